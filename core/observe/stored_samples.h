#pragma once
#include "core/observe/step_cursor.h"

namespace rasterlens
{

/// What the samples of a pixel store at the cursor's position, in the order of the grid or the pattern; no mean.
[[nodiscard]] ResolvedPixel storedSamples(const StepCursor& cursor, int x, int y);

} // namespace rasterlens
