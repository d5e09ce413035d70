// Interpolated colours: each block of a tile is shaded as it is met, triangle by triangle, in registers. Included once
// for each target.
#if defined(RASTERLENS_TILED_GOURAUD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_GOURAUD_INL_H
#undef RASTERLENS_TILED_GOURAUD_INL_H
#else
#define RASTERLENS_TILED_GOURAUD_INL_H
#endif

#include "core/rasterizers/tiled/exact_path.h"
#include "core/rasterizers/tiled/kernels.h"
#include "core/rasterizers/tiled/lanes-inl.h"
#include "core/rasterizers/tiled/tile_output.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// Samples of a block that belong to the target.
inline std::uint32_t LanesOnTarget(const FrameJob& job, TileOrigin origin, int block)
{
    const int columns = std::min(job.rules.columns() - origin.x, job.grid.pitch) - blockColumn(block) * kBlockSide;
    const int rows = std::min(job.rules.rows() - origin.y, job.grid.pitch) - blockRow(block) * kBlockSide;
    if (columns >= kBlockSide && rows >= kBlockSide)
        return 0xffff;
    std::uint32_t bits = 0;
    for (int y = 0; y < std::min(rows, kBlockSide); ++y)
        for (int x = 0; x < std::min(columns, kBlockSide); ++x)
            bits |= 1U << (y * kBlockSide + x);
    return bits;
}

/// Colours of 0 to 255 rounded, in the lowest bits: above 2^23 a float counts in ones.
HWY_INLINE Ints ChannelOf(Floats c) { return hn::BitCast(IntTag(), hn::Add(c, hn::Set(FloatTag(), 0x1p23F))); }

HWY_INLINE Uints PackChannels(Floats red, Floats green, Floats blue)
{
    constexpr IntTag tag;
    // What is above the lowest 8 bits is shifted out, or covered by alpha.
    const Ints packed = hn::Or3(hn::ShiftLeft<16>(ChannelOf(red)), hn::ShiftLeft<8>(ChannelOf(green)), ChannelOf(blue));
    return hn::BitCast(UintTag(), hn::Or(packed, hn::Set(tag, static_cast<std::int32_t>(0xff000000U))));
}

/// The same of colours that may lie outside.
HWY_INLINE Uints PackHeld(Floats red, Floats green, Floats blue)
{
    const auto held = [](Floats c)
                          HWY_ATTR { return hn::Min(hn::Max(c, hn::Zero(FloatTag())), hn::Set(FloatTag(), 255.0F)); };
    return PackChannels(held(red), held(green), held(blue));
}

/// The colour of a triangle at samples (x, y) of the target.
HWY_INLINE Uints ColorAt(const ColorPlanes& planes, Floats x, Floats y)
{
    constexpr FloatTag tag;
    const Floats toX = hn::Sub(x, hn::Set(tag, planes.x0));
    const Floats toY = hn::Sub(y, hn::Set(tag, planes.y0));
    const auto plane = [&](std::size_t i) HWY_ATTR {
        return hn::Add(hn::Set(tag, planes.origin[i]),
                       hn::Add(hn::Mul(hn::Set(tag, planes.perX[i]), toX), hn::Mul(hn::Set(tag, planes.perY[i]), toY)));
    };
    if (HWY_LIKELY(planes.way == ColorWay::Affine))
        return PackChannels(plane(1), plane(2), plane(3));
    const Floats w = hn::Div(hn::Set(tag, 1.0F), plane(0));
    return PackHeld(hn::Mul(plane(1), w), hn::Mul(plane(2), w), hn::Mul(plane(3), w));
}

/// A block's place: in the tile, and its first sample on the target.
struct BlockPlace {
    TileOrigin origin;
    std::size_t block;

    [[nodiscard]] int x() const { return origin.x + blockColumn(static_cast<int>(block)) * kBlockSide; }
    [[nodiscard]] int y() const { return origin.y + blockRow(static_cast<int>(block)) * kBlockSide; }
};

/// A block while it is shaded.
struct ColorBlock {
    std::array<Uints, kVectors> ids;
    std::array<Uints, kVectors> color;
    std::array<Floats, kVectors> x, y; ///< samples of the target

