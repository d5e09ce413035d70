#pragma once
#include "core/scenes/shapes.h"

#include <functional>

namespace rasterlens
{

/// A box of cubic cells.
struct CellBox {
    glm::dvec3 low{-1, -1, -1};
    double cell = 0.1;
    glm::ivec3 cells{20, 20, 20};
};

/// The surface where `distance` is zero, as a closed mesh (naive surface nets).
///
/// in      distance: negative inside, positive outside and on the border of the box; colorAt: of a point of the surface
/// out     a corner in every cell the surface crosses, normals from the gradient, front outside
/// order   faces from the largest z to the smallest
/// source  S. F. Gibson, Constrained Elastic Surface Nets, MICCAI 1998
[[nodiscard]] Mesh surfaceNets(const CellBox& box, const std::function<double(glm::dvec3)>& distance,
                               const std::function<glm::vec3(glm::dvec3)>& colorAt);

} // namespace rasterlens
