#pragma once
#include "core/scene/scene.h"

#include <QString>
#include <glm/glm.hpp>

#include <array>
#include <cstdint>

namespace rasterlens
{

/// A corner of a face in every space, not clipped.
struct VertexRow {
    std::uint32_t meshVertex = 0;
    glm::dvec4 object{0};
    QString world;      ///< x, y, z in the coordinates of the file, where the mesh has an origin of its own; else empty
    glm::dvec4 view{0}; ///< as `object` in clip-space scenes
    glm::dvec4 clip{0};
    glm::dvec3 ndc{0};         ///< clip / w; not finite where w is 0
    glm::dvec2 screen{0};      ///< pixels, y down
    glm::dvec2 snapped{0};     ///< pixels, on the subpixel grid of the settings; as `screen` in floating point
    double depth = 0;          ///< 0..1 inside
    std::uint32_t outside = 0; ///< planes of the view volume it is outside of, one bit a ClipPlane
    unsigned screenRegion = 0; ///< Cohen-Sutherland outcode: bits kRegionLeft, kRegionRight, kRegionBelow, kRegionAbove
};

/// The three corners of a face.
///
/// in     a face of the mesh
/// exact  clip and snapped are what render() computes
[[nodiscard]] std::array<VertexRow, 3> vertexTable(const Scene& scene, const Settings& settings, std::uint32_t face);

/// Whether a corner lies in front of the eye: w, its distance, is a positive number.
[[nodiscard]] bool isBeforeEye(const VertexRow& corner);
/// The edge whose ends lie most unequally far away, the one with the most to correct; the first of equal ones. Edge i
/// leads from corner i to the next.
[[nodiscard]] int mostUnequalEdge(const std::array<VertexRow, 3>& corners);

} // namespace rasterlens
