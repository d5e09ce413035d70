#include "ui/face/figure_view.h"

#include "ui/base/distances.h"
#include "ui/base/inks.h"
#include "ui/base/theme.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <array>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr double kReach = 7; ///< so near the mouse has to come, in pixels
constexpr double kPointRadius = 3;

/// A number at the end of an axis, where little room is.
QString axisNumber(double value)
{
    constexpr int kDigits = 3;
    return QString::number(value, 'g', kDigits).replace(QLatin1Char('-'), QChar(0x2212));
}

QFont nameFont() { return textFont(-1, true); }

} // namespace

/// Puts names beside their points: none covers another, and each stands where no other point is nearer and where as few
/// lines as can be run through it. A name without room is left out.
class FigureLabels
{
public:
    FigureLabels(const QFontMetricsF& metrics, const QRectF& room) : m_metrics(metrics), m_room(room) {}

    void addLine(const QPolygonF& line) { m_lines.push_back(line); }
    void addPoint(QPointF point) { m_points.push_back(point); }
    void keepFree(const QRectF& box) { m_kept.push_back(box); }

    void put(QPointF at, const QString& name, int symbol)
    {
        if (name.isEmpty())
            return;
        const QSizeF size(m_metrics.horizontalAdvance(name), m_metrics.ascent());
        std::optional<QRectF> best;
        int least = 0;
        for (const QRectF& box : placesBeside(at, size)) {
            constexpr double kGap = 4; // between two names in a row, so that they do not read as one
            const QRectF wide = box.adjusted(-kGap, 0, kGap, 0);
            const bool isFree =
                m_room.contains(box) &&
                std::ranges::none_of(m_kept, [&](const QRectF& kept) { return kept.intersects(box); }) &&
                std::ranges::none_of(m_names, [&](const FigureName& other) { return other.box.intersects(wide); });
            if (const int cost = isFree ? costOf(box, at) : 0; isFree && (!best || cost < least)) {
                best = box;
                least = cost;
            }
        }
        if (best)
            m_names.push_back({name, at, *best, symbol});
    }

    [[nodiscard]] std::vector<FigureName> take() { return std::move(m_names); }

private:
    /// In the order in which they are liked.
    [[nodiscard]] static std::array<QRectF, 8> placesBeside(QPointF at, QSizeF size)
    {
        constexpr double kAway = 5;
        const double left = -kAway - size.width();
        const double above = -kAway - size.height();
        const double across = -size.width() / 2;
        const double level = -size.height() / 2;
        const auto box = [&](double x, double y) { return QRectF(at + QPointF(x, y), size); };
        return {box(kAway, above),     box(left, above),     box(kAway, kAway),  box(left, kAway),
                box(kAway + 1, level), box(left - 1, level), box(across, above), box(across, kAway)};
    }

    [[nodiscard]] int costOf(const QRectF& box, QPointF at) const
    {
        constexpr int kOtherIsNearer = 8;
        constexpr int kCoversPoint = 4;
        const auto away = [&](QPointF point) {
            const QPointF inside(std::clamp(point.x(), box.left(), box.right()),
                                 std::clamp(point.y(), box.top(), box.bottom()));
            return QLineF(point, inside).length();
        };
        int cost = 0;
        for (const QPointF& point : m_points) {
            if (point == at)
                continue;
            cost += away(point) < away(at) ? kOtherIsNearer : 0;
            cost += away(point) < kPointRadius ? kCoversPoint : 0;
        }
        for (const QPolygonF& line : m_lines)
            cost += crosses(line, box) ? 1 : 0;
        return cost;
    }

    [[nodiscard]] static bool crosses(const QPolygonF& line, const QRectF& box)
    {
        const std::array<QLineF, 4> sides{
            QLineF(box.topLeft(), box.topRight()), QLineF(box.topRight(), box.bottomRight()),
            QLineF(box.bottomRight(), box.bottomLeft()), QLineF(box.bottomLeft(), box.topLeft())};
        for (qsizetype i = 1; i < line.size(); ++i) {
            const QLineF piece(line[i - 1], line[i]);
            if (box.contains(piece.p1()) || std::ranges::any_of(sides, [&](const QLineF& side) {
                    return side.intersects(piece) == QLineF::BoundedIntersection;
                }))
                return true;
        }
        return false;
    }

    QFontMetricsF m_metrics;
    QRectF m_room;
    std::vector<QPolygonF> m_lines;
    std::vector<QPointF> m_points;
    std::vector<QRectF> m_kept;
    std::vector<FigureName> m_names;
};

FigureView::FigureView(QWidget* parent) : QWidget(parent)
{
    setMouseTracking(true);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
}

