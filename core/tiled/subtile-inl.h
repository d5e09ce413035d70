// With 4 x 4 samples a pixel, where a triangle has a subtile to itself: sixteen pixels at a time, sample by sample, so
// that a pixel's samples are summed up in its lane and never stored. Included once for each target: see README.md.
#if defined(RASTERLENS_TILED_SUBTILE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_SUBTILE_INL_H
#undef RASTERLENS_TILED_SUBTILE_INL_H
#else
#define RASTERLENS_TILED_SUBTILE_INL_H
#endif

#include "core/tiled/blocks-inl.h"
#include "core/tiled/gouraud-inl.h"
#include "core/tiled/tile_output.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// The triangle that has all blocks of a subtile, or kNobody.
HWY_INLINE std::uint32_t SubtileOwner(const std::uint32_t* owners)
{
    return owners[0] < kEmpty && LanesWith(owners, owners[0]) == 0xffff ? owners[0] : kNobody;
}

/// Colours from sums of 16 samples, two channels in one number, to which half of 16 has been added.
HWY_INLINE Uints MeanOf16(Uints redBlueSum, Uints alphaGreenSum)
{
    const Uints halves = hn::Set(UintTag(), 0x00ff00ffU);
    const Uints alphaGreen = hn::And(hn::ShiftRight<4>(alphaGreenSum), halves);
    return hn::OrAnd(hn::ShiftLeft<8>(alphaGreen), hn::ShiftRight<4>(redBlueSum), halves);
}

/// Means of the 16 samples of each of a vector of pixels, the square-th pixel in the square-th lane.
HWY_INLINE Uints AffineMeans(const ColorSquares& squares, std::size_t v)
{
    const ChannelPairs corners = squares.corners.load(v * kPerVector);
    Uints redBlueSum = hn::Set(UintTag(), 0x00080008U);
    Uints alphaGreenSum = redBlueSum;
    for (std::size_t s = 0; s < kLanes; ++s) {
        const ChannelPairs color = Add(corners, squares.offsets.spread(s));
        redBlueSum = hn::Add(redBlueSum, UpperBytes(color.redBlue));
        alphaGreenSum = hn::Add(alphaGreenSum, UpperBytes(color.alphaGreen));
    }
    return MeanOf16(redBlueSum, alphaGreenSum);
}

HWY_INLINE Uints PerspectiveMeans(const ColorSquares& squares, std::size_t v)
{
    constexpr FloatTag tag;
    constexpr UintTag unsignedTag;
    const auto first = [&](int at, const std::array<float, kLanes>& pattern) HWY_ATTR {
        const Floats inBlocks = hn::Load(FloatTag(), pattern.data() + v * kPerVector);
        return hn::Add(hn::Set(FloatTag(), static_cast<float>(at)),
                       hn::Mul(inBlocks, hn::Set(FloatTag(), float(kBlockSide))));
    };
    const Floats x = first(squares.x, kPattern.floatX);
    const Floats y = first(squares.y, kPattern.floatY);
    const Uints halves = hn::Set(unsignedTag, 0x00ff00ffU);
    Uints redBlueSum = hn::Set(unsignedTag, 0x00080008U);
    Uints alphaGreenSum = redBlueSum;
    for (std::size_t s = 0; s < kLanes; ++s) {
        const Uints color = PerspectiveColor(*squares.planes, hn::Add(x, hn::Set(tag, kPattern.floatX[s])),
                                             hn::Add(y, hn::Set(tag, kPattern.floatY[s])));
        redBlueSum = hn::Add(redBlueSum, hn::And(color, halves));
        alphaGreenSum = hn::Add(alphaGreenSum, hn::And(hn::ShiftRight<8>(color), halves));
    }
    return MeanOf16(redBlueSum, alphaGreenSum);
}

/// The squares of a subtile, its first sample at (x, y) of the target.
HWY_INLINE void FillSubtile(const ColorPlanes& planes, int x, int y, ColorSquares& squares)
{
    squares.fill(planes, x - planes.x0, y - planes.y0);
}

