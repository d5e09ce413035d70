// First phase of a tile: coverage, depth and the number of the nearest triangle. Included once for each target.
#if defined(RASTERLENS_TILED_COVER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_COVER_INL_H
#undef RASTERLENS_TILED_COVER_INL_H
#else
#define RASTERLENS_TILED_COVER_INL_H
#endif

#include "core/rasterizers/tiled/exact_path.h"
#include "core/rasterizers/tiled/kernels.h"
#include "core/rasterizers/tiled/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

HWY_INLINE hn::Mask<IntTag> NotNegative(Ints v) { return hn::Gt(v, hn::Set(IntTag(), -1)); }

constexpr std::int32_t kKeyOfOne = 0x3f800000; ///< the bits of 1.0F

/// The usual case knows its depth test when it is compiled; every other one reads it from here.
struct UsualDepth {
    static constexpr bool kUsual = true; ///< float32, smaller wins, nobody counts
    UsualDepth(const FrameJob&, TileOrigin) {}
};

struct AnyDepth {
    static constexpr bool kUsual = false;
    AnyDepth(const FrameJob& job, TileOrigin origin)
        : flip(depthFlip(job.rules.depthCompare)), handicap(depthHandicap(job.rules)), format(job.rules.depthFormat),
          countsCoverage(job.countsCoverage()), width(job.rules.columns() - origin.x),
          height(job.rules.rows() - origin.y)
    {
    }
    std::int32_t flip;
    std::int32_t handicap;
    DepthFormat format;
    bool countsCoverage;
    int width; ///< samples of the tile that belong to the target
    int height;
};

/// A triangle spread over the lanes: what changes from the first sample of a block (or first block of a subtile...) to
/// the others.
struct TriangleLanes {
    std::array<std::array<Ints, kVectors>, 3> edge;
    std::array<WideDoubles, kVectors> depth;
    std::array<std::int32_t, 3> a;
    std::array<std::int32_t, 3> b;
    double perX;
    double perY;
};

/// A triangle at a sample: the first of a square of squares.
struct SampleValues {
    std::array<std::int32_t, 3> edge;
    double depth;
};

/// A triangle at sample (x, y) of the tile.
HWY_INLINE SampleValues ValuesAt(const TriangleLanes& lanes, const TileTriangle& t, int x, int y)
{
    const int toX = x - t.anchorX();
    const int toY = y - t.anchorY();
    SampleValues at;
    for (std::size_t k = 0; k < 3; ++k)
        at.edge[k] = t.c[k] + lanes.a[k] * toX + lanes.b[k] * toY;
    at.depth = t.depthOrigin + t.depthPerX * toX + t.depthPerY * toY;
    return at;
}

HWY_INLINE WideDoubles DepthOffsets(double perX, double perY, std::size_t first)
{
    constexpr DoubleTag tag;
    WideDoubles offsets;
    for (std::size_t p = 0; p < kParts; ++p) {
        const std::size_t at = first + p * kDoubles;
        offsets.part[p] = hn::Add(hn::Mul(hn::Load(tag, kPattern.doubleX.data() + at), hn::Set(tag, perX)),
                                  hn::Mul(hn::Load(tag, kPattern.doubleY.data() + at), hn::Set(tag, perY)));
    }
    return offsets;
}

HWY_INLINE TriangleLanes SpreadTriangle(const TileTriangle& t)
{
    constexpr IntTag tag;
    TriangleLanes lanes;
    lanes.a = {t.a[0], t.a[1], -(t.a[0] + t.a[1])};
    lanes.b = {t.b[0], t.b[1], -(t.b[0] + t.b[1])};
    lanes.perX = t.depthPerX;
    lanes.perY = t.depthPerY;
    for (std::size_t v = 0; v < kVectors; ++v) {
        const std::size_t at = v * kPerVector;
        const Ints x = hn::Load(tag, kPattern.x.data() + at);
        const Ints y = hn::Load(tag, kPattern.y.data() + at);
        for (std::size_t k = 0; k < 2; ++k)
            lanes.edge[k][v] = hn::Add(hn::Mul(x, hn::Set(tag, lanes.a[k])), hn::Mul(y, hn::Set(tag, lanes.b[k])));
        lanes.edge[2][v] = hn::Neg(hn::Add(lanes.edge[0][v], lanes.edge[1][v]));
        lanes.depth[v] = DepthOffsets(t.depthPerX, t.depthPerY, at);
    }
    return lanes;
}

