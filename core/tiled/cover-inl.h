// First phase of a tile: coverage, depth and the number of the nearest triangle. Included once for each target: see
// README.md.
#if defined(RASTERLENS_TILED_COVER_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_COVER_INL_H
#undef RASTERLENS_TILED_COVER_INL_H
#else
#define RASTERLENS_TILED_COVER_INL_H
#endif

#include "core/tiled/blocks-inl.h"
#include "core/tiled/exact_path.h"
#include "core/tiled/frame_job.h"
#include "core/tiled/lanes-inl.h"
#include "core/tiled/pattern-inl.h"
#include "core/tiled/squares-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// Clears all blocks that are still unwritten. This is done in one pass, because which blocks later triangles will
/// touch cannot be predicted.
template <class Policy>
inline HWY_NOINLINE void WriteAllBlankBlocks(const Policy& policy, Worker& worker)
{
    TileSamples& samples = worker.samples;
    for (std::size_t block = 0; block < kTileBlocks; ++block) {
        if (samples.owner[block] != kEmpty)
            continue;
        samples.owner[block] = kNobody;
        std::int32_t* keys = KeysOf(policy, worker, block);
        for (std::size_t at = 0; at < SetsOf(policy) * kLanes; at += kPerVector) {
            hn::Store(hn::Set(IntTag(), samples.clearKey), IntTag(), keys + at);
            if constexpr (Policy::kKeeps == Keeps::Color)
                hn::Store(hn::Set(UintTag(), policy.job.clearColor), UintTag(),
                          SampleColorsOf(policy, worker, block) + at);
            if constexpr (Policy::kKeeps == Keeps::Number)
                hn::Store(hn::Set(UintTag(), kNobody), UintTag(), NumbersOf(policy, worker, block) + at);
        }
    }
}

template <class Policy>
HWY_INLINE void WriteBlankBlocks(const Policy& policy, Worker& worker, TileDepth& tile)
{
    if (HWY_UNLIKELY(tile.blank)) {
        tile.blank = false;
        WriteAllBlankBlocks(policy, worker);
    }
}

/// Interpolated colours of samples of a block, a bit each.
inline void ColorSamples(const FrameJob& job, TileOrigin origin, std::uint32_t number, std::size_t block,
                         std::uint32_t lanes, Worker& worker)
{
    constexpr UintTag tag;
    const ColorPlanes& planes = worker.colors(number);
    if (HWY_UNLIKELY(planes.way == ColorWay::Exact)) {
        ColorExactly(job, origin, number, block, lanes, worker);
        return;
    }
    const int x = origin.x + blockColumn(static_cast<int>(block)) * kBlockSide;
    const int y = origin.y + blockRow(static_cast<int>(block)) * kBlockSide;
    for (std::size_t v = 0; v < kVectors; ++v) {
        std::uint32_t* colors = worker.samples.color.data() + block * kLanes + v * kPerVector;
        hn::Store(hn::IfThenElse(MaskOf(tag, lanes >> (v * kPerVector)), BlockColor(planes, x, y, v, false),
                                 hn::Load(tag, colors)),
                  tag, colors);
    }
}

