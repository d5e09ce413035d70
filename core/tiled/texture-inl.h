// Texture look-up, a vector of samples at a time: sampleTexture(). Included once for each target: see README.md.
#if defined(RASTERLENS_TILED_TEXTURE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_TEXTURE_INL_H
#undef RASTERLENS_TILED_TEXTURE_INL_H
#else
#define RASTERLENS_TILED_TEXTURE_INL_H
#endif

#include "core/scene/scene.h"
#include "core/scene/texel_border.h"
#include "core/tiled/lanes-inl.h"
#include "core/tiled/math-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// Colours of a vector of samples. Each function that makes them says in which range they are.
struct RgbLanes {
    Floats red, green, blue;
};

/// 0 to 255.
HWY_INLINE RgbLanes Unpack(Uints texels)
{
    constexpr IntTag tag;
    const Ints bits = hn::BitCast(tag, texels);
    const Ints low = hn::Set(tag, 255);
    const auto channel = [&](Ints shifted) HWY_ATTR { return hn::ConvertTo(FloatTag(), hn::And(shifted, low)); };
    return {channel(hn::ShiftRight<16>(bits)), channel(hn::ShiftRight<8>(bits)), channel(bits)};
}

HWY_INLINE RgbLanes Scale(const RgbLanes& a, Floats by)
{
    return {hn::Mul(a.red, by), hn::Mul(a.green, by), hn::Mul(a.blue, by)};
}

HWY_INLINE RgbLanes Scale(const RgbLanes& a, const RgbLanes& by)
{
    return {hn::Mul(a.red, by.red), hn::Mul(a.green, by.green), hn::Mul(a.blue, by.blue)};
}

HWY_INLINE Floats Mix(Floats a, Floats b, Floats part) { return hn::Add(a, hn::Mul(hn::Sub(b, a), part)); }

HWY_INLINE RgbLanes Mix(const RgbLanes& a, const RgbLanes& b, Floats part)
{
    return {Mix(a.red, b.red, part), Mix(a.green, b.green, part), Mix(a.blue, b.blue, part)};
}

/// Coordinates whose texels have numbers that integers can count, and that are not so close to 0 that float32 shows
/// what sums in double are off by, and its sign; the others are left to the scalar look-up.
HWY_INLINE hn::Mask<FloatTag> InReach(Floats coordinate, int size)
{
    constexpr FloatTag tag;
    const Floats distance = hn::Abs(coordinate);
    return hn::And(hn::Gt(distance, hn::Set(tag, 0x1p-12F)),
                   hn::Lt(distance, hn::Set(tag, 0x1p30F / static_cast<float>(size))));
}

/// texelFloor(), operation by operation.
HWY_INLINE Floats TexelFloor(Floats texels)
{
    constexpr FloatTag tag;
    const Floats border = hn::Add(hn::Mul(hn::Abs(texels), hn::Set(tag, kBorderShare)), hn::Set(tag, kBorderReach));
    return hn::Floor(hn::Add(texels, border));
}

/// The texel along an axis that holds the point.
HWY_INLINE Ints NearestTexel(Floats coordinate, int size)
{
    constexpr FloatTag tag;
    constexpr IntTag intTag;
    const Floats whole = TexelFloor(hn::Mul(coordinate, hn::Set(tag, static_cast<float>(size))));
    if (std::has_single_bit(static_cast<unsigned>(size)))
        return hn::And(IntsOf(whole), hn::Set(intTag, size - 1));
    constexpr DoubleTag wideTag;
    const Doubles sizes = hn::Set(wideTag, size);
    WideDoubles wide = ToDoubles(whole);
    for (Doubles& part : wide.part)
        part = hn::Sub(part, hn::Mul(hn::Floor(hn::Div(part, sizes)), sizes));
    return ToInts(wide);
}

/// A texture, or for each lane one of its mip levels.
struct TexelLanes {
    const std::uint32_t* texels;
    Floats width;
    Floats height;
    Ints pitch; ///< the width again
    Ints first;
};

/// Two texels of an axis whose centres are on both sides of the point, and how far it is from the first to the second.
struct AxisLanes {
    Ints first;
    Ints second;
    Floats part;
};

HWY_INLINE AxisLanes NeighboursOf(Floats coordinate, Floats size)
{
    constexpr FloatTag tag;
    const Floats one = hn::Set(tag, 1.0F);
    const Floats zero = hn::Zero(tag);
    const Floats repeat = hn::Sub(coordinate, hn::Floor(coordinate));
    const Floats at = hn::Sub(hn::Mul(repeat, size), hn::Set(tag, 0.5F));
    const Floats left = hn::Floor(at);
    const Floats right = hn::Add(left, one);
    return {IntsOf(hn::IfThenElse(hn::Lt(left, zero), hn::Sub(size, one), left)),
            IntsOf(hn::IfThenElse(hn::Lt(right, size), right, zero)), hn::Sub(at, left)};
}

