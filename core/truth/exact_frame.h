#pragma once
#include "core/settings/rules.h"
#include "core/settings/sample_pattern.h"

#include <QSize>
#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace rasterlens
{

/// The planes that faces are cut by, besides near and far: |x| <= sideX * w, |y| <= sideY * w, w >= smallestW. Cut
/// corners snap where these planes are: a guard band has others than the view volume.
struct ExactSides {
    double sideX = 1;
    double sideY = 1;
    double smallestW = 0; ///< 0: no such plane
    bool nearFar = true;  ///< false: nothing is cut at near and far
};

/// What the exact reference is asked for. Default-constructed = what a correct rasterizer with 24.8 fixed point draws.
struct ExactOptions {
    QSize size{256, 256}; ///< viewport in pixels, 1..16384 each
    bool snap = true;     ///< false: vertices stay where they are (`exact` in case files)
    int subpixelBits = 8; ///< 0..8; vertices snap to 1/2^bits pixel, half to even
    ClipZ clipZ = ClipZ::Gl;
    ExactSides sides; ///< of snapped frames; without snapping none but nearFar changes what is visible
    Culling culling = Culling::None;
    Winding winding = Winding::CounterClockwise;
    DepthCompare depthCompare = DepthCompare::Less;
    double depthClear = 1;   ///< of unorm formats the value of a code
    bool depthTested = true; ///< false: a renderer need not keep depths; the truth's are those of the winners
    /// The faces of the span before this one are compared by this; the others, by depthCompare.
    std::size_t firstPassFaces = 0;
    DepthCompare firstPassCompare = DepthCompare::Less;
    DepthRange depthRange;                          ///< near and far come to lie there, and depths are held within it
    DepthBias depthBias;                            ///< of the faces that are not of the first pass
    DepthFormat depthFormat = DepthFormat::Float32; ///< Float32: compared exactly; unorm: nearest code, half to even
    int sampleGrid = 1;        ///< 1..4 samples a pixel along each axis; vertices still snap to pixels
    int patternSamples = 1;    ///< multi-sampling: 2, 4, 8 or 16 samples a pixel; the sample grid is 1 then
    SampleOffset offset{0, 0}; ///< of all samples from the centres of theirs, on a sample grid of 1 only
    ResolveLight resolveLight = ResolveLight::Gamma;
    std::optional<PixelRect> window; ///< the part of the viewport to compute
    /// Not Centre: for snapped frames of one sample a pixel only. Each triangle that clipping leaves is asked by
    /// itself.
    CoverageRule coverageRule = CoverageRule::Centre;
    /// Faces that are lines, ascending: from the first corner to the second. They snap in frames that snap nothing
    /// else, to 1/256 pixel; nothing culls or biases them, and samples of a pattern have none.
    std::vector<std::uint32_t> lines;
    LineRule lineRule = LineRule::Inclusive;
    bool lineTiesByDirection = true;
    bool edgeDistance = false; ///< fill ExactFrame::edgeDistance
    bool textured = false;     ///< fill ExactFrame::uv: the varyings of the triangles are those of Shading::Texture
    /// Given: the triangles' positions lie in object space, and clip space is their exact product with this matrix.
    std::optional<glm::dmat4> clipFromObject{};
};

/// Texture coordinates at a sample, and how they change to the next sample.
struct ExactUv {
    glm::dvec2 place{0, 0};
    glm::dvec2 perColumn{0, 0}; ///< to the right; 0 on a line
    glm::dvec2 perRow{0, 0};    ///< down; 0 on a line
};

/// The truth about a picture. Arrays are row by row from the top, one entry a sample; with a pattern the arrays of its
/// samples follow each other.
struct ExactFrame {
    PixelRect window;   ///< the part of the viewport the arrays hold
    int sampleGrid = 1; ///< samples a pixel along each axis
    int patternSamples = 1;
    glm::dvec2 offset{0, 0}; ///< of the samples from the centres of theirs, in pixels
    ResolveLight resolveLight = ResolveLight::Gamma;
    int width = 0;  ///< samples: window.width * sampleGrid
    int height = 0; ///< samples: window.height * sampleGrid

    bool depthTested = true; ///< as asked for

    std::vector<std::uint32_t> cover; ///< how many faces cover the sample, before the depth test
    std::vector<std::int32_t> id;     ///< face that won the depth test, -1 none
    std::vector<double> depth;     ///< its depth 0..1 (unorm formats: the stored code's value); depthClear where none
    std::vector<glm::dvec3> color; ///< its colour, not clamped; 0 where none
    std::vector<ExactUv> uv;       ///< of that face; empty unless asked for
    /// Pixels to the nearest edge of the clipped, unsnapped faces that are drawn, where that is below kEdgeBandPixels;
    /// empty unless asked for (edge_distance.h).
    std::vector<float> edgeDistance;

    int nonFinite = 0;       ///< faces dropped because a position is NaN or infinite
    int culled = 0;          ///< faces dropped by their facing
    int degenerate = 0;      ///< faces without area that were inside the view volume
    int outside = 0;         ///< faces wholly outside the view volume (snapped frames only)
    int maxClipVertices = 3; ///< most corners a clipped face had (snapped frames only)

    /// The sample nearest the centre of a pixel of the window (the lower right of the middle four of an even grid, the
    /// first of a pattern).
    [[nodiscard]] std::size_t sampleNearestCentre(int x, int y) const;
    /// The mean of a pixel's samples over a background, each channel held within 0..1, each shaded at its own place.
    [[nodiscard]] glm::dvec3 pixelColor(int x, int y, glm::vec3 background) const;
};

} // namespace rasterlens
