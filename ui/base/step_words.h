#pragma once
#include "core/base/reason.h"
#include "core/observe/step_log.h"
#include "core/settings/mistakes.h"

#include <QString>
#include <QStringList>

#include <optional>
#include <span>

namespace rasterlens
{

/// What a step says (core/observe/step_text.h), in the language in use and with the signs of printed books.
[[nodiscard]] QString stepWords(const Reason& said);

/// `because of M1 All edges are inclusive`, in the language in use; empty without mistakes.
[[nodiscard]] QString becauseWords(std::span<const Mistake* const> mistakes);

/// `1: (240, 164, 85)  z 0.5`, a line for each sample of a pixel; where a sample counts as black though it is not, the
/// line says so. In the language in use.
[[nodiscard]] QStringList storedWords(const ResolvedPixel& pixel);

/// The mean of the samples of a pixel, a line for each channel: `R = (240 + 240 + 0 + 1) / 4 = 120.25 → 120`.
[[nodiscard]] QStringList meanWords(const ResolvedPixel& pixel);

/// The moment that numbers speak of: `after step 120`, or `finished frame` where there is no step.
[[nodiscard]] QString momentText(const std::optional<std::size_t>& step);

} // namespace rasterlens
