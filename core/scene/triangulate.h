#pragma once
#include "core/scene/ear_clipper.h"

#include <glm/glm.hpp>

#include <span>
#include <vector>

namespace rasterlens
{

enum class Cut {
    Exact,    ///< the triangles cover the outline, no point twice
    Overlaps, ///< the outline crosses itself, or was given up: parts are covered twice, or what lies outside is
};

/// Cuts a polygon into triangles of its corners, which are numbered from 0.
///
/// in      three corners or more, in order; roughly planar
/// out     corners - 2 triangles of the polygon's winding, appended to `triangles`
/// covers  a convex polygon becomes the fan about corner 0; a concave one is cut ear by ear in the plane of its area
///         vector, also with holes joined to the outline by a bridge; one that crosses itself or has no area gives some
///         triangulation
/// exact   which side of an edge a corner lies on
/// cost    a fan: linear. Ears: in practice corners * log(corners), as only the reflex corners near an ear are looked
///         at, by way of a grid; what is left after a fixed amount of work is fanned
/// source  Meisters, "Polygons have ears", Amer. Math. Monthly 82(6), 1975
Cut triangulate(std::span<const glm::vec3> corners, std::vector<CornerTriple>& triangles);

} // namespace rasterlens
