#pragma once
#include "core/observe/step_log.h"

#include <QString>

#include <array>

namespace rasterlens
{

/// The loop of Bresenham's lines in the octant of the line that a step belongs to, in two lines; that of the first
/// octant where the step belongs to none.
[[nodiscard]] std::array<QString, 2> bresenhamCode(const StepLog& log, std::size_t i);

} // namespace rasterlens
