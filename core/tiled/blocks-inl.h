// Blocks of samples: which of them a triangle covers, and the depth test. Included once for each target: see README.md.
#if defined(RASTERLENS_TILED_BLOCKS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_BLOCKS_INL_H
#undef RASTERLENS_TILED_BLOCKS_INL_H
#else
#define RASTERLENS_TILED_BLOCKS_INL_H
#endif

#include "core/pipeline/depth_test.h"
#include "core/tiled/exact_path.h"
#include "core/tiled/frame_job.h"
#include "core/tiled/gouraud-inl.h"
#include "core/tiled/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

HWY_INLINE hn::Mask<IntTag> NotNegative(Ints v) { return hn::Gt(v, hn::Set(IntTag(), -1)); }

constexpr std::int32_t kKeyOfOne = 0x3f800000; ///< the bits of 1.0F

/// What a sample keeps of the triangle that won it, beside its depth.
enum class Keeps {
    Number, ///< the number of the triangle
    Color,  ///< its interpolated colour: computing it at once is less work than coming back with the number
    Nothing ///< where only depth is asked for
};

/// The usual case knows its depth test when it is compiled; every other one reads it from here.
template <Keeps kKeep, bool kHasPattern>
struct UsualDepth {
    static constexpr bool kUsual = true; ///< float32 depths, the smaller one wins, samples are not counted
    static constexpr Keeps kKeeps = kKeep;
    static constexpr bool kPattern = kHasPattern; ///< multi-sampling
    UsualDepth(const FrameJob& j, TileOrigin o) : job(j), origin(o) {}
    const FrameJob& job;
    TileOrigin origin;
};

template <bool kHasPattern>
struct AnyDepth {
    static constexpr bool kUsual = false;
    static constexpr Keeps kKeeps = Keeps::Number;
    static constexpr bool kPattern = kHasPattern;
    AnyDepth(const FrameJob& j, TileOrigin o)
        : job(j), origin(o), store(job.rules), countsCoverage(job.countsCoverage()),
          width(job.rules.columns() - origin.x), height(job.rules.rows() - origin.y)
    {
    }
    const FrameJob& job;
    TileOrigin origin;
    DepthStore store;
    bool countsCoverage;
    int width; ///< samples of the tile that belong to the target
    int height;
};

/// Multi-sampling: what changes from the centre of a pixel to its samples, one after the other.
struct alignas(64) PatternLanes {
    std::array<std::array<std::int32_t, kLanes>, 3> edge;
    std::array<double, kLanes> depth;
};

/// Where the samples of a block are stored, and how many sets of 16 there are.
template <class Policy>
HWY_INLINE std::size_t SetsOf(const Policy& policy)
{
    if constexpr (Policy::kPattern)
        return policy.job.pattern.samples;
    else
        return 1;
}
template <class Policy>
HWY_INLINE std::int32_t* KeysOf(const Policy& policy, Worker& worker, std::size_t block)
{
    std::int32_t* keys = Policy::kPattern ? worker.pattern.key.data() : worker.samples.key.data();
    return keys + block * SetsOf(policy) * kLanes;
}
template <class Policy>
HWY_INLINE std::uint32_t* NumbersOf(const Policy& policy, Worker& worker, std::size_t block)
{
    std::uint32_t* ids = Policy::kPattern ? worker.pattern.ids.data() : worker.samples.ids.data();
    return ids + block * SetsOf(policy) * kLanes;
}
template <class Policy>
HWY_INLINE std::uint32_t* SampleColorsOf(const Policy& policy, Worker& worker, std::size_t block)
{
    std::uint32_t* colors = Policy::kPattern ? worker.pattern.color.data() : worker.samples.color.data();
    return colors + block * SetsOf(policy) * kLanes;
}

