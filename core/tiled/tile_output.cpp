#include "core/tiled/tile_output.h"

#include "core/pipeline/shading.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace rasterlens::tiled
{
namespace
{

/// With one sample a pixel: the four rows of four blocks side by side, which are 16 pixels each.
template <class T>
void copySubtileRow(const T* blocks, T* out, std::size_t stride)
{
    for (std::size_t y = 0; y < kBlockSide; ++y)
        for (std::size_t block = 0; block < 4; ++block)
            std::memcpy(out + y * stride + block * kBlockSide, blocks + block * kLanes + y * kBlockSide,
                        kBlockSide * sizeof *out);
}

/// With one sample a pixel: an array of samples into the rows of `pixels`.
template <class T>
void copySamples(const FrameJob& job, const T* samples, const PixelBox& box, T* pixels)
{
    const int width = box.x1 - box.x0;
    const int height = box.y1 - box.y0;
    const auto stride = static_cast<std::size_t>(job.rules.width);
    for (int y = 0; y < height; y += kBlockSide)
        for (int x = 0; x < width; x += 4 * kBlockSide) {
            T* out = pixels + pixelIndex(job, box.x0 + x, box.y0 + y);
            if (x + 4 * kBlockSide <= width && y + kBlockSide <= height) {
                copySubtileRow(samples + sampleIndex(x, y), out, stride);
                continue;
            }
            for (int j = 0; j < std::min(kBlockSide, height - y); ++j)
                for (int i = 0; i < std::min(4 * kBlockSide, width - x); ++i)
                    out[std::size_t(j) * stride + std::size_t(i)] = samples[sampleIndex(x + i, y + j)];
        }
}

/// The mean of a pixel's samples, channel by channel, rounded to nearest; (x, y) is the first of them, at `first`.
template <int kGrid>
std::uint32_t meanColor(const TileSamples& samples, int x, int y, int first)
{
    constexpr std::uint32_t kCount = kGrid * kGrid;
    std::uint32_t redBlue = kCount / 2 * 0x10001; // two sums in one number
    std::uint32_t green = kCount / 2;
    for (int j = 0; j < kGrid; ++j)
        for (int i = 0; i < kGrid; ++i) {
            // 2 x 2 and 4 x 4 samples lie in one block.
            const int at = kGrid == 3 ? sampleIndex(x + i, y + j) : first + j * kBlockSide + i;
            const std::uint32_t c = samples.color[static_cast<std::size_t>(at)];
            redBlue += c & 0xff00ffU;
            green += c >> 8 & 0xffU;
        }
    return 0xff000000U | (redBlue >> 16) / kCount << 16 | green / kCount << 8 | (redBlue & 0xffffU) / kCount;
}

std::size_t pixelCount(const FrameJob& job) { return std::size_t(job.rules.width) * std::size_t(job.rules.height); }

template <class Write>
void forEachPixel(const PixelBox& box, Write&& write)
{
    for (int y = box.y0; y < box.y1; ++y)
        for (int x = box.x0; x < box.x1; ++x)
            write(x, y);
}

template <int kGrid>
void averageColor(const FrameJob& job, const Worker& worker, TileOrigin origin)
{
    forEachPixel(pixelsOf(job, origin), [&](int x, int y) {
        const int column = x * kGrid - origin.x;
        const int row = y * kGrid - origin.y;
        const int first = sampleIndex(column, row);
        if ((worker.resolvedSubtiles >> (first / (kLanes * kLanes)) & 1) == 0)
            job.color[pixelIndex(job, x, y)] = meanColor<kGrid>(worker.samples, column, row, first);
    });
}

} // namespace

void writeBlocks(const FrameJob& job, TileOrigin origin, int firstBlock, const std::uint32_t* colors)
{
    const int x = origin.x + blockColumn(firstBlock) * kBlockSide;
    const int y = origin.y + blockRow(firstBlock) * kBlockSide;
    const int width = std::min(4 * kBlockSide, job.rules.width - x);
    const int height = std::min(kBlockSide, job.rules.height - y);
    if (width <= 0 || height <= 0)
        return;
    std::uint32_t* out = job.color + pixelIndex(job, x, y);
    const auto stride = static_cast<std::size_t>(job.rules.width);
    if (width == 4 * kBlockSide && height == kBlockSide) {
        copySubtileRow(colors, out, stride);
        return;
    }
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i)
            out[std::size_t(j) * stride + std::size_t(i)] =
                colors[i / kBlockSide * kLanes + j * kBlockSide + i % kBlockSide];
}

