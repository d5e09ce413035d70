#pragma once
#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rasterlens
{

using CornerTriple = std::array<std::uint32_t, 3>;

/// Cuts a polygon into triangles of its corners, which are numbered from 0.
///
/// in      three corners or more, in order; roughly planar
/// out     corners - 2 triangles of the polygon's winding, appended to `triangles`
/// covers  a convex polygon becomes the fan about corner 0; a concave one is cut ear by ear in the plane of its area
///         vector; one that crosses itself or has no area gives some triangulation
/// cost    a fan: linear. Ears: corners * reflex corners as a rule; what is left after a fixed amount of work is fanned
/// source  Meisters, "Polygons have ears", Amer. Math. Monthly 82(6), 1975
void triangulate(std::span<const glm::vec3> corners, std::vector<CornerTriple>& triangles);

} // namespace rasterlens