/// A triangle spread over the lanes: what changes from the first sample of a block (or first block of a subtile...) to
/// the others.
struct TriangleLanes {
    std::array<std::array<Ints, kVectors>, 3> edge;
    std::array<Ints, 3> toHighest; ///< from the first sample of a block to the highest edge value in it, in all lanes
    std::array<WideDoubles, kVectors> depth;
    std::array<std::int32_t, 3> a;
    std::array<std::int32_t, 3> b;
    std::array<std::int32_t, 3> reach; ///< multi-sampling: no sample's edge values differ more from the pixel's
    PatternLanes pattern;              ///< multi-sampling only
    double depthReach;                 ///< multi-sampling: no sample's depth differs more from the pixel's
    double perX;
    double perY;
    std::uint32_t number;    ///< in the tile
    PassingDifferences test; ///< AnyDepth only
    const ColorPlanes* planes;
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

/// Multi-sampling: what a triangle changes by from the centre of a pixel to its samples.
///
/// exact  edge values shifted right by 8 have the sign of the whole ones; the 4 bits that the record has beside c are
///        those that sixteenths of a pixel can carry out of
HWY_INLINE void SpreadPattern(const PixelPattern& pattern, const TileTriangle& t, TriangleLanes& lanes)
{
    constexpr IntTag tag;
    constexpr std::int32_t kRest = 15;
    const auto& g = t.gradients;
    lanes.a = {g[0] >> 4, g[1] >> 4, -((g[0] >> 4) + (g[1] >> 4))};
    lanes.b = {g[2] >> 4, g[3] >> 4, -((g[2] >> 4) + (g[3] >> 4))};
    const std::array<std::int32_t, 3> rest{g[0] & kRest, g[1] & kRest, g[2] & kRest};
    for (std::size_t k = 0; k < 3; ++k) {
        lanes.reach[k] = ((std::abs(lanes.a[k]) + std::abs(lanes.b[k])) * pattern.reach + kRest) >> 4;
        for (std::size_t at = 0; at < kLanes; at += kPerVector) {
            const Ints alongX = hn::Mul(hn::Load(tag, pattern.x.data() + at), hn::Set(tag, lanes.a[k]));
            const Ints alongY = hn::Mul(hn::Load(tag, pattern.y.data() + at), hn::Set(tag, lanes.b[k]));
            const Ints sixteenths = hn::Add(hn::Set(tag, rest[k]), hn::Add(alongX, alongY));
            hn::Store(hn::ShiftRight<4>(sixteenths), tag, lanes.pattern.edge[k].data() + at);
        }
    }
    lanes.depthReach = pattern.depthReach(t.depthPerX, t.depthPerY);
    for (std::size_t at = 0; at < kLanes; at += kDoubles)
        hn::Store(
            hn::Add(hn::Mul(hn::Load(DoubleTag(), pattern.offsetX.data() + at), hn::Set(DoubleTag(), t.depthPerX)),
                    hn::Mul(hn::Load(DoubleTag(), pattern.offsetY.data() + at), hn::Set(DoubleTag(), t.depthPerY))),
            DoubleTag(), lanes.pattern.depth.data() + at);
}

/// Edges of a triangle with gradients of 16 bits.
HWY_INLINE void SpreadNarrowEdges(const TileTriangle& t, TriangleLanes& lanes)
{
    constexpr IntTag tag;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t pair = t.gradients[k];
        const Ints pairs = hn::Set(tag, pair);
        lanes.a[k] = static_cast<std::int16_t>(pair);
        lanes.b[k] = pair >> 16;
        lanes.toHighest[k] = PairProducts(PositiveHalves(pairs), hn::Set(tag, 0x10001 * (kBlockSide - 1)));
        for (std::size_t v = 0; v < kVectors; ++v)
            lanes.edge[k][v] = PairProducts(pairs, hn::Load(tag, kPattern.xy.data() + v * kPerVector));
    }
}

/// Edges of a triangle whose gradients stand in `lanes` already.
HWY_INLINE void SpreadWideEdges(TriangleLanes& lanes)
{
    constexpr IntTag tag;
    for (std::size_t k = 0; k < 3; ++k)
        lanes.toHighest[k] =
            hn::Set(tag, (kBlockSide - 1) * (std::max(lanes.a[k], 0) + std::max(lanes.b[k], 0)) + lanes.reach[k]);
    for (std::size_t v = 0; v < kVectors; ++v) {
        const Ints x = hn::Load(tag, kPattern.x.data() + v * kPerVector);
        const Ints y = hn::Load(tag, kPattern.y.data() + v * kPerVector);
        for (std::size_t k = 0; k < 2; ++k)
            lanes.edge[k][v] = hn::Add(hn::Mul(x, hn::Set(tag, lanes.a[k])), hn::Mul(y, hn::Set(tag, lanes.b[k])));
        lanes.edge[2][v] = hn::Neg(hn::Add(lanes.edge[0][v], lanes.edge[1][v]));
    }
}