/// Depths as stored, 0 to 1, as their bits.
HWY_INLINE Ints KeyOf(const WideDoubles& depth)
{
    constexpr IntTag tag;
    const Ints bits = hn::BitCast(tag, ToFloats(depth));
    return hn::Min(hn::Max(bits, hn::Zero(tag)), hn::Set(tag, kKeyOfOne));
}

/// The nearest values a unorm format stores.
HWY_INLINE WideDoubles RoundToUnorm(const WideDoubles& depth, double steps)
{
    constexpr DoubleTag tag;
    WideDoubles rounded;
    for (std::size_t p = 0; p < kParts; ++p) {
        const Doubles held = hn::Min(hn::Max(depth.part[p], hn::Zero(tag)), hn::Set(tag, 1.0));
        rounded.part[p] = hn::Div(hn::Round(hn::Mul(held, hn::Set(tag, steps))), hn::Set(tag, steps));
    }
    return rounded;
}

HWY_INLINE Ints StoredKey(const WideDoubles& depth, const AnyDepth& policy)
{
    constexpr IntTag tag;
    const Ints key = policy.format == DepthFormat::Unorm24   ? KeyOf(RoundToUnorm(depth, 0xffffff))
                     : policy.format == DepthFormat::Unorm16 ? KeyOf(RoundToUnorm(depth, 0xffff))
                                                             : KeyOf(depth);
    return hn::Xor(key, hn::Set(tag, policy.flip));
}

/// What is beyond 1 needs no holding: it loses against everything.
HWY_INLINE Ints StoredKey(const WideDoubles& depth, const UsualDepth&)
{
    constexpr IntTag tag;
    return hn::Max(hn::BitCast(tag, ToFloats(depth)), hn::Zero(tag));
}

/// Lanes of a block that are samples of the target: only those are counted.
HWY_INLINE hn::Mask<IntTag> OnTarget(const AnyDepth& policy, std::size_t block, std::size_t lane)
{
    constexpr IntTag tag;
    const int x = blockColumn(static_cast<int>(block)) * kBlockSide;
    const int y = blockRow(static_cast<int>(block)) * kBlockSide;
    return hn::And(hn::Lt(hn::Load(tag, kPattern.x.data() + lane), hn::Set(tag, policy.width - x)),
                   hn::Lt(hn::Load(tag, kPattern.y.data() + lane), hn::Set(tag, policy.height - y)));
}

template <class Mask>
HWY_INLINE void CountSamples(const AnyDepth& policy, Mask inside, Mask passed, std::size_t at, Worker& worker)
{
    constexpr IntTag tag;
    std::uint32_t covered = BitsOf(tag, inside);
    const auto coveredCount = static_cast<unsigned>(std::popcount(covered));
    const auto passedCount = static_cast<unsigned>(std::popcount(BitsOf(tag, passed)));
    worker.pixels.tested += kPerVector;
    worker.pixels.covered += coveredCount;
    worker.pixels.depthPassed += passedCount;
    worker.pixels.depthFailed += coveredCount - passedCount;
    if (!policy.countsCoverage)
        return;
    for (; covered != 0; covered &= covered - 1) {
        std::uint16_t& count = worker.samples.coverage[at + static_cast<std::size_t>(std::countr_zero(covered))];
        count = static_cast<std::uint16_t>(count + (count != 0xffff));
    }
}

/// A triangle at the first samples of 16 squares, 4 x 4 of them.
struct alignas(64) SquareCorners {
    std::array<std::array<std::int32_t, kLanes>, 3> edge;
    std::array<double, kLanes> depth;
};

/// Blocks whose samples are still to be tested, in the order of the triangles. They are gathered over several
/// triangles: a loop whose end is foreseen once in a hundred blocks, not once a triangle.
struct alignas(64) BlockQueue {
    static constexpr std::size_t kGroups = 8;

    /// Up to 16 blocks of one triangle.
    struct alignas(64) Group {
        SquareCorners corners;
        SquareCorners offsets; ///< from the first sample of a block to the others
        std::uint32_t number;
    };
    std::array<Group, kGroups> groups;
    /// Block of the tile, group, place in its 16: a byte each from the top. Whole vectors are written at the end.
    std::array<std::uint32_t, (kGroups + 1) * kLanes> items;
    std::size_t groupCount = 0;
    std::size_t itemCount = 0;
};

