// Squares of samples, 16 at a time: which a triangle touches and covers, and what is to be done about blocks. Included
// once for each target: see README.md.
#if defined(RASTERLENS_TILED_SQUARES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_SQUARES_INL_H
#undef RASTERLENS_TILED_SQUARES_INL_H
#else
#define RASTERLENS_TILED_SQUARES_INL_H
#endif

#include "core/tiled/blocks-inl.h"
#include "core/tiled/frame_job.h"
#include "core/tiled/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// The state of a tile between its triangles.
struct TileDepth {
    std::int32_t farthest;     ///< a key no sample of the tile is farther than
    std::int32_t nearestSmall; ///< a key no small triangle so far is nearer than
    int updates = 0;           ///< blocks that came nearer since `farthest` was found
    bool blank = true;         ///< there are blocks without any sample written yet
    bool owners = false;       ///< there may be blocks that belong to one triangle
};

/// Which of 16 squares of 2^kSideLog2 samples the triangle touches and covers, a bit each.
struct SquareVerdicts {
    std::uint32_t touched = 0;
    std::uint32_t covered = 0;
};

/// Multi-sampling: touched are squares of which a sample may be covered, covered those of which all are.
template <class Policy, int kSideLog2>
HWY_INLINE SquareVerdicts JudgeSquares(const TriangleLanes& t, const std::array<std::int32_t, 3>& first,
                                       SquareCorners& corners)
{
    constexpr IntTag tag;
    constexpr int kLast = (1 << kSideLog2) - 1;
    SquareVerdicts verdicts;
    for (std::size_t v = 0; v < kVectors; ++v) {
        std::array<Ints, 3> highest;
        std::array<Ints, 3> lowest;
        for (std::size_t k = 0; k < 3; ++k) {
            const Ints corner = hn::Add(hn::Set(tag, first[k]), hn::ShiftLeft<kSideLog2>(t.edge[k][v]));
            hn::Store(corner, tag, corners.edge[k].data() + v * kPerVector);
            const std::int32_t reach = Policy::kPattern ? t.reach[k] : 0;
            highest[k] = hn::Add(corner, hn::Set(tag, kLast * (std::max(t.a[k], 0) + std::max(t.b[k], 0)) + reach));
            lowest[k] = hn::Add(corner, hn::Set(tag, kLast * (std::min(t.a[k], 0) + std::min(t.b[k], 0)) - reach));
        }
        const auto bits = [&](const std::array<Ints, 3>& e) HWY_ATTR {
            return BitsOf(tag, NotNegative(hn::Or3(e[0], e[1], e[2]))) << (v * kPerVector);
        };
        verdicts.touched |= bits(highest);
        verdicts.covered |= bits(lowest);
    }
    return verdicts;
}

/// The blocks of 4 x 4 that the triangle may touch, a bit each.
///
/// in   edge values at the first sample of them
HWY_INLINE std::uint32_t TouchedSquares(const TriangleLanes& t, const std::array<std::int32_t, 3>& first,
                                        SquareCorners& corners)
{
    constexpr IntTag tag;
    const std::array<Ints, 3> start{hn::Set(tag, first[0]), hn::Set(tag, first[1]), hn::Set(tag, first[2])};
    std::uint32_t touched = 0;
    for (std::size_t v = 0; v < kVectors; ++v) {
        std::array<Ints, 3> highest;
        for (std::size_t k = 0; k < 3; ++k) {
            const Ints corner = hn::Add(hn::ShiftLeft<2>(t.edge[k][v]), start[k]);
            hn::Store(corner, tag, corners.edge[k].data() + v * kPerVector);
            highest[k] = hn::Add(corner, t.toHighest[k]);
        }
        touched |= BitsOf(tag, NotNegative(hn::Or3(highest[0], highest[1], highest[2]))) << (v * kPerVector);
    }
    return touched;
}

inline void RefreshFarthest(const TileSamples& samples, TileDepth& tile)
{
    constexpr IntTag tag;
    Ints farthest = hn::Zero(tag);
    for (std::size_t i = 0; i < kTileBlocks; i += kPerVector)
        farthest = hn::Max(farthest, hn::Load(tag, samples.farthest.data() + i));
    tile.farthest = hn::GetLane(hn::MaxOfLanes(tag, farthest));
    tile.updates = 0;
}

/// Depths at the first samples of 16 blocks.
HWY_INLINE void StoreDepths(const TriangleLanes& t, double first, SquareCorners& corners)
{
    constexpr DoubleTag tag;
    for (std::size_t v = 0; v < kVectors; ++v)
        Store(Add(Mul(t.depth[v], hn::Set(tag, double(kBlockSide))), hn::Set(tag, first)),
              corners.depth.data() + v * kPerVector);
}

