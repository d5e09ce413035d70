// Textures multiplied with interpolated colours. Included once for each target.
#if defined(RASTERLENS_TILED_TEXTURED_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_TEXTURED_INL_H
#undef RASTERLENS_TILED_TEXTURED_INL_H
#else
#define RASTERLENS_TILED_TEXTURED_INL_H
#endif

#include "core/rasterizers/tiled/exact_path.h"
#include "core/rasterizers/tiled/gouraud-inl.h"
#include "core/rasterizers/tiled/kernels.h"
#include "core/rasterizers/tiled/texels-inl.h"
#include "core/rasterizers/tiled/texture-inl.h"
#include "core/rasterizers/tiled/varyings-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// Texture coordinates of a triangle of the tile in double: no faster than they must be, as few samples ask for them.
inline VaryingPlanes<kUvVaryings> MakePreciseTexels(const FrameJob& job, const Worker& worker, std::uint32_t number)
{
    const ScreenTriangle triangle = screenTriangle(job, worker.chunkOf(number), worker.triangle(number).source);
    const auto& [a, b, c] = triangle.vertices;
    VaryingStage<kUvVaryings> stage;
    for (std::size_t k = 0; k < 3; ++k) {
        stage.w[k].fill(1 / triangle.vertices[k].invW);
        for (std::size_t i = 0; i < kUvVaryings; ++i)
            stage.value[k][i].fill(triangle.vertices[k].varyings[kVaryingUv + i]);
    }
    const auto toUnits = [](double samples)
                             HWY_ATTR { return hn::Set(HalfIntTag(), static_cast<std::int32_t>(samples * kUnit)); };
    const ColorPlanes& anchor = worker.colors(number);
    const auto fromCorner = [&](float sample, double corner)
                                HWY_ATTR { return toUnits(double(sample) + 0.5 - corner); };
    const PlaneGeometry geometry{toUnits(b.position.x - a.position.x),
                                 toUnits(b.position.y - a.position.y),
                                 toUnits(c.position.x - a.position.x),
                                 toUnits(c.position.y - a.position.y),
                                 fromCorner(anchor.x0, a.position.x),
                                 fromCorner(anchor.y0, a.position.y),
                                 hn::Set(DoubleTag(), 1 / twiceArea(a.position, b.position, c.position))};
    VaryingPlanes<kUvVaryings> planes;
    MakeVaryingPlanes<kUvVaryings>(job.rules, geometry, stage, 1, hn::Set(HalfIntTag(), static_cast<int>(anchor.x0)),
                                   hn::Set(HalfIntTag(), static_cast<int>(anchor.y0)), {&planes});
    return planes;
}

HWY_NOINLINE inline const VaryingPlanes<kUvVaryings>& PreciseTexelsOf(const FrameJob& job, Worker& worker,
                                                               std::uint32_t number)
{
    PreciseTexels& known = worker.precise;
    const std::size_t place = number % PreciseTexels::kCapacity;
    if (known.number[place] != number) {
        known.number[place] = number;
        known.planes[place] = MakePreciseTexels(job, worker, number);
    }
    return known.planes[place];
}

/// Texture coordinates with everything filters ask for.
struct TextureLanesAt {
    Floats u, v;
    GradientLanes gradient;
};

HWY_INLINE Floats ToUv(Floats texels, int size) { return hn::Mul(texels, hn::Set(FloatTag(), 1.0F / float(size))); }

/// Places of texels that the wanted lanes find in double, as the scalar stages do.
HWY_NOINLINE inline Ints FindTexelsPrecisely(const VaryingPlanes<kUvVaryings>& planes, const Texture& texture,
                                      const BlockLanes& block, hn::Mask<FloatTag> wanted, LeftLanes& left)
{
    if (planes.exact) {
        left.add(wanted, block.vector);
        return hn::Zero(IntTag());
    }
    const VaryingLanes<kUvVaryings> at = VaryingsAt(planes, block.x, block.y, block.vector);
    const auto found =
        hn::And(wanted, hn::And(InReach(at.value[0], texture.width), InReach(at.value[1], texture.height)));
    left.add(hn::AndNot(found, wanted), block.vector);
    return TexelPlaces(texture, at.value[0], at.value[1], found);
}