/// The samples of one block: all of them are computed and those that win are blended in, without a branch.
template <class Policy>
HWY_INLINE void CoverBlock(const BlockQueue::Group& group, std::size_t square, std::size_t block, const Policy& policy,
                           Worker& worker)
{
    constexpr IntTag tag;
    constexpr UintTag unsignedTag;
    constexpr DoubleTag wide;
    const Doubles depth = hn::Set(wide, group.corners.depth[square]);
    for (std::size_t v = 0; v < kVectors; ++v) {
        const std::size_t lane = v * kPerVector;
        const std::size_t at = block * kLanes + lane;
        const auto edge = [&](std::size_t k) HWY_ATTR {
            return hn::Add(hn::Set(tag, group.corners.edge[k][square]),
                           hn::Load(tag, group.offsets.edge[k].data() + lane));
        };
        auto inside = NotNegative(hn::Or3(edge(0), edge(1), edge(2)));
        if constexpr (!Policy::kUsual)
            inside = hn::And(inside, OnTarget(policy, block, lane));
        const Ints key = StoredKey(Add(LoadWide(group.offsets.depth.data() + lane), depth), policy);
        std::int32_t* keys = worker.samples.key.data() + at;
        std::uint32_t* ids = worker.samples.ids.data() + at;
        const Ints stored = hn::Load(tag, keys);
        Ints compared = key;
        if constexpr (!Policy::kUsual)
            compared = hn::Sub(key, hn::Set(tag, policy.handicap));
        const auto passed = hn::And(inside, hn::Lt(compared, stored));
        hn::Store(hn::IfThenElse(passed, key, stored), tag, keys);
        hn::Store(hn::IfThenElse(hn::RebindMask(unsignedTag, passed), hn::Set(unsignedTag, group.number),
                                 hn::Load(unsignedTag, ids)),
                  unsignedTag, ids);
        if constexpr (!Policy::kUsual)
            CountSamples(policy, inside, passed, at, worker);
    }
}

/// Tests the blocks of the queue and empties it.
template <class Policy>
HWY_INLINE void FlushQueue(const Policy& policy, BlockQueue& queue, Worker& worker)
{
    for (std::size_t i = 0; i < queue.itemCount; ++i) {
        const std::uint32_t item = queue.items[i];
        CoverBlock(queue.groups[item >> 8 & 0xff], item & 0xff, item >> 16, policy, worker);
    }
    queue.itemCount = 0;
    queue.groupCount = 0;
}

/// The group that comes next, for its corners to be filled in.
template <class Policy>
HWY_INLINE BlockQueue::Group& NextGroup(const Policy& policy, BlockQueue& queue, Worker& worker)
{
    if (queue.groupCount == BlockQueue::kGroups)
        FlushQueue(policy, queue, worker);
    return queue.groups[queue.groupCount];
}

/// Appends the next group.
///
/// in   the blocks of the tile at the group's 16 places, and which of them are wanted
template <class BlocksAt>
HWY_INLINE void AppendGroup(const TriangleLanes& t, std::uint32_t number, std::uint32_t wanted, BlockQueue& queue,
                            BlocksAt&& blocksAt)
{
    constexpr UintTag tag;
    const auto index = static_cast<std::uint32_t>(queue.groupCount++);
    BlockQueue::Group& group = queue.groups[index];
    group.number = number;
    for (std::size_t v = 0; v < kVectors; ++v) {
        const std::size_t lane = v * kPerVector;
        for (std::size_t k = 0; k < 3; ++k)
            hn::Store(t.edge[k][v], IntTag(), group.offsets.edge[k].data() + lane);
        Store(t.depth[v], group.offsets.depth.data() + lane);
        const Uints places = PlacesFrom(index << 8, lane);
        const Uints items = hn::Or(hn::ShiftLeft<16>(blocksAt(lane)), places);
        const std::uint32_t bits = wanted >> lane & ((1U << kPerVector) - 1);
        hn::StoreU(hn::Compress(items, MaskOf(tag, bits)), tag, queue.items.data() + queue.itemCount);
        queue.itemCount += static_cast<std::size_t>(std::popcount(bits));
    }
}

/// The state of a tile between its triangles.
struct TileDepth {
    std::int32_t farthest;     ///< a key no sample of the tile is farther than
    std::int32_t nearestSmall; ///< a key no small triangle so far is nearer than
    int updates = 0;           ///< blocks that came nearer since `farthest` was found
    bool blank = true;         ///< there are blocks that nobody wrote to
    bool owners = false;       ///< there may be blocks that belong to one triangle
};

