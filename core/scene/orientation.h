#pragma once
#include <glm/glm.hpp>

namespace rasterlens
{

/// Twice the signed area of a triangle, positive if it is counter-clockwise.
///
/// exact   the sign always; the value to within a few units of the last place
/// source  Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric predicates", 1997: the
///         error bound of his ccwerrboundA, and sums of exact products where that does not decide
[[nodiscard]] double orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c);

} // namespace rasterlens
