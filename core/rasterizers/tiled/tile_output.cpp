#include "core/rasterizers/tiled/tile_output.h"

#include "core/pipeline/shading.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace rasterlens::tiled
{
namespace
{

/// The pixels of a tile.
struct PixelBox {
    int x0, y0, x1, y1; ///< ends excluded
};

PixelBox pixelsOf(const FrameJob& job, TileOrigin origin, int tiles = 1)
{
    const int grid = job.rules.sampleGrid;
    const int side = job.grid.pitch / grid;
    const int x = origin.x / grid;
    const int y = origin.y / grid;
    return {x, y, std::min(x + side * tiles, job.rules.width), std::min(y + side, job.rules.height)};
}

std::size_t pixelIndex(const FrameJob& job, int x, int y)
{
    return std::size_t(y) * std::size_t(job.rules.width) + std::size_t(x);
}

/// With one sample a pixel: rows of four samples, block by block.
void copyColor(const FrameJob& job, const TileSamples& samples, const PixelBox& box)
{
    for (int y = box.y0; y < box.y1; ++y) {
        std::uint32_t* out = job.color + pixelIndex(job, box.x0, y);
        int x = 0;
        const int width = box.x1 - box.x0;
        for (; x + kBlockSide <= width; x += kBlockSide)
            std::memcpy(out + x, &samples.color[std::size_t(sampleIndex(x, y - box.y0))], kBlockSide * sizeof *out);
        for (; x < width; ++x)
            out[x] = samples.color[std::size_t(sampleIndex(x, y - box.y0))];
    }
}

/// The mean of a pixel's samples, channel by channel, rounded to nearest.
std::uint32_t meanColor(const TileSamples& samples, int x, int y, int grid)
{
    const auto count = static_cast<std::uint32_t>(grid * grid);
    std::uint32_t red = count / 2;
    std::uint32_t green = red;
    std::uint32_t blue = red;
    for (int j = 0; j < grid; ++j)
        for (int i = 0; i < grid; ++i) {
            const std::uint32_t c = samples.color[std::size_t(sampleIndex(x + i, y + j))];
            red += c >> 16 & 255U;
            green += c >> 8 & 255U;
            blue += c & 255U;
        }
    return 0xff000000U | red / count << 16 | green / count << 8 | blue / count;
}

template <class Write>
void forEachPixel(const PixelBox& box, Write&& write)
{
    for (int y = box.y0; y < box.y1; ++y)
        for (int x = box.x0; x < box.x1; ++x)
            write(x, y);
}

} // namespace

void writeTile(const FrameJob& job, const Worker& worker, TileOrigin origin)
{
    const TileSamples& samples = worker.samples;
    const PixelBox box = pixelsOf(job, origin);
    const int grid = job.rules.sampleGrid;
    if (grid == 1)
        copyColor(job, samples, box);
    else
        forEachPixel(box, [&](int x, int y) {
            job.color[pixelIndex(job, x, y)] = meanColor(samples, x * grid - origin.x, y * grid - origin.y, grid);
        });
    // The sample nearest the pixel's centre.
    const auto at = [&](int x, int y) {
        return std::size_t(sampleIndex(x * grid + grid / 2 - origin.x, y * grid + grid / 2 - origin.y));
    };
    if (job.depth != nullptr)
        forEachPixel(box, [&](int x, int y) {
            job.depth[pixelIndex(job, x, y)] =
                std::bit_cast<float>(samples.key[at(x, y)] ^ depthFlip(job.rules.depthCompare));
        });
    if (job.ids != nullptr)
        forEachPixel(box, [&](int x, int y) {
            const std::uint32_t number = samples.ids[at(x, y)];
            std::int32_t face = -1;
            if (number != kNobody) {
                face = static_cast<std::int32_t>(faceOf(worker.chunkOf(number), worker.source(number)));
            }
            job.ids[pixelIndex(job, x, y)] = face;
        });
    if (job.coverage != nullptr)
        forEachPixel(box, [&](int x, int y) { job.coverage[pixelIndex(job, x, y)] = samples.coverage[at(x, y)]; });
}

void prefetchTile(const FrameJob& job, TileOrigin origin)
{
    constexpr int kPixelsPerLine = 16;
    const PixelBox box = pixelsOf(job, origin);
    for (int y = box.y0; y < box.y1; ++y)
        for (int x = box.x0; x < box.x1; x += kPixelsPerLine)
            __builtin_prefetch(job.color + pixelIndex(job, x, y), 1);
}

void clearTiles(const FrameJob& job, TileOrigin origin, int count)
{
    const PixelBox box = pixelsOf(job, origin, count);
    const std::uint32_t color = job.rules.shading == Shading::Overdraw ? overdrawColor(0) : job.clearColor;
    const auto width = std::size_t(box.x1 - box.x0);
    for (int y = box.y0; y < box.y1; ++y) {
        const std::size_t first = pixelIndex(job, box.x0, y);
        std::fill_n(job.color + first, width, color);
        if (job.depth != nullptr)
            std::fill_n(job.depth + first, width, job.rules.depthClear);
        if (job.ids != nullptr)
            std::fill_n(job.ids + first, width, -1);
        if (job.coverage != nullptr)
            std::fill_n(job.coverage + first, width, std::uint16_t(0));
    }
}

} // namespace rasterlens::tiled
