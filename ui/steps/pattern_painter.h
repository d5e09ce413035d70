#pragma once
#include "ui/steps/lens_view.h"

namespace rasterlens
{

/// Multi-sampling: the samples of the pixels in sight, which of them the triangle covers, where each pixel is shaded,
/// and in words what becomes of the present one.
void paintPattern(LensView& view, const LensModel& model);

/// What is said of a pixel of the triangle of the model: the mask, where it is shaded, and by which edges its centre
/// is outside. In the language in use.
[[nodiscard]] QStringList patternWords(const LensModel& model, int x, int y);

} // namespace rasterlens
