#include "ui/face/derivation_layer.h"

#include "ui/base/inks.h"
#include "ui/base/theme.h"

#include <QPainter>
#include <QRegularExpression>

#include <algorithm>

namespace rasterlens
{
namespace
{

constexpr QRgb kFigureInk = 0xff56b4e9;
constexpr double kSeam = 2; ///< wider on both sides together: keeps strokes in sight on any picture

/// The hue of an edge over the picture, light enough for the dark seam around it.
QColor figureInk(std::size_t look) { return QColor(kEdgeLooks[look].color).lighter(230); }

void paintArrow(QPainter& painter, QPointF from, QPointF to)
{
    const QLineF line(to, from);
    painter.drawLine(line);
    constexpr double kHead = 11;
    if (line.length() < 1)
        return;
    const QPen pen = painter.pen();
    painter.setPen(QPen(pen.color(), pen.widthF())); // a head of dots is none
    for (const double turn : {-24.0, 24.0}) {
        QLineF head = line;
        head.setLength(std::min(kHead, line.length()));
        head.setAngle(line.angle() + turn);
        painter.drawLine(head);
    }
    painter.setPen(pen);
}

void paintPart(QPainter& painter, const CanvasPart& part, const CanvasTransform& transform)
{
    QPolygonF points;
    for (const glm::dvec2& point : part.points)
        points << transform.toCanvas(QPointF(point.x, point.y));
    if (points.isEmpty())
        return;
    switch (part.kind) {
    case CanvasKind::Vector:
        if (points.size() == 2)
            paintArrow(painter, points[0], points[1]);
        break;
    case CanvasKind::Area: {
        QColor fill = painter.pen().color();
        fill.setAlpha(60);
        painter.setBrush(fill);
        painter.drawPolygon(points);
        painter.setBrush(Qt::NoBrush);
        break;
    }
    case CanvasKind::Edge:
    case CanvasKind::Row:
    case CanvasKind::Column: painter.drawPolyline(points); break;
    case CanvasKind::Point:
    case CanvasKind::Corner:
    case CanvasKind::Sample:
        for (const QPointF& point : points)
            painter.drawEllipse(point, 5, 5);
        break;
    case CanvasKind::Nothing:
    case CanvasKind::Plane: break;
    }
}

/// The names of the points of a part: `BA` names the ends of a vector, `CBP` the corners of an area, `I3B` the ends of
/// an edge that was cut. Where a name is none of the points', that of a vector, such as `n`, stands at its tip, and
/// that of anything else, such as `box`, stands nowhere.
std::vector<NamedPlace> namesOf(const CanvasPart& part)
{
    static const QRegularExpression pointName(QStringLiteral("[A-Z][0-9]*'?"));
    std::vector<NamedPlace> names;
    QString rest = part.name;
    const auto atTip = [&]() -> std::vector<NamedPlace> {
        if (part.kind != CanvasKind::Vector || part.points.empty())
            return {};
        return {{QPointF(part.points.back().x, part.points.back().y), part.name}};
    };
    for (const glm::dvec2& point : part.points) {
        const QRegularExpressionMatch match =
            pointName.match(rest, 0, QRegularExpression::NormalMatch, QRegularExpression::AnchorAtOffsetMatchOption);
        if (!match.hasMatch())
            return atTip();
        names.push_back({QPointF(point.x, point.y), match.captured()});
        rest = rest.sliced(match.capturedLength());
    }
    return rest.isEmpty() ? names : atTip();
}

bool isCornerName(const QString& name)
{
    static const QRegularExpression corner(QStringLiteral("^([ABC]|I[0-9]+)$"));
    return corner.match(name).hasMatch();
}

} // namespace

std::optional<std::size_t> edgeLookOf(const CanvasPart& part)
{
    const bool isOfEdge =
        part.kind == CanvasKind::Edge || part.kind == CanvasKind::Vector || part.kind == CanvasKind::Area;
    const QString corners = QStringLiteral("ABC");
    const qsizetype count = part.name.size();
    if (!isOfEdge || count < 2 || count > 3 || (count == 3 && part.name[2] != QLatin1Char('P')))
        return std::nullopt;
    const qsizetype from = corners.indexOf(part.name[0]);
    const qsizetype to = corners.indexOf(part.name[1]);
    if (from < 0 || to < 0 || from == to)
        return std::nullopt;
    // Set up clockwise or counter-clockwise, the edge from A on is the first one.
    return from == 0 ? 0 : to == 0 ? 2 : 1;
}

std::vector<NamedPlace> DerivationLayer::names() const
{
    std::vector<NamedPlace> names;
    for (const auto* parts : {&m_marks, &m_named})
        for (const CanvasPart& part : *parts)
            for (const NamedPlace& name : namesOf(part)) {
                const bool isThere = std::ranges::any_of(
                    names, [&](const NamedPlace& other) { return other.name == name.name && other.at == name.at; });
                if (!isThere && !(m_cornersAreNamed && isCornerName(name.name)))
                    names.push_back(name);
            }
    return names;
}

/// Each name beside its point, away from the middle of them all.
void DerivationLayer::paintNames(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                                 bool isLarge) const
{
    std::vector<NamedPlace> places = names();
    QPointF middle;
    for (NamedPlace& place : places) {
        place.at = transform.toCanvas(place.at);
        middle += place.at / double(places.size());
    }
    const QFont font = textFont(isLarge ? 2 : 1, true);
    const QFontMetricsF metrics(font);
    const double height = metrics.height();
    painter.setFont(font);
    for (const NamedPlace& place : joinedPlaces(places, height / 3)) {
        if (!QRectF(canvas).contains(place.at))
            continue;
        const QLineF outward(middle, place.at);
        const QPointF way =
            outward.length() > 1 ? QPointF(outward.dx(), outward.dy()) / outward.length() : QPointF(0.6, -0.8);
        QRectF plate(QPointF(), QSizeF(metrics.horizontalAdvance(place.name) + 8, height));
        constexpr double kAway = 4;
        plate.moveCenter(place.at + way * (std::max(height, plate.width()) / 2 + kAway + 2));
        constexpr double kMargin = 3;
        const QRectF room = QRectF(canvas).adjusted(kMargin, kMargin, -kMargin, -kMargin);
        plate.moveLeft(std::clamp(plate.left(), room.left(), std::max(room.left(), room.right() - plate.width())));
        plate.moveTop(std::clamp(plate.top(), room.top(), std::max(room.top(), room.bottom() - plate.height())));
        QColor ground(kCanvasInk);
        ground.setAlpha(200);
        painter.setPen(Qt::NoPen);
        painter.setBrush(ground);
        painter.drawRoundedRect(plate, 4, 4);
        painter.setPen(Qt::white);
        painter.drawText(plate, Qt::AlignCenter, place.name);
    }
}

void DerivationLayer::paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                            const OverlayOptions& options) const
{
    painter.save();
    painter.setClipRect(canvas, Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing);
    const double width = options.thickLines ? 4 : 2;
    const auto paintOne = [&](const CanvasPart& part, QColor ink, Qt::PenStyle style, double width) {
        painter.setPen(QPen(QColor(kCanvasInk), width + kSeam));
        paintPart(painter, part, transform);
        if (style != Qt::SolidLine && part.kind != CanvasKind::Area) { // between dashes the line goes on
            painter.setPen(QPen(ink.darker(200), width));
            paintPart(painter, part, transform);
        }
        painter.setPen(QPen(ink, width, style, Qt::FlatCap));
        paintPart(painter, part, transform);
    };
    for (const CanvasPart& part : m_marks) {
        const std::optional<std::size_t> look = edgeLookOf(part);
        paintOne(part, look ? figureInk(*look) : QColor(kFigureInk), look ? kEdgeLooks[*look].style : Qt::SolidLine,
                 width);
    }
    constexpr double kHoveredMore = 3; // the outline of the selected pixel's face is as yellow
    paintOne(m_hovered, QColor(kHoveredInk), Qt::SolidLine, width + kHoveredMore);
    paintNames(painter, canvas, transform, options.thickLines);
    painter.restore();
}

} // namespace rasterlens
