#include "ui/face/figure_view.h"

#include "ui/base/distances.h"
#include "ui/base/inks.h"
#include "ui/base/theme.h"

#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

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

} // namespace

/// Puts names beside their points so that none covers another; one without room is left out.
class FigureLabels
{
public:
    FigureLabels(QPainter& painter, const QRectF& room) : m_painter(painter), m_room(room) {}

    void put(QPointF at, const QString& name)
    {
        if (name.isEmpty())
            return;
        const QFontMetricsF metrics(m_painter.font());
        const QSizeF size(metrics.horizontalAdvance(name), metrics.ascent());
        constexpr double kAway = 5;
        for (const QPointF& corner :
             {QPointF(kAway, -kAway - size.height()), QPointF(-kAway - size.width(), -kAway - size.height()),
              QPointF(kAway, kAway), QPointF(-kAway - size.width(), kAway)}) {
            const QRectF box(at + corner, size);
            const bool isFree = m_room.contains(box) && std::ranges::none_of(m_taken, [&](const QRectF& other) {
                                    return other.intersects(box);
                                });
            if (!isFree)
                continue;
            m_taken.push_back(box);
            m_painter.drawText(box, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, name);
            return;
        }
    }

private:
    QPainter& m_painter;
    QRectF m_room;
    std::vector<QRectF> m_taken;
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

void FigureView::paintStrokes(QPainter& painter, FigureLabels& labels) const
{
    for (const FigureStroke& stroke : m_figure.strokes) {
        QPolygonF way;
        for (const glm::dvec2& point : stroke.points)
            way << toWidget(point);
        const QColor ink = inkOf(stroke.symbol);
        const bool isPlain = ink == palette().color(QPalette::Text);
        painter.setPen(
            QPen(ink, isPlain ? 1.2 : 2.6, stroke.look == FigureStroke::Look::Dashed ? Qt::DashLine : Qt::SolidLine));
        painter.drawPolyline(way);
        if (!way.isEmpty())
            labels.put(way.size() > 2 ? way[way.size() / 2] : (way.front() + way.back()) / 2, stroke.name);
    }
}

void FigureView::paintPoints(QPainter& painter, FigureLabels& labels) const
{
    for (const FigurePoint& point : m_figure.points) {
        const QPointF at = toWidget(point.at);
        painter.setPen(inkOf(point.symbol));
        painter.setBrush(inkOf(point.symbol));
        painter.drawEllipse(at, isLit(point.symbol) ? kPointRadius + 2 : kPointRadius, kPointRadius);
        labels.put(at, point.name);
    }
}

void FigureView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintAxes(painter);
    painter.setFont(textFont(-1, true));
    FigureLabels labels(painter, QRectF(rect()));
    paintStrokes(painter, labels);
    paintPoints(painter, labels);
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
