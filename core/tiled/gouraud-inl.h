// Interpolated colours: each block of a tile is shaded as it is met, triangle by triangle, in registers. Included once
// for each target: see README.md.
#if defined(RASTERLENS_TILED_GOURAUD_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_GOURAUD_INL_H
#undef RASTERLENS_TILED_GOURAUD_INL_H
#else
#define RASTERLENS_TILED_GOURAUD_INL_H
#endif

#include "core/tiled/exact_path.h"
#include "core/tiled/frame_job.h"
#include "core/tiled/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// Samples of the block that hold the number, a bit each.
HWY_INLINE std::uint32_t LanesWith(const std::uint32_t* ids, std::uint32_t number)
{
    constexpr UintTag tag;
    std::uint32_t bits = 0;
    for (std::size_t v = 0; v < kVectors; ++v)
        bits |= BitsOf(tag, hn::Eq(hn::Load(tag, ids + v * kPerVector), hn::Set(tag, number))) << (v * kPerVector);
    return bits;
}

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

/// Packs colours that may lie outside of 0 to 255: they are held within that range first.
HWY_INLINE Uints PackHeld(Floats red, Floats green, Floats blue)
{
    const auto held = [](Floats c)
                          HWY_ATTR { return hn::Min(hn::Max(c, hn::Zero(FloatTag())), hn::Set(FloatTag(), 255.0F)); };
    return PackChannels(held(red), held(green), held(blue));
}

/// Colours of ColorWay::Perspective at samples relative to the anchor.
HWY_INLINE Uints PerspectiveColor(const ColorPlanes& planes, Floats x, Floats y)
{
    constexpr FloatTag tag;
    const auto number = [](std::int32_t bits) HWY_ATTR { return hn::Set(FloatTag(), std::bit_cast<float>(bits)); };
    const auto plane = [&](std::size_t i) HWY_ATTR {
        return hn::Add(number(planes.origin[i]),
                       hn::Add(hn::Mul(number(planes.perX[i]), x), hn::Mul(number(planes.perY[i]), y)));
    };
    const Floats w = hn::Div(hn::Set(tag, 1.0F), plane(0));
    return PackHeld(hn::Mul(plane(1), w), hn::Mul(plane(2), w), hn::Mul(plane(3), w));
}

/// Colours of ColorWay::Perspective in a block whose first sample is at (x, y) relative to the anchor: the vector of
/// samples that starts at `lane`.
HWY_INLINE Uints PerspectiveColor(const ColorPlanes& planes, int x, int y, std::size_t lane)
{
    constexpr FloatTag tag;
    return PerspectiveColor(planes,
                            hn::Add(hn::Load(tag, kPattern.floatX.data() + lane), hn::Set(tag, static_cast<float>(x))),
                            hn::Add(hn::Load(tag, kPattern.floatY.data() + lane), hn::Set(tag, static_cast<float>(y))));
}

/// Multi-sampling: the planes of ColorWay::Affine over 4 x 4 blocks. They are planes of float32 then: nothing wraps
/// round where the centres of pixels lie beside the triangle.
struct alignas(64) HeldSquares {
    std::array<std::array<float, kLanes>, 3> corner;
    std::array<std::array<float, kLanes>, 3> offset; ///< from the first pixel of a block to the others

    /// in   the first pixel of the first block, relative to the anchor
    HWY_INLINE void fill(const ColorPlanes& planes, int x, int y)
    {
        constexpr FloatTag tag;
        const auto number = [](std::int32_t bits) HWY_ATTR { return hn::Set(FloatTag(), std::bit_cast<float>(bits)); };
        const Floats side = hn::Set(tag, float(kBlockSide));
        for (std::size_t lane = 0; lane < kLanes; lane += kPerVector) {
            const Floats column = hn::Load(tag, kPattern.floatX.data() + lane);
            const Floats row = hn::Load(tag, kPattern.floatY.data() + lane);
            const Floats toX = hn::Add(hn::Mul(column, side), hn::Set(tag, static_cast<float>(x)));
            const Floats toY = hn::Add(hn::Mul(row, side), hn::Set(tag, static_cast<float>(y)));
            for (std::size_t i = 0; i < 3; ++i) {
                const Floats perX = number(planes.perX[i + 1]);
                const Floats perY = number(planes.perY[i + 1]);
                const Floats way = hn::Add(hn::Mul(perX, toX), hn::Mul(perY, toY));
                hn::Store(hn::Add(number(planes.origin[i + 1]), way), tag, corner[i].data() + lane);
                hn::Store(hn::Add(hn::Mul(perX, column), hn::Mul(perY, row)), tag, offset[i].data() + lane);
            }
        }
    }
    HWY_INLINE Floats channel(std::size_t i, std::size_t square, std::size_t lane) const
    {
        return hn::Add(hn::Set(FloatTag(), corner[i][square]), hn::Load(FloatTag(), offset[i].data() + lane));
    }
    /// Colours of the square-th block: the vector of pixels that starts at `lane`.
    HWY_INLINE Uints held(std::size_t square, std::size_t lane) const
    {
        return PackHeld(channel(0, square, lane), channel(1, square, lane), channel(2, square, lane));
    }
    /// Colours of a block that the triangle covers: between its corners no channel leaves 0 to 255.
    HWY_INLINE Uints inside(std::size_t square, std::size_t lane) const
    {
        return PackChannels(channel(0, square, lane), channel(1, square, lane), channel(2, square, lane));
    }
};