/// Clears the samples of the blocks that nobody wrote to: all at once, as those to come are anybody's guess.
inline void WriteBlankBlocks(TileSamples& samples, TileDepth& tile)
{
    if (!tile.blank)
        return;
    tile.blank = false;
    for (std::size_t block = 0; block < kTileBlocks; ++block) {
        if (samples.owner[block] != kEmpty)
            continue;
        samples.owner[block] = kNobody;
        for (std::size_t at = block * kLanes; at < (block + 1) * kLanes; at += kPerVector) {
            hn::Store(hn::Set(IntTag(), samples.clearKey), IntTag(), samples.key.data() + at);
            hn::Store(hn::Set(UintTag(), kNobody), UintTag(), samples.ids.data() + at);
        }
    }
}

/// Writes the keys and ids of a block that one triangle has to itself.
inline void WriteOwnedBlock(std::size_t block, Worker& worker)
{
    TileSamples& samples = worker.samples;
    const std::uint32_t number = samples.owner[block];
    if (number == kNobody)
        return;
    samples.owner[block] = kNobody;
    const TileTriangle& t = worker.triangle(number);
    const int x = blockColumn(static_cast<int>(block)) * kBlockSide - t.anchorX();
    const int y = blockRow(static_cast<int>(block)) * kBlockSide - t.anchorY();
    const Doubles corner = hn::Set(DoubleTag(), t.depthOrigin + t.depthPerX * x + t.depthPerY * y);
    for (std::size_t v = 0; v < kVectors; ++v) {
        const std::size_t at = block * kLanes + v * kPerVector;
        const WideDoubles offsets = DepthOffsets(t.depthPerX, t.depthPerY, v * kPerVector);
        hn::Store(KeyOf(Add(offsets, corner)), IntTag(), samples.key.data() + at);
        hn::Store(hn::Set(UintTag(), number), UintTag(), samples.ids.data() + at);
    }
}

inline void WriteOwnedBlocks(Worker& worker, TileDepth& tile)
{
    WriteBlankBlocks(worker.samples, tile);
    for (std::size_t block = 0; tile.owners && block < kTileBlocks; ++block)
        WriteOwnedBlock(block, worker);
    tile.owners = false;
}

/// Which of 16 squares of 2^kSideLog2 samples the triangle touches and covers, a bit each.
struct SquareVerdicts {
    std::uint32_t touched = 0;
    std::uint32_t covered = 0;
};

template <int kSideLog2>
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
            highest[k] = hn::Add(corner, hn::Set(tag, kLast * (std::max(t.a[k], 0) + std::max(t.b[k], 0))));
            lowest[k] = hn::Add(corner, hn::Set(tag, kLast * (std::min(t.a[k], 0) + std::min(t.b[k], 0))));
        }
        const auto bits = [&](const std::array<Ints, 3>& e) HWY_ATTR {
            return BitsOf(tag, NotNegative(hn::Or3(e[0], e[1], e[2]))) << (v * kPerVector);
        };
        verdicts.touched |= bits(highest);
        verdicts.covered |= bits(lowest);
    }
    return verdicts;
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
    std::uint32_t writeBefore; ///< of these, those that have an owner
};

HWY_INLINE BlockWork DecideBlocks(const TriangleLanes& t, double firstDepth, SquareVerdicts verdicts, const AnyDepth&,
                                  std::size_t, std::uint32_t, TileSamples&, TileDepth&, SquareCorners& corners)
{
    StoreDepths(t, firstDepth, corners);
    return {verdicts.touched, 0};
}

/// Drops the blocks behind what is there, and gives those that the triangle covers wholly and in front of everything
/// to it without looking at their samples.
///
/// exact  bounds are depths at corner samples, which the plane gives exactly; rounding to float32 keeps order
HWY_INLINE BlockWork DecideBlocks(const TriangleLanes& t, double firstDepth, SquareVerdicts verdicts, const UsualDepth&,
                                  std::size_t firstBlock, std::uint32_t number, TileSamples& samples, TileDepth& tile,
                                  SquareCorners& corners)
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
        const Ints nearest = KeyOf(Add(corner, toNearest));
        const Ints farthest = KeyOf(Add(corner, toFarthest));
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
        hn::Store(hn::IfThenElse(hn::RebindMask(unsignedTag, owned), hn::Set(unsignedTag, number), owner), unsignedTag,
                  samples.owner.data() + at);
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

