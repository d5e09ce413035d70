#pragma once
#include "core/base/reason.h"
#include "core/settings/mistakes.h"

#include <QString>

#include <optional>
#include <span>

namespace rasterlens
{

/// What a step says (core/observe/step_text.h), in the language in use and with the signs of printed books.
[[nodiscard]] QString stepWords(const Reason& said);

/// `because of M1 All edges are inclusive`, in the language in use; empty without mistakes.
[[nodiscard]] QString becauseWords(std::span<const Mistake* const> mistakes);

/// The moment that numbers speak of: `after step 120`, or `finished frame` where there is no step.
[[nodiscard]] QString momentText(const std::optional<std::size_t>& step);

} // namespace rasterlens
