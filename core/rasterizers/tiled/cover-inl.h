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
        const auto pattern = [&](const auto& lanes)
                                 HWY_ATTR { return hn::PromoteTo(tag, hn::LoadU(HalfIntTag(), lanes.data() + at)); };
        offsets.part[p] =
            hn::Add(hn::Mul(pattern(kPattern.x), hn::Set(tag, perX)), hn::Mul(pattern(kPattern.y), hn::Set(tag, perY)));
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

/// The samples of one block: all of them are computed and those that win are blended in, without a branch.
template <class Policy>
HWY_INLINE void CoverBlock(const TriangleLanes& t, const Policy& policy, int x, int y, std::size_t block,
                           std::uint32_t number, Worker& worker)
{
    constexpr IntTag tag;
    constexpr UintTag unsignedTag;
    constexpr DoubleTag wide;
    const std::array<Ints, 3> base{hn::Set(tag, t.EdgeAt(0, x, y)), hn::Set(tag, t.EdgeAt(1, x, y)),
                                   hn::Set(tag, t.EdgeAt(2, x, y))};
    const Doubles depth = hn::Set(wide, t.DepthAt(x, y));
    for (std::size_t v = 0; v < kVectors; ++v) {
        const std::size_t at = block * kLanes + v * kPerVector;
        const Ints sign =
            hn::Or3(hn::Add(base[0], t.edge[0][v]), hn::Add(base[1], t.edge[1][v]), hn::Add(base[2], t.edge[2][v]));
        auto inside = NotNegative(sign);
        if constexpr (!Policy::kUsual)
            inside = hn::And(inside, OnTarget(policy, x, y, v * kPerVector));
        const Ints key = StoredKey(Add(t.depth[v], depth), policy);
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

/// Which of the 16 squares of `side` samples, 4 x 4 of them from (x, y) on, the triangle touches and covers.
struct SquareVerdicts {
    std::uint32_t touched;
    std::uint32_t covered;
};

template <int kSideLog2>
HWY_INLINE SquareVerdicts JudgeSquares(const TriangleLanes& t, int x, int y)
{
    constexpr IntTag tag;
    constexpr int kLast = (1 << kSideLog2) - 1;
    SquareVerdicts verdicts{0, 0};
    std::array<std::int32_t, 3> highest;
    std::array<std::int32_t, 3> lowest;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t base = t.EdgeAt(k, x, y);
        highest[k] = base + kLast * (std::max(t.a[k], 0) + std::max(t.b[k], 0));
        lowest[k] = base + kLast * (std::min(t.a[k], 0) + std::min(t.b[k], 0));
    }
    for (std::size_t v = 0; v < kVectors; ++v) {
        const auto signOf = [&](const std::array<std::int32_t, 3>& base) HWY_ATTR {
            const auto value = [&](std::size_t k) HWY_ATTR {
                return hn::Add(hn::Set(tag, base[k]), hn::ShiftLeft<kSideLog2>(t.edge[k][v]));
            };
            return hn::Or3(value(0), value(1), value(2));
        };
        const auto bits = [&](Ints sign) HWY_ATTR { return BitsOf(tag, NotNegative(sign)) << (v * kPerVector); };
        verdicts.touched |= bits(signOf(highest));
        verdicts.covered |= bits(signOf(lowest));
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

/// Drops blocks of a subtile behind what is there, and brings nearer the bound of those that are covered wholly.
///
/// exact  bounds are depths at corner samples, which the plane gives exactly; rounding to float32 keeps order
HWY_INLINE std::uint32_t RejectHidden(const TriangleLanes& t, int x, int y, std::size_t firstBlock,
                                      SquareVerdicts verdicts, TileSamples& samples, TileDepth& tile)
{
    constexpr IntTag tag;
    constexpr DoubleTag wide;
    const double base = t.DepthAt(x, y);
    const Doubles nearest = hn::Set(wide, base + 3 * (std::min(t.perX, 0.0) + std::min(t.perY, 0.0)));
    const Doubles farthest = hn::Set(wide, base + 3 * (std::max(t.perX, 0.0) + std::max(t.perY, 0.0)));
    std::uint32_t shown = 0;
    for (std::size_t v = 0; v < kVectors; ++v) {
        WideDoubles offsets;
        for (std::size_t p = 0; p < kParts; ++p)
            offsets.part[p] = hn::Mul(t.depth[v].part[p], hn::Set(wide, double(kBlockSide)));
        std::int32_t* bounds = samples.farthest.data() + firstBlock + v * kPerVector;
        const Ints bound = hn::Load(tag, bounds);
        const std::uint32_t visible = BitsOf(tag, hn::Lt(KeyOf(Add(offsets, nearest)), bound)) << (v * kPerVector);
        shown |= visible;
        const std::uint32_t nearer = verdicts.covered & visible;
        if (nearer == 0)
            continue;
        std::array<std::uint8_t, 8> bytes{static_cast<std::uint8_t>(nearer >> (v * kPerVector)),
                                          static_cast<std::uint8_t>(nearer >> (v * kPerVector) >> 8)};
        const auto update = hn::LoadMaskBits(tag, bytes.data());
        const Ints closer = hn::Min(bound, KeyOf(Add(offsets, farthest)));
        hn::Store(hn::IfThenElse(update, closer, bound), tag, bounds);
    }
    tile.updates += std::popcount(verdicts.covered & shown);
    return verdicts.touched & shown;
}

/// A triangle that is large in the tile: subtiles first, then their blocks.
template <class Policy>
HWY_INLINE void CoverSubtiles(const TriangleLanes& t, const TileTriangle& bounds, const Policy& policy,
                              std::uint32_t number, Worker& worker, TileDepth& tile)
{
    std::uint32_t subtiles = JudgeSquares<4>(t, 0, 0).touched;
    for (; subtiles != 0; subtiles &= subtiles - 1) {
        const int subtile = std::countr_zero(subtiles);
        const int x = subtile % 4 * 16;
        const int y = subtile / 4 * 16;
        if (x > bounds.x1 || x + 15 < bounds.x0 || y > bounds.y1 || y + 15 < bounds.y0)
            continue;
        const SquareVerdicts verdicts = JudgeSquares<2>(t, x, y);
        std::uint32_t blocks = verdicts.touched;
        if constexpr (Policy::kUsual)
            blocks = RejectHidden(t, x, y, static_cast<std::size_t>(subtile) * 16, verdicts, worker.samples, tile);
        for (; blocks != 0; blocks &= blocks - 1) {
            const int block = std::countr_zero(blocks);
            CoverBlock(t, policy, x + block % 4 * kBlockSide, y + block / 4 * kBlockSide,
                       static_cast<std::size_t>(subtile * 16 + block), number, worker);
        }
    }
    if (Policy::kUsual && tile.updates >= kTileBlocks / 4)
        RefreshFarthest(worker.samples, tile);
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
    for (int row = row0; row <= row1; ++row)
        for (int column = column0; column <= column1; ++column)
            CoverBlock(lanes, policy, column * kBlockSide, row * kBlockSide,
                       static_cast<std::size_t>(blockIndex(column, row)), number, worker);
}

template <class Policy>
inline void CoverTileWith(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    const Policy policy(job, origin);
    TileSamples& samples = worker.samples;
    TileDepth tile{samples.farthest[0]};
    for (std::size_t block = 0; block < worker.blocks.size(); ++block) {
        const BinBlock& bin = *worker.blocks[block];
        for (std::uint32_t i = 0; i < bin.count; ++i) {
            const TileTriangle& t = bin.triangles[i];
            const std::uint32_t number = static_cast<std::uint32_t>(block) * (BinBlock::kCapacity + 1) + i;
            if (Policy::kUsual && std::bit_cast<std::int32_t>(t.nearest) >= tile.farthest)
                continue;
            if ((t.source & kPiece) != 0) {
                const Piece& piece = worker.blockChunk[block]->pieces[t.source & ~kPiece];
                if (piece.exact) {
                    coverExactly(job, piece, number, origin, worker);
                    continue;
                }
            }
            CoverTriangle(t, policy, origin, number, worker, tile);
        }
    }
}

/// Fills the samples of a tile from the triangles in worker.blocks.
inline void CoverTile(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    const Rules& rules = job.rules;
    TileSamples& samples = worker.samples;
    const std::int32_t clear = std::bit_cast<std::int32_t>(rules.depthClear) ^ depthFlip(rules.depthCompare);
    samples.key.fill(clear);
    samples.ids.fill(kNobody);
    samples.farthest.fill(clear);
    if (job.countsCoverage())
        samples.coverage.fill(0);
    const bool usual = rules.depthTested && rules.depthCompare == DepthCompare::Less &&
                       rules.depthFormat == DepthFormat::Float32 && !job.countsCoverage();
    if (usual)
        CoverTileWith<UsualDepth>(job, worker, origin);
    else
        CoverTileWith<AnyDepth>(job, worker, origin);
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