/// A triangle that is large in the tile: subtiles first, then their blocks.
template <class Policy>
HWY_INLINE void CoverSubtiles(const TriangleLanes& lanes, const TileTriangle& t, const Policy& policy,
                              std::uint32_t number, Worker& worker, TileDepth& tile, BlockQueue& queue)
{
    std::uint32_t subtiles = SquaresBetween(t.x0 / 16, t.y0 / 16, t.x1 / 16, t.y1 / 16);
    if (std::popcount(subtiles) > 4) {
        SquareCorners corners;
        subtiles &= JudgeSquares<4>(lanes, ValuesAt(lanes, t, 0, 0).edge, corners).touched;
    }
    for (; subtiles != 0; subtiles &= subtiles - 1) {
        const int subtile = std::countr_zero(subtiles);
        const int x = subtile % 4 * 16;
        const int y = subtile / 4 * 16;
        BlockQueue::Group& group = NextGroup(policy, queue, worker);
        const std::size_t firstBlock = static_cast<std::size_t>(subtile) * 16;
        const SampleValues first = ValuesAt(lanes, t, x, y);
        const SquareVerdicts verdicts = JudgeSquares<2>(lanes, first.edge, group.corners);
        BlockWork work =
            DecideBlocks(lanes, first.depth, verdicts, policy, firstBlock, number, worker.samples, tile, group.corners);
        if (work.writeBefore != 0) {
            WriteBlankBlocks(worker.samples, tile);
            for (; work.writeBefore != 0; work.writeBefore &= work.writeBefore - 1)
                WriteOwnedBlock(firstBlock + static_cast<std::size_t>(std::countr_zero(work.writeBefore)), worker);
        }
        if (work.cover != 0)
            AppendGroup(lanes, number, work.cover, queue, [&](std::size_t lane) HWY_ATTR {
                return PlacesFrom(static_cast<std::uint32_t>(firstBlock), lane);
            });
    }
    if (Policy::kUsual && tile.updates >= kTileBlocks / 4)
        RefreshFarthest(worker.samples, tile);
}

/// The columns and rows of blocks that hold the bounds of a triangle.
struct BlockBounds {
    explicit BlockBounds(const TileTriangle& t)
        : column(t.x0 / kBlockSide), row(t.y0 / kBlockSide), columns(t.x1 / kBlockSide - column + 1),
          rows(t.y1 / kBlockSide - row + 1)
    {
    }
    int column, row, columns, rows;
};

/// blockIndex() of the 4 x 4 blocks from column and row on.
HWY_INLINE Uints BlocksFrom(int column, int row, std::size_t lane)
{
    constexpr UintTag tag;
    const auto along = [](const std::array<std::int32_t, kLanes>& pattern, std::size_t at, int first) HWY_ATTR {
        return hn::BitCast(UintTag(), hn::Add(hn::Load(IntTag(), pattern.data() + at), hn::Set(IntTag(), first)));
    };
    const Uints x = along(kPattern.x, lane, column);
    const Uints y = along(kPattern.y, lane, row);
    const Uints three = hn::Set(tag, 3);
    const Uints inSubtile = hn::Add(hn::ShiftLeft<2>(hn::And(y, three)), hn::And(x, three));
    const Uints subtile = hn::Add(hn::ShiftLeft<2>(hn::ShiftRight<2>(y)), hn::ShiftRight<2>(x));
    return hn::Add(hn::ShiftLeft<4>(subtile), inSubtile);
}

/// A triangle of at most 4 x 4 blocks: those that it touches, without asking what is in front.
template <class Policy>
HWY_INLINE void CoverWindow(const TriangleLanes& lanes, const TileTriangle& t, const BlockBounds& bounds,
                            const Policy& policy, std::uint32_t number, Worker& worker, TileDepth& tile,
                            BlockQueue& queue)
{
    BlockQueue::Group& group = NextGroup(policy, queue, worker);
    StoreDepths(lanes, t.depthOrigin, group.corners);
    const std::uint32_t inBounds = SquaresBetween(0, 0, bounds.columns - 1, bounds.rows - 1);
    const std::uint32_t touched = JudgeSquares<2>(lanes, t.c, group.corners).touched & inBounds;
    tile.nearestSmall = std::min(tile.nearestSmall, std::max(std::bit_cast<std::int32_t>(t.nearest), 0));
    WriteBlankBlocks(worker.samples, tile);
    if (tile.owners)
        for (std::uint32_t bits = touched; bits != 0; bits &= bits - 1) {
            const int square = std::countr_zero(bits);
            const int block = blockIndex(bounds.column + square % kBlockSide, bounds.row + square / kBlockSide);
            WriteOwnedBlock(static_cast<std::size_t>(block), worker);
        }
    AppendGroup(lanes, number, touched, queue,
                [&](std::size_t lane) HWY_ATTR { return BlocksFrom(bounds.column, bounds.row, lane); });
}