/// The keys of blocks of a subtile, a bit each, that one triangle has to itself.
///
/// in   the first block of the subtile
template <class Policy>
inline void WriteOwnedKeys(const Policy& policy, Worker& worker, std::size_t first, std::uint32_t number,
                           std::uint32_t blocks)
{
    const TileTriangle& t = worker.triangle(number);
    const int x = blockColumn(static_cast<int>(first)) * kBlockSide - t.anchorX();
    const int y = blockRow(static_cast<int>(first)) * kBlockSide - t.anchorY();
    const Doubles corner = hn::Set(DoubleTag(), t.depthOrigin + t.depthPerX * x + t.depthPerY * y);
    alignas(64) std::array<double, kLanes> corners;
    std::array<WideDoubles, kVectors> offsets;
    for (std::size_t v = 0; v < kVectors; ++v) {
        offsets[v] = DepthOffsets(t.depthPerX, t.depthPerY, v * kPerVector);
        Store(Add(Mul(offsets[v], hn::Set(DoubleTag(), double(kBlockSide))), corner), corners.data() + v * kPerVector);
    }
    for (; blocks != 0; blocks &= blocks - 1) {
        const auto square = static_cast<std::size_t>(std::countr_zero(blocks));
        std::int32_t* keys = KeysOf(policy, worker, first + square);
        for (std::size_t v = 0; v < kVectors; ++v) {
            const WideDoubles depth = Add(offsets[v], hn::Set(DoubleTag(), corners[square]));
            if constexpr (!Policy::kPattern) {
                hn::Store(KeyOf(depth), IntTag(), keys + v * kPerVector);
            } else {
                for (std::size_t s = 0; s < SetsOf(policy); ++s) {
                    const double offset = policy.job.pattern.depthOffset(s, t.depthPerX, t.depthPerY);
                    hn::Store(KeyOf(Add(depth, hn::Set(DoubleTag(), offset))), IntTag(),
                              keys + s * kLanes + v * kPerVector);
                }
            }
        }
    }
}

/// What blocks of a subtile keep beside their keys.
template <class Policy>
inline void WriteOwnedRest(const Policy& policy, Worker& worker, std::size_t first, std::uint32_t number,
                           std::uint32_t blocks)
{
    for (; blocks != 0; blocks &= blocks - 1) {
        const std::size_t block = first + static_cast<std::size_t>(std::countr_zero(blocks));
        if constexpr (Policy::kKeeps == Keeps::Color && Policy::kPattern) {
            ColorCentres(policy.job, policy.origin, number, block, 0xffff, worker);
            const std::uint32_t* centres = worker.samples.color.data() + block * kLanes;
            for (std::size_t s = 0; s < SetsOf(policy); ++s)
                std::copy_n(centres, kLanes, SampleColorsOf(policy, worker, block) + s * kLanes);
        } else if constexpr (Policy::kKeeps == Keeps::Color) {
            ColorSamples(policy.job, policy.origin, number, block, 0xffff, worker);
        }
        if constexpr (Policy::kKeeps == Keeps::Number)
            std::fill_n(NumbersOf(policy, worker, block), SetsOf(policy) * kLanes, number);
    }
}

/// Writes the samples of blocks of a subtile, a bit each, if a triangle has them to itself.
template <class Policy>
inline void WriteOwnedBlocks(const Policy& policy, Worker& worker, std::size_t first, std::uint32_t blocks)
{
    std::uint32_t* owners = worker.samples.owner.data() + first;
    for (std::uint32_t left = blocks & ~LanesWith(owners, kNobody); left != 0;) {
        const std::uint32_t number = owners[std::countr_zero(left)];
        const std::uint32_t owned = left & LanesWith(owners, number);
        WriteOwnedKeys(policy, worker, first, number, owned);
        WriteOwnedRest(policy, worker, first, number, owned);
        for (std::uint32_t bits = owned; bits != 0; bits &= bits - 1)
            owners[std::countr_zero(bits)] = kNobody;
        left &= ~owned;
    }
}

template <class Policy>
inline void WriteOwnedBlocks(const Policy& policy, Worker& worker, TileDepth& tile)
{
    WriteBlankBlocks(policy, worker, tile);
    for (std::size_t first = 0; tile.owners && first < kTileBlocks; first += kLanes)
        WriteOwnedBlocks(policy, worker, first, 0xffff);
    tile.owners = false;
}