/// Multi-sampling: colours of one block at the centres of pixels. Not for ColorWay::Exact.
HWY_INLINE Uints HeldColor(const ColorPlanes& planes, int x, int y, std::size_t lane)
{
    if (HWY_UNLIKELY(planes.way != ColorWay::Affine))
        return PerspectiveColor(planes, x, y, lane);
    HeldSquares squares;
    squares.fill(planes, x, y);
    return squares.held(0, lane);
}

/// Colours of ColorWay::Affine of a vector of samples, two channels to a number, in 2^-8 of a step modulo 256 steps:
/// red and blue, alpha and green.
struct ChannelPairs {
    Uints redBlue;
    Uints alphaGreen;
};

HWY_INLINE ChannelPairs Add(const ChannelPairs& a, const ChannelPairs& b)
{
    return {AddHalves(a.redBlue, b.redBlue), AddHalves(a.alphaGreen, b.alphaGreen)};
}

HWY_INLINE Uints ColorOf(const ChannelPairs& pairs)
{
    return hn::OrAnd(UpperBytes(pairs.redBlue), pairs.alphaGreen, hn::Set(UintTag(), 0xff00ff00U));
}

/// Opaque alpha plus half a step: what greens lose below 0 they borrow from it.
constexpr std::uint32_t kOpaque = 0xff800000U;

/// A channel of ColorWay::Affine at (x, y) relative to the anchor.
HWY_INLINE std::uint32_t ChannelAt(const ColorPlanes& planes, std::size_t channel, int x, int y)
{
    const auto bits = [](std::int32_t number) { return static_cast<std::uint32_t>(number); };
    return bits(planes.origin[channel + 1]) + bits(planes.perX[channel + 1]) * bits(x) +
           bits(planes.perY[channel + 1]) * bits(y);
}

/// Channels of ColorWay::Affine, red, green and blue, of a vector of samples, in the units of the planes.
using ChannelLanes = std::array<Uints, 3>;

/// From the first sample of a block to the others.
HWY_INLINE ChannelLanes ChannelsInBlock(const ColorPlanes& planes, std::size_t lane)
{
    constexpr IntTag tag;
    const Ints x = hn::Load(tag, kPattern.x.data() + lane);
    const Ints y = hn::Load(tag, kPattern.y.data() + lane);
    const auto channel = [&](std::size_t i) HWY_ATTR {
        const Ints alongX = hn::Mul(x, hn::Set(IntTag(), planes.perX[i + 1]));
        const Ints alongY = hn::Mul(y, hn::Set(IntTag(), planes.perY[i + 1]));
        return hn::BitCast(UintTag(), hn::Add(alongX, alongY));
    };
    return {channel(0), channel(1), channel(2)};
}

/// Cuts off what channels have below 2^-8 of a step.
///
/// in   what stands above the greens
HWY_INLINE ChannelPairs PairsOf(const ChannelLanes& channels, std::uint32_t alpha)
{
    constexpr UintTag tag;
    const auto& [red, green, blue] = channels;
    return {hn::OrAnd(hn::ShiftRight<16>(blue), red, hn::Set(tag, 0xffff0000U)),
            hn::Or(hn::ShiftRight<16>(green), hn::Set(tag, alpha))};
}

/// ChannelPairs in memory.
struct alignas(64) StoredPairs {
    std::array<std::uint32_t, kLanes> redBlue;
    std::array<std::uint32_t, kLanes> alphaGreen;