/// Numbers of up to 2^22 rounded to whole ones: above 2^23 a float counts in ones, below its bits.
struct RoundedLanes {
    static constexpr float kOnes = 0x1.8p23F;
    Floats counted;

    HWY_INLINE explicit RoundedLanes(Floats a) : counted(hn::Add(a, hn::Set(FloatTag(), kOnes))) {}
    HWY_INLINE Floats floats() const { return hn::Sub(counted, hn::Set(FloatTag(), kOnes)); }
    HWY_INLINE Ints plus(int offset) const
    {
        constexpr int kBits = std::bit_cast<std::int32_t>(kOnes);
        return hn::Add(hn::BitCast(IntTag(), counted), hn::Set(IntTag(), offset - kBits));
    }
};

/// The texel along an axis, from the one where the coordinates begin.
HWY_INLINE Ints WrapTexel(const RoundedLanes& at, int first, int size)
{
    constexpr FloatTag tag;
    constexpr IntTag intTag;
    if (std::has_single_bit(static_cast<unsigned>(size)))
        return hn::And(at.plus(first), hn::Set(intTag, size - 1));
    // Up to 2^22 no quotient is rounded to a whole number that it has not reached.
    const Floats sizes = hn::Set(tag, static_cast<float>(size));
    const Floats texel = hn::Add(at.floats(), hn::Set(tag, static_cast<float>(first)));
    return hn::ConvertTo(intTag, hn::Sub(texel, hn::Mul(hn::Floor(hn::Div(texel, sizes)), sizes)));
}

/// Shading texture at a vector of samples of a triangle.
template <TextureFilter kFilter>
struct Textured {
    const FrameJob& job;
    Worker& worker;
    std::uint32_t number;
    const ColorPlanes& colors;
    const TexelPlanes& texels;
    const Texture& texture;

    HWY_INLINE Textured(const FrameJob& j, Worker& w, std::uint32_t n)
        : job(j), worker(w), number(n), colors(w.colors(n)), texels(w.texels(n)),
          texture(j.texture(static_cast<std::int32_t>(colors.extra)))
    {
    }

    /// in   the samples relative to the anchor
    template <class Coefficients>
    static HWY_INLINE Floats PlaneAt(const Coefficients& planes, std::size_t i, Floats x, Floats y)
    {
        constexpr FloatTag tag;
        return hn::Add(hn::Set(tag, planes.origin[i]),
                       hn::Add(hn::Mul(hn::Set(tag, planes.perX[i]), x), hn::Mul(hn::Set(tag, planes.perY[i]), y)));
    }

    /// The nearest texels, 0 to 255.
    HWY_INLINE RgbLanes nearest(Floats u, Floats v, hn::Mask<FloatTag> wanted, const BlockLanes& block,
                                LeftLanes& left) const
    {
        constexpr FloatTag tag;
        constexpr IntTag intTag;
        const RoundedLanes column(u);
        const RoundedLanes row(v);
        const Floats off = hn::Max(hn::Abs(hn::Sub(u, column.floats())), hn::Abs(hn::Sub(v, row.floats())));
        const auto unsure = hn::AndNot(hn::Lt(off, hn::Set(tag, texels.certain)), wanted);
        const Ints x = WrapTexel(column, texels.first[0], texture.width);
        const Ints y = WrapTexel(row, texels.first[1], texture.height);
        Ints place = hn::Add(hn::Mul(y, hn::Set(intTag, texture.width)), x);
        place = hn::IfThenElseZero(hn::RebindMask(intTag, hn::AndNot(unsure, wanted)), place);
        if (HWY_UNLIKELY(!hn::AllFalse(tag, unsure))) {
            const auto& planes = PreciseTexelsOf(job, worker, number);
            const Ints found = FindTexelsPrecisely(planes, texture, block, unsure, left);
            place = hn::IfThenElse(hn::RebindMask(intTag, unsure), found, place);
        }
        return Unpack(hn::GatherIndex(UintTag(), texture.texels.data(), place));
    }

