// Multi-sampling: colours of pixels go to their samples, and come back as means. Included once for each target: see
// README.md.
#if defined(RASTERLENS_TILED_PATTERN_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_PATTERN_INL_H
#undef RASTERLENS_TILED_PATTERN_INL_H
#else
#define RASTERLENS_TILED_PATTERN_INL_H
#endif

#include "core/tiled/blocks-inl.h"
#include "core/tiled/frame_job.h"
#include "core/tiled/gouraud-inl.h"
#include "core/tiled/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// The colours of a block at the centres of pixels.
///
/// in   the pixels that must be right, a bit each
/// out  in worker.samples
inline void ColorCentres(const FrameJob& job, TileOrigin origin, std::uint32_t number, std::size_t block,
                         std::uint32_t lanes, Worker& worker)
{
    const ColorPlanes& planes = worker.colors(number);
    if (HWY_UNLIKELY(planes.way == ColorWay::Exact)) {
        ColorExactly(job, origin, number, block, lanes, worker);
        return;
    }
    const int x = origin.x + blockColumn(static_cast<int>(block)) * kBlockSide - planes.x0;
    const int y = origin.y + blockRow(static_cast<int>(block)) * kBlockSide - planes.y0;
    for (std::size_t lane = 0; lane < kLanes; lane += kPerVector)
        hn::Store(HeldColor(planes, x, y, lane), UintTag(), worker.samples.color.data() + block * kLanes + lane);
}

/// Gives colours of pixels to those of their samples that hold the number.
///
/// in   16 pixels of the block, from `lane` on a vector of them
HWY_INLINE void ShareColors(const PixelPattern& pattern, std::uint32_t number, std::size_t block, std::size_t lane,
                            Uints color, Worker& worker)
{
    constexpr UintTag tag;
    for (std::size_t s = 0; s < pattern.samples; ++s) {
        const std::size_t at = (block * pattern.samples + s) * kLanes + lane;
        std::uint32_t* out = worker.pattern.color.data() + at;
        const auto won = hn::Eq(hn::Load(tag, worker.pattern.ids.data() + at), hn::Set(tag, number));
        hn::Store(hn::IfThenElse(won, color, hn::Load(tag, out)), tag, out);
    }
}

/// Gives the colours in worker.samples to the samples.
inline void ShareColors(const PixelPattern& pattern, std::uint32_t number, std::size_t block, Worker& worker)
{
    for (std::size_t lane = 0; lane < kLanes; lane += kPerVector)
        ShareColors(pattern, number, block, lane,
                    hn::Load(UintTag(), worker.samples.color.data() + block * kLanes + lane), worker);
}

/// Clears the colours of a block's samples.
inline void ClearSamples(const FrameJob& job, std::size_t block, Worker& worker)
{
    const std::size_t count = job.pattern.samples * kLanes;
    std::fill_n(worker.pattern.color.data() + block * count, count, job.clearColor);
}

/// Calls use(number, pixels, samples) for each triangle that has samples of a block: its pixels, a bit each, and how
/// many samples they are.
///
/// in   the pixels that count, a bit each
template <class Use>
HWY_INLINE void ForEachNumber(const PixelPattern& pattern, const Worker& worker, std::size_t block,
                              std::uint32_t pixels, Use&& use)
{
    const std::uint32_t* ids = worker.pattern.ids.data() + block * pattern.samples * kLanes;
    std::array<std::uint32_t, kLanes> left;
    for (std::size_t s = 0; s < pattern.samples; ++s)
        left[s] = pixels & ~LanesWith(ids + s * kLanes, kNobody);
    for (std::size_t first = 0; first < pattern.samples; ++first)
        while (left[first] != 0) {
            const std::uint32_t number = ids[first * kLanes + static_cast<std::size_t>(std::countr_zero(left[first]))];
            std::uint32_t lanes = 0;
            int samples = 0;
            for (std::size_t s = first; s < pattern.samples; ++s) {
                const std::uint32_t won = LanesWith(ids + s * kLanes, number) & left[s];
                left[s] &= ~won;
                lanes |= won;
                samples += std::popcount(won);
            }
            use(number, lanes, samples);
        }
}