template <class Policy>
HWY_INLINE TriangleLanes SpreadTriangle(const Policy& policy, const TileTriangle& t, const ColorPlanes& planes,
                                        std::uint32_t number, const Worker& worker)
{
    TriangleLanes lanes;
    lanes.number = number;
    if constexpr (!Policy::kUsual)
        lanes.test = passingDifferences(policy.job.rules, faceOf(worker.chunkOf(number), t.source));
    lanes.planes = &planes;
    if constexpr (Policy::kPattern) {
        SpreadPattern(policy.job.pattern, t, lanes);
        SpreadWideEdges(lanes);
    } else if (HWY_LIKELY(t.isNarrow())) {
        SpreadNarrowEdges(t, lanes);
    } else {
        const auto& g = t.gradients;
        lanes.a = {g[0], g[1], -(g[0] + g[1])};
        lanes.b = {g[2], g[3], -(g[2] + g[3])};
        lanes.reach = {};
        SpreadWideEdges(lanes);
    }
    lanes.perX = t.depthPerX;
    lanes.perY = t.depthPerY;
    for (std::size_t v = 0; v < kVectors; ++v)
        lanes.depth[v] = DepthOffsets(t.depthPerX, t.depthPerY, v * kPerVector);
    return lanes;
}

/// Depths as stored, 0 to 1, as their bits.
HWY_INLINE Ints KeyOf(const WideDoubles& depth)
{
    constexpr IntTag tag;
    const Ints bits = hn::BitCast(tag, ToFloats(depth));
    return hn::Min(hn::Max(bits, hn::Zero(tag)), hn::Set(tag, kKeyOfOne));
}

/// storedDepth(), operation by operation: in double, for a format of so many steps.
HWY_INLINE WideDoubles RoundToUnorm(const WideDoubles& depth, const DepthStore& store, double steps)
{
    constexpr DoubleTag tag;
    WideDoubles rounded;
    for (std::size_t p = 0; p < kParts; ++p) {
        const Doubles held = hn::Min(hn::Max(depth.part[p], hn::Set(tag, store.low)), hn::Set(tag, store.high));
        rounded.part[p] = hn::Div(hn::Round(hn::Mul(held, hn::Set(tag, steps))), hn::Set(tag, steps));
    }
    return rounded;
}

template <bool kPattern>
HWY_INLINE Ints StoredKey(const WideDoubles& depth, const AnyDepth<kPattern>& policy)
{
    constexpr IntTag tag;
    const DepthStore& store = policy.store;
    if (const int largest = largestDepthCode(store.format); largest > 0)
        return KeyOf(RoundToUnorm(depth, store, largest));
    // Rounding to float32 keeps order: what is held afterwards is what is held before.
    const Ints low = hn::Set(tag, depthKey(static_cast<float>(store.low)));
    const Ints high = hn::Set(tag, depthKey(static_cast<float>(store.high)));
    return hn::Min(hn::Max(KeyOf(depth), low), high);
}

/// The key of a depth in the usual depth test. Depths beyond 1 need not be clamped: they lose against every stored one.
template <Keeps kKeep, bool kPattern>
HWY_INLINE Ints StoredKey(const WideDoubles& depth, const UsualDepth<kKeep, kPattern>&)
{
    constexpr IntTag tag;
    return hn::Max(hn::BitCast(tag, ToFloats(depth)), hn::Zero(tag));
}

/// Lanes of a block that are samples of the target: only those are counted.
template <class Policy>
HWY_INLINE hn::Mask<IntTag> OnTarget(const Policy& policy, std::size_t block, std::size_t lane)
{
    constexpr IntTag tag;
    const int x = blockColumn(static_cast<int>(block)) * kBlockSide;
    const int y = blockRow(static_cast<int>(block)) * kBlockSide;
    return hn::And(hn::Lt(hn::Load(tag, kPattern.x.data() + lane), hn::Set(tag, policy.width - x)),
                   hn::Lt(hn::Load(tag, kPattern.y.data() + lane), hn::Set(tag, policy.height - y)));
}

///
/// in   where the samples are stored
template <class Policy, class Mask>
HWY_INLINE void CountSamples(const Policy& policy, Mask inside, Mask passed, std::size_t at, Worker& worker)
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
    std::uint16_t* counts = Policy::kPattern ? worker.pattern.coverage.data() : worker.samples.coverage.data();
    for (; covered != 0; covered &= covered - 1) {
        std::uint16_t& count = counts[at + static_cast<std::size_t>(std::countr_zero(covered))];
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

    /// Up to 16 blocks of one triangle. The size is a power of two: places of groups take a shift to find.
    struct alignas(1024) Group {
        SquareCorners corners;
        SquareCorners offsets; ///< from the first sample of a block to the others
        ColorSquares colors;
        std::uint32_t number;
        PassingDifferences test; ///< AnyDepth only
    };
    static_assert(sizeof(Group) == 1024);
    /// Multi-sampling: what groups have beside that.
    struct alignas(64) PatternGroup {
        PatternLanes lanes;
        HeldSquares held; ///< ColorWay::Affine
    };
    std::array<Group, kGroups> groups;
    std::array<PatternGroup, kGroups> patterns;
    /// Block of the tile, group, place in its 16: a byte each from the top. Whole vectors are written at the end.
    std::array<std::uint32_t, (kGroups + 1) * kLanes> items;
    std::size_t groupCount = 0;
    std::size_t itemCount = 0;
    bool affine = true; ///< all colours of the groups are ColorWay::Affine
};