void FigureView::setFigure(const DerivationFigure& figure, const QString& title)
{
    m_figure = figure;
    m_title = title;
    setAccessibleName(title);
    update();
}

void FigureView::setPresent(std::vector<int> symbols)
{
    m_present = std::move(symbols);
    update();
}

void FigureView::setHovered(std::optional<std::size_t> symbol)
{
    m_hovered = symbol;
    update();
}

QRectF FigureView::plotArea() const
{
    const double line = QFontMetricsF(textFont(-1)).height();
    return QRectF(rect()).adjusted(2.4 * line, 2.2 * line, -0.9 * line, -1.3 * line);
}

QPointF FigureView::toWidget(const glm::dvec2& at) const
{
    const QRectF area = plotArea();
    const double height = m_figure.high.y - m_figure.low.y;
    const double up = (at.y - m_figure.low.y) / (height > 0 ? height : 1);
    return {area.left() + m_figure.partOfWidth(at.x) * area.width(), area.bottom() - up * area.height()};
}

std::optional<std::size_t> FigureView::symbolAt(QPointF widget) const
{
    std::optional<std::size_t> nearest;
    double distance = kReach;
    const auto offer = [&](int symbol, double away) {
        if (symbol < 0 || away >= distance)
            return;
        nearest = static_cast<std::size_t>(symbol);
        distance = away;
    };
    for (const FigurePoint& point : m_figure.points)
        offer(point.symbol, QLineF(widget, toWidget(point.at)).length() - kPointRadius);
    for (const FigureStroke& stroke : m_figure.strokes)
        for (std::size_t i = 1; i < stroke.points.size(); ++i)
            offer(stroke.symbol,
                  distanceToSegment(widget, {toWidget(stroke.points[i - 1]), toWidget(stroke.points[i])}));
    return nearest;
}

bool FigureView::isLit(int symbol) const
{
    return symbol >= 0 && m_hovered && static_cast<std::size_t>(symbol) == *m_hovered;
}

QColor FigureView::inkOf(int symbol) const
{
    const Inks inks = inksFor(palette());
    if (isLit(symbol))
        return inks.minus;
    const bool isPresent = symbol >= 0 && std::ranges::find(m_present, symbol) != m_present.end();
    return isPresent ? inks.plus : palette().color(QPalette::Text);
}

void FigureView::paintAxes(QPainter& painter) const
{
    const QRectF area = plotArea();
    const QColor muted = palette().color(QPalette::PlaceholderText);
    painter.setPen(palette().color(QPalette::Text));
    painter.setFont(textFont(-1, true));
    painter.drawText(QRectF(0, 0, width(), area.top()), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, m_title);
    painter.setPen(muted);
    painter.setFont(textFont(-1));
    painter.drawLine(area.topLeft(), area.bottomLeft());
    painter.drawLine(area.bottomLeft(), area.bottomRight());
    paintXAxis(painter, QRectF(area.left(), area.bottom() + 1, area.width(), height() - area.bottom()));
    const QRectF beside(0, area.top(), area.left() - 3, area.height());
    painter.drawText(beside, Qt::AlignRight | Qt::AlignTop, axisNumber(m_figure.high.y));
    painter.drawText(beside, Qt::AlignRight | Qt::AlignVCenter, m_figure.yName);
    painter.drawText(beside, Qt::AlignRight | Qt::AlignBottom, axisNumber(m_figure.low.y));
}

/// Names what lies along the x axis: its ends and, in the middle, what it counts; or its ticks and, at its end, what it
/// counts.
void FigureView::paintXAxis(QPainter& painter, const QRectF& below) const
{
    const bool hasTicks = !m_figure.xTicks.empty();
    painter.drawText(below, static_cast<int>((hasTicks ? Qt::AlignRight : Qt::AlignHCenter) | Qt::AlignTop),
                     m_figure.xName);
    for (const FigureTick& tick : m_figure.xTicks) {
        const double x = below.left() + m_figure.partOfWidth(tick.at) * below.width();
        constexpr double kTick = 4;
        painter.drawLine(QPointF(x, below.top() - 1), QPointF(x, below.top() - 1 - kTick));
        const double room = QFontMetricsF(painter.font()).horizontalAdvance(tick.name) + 2;
        painter.drawText(QRectF(x - room / 2, below.top(), room, below.height()), Qt::AlignHCenter | Qt::AlignTop,
                         tick.name);
    }
    if (hasTicks)
        return;
    painter.drawText(below, Qt::AlignLeft | Qt::AlignTop, axisNumber(m_figure.low.x));
    painter.drawText(below, Qt::AlignRight | Qt::AlignTop, axisNumber(m_figure.high.x));
}

