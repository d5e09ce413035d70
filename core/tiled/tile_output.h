#pragma once
#include "core/tiled/exact_path.h"

namespace rasterlens::tiled
{

/// Pixels of the target.
struct PixelBox {
    int x0, y0, x1, y1; ///< ends excluded
};

/// The pixels of tiles side by side.
[[nodiscard]] PixelBox pixelsOf(const FrameJob& job, TileOrigin origin, int tiles = 1);

[[nodiscard]] inline std::size_t pixelIndex(const FrameJob& job, int x, int y)
{
    return std::size_t(y) * std::size_t(job.rules.width) + std::size_t(x);
}

/// Writes a tile into the picture: with one sample a pixel, and with several by their means, but for subtiles that are
/// resolved already.
void copyColor(const FrameJob& job, const TileSamples& samples, TileOrigin origin);
void averageColor(const FrameJob& job, const Worker& worker, TileOrigin origin);

/// Writes a tile into the other arrays that were asked for.
void writeTile(const FrameJob& job, const Worker& worker, TileOrigin origin);

/// Writes four blocks side by side into a picture with one sample a pixel.
///
/// in   the first block of a row of a subtile; 16 colours each
void writeBlocks(const FrameJob& job, TileOrigin origin, int firstBlock, const std::uint32_t* colors);

/// Prefetches the pixels of a tile into the cache while other work goes on.
void prefetchTile(const FrameJob& job, TileOrigin origin);

/// Clears the pixels of `count` tiles side by side that no triangle touches.
void clearTiles(const FrameJob& job, TileOrigin origin, int count);

} // namespace rasterlens::tiled
