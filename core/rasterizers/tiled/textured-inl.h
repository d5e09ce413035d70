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

/// A vector of samples: where they are in the texture, and the colour their texels are to be multiplied with. What
/// belongs to other triangles of the block stays as it is.
template <TextureFilter kFilter>
struct TexturedLanes {
    Ints place;         ///< of nearest texels
    Floats u, v, level; ///< for filters
    RgbLanes color;     ///< 0 to 1
};

/// Coordinates of samples in double, and which of the lanes can be counted.
struct PreciseUv {
    Floats u, v, level;
    hn::Mask<FloatTag> found;
};

HWY_NOINLINE inline PreciseUv FindPrecisely(const FrameJob& job, Worker& worker, std::uint32_t number,
                                            const BlockPlace& place, std::size_t vector)
{
    const VaryingPlanes<kUvVaryings>& planes = PreciseTexelsOf(job, worker, number);
    const Texture& texture = job.texture(static_cast<std::int32_t>(worker.colors(number).extra));
    const VaryingLanes<kUvVaryings> at = VaryingsAt(planes, place.x(), place.y(), vector);
    const auto [u, v] = at.value;
    const Floats level = MipLevel(texture, GradientOf(planes, 0, u, v, at.w));
    const auto found = hn::And(InReach(u, texture.width), InReach(v, texture.height));
    return {u, v, level, planes.exact ? MaskOf(FloatTag(), 0) : found};
}

/// The samples of one triangle in a block.
struct TexelFinder {
    const FrameJob& job;
    Worker& worker;
    BlockPlace block;
    std::uint32_t number;
    const ColorPlanes& colors;
    const TexelPlanes& texels;
    const Texture& texture;
    std::uint32_t left = 0; ///< samples that only the scalar stages can do, a bit each

    HWY_INLINE PreciseUv precise(std::size_t vector, hn::Mask<FloatTag> wanted)
    {
        PreciseUv at = FindPrecisely(job, worker, number, BlockPlace(block), vector);
        left |= BitsOf(FloatTag(), hn::AndNot(at.found, wanted)) << (vector * kPerVector);
        at.found = hn::And(at.found, wanted);
        return at;
    }

    /// The nearest texels; in double where the closest border between two may be on the other side.
    HWY_INLINE Ints nearest(Floats u, Floats v, std::size_t vector, hn::Mask<FloatTag> wanted)
    {
        constexpr FloatTag tag;
        constexpr IntTag intTag;
        const RoundedLanes column(u);
        const RoundedLanes row(v);
        const Floats off = hn::Max(hn::Abs(hn::Sub(u, column.floats())), hn::Abs(hn::Sub(v, row.floats())));
        const auto unsure = hn::AndNot(hn::Lt(off, hn::Set(tag, texels.certain)), wanted);
        const Ints x = WrapTexel(column, texels.first[0], texture.width);
        const Ints y = WrapTexel(row, texels.first[1], texture.height);
        const Ints place = hn::Add(hn::Mul(y, hn::Set(intTag, texture.width)), x);
        if (HWY_LIKELY(hn::AllFalse(tag, unsure)))
            return place;
        const PreciseUv at = precise(vector, unsure);
        return hn::IfThenElse(hn::RebindMask(intTag, unsure), TexelPlaces(texture, at.u, at.v, at.found), place);
    }

    /// Filters forgive what is far below a step of colour.
    HWY_INLINE PreciseUv smooth(Floats u, Floats v, Floats w, std::size_t vector, hn::Mask<FloatTag> wanted)
    {
        constexpr FloatTag tag;
        constexpr float kEnough = 0.5F - 0x1p-10F; // a quarter of a step between black and white texels
        if (HWY_UNLIKELY(!(texels.certain >= kEnough)))
            return precise(vector, wanted);
        const auto toUv = [&](Floats at, std::size_t axis, int size) HWY_ATTR {
            const Floats first = hn::Set(tag, static_cast<float>(texels.first[axis]) + 0.5F);
            return hn::Mul(hn::Add(at, first), hn::Set(tag, 1.0F / static_cast<float>(size)));
        };
        // The quotient rule: (U/W)' = (U' - u W') / W.
        const auto derivative = [&](const auto& slopes, float ofInverseW, std::size_t axis, Floats at) HWY_ATTR {
            return hn::Mul(hn::Sub(hn::Set(tag, slopes[axis]), hn::Mul(at, hn::Set(tag, ofInverseW))), w);
        };
        const GradientLanes inTexels{
            derivative(texels.perX, colors.perX[0], 0, u), derivative(texels.perY, colors.perY[0], 0, u),
            derivative(texels.perX, colors.perX[0], 1, v), derivative(texels.perY, colors.perY[0], 1, v)};
        return {toUv(u, 0, texture.width), toUv(v, 1, texture.height), MipLevel(inTexels), wanted};
    }

