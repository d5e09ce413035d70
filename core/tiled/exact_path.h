#pragma once
#include "core/settings/depth_rules.h"
#include "core/tiled/frame_job.h"

#include <cstdint>
#include <limits>

namespace rasterlens::tiled
{

// What the vector kernels leave to the scalar stages: vertices outside the view volume, faces to be clipped, needles,
// attributes too steep for float32.

/// The planes of the view volume a vertex is outside of, or kNotFinite.
[[nodiscard]] std::int32_t planesOutside(const FrameJob& job, std::size_t vertex);

/// Takes a face with vertices outside through the scalar stages.
///
/// in   the corners' ScreenXY::y where x is kOutside, else 0
/// out  the triangles to draw, in chunk.clipped; its fate is counted
void processOutsideFace(const FrameJob& job, Chunk& chunk, std::uint32_t face, std::array<std::int32_t, 3> codes);

/// The triangle with everything the scalar stages know of it.
[[nodiscard]] ScreenTriangle screenTriangle(const FrameJob& job, const Chunk& chunk, std::uint32_t source);

/// The face of the mesh behind a triangle.
[[nodiscard]] inline std::uint32_t faceOf(const Chunk& chunk, std::uint32_t source)
{
    return (source & kPiece) != 0 ? chunk.pieces[source & ~kPiece].face : source;
}

/// A tile's first sample.
struct TileOrigin {
    int x;
    int y;
};

/// Coverage and depth of a piece, sample by sample.
///
/// in   number of the triangle in the tile
void coverExactly(const FrameJob& job, const ScreenTriangle& piece, std::uint32_t number, TileOrigin origin,
                  Worker& worker);

/// Colours the samples that a triangle won, one by one.
void shadeExactly(const FrameJob& job, const VisibleTriangle& triangle, const BlockShare& share, TileOrigin origin,
                  TileSamples& samples);

/// The differences of depth keys, new minus stored, with which a sample passes the depth test.
///
/// Each comparison holds for one run of differences, if the smallest number of 32 bits follows the largest: `notequal`
/// for all from 1 round to -1. Differences are moved so that the run begins with the smallest number; then one
/// comparison decides every test.
///
/// exact  keys are 0 to the bits of 1.0F, so no difference wraps round
struct PassingDifferences {
    std::int32_t offset;  ///< taken off the difference
    std::int32_t largest; ///< that then passes

    [[nodiscard]] bool holds(std::int32_t key, std::int32_t stored) const
    {
        const auto bits = [](std::int32_t number) { return static_cast<std::uint32_t>(number); };
        return static_cast<std::int32_t>(bits(key) - bits(stored) - bits(offset)) <= largest;
    }
};

/// The differences with which samples of a face pass.
[[nodiscard]] inline PassingDifferences passingDifferences(const Rules& rules, std::uint32_t face)
{
    constexpr std::int32_t kSmallest = std::numeric_limits<std::int32_t>::min();
    constexpr std::int32_t kLargest = std::numeric_limits<std::int32_t>::max();
    if (!rules.depthTested)
        return {0, kLargest};
    switch (depthCompareOf(rules, face)) {
    case DepthCompare::Less: return {0, -1};
    case DepthCompare::LessEqual: return {0, 0};
    case DepthCompare::Equal: return {kSmallest, kSmallest};
    case DepthCompare::GreaterEqual: return {kSmallest, -1};
    case DepthCompare::Greater: return {kSmallest + 1, -2};
    case DepthCompare::NotEqual: return {kSmallest + 1, kLargest - 1};
    case DepthCompare::Always: break;
    }
    return {0, kLargest};
}

} // namespace rasterlens::tiled