/// Colours the 4 x 4 pixels of a subtile that a triangle has to itself.
///
/// in     (x, y) of its first sample on the target
/// exact  the means of what the samples would have been: the picture does not depend on who owns what
inline void ColorSubtile(const FrameJob& job, const ColorPlanes& planes, int x, int y)
{
    std::array<std::uint32_t, kLanes> pixels;
    ColorSquares squares;
    FillSubtile(planes, x, y, squares);
    for (std::size_t v = 0; v < kVectors; ++v) {
        const bool affine = planes.way == ColorWay::Affine;
        const Uints means = affine ? AffineMeans(squares, v) : PerspectiveMeans(squares, v);
        hn::StoreU(means, UintTag(), pixels.data() + v * kPerVector);
    }
    for (int row = 0; row < 4; ++row)
        std::copy_n(pixels.begin() + 4 * row, 4, job.color + pixelIndex(job, x / 4, y / 4 + row));
}

/// Colours blocks of a subtile, a bit each, that all belong to the triangle `owner` or, for kEmpty, hold no triangle.
///
/// in   the first of the blocks of the subtile
inline void ColorOwned(const FrameJob& job, Worker& worker, TileOrigin origin, std::size_t first, std::uint32_t owner,
                       std::uint32_t blocks)
{
    constexpr UintTag tag;
    const auto forEach = [&](auto&& colorOf) HWY_ATTR {
        for (std::uint32_t bits = blocks; bits != 0; bits &= bits - 1) {
            const auto square = static_cast<std::size_t>(std::countr_zero(bits));
            for (std::size_t lane = 0; lane < kLanes; lane += kPerVector)
                hn::Store(colorOf(square, lane), tag, worker.samples.color.data() + (first + square) * kLanes + lane);
        }
    };
    if (owner == kEmpty) {
        forEach([&](std::size_t, std::size_t) HWY_ATTR { return hn::Set(UintTag(), job.clearColor); });
        return;
    }
    const ColorPlanes& planes = worker.colors(owner);
    if (HWY_UNLIKELY(planes.way == ColorWay::Exact)) {
        for (std::uint32_t bits = blocks; bits != 0; bits &= bits - 1)
            ColorExactly(job, origin, owner, first + static_cast<std::size_t>(std::countr_zero(bits)), 0xffff, worker);
        return;
    }
    ColorSquares squares;
    FillSubtile(planes, origin.x + blockColumn(static_cast<int>(first)) * kBlockSide,
                origin.y + blockRow(static_cast<int>(first)) * kBlockSide, squares);
    forEach([&](std::size_t square, std::size_t lane) HWY_ATTR { return squares.color(square, lane); });
}

/// Colours the blocks whose samples were never written: they have an owner, or hold no triangle.
inline void FinishColors(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    const bool whole = origin.x + kTileSide <= job.rules.columns() && origin.y + kTileSide <= job.rules.rows();
    const bool takesSubtiles = whole && job.rules.sampleGrid == 4;
    for (std::size_t first = 0; first < kTileBlocks; first += kLanes) {
        const std::uint32_t* owners = worker.samples.owner.data() + first;
        const std::uint32_t owner = takesSubtiles ? SubtileOwner(owners) : kNobody;
        if (owner != kNobody && worker.colors(owner).way != ColorWay::Exact) {
            ColorSubtile(job, worker.colors(owner), origin.x + blockColumn(static_cast<int>(first)) * kBlockSide,
                         origin.y + blockRow(static_cast<int>(first)) * kBlockSide);
            worker.resolvedSubtiles |= 1U << (first / kLanes);
            continue;
        }
        for (std::uint32_t left = 0xffff & ~LanesWith(owners, kNobody); left != 0;) {
            const std::uint32_t next = owners[std::countr_zero(left)];
            const std::uint32_t blocks = LanesWith(owners, next);
            ColorOwned(job, worker, origin, first, next, blocks);
            left &= ~blocks;
        }
    }
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