template <class Policy>
HWY_INLINE void CoverTriangle(const TileTriangle& t, const Policy& policy, std::uint32_t number, Worker& worker,
                              TileDepth& tile, BlockQueue& queue)
{
    const TriangleLanes lanes = SpreadTriangle(t);
    const BlockBounds bounds(t);
    if (bounds.columns > kBlockSide || bounds.rows > kBlockSide)
        CoverSubtiles(lanes, t, policy, number, worker, tile, queue);
    else
        CoverWindow(lanes, t, bounds, policy, number, worker, tile, queue);
}

template <class Policy>
inline void CoverTileWith(const FrameJob& job, Worker& worker, TileOrigin origin, TileDepth& tile)
{
    constexpr std::size_t kAhead = 8; // triangles
    const Policy policy(job, origin);
    BlockQueue queue;
    for (std::size_t block = 0; block < worker.blocks.size(); ++block) {
        const TileBlock& bin = worker.blocks[block];
        if (block + 1 < worker.blocks.size())
            for (std::size_t i = 0; i < kAhead; ++i)
                __builtin_prefetch(&worker.blocks[block + 1].bin->triangles[i]);
        for (std::uint32_t i = 0; i < bin.count; ++i) {
            const TileTriangle& t = bin.bin->triangles[i];
            __builtin_prefetch(&t + kAhead);
            const std::uint32_t number = static_cast<std::uint32_t>(block) * BinBlock::kCapacity + i;
            if (Policy::kUsual && std::bit_cast<std::int32_t>(t.nearest) >= tile.farthest)
                continue;
            if (HWY_UNLIKELY(t.exact())) {
                FlushQueue(policy, queue, worker);
                WriteOwnedBlocks(worker, tile);
                tile.nearestSmall = 0;
                coverExactly(job, bin.chunk->pieces[t.source & ~kPiece], number, origin, worker);
                continue;
            }
            CoverTriangle(t, policy, number, worker, tile, queue);
        }
    }
    FlushQueue(policy, queue, worker);
}

/// Blocks outside the target are behind everything: they take no time and keep no tile from being full.
inline void HideOffTarget(const FrameJob& job, TileOrigin origin, TileSamples& samples)
{
    const int columns = std::min(job.rules.columns() - origin.x, job.grid.pitch);
    const int rows = std::min(job.rules.rows() - origin.y, job.grid.pitch);
    if (columns == kTileSide && rows == kTileSide)
        return;
    for (int block = 0; block < kTileBlocks; ++block)
        if (blockColumn(block) * kBlockSide >= columns || blockRow(block) * kBlockSide >= rows)
            samples.farthest[static_cast<std::size_t>(block)] = std::numeric_limits<std::int32_t>::min();
}

/// Fills the samples of a tile from the triangles in worker.blocks.
inline void CoverTile(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    const Rules& rules = job.rules;
    TileSamples& samples = worker.samples;
    const std::int32_t clear = std::bit_cast<std::int32_t>(rules.depthClear) ^ depthFlip(rules.depthCompare);
    samples.clearKey = clear;
    samples.farthest.fill(clear);
    samples.nearest.fill(clear);
    samples.owner.fill(kEmpty);
    HideOffTarget(job, origin, samples);
    if (job.countsCoverage())
        samples.coverage.fill(0);
    TileDepth tile{clear, clear};
    const bool usual = rules.depthTested && rules.depthCompare == DepthCompare::Less &&
                       rules.depthFormat == DepthFormat::Float32 && !job.countsCoverage();
    if (usual) {
        CoverTileWith<UsualDepth>(job, worker, origin, tile);
    } else {
        WriteOwnedBlocks(worker, tile);
        CoverTileWith<AnyDepth>(job, worker, origin, tile);
    }
    if (job.depth != nullptr || job.ids != nullptr || rules.shading == Shading::Depth)
        WriteOwnedBlocks(worker, tile);
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
