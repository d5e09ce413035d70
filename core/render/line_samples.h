#pragma once
#include "core/pipeline/types.h"
#include "core/settings/rules.h"

#include <glm/glm.hpp>

#include <vector>

namespace rasterlens
{

/// The samples of a line from one point to another by the rules, in the order they are drawn, whether on the target or
/// not.
///
/// in   samples
[[nodiscard]] std::vector<glm::ivec2> lineSamples(const glm::dvec2& from, const glm::dvec2& to, const Rules& rules);

/// A sample whose diamond a line meets, see LineRule::DiamondExit.
struct MetDiamond {
    int column;
    int row;
    double enters; ///< where on the line, as a fraction of the way; 0: it starts within
    double leaves; ///< 1: it ends at the diamond's border or within
    bool drawn;    ///< by the rule, exactly; the fractions are rounded
};

/// The diamonds that a line meets in a part of the picture, row by row.
///
/// in   samples
[[nodiscard]] std::vector<MetDiamond> diamondsOf(const glm::dvec2& from, const glm::dvec2& to, const PixelRect& part);

} // namespace rasterlens