/// The colours of a triangle in 4 x 4 blocks from sample (x, y) of the tile on, if they are wanted.
template <bool kFromAnchor, class Policy>
HWY_INLINE void FillColors(const TriangleLanes& lanes, int x, int y, const Policy& policy, BlockQueue& queue)
{
    BlockQueue::Group& group = queue.groups[queue.groupCount];
    if constexpr (Policy::kKeeps == Keeps::Color && Policy::kPattern) {
        group.colors.planes = lanes.planes;
        group.colors.x = policy.origin.x + x - lanes.planes->x0;
        group.colors.y = policy.origin.y + y - lanes.planes->y0;
        if (HWY_LIKELY(lanes.planes->way == ColorWay::Affine))
            queue.patterns[queue.groupCount].held.fill(*lanes.planes, group.colors.x, group.colors.y);
    } else if constexpr (Policy::kKeeps == Keeps::Color) {
        queue.affine &= lanes.planes->way == ColorWay::Affine;
        const int toX = policy.origin.x + x - lanes.planes->x0;
        const int toY = policy.origin.y + y - lanes.planes->y0;
        if constexpr (kFromAnchor)
            group.colors.fillFromAnchor(*lanes.planes, toX, toY);
        else
            group.colors.fill(*lanes.planes, toX, toY);
    }
}

/// A triangle that is large in the tile: subtiles first, then their blocks.
template <class Policy>
HWY_INLINE void CoverSubtiles(const TriangleLanes& lanes, const TileTriangle& t, const Policy& policy, Worker& worker,
                              TileDepth& tile, BlockQueue& queue)
{
    std::uint32_t subtiles = SquaresBetween(t.x0 / 16, t.y0 / 16, t.x1 / 16, t.y1 / 16);
    if (std::popcount(subtiles) > 4) {
        SquareCorners corners;
        subtiles &= JudgeSquares<Policy, 4>(lanes, ValuesAt(lanes, t, 0, 0).edge, corners).touched;
    }
    for (; subtiles != 0; subtiles &= subtiles - 1) {
        const int subtile = std::countr_zero(subtiles);
        const int x = subtile % 4 * 16;
        const int y = subtile / 4 * 16;
        MakeRoom(policy, queue, worker);
        BlockQueue::Group& group = queue.groups[queue.groupCount];
        const std::size_t firstBlock = static_cast<std::size_t>(subtile) * 16;
        const SampleValues first = ValuesAt(lanes, t, x, y);
        const SquareVerdicts verdicts = JudgeSquares<Policy, 2>(lanes, first.edge, group.corners);
        BlockWork work =
            DecideBlocks(lanes, first.depth, verdicts, policy, firstBlock, worker.samples, tile, group.corners);
        if (work.writeBefore != 0) {
            WriteBlankBlocks(policy, worker, tile);
            WriteOwnedBlocks(policy, worker, firstBlock, work.writeBefore);
        }
        if (work.cover != 0) {
            FillColors<false>(lanes, x, y, policy, queue);
            AppendGroup(policy, lanes, work.cover, queue, [&](std::size_t lane) HWY_ATTR {
                return PlacesFrom(static_cast<std::uint32_t>(firstBlock), lane);
            });
        }
    }
    if (Policy::kUsual && tile.updates >= kTileBlocks / 4)
        RefreshFarthest(worker.samples, tile);
}

/// The columns and rows of blocks that hold the bounds of a triangle.
struct BlockBounds {
    int column, row, columns, rows;
};

HWY_INLINE BlockBounds BoundsInBlocks(const TileTriangle& t)
{
    const int column = t.x0 / kBlockSide;
    const int row = t.y0 / kBlockSide;
    return {column, row, t.x1 / kBlockSide - column + 1, t.y1 / kBlockSide - row + 1};
}

/// blockIndex() of the 4 x 4 blocks from column and row on.
HWY_INLINE Uints BlocksFrom(int column, int row, std::size_t lane)
{
    constexpr UintTag tag;
    // Column and row take turns in the bits of a block's index. Where the bits of the other one are set, sums carry
    // across them.
    constexpr std::uint32_t kColumnBits = 0x33;
    constexpr std::uint32_t kRowBits = 0xcc;
    static_assert(blockIndex(15, 0) == kColumnBits && blockIndex(0, 15) == kRowBits);
    const auto first = [](int index, std::uint32_t others)
                           HWY_ATTR { return hn::Set(UintTag(), static_cast<std::uint32_t>(index) | others); };
    const Uints places = hn::Load(tag, kPattern.place.data() + lane);
    const Uints x = hn::Add(hn::And(places, hn::Set(tag, 3)), first(blockIndex(column, 0), kRowBits));
    const Uints y = hn::Add(hn::And(places, hn::Set(tag, 12)), first(blockIndex(0, row), kColumnBits));
    return hn::OrAnd(hn::And(x, hn::Set(tag, kColumnBits)), y, hn::Set(tag, kRowBits));
}