/// The depth test of a vector of samples.
///
/// in   the keys of a triangle, and what is stored so far; test: of AnyDepth
/// out  which samples it wins; their keys are stored
template <class Policy>
HWY_INLINE hn::Mask<IntTag> TestDepth(const Policy&, hn::Mask<IntTag> inside, Ints key, Ints stored,
                                      const PassingDifferences& test, std::int32_t* keys)
{
    constexpr IntTag tag;
    if constexpr (Policy::kUsual) {
        // Outside a key that never wins: so the next triangle in the same block waits for a minimum and nothing else.
        const Ints covered = hn::IfThenElse(inside, key, hn::Set(tag, std::numeric_limits<std::int32_t>::max()));
        hn::Store(hn::Min(covered, stored), tag, keys);
        return hn::Lt(covered, stored);
    } else {
        const Ints moved = hn::Sub(hn::Sub(key, stored), hn::Set(tag, test.offset));
        const auto passed = hn::AndNot(hn::Gt(moved, hn::Set(tag, test.largest)), inside);
        hn::Store(hn::IfThenElse(passed, key, stored), tag, keys);
        return passed;
    }
}

/// Interpolated colours of samples in the scalar way, a bit each.
inline void ColorExactly(const FrameJob& job, TileOrigin origin, std::uint32_t number, std::size_t block,
                         std::uint32_t lanes, Worker& worker)
{
    shadeExactly(job, {number, worker.triangle(number).source, &worker.chunkOf(number), nullptr, {}},
                 {static_cast<std::uint16_t>(block), static_cast<std::uint16_t>(lanes), 0}, origin, worker.samples);
}

/// The samples of one block: all of them are computed and those that win are blended in, without a branch.
///
/// in   kAffine: all interpolated colours are ColorWay::Affine
template <bool kAffine, class Policy>
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
        const Ints stored = hn::Load(tag, keys);
        const auto passed = TestDepth(policy, inside, key, stored, group.test, keys);
        const auto won = hn::RebindMask(unsignedTag, passed);
        if constexpr (Policy::kKeeps == Keeps::Color) {
            std::uint32_t* colors = worker.samples.color.data() + at;
            if constexpr (kAffine) {
                StoreWhere(group.colors.affineColor(square, lane), won, colors);
            } else if (group.colors.planes->way != ColorWay::Exact) {
                StoreWhere(group.colors.color(square, lane), won, colors);
            } else {
                ColorExactly(policy.job, policy.origin, group.number, block, BitsOf(tag, passed) << lane, worker);
            }
        } else if constexpr (Policy::kKeeps == Keeps::Number) {
            std::uint32_t* ids = worker.samples.ids.data() + at;
            StoreWhere(hn::Set(unsignedTag, group.number), won, ids);
        }
        if constexpr (!Policy::kUsual)
            CountSamples(policy, inside, passed, at, worker);
    }
}

/// Multi-sampling: the colours of a block at the centres of pixels, whether the triangle covers them or not.
template <class Policy>
HWY_INLINE Uints CentreColors(const Policy& policy, const BlockQueue::Group& group, const HeldSquares& held,
                              std::size_t square, std::size_t block, std::size_t lane, Worker& worker)
{
    const ColorSquares& colors = group.colors;
    if (HWY_LIKELY(colors.planes->way == ColorWay::Affine))
        return held.held(square, lane);
    if (colors.planes->way == ColorWay::Perspective) {
        const auto at = static_cast<int>(square);
        return PerspectiveColor(*colors.planes, colors.x + at % 4 * kBlockSide, colors.y + at / 4 * kBlockSide, lane);
    }
    if (lane == 0)
        ColorExactly(policy.job, policy.origin, group.number, block, 0xffff, worker);
    return hn::Load(UintTag(), worker.samples.color.data() + block * kLanes + lane);
}

