#pragma once
#include "ui/steps/lens_view.h"

namespace rasterlens
{

/// Lines by the diamond rule: the diamonds that the lines of the triangle meet, where each line enters and leaves them,
/// and which it leaves, so that their pixels are drawn.
void paintDiamonds(LensView& view, const LensModel& model);

/// What the lines of the triangle of the model do in the diamond of a sample, a sentence for each that meets it. In the
/// language in use.
[[nodiscard]] QStringList diamondWords(const LensModel& model, int x, int y);

} // namespace rasterlens