/// Writes the samples of blocks of a window, a bit each, if a triangle has them to itself.
template <class Policy>
inline HWY_NOINLINE void WriteOwnedInWindow(const Policy& policy, Worker& worker, BlockBounds window,
                                            std::uint32_t blocks)
{
    for (; blocks != 0; blocks &= blocks - 1) {
        const int square = std::countr_zero(blocks);
        const auto block =
            static_cast<std::size_t>(blockIndex(window.column + square % kBlockSide, window.row + square / kBlockSide));
        WriteOwnedBlocks(policy, worker, block & ~std::size_t(kLanes - 1), 1U << block % kLanes);
    }
}

/// Up to 4 x 4 blocks of a triangle: those that it touches, without asking what is in front.
///
/// in   the triangle at the first sample of them; the queue has room for a group
template <bool kFromAnchor, class Policy>
HWY_INLINE void CoverWindow(const TriangleLanes& lanes, const SampleValues& first, const BlockBounds& window,
                            const Policy& policy, Worker& worker, const TileDepth& tile, BlockQueue& queue)
{
    BlockQueue::Group& group = queue.groups[queue.groupCount];
    StoreDepths(lanes, first.depth, group.corners);
    const std::uint32_t touched =
        TouchedSquares(lanes, first.edge, group.corners) & SquaresBetween(0, 0, window.columns - 1, window.rows - 1);
    FillColors<kFromAnchor>(lanes, window.column * kBlockSide, window.row * kBlockSide, policy, queue);
    AppendGroup(policy, lanes, touched, queue,
                [&](std::size_t lane) HWY_ATTR { return BlocksFrom(window.column, window.row, lane); });
    if (HWY_UNLIKELY(tile.owners)) // before the queue is tested; older triangles in it lose against the owners
        WriteOwnedInWindow(policy, worker, window, touched);
}

/// What comes before the windows of a triangle.
template <class Policy>
HWY_INLINE void PrepareWindows(const TileTriangle& t, const Policy& policy, Worker& worker, TileDepth& tile)
{
    tile.nearestSmall = std::min(tile.nearestSmall, std::max(std::bit_cast<std::int32_t>(t.nearest), 0));
    WriteBlankBlocks(policy, worker, tile);
}

/// A triangle of more than 4 x 4 blocks. A function of its own, as FlushQueue() is: where one could be called while the
/// lanes of CoverTriangle() are in registers, these would be kept in memory instead.
template <class Policy>
inline HWY_NOINLINE void CoverLargerTriangle(const TileTriangle& t, const ColorPlanes& planes, const Policy& policy,
                                             std::uint32_t number, Worker& worker, TileDepth& tile, BlockQueue& queue)
{
    const TriangleLanes lanes = SpreadTriangle(policy, t, planes, number, worker);
    if (t.isLarge()) {
        CoverSubtiles(lanes, t, policy, worker, tile, queue);
        return;
    }
    PrepareWindows(t, policy, worker, tile);
    const BlockBounds bounds = BoundsInBlocks(t);
    for (int row = 0; row < bounds.rows; row += 4)
        for (int column = 0; column < bounds.columns; column += 4) {
            const BlockBounds window{bounds.column + column, bounds.row + row, std::min(bounds.columns - column, 4),
                                     std::min(bounds.rows - row, 4)};
            const SampleValues first = ValuesAt(lanes, t, window.column * kBlockSide, window.row * kBlockSide);
            MakeRoom(policy, queue, worker);
            CoverWindow<false>(lanes, first, window, policy, worker, tile, queue);
        }
}

