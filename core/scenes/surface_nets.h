#pragma once
#include "core/scenes/shapes.h"

#include <functional>

namespace rasterlens
{

/// A grid of cells, which may be finer in one place than in another.
struct CellGrid {
    glm::ivec3 cells{20, 20, 20};
    std::function<glm::dvec3(glm::dvec3)> place; ///< object space of a grid point; every axis for itself, increasing
    double smallestCell = 0.1;                   ///< shortest side of a cell
};

/// The surface where `distance` is zero, as a closed mesh (naive surface nets).
///
/// in      distance: negative inside, positive outside and on the border of the grid; colorAt: of a point of the
/// surface out     a corner in every cell the surface crosses, normals from the gradient, front outside order   faces
/// from the largest z to the smallest source  S. F. Gibson, Constrained Elastic Surface Nets, MICCAI 1998
[[nodiscard]] Mesh surfaceNets(const CellGrid& grid, const std::function<double(glm::dvec3)>& distance,
                               const std::function<glm::vec3(glm::dvec3)>& colorAt);

} // namespace rasterlens
