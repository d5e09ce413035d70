#pragma once
#include "ui/canvas/canvas_transform.h"
#include "ui/document/render_worker.h"

#include <QPoint>
#include <QString>
#include <QStringList>

#include <functional>

class QPainter;

namespace rasterlens
{

/// How much there is room for in a pixel of the canvas.
enum class NumberRoom { Hex, Decimals, Details };

/// What the view shows of a pixel as a number, on the first line: its colour; or depth, face, how often it was
/// covered, the normal or the texture coordinates that the colour stands for, where the shading is that. With room for
/// details, face and depth follow. What is not known (yet) is an empty line.
///
/// in   a pixel of the picture
[[nodiscard]] QStringList pixelNumbers(const RenderedFrame& frame, QPoint pixel, NumberRoom room);

/// The lines of one pixel.
using PixelLines = std::function<QStringList(QPoint, NumberRoom)>;

/// Writes lines into pixels: the first at the top, the others from the bottom.
///
/// in  pixels of the picture; from kNumbersFromZoom on
void paintPixelNumbers(QPainter& painter, const QRect& pixels, const CanvasTransform& transform, const QImage& picture,
                       const PixelLines& linesAt);

} // namespace rasterlens
