#pragma once
#include "core/tiled/frame_job.h"

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

/// What the bits of a depth are xored with in a tile, so that smaller is nearer.
[[nodiscard]] inline std::int32_t depthFlip(DepthCompare compare)
{
    return compare == DepthCompare::Greater || compare == DepthCompare::GreaterEqual
               ? std::numeric_limits<std::int32_t>::max()
               : 0;
}

/// What is taken off a depth before it is compared: 0 lets smaller ones pass, 1 equal ones too, more any.
[[nodiscard]] inline std::int32_t depthHandicap(const Rules& rules)
{
    if (!rules.depthTested)
        return 1 << 30;
    switch (rules.depthCompare) {
    case DepthCompare::Less:
    case DepthCompare::Greater: return 0;
    case DepthCompare::LessEqual:
    case DepthCompare::GreaterEqual: return 1;
    case DepthCompare::Equal: // these two are not supported
    case DepthCompare::NotEqual:
    case DepthCompare::Always: break;
    }
    return 1 << 30;
}

} // namespace rasterlens::tiled
