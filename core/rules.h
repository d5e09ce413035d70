#pragma once
#include "core/settings.h"

#include <glm/glm.hpp>

#include <cstdint>

namespace rasterlens
{

enum class DepthCompare { Less, LessEqual, Greater, GreaterEqual, Always };

/// What the stages read: Settings resolved into numbers and enumerations. Default-constructed = correct graphics.
/// A mistake is a wrong value in here; no stage knows about mistakes.
struct Rules {
    // Vertex stage and shading
    Shading shading = Shading::Gouraud;
    TextureFilter textureFilter = TextureFilter::Nearest;
    bool lit = true;
    int varyingCount = 3;     ///< floats a vertex hands to the fragments; what no shader reads is not carried
    bool mirrorClipZ = false; ///< reversed z for a scene that brings its own clip coordinates

    // Clipping
    Clipping clipping = Clipping::Frustum;
    ClipZ clipZ = ClipZ::Gl;

    // Viewport
    int width = 0;      ///< pixels
    int height = 0;     ///< pixels
    int sampleGrid = 1; ///< samples a pixel along each axis
    NumberType numberType = NumberType::Fixed;
    int subpixelBits = 8; ///< fixed point only: vertices snap to 1/2^bits pixel

    // Culling
    Culling culling = Culling::Back;
    CullSpace cullSpace = CullSpace::Screen;
    double frontSign = 1; ///< +1: counter-clockwise with y up is front, -1: clockwise

    // Coverage
    Algorithm algorithm = Algorithm::EdgeEquation;
    Stepping stepping = Stepping::Incremental;
    Fill fill = Fill::Solid;
    LineAlgorithm line = LineAlgorithm::Bresenham;
    /// The smallest edge value that counts as inside, in units of the last place: for an edge that owns its points and
    /// for one that does not. Top-left {0, 1}, inclusive {0, 0}, exclusive {1, 1}.
    struct TieThresholds {
        int owner = 0;
        int other = 1;
    } tie;

    // Depth
    bool painter = false;    ///< faces from far to near
    bool depthTested = true; ///< false: every fragment passes, and depth is kept only if someone asks for it
    DepthCompare depthCompare = DepthCompare::Less;
    float depthClear = 1;
    DepthFormat depthFormat = DepthFormat::Float32;
    bool depthBeforeShading = true;

    // Interpolation
    bool perspectiveCorrect = true;
    AttributePath attributePath = AttributePath::Planes;

    [[nodiscard]] int columns() const { return width * sampleGrid; } ///< samples
    [[nodiscard]] int rows() const { return height * sampleGrid; }   ///< samples
};

struct Scene;

/// Resolves the settings for a scene. The mistakes of the settings are applied last.
[[nodiscard]] Rules rulesFor(const Scene& scene, const Settings& settings);

} // namespace rasterlens