    HWY_INLINE void store(std::uint32_t* to) const
    {
        for (std::size_t v = 0; v < kVectors; ++v)
            hn::Store(color[v], UintTag(), to + v * kPerVector);
    }
    HWY_INLINE void load(const std::uint32_t* from)
    {
        for (std::size_t v = 0; v < kVectors; ++v)
            color[v] = hn::Load(UintTag(), from + v * kPerVector);
    }
    /// Samples that hold the number, a bit each.
    HWY_INLINE std::uint32_t lanesOf(std::uint32_t number) const
    {
        std::uint32_t lanes = 0;
        for (std::size_t v = 0; v < kVectors; ++v)
            lanes |= BitsOf(UintTag(), hn::Eq(ids[v], hn::Set(UintTag(), number))) << (v * kPerVector);
        return lanes;
    }
};

inline void ColorExactly(const FrameJob& job, Worker& worker, const BlockPlace& place, std::uint32_t number,
                         std::uint32_t lanes, ColorBlock& samples)
{
    std::uint32_t* memory = worker.samples.color.data() + place.block * kLanes;
    samples.store(memory);
    shadeExactly(job, {worker.triangle(number).source, &worker.chunkOf(number), nullptr, {}},
                 {static_cast<std::uint16_t>(place.block), static_cast<std::uint16_t>(lanes), 0}, place.origin,
                 worker.samples);
    samples.load(memory);
}

/// Shading gouraud of a block.
struct Interpolated {
    const FrameJob& job;
    Worker& worker;
    BlockPlace place;

    HWY_INLINE Interpolated(const FrameJob& j, Worker& w, const BlockPlace& p) : job(j), worker(w), place(p) {}

    /// Colours the samples that a triangle won; the lanes are those.
    HWY_INLINE void add(std::uint32_t number, std::uint32_t lanes, ColorBlock& samples)
    {
        constexpr UintTag tag;
        const ColorPlanes& planes = worker.colors(number);
        if (HWY_UNLIKELY(planes.way == ColorWay::Exact)) {
            ColorExactly(job, worker, place, number, lanes, samples);
            return;
        }
        for (std::size_t v = 0; v < kVectors; ++v) {
            const auto mine = hn::Eq(samples.ids[v], hn::Set(tag, number));
            samples.color[v] = hn::IfThenElse(mine, ColorAt(planes, samples.x[v], samples.y[v]), samples.color[v]);
        }
    }
    HWY_INLINE void finish(ColorBlock&) {}
};

HWY_INLINE ColorBlock LoadColorBlock(const FrameJob& job, const TileSamples& samples, TileOrigin origin,
                                     std::size_t block)
{
    constexpr UintTag tag;
    constexpr FloatTag floatTag;
    const auto x = static_cast<float>(origin.x + blockColumn(static_cast<int>(block)) * kBlockSide);
    const auto y = static_cast<float>(origin.y + blockRow(static_cast<int>(block)) * kBlockSide);
    const std::uint32_t owner = samples.owner[block];
    ColorBlock loaded;
    for (std::size_t v = 0; v < kVectors; ++v) {
        const std::size_t lane = v * kPerVector;
        loaded.x[v] = hn::Add(hn::Load(floatTag, kPattern.floatX.data() + lane), hn::Set(floatTag, x));
        loaded.y[v] = hn::Add(hn::Load(floatTag, kPattern.floatY.data() + lane), hn::Set(floatTag, y));
        loaded.color[v] = hn::Set(tag, job.clearColor);
        loaded.ids[v] =
            owner != kNobody ? hn::Set(tag, owner) : hn::Load(tag, samples.ids.data() + block * kLanes + lane);
    }
    return loaded;
}

/// Colours a block; what nobody won is background.
template <class Shader>
HWY_INLINE void ColorWholeBlock(const FrameJob& job, Worker& worker, TileOrigin origin, std::size_t block,
                                std::uint32_t* out)
{
    const TileSamples& samples = worker.samples;
    ColorBlock shaded = LoadColorBlock(job, samples, origin, block);
    const std::uint32_t owner = samples.owner[block];
    const std::uint32_t* ids = samples.ids.data() + block * kLanes;
    std::uint32_t remaining = owner == kEmpty ? 0 : 0xffff & ~shaded.lanesOf(kNobody);
    if (job.counting) {
        remaining &= LanesOnTarget(job, origin, static_cast<int>(block));
        worker.pixels.shaded += static_cast<unsigned>(std::popcount(remaining));
        worker.pixels.written += static_cast<unsigned>(std::popcount(remaining));
    }
    Shader shader(job, worker, {origin, block});
    while (remaining != 0) {
        const std::uint32_t number = owner != kNobody ? owner : ids[std::countr_zero(remaining)];
        const std::uint32_t lanes = shaded.lanesOf(number);
        shader.add(number, lanes & remaining, shaded);
        remaining &= ~lanes;
    }
    shader.finish(shaded);
    shaded.store(out);
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
