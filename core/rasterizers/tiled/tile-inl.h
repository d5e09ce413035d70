// One tile from its bins to the picture. Included once for each target.
#if defined(RASTERLENS_TILED_TILE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_TILE_INL_H
#undef RASTERLENS_TILED_TILE_INL_H
#else
#define RASTERLENS_TILED_TILE_INL_H
#endif

#include "core/rasterizers/tiled/cover-inl.h"
#include "core/rasterizers/tiled/faces-inl.h"
#include "core/rasterizers/tiled/shade-inl.h"
#include "core/rasterizers/tiled/tile_output.h"
#include "core/rasterizers/tiled/vertices-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

inline void DrawTile(const FrameJob& job, Worker& worker, int column, int row)
{
    const TileOrigin origin{column * job.grid.pitch, row * job.grid.pitch};
    worker.blocks.clear();
    worker.blockChunk.clear();
    for (const Chunk& chunk : *job.chunks)
        for (const BinBlock* block = chunk.bins[job.grid.index(column, row)].first; block != nullptr;
             block = block->next) {
            worker.blocks.push_back(block);
            worker.blockChunk.push_back(&chunk);
        }
    if (worker.blocks.empty()) {
        writeEmptyTile(job, origin);
        return;
    }
    CoverTile(job, worker, origin);
    ShadeTile(job, worker, origin);
    writeTile(job, worker, origin);
}

inline constexpr Kernels kKernels{ProcessVertices, ProcessFaces, DrawTile};

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
