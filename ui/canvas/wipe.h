#pragma once
#include "ui/canvas/pixel_overlay.h"

namespace rasterlens
{

/// The column of the canvas a wipe divides it at: as near to its place in the picture as leaves it in sight.
[[nodiscard]] double wipeColumn(const Wipe& wipe, const QRect& canvas, const CanvasTransform& transform,
                                int imageWidth);

/// The dividing line with its grip and the names A and B on either side.
void paintWipe(QPainter& painter, const QRect& canvas, double column, bool thick);

/// The name of the picture that is shown, in the lower left corner.
void paintTag(QPainter& painter, const QRect& canvas, const QString& text);

} // namespace rasterlens
