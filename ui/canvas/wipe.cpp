#include "ui/canvas/wipe.h"

#include "ui/base/inks.h"
#include "ui/base/theme.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr double kMargin = 10;

void paintPill(QPainter& painter, QPointF topLeft, const QString& text)
{
    const QFontMetricsF metrics(painter.font());
    const double height = metrics.height() + 4;
    const QRectF pill(topLeft, QSizeF(std::max(height, metrics.horizontalAdvance(text) + 14), height));
    painter.setPen(QPen(Qt::white, 1));
    painter.setBrush(QColor(kCanvasInk));
    painter.drawRoundedRect(pill, 5, 5);
    painter.drawText(pill, Qt::AlignCenter, text);
}

} // namespace

double wipeColumn(const Wipe& wipe, const QRect& canvas, const CanvasTransform& transform, int imageWidth)
{
    const double column = transform.toCanvas(QPointF(wipe.at * imageWidth, 0)).x();
    const double low = canvas.left() + kMargin;
    const double high = canvas.right() - kMargin;
    return low < high ? std::round(std::clamp(column, low, high)) : column;
}

void paintWipe(QPainter& painter, const QRect& canvas, const QRectF& picture, double column, bool thick)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    const double width = thick ? 4 : 2;
    painter.fillRect(QRectF(column - width / 2 - 1, canvas.top(), width + 2, canvas.height()), QColor(kCanvasInk));
    painter.fillRect(QRectF(column - width / 2, canvas.top(), width, canvas.height()), Qt::white);
    const double radius = thick ? 14 : 9;
    const QPointF grip(column, canvas.center().y());
    painter.setPen(QPen(QColor(kCanvasInk), 1.5));
    painter.setBrush(Qt::white);
    painter.drawEllipse(grip, radius, radius);
    for (const double side : {-1.0, 1.0}) {
        const QPointF tip = grip + QPointF(side * radius * 0.65, 0);
        const QPointF back = grip + QPointF(side * radius * 0.2, 0);
        const QPointF up(0, radius * 0.4);
        painter.setBrush(QColor(kCanvasInk));
        painter.drawPolygon(QPolygonF{tip, back - up, back + up});
    }
    painter.setFont(textFont(1, true));
    const QFontMetricsF metrics(painter.font());
    const double side = metrics.height() + 4;
    const double y = canvas.bottom() - side - 8;
    // Where there is room they stand beside the picture and hide no pixel.
    constexpr double kGap = 8;
    const bool hasLeft = picture.left() - side - kGap >= canvas.left() + kGap;
    const bool hasRight = picture.right() + side + kGap <= canvas.right() - kGap;
    paintPill(painter, {(hasLeft ? std::min(picture.left(), column) : column) - side - kGap, y}, QStringLiteral("A"));
    paintPill(painter, {(hasRight ? std::max(picture.right(), column) : column) + kGap, y}, QStringLiteral("B"));
    painter.restore();
}

void paintTag(QPainter& painter, const QRect& canvas, const QString& text)
{
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(textFont(1, true));
    const double height = QFontMetricsF(painter.font()).height() + 4;
    paintPill(painter, {canvas.left() + 12.0, canvas.bottom() - height - 8}, text);
    painter.restore();
}

} // namespace rasterlens
