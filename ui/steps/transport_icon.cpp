#include "ui/steps/transport_icon.h"

#include <QPainter>
#include <QPixmap>

namespace rasterlens
{
namespace
{

constexpr int kSide = 20;
constexpr int kResolution = 2; ///< pixels a unit, for screens of high resolution

/// So many triangles in a row, and a bar at the end.
void paintArrows(QPainter& painter, int count, bool bar, double width)
{
    const double barWidth = bar ? 2.4 : 0;
    double x = (kSide - count * width - barWidth) / 2;
    const double half = count == 1 && !bar ? 6.5 : 5;
    for (int i = 0; i < count; ++i, x += width)
        painter.drawPolygon(QPolygonF{{{x, kSide / 2.0 - half}, {x + width, kSide / 2.0}, {x, kSide / 2.0 + half}}});
    if (bar)
        painter.drawRect(QRectF(x, kSide / 2.0 - half, barWidth, 2 * half));
}

QPixmap picture(TransportSign sign, bool backward, const QColor& color)
{
    QPixmap pixmap(kSide * kResolution, kSide * kResolution);
    pixmap.setDevicePixelRatio(kResolution);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    if (backward) {
        painter.translate(kSide, 0);
        painter.scale(-1, 1);
    }
    switch (sign) {
    case TransportSign::Play: paintArrows(painter, 1, false, 11); break;
    case TransportSign::Pause:
        painter.drawRect(QRectF(5, 4, 3.6, 12));
        painter.drawRect(QRectF(11.4, 4, 3.6, 12));
        break;
    case TransportSign::Step: paintArrows(painter, 1, false, 6.5); break;
    case TransportSign::Row: paintArrows(painter, 2, false, 6); break;
    case TransportSign::Face: paintArrows(painter, 3, false, 5); break;
    case TransportSign::Stage: paintArrows(painter, 2, true, 6); break;
    case TransportSign::End: paintArrows(painter, 1, true, 8); break;
    }
    return pixmap;
}

} // namespace

QIcon transportIcon(TransportSign sign, bool backward, const QColor& ink, const QColor& faded)
{
    QIcon icon;
    icon.addPixmap(picture(sign, backward, ink), QIcon::Normal);
    icon.addPixmap(picture(sign, backward, faded), QIcon::Disabled);
    return icon;
}

} // namespace rasterlens
