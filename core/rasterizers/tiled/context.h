#pragma once
#include "core/rasterizers/tiled/kernels.h"
#include "core/rasterizers/tiled/thread_pool.h"

#include <memory>

namespace rasterlens
{

/// Threads and memory of the tiled algorithm, kept with the Frame from picture to picture.
///
/// A frame is drawn by one caller at a time, and so is what belongs to it: no lock, and nothing shared between callers
/// that draw at the same time. Memory goes when the last picture goes.
struct TiledContext {
    std::unique_ptr<tiled::ThreadPool> pool;
    std::vector<std::unique_ptr<tiled::Worker>> workers; ///< one a thread
    std::vector<tiled::Chunk> chunks;
    tiled::LargeArray<tiled::ScreenPoint> points;
    tiled::LargeArray<glm::vec4> colors;
};

} // namespace rasterlens