/// The wanted lanes' blends of four texels.
HWY_INLINE RgbLanes Bilinear(const TexelLanes& from, Floats u, Floats v, hn::Mask<FloatTag> wanted)
{
    const AxisLanes x = NeighboursOf(u, from.width);
    const AxisLanes y = NeighboursOf(v, from.height);
    const auto texel = [&](Ints column, Ints row) HWY_ATTR {
        const Ints index = hn::Add(hn::Add(from.first, hn::Mul(row, from.pitch)), column);
        return Unpack(Gather(from.texels, index, wanted));
    };
    return Mix(Mix(texel(x.first, y.first), texel(x.second, y.first), x.part),
               Mix(texel(x.first, y.second), texel(x.second, y.second), x.part), y.part);
}

/// Places of the texels that hold the points, and the first of all for lanes that are not wanted.
HWY_INLINE Ints TexelPlaces(const Texture& texture, Floats u, Floats v, hn::Mask<FloatTag> wanted)
{
    constexpr IntTag tag;
    const Ints row = hn::Mul(NearestTexel(v, texture.height), hn::Set(tag, texture.width));
    return hn::IfThenElseZero(hn::RebindMask(tag, wanted), hn::Add(row, NearestTexel(u, texture.width)));
}

HWY_INLINE RgbLanes SampleNearest(const Texture& texture, Floats u, Floats v, hn::Mask<FloatTag> wanted)
{
    return Unpack(Gather(texture.texels.data(), TexelPlaces(texture, u, v, wanted), wanted));
}

HWY_INLINE RgbLanes SampleBilinear(const Texture& texture, Floats u, Floats v, hn::Mask<FloatTag> wanted)
{
    constexpr FloatTag tag;
    return Bilinear({texture.texels.data(), hn::Set(tag, static_cast<float>(texture.width)),
                     hn::Set(tag, static_cast<float>(texture.height)), hn::Set(IntTag(), texture.width),
                     hn::Zero(IntTag())},
                    u, v, wanted);
}

/// How texture coordinates change from sample to sample.
struct GradientLanes {
    Floats uPerX, uPerY, vPerX, vPerY;
};

/// mipLevel()
///
/// in   in texels
HWY_INLINE Floats MipLevel(const GradientLanes& gradient)
{
    constexpr FloatTag tag;
    const auto squared = [](Floats x, Floats y) HWY_ATTR { return hn::Add(hn::Mul(x, x), hn::Mul(y, y)); };
    const Floats larger = hn::Max(squared(gradient.uPerX, gradient.vPerX), squared(gradient.uPerY, gradient.vPerY));
    return hn::Mul(hn::Set(tag, 0.5F), Log2(hn::Max(larger, hn::Set(tag, 1.0F))));
}

HWY_INLINE Floats MipLevel(const Texture& texture, const GradientLanes& gradient)
{
    const Floats width = hn::Set(FloatTag(), static_cast<float>(texture.width));
    const Floats height = hn::Set(FloatTag(), static_cast<float>(texture.height));
    return MipLevel({hn::Mul(gradient.uPerX, width), hn::Mul(gradient.uPerY, width), hn::Mul(gradient.vPerX, height),
                     hn::Mul(gradient.vPerY, height)});
}

/// in   mipLevel()
HWY_INLINE RgbLanes SampleTrilinear(const Texture& texture, Floats u, Floats v, Floats mipLevel,
                                    hn::Mask<FloatTag> wanted)
{
    constexpr FloatTag tag;
    constexpr IntTag intTag;
    const MipLevels& mips = texture.mipLevels();
    const Ints last = hn::Set(intTag, static_cast<std::int32_t>(mips.levels.size()) - 1);
    const Floats level = hn::IfThenElseZero(wanted, hn::Min(mipLevel, hn::ConvertTo(tag, last)));
    const Ints finer = IntsOf(level);
    const Ints coarser = hn::Min(hn::Add(finer, hn::Set(intTag, 1)), last);
    constexpr int kStride = sizeof(MipLevels::Level) / sizeof(std::int32_t);
    const auto sample = [&](Ints which) HWY_ATTR {
        const Ints at = hn::Mul(which, hn::Set(intTag, kStride));
        const auto* fields = &mips.levels.front().width;
        const Ints width = Gather(fields, at, wanted);
        const Ints height = Gather(fields + 1, at, wanted);
        const Ints first = Gather(fields + 2, at, wanted);
        return Bilinear({mips.texels.data(), hn::ConvertTo(tag, width), hn::ConvertTo(tag, height), width, first}, u, v,
                        wanted);
    };
    const Floats part = hn::Sub(level, hn::ConvertTo(tag, finer));
    if (hn::AllFalse(tag, hn::Gt(part, hn::Zero(tag)))) // magnified, as a rule
        return sample(finer);
    return Mix(sample(finer), sample(coarser), part);
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
