#pragma once
#include "core/rasterizers/tiled/exact_path.h"

namespace rasterlens::tiled
{

/// Writes a tile into the picture and the other arrays that were asked for; several samples a pixel are averaged.
void writeTile(const FrameJob& job, const Worker& worker, TileOrigin origin);

/// The same for a tile no triangle touches.
void writeEmptyTile(const FrameJob& job, TileOrigin origin);

} // namespace rasterlens::tiled
