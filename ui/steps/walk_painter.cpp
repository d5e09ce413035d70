#include "ui/steps/walk_painter.h"

#include "core/observe/step_text.h"
#include "ui/base/inks.h"
#include "ui/base/theme.h"
#include "ui/steps/lens_view.h"
#include "ui/steps/step_formula.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPalette>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace rasterlens
{
namespace
{

constexpr double kActiveLine = 4.5;
constexpr double kRestingLine = 3;
constexpr Qt::PenStyle kBrokenStyle = Qt::DashLine;

QString translated(const char* text) { return QCoreApplication::translate("Lens", text); }

/// What a row crosses, two numbers a line.
QStringList crossingLines(const RowCrossings& row)
{
    return {QStringLiteral("alpha = %1   xa = %2").arg(shortNumber(row.alpha), shortNumber(row.xa)),
            QStringLiteral("beta = %1   xb = %2").arg(shortNumber(row.beta), shortNumber(row.xb))};
}

/// One equation a line, for a narrow place. A function is of the name, whose number stands above it.
QStringList narrow(const QStringList& lines)
{
    QStringList equations;
    for (const QString& line : lines) {
        const QStringList parts = line.split(QStringLiteral("   "));
        const QString name = parts[0].section(QStringLiteral(" = "), 0, 0);
        const QString number = parts[0].section(QStringLiteral(" = "), 1);
        equations << parts[0];
        for (QString part : parts.mid(1))
            equations << part.replace(QLatin1Char('(') + number, QLatin1Char('(') + name);
    }
    return equations;
}

/// Paints the stages of one triangle.
class WalkPainter
{
public:
    WalkPainter(const LensView& view, const LensModel& model, const WalkedTriangle& walk)
        : m_view(view), m_model(model), m_walk(walk)
    {
        if (model.ownsEvent()) {
            m_now = model.event()->kind;
            m_row = model.event()->y;
        }
    }

    void paint() const
    {
        const bool atHalves = m_now == StepKind::Halves;
        if (atHalves)
            paintHalves();
        if (m_model.halves() != nullptr)
            paintCut();
        paintSides();
        if (atHalves)
            paintHalfNames();
        QRectF numbers;
        if (m_now == StepKind::Crossing)
            numbers = paintCrossings(*m_model.crossings());
        else if (m_row >= 0 && m_model.span() != nullptr)
            numbers = paintSpan(*m_model.span());
        paintLegend(numbers);
    }

private:
    [[nodiscard]] bool hasUpper() const { return m_walk.vertices[1].y > m_walk.vertices[0].y; }
    [[nodiscard]] bool hasLower() const { return m_walk.vertices[2].y > m_walk.vertices[1].y; }

    /// Which half the present row is in; nothing before the first row.
    [[nodiscard]] std::optional<bool> upperHalf() const
    {
        const RowCrossings* row = m_model.crossings();
        return row != nullptr && m_row >= 0 ? std::optional(row->upperHalf) : std::nullopt;
    }

    /// The long edge, and the two short ones; of these the one that is walked along is the thicker.
    void paintSides() const
    {
        const auto& v = m_walk.vertices;
        const auto upper = upperHalf();
        const auto width = [](bool isActive) { return isActive ? kActiveLine : kRestingLine; };
        const QColor broken(kCanvasBrokenEdge);
        m_view.line(v[0], v[1], broken, width(!upper || *upper), kBrokenStyle);
        m_view.line(v[1], v[2], broken, width(!upper || !*upper), kBrokenStyle);
        m_view.line(v[0], v[2], QColor(kCanvasLongEdge), kActiveLine, Qt::SolidLine);
    }

    /// Where the cut meets the long edge.
    [[nodiscard]] glm::dvec2 cutEnd() const { return {m_model.halves()->x, m_walk.vertices[1].y}; }

    void paintCut() const
    {
        if (hasUpper() && hasLower())
            m_view.line(m_walk.vertices[1], cutEnd(), QColor(kCanvasInk), 2.2, Qt::DashDotLine);
    }

    [[nodiscard]] QPolygonF half(bool isUpper) const
    {
        return {{m_view.at(m_walk.vertices[isUpper ? 0 : 2]), m_view.at(m_walk.vertices[1]), m_view.at(cutEnd())}};
    }

    /// The halves are hatched in two directions.
    void paintHalves() const
    {
        for (const bool isUpper : {true, false}) {
            if (!(isUpper ? hasUpper() : hasLower()))
                continue;
            const QRectF seen(m_view.canvas.adjusted(-8, -8, 8, 8));
            const QPolygonF area = half(isUpper).intersected(QPolygonF(seen));
            m_view.painter.setPen(Qt::NoPen);
            m_view.painter.setBrush(QColor(255, 255, 255, 130));
            m_view.painter.drawPolygon(area);
            m_view.painter.setBrush(
                QBrush(withAlpha(QColor(kCanvasInk), 170), isUpper ? Qt::FDiagPattern : Qt::BDiagPattern));
            m_view.painter.drawPolygon(area);
        }
    }

    void paintHalfNames() const
    {
        const QFont font = textFont(0, true);
        const QFontMetricsF metrics(font);
        for (const bool isUpper : {true, false}) {
            if (!(isUpper ? hasUpper() : hasLower()))
                continue;
            const QString name = isUpper ? translated(QT_TRANSLATE_NOOP("Lens", "upper half"))
                                         : translated(QT_TRANSLATE_NOOP("Lens", "lower half"));
            const QPolygonF area = half(isUpper);
            const QPointF middle = (area[0] + area[1] + area[2]) / 3;
            const QPointF size(metrics.horizontalAdvance(name) + 16, metrics.lineSpacing() + 10);
            QPointF corner = middle - size / 2;
            if (hasUpper() && hasLower()) { // each on its side of the cut, also where the halves are lower than a name
                const double cut = m_view.at(m_walk.vertices[1]).y();
                corner.setY(isUpper ? std::min(corner.y(), cut - size.y() - 1) : std::max(corner.y(), cut + 1));
            }
            paintPlate(m_view.painter, m_view.canvas, corner, {name}, font);
        }
    }

    void paintPoint(glm::dvec2 at, QRgb color) const
    {
        const double r = std::clamp(m_view.cell / 6, 4.0, 8.0);
        const QPointF centre = m_view.at(at);
        const QPolygonF diamond{
            {centre + QPointF(0, -r), centre + QPointF(r, 0), centre + QPointF(0, r), centre + QPointF(-r, 0)}};
        m_view.painter.setPen(QPen(Qt::white, m_view.thickness(1.5)));
        m_view.painter.setBrush(QColor(color));
        m_view.painter.drawPolygon(diamond);
    }

    void paintEnds(double y, double xa, double xb) const
    {
        paintPoint({xa, y}, kCanvasLongEdge);
        paintPoint({xb, y}, kCanvasBrokenEdge);
    }

    /// The centre line of the row, or where it is crossed instead, and where it crosses both edges.
    ///
    /// out  the plate with the numbers
    QRectF paintCrossings(const RowCrossings& row) const
    {
        const double y = row.height;
        const double beyond = 24 / m_view.cell;
        m_view.line({std::min(row.xa, row.xb) - beyond, y}, {std::max(row.xa, row.xb) + beyond, y}, QColor(kCanvasInk),
                    1.4, Qt::SolidLine);
        paintEnds(y, row.xa, row.xb);
        return paintNumbers(crossingLines(row), QRectF(m_view.at({std::min(row.xa, row.xb), y - 0.5}),
                                                       m_view.at({std::max(row.xa, row.xb), y + 0.5})));
    }

    /// The samples of the row, and where the span begins and ends before and after ceil(v - 0.5).
    ///
    /// out  the plate with the numbers
    QRectF paintSpan(const SpanStep& span) const
    {
        const int y = m_row;
        const QRectF row(m_view.at({span.xBegin, y}), m_view.at({span.xEnd, y + 1}));
        m_view.painter.setBrush(Qt::NoBrush);
        m_view.painter.setPen(QPen(Qt::white, m_view.thickness(5)));
        m_view.painter.drawRect(row);
        m_view.painter.setPen(QPen(Qt::black, m_view.thickness(2.2)));
        m_view.painter.drawRect(row);
        const SpanEnds& ends = span.ends;
        paintEnds(ends.whole ? y : y + 0.5, ends.longEdgeIsLeft ? ends.left : ends.right,
                  ends.longEdgeIsLeft ? ends.right : ends.left);
        if (m_view.cell < kGlyphsFromCell)
            return {};
        return paintNumbers(spanLines(span, Digits::Few), row);
    }

    /// What lies between two heights of the canvas: the triangle, and the names of its corners.
    [[nodiscard]] QRectF takenBetween(double top, double bottom) const
    {
        constexpr QMarginsF kName(90, 40, 90, 40); // around a corner
        const QRectF band(m_view.canvas.left(), top, m_view.canvas.width(), bottom - top);
        QPolygonF triangle;
        QRectF taken;
        for (const ScreenVertex& vertex : m_model.triangle().screen.vertices) {
            const QPointF corner = m_view.at(vertex.position);
            triangle << corner;
            if (const QRectF name = QRectF(corner, QSizeF(0, 0)).marginsAdded(kName); name.intersects(band))
                taken |= name;
        }
        return taken | triangle.intersected(QPolygonF(band)).boundingRect();
    }

    /// A place beside the triangle and the row for a plate whose middle is at a height of the canvas; nothing where it
    /// has no room.
    [[nodiscard]] std::optional<QPointF> placeBeside(QSizeF size, double middle, const QRectF& row) const
    {
        constexpr double kGap = 12;
        const QRectF canvas(m_view.canvas.adjusted(4, 4, -4, -4));
        const double top = middle - size.height() / 2;
        if (top < canvas.top() || top + size.height() > canvas.bottom())
            return std::nullopt;
        QRectF taken = takenBetween(top, top + size.height());
        if (row.bottom() > top && row.top() < top + size.height())
            taken |= row;
        if (taken.right() + kGap + size.width() <= canvas.right())
            return QPointF(taken.right() + kGap, top);
        if (taken.left() - kGap - size.width() >= canvas.left())
            return QPointF(taken.left() - kGap - size.width(), top);
        return std::nullopt;
    }

    /// Beside the triangle, one equation a line if need be, as near to the row as there is room; else below the row.
    QRectF paintNumbers(const QStringList& lines, const QRectF& row) const
    {
        constexpr int kSteps = 30;
        constexpr double kStep = 10; // canvas pixels up and down
        const QFont font = numberFont(0);
        const QRectF canvas(m_view.canvas);
        for (int step = 0; step <= kSteps; ++step)
            for (const QStringList& shown : {lines, narrow(lines)})
                for (const int way : {-1, 1}) {
                    const QSizeF size = textPlate(canvas, canvas.topLeft(), shown, font).size();
                    if (const auto place = placeBeside(size, row.center().y() + way * step * kStep, row))
                        return paintPlate(m_view.painter, canvas, *place, shown, font);
                }
        return paintPlate(m_view.painter, canvas, row.bottomLeft() + QPointF(4, 6), lines, font);
    }

    /// What the two colours are, by the numbers of the sorted corners and the names of the edges; and the half of the
    /// row. It leaves `numbers` free.
    void paintLegend(const QRectF& numbers) const
    {
        const StepTriangle& triangle = m_model.triangle();
        if (!triangle.hasSetup)
            return;
        const auto name = [&](std::size_t i, std::size_t j) { return walkedEdgeName(triangle.setup, m_walk, i, j); };
        QStringList lines{
            translated(QT_TRANSLATE_NOOP("Lens", "long edge 1-3: %1")).arg(name(0, 2)),
            translated(QT_TRANSLATE_NOOP("Lens", "broken edge 1-2-3: %1, %2")).arg(name(0, 1), name(1, 2))};
        if (const auto upper = upperHalf())
            lines << (*upper ? translated(QT_TRANSLATE_NOOP("Lens", "upper half: short edge %1")).arg(name(0, 1))
                             : translated(QT_TRANSLATE_NOOP("Lens", "lower half: short edge %1")).arg(name(1, 2)));
        const QFont font = textFont(0);
        const double spacing = QFontMetricsF(font).lineSpacing();
        constexpr double kSwatch = 34;
        const QString room(int(std::ceil((kSwatch + 8) / QFontMetricsF(font).horizontalAdvance(QLatin1Char(' ')))),
                           QLatin1Char(' '));
        QStringList indented;
        for (const QString& line : lines)
            indented << room + line;
        const double height = spacing * double(lines.size()) + 10;
        const QPointF corner = legendCorner(indented, font, height, numbers);
        paintPlate(m_view.painter, m_view.canvas, corner, indented, font);
        for (int i = 0; i < 2; ++i) {
            const QPointF from = corner + QPointF(8, 5 + spacing * (i + 0.5));
            const QColor color(i == 0 ? kCanvasLongEdge : kCanvasBrokenEdge);
            m_view.painter.setPen(QPen(Qt::white, 6.5, Qt::SolidLine, Qt::FlatCap));
            m_view.painter.drawLine(from, from + QPointF(kSwatch, 0));
            m_view.painter.setPen(QPen(color, kActiveLine, i == 0 ? Qt::SolidLine : kBrokenStyle, Qt::FlatCap));
            m_view.painter.drawLine(from, from + QPointF(kSwatch, 0));
        }
    }

    /// Below, as messages are above, and at the left, unless a corner of the triangle with its letter, or the numbers,
    /// would lie under the legend there; then in another corner of the canvas.
    [[nodiscard]] QPointF legendCorner(const QStringList& lines, const QFont& font, double height,
                                       const QRectF& numbers) const
    {
        constexpr double kGap = 10;
        double width = 2 * kGap;
        for (const QString& line : lines)
            width = std::max(width, QFontMetricsF(font).horizontalAdvance(line) + 2 * kGap);
        const QRectF canvas(m_view.canvas);
        const double right = canvas.right() - kGap - width;
        const double left = canvas.left() + kGap;
        const double below = canvas.bottom() - height - kGap;
        const std::array corners{QPointF(left, below), QPointF(right, below), QPointF(right, canvas.top() + kGap)};
        for (const double letter : {1.6 * QFontMetricsF(textFont(3, true)).height(), 0.0})
            for (const QPointF& corner : corners) {
                const QRectF plate(corner, QSizeF(width, height));
                const QRectF kept = plate.adjusted(-letter, -letter, letter, letter);
                const auto isUnder = [&](const ScreenVertex& vertex) {
                    return kept.contains(m_view.at(vertex.position));
                };
                if (!plate.intersects(numbers) && std::ranges::none_of(m_model.triangle().screen.vertices, isUnder))
                    return corner;
            }
        return {right, below};
    }

    const LensView& m_view;
    const LensModel& m_model;
    const WalkedTriangle& m_walk;
    StepKind m_now = StepKind::End; ///< the present step, if it is one of the triangle's
    int m_row = -1;                 ///< the present row, in samples; -1: none
};

} // namespace

void paintWalk(const LensView& view, const LensModel& model)
{
    if (const WalkedTriangle* walk = model.sides(); walk != nullptr)
        WalkPainter(view, model, *walk).paint();
}

QString walkedCornerName(const LensModel& model, std::size_t vertex)
{
    const QString letter = cornerLetter(vertex);
    const WalkedTriangle* walk = model.walk();
    if (walk == nullptr)
        return letter;
    const auto at = std::ranges::find(walk->source, vertex);
    return QStringLiteral("%1 = %2").arg(letter).arg(at - walk->source.begin() + 1);
}

} // namespace rasterlens
