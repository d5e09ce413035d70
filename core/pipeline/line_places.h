#pragma once
#include "core/settings/rules.h"

#include <glm/glm.hpp>

#include <cmath>
#include <cstdlib>

namespace rasterlens
{

/// A sample of the grid.
struct GridPoint {
    int x;
    int y;
};

/// The octant the way from one sample to another lies in, 0..7 counter-clockwise from the direction of x with y up.
[[nodiscard]] inline int octantOf(GridPoint from, GridPoint to)
{
    const int dx = to.x - from.x;
    const int dy = from.y - to.y;
    const bool steep = std::abs(dy) > std::abs(dx);
    if (dy >= 0)
        return dx >= 0 ? (steep ? 1 : 0) : (steep ? 2 : 3);
    return dx < 0 ? (steep ? 5 : 4) : (steep ? 6 : 7);
}

/// The sample that holds a point of the screen.
[[nodiscard]] inline GridPoint sampleOf(const glm::dvec2& position, GridRounding rounding = GridRounding::Floor)
{
    if (rounding == GridRounding::TowardsZero)
        return {static_cast<int>(position.x), static_cast<int>(position.y)};
    return {static_cast<int>(std::floor(position.x)), static_cast<int>(std::floor(position.y))};
}

} // namespace rasterlens
