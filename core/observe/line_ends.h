#pragma once
#include "core/observe/step_log.h"

#include <array>
#include <optional>

namespace rasterlens
{

/// The line of a triangle that a decision belongs to.
struct LineOfTriangle {
    std::size_t edge;               ///< from vertex 0, 1, 2 to the one after it
    std::array<glm::ivec2, 2> ends; ///< in samples, in the order in which they are drawn
};
[[nodiscard]] std::optional<LineOfTriangle> lineOf(const ScreenTriangle& triangle, const LineDecision& decision,
                                                   const Rules& rules);

/// The decision that follows a sample of a line or, after its last sample, the one before; null where there is none.
///
/// in  the number of an event
[[nodiscard]] const StepEvent* decisionAt(const StepLog& log, std::size_t i);

} // namespace rasterlens
