#include "ui/canvas/overlay_inks.h"

#include <QFontMetricsF>

#include <algorithm>

namespace rasterlens
{

QRectF plateOf(const QPainter& painter, const QRect& canvas, QPointF centre, const QString& text)
{
    const QSizeF size = QFontMetricsF(painter.font()).size(0, text) + QSizeF(12, 4);
    QRectF plate(QPointF(0, 0), size);
    plate.moveCenter(centre);
    plate.moveLeft(
        std::clamp(plate.left(), canvas.left() + 1.0, std::max(canvas.left() + 1.0, canvas.right() - size.width())));
    plate.moveTop(
        std::clamp(plate.top(), canvas.top() + 1.0, std::max(canvas.top() + 1.0, canvas.bottom() - size.height())));
    return plate;
}

QRectF paintPlate(QPainter& painter, const QRect& canvas, QPointF centre, const QString& text, QRgb ink)
{
    const QRectF plate = plateOf(painter, canvas, centre, text);
    painter.setPen(QPen(QColor(ink), 1.5));
    painter.setBrush(QColor(kCanvasInk));
    painter.drawRoundedRect(plate, 4, 4);
    painter.setPen(Qt::white);
    painter.drawText(plate, Qt::AlignCenter, text);
    return plate;
}

} // namespace rasterlens
