// One tile from its bins to the picture. Included once for each target: see README.md.
#if defined(RASTERLENS_TILED_TILE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_TILE_INL_H
#undef RASTERLENS_TILED_TILE_INL_H
#else
#define RASTERLENS_TILED_TILE_INL_H
#endif

#include "core/tiled/cover-inl.h"
#include "core/tiled/faces-inl.h"
#include "core/tiled/resolve-inl.h"
#include "core/tiled/shade-inl.h"
#include "core/tiled/tile_output.h"
#include "core/tiled/vertices-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// Collects the blocks of a tile's bins in the order of the faces.
inline void CollectBlocks(const FrameJob& job, std::size_t tile, Worker& worker)
{
    worker.blocks.clear();
    for (const Chunk& chunk : *job.chunks) {
        const Bin& bin = chunk.bins[tile];
        for (std::uint32_t block = bin.first; block != kNobody; block = chunk.arena.next(block))
            worker.blocks.push_back({&chunk.arena.block(block), chunk.arena.texels(block), &chunk,
                                     block == bin.last ? bin.used : BinBlock::kCapacity});
    }
}

/// Prefetches the first triangles of a tile into the cache while another tile is drawn.
inline void FetchBins(const FrameJob& job, std::size_t tile)
{
    constexpr std::size_t kAhead = 8; // triangles
    for (const Chunk& chunk : *job.chunks) {
        if (chunk.bins[tile].first == kNobody)
            continue;
        const BinBlock& block = chunk.arena.block(chunk.bins[tile].first);
        for (std::size_t i = 0; i < kAhead; ++i) {
            __builtin_prefetch(&block.triangles[i]);
            __builtin_prefetch(&block.colors[i]);
        }
        return;
    }
}

inline void WriteColor(const FrameJob& job, const Worker& worker, TileOrigin origin)
{
    switch (job.rules.sampleGrid) {
    case 1:
        if (!job.hasTexels()) // those are written as they are made
            copyColor(job, worker.samples, origin);
        break;
    case 2: ResolveTile<2>(job, worker, origin); break;
    case 4: ResolveTile<4>(job, worker, origin); break;
    default: averageColor(job, worker, origin);
    }
}

/// Whether a tile holds nothing but background now as in the last frame, so that it need not be cleared. Face ids and
/// coverage are not tracked: a frame that has them clears every tile.
inline bool StaysBlank(const FrameJob& job, std::size_t tile)
{
    return job.ids == nullptr && job.coverage == nullptr && job.sampleCoverage == nullptr && job.blank[tile] != 0;
}

/// Some tiles of a row; neighbours that are empty are cleared together.
inline void DrawTiles(const FrameJob& job, Worker& worker, int columnBegin, int columnEnd, int row)
{
    const int pitch = job.grid.pitch;
    int emptyBegin = columnBegin;
    const auto clearUpTo = [&](int column) {
        if (emptyBegin < column)
            clearTiles(job, {emptyBegin * pitch, row * pitch}, column - emptyBegin);
        emptyBegin = column + 1;
    };
    for (int column = columnBegin; column < columnEnd; ++column) {
        const std::size_t tile = job.grid.index(column, row);
        CollectBlocks(job, tile, worker);
        if (worker.blocks.empty()) {
            if (StaysBlank(job, tile))
                clearUpTo(column);
            job.blank[tile] = 1;
            continue;
        }
        clearUpTo(column);
        job.blank[tile] = 0;
        if (column + 1 < columnEnd)
            FetchBins(job, tile + 1);
        const TileOrigin origin{column * pitch, row * pitch};
        CoverTile(job, worker, origin);
        if (!job.hasTexels())
            prefetchTile(job, origin);
        ShadeTile(job, worker, origin);
        if (job.color != nullptr)
            WriteColor(job, worker, origin);
        writeTile(job, worker, origin);
    }
    clearUpTo(columnEnd);
}

inline constexpr Kernels kKernels{ProcessVertices, ProcessFaces, DrawTiles};

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