PixelBox pixelsOf(const FrameJob& job, TileOrigin origin, int tiles)
{
    const int grid = job.rules.sampleGrid;
    const int side = job.grid.pitch / grid;
    const int x = origin.x / grid;
    const int y = origin.y / grid;
    return {x, y, std::min(x + side * tiles, job.rules.width), std::min(y + side, job.rules.height)};
}

void averageColor(const FrameJob& job, const Worker& worker, TileOrigin origin)
{
    switch (job.rules.sampleGrid) {
    case 2: averageColor<2>(job, worker, origin); break;
    case 3: averageColor<3>(job, worker, origin); break;
    default: averageColor<4>(job, worker, origin);
    }
}

void copyColor(const FrameJob& job, const TileSamples& samples, TileOrigin origin)
{
    copySamples(job, samples.color.data(), pixelsOf(job, origin), job.color);
}

void writeTile(const FrameJob& job, const Worker& worker, TileOrigin origin)
{
    const TileSamples& samples = worker.samples;
    const PixelBox box = pixelsOf(job, origin);
    const int grid = job.rules.sampleGrid;
    const bool isPattern = job.pattern.isOn();
    const std::int32_t* keys = isPattern ? worker.pattern.key.data() : samples.key.data();
    const std::uint32_t* ids = isPattern ? worker.pattern.ids.data() : samples.ids.data();
    const std::uint16_t* coverage = isPattern ? worker.pattern.coverage.data() : samples.coverage.data();
    // The sample nearest the pixel's centre; of a pattern the first.
    const auto at = [&](int x, int y) {
        const auto sample = std::size_t(sampleIndex(x * grid + grid / 2 - origin.x, y * grid + grid / 2 - origin.y));
        return isPattern ? job.pattern.place(sample, 0) : sample;
    };
    if (job.depth != nullptr && grid == 1 && !isPattern)
        copySamples(job, samples.key.data(), box, reinterpret_cast<std::int32_t*>(job.depth));
    else if (job.depth != nullptr)
        forEachPixel(box,
                     [&](int x, int y) { job.depth[pixelIndex(job, x, y)] = std::bit_cast<float>(keys[at(x, y)]); });
    if (job.ids != nullptr)
        forEachPixel(box, [&](int x, int y) {
            const std::uint32_t number = ids[at(x, y)];
            std::int32_t face = -1;
            if (number != kNobody) {
                face = static_cast<std::int32_t>(faceOf(worker.chunkOf(number), worker.triangle(number).source));
            }
            job.ids[pixelIndex(job, x, y)] = face;
        });
    if (job.coverage != nullptr)
        forEachPixel(box, [&](int x, int y) { job.coverage[pixelIndex(job, x, y)] = coverage[at(x, y)]; });
    for (std::size_t s = 0; job.sampleCoverage != nullptr && s < job.pattern.samples; ++s)
        forEachPixel(box, [&](int x, int y) {
            const auto pixel = std::size_t(sampleIndex(x - origin.x, y - origin.y));
            job.sampleCoverage[s * pixelCount(job) + pixelIndex(job, x, y)] = coverage[job.pattern.place(pixel, s)];
        });
}

void prefetchTile(const FrameJob& job, TileOrigin origin)
{
    constexpr int kPixelsPerLine = 16;
    const PixelBox box = pixelsOf(job, origin);
    for (int y = box.y0; y < box.y1; ++y)
        for (int x = box.x0; x < box.x1; x += kPixelsPerLine) {
            if (job.color != nullptr)
                __builtin_prefetch(job.color + pixelIndex(job, x, y), 1);
            if (job.depth != nullptr)
                __builtin_prefetch(job.depth + pixelIndex(job, x, y), 1);
        }
}

void clearTiles(const FrameJob& job, TileOrigin origin, int count)
{
    const PixelBox box = pixelsOf(job, origin, count);
    const auto width = std::size_t(box.x1 - box.x0);
    for (int y = box.y0; y < box.y1; ++y) {
        const std::size_t first = pixelIndex(job, box.x0, y);
        if (job.color != nullptr)
            std::fill_n(job.color + first, width, job.emptyColor);
        if (job.depth != nullptr)
            std::fill_n(job.depth + first, width, job.rules.depthClear);
        if (job.ids != nullptr)
            std::fill_n(job.ids + first, width, -1);
        if (job.coverage != nullptr)
            std::fill_n(job.coverage + first, width, std::uint16_t(0));
        for (std::size_t s = 0; job.sampleCoverage != nullptr && s < job.pattern.samples; ++s)
            std::fill_n(job.sampleCoverage + s * pixelCount(job) + first, width, std::uint16_t(0));
    }
}

} // namespace rasterlens::tiled
