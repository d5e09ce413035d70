#pragma once
#include "core/tiled/frame_job.h"
#include "core/tiled/thread_pool.h"

#include <memory>

namespace rasterlens
{

/// What is known of a picture since the last frame: tiles without triangles need not be cleared again and again.
struct PictureMemory {
    QSize size;
    int pitch = 0;
    qint64 image = 0; ///< QImage::cacheKey(), which changes whenever the pixels are handed out for writing
    std::uint32_t emptyColor = 0;
    std::uint64_t depth = 0; ///< DepthBuffer::key()
    float depthClear = 0;
    std::vector<std::uint8_t> blank; ///< FrameJob::blank
};

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
    PictureMemory picture;
};

} // namespace rasterlens
