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
    std::array<std::int32_t, 3> c;
    double origin; ///< of the depth plane, at the target's first sample: from there on all sums are exact
    double perX;
    double perY;
    TileOrigin tile;

    HWY_INLINE std::int32_t EdgeAt(std::size_t k, int x, int y) const { return c[k] + a[k] * x + b[k] * y; }
    HWY_INLINE double DepthAt(int x, int y) const { return origin + perX * (tile.x + x) + perY * (tile.y + y); }
};

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

HWY_INLINE TriangleLanes SpreadTriangle(const TileTriangle& t, TileOrigin origin)
{
    constexpr IntTag tag;
    TriangleLanes lanes;
    lanes.a = {t.a[0], t.a[1], -(t.a[0] + t.a[1])};
    lanes.b = {t.b[0], t.b[1], -(t.b[0] + t.b[1])};
    lanes.c = t.c;
    lanes.perX = t.depthPerX;
    lanes.perY = t.depthPerY;
    lanes.origin = t.depthOrigin;
    lanes.tile = origin;
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

HWY_INLINE Ints StoredKey(const WideDoubles& depth, const UsualDepth&) { return KeyOf(depth); }

/// Lanes of a block that are samples of the target: only those are counted.
HWY_INLINE hn::Mask<IntTag> OnTarget(const AnyDepth& policy, int x, int y, std::size_t lane)
{
    constexpr IntTag tag;
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

/// What a triangle has at the first sample of a block.
struct BlockCorner {
    Ints edge0, edge1, edge2;
    Doubles depth;
};

/// The samples of one block: all of them are computed and those that win are blended in, without a branch.
template <class Policy>
HWY_INLINE void CoverBlock(const TriangleLanes& t, const BlockCorner& corner, const Policy& policy, int x, int y,
                           std::size_t block, std::uint32_t number, Worker& worker)
{
    constexpr IntTag tag;
    constexpr UintTag unsignedTag;
    for (std::size_t v = 0; v < kVectors; ++v) {
        const std::size_t at = block * kLanes + v * kPerVector;
        const Ints sign = hn::Or3(hn::Add(corner.edge0, t.edge[0][v]), hn::Add(corner.edge1, t.edge[1][v]),
                                  hn::Add(corner.edge2, t.edge[2][v]));
        auto inside = NotNegative(sign);
        if constexpr (!Policy::kUsual)
            inside = hn::And(inside, OnTarget(policy, x, y, v * kPerVector));
        const Ints key = StoredKey(Add(t.depth[v], corner.depth), policy);
        std::int32_t* keys = worker.samples.key.data() + at;
        std::uint32_t* ids = worker.samples.ids.data() + at;
        const Ints stored = hn::Load(tag, keys);
        Ints compared = key;
        if constexpr (!Policy::kUsual)
            compared = hn::Sub(key, hn::Set(tag, policy.handicap));
        const auto passed = hn::And(inside, hn::Lt(compared, stored));
        hn::Store(hn::IfThenElse(passed, key, stored), tag, keys);
        hn::Store(hn::IfThenElse(hn::RebindMask(unsignedTag, passed), hn::Set(unsignedTag, number),
                                 hn::Load(unsignedTag, ids)),
                  unsignedTag, ids);
        if constexpr (!Policy::kUsual)
            CountSamples(policy, inside, passed, at, worker);
    }
}

/// Writes the keys and ids of a block that nobody or one triangle has to itself.
inline void WriteOwnedBlock(std::size_t block, TileOrigin origin, Worker& worker)
{
    TileSamples& samples = worker.samples;
    const std::uint32_t number = samples.owner[block];
    samples.owner[block] = kNobody;
    if (number == kEmpty) {
        std::fill_n(samples.key.begin() + std::ptrdiff_t(block) * kLanes, kLanes, samples.clearKey);
        std::fill_n(samples.ids.begin() + std::ptrdiff_t(block) * kLanes, kLanes, kNobody);
        return;
    }
    const TileTriangle& t = worker.triangle(number);
    const int x = origin.x + blockColumn(static_cast<int>(block)) * kBlockSide;
    const int y = origin.y + blockRow(static_cast<int>(block)) * kBlockSide;
    const Doubles corner = hn::Set(DoubleTag(), t.depthOrigin + t.depthPerX * x + t.depthPerY * y);
    for (std::size_t v = 0; v < kVectors; ++v) {
        const std::size_t at = block * kLanes + v * kPerVector;
        const WideDoubles offsets = DepthOffsets(t.depthPerX, t.depthPerY, v * kPerVector);
        hn::Store(KeyOf(Add(offsets, corner)), IntTag(), samples.key.data() + at);
        hn::Store(hn::Set(UintTag(), number), UintTag(), samples.ids.data() + at);
    }
}

inline void WriteOwnedBlocks(TileOrigin origin, Worker& worker)
{
    for (std::size_t block = 0; block < kTileBlocks; ++block)
        if (worker.samples.owner[block] != kNobody)
            WriteOwnedBlock(block, origin, worker);
}

/// A triangle at the first samples of 16 squares, 4 x 4 of them.
struct alignas(64) SquareCorners {
    std::array<std::array<std::int32_t, kLanes>, 3> edge;
    std::array<double, kLanes> depth;
};

/// Which of the 16 squares of 2^kSideLog2 samples from (x, y) on the triangle touches and covers, a bit each.
struct SquareVerdicts {
    std::uint32_t touched = 0;
    std::uint32_t covered = 0;
};

template <int kSideLog2>
HWY_INLINE SquareVerdicts JudgeSquares(const TriangleLanes& t, int x, int y, SquareCorners& corners)
{
    constexpr IntTag tag;
    constexpr int kLast = (1 << kSideLog2) - 1;
    SquareVerdicts verdicts;
    for (std::size_t v = 0; v < kVectors; ++v) {
        std::array<Ints, 3> highest;
        std::array<Ints, 3> lowest;
        for (std::size_t k = 0; k < 3; ++k) {
            const Ints corner = hn::Add(hn::Set(tag, t.EdgeAt(k, x, y)), hn::ShiftLeft<kSideLog2>(t.edge[k][v]));
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

/// The state of a tile between its triangles.
struct TileDepth {
    std::int32_t farthest; ///< a key no sample of the tile is farther than
    int updates = 0;       ///< blocks that came nearer since
};

inline void RefreshFarthest(const TileSamples& samples, TileDepth& tile)
{
    constexpr IntTag tag;
    Ints farthest = hn::Zero(tag);
    for (std::size_t i = 0; i < kTileBlocks; i += kPerVector)
        farthest = hn::Max(farthest, hn::Load(tag, samples.farthest.data() + i));
    tile.farthest = hn::GetLane(hn::MaxOfLanes(tag, farthest));
    tile.updates = 0;
}

/// What is to be done about the blocks of a subtile, a bit each.
struct BlockWork {
    std::uint32_t cover;       ///< sample by sample
    std::uint32_t writeBefore; ///< of these, those that have an owner
};

HWY_INLINE BlockWork DecideBlocks(const TriangleLanes& t, int x, int y, SquareVerdicts verdicts, const AnyDepth&,
                                  std::size_t, std::uint32_t, TileSamples&, TileDepth&, SquareCorners& corners)
{
    for (std::size_t v = 0; v < kVectors; ++v)
        Store(Add(Mul(t.depth[v], hn::Set(DoubleTag(), double(kBlockSide))), hn::Set(DoubleTag(), t.DepthAt(x, y))),
              corners.depth.data() + v * kPerVector);
    return {verdicts.touched, 0};
}

/// Drops the blocks behind what is there, and gives those that the triangle covers wholly and in front of everything
/// to it without looking at their samples.
///
/// exact  bounds are depths at corner samples, which the plane gives exactly; rounding to float32 keeps order
HWY_INLINE BlockWork DecideBlocks(const TriangleLanes& t, int x, int y, SquareVerdicts verdicts, const UsualDepth&,
                                  std::size_t firstBlock, std::uint32_t number, TileSamples& samples, TileDepth& tile,
                                  SquareCorners& corners)
{
    constexpr IntTag tag;
    constexpr UintTag unsignedTag;
    constexpr DoubleTag wide;
    const Doubles first = hn::Set(wide, t.DepthAt(x, y));
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
        const Ints nearestThere = hn::Load(tag, samples.nearest.data() + at);
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
    }
    return work;
}

/// A triangle that is large in the tile: subtiles first, then their blocks.
template <class Policy>
HWY_INLINE void CoverSubtiles(const TriangleLanes& t, const TileTriangle& bounds, const Policy& policy,
                              std::uint32_t number, Worker& worker, TileDepth& tile)
{
    constexpr IntTag tag;
    SquareCorners corners;
    std::uint32_t subtiles = JudgeSquares<4>(t, 0, 0, corners).touched;
    for (; subtiles != 0; subtiles &= subtiles - 1) {
        const int subtile = std::countr_zero(subtiles);
        const int x = subtile % 4 * 16;
        const int y = subtile / 4 * 16;
        if (x > bounds.x1 || x + 15 < bounds.x0 || y > bounds.y1 || y + 15 < bounds.y0)
            continue;
        const std::size_t firstBlock = static_cast<std::size_t>(subtile) * 16;
        const SquareVerdicts verdicts = JudgeSquares<2>(t, x, y, corners);
        BlockWork work = DecideBlocks(t, x, y, verdicts, policy, firstBlock, number, worker.samples, tile, corners);
        for (; work.writeBefore != 0; work.writeBefore &= work.writeBefore - 1)
            WriteOwnedBlock(firstBlock + static_cast<std::size_t>(std::countr_zero(work.writeBefore)), t.tile, worker);
        for (; work.cover != 0; work.cover &= work.cover - 1) {
            const auto block = static_cast<std::size_t>(std::countr_zero(work.cover));
            const BlockCorner corner{hn::Set(tag, corners.edge[0][block]), hn::Set(tag, corners.edge[1][block]),
                                     hn::Set(tag, corners.edge[2][block]), hn::Set(DoubleTag(), corners.depth[block])};
            CoverBlock(t, corner, policy, x + static_cast<int>(block % 4) * kBlockSide,
                       y + static_cast<int>(block / 4) * kBlockSide, firstBlock + block, number, worker);
        }
    }
    if (Policy::kUsual && tile.updates >= kTileBlocks / 4)
        RefreshFarthest(worker.samples, tile);
}

/// A block of a triangle that is small.
template <class Policy>
HWY_INLINE void CoverLoneBlock(const TriangleLanes& t, std::int32_t nearest, const Policy& policy, int column, int row,
                               std::uint32_t number, Worker& worker)
{
    constexpr IntTag tag;
    const auto block = static_cast<std::size_t>(blockIndex(column, row));
    const int x = column * kBlockSide;
    const int y = row * kBlockSide;
    TileSamples& samples = worker.samples;
    if (Policy::kUsual) {
        if (HWY_UNLIKELY(samples.owner[block] != kNobody))
            WriteOwnedBlock(block, t.tile, worker);
        samples.nearest[block] = std::min(samples.nearest[block], nearest);
    }
    const BlockCorner corner{hn::Set(tag, t.EdgeAt(0, x, y)), hn::Set(tag, t.EdgeAt(1, x, y)),
                             hn::Set(tag, t.EdgeAt(2, x, y)), hn::Set(DoubleTag(), t.DepthAt(x, y))};
    CoverBlock(t, corner, policy, x, y, block, number, worker);
}

template <class Policy>
HWY_INLINE void CoverTriangle(const TileTriangle& t, const Policy& policy, TileOrigin origin, std::uint32_t number,
                              Worker& worker, TileDepth& tile)
{
    const TriangleLanes lanes = SpreadTriangle(t, origin);
    const int column0 = t.x0 / kBlockSide;
    const int column1 = t.x1 / kBlockSide;
    const int row0 = t.y0 / kBlockSide;
    const int row1 = t.y1 / kBlockSide;
    if ((column1 - column0) + (row1 - row0) > 3) {
        CoverSubtiles(lanes, t, policy, number, worker, tile);
        return;
    }
    const auto nearest = std::max(std::bit_cast<std::int32_t>(t.nearest), 0);
    for (int row = row0; row <= row1; ++row)
        for (int column = column0; column <= column1; ++column)
            CoverLoneBlock(lanes, nearest, policy, column, row, number, worker);
}

template <class Policy>
inline void CoverTileWith(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    constexpr std::size_t kAhead = 8; // triangles
    const Policy policy(job, origin);
    TileSamples& samples = worker.samples;
    TileDepth tile{std::bit_cast<std::int32_t>(job.rules.depthClear)};
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
                WriteOwnedBlocks(origin, worker);
                samples.nearest.fill(0);
                coverExactly(job, bin.chunk->pieces[t.source & ~kPiece], number, origin, worker);
                continue;
            }
            CoverTriangle(t, policy, origin, number, worker, tile);
        }
    }
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
    const bool usual = rules.depthTested && rules.depthCompare == DepthCompare::Less &&
                       rules.depthFormat == DepthFormat::Float32 && !job.countsCoverage();
    if (usual) {
        CoverTileWith<UsualDepth>(job, worker, origin);
    } else {
        WriteOwnedBlocks(origin, worker);
        CoverTileWith<AnyDepth>(job, worker, origin);
    }
    if (job.depth != nullptr || job.ids != nullptr || rules.shading == Shading::Depth)
        WriteOwnedBlocks(origin, worker);
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
