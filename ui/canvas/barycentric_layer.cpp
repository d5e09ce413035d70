#include "ui/canvas/barycentric_layer.h"

#include "core/observe/names.h"
#include "ui/base/theme.h"
#include "ui/canvas/geometry_layer.h"
#include "ui/canvas/overlay_inks.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>
#include <QPolygonF>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rasterlens
{
namespace
{

constexpr std::array<char16_t, 3> kLetters{u'\u03b1', u'\u03b2', u'\u03b3'};

QPointF onCanvas(const CanvasTransform& transform, const glm::dvec2& point)
{
    return transform.toCanvas(QPointF(point.x, point.y));
}

/// The middle of the part of a polygon that the canvas shows; of all of it where it shows none.
QPointF visibleMiddle(const QPolygonF& polygon, const QRect& canvas)
{
    const QPolygonF seen = polygon.intersected(QPolygonF(QRectF(canvas)));
    const QPolygonF& shown = seen.isEmpty() ? polygon : seen;
    QPointF sum;
    for (const QPointF& point : shown)
        sum += point;
    return sum / static_cast<double>(shown.size());
}

/// What the frame of the pixel of a point takes of the canvas.
QRectF frameOf(const CanvasTransform& transform, const glm::dvec2& point)
{
    constexpr double kFrame = 6; // canvas pixels beside the pixel
    const QRectF pixel(std::floor(point.x), std::floor(point.y), 1, 1);
    return transform.toCanvas(pixel).adjusted(-kFrame, -kFrame, kFrame, kFrame);
}

/// The shortest way along an axis that takes `plate` off `frame`; none where they do not touch.
QPointF wayOut(const QRectF& plate, const QRectF& frame)
{
    if (!plate.intersects(frame))
        return {};
    const bool isLeft = plate.center().x() < frame.center().x();
    const bool isAbove = plate.center().y() < frame.center().y();
    const QPointF across(isLeft ? frame.left() - plate.right() : frame.right() - plate.left(), 0);
    const QPointF along(0, isAbove ? frame.top() - plate.bottom() : frame.bottom() - plate.top());
    return std::abs(across.x()) < std::abs(along.y()) ? across : along;
}

double areaOf(const QPolygonF& polygon)
{
    double twice = 0;
    for (qsizetype i = 0; i < polygon.size(); ++i) {
        const QPointF& here = polygon[i];
        const QPointF& next = polygon[(i + 1) % polygon.size()];
        twice += here.x() * next.y() - next.x() * here.y();
    }
    return std::abs(twice) / 2;
}

/// Whether the plates have no room in the areas: they lie on each other, or hide much of the triangle.
bool areCrowded(const std::array<QRectF, 3>& plates, const QPolygonF& triangle)
{
    if (plates[0].intersects(plates[1]) || plates[1].intersects(plates[2]) || plates[2].intersects(plates[0]))
        return true;
    constexpr double kMost = 0.3;
    double hidden = 0;
    for (const QRectF& plate : plates)
        hidden += areaOf(QPolygonF(plate).intersected(triangle));
    return hidden > kMost * areaOf(triangle);
}

/// Where plates that lie one below the other hide the least of the triangle and no name of a corner: beside the sample,
/// or else in a corner of the canvas.
///
/// in  `size`: of all of them together
QRectF placeOfStack(QSizeF size, QPointF sample, double besideIt, const QRect& canvas, const QPolygonF& triangle,
                    const std::vector<QRectF>& names)
{
    constexpr double kMargin = 8;
    const QRectF room = QRectF(canvas).adjusted(kMargin, kMargin, -kMargin, -kMargin);
    const double top = sample.y() - size.height() / 2;
    const double left = room.right() - size.width();
    const double low = room.bottom() - size.height();
    const QPointF places[] = {{sample.x() + besideIt, top},
                              {sample.x() - besideIt - size.width(), top},
                              {left, room.top()},
                              {room.left(), room.top()},
                              {left, low},
                              {room.left(), low}};
    const auto hidden = [&](QPointF place) {
        const QRectF rect(place, size);
        double area = areaOf(QPolygonF(rect).intersected(triangle));
        if (!room.contains(rect))
            area += size.width() * size.height();
        for (const QRectF& name : names)
            if (rect.intersects(name))
                area += size.width() * size.height();
        return area;
    };
    return {*std::ranges::min_element(places, {}, hidden), size};
}

} // namespace

std::array<QString, 3> BarycentricLayer::texts() const
{
    std::array<QString, 3> texts;
    for (std::size_t i = 0; i < 3; ++i) {
        const QString letter = QChar(kLetters[i]);
        texts[i] = QStringLiteral("%1 %2").arg(letter).arg(m_weights->screen[i], 0, 'f', 4);
        if (m_weights->isCorrected())
            texts[i] +=
                QLatin1Char('\n') + QCoreApplication::translate("rasterlens::BarycentricLayer", "perspective %1")
                                        .arg(QStringLiteral("%1 %2").arg(letter).arg(m_weights->used[i], 0, 'f', 4));
    }
    return texts;
}

void BarycentricLayer::paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                             const OverlayOptions& options) const
{
    if (!m_weights || !options.barycentric)
        return;
    painter.save();
    painter.setClipRect(canvas, Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing);
    paintIsoLines(painter, transform);
    paintAreas(painter, transform, options.thickLines);
    paintTexts(painter, canvas, transform);
    painter.restore();
}