template <class Policy>
HWY_INLINE void CoverTriangle(const TileTriangle& t, const ColorPlanes& planes, const Policy& policy,
                              std::uint32_t number, Worker& worker, TileDepth& tile, BlockQueue& queue)
{
    const BlockBounds bounds = BoundsInBlocks(t);
    if (HWY_UNLIKELY(bounds.columns > 4 || bounds.rows > 4)) {
        CoverLargerTriangle(t, planes, policy, number, worker, tile, queue);
        return;
    }
    PrepareWindows(t, policy, worker, tile);
    MakeRoom(policy, queue, worker);
    const TriangleLanes lanes = SpreadTriangle(policy, t, planes, number, worker);
    CoverWindow<true>(lanes, {t.c, t.depthOrigin}, bounds, policy, worker, tile, queue);
}

/// Samples of a triangle beyond the numbers of the fast path, one by one.
template <class Policy>
inline void CoverExactly(const FrameJob& job, const ScreenTriangle& piece, const Policy&, std::uint32_t number,
                         TileOrigin origin, Worker& worker)
{
    TileSamples& samples = worker.samples;
    if constexpr (Policy::kKeeps != Keeps::Color) {
        coverExactly(job, piece, number, origin, worker);
    } else if constexpr (Policy::kPattern) {
        const std::size_t perBlock = job.pattern.samples * kLanes;
        std::fill_n(worker.pattern.ids.data(), kTileBlocks * perBlock, kNobody);
        coverExactly(job, piece, number, origin, worker);
        for (std::size_t block = 0; block < kTileBlocks; ++block) {
            const std::uint32_t* ids = worker.pattern.ids.data() + block * perBlock;
            if (std::find(ids, ids + perBlock, number) == ids + perBlock)
                continue;
            ColorCentres(job, origin, number, block, 0xffff, worker);
            ShareColors(job.pattern, number, block, worker);
        }
    } else {
        samples.ids.fill(kNobody);
        coverExactly(job, piece, number, origin, worker);
        for (std::size_t block = 0; block < kTileBlocks; ++block) {
            const std::uint32_t lanes = LanesWith(samples.ids.data() + block * kLanes, number);
            if (lanes != 0)
                ColorSamples(job, origin, number, block, lanes, worker);
        }
    }
}

/// Prefetches the record of a triangle of a bin into the cache. A number beyond the last one does no harm.
template <class Policy>
HWY_INLINE void FetchRecord(const TileBlock& block, std::size_t triangle)
{
    __builtin_prefetch(block.bin->triangles.data() + triangle);
    if constexpr (Policy::kKeeps == Keeps::Color) {
        __builtin_prefetch(block.bin->colors.data() + triangle);
    } else if (block.texels != nullptr) {
        __builtin_prefetch(block.bin->colors.data() + triangle);
        __builtin_prefetch(block.texels->data() + triangle);
    }
}

template <class Policy>
inline void CoverTriangles(const Policy& policy, const FrameJob& job, Worker& worker, TileOrigin origin,
                           TileDepth& tile)
{
    constexpr std::size_t kAhead = 8; // triangles
    BlockQueue queue;
    for (std::size_t block = 0; block < worker.blocks.size(); ++block) {
        const TileBlock& bin = worker.blocks[block];
        if (block + 1 < worker.blocks.size())
            for (std::size_t i = 0; i < kAhead; ++i)
                FetchRecord<Policy>(worker.blocks[block + 1], i);
        for (std::uint32_t i = 0; i < bin.count; ++i) {
            const TileTriangle& t = bin.bin->triangles[i];
            FetchRecord<Policy>(bin, i + kAhead);
            const std::uint32_t number = static_cast<std::uint32_t>(block) * BinBlock::kCapacity + i;
            if (Policy::kUsual && std::bit_cast<std::int32_t>(t.nearest) >= tile.farthest)
                continue;
            if (HWY_UNLIKELY(t.exact())) {
                FlushQueue(policy, queue, worker);
                WriteOwnedBlocks(policy, worker, tile);
                tile.nearestSmall = 0;
                CoverExactly(job, bin.chunk->pieces[t.source & ~kPiece], policy, number, origin, worker);
                continue;
            }
            CoverTriangle(t, bin.bin->colors[i], policy, number, worker, tile, queue);
        }
    }
    FlushQueue(policy, queue, worker);
}

