#pragma once
#include "core/settings/mistakes.h"
#include "core/settings/step_kind.h"

namespace rasterlens
{

/// The steps that the wrong line of a mistake is run at.
///
/// in   one of mistakes()
[[nodiscard]] StepKinds stepsOf(const Mistake& mistake);

} // namespace rasterlens
