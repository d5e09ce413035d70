#pragma once
#include "core/observe/step_log.h"

#include <QString>

namespace rasterlens
{

/// What a step decides, as one sentence for a lecture: `Pixel (7, 0) lies exactly on BC; BC is neither a left nor a top
/// edge of face 0, so face 0 does not draw it.` Where a mistake makes the difference the sentence ends with its name.
/// In the language in use.
///
/// in  event number
[[nodiscard]] QString stepSentence(const StepLog& log, std::size_t i);

} // namespace rasterlens