/// Whether a tile has one triangle that covers it all, in front of the background.
template <class Policy>
inline bool HasOneForAll(const Policy& policy, const Worker& worker, const TileDepth& tile)
{
    constexpr int kLast = kTileSide - 1;
    if (worker.blocks.size() != 1 || worker.blocks[0].count != 1)
        return false;
    const TileTriangle& t = worker.triangle(0);
    if ((t.x0 | t.y0) != 0 || t.x1 != kLast || t.y1 != kLast)
        return false;
    const TriangleLanes lanes = SpreadTriangle(policy, t, worker.colors(0), 0, worker);
    double farthest = t.depthOrigin + kLast * (std::max(t.depthPerX, 0.0) + std::max(t.depthPerY, 0.0));
    bool covers = true;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::int32_t reach = Policy::kPattern ? lanes.reach[k] : 0;
        covers &= t.c[k] + kLast * (std::min(lanes.a[k], 0) + std::min(lanes.b[k], 0)) - reach >= 0;
    }
    if constexpr (Policy::kPattern)
        farthest += lanes.depthReach;
    return covers && depthKey(static_cast<float>(farthest)) < tile.farthest;
}

template <class Policy>
inline void CoverWith(const Policy& policy, const FrameJob& job, Worker& worker, TileOrigin origin, TileDepth& tile)
{
    if constexpr (!Policy::kUsual)
        WriteOwnedBlocks(policy, worker, tile);
    if (Policy::kUsual && HasOneForAll(policy, worker, tile)) {
        worker.samples.owner.fill(0);
        tile.owners = true;
    } else {
        CoverTriangles(policy, job, worker, origin, tile);
    }
    if (job.depth != nullptr || job.ids != nullptr || job.rules.shading == Shading::Depth)
        WriteOwnedBlocks(policy, worker, tile);
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

template <bool kPattern>
inline void CoverWithPattern(const FrameJob& job, Worker& worker, TileOrigin origin, TileDepth& tile)
{
    if (job.colorsAtOnce())
        CoverWith(UsualDepth<Keeps::Color, kPattern>(job, origin), job, worker, origin, tile);
    else if (job.depthOnly())
        CoverWith(UsualDepth<Keeps::Nothing, kPattern>(job, origin), job, worker, origin, tile);
    else if (job.usualDepth())
        CoverWith(UsualDepth<Keeps::Number, kPattern>(job, origin), job, worker, origin, tile);
    else
        CoverWith(AnyDepth<kPattern>(job, origin), job, worker, origin, tile);
}

/// Fills the samples of a tile from the triangles in worker.blocks.
inline void CoverTile(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    TileSamples& samples = worker.samples;
    const auto clear = std::bit_cast<std::int32_t>(job.rules.depthClear);
    samples.clearKey = clear;
    samples.farthest.fill(clear);
    samples.nearest.fill(clear);
    samples.owner.fill(kEmpty);
    HideOffTarget(job, origin, samples);
    if (job.countsCoverage() && job.pattern.isOn())
        std::fill_n(worker.pattern.coverage.data(), kTileSamples * job.pattern.samples, std::uint16_t(0));
    else if (job.countsCoverage())
        samples.coverage.fill(0);
    TileDepth tile{clear, clear};
    if (job.pattern.isOn())
        CoverWithPattern<true>(job, worker, origin, tile);
    else
        CoverWithPattern<false>(job, worker, origin, tile);
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