/// Where the axes are named.
std::vector<QRectF> FigureView::axisTexts() const
{
    const QRectF area = plotArea();
    const QFontMetricsF metrics(textFont(-1));
    const double line = metrics.height();
    std::vector<QRectF> boxes;
    const auto beside = [&](const QString& text, double top) {
        const double width = metrics.horizontalAdvance(text);
        boxes.emplace_back(area.left() - 3 - width, top, width, line);
    };
    beside(axisNumber(m_figure.high.y), area.top());
    beside(m_figure.yName, area.center().y() - line / 2);
    beside(axisNumber(m_figure.low.y), area.bottom() - line);
    const auto below = [&](const QString& text, double middle) {
        const double width = metrics.horizontalAdvance(text);
        boxes.emplace_back(middle - width / 2, area.bottom() + 1, width, line);
    };
    for (const FigureTick& tick : m_figure.xTicks)
        below(tick.name, area.left() + m_figure.partOfWidth(tick.at) * area.width());
    if (m_figure.xTicks.empty()) {
        const double half = metrics.horizontalAdvance(axisNumber(m_figure.high.x)) / 2;
        below(m_figure.xName, area.center().x());
        below(axisNumber(m_figure.low.x), area.left() + metrics.horizontalAdvance(axisNumber(m_figure.low.x)) / 2);
        below(axisNumber(m_figure.high.x), area.right() - half);
    } else {
        below(m_figure.xName, area.right() - metrics.horizontalAdvance(m_figure.xName) / 2);
    }
    return boxes;
}

QPolygonF FigureView::wayOf(const FigureStroke& stroke) const
{
    QPolygonF way;
    for (const glm::dvec2& point : stroke.points)
        way << toWidget(point);
    return way;
}

void FigureView::paintStrokes(QPainter& painter) const
{
    for (const FigureStroke& stroke : m_figure.strokes) {
        const QColor ink = inkOf(stroke.symbol);
        const bool isPlain = ink == palette().color(QPalette::Text);
        painter.setPen(
            QPen(ink, isPlain ? 1.2 : 2.6, stroke.look == FigureStroke::Look::Dashed ? Qt::DashLine : Qt::SolidLine));
        painter.drawPolyline(wayOf(stroke));
    }
}

void FigureView::paintPoints(QPainter& painter) const
{
    for (const FigurePoint& point : m_figure.points) {
        painter.setPen(inkOf(point.symbol));
        painter.setBrush(inkOf(point.symbol));
        painter.drawEllipse(toWidget(point.at), isLit(point.symbol) ? kPointRadius + 2 : kPointRadius, kPointRadius);
    }
}

/// The names of points first: a line has its name in more places than one.
std::vector<FigureName> FigureView::names() const
{
    FigureLabels labels{QFontMetricsF(nameFont()), QRectF(rect())};
    for (const QRectF& text : axisTexts())
        labels.keepFree(text);
    for (const FigureStroke& stroke : m_figure.strokes)
        labels.addLine(wayOf(stroke));
    for (const FigurePoint& point : m_figure.points)
        labels.addPoint(toWidget(point.at));
    for (const FigurePoint& point : m_figure.points)
        labels.put(toWidget(point.at), point.name, point.symbol);
    for (const FigureStroke& stroke : m_figure.strokes)
        if (const QPolygonF way = wayOf(stroke); !way.isEmpty())
            labels.put(way.size() > 2 ? way[way.size() / 2] : (way.front() + way.back()) / 2, stroke.name,
                       stroke.symbol);
    return labels.take();
}

void FigureView::paintNames(QPainter& painter) const
{
    constexpr int kVeil = 190; // lines are still seen to go on
    QColor ground = palette().color(QPalette::Window);
    ground.setAlpha(kVeil);
    painter.setFont(nameFont());
    for (const FigureName& name : names()) {
        painter.fillRect(name.box, ground);
        painter.setPen(inkOf(name.symbol));
        painter.drawText(name.box, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, name.name);
    }
}

void FigureView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintAxes(painter);
    paintStrokes(painter);
    paintPoints(painter);
    paintNames(painter);
}

void FigureView::mouseMoveEvent(QMouseEvent* event)
{
    Q_EMIT symbolHovered(symbolAt(event->position()));
    QWidget::mouseMoveEvent(event);
}

void FigureView::leaveEvent(QEvent* event)
{
    Q_EMIT symbolHovered(std::nullopt);
    QWidget::leaveEvent(event);
}

} // namespace rasterlens