/// Multi-sampling: the samples of one block, those of 16 pixels at a time.
template <class Policy>
HWY_INLINE void CoverPatternBlock(const BlockQueue::Group& group, const BlockQueue::PatternGroup& pattern,
                                  std::size_t square, std::size_t block, const Policy& policy, Worker& worker)
{
    constexpr IntTag tag;
    constexpr UintTag unsignedTag;
    const std::size_t sets = SetsOf(policy);
    for (std::size_t v = 0; v < kVectors; ++v) {
        const std::size_t lane = v * kPerVector;
        std::array<Ints, 3> edge;
        for (std::size_t k = 0; k < 3; ++k)
            edge[k] = hn::Add(hn::Set(tag, group.corners.edge[k][square]),
                              hn::Load(tag, group.offsets.edge[k].data() + lane));
        const WideDoubles depth =
            Add(LoadWide(group.offsets.depth.data() + lane), hn::Set(DoubleTag(), group.corners.depth[square]));
        Uints color = hn::Zero(unsignedTag);
        if constexpr (Policy::kKeeps == Keeps::Color)
            color = CentreColors(policy, group, pattern.held, square, block, lane, worker);
        if constexpr (Policy::kKeeps == Keeps::Number)
            color = hn::Set(unsignedTag, group.number);
        std::int32_t* keys = KeysOf(policy, worker, block) + lane;
        std::uint32_t* kept = Policy::kKeeps == Keeps::Color ? SampleColorsOf(policy, worker, block) + lane
                                                             : NumbersOf(policy, worker, block) + lane;
        for (std::size_t s = 0; s < sets; ++s, keys += kLanes, kept += kLanes) {
            const auto moved = [&](std::size_t k)
                                   HWY_ATTR { return hn::Add(edge[k], hn::Set(tag, pattern.lanes.edge[k][s])); };
            auto inside = NotNegative(hn::Or3(moved(0), moved(1), moved(2)));
            if constexpr (!Policy::kUsual)
                inside = hn::And(inside, OnTarget(policy, block, lane));
            const Ints key = StoredKey(Add(depth, hn::Set(DoubleTag(), pattern.lanes.depth[s])), policy);
            const Ints stored = hn::Load(tag, keys);
            const auto passed = TestDepth(policy, inside, key, stored, group.test, keys);
            if constexpr (Policy::kKeeps != Keeps::Nothing)
                hn::BlendedStore(color, hn::RebindMask(unsignedTag, passed), unsignedTag, kept);
            if constexpr (!Policy::kUsual)
                CountSamples(policy, inside, passed, (block * sets + s) * kLanes + lane, worker);
        }
    }
}

/// Tests the blocks of the queue.
template <bool kAffine, class Policy>
HWY_INLINE void CoverBlocks(const Policy& policy, const BlockQueue& queue, Worker& worker)
{
    for (std::size_t i = 0; i < queue.itemCount; ++i) {
        const std::uint32_t item = queue.items[i];
        const std::uint32_t group = item >> 8 & 0xff;
        if constexpr (Policy::kPattern)
            CoverPatternBlock(queue.groups[group], queue.patterns[group], item & 0xff, item >> 16, policy, worker);
        else
            CoverBlock<kAffine>(queue.groups[group], item & 0xff, item >> 16, policy, worker);
    }
}

/// Tests the blocks of the queue and empties it. Where no colour needs more than a sum, the loop has no call: constants
/// stay in registers.
template <class Policy>
inline HWY_NOINLINE void FlushQueue(const Policy& policy, BlockQueue& queue, Worker& worker)
{
    if (HWY_LIKELY(queue.affine))
        CoverBlocks<true>(policy, queue, worker);
    else
        CoverBlocks<false>(policy, queue, worker);
    queue.itemCount = 0;
    queue.groupCount = 0;
    queue.affine = true;
}

/// Makes room for a group.
template <class Policy>
HWY_INLINE void MakeRoom(const Policy& policy, BlockQueue& queue, Worker& worker)
{
    if (queue.groupCount == BlockQueue::kGroups)
        FlushQueue(policy, queue, worker);
}

/// Appends the next group.
///
/// in   the blocks of the tile at the group's 16 places, and which of them are wanted
template <class Policy, class BlocksAt>
HWY_INLINE void AppendGroup(const Policy&, const TriangleLanes& t, std::uint32_t wanted, BlockQueue& queue,
                            BlocksAt&& blocksAt)
{
    constexpr UintTag tag;
    const auto index = static_cast<std::uint32_t>(queue.groupCount++);
    BlockQueue::Group& group = queue.groups[index];
    group.number = t.number;
    if constexpr (!Policy::kUsual)
        group.test = t.test;
    if constexpr (Policy::kPattern)
        queue.patterns[index].lanes = t.pattern;
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

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
