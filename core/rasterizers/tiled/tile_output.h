#pragma once
#include "core/rasterizers/tiled/exact_path.h"

namespace rasterlens::tiled
{

/// Writes a tile into the picture and the other arrays that were asked for; several samples a pixel are averaged.
void writeTile(const FrameJob& job, const Worker& worker, TileOrigin origin);

/// Writes four blocks side by side into a picture with one sample a pixel.
///
/// in   the first block of a row of a subtile; 16 colours each
void writeBlocks(const FrameJob& job, TileOrigin origin, int firstBlock, const std::uint32_t* colors);

/// Brings the pixels of a tile near while there is something else to do.
void prefetchTile(const FrameJob& job, TileOrigin origin);

/// The same for tiles side by side that no triangle touches.
void clearTiles(const FrameJob& job, TileOrigin origin, int count);

} // namespace rasterlens::tiled
