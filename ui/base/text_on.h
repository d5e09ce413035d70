#pragma once
#include <QColor>

class QPainter;
class QRectF;
class QString;

namespace rasterlens
{

/// How text is written on a surface of one colour, which may be any.
struct InkOn {
    QColor ink;  ///< black or white, whichever stands out more (WCAG 2.1): at least 4.58 to 1
    QColor seam; ///< of the letters, where ink and surface are closer than 7 to 1; else no valid colour
};

[[nodiscard]] InkOn inkOn(QRgb surface);

/// in  flags: of Qt::AlignmentFlag, as QPainter::drawText() takes them
void drawTextOn(QPainter& painter, const QRectF& box, int flags, const QString& text, QRgb surface);

} // namespace rasterlens