/// The means of a block's samples, pixel by pixel.
///
/// out  16 colours
inline void ResolveBlock(const PixelPattern& pattern, const Worker& worker, std::size_t block, std::uint32_t* out)
{
    constexpr UintTag tag;
    const Uints halves = hn::Set(tag, 0x00ff00ffU);
    const int shift = std::countr_zero(pattern.samples);
    for (std::size_t lane = 0; lane < kLanes; lane += kPerVector) {
        const std::uint32_t* colors = worker.pattern.color.data() + block * pattern.samples * kLanes + lane;
        Uints redBlue = hn::Set(tag, static_cast<std::uint32_t>(pattern.samples / 2) * 0x10001U);
        Uints alphaGreen = redBlue;
        for (std::size_t s = 0; s < pattern.samples; ++s) {
            const Uints color = hn::Load(tag, colors + s * kLanes);
            redBlue = hn::Add(redBlue, hn::And(color, halves));
            alphaGreen = hn::Add(alphaGreen, hn::And(hn::ShiftRight<8>(color), halves));
        }
        const Uints low = hn::And(hn::ShiftRightSame(redBlue, shift), halves);
        const Uints high = hn::And(hn::ShiftRightSame(alphaGreen, shift), halves);
        hn::Store(hn::Or(low, hn::ShiftLeft<8>(high)), tag, out + lane);
    }
}

/// Makes pixels of the blocks that do not belong to one triangle.
///
/// out  in worker.samples
inline void ResolveBlocks(const PixelPattern& pattern, Worker& worker)
{
    for (std::size_t block = 0; block < kTileBlocks; ++block)
        if (worker.samples.owner[block] == kNobody)
            ResolveBlock(pattern, worker, block, worker.samples.color.data() + block * kLanes);
}

/// Colours of pixels in blocks of a subtile, a bit each, that all belong to the triangle `owner`.
///
/// in   the first block of the subtile
inline void ColorOwnedPixels(const FrameJob& job, Worker& worker, TileOrigin origin, std::size_t first,
                             std::uint32_t owner, std::uint32_t blocks)
{
    const ColorPlanes& planes = worker.colors(owner);
    HeldSquares squares;
    if (HWY_LIKELY(planes.way == ColorWay::Affine))
        squares.fill(planes, origin.x + blockColumn(static_cast<int>(first)) * kBlockSide - planes.x0,
                     origin.y + blockRow(static_cast<int>(first)) * kBlockSide - planes.y0);
    for (; blocks != 0; blocks &= blocks - 1) {
        const auto square = static_cast<std::size_t>(std::countr_zero(blocks));
        if (HWY_UNLIKELY(planes.way != ColorWay::Affine)) {
            ColorCentres(job, origin, owner, first + square, 0xffff, worker);
            continue;
        }
        std::uint32_t* out = worker.samples.color.data() + (first + square) * kLanes;
        for (std::size_t lane = 0; lane < kLanes; lane += kPerVector)
            hn::Store(squares.inside(square, lane), UintTag(), out + lane);
    }
}

/// Interpolated colours of a tile: of its pixels where blocks have an owner, else of the samples.
inline void FinishPatternColors(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    for (std::size_t first = 0; first < kTileBlocks; first += kLanes) {
        const std::uint32_t* owners = worker.samples.owner.data() + first;
        for (std::uint32_t left = 0xffff; left != 0;) {
            const std::uint32_t owner = owners[std::countr_zero(left)];
            const std::uint32_t blocks = LanesWith(owners, owner);
            left &= ~blocks;
            if (owner < kEmpty) {
                ColorOwnedPixels(job, worker, origin, first, owner, blocks);
                continue;
            }
            for (std::uint32_t bits = blocks; bits != 0; bits &= bits - 1) {
                const std::size_t block = first + static_cast<std::size_t>(std::countr_zero(bits));
                std::uint32_t* out = worker.samples.color.data() + block * kLanes;
                if (owner == kNobody)
                    ResolveBlock(job.pattern, worker, block, out);
                else
                    std::fill_n(out, kLanes, job.clearColor);
            }
        }
    }
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
