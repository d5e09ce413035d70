// Several samples a pixel: their means. Included once for each target: see README.md.
#if defined(RASTERLENS_TILED_RESOLVE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_RESOLVE_INL_H
#undef RASTERLENS_TILED_RESOLVE_INL_H
#else
#define RASTERLENS_TILED_RESOLVE_INL_H
#endif

#include "core/tiled/lanes-inl.h"
#include "core/tiled/tile_output.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

#if HWY_TARGET == HWY_SCALAR

template <int kGrid>
HWY_INLINE void ResolveTile(const FrameJob& job, const Worker& worker, TileOrigin origin)
{
    averageColor(job, worker, origin);
}

#else

// Sums of two channels at a time: red and blue, or alpha and green, in the 16-bit halves of a lane.
using RowTag = hn::FixedTag<std::uint32_t, kBlockSide>; ///< a row of a block
using Row = hn::Vec<RowTag>;

template <class V>
HWY_INLINE V RedBlue(V colors)
{
    return hn::And(colors, hn::Set(hn::DFromV<V>(), 0x00ff00ffU));
}

template <class V>
HWY_INLINE V AlphaGreen(V colors)
{
    return RedBlue(hn::ShiftRight<8>(colors));
}

/// Pairs of lanes (red and blue, alpha and green) of two pixels become their means in the even lanes.
template <int kSamplesLog2>
HWY_INLINE Row MeansOf(Row sums)
{
    const hn::Repartition<std::uint16_t, RowTag> halves;
    const hn::Repartition<std::uint64_t, RowTag> pairs;
    const auto rounding = hn::Set(halves, std::uint16_t(1U << (kSamplesLog2 - 1)));
    const auto means = hn::ShiftRight<kSamplesLog2>(hn::Add(hn::BitCast(halves, sums), rounding));
    const auto wide = hn::BitCast(pairs, means);
    return hn::BitCast(RowTag(), hn::Or(wide, hn::ShiftRight<24>(wide)));
}

/// Adds the rows that a vector holds.
template <class V>
HWY_INLINE Row SumOfRows(V rows)
{
    constexpr hn::DFromV<V> tag;
    if constexpr (hn::MaxLanes(tag) == kBlockSide)
        return rows;
    else
        return SumOfRows(hn::Add(hn::LowerHalf(rows), hn::UpperHalf(hn::Half<hn::DFromV<V>>(), rows)));
}

/// Red and blue, alpha and green of columns 0 and 2 of a block, then of columns 1 and 3.
HWY_INLINE Row HalfSumOfBlock(const std::uint32_t* block)
{
    constexpr UintTag tag;
    Uints redBlue = hn::Zero(tag);
    Uints alphaGreen = hn::Zero(tag);
    for (std::size_t v = 0; v < kVectors; ++v) {
        const Uints colors = hn::Load(tag, block + v * kPerVector);
        redBlue = hn::Add(redBlue, RedBlue(colors));
        alphaGreen = hn::Add(alphaGreen, AlphaGreen(colors));
    }
    return SumOfRows(
        hn::Add(hn::InterleaveLower(tag, redBlue, alphaGreen), hn::InterleaveUpper(tag, redBlue, alphaGreen)));
}

/// Adds the halves of two rows: those of the first, then those of the second.
HWY_INLINE Row SumOfHalves(Row first, Row second)
{
    constexpr RowTag tag;
    return hn::Add(hn::ConcatLowerLower(tag, second, first), hn::ConcatUpperUpper(tag, second, first));
}

/// Means of four blocks side by side, each of which is a pixel.
HWY_INLINE void ResolvePixelBlocks(const std::uint32_t* blocks, std::array<std::uint32_t, 4>& out)
{
    constexpr RowTag tag;
    const auto half = [&](std::size_t block) HWY_ATTR { return HalfSumOfBlock(blocks + block * kLanes); };
    const Row first = MeansOf<4>(SumOfHalves(half(0), half(1)));
    const Row second = MeansOf<4>(SumOfHalves(half(2), half(3)));
    hn::StoreU(hn::ConcatEven(tag, second, first), tag, out.data());
}

/// Means of two rows of two blocks side by side: four pixels.
HWY_INLINE void ResolveRows(const std::uint32_t* blocks, std::array<std::uint32_t, 4>& out)
{
    constexpr RowTag tag;
    const auto pixels = [&](const std::uint32_t* block) HWY_ATTR {
        const Row upper = hn::Load(tag, block);
        const Row lower = hn::Load(tag, block + kBlockSide);
        const Row redBlue = hn::Add(RedBlue(upper), RedBlue(lower));
        const Row alphaGreen = hn::Add(AlphaGreen(upper), AlphaGreen(lower));
        return MeansOf<2>(
            SumOfHalves(hn::InterleaveLower(tag, redBlue, alphaGreen), hn::InterleaveUpper(tag, redBlue, alphaGreen)));
    };
    hn::StoreU(hn::ConcatEven(tag, pixels(blocks + kLanes), pixels(blocks)), tag, out.data());
}

/// The pixels of a tile that are not resolved yet, four at a time.
template <int kGrid>
HWY_INLINE void ResolveTile(const FrameJob& job, const Worker& worker, TileOrigin origin)
{
    constexpr int kFour = 4 * kGrid; // samples along the row
    const PixelBox box = pixelsOf(job, origin);
    for (int y = 0; y < box.y1 - box.y0; ++y)
        for (int x = 0; x < box.x1 - box.x0; x += 4) {
            const int at = sampleIndex(x / 4 * kFour, y * kGrid);
            if ((worker.resolvedSubtiles >> (at / (kLanes * kLanes)) & 1) != 0)
                continue;
            std::array<std::uint32_t, 4> pixels;
            if constexpr (kGrid == 4)
                ResolvePixelBlocks(worker.samples.color.data() + at, pixels);
            else
                ResolveRows(worker.samples.color.data() + at, pixels);
            std::copy_n(pixels.begin(), std::min(4, box.x1 - box.x0 - x),
                        job.color + pixelIndex(job, box.x0 + x, box.y0 + y));
        }
}

#endif

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