/// Solid: of the weights that attributes are weighted with. Dotted: of those on the screen, where they differ.
void BarycentricLayer::paintIsoLines(QPainter& painter, const CanvasTransform& transform) const
{
    constexpr int kParts = 10;
    const bool corrected = m_weights->isCorrected();
    const auto draw = [&](std::size_t corner, int part, bool withW) {
        const auto line = isoLine(m_weights->corners, m_weights->invW, corner, double(part) / kParts, withW);
        painter.drawLine(onCanvas(transform, line[0]), onCanvas(transform, line[1]));
    };
    for (std::size_t corner = 0; corner < 3; ++corner)
        for (int part = 1; part < kParts; ++part) {
            const double width = part * 2 == kParts ? 2 : 1;
            paintSeamed(painter, kWeightInks[corner], width, Qt::SolidLine, [&] { draw(corner, part, corrected); });
            if (corrected && part * 2 == kParts)
                paintSeamed(painter, kWeightInks[corner], 1.5, Qt::DotLine, [&] { draw(corner, part, false); });
        }
}

/// The triangle of the sample and the side opposite a corner has the part of the area that is that corner's weight.
void BarycentricLayer::paintAreas(QPainter& painter, const CanvasTransform& transform, bool thick) const
{
    constexpr int kAlpha = 90;
    const QPointF point = onCanvas(transform, m_weights->point);
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const QPointF next = onCanvas(transform, m_weights->corners[(corner + 1) % 3]);
        const QPointF last = onCanvas(transform, m_weights->corners[(corner + 2) % 3]);
        QColor fill(kWeightInks[corner]);
        fill.setAlpha(kAlpha);
        painter.setPen(Qt::NoPen);
        painter.setBrush(fill);
        painter.drawPolygon(QPolygonF{point, next, last});
        paintSeamed(painter, kWireInk, thick ? 3 : 1.5, Qt::SolidLine, [&] {
            painter.drawPolygon(QPolygonF{point, next, last});
        });
    }
    painter.setPen(QPen(QColor(kCanvasInk), 1.5));
    painter.setBrush(Qt::white);
    painter.drawEllipse(point, 4, 4);
}

void BarycentricLayer::paintTexts(QPainter& painter, const QRect& canvas, const CanvasTransform& transform) const
{
    painter.setFont(textFont(0, true));
    const std::array<QString, 3> texts = this->texts();
    const QPointF point = onCanvas(transform, m_weights->point);
    std::array<QPointF, 3> places;
    std::array<QRectF, 3> plates;
    QPointF middle;
    for (std::size_t i = 0; i < 3; ++i) {
        const QPointF here = onCanvas(transform, m_weights->corners[i]);
        const QPointF next = onCanvas(transform, m_weights->corners[(i + 1) % 3]);
        const QPointF last = onCanvas(transform, m_weights->corners[(i + 2) % 3]);
        places[i] = visibleMiddle(QPolygonF{point, next, last}, canvas);
        plates[i] = plateOf(painter, canvas, places[i], texts[i]);
        middle += here / 3;
    }
    const QRectF frame = frameOf(transform, m_weights->point);
    for (std::size_t i = 0; i < 3; ++i) {
        places[i] += wayOut(plates[i], frame);
        plates[i] = plateOf(painter, canvas, places[i], texts[i]);
    }
    std::array<QPointF, 3> names;
    std::vector<QRectF> named; // the names that are seen
    QPolygonF triangle;
    for (std::size_t i = 0; i < 3; ++i) {
        const QPointF here = onCanvas(transform, m_weights->corners[i]);
        const QLineF away(middle, here);
        constexpr double kAway = 14;
        names[i] = away.length() > 0 ? here + (here - middle) / away.length() * kAway : here;
        triangle << here;
        if (canvas.contains(here.toPoint()))
            named.push_back(plateOf(painter, canvas, names[i], cornerLetter(i)));
    }
    if (areCrowded(plates, triangle)) {
        constexpr double kGap = 2;
        QSizeF size;
        for (const QRectF& plate : plates)
            size = QSizeF(std::max(size.width(), plate.width()), size.height() + plate.height() + kGap);
        QPointF place = placeOfStack(size, point, std::max(16.0, transform.zoom), canvas, triangle, named).topLeft();
        for (std::size_t i = 0; i < 3; ++i) {
            places[i] = place + QPointF(size.width() / 2, plates[i].height() / 2);
            place.ry() += plates[i].height() + kGap;
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        if (canvas.contains(onCanvas(transform, m_weights->corners[i]).toPoint()))
            paintPlate(painter, canvas, names[i], cornerLetter(i), kWeightInks[i]);
        paintPlate(painter, canvas, places[i], texts[i], kWeightInks[i]);
    }
}

} // namespace rasterlens
