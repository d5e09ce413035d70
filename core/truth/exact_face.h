#pragma once
#include "core/truth/exact_frame.h"
#include "core/truth/exact_geometry.h"

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <vector>

// One face of the exact reference. A part of exact_reference.cpp, which alone includes this header.

namespace rasterlens::exact
{

/// One triangle to interpolate over: three weights that are >= 0 inside and as the perspective-correct ones to each
/// other.
struct Piece {
    std::array<Linear, 3> weights;
    Linear depthNumerator;
    Integer depthDenominator; // > 0
    Linear nearSide;          // >= 0 behind the near plane, and everywhere where it cuts nothing
    Linear farSide;           // >= 0 before the far plane
    std::array<glm::dvec3, 3> colors;
    std::array<glm::dvec2, 3> uvs;
    std::int32_t face;
    bool isLine;
};

/// Which piece of which triangle of the submitted ones.
struct PieceIndex {
    std::int32_t triangle = -1; ///< -1: none
    std::int32_t piece = 0;     ///< of its fan
};

/// A face on the screen.
struct Outline {
    enum class Fate { Drawn, Outside, Degenerate, Culled };

    Fate fate = Fate::Drawn;
    int sign = 0;                      ///< of its area on the screen, y down
    std::vector<ScreenCorner> corners; ///< clipped and snapped where faces are
    std::vector<Snapped> polygon;      ///< the same corners on the lattice; empty where nothing snaps
    std::vector<glm::dvec2> trueEdges; ///< clipped corners before snapping, in pixels; empty unless asked for
    std::vector<ScreenCorner> left;    ///< of unsnapped faces: what clipping leaves, where a depth bias asks for it
    int clippedCorners = 0;            ///< 0 where nothing is clipped
    std::int32_t face = 0;
};

/// A face that is a line, on the screen.
struct Segment {
    struct Sample {
        int column;
        int row;
        int piece; ///< where its depth and colour are told
    };

    Outline::Fate fate = Outline::Fate::Drawn;
    std::vector<Piece> pieces;   ///< along the line, at its start and at its end
    std::vector<Sample> samples; ///< in the order of the way or against it, also those beyond the window
};

/// Makes outlines of faces and pieces of outlines: always the same ones of the same face.
class FaceSetup
{
public:
    explicit FaceSetup(const ExactOptions& options);

    [[nodiscard]] const Lattice& lattice() const { return m_lattice; }

    /// in   finite positions
    [[nodiscard]] Outline outlineOf(const ClipTriangle& triangle) const;
    /// The triangles round the first corner.
    ///
    /// in   an outline whose fate is to be drawn
    [[nodiscard]] std::vector<Piece> fanOf(const Outline& outline) const;

    /// Whether a face is a line.
    [[nodiscard]] bool isLine(std::uint32_t face) const;
    /// A line with its ends clipped and snapped.
    ///
    /// in   finite positions
    [[nodiscard]] Segment segmentOf(const ClipTriangle& triangle) const;
    /// What the samples of a face are told by: the pieces of its segment if it is a line, else the fan of its outline.
    ///
    /// in   a face whose fate is to be drawn
    [[nodiscard]] std::vector<Piece> piecesOf(const ClipTriangle& triangle) const;

private:
    [[nodiscard]] Outline unsnappedOutline(const ClipTriangle& triangle, const IntegerTriangle& integers) const;
    [[nodiscard]] Outline snappedOutline(const ClipTriangle& triangle, const IntegerTriangle& integers) const;
    [[nodiscard]] std::vector<ScreenCorner> screenPolygon(std::span<const Corner> clipped,
                                                          const ClipTriangle& triangle) const;
    [[nodiscard]] std::vector<glm::dvec2> pixelsOf(const std::vector<ScreenCorner>& polygon) const;
    [[nodiscard]] Outline::Fate fateOf(int areaSign) const;
    [[nodiscard]] Piece pieceOf(const std::array<ScreenCorner, 3>& corners, const Integer& det,
                                std::int32_t face) const;
    [[nodiscard]] bool isBiased(std::int32_t face) const;
    [[nodiscard]] double biasOf(const Outline& outline) const;
    [[nodiscard]] Piece pieceAlong(const std::array<ScreenCorner, 2>& ends, const Linear& top, const Integer& bottom,
                                   std::int32_t face) const;
    void finishDepth(Piece& piece) const;
    void toDepthRange(Piece& piece) const;

    const ExactOptions& m_options;
    Lattice m_lattice;
};

} // namespace rasterlens::exact