    /// in   samples of the target
    template <TextureFilter kFilter>
    HWY_INLINE void find(Floats sampleX, Floats sampleY, std::size_t vector, hn::Mask<FloatTag> wanted,
                         TexturedLanes<kFilter>& out)
    {
        constexpr FloatTag tag;
        const Floats x = hn::Sub(sampleX, hn::Set(tag, colors.x0));
        const Floats y = hn::Sub(sampleY, hn::Set(tag, colors.y0));
        const auto plane = [&](const auto& planes, std::size_t i) HWY_ATTR {
            return hn::Add(hn::Set(tag, planes.origin[i]),
                           hn::Add(hn::Mul(hn::Set(tag, planes.perX[i]), x), hn::Mul(hn::Set(tag, planes.perY[i]), y)));
        };
        const auto keep = [&](Floats& to, Floats value) HWY_ATTR { to = hn::IfThenElse(wanted, value, to); };
        const Floats w = hn::Div(hn::Set(tag, 1.0F), plane(colors, 0));
        RgbLanes color{plane(colors, 1), plane(colors, 2), plane(colors, 3)};
        if (HWY_UNLIKELY(colors.way == ColorWay::Perspective))
            color = Scale(color, w);
        keep(out.color.red, color.red);
        keep(out.color.green, color.green);
        keep(out.color.blue, color.blue);
        const Floats u = hn::Mul(plane(texels, 0), w);
        const Floats v = hn::Mul(plane(texels, 1), w);
        if constexpr (kFilter == TextureFilter::Nearest) {
            out.place = hn::IfThenElse(hn::RebindMask(IntTag(), wanted), nearest(u, v, vector, wanted), out.place);
        } else {
            const PreciseUv at = smooth(u, v, w, vector, wanted);
            keep(out.u, at.u);
            keep(out.v, at.v);
            if constexpr (kFilter == TextureFilter::Trilinear)
                keep(out.level, at.level);
        }
    }
};

/// Shading texture of a block: each triangle says where in the texture its samples are, and texels are fetched for all
/// of them together.
template <TextureFilter kFilter>
struct Textured {
    const FrameJob& job;
    Worker& worker;
    BlockPlace place;
    const Texture* texture = nullptr; ///< of the samples that wait for their texels
    std::uint32_t waiting = 0;        ///< a bit each
    std::array<TexturedLanes<kFilter>, kVectors> lanes;

    HWY_INLINE Textured(const FrameJob& j, Worker& w, const BlockPlace& p) : job(j), worker(w), place(p) {}

    static HWY_INLINE hn::Mask<FloatTag> MaskAt(std::uint32_t bits, std::size_t v)
    {
        return MaskOf(FloatTag(), bits >> (v * kPerVector));
    }

    HWY_INLINE void add(std::uint32_t number, std::uint32_t won, ColorBlock& samples)
    {
        const ColorPlanes& colors = worker.colors(number);
        const Texture& its = job.texture(static_cast<std::int32_t>(colors.extra));
        if (HWY_UNLIKELY(colors.way == ColorWay::Exact)) {
            ColorExactly(job, worker, place, number, won, samples);
            return;
        }
        if (HWY_UNLIKELY(waiting != 0 && texture != &its))
            finish(samples);
        texture = &its;
        TexelFinder finder{job, worker, place, number, colors, worker.texels(number), its};
        for (std::size_t v = 0; v < kVectors; ++v)
            finder.find(samples.x[v], samples.y[v], v, MaskAt(won, v), lanes[v]);
        waiting |= won & ~finder.left;
        if (HWY_UNLIKELY((won & finder.left) != 0))
            ColorExactly(job, worker, place, number, won & finder.left, samples);
    }

    HWY_INLINE RgbLanes fetch(const TexturedLanes<kFilter>& at, hn::Mask<FloatTag> wanted) const
    {
        if constexpr (kFilter == TextureFilter::Nearest)
            return Unpack(hn::GatherIndex(UintTag(), texture->texels.data(),
                                          hn::IfThenElseZero(hn::RebindMask(IntTag(), wanted), at.place)));
        else if constexpr (kFilter == TextureFilter::Bilinear)
            return SampleBilinear(*texture, at.u, at.v, wanted);
        else
            return SampleTrilinear(*texture, at.u, at.v, at.level, wanted);
    }

    /// Fetches and colours what waits.
    HWY_INLINE void finish(ColorBlock& samples)
    {
        if (waiting == 0)
            return;
        for (std::size_t v = 0; v < kVectors; ++v) {
            const auto wanted = MaskAt(waiting, v);
            const RgbLanes color = Scale(fetch(lanes[v], wanted), lanes[v].color);
            samples.color[v] = hn::IfThenElse(hn::RebindMask(UintTag(), wanted),
                                              PackHeld(color.red, color.green, color.blue), samples.color[v]);
        }
        waiting = 0;
    }
};

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
