#pragma once
#include "core/rasterizers/tiled/exact_path.h"

namespace rasterlens::tiled
{

/// Writes a tile into the picture and the other arrays that were asked for; several samples a pixel are averaged.
void writeTile(const FrameJob& job, const Worker& worker, TileOrigin origin);

/// Brings the pixels of a tile near while there is something else to do.
void prefetchTile(const FrameJob& job, TileOrigin origin);

/// The same for tiles side by side that no triangle touches.
void clearTiles(const FrameJob& job, TileOrigin origin, int count);

} // namespace rasterlens::tiled