    /// Coordinates for filters, which forgive what is far below a step of colour.
    HWY_INLINE TextureLanesAt smooth(Floats u, Floats v, Floats w) const
    {
        constexpr FloatTag tag;
        const auto fromFirst = [&](Floats at, std::size_t axis) HWY_ATTR {
            return hn::Add(at, hn::Set(tag, static_cast<float>(texels.first[axis]) + 0.5F));
        };
        // The quotient rule: (U/W)' = (U' - u W') / W.
        const auto derivative = [&](const auto& slopes, float ofInverseW, std::size_t axis, Floats at) HWY_ATTR {
            return hn::Mul(hn::Sub(hn::Set(tag, slopes[axis]), hn::Mul(at, hn::Set(tag, ofInverseW))), w);
        };
        const int width = texture.width;
        const int height = texture.height;
        return {ToUv(fromFirst(u, 0), width),
                ToUv(fromFirst(v, 1), height),
                {ToUv(derivative(texels.perX, colors.perX[0], 0, u), width),
                 ToUv(derivative(texels.perY, colors.perY[0], 0, u), width),
                 ToUv(derivative(texels.perX, colors.perX[0], 1, v), height),
                 ToUv(derivative(texels.perY, colors.perY[0], 1, v), height)}};
    }

    /// The same where float32 is not enough.
    TextureLanesAt precise(const BlockLanes& block, hn::Mask<FloatTag> wanted, LeftLanes& left) const
    {
        const VaryingPlanes<kUvVaryings>& planes = PreciseTexelsOf(job, worker, number);
        const VaryingLanes<kUvVaryings> at = VaryingsAt(planes, block.x, block.y, block.vector);
        const auto found = hn::And(InReach(at.value[0], texture.width), InReach(at.value[1], texture.height));
        left.add(planes.exact ? wanted : hn::AndNot(found, wanted), block.vector);
        return {hn::IfThenElseZero(found, at.value[0]), hn::IfThenElseZero(found, at.value[1]),
                GradientOf(planes, 0, at.value[0], at.value[1], at.w)};
    }

    HWY_INLINE RgbLanes filtered(Floats u, Floats v, Floats w, hn::Mask<FloatTag> wanted, const BlockLanes& block,
                                 LeftLanes& left) const
    {
        constexpr float kEnough = 0.5F - 0x1p-10F; // a quarter of a step between black and white texels
        const TextureLanesAt at =
            HWY_LIKELY(texels.certain >= kEnough) ? smooth(u, v, w) : precise(block, wanted, left);
        if constexpr (kFilter == TextureFilter::Bilinear)
            return SampleBilinear(texture, at.u, at.v, wanted);
        else
            return SampleTrilinear(texture, at.u, at.v, at.gradient, wanted);
    }

    HWY_INLINE Uints colorAt(const BlockLanes& block, Floats sampleX, Floats sampleY, hn::Mask<FloatTag> wanted,
                             LeftLanes& left) const
    {
        constexpr FloatTag tag;
        const Floats x = hn::Sub(sampleX, hn::Set(tag, colors.x0));
        const Floats y = hn::Sub(sampleY, hn::Set(tag, colors.y0));
        const Floats w = hn::Div(hn::Set(tag, 1.0F), PlaneAt(colors, 0, x, y));
        const Floats u = hn::Mul(PlaneAt(texels, 0, x, y), w);
        const Floats v = hn::Mul(PlaneAt(texels, 1, x, y), w);
        const RgbLanes texel = kFilter == TextureFilter::Nearest ? nearest(u, v, wanted, block, left)
                                                                 : filtered(u, v, w, wanted, block, left);
        const RgbLanes color{PlaneAt(colors, 1, x, y), PlaneAt(colors, 2, x, y), PlaneAt(colors, 3, x, y)};
        const RgbLanes product = Scale(texel, color);
        if (HWY_LIKELY(colors.way == ColorWay::Affine))
            return PackChannels(product.red, product.green, product.blue);
        const RgbLanes divided = Scale(product, w);
        return PackHeld(divided.red, divided.green, divided.blue);
    }
};

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