/// What is to be done about the blocks of a subtile, a bit each.
struct BlockWork {
    std::uint32_t cover;       ///< sample by sample
    std::uint32_t writeBefore; ///< the blocks to be tested that have an owner, whose samples are written first
};

template <bool kPattern>
HWY_INLINE BlockWork DecideBlocks(const TriangleLanes& t, double firstDepth, SquareVerdicts verdicts,
                                  const AnyDepth<kPattern>&, std::size_t, TileSamples&, TileDepth&,
                                  SquareCorners& corners)
{
    StoreDepths(t, firstDepth, corners);
    return {verdicts.touched, 0};
}

/// Drops the blocks behind what is there, and gives those that the triangle covers wholly and in front of everything
/// to it without looking at their samples.
///
/// exact  bounds are depths at corner samples, which the plane gives exactly; rounding to float32 keeps order, and so
///        does adding what samples of a pattern may lie nearer or farther
template <Keeps kKeep, bool kPattern>
HWY_INLINE BlockWork DecideBlocks(const TriangleLanes& t, double firstDepth, SquareVerdicts verdicts,
                                  const UsualDepth<kKeep, kPattern>&, std::size_t firstBlock, TileSamples& samples,
                                  TileDepth& tile, SquareCorners& corners)
{
    constexpr IntTag tag;
    constexpr UintTag unsignedTag;
    constexpr DoubleTag wide;
    const Ints nearestSmall = hn::Set(tag, tile.nearestSmall);
    const Doubles first = hn::Set(wide, firstDepth);
    const Doubles toNearest = hn::Set(wide, 3 * (std::min(t.perX, 0.0) + std::min(t.perY, 0.0)));
    const Doubles toFarthest = hn::Set(wide, 3 * (std::max(t.perX, 0.0) + std::max(t.perY, 0.0)));
    BlockWork work{0, 0};
    for (std::size_t v = 0; v < kVectors; ++v) {
        const std::size_t at = firstBlock + v * kPerVector;
        const std::size_t shift = v * kPerVector;
        const WideDoubles corner = Add(Mul(t.depth[v], hn::Set(wide, double(kBlockSide))), first);
        Store(corner, corners.depth.data() + shift);
        WideDoubles nearestDepth = Add(corner, toNearest);
        WideDoubles farthestDepth = Add(corner, toFarthest);
        if constexpr (kPattern) {
            nearestDepth = Add(nearestDepth, hn::Set(wide, -t.depthReach));
            farthestDepth = Add(farthestDepth, hn::Set(wide, t.depthReach));
        }
        const Ints nearest = KeyOf(nearestDepth);
        const Ints farthest = KeyOf(farthestDepth);
        const Ints nearestThere = hn::Min(hn::Load(tag, samples.nearest.data() + at), nearestSmall);
        const Ints farthestThere = hn::Load(tag, samples.farthest.data() + at);
        const auto shown = hn::And(MaskOf(tag, verdicts.touched >> shift), hn::Lt(nearest, farthestThere));
        const auto covered = hn::And(MaskOf(tag, verdicts.covered >> shift), shown);
        const auto owned = hn::And(covered, hn::Lt(farthest, nearestThere));
        const Uints owner = hn::Load(unsignedTag, samples.owner.data() + at);
        hn::Store(hn::IfThenElse(shown, hn::Min(nearest, nearestThere), nearestThere), tag,
                  samples.nearest.data() + at);
        hn::Store(hn::IfThenElse(covered, hn::Min(farthest, farthestThere), farthestThere), tag,
                  samples.farthest.data() + at);
        hn::Store(hn::IfThenElse(hn::RebindMask(unsignedTag, owned), hn::Set(unsignedTag, t.number), owner),
                  unsignedTag, samples.owner.data() + at);
        const std::uint32_t cover = BitsOf(tag, hn::AndNot(owned, shown));
        work.cover |= cover << shift;
        work.writeBefore |= (cover & BitsOf(unsignedTag, hn::Ne(owner, hn::Set(unsignedTag, kNobody)))) << shift;
        tile.updates += std::popcount(BitsOf(tag, covered));
        tile.owners |= !hn::AllFalse(tag, owned);
    }
    return work;
}

/// Bits of the squares, of 4 x 4, in these columns and rows.
constexpr std::uint32_t SquaresBetween(int column0, int row0, int column1, int row1)
{
    const std::uint32_t columns = (2U << column1) - (1U << column0);
    const std::uint32_t rows = (16U << row1 * 4) - (1U << row0 * 4);
    return (columns * 0x1111U) & rows;
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
