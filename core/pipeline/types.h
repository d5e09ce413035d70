#pragma once
#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>

namespace rasterlens
{

// One struct for each state of a vertex, one for each state of a triangle. Nothing in here has a constructor that
// writes: a stage fills what it hands on.

constexpr int kMaxVaryings = 12;

/// What the vertex stage hands to the fragments; the shading says which float means what (shading.h).
using Varyings = std::array<float, kMaxVaryings>;

/// Clip space, before the divide. Positions of the vertex stage are float32 values; cuts are computed in double.
struct ClipVertex {
    glm::dvec4 positionClip;
    Varyings varyings;
};

enum class ClipPlane { W, Right, Left, Top, Bottom, Near, Far };

struct ClipTriangle {
    std::array<ClipVertex, 3> vertices;
    std::uint32_t face; ///< index of the face in the mesh
};

/// A line in the plane of a triangle that bounds what clipping leaves of it: an edge of the triangle, or where a clip
/// plane crosses it (triangle_lines.h has the numbers).
using ClipLine = std::uint8_t;

/// A corner of a clipped triangle, as the lines of the two edges that meet there.
struct ClipCorner {
    ClipLine arriving; ///< of the edge from the corner before
    ClipLine leaving;  ///< of the edge to the corner after

    friend bool operator==(const ClipCorner&, const ClipCorner&) = default;
};

/// Convex polygon left of a triangle by clipping.
struct ClipPolygon {
    // Sutherland-Hodgman needs 3 and seven planes; Cohen-Sutherland two points for each of nine edges and four corners.
    static constexpr int kMaxVertices = 22;
    std::array<ClipVertex, kMaxVertices> vertices;
    std::array<ClipCorner, kMaxVertices> corners; ///< what the vertices are without rounding
    std::array<double, kMaxVertices> distances;   ///< to the plane that cuts the polygon next; inside is >= 0
    int count;

    [[nodiscard]] std::span<const ClipVertex> span() const
    {
        return {vertices.data(), static_cast<std::size_t>(count)};
    }
};

/// Screen space, y down, in samples: pixels times the side of the sample grid. With fixed point a multiple of 1/256.
struct ScreenVertex {
    glm::dvec2 position;
    double depth; ///< z/w mapped to 0..1
    double invW;  ///< 1 / w of clip space
    Varyings varyings;
};

struct ScreenTriangle {
    std::array<ScreenVertex, 3> vertices;
    std::uint32_t face;
    double area2;             ///< twice the signed area in samples squared, positive for counter-clockwise with y up
    bool isLine;              ///< from A to B; C is B once more
    std::uint8_t sharedEdges; ///< wireframe: edges that another face draws, bit 0: AB, bit 1: BC, bit 2: CA

    /// Whether the wireframe of the triangle draws the edge from a corner to the next one.
    [[nodiscard]] bool drawsEdge(std::size_t corner) const
    {
        return isLine ? corner == 0 : (sharedEdges >> corner & 1U) == 0;
    }
};

/// Screen-space barycentric weights of the vertices A, B, C; they sum to 1.
using Weights = std::array<double, 3>;

/// One covered sample on its way to the frame buffer.
struct Fragment {
    int x; ///< sample column
    int y; ///< sample row
    std::uint32_t face;
    float depth;     ///< as the buffer stores it
    Weights screen;  ///< barycentric weights on the screen
    Weights weights; ///< the same after perspective correction: what attributes are weighted with
    Varyings varyings;
};

/// How texture coordinates change from a sample to its neighbours.
struct UvGradient {
    glm::vec2 perX{0, 0}; ///< to the right
    glm::vec2 perY{0, 0}; ///< down
};

/// What became of a face. Every submitted face has exactly one fate.
enum class FaceFate { Rejected, CulledBack, CulledFront, Degenerate, NonFinite, Rasterized };

} // namespace rasterlens
