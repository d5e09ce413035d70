#pragma once
#include "ui/steps/lens_view.h"

namespace rasterlens
{

/// Multi-sampling: the samples of the pixels in sight, which of them the triangle covers, and where each pixel is
/// shaded.
void paintPattern(LensView& view, const LensModel& model);
/// Multi-sampling: what becomes of the present pixel, in words beside it.
void paintPatternWords(LensView& view, const LensModel& model);

/// The mark of a sample that the triangle covers, or of one that it does not.
///
/// in  pens are so many times as thick
void paintSampleMark(QPainter& painter, QPointF at, double radius, bool isCovered, double thickness = 1);
/// The mark of a place where a pixel is shaded; another colour where it lies outside of the triangle.
void paintPlaceMark(QPainter& painter, QPointF at, double arm, bool isOutside, double thickness = 1);

/// What is said of a pixel of the triangle of the model: the mask, where it is shaded, and by which edges its centre
/// is outside. In the language in use.
[[nodiscard]] QStringList patternWords(const LensModel& model, int x, int y);

} // namespace rasterlens
