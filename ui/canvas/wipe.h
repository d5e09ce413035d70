#pragma once
#include "ui/canvas/canvas_transform.h"
#include "ui/document/render_worker.h"

class QPainter;

namespace rasterlens
{

/// Another picture of the same size in the left part of the canvas.
struct Wipe {
    FramePtr left;
    double at = 0.5; ///< where it ends, as a fraction of the picture's width
};

/// The column of the canvas a wipe divides it at: as near to its place in the picture as leaves it in sight.
[[nodiscard]] double wipeColumn(const Wipe& wipe, const QRect& canvas, const CanvasTransform& transform,
                                int imageWidth);

/// The dividing line with its grip and the names A and B on either side.
void paintWipe(QPainter& painter, const QRect& canvas, const QRectF& picture, double column, bool thick);

/// The name of the picture that is shown, in the lower left corner.
void paintTag(QPainter& painter, const QRect& canvas, const QString& text);

} // namespace rasterlens
