#pragma once
#include "core/base/reason.h"
#include "core/observe/step_log.h"

#include <span>
#include <vector>

namespace rasterlens
{

/// The mistakes of a record because of which an event is not what it would be by the right rules, from the same
/// numbers that came in: another verdict, or another number.
///
/// covers  what can be seen in the event itself. Samples of lines that a mistake leaves out have no event: the triangle
///         they belong to is named instead, and the decision that would have led to the end of a line
/// cost    that of the event's stage for one vertex, triangle or sample
[[nodiscard]] std::vector<const Mistake*> becauseOf(const StepLog& log, std::size_t i);

/// `because of M1 All edges are inclusive`, a text of the context "Steps" with titles of the context "Mistake"; empty
/// without mistakes.
[[nodiscard]] Reason becauseText(std::span<const Mistake* const> mistakes);

} // namespace rasterlens
