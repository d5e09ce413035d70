#include "ui/steps/lens_view.h"

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPalette>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rasterlens
{
namespace
{

constexpr int kWithinReach = 20000; ///< canvas pixels; farther ends of lines are cut off

/// The part of a line within a rectangle (Liang & Barsky, 1984).
std::optional<QLineF> cut(const QLineF& line, const QRectF& box)
{
    double t0 = 0;
    double t1 = 1;
    const auto side = [&](double distance, double growth) {
        if (growth == 0)
            return distance >= 0;
        const double t = -distance / growth;
        if (growth > 0)
            t0 = std::max(t0, t);
        else
            t1 = std::min(t1, t);
        return true;
    };
    const bool crosses = side(line.x1() - box.left(), line.dx()) && side(box.right() - line.x1(), -line.dx()) &&
                         side(line.y1() - box.top(), line.dy()) && side(box.bottom() - line.y1(), -line.dy());
    if (!crosses || !(t0 <= t1))
        return std::nullopt;
    return QLineF(line.pointAt(t0), line.pointAt(t1));
}

} // namespace

Paper paper()
{
    return {QGuiApplication::palette().color(QPalette::Base), QGuiApplication::palette().color(QPalette::Text)};
}

QColor withAlpha(QColor color, int alpha)
{
    color.setAlpha(alpha);
    return color;
}

QRectF textPlate(const QRectF& within, QPointF at, const QStringList& lines, const QFont& font)
{
    const QFontMetricsF metrics(font);
    double width = 0;
    for (const QString& line : lines)
        width = std::max(width, metrics.horizontalAdvance(line));
    QRectF plate(at, QSizeF(width + 16, metrics.lineSpacing() * double(lines.size()) + 10));
    if (plate.right() > within.right() - 4)
        plate.moveRight(within.right() - 4);
    if (plate.bottom() > within.bottom() - 4)
        plate.moveBottom(within.bottom() - 4);
    plate.moveTopLeft({std::max(plate.left(), within.left() + 4), std::max(plate.top(), within.top() + 4)});
    return plate;
}

QRectF paintPlate(QPainter& painter, const QRectF& within, QPointF at, const QStringList& lines, const QFont& font)
{
    const QFontMetricsF metrics(font);
    const QRectF plate = textPlate(within, at, lines, font);
    const Paper p = paper();
    painter.setPen(QPen(QGuiApplication::palette().color(QPalette::Mid), 1));
    painter.setBrush(withAlpha(p.fill, 240));
    painter.drawRoundedRect(plate, 5, 5);
    painter.setFont(font);
    painter.setPen(p.ink);
    for (int i = 0; i < lines.size(); ++i)
        painter.drawText(plate.topLeft() + QPointF(8, 5 + metrics.ascent() + i * metrics.lineSpacing()), lines[i]);
    return plate;
}

QPointF freeCorner(const QRectF& canvas, QSizeF size, const std::vector<QRectF>& marked)
{
    constexpr double kMargin = 12;
    const QRectF room = canvas.adjusted(kMargin, kMargin, -kMargin - size.width(), -kMargin - size.height());
    std::vector<std::pair<std::ptrdiff_t, QPointF>> places;
    for (const QPointF& at : {room.topLeft(), QPointF(room.right(), room.top()), QPointF(room.left(), room.bottom()),
                              QPointF(room.right(), room.bottom())}) {
        const QRectF plate(at, size);
        places.emplace_back(std::ranges::count_if(marked, [&](const QRectF& part) { return part.intersects(plate); }),
                            at);
    }
    return std::ranges::min_element(places, {}, &std::pair<std::ptrdiff_t, QPointF>::first)->second;
}

QRect LensView::visible(const PixelRect& of) const
{
    const auto sampleAt = [&](QPointF p) { return transform.toImage(p) * grid; };
    const QPointF first = sampleAt(QRectF(canvas).topLeft());
    const QPointF last = sampleAt(QRectF(canvas).bottomRight());
    const QRect seen(QPoint(int(std::floor(first.x())), int(std::floor(first.y()))),
                     QPoint(int(std::ceil(last.x())) - 1, int(std::ceil(last.y())) - 1));
    return seen.intersected(QRect(of.x, of.y, of.width, of.height));
}

void LensView::line(glm::dvec2 from, glm::dvec2 to, QColor color, double width, Qt::PenStyle style) const
{
    const double reach = kWithinReach;
    const QRectF near = QRectF(canvas).adjusted(-40, -40, 40, 40);
    const auto shown = cut(QLineF(at(from), at(to)), near);
    if (!shown || !(shown->length() < reach))
        return;
    painter.setPen(QPen(QColor(255, 255, 255, 200), thickness(width) + 2.4, Qt::SolidLine, Qt::RoundCap));
    painter.drawLine(*shown);
    painter.setPen(QPen(color, thickness(width), style, style == Qt::SolidLine ? Qt::RoundCap : Qt::FlatCap));
    painter.drawLine(*shown);
}

std::vector<LensView::NamePlate> LensView::namePlates(const std::vector<NamedPlace>& corners, QPointF middle) const
{
    constexpr double kMargin = 4;
    const QFontMetricsF metrics(painter.font());
    const double height = metrics.height();
    std::vector<NamePlate> plates;
    for (const NamedPlace& corner : joinedPlaces(corners, height / 2)) {
        const QLineF outward(middle, corner.at);
        const QPointF way =
            outward.length() > 0 ? QPointF(outward.dx(), outward.dy()) / outward.length() : QPointF(0, -1);
        const QSizeF size(metrics.horizontalAdvance(corner.name) + 10, height);
        const QRectF room = QRectF(canvas).adjusted(size.width() / 2 + kMargin, size.height() / 2 + kMargin,
                                                    -size.width() / 2 - kMargin, -size.height() / 2 - kMargin);
        QPointF centre = corner.at + way * height;
        centre = {std::clamp(centre.x(), room.left(), std::max(room.left(), room.right())),
                  std::clamp(centre.y(), room.top(), std::max(room.top(), room.bottom()))};
        plates.push_back({QRectF(centre - QPointF(size.width(), size.height()) / 2, size), corner.name});
    }
    return plates;
}

void LensView::paintNames(const std::vector<NamePlate>& plates) const
{
    const Paper p = paper();
    for (const auto& [plate, name] : plates) {
        painter.setPen(Qt::NoPen);
        painter.setBrush(withAlpha(p.fill, 225));
        painter.drawRoundedRect(plate, 4, 4);
        painter.setPen(p.ink);
        painter.drawText(plate, Qt::AlignCenter, name);
    }
}

} // namespace rasterlens
