#include "ui/steps/lens_glyphs.h"

#include "core/observe/names.h"
#include "core/observe/step_text.h"
#include "ui/base/inks.h"
#include "ui/base/theme.h"
#include "ui/steps/pattern_painter.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPainter>
#include <QPalette>

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

namespace rasterlens
{

GlyphColors glyphColors(EdgeSign sign, bool isHollow)
{
    const QPalette palette = QGuiApplication::palette();
    const QColor fill = palette.color(QPalette::Base);
    const bool hasColor = sign == EdgeSign::Plus || sign == EdgeSign::Minus;
    if (!hasColor)
        return {isHollow ? fill : QColor(Qt::white), isHollow ? palette.color(QPalette::Text) : QColor(Qt::black)};
    const Inks inks = inksFor(palette);
    if (isHollow)
        return {fill, sign == EdgeSign::Plus ? inks.plus : inks.minus};
    return {QColor(sign == EdgeSign::Plus ? kCanvasPlus : kCanvasMinus), Qt::white};
}

QColor lensVeil(const LensCell& cell, const QColor& paper)
{
    const bool waiting = cell.state == LensCell::State::Waiting;
    bool inside = cell.state == LensCell::State::Covered;
    if (waiting && cell.hasValues)
        inside =
            std::none_of(cell.signs.begin(), cell.signs.end(), [](EdgeSign sign) { return sign == EdgeSign::Minus; });
    const double tint = inside ? (waiting ? 0.07 : 0.17) : 0;
    const QColor plus(kCanvasPlus);
    const auto mixed = [&](int a, int b) { return int(std::lround(a + (b - a) * tint)); };
    return {mixed(paper.red(), plus.red()), mixed(paper.green(), plus.green()), mixed(paper.blue(), plus.blue()),
            waiting ? 246 : 250};
}

QColor lensNumberColor(LensCell::State state)
{
    constexpr int kWaiting = 200;
    QColor ink = QGuiApplication::palette().color(QPalette::Text);
    ink.setAlpha(state == LensCell::State::Waiting ? kWaiting : 255);
    return ink;
}

void paintGlyph(QPainter& painter, QPointF centre, double diameter, EdgeSign sign, std::size_t edge, bool isHollow)
{
    const double r = diameter / 2;
    const double stroke = std::max(1.0, diameter / 7);
    const GlyphColors colors = glyphColors(sign, isHollow);
    painter.setBrush(colors.disc);
    painter.setPen(QPen(QColor(kEdgeLooks[edge].color), std::max(1.0, diameter / 9)));
    painter.drawEllipse(centre, r - stroke / 2, r - stroke / 2);
    const double arm = r * 0.5;
    if (sign == EdgeSign::Plus || sign == EdgeSign::Minus) {
        painter.setPen(QPen(colors.sign, stroke, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(centre - QPointF(arm, 0), centre + QPointF(arm, 0));
        if (sign == EdgeSign::Plus)
            painter.drawLine(centre - QPointF(0, arm), centre + QPointF(0, arm));
    } else if (sign == EdgeSign::Zero) {
        painter.setPen(QPen(colors.sign, std::max(1.0, diameter / 9)));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(centre, r * 0.28, r * 0.42);
    } else {
        painter.setPen(QPen(colors.sign, stroke));
        painter.drawLine(centre - QPointF(arm, arm) * 0.7, centre + QPointF(arm, arm) * 0.7);
        painter.drawLine(centre - QPointF(arm, -arm) * 0.7, centre + QPointF(arm, -arm) * 0.7);
    }
}

namespace
{

/// A place at the canvas's left or right border that leaves free the samples looked at and the letters of the corners.
///
/// in  `samples`: those within the bounds of the set-up, on the canvas
std::optional<QRectF> placeOfLegend(const QRectF& canvas, QSizeF size, const QRectF& samples, const StepSetup& setup)
{
    constexpr double kGap = 8;
    const PixelRect& bounds = setup.bounds;
    const double scale = samples.width() / bounds.width;
    const QRectF kept = samples.adjusted(-kGap, -kGap, kGap, kGap);
    const double letter = 1.6 * QFontMetricsF(textFont(3, true)).height();
    const auto isFree = [&](const QRectF& plate) {
        const auto isUnder = [&](const glm::dvec2& vertex) {
            const QPointF corner = samples.topLeft() + QPointF(vertex.x - bounds.x, vertex.y - bounds.y) * scale;
            return plate.intersects(QRectF(corner - QPointF(letter, letter), QSizeF(2 * letter, 2 * letter)));
        };
        return canvas.contains(plate) && !plate.intersects(kept) && std::ranges::none_of(setup.vertices, isUnder);
    };
    const double middle = canvas.center().y() - size.height() / 2;
    for (const double x : {canvas.right() - kGap - size.width(), canvas.left() + kGap})
        for (const double y : {canvas.top() + kGap, middle, canvas.bottom() - kGap - size.height()})
            if (const QRectF plate(QPointF(x, y), size); isFree(plate))
                return plate;
    return std::nullopt;
}

/// A line of the legend below those of the edges.
struct LegendRow {
    std::function<void(QPainter& painter, QPointF centre, double diameter)> paintMark; ///< none: words alone
    QString text;
};

QString translated(const char* text) { return QCoreApplication::translate("Lens", text); }

std::vector<LegendRow> signRows(bool hasNumbers)
{
    const auto glyph = [](EdgeSign sign) {
        return [sign](QPainter& painter, QPointF centre, double diameter) {
            paintGlyph(painter, centre, diameter, sign, 0, false);
        };
    };
    std::vector<LegendRow> rows{
        {glyph(EdgeSign::Plus), translated(QT_TRANSLATE_NOOP("Lens", "inside this edge"))},
        {glyph(EdgeSign::Minus), translated(QT_TRANSLATE_NOOP("Lens", "outside it"))},
        {glyph(EdgeSign::Zero), translated(QT_TRANSLATE_NOOP("Lens", "exactly on it"))},
    };
    if (hasNumbers)
        rows.push_back({{}, translated(QT_TRANSLATE_NOOP("Lens", "number: E, px\u00b2"))});
    return rows;
}

std::vector<LegendRow> patternRows(AttributeAt attributeAt)
{
    const auto sample = [](bool isCovered) {
        return [isCovered](QPainter& painter, QPointF centre, double diameter) {
            paintSampleMark(painter, centre, diameter / 3, isCovered);
        };
    };
    const auto place = [](bool isOutside) {
        return [isOutside](QPainter& painter, QPointF centre, double diameter) {
            paintPlaceMark(painter, centre, diameter / 3, isOutside);
        };
    };
    std::vector<LegendRow> rows{
        {sample(true), translated(QT_TRANSLATE_NOOP("Lens", "sample, covered"))},
        {sample(false), translated(QT_TRANSLATE_NOOP("Lens", "not covered"))},
    };
    if (attributeAt != AttributeAt::Sample)
        rows.push_back({place(false), translated(QT_TRANSLATE_NOOP("Lens", "shaded here"))});
    if (attributeAt == AttributeAt::Centre)
        rows.push_back({place(true), translated(QT_TRANSLATE_NOOP("Lens", "shaded outside"))});
    return rows;
}

std::vector<LegendRow> rowsOf(const LensLegend& legend)
{
    return legend.isPattern ? patternRows(legend.attributeAt) : signRows(legend.hasNumbers);
}

constexpr double kLegendPad = 8;

/// The lengths of a legend in the window's type.
struct LegendMetrics {
    QFont font = textFont(-1);
    QFontMetricsF metrics{font};
    double row = metrics.height() * 1.3;
    double glyph = metrics.height() * 0.9;
    double line = metrics.height() * 1.8; ///< that stands for an edge

    [[nodiscard]] double indent(const LegendRow& of) const { return of.paintMark ? glyph * 1.4 : 0; }
};

} // namespace

LensLegend::LensLegend(const StepSetup& setup, const Rules& rules, bool withNumbers)
    : isPattern(rules.multiSampled()), attributeAt(rules.attributeAt), hasNumbers(withNumbers)
{
    for (std::size_t edge = 0; edge < edges.size(); ++edge)
        edges[edge] = edgeName(setup, static_cast<int>(edge));
}

QSizeF LensLegend::size() const
{
    const LegendMetrics m;
    const std::vector<LegendRow> rows = rowsOf(*this);
    double width = 0;
    for (const LegendRow& row : rows)
        width = std::max(width, m.indent(row) + m.metrics.horizontalAdvance(row.text));
    return {width + 2 * kLegendPad, double(edges.size() + rows.size()) * m.row + kLegendPad};
}

void LensLegend::paint(QPainter& painter, const QRectF& plate) const
{
    const LegendMetrics m;
    const QPalette palette = QGuiApplication::palette();
    painter.setPen(QPen(palette.color(QPalette::Mid), 1));
    painter.setBrush(palette.color(QPalette::Base));
    painter.drawRoundedRect(plate, 6, 6);
    painter.setFont(m.font);
    QPointF at = plate.topLeft() + QPointF(kLegendPad, kLegendPad / 2 + m.row / 2);
    const auto write = [&](double x, const QString& text) {
        painter.setPen(palette.color(QPalette::Text));
        painter.drawText(QPointF(at.x() + x, at.y() + m.metrics.ascent() / 2 - 1), text);
        at.ry() += m.row;
    };
    for (std::size_t edge = 0; edge < edges.size(); ++edge) {
        painter.setPen(QPen(QColor(kEdgeLooks[edge].color), 3, kEdgeLooks[edge].style, Qt::FlatCap));
        painter.drawLine(at, at + QPointF(m.line, 0));
        write(m.line + 8, edges[edge]);
    }
    for (const LegendRow& row : rowsOf(*this)) {
        if (row.paintMark)
            row.paintMark(painter, at + QPointF(m.glyph / 2, 0), m.glyph);
        write(m.indent(row), row.text);
    }
}

QRectF paintLensLegend(QPainter& painter, const QRect& canvas, const QRectF& samples, const StepSetup& setup,
                       const LensLegend& legend)
{
    const auto plate = placeOfLegend(canvas, legend.size(), samples, setup);
    if (!plate)
        return {};
    legend.paint(painter, *plate);
    return *plate;
}

} // namespace rasterlens
