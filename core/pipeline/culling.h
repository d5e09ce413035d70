#pragma once
#include "core/pipeline/types.h"
#include "core/scene/scene.h"
#include "core/settings/rules.h"

#include <span>

namespace rasterlens
{

/// Twice the signed area of a convex screen polygon, positive for counter-clockwise with y up.
///
/// exact  for snapped positions
[[nodiscard]] double twicePolygonArea(std::span<const ScreenVertex> polygon);

/// det[x y w] of the vertices: six times the signed volume of the triangle and the eye, right even for triangles that
/// cross w = 0. Positive is counter-clockwise with y up.
///
/// source  Olano & Greer, Triangle Scan Conversion using 2D Homogeneous Coordinates, 1997
[[nodiscard]] double clipDeterminant(const ClipTriangle& triangle);

/// clipDeterminant() as if all w were equal: twice the area of x and y in clip space.
[[nodiscard]] double areaWithoutDivide(const ClipTriangle& triangle);

/// Twice the area of x/w and y/w, whatever the signs of w are; not a number where a w is 0.
[[nodiscard]] double areaWithoutClipping(const ClipTriangle& triangle);

/// The face's normal against a direction, positive when a counter-clockwise face turns towards it: the light, or the
/// eye of an orthographic camera.
[[nodiscard]] double directionFacing(const Mesh& mesh, std::uint32_t face, const glm::dvec3& towards);

/// The face's normal against the direction from the eye, positive when a counter-clockwise face looks at the eye.
///
/// in   object space = world space
[[nodiscard]] double viewFacing(const Mesh& mesh, std::uint32_t face, const glm::dvec3& eyeObject);

/// Whether a face with this signed area (or determinant, or facing) is drawn.
///
/// out     Rasterized, or the reason why not
/// source  Direct3D 11.3 functional specification: culling sees snapped positions, zero area draws nothing
[[nodiscard]] FaceFate cull(double signedArea, const Rules& rules);

} // namespace rasterlens
