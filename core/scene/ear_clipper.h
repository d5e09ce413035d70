#pragma once
#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rasterlens
{

/// The corners of a triangle, numbered as in the polygon that it is cut from.
using CornerTriple = std::array<std::uint32_t, 3>;

/// Cuts a simple polygon, counter-clockwise, ear by ear. See triangulate().
///
/// out   as many triangles as corners less two, the last ones a fan where no ear was found
void clipEars(std::span<const glm::dvec2> points, std::vector<CornerTriple>& triangles);

} // namespace rasterlens