    HWY_INLINE void store(const ChannelPairs& pairs, std::size_t lane)
    {
        hn::Store(pairs.redBlue, UintTag(), redBlue.data() + lane);
        hn::Store(pairs.alphaGreen, UintTag(), alphaGreen.data() + lane);
    }
    HWY_INLINE ChannelPairs load(std::size_t lane) const
    {
        return {hn::Load(UintTag(), redBlue.data() + lane), hn::Load(UintTag(), alphaGreen.data() + lane)};
    }
    /// One of them in all lanes.
    HWY_INLINE ChannelPairs spread(std::size_t at) const
    {
        return {hn::Set(UintTag(), redBlue[at]), hn::Set(UintTag(), alphaGreen[at])};
    }
};

/// Colours of a triangle in 4 x 4 blocks.
struct ColorSquares {
    StoredPairs corners;
    StoredPairs offsets; ///< from the first sample of a block to the others
    const ColorPlanes* planes;
    int x, y; ///< the first sample, relative to the anchor

    HWY_INLINE void fill(const ColorPlanes& triangle, int firstX, int firstY)
    {
        const auto channel = [&](std::size_t i) HWY_ATTR { return ChannelAt(triangle, i, firstX, firstY); };
        fillFrom({channel(0), channel(1), channel(2)}, triangle, firstX, firstY);
    }
    /// Blocks from the anchor of the triangle's record on, where the planes of affine colours begin.
    HWY_INLINE void fillFromAnchor(const ColorPlanes& triangle, int firstX, int firstY)
    {
        const auto channel = [&](std::size_t i) HWY_ATTR { return static_cast<std::uint32_t>(triangle.origin[i + 1]); };
        fillFrom({channel(0), channel(1), channel(2)}, triangle, firstX, firstY);
    }

    /// Colours of the square-th block: the vector of samples that starts at `lane`. Not for ColorWay::Exact.
    HWY_INLINE Uints color(std::size_t square, std::size_t lane) const
    {
        return HWY_LIKELY(planes->way == ColorWay::Affine) ? affineColor(square, lane) : perspectiveColor(square, lane);
    }
    HWY_INLINE Uints affineColor(std::size_t square, std::size_t lane) const
    {
        return ColorOf(Add(corners.spread(square), offsets.load(lane)));
    }
    HWY_INLINE Uints perspectiveColor(std::size_t square, std::size_t lane) const
    {
        const auto at = static_cast<int>(square);
        return PerspectiveColor(*planes, x + at % 4 * kBlockSide, y + at / 4 * kBlockSide, lane);
    }

private:
    /// in   channels of affine colours at the first sample
    HWY_INLINE void fillFrom(const std::array<std::uint32_t, 3>& first, const ColorPlanes& triangle, int firstX,
                             int firstY)
    {
        planes = &triangle;
        x = firstX;
        y = firstY;
        for (std::size_t lane = 0; lane < kLanes; lane += kPerVector) {
            const ChannelLanes inBlock = ChannelsInBlock(triangle, lane);
            ChannelLanes firsts; // of blocks
            for (std::size_t i = 0; i < 3; ++i)
                firsts[i] = hn::Add(hn::ShiftLeft<2>(inBlock[i]), hn::Set(UintTag(), first[i]));
            corners.store(PairsOf(firsts, kOpaque), lane);
            offsets.store(PairsOf(inBlock, 0), lane);
        }
    }
};

/// Colours the samples of one block whose first is at (x, y) of the target. Not for ColorWay::Exact.
///
/// in     held: multi-sampling
/// exact  what ColorSquares has: wherever sums in the units of planes begin, they are the same
HWY_INLINE Uints BlockColor(const ColorPlanes& planes, int x, int y, std::size_t v, bool held)
{
    const int toX = x - planes.x0;
    const int toY = y - planes.y0;
    const std::size_t lane = v * kPerVector;
    if (held)
        return HeldColor(planes, toX, toY, lane);
    if (HWY_UNLIKELY(planes.way != ColorWay::Affine))
        return PerspectiveColor(planes, toX, toY, lane);
    ChannelLanes first;
    for (std::size_t i = 0; i < 3; ++i)
        first[i] = hn::Set(UintTag(), ChannelAt(planes, i, toX, toY));
    return ColorOf(Add(PairsOf(first, kOpaque), PairsOf(ChannelsInBlock(planes, lane), 0)));
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
