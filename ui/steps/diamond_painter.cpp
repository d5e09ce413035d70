#include "ui/steps/diamond_painter.h"

#include "core/observe/step_text.h"
#include "core/render/line_samples.h"
#include "core/settings/depth_rules.h"
#include "ui/base/inks.h"
#include "ui/base/theme.h"

#include <QCoreApplication>

#include <vector>

namespace rasterlens
{
namespace
{

QString translated(const char* text) { return QCoreApplication::translate("Lens", text); }

bool goesByDiamonds(const LensModel& model)
{
    const StepEvent* event = model.event();
    const Rules rules = passRules(model.log().rules(), event ? event->face : 0);
    return rules.fill == Fill::Wireframe && rules.lineRule == LineRule::DiamondExit;
}

/// A line of the triangle, from the corner that it starts at. Samples.
struct Line {
    QString name; ///< `AB`
    glm::dvec2 from;
    glm::dvec2 to;

    [[nodiscard]] glm::dvec2 at(double t) const { return from + t * (to - from); }
};

/// The lines that the triangle draws.
std::vector<Line> linesOf(const LensModel& model)
{
    const ScreenTriangle& triangle = model.triangle().screen;
    std::vector<Line> lines;
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        if (triangle.drawsEdge(i))
            lines.push_back({QStringLiteral("%1%2").arg(QChar(u'A' + char16_t(i))).arg(QChar(u'A' + char16_t(j))),
                             triangle.vertices[i].position, triangle.vertices[j].position});
    }
    return lines;
}

QPolygonF diamond(const LensView& view, int column, int row)
{
    const QRectF box = view.box(column, row);
    return {{QPointF(box.center().x(), box.top()), QPointF(box.right(), box.center().y()),
             QPointF(box.center().x(), box.bottom()), QPointF(box.left(), box.center().y())}};
}

/// A disc with a light rim; hollow where the line comes in.
void paintDot(const LensView& view, const glm::dvec2& at, const QColor& color, bool filled)
{
    const double radius = view.thickness(3.5);
    view.painter.setPen(QPen(Qt::white, view.thickness(4)));
    view.painter.setBrush(filled ? color : QColor(Qt::white));
    view.painter.drawEllipse(view.at(at), radius, radius);
    view.painter.setPen(QPen(color, view.thickness(2)));
    view.painter.drawEllipse(view.at(at), radius, radius);
}

void paintDiamond(const LensView& view, const Line& line, const MetDiamond& met)
{
    const QColor color(met.drawn ? kCanvasPlus : kCanvasMinus);
    const QPolygonF border = diamond(view, met.column, met.row);
    view.painter.setBrush(Qt::NoBrush);
    view.painter.setPen(QPen(QColor(255, 255, 255, 200), view.thickness(4)));
    view.painter.drawPolygon(border);
    view.painter.setPen(QPen(color, view.thickness(2), met.drawn ? Qt::SolidLine : Qt::DashLine));
    view.painter.drawPolygon(border);
    if (view.cell < 2 * kGlyphsFromCell)
        return;
    if (met.enters > 0)
        paintDot(view, line.at(met.enters), color, false);
    if (met.leaves < 1)
        paintDot(view, line.at(met.leaves), color, true);
}

QString pointText(const glm::dvec2& at) { return QStringLiteral("(%1, %2)").arg(shortNumber(at.x), shortNumber(at.y)); }

QString wordsOf(const Line& line, const MetDiamond& diamond)
{
    const QString enters = diamond.enters > 0
                               ? translated(QT_TRANSLATE_NOOP("Lens", "%1 enters the diamond at %2"))
                                     .arg(line.name, pointText(line.at(diamond.enters)))
                               : translated(QT_TRANSLATE_NOOP("Lens", "%1 starts in the diamond")).arg(line.name);
    const QString leaves =
        diamond.leaves < 1
            ? translated(QT_TRANSLATE_NOOP("Lens", "leaves it at %1")).arg(pointText(line.at(diamond.leaves)))
            : translated(QT_TRANSLATE_NOOP("Lens", "ends at its border or within"));
    const QString drawn = diamond.drawn ? translated(QT_TRANSLATE_NOOP("Lens", "drawn"))
                                        : translated(QT_TRANSLATE_NOOP("Lens", "not drawn"));
    return QStringLiteral("%1, %2: %3").arg(enters, leaves, drawn);
}

} // namespace

void paintDiamonds(LensView& view, const LensModel& model)
{
    if (!goesByDiamonds(model) || view.cell < kGlyphsFromCell)
        return;
    const Rules& rules = model.log().rules();
    const QRect seen = view.visible({0, 0, rules.columns(), rules.rows()});
    for (const Line& line : linesOf(model)) {
        view.line(line.from, line.to, QColor(Qt::black), 1.8, Qt::SolidLine);
        for (const MetDiamond& met : diamondsOf(line.from, line.to, {seen.x(), seen.y(), seen.width(), seen.height()}))
            paintDiamond(view, line, met);
    }
    const StepEvent* now = model.event();
    if (now == nullptr || !model.ownsEvent() || now->x < 0 || now->y < 0)
        return;
    const QStringList words = diamondWords(model, now->x, now->y);
    if (!words.isEmpty())
        paintPlate(view.painter, view.canvas, view.box(now->x + 1, now->y + 1).topLeft(), words, numberFont(0));
}

QStringList diamondWords(const LensModel& model, int x, int y)
{
    QStringList words;
    if (!goesByDiamonds(model))
        return words;
    for (const Line& line : linesOf(model))
        for (const MetDiamond& met : diamondsOf(line.from, line.to, {x, y, 1, 1}))
            words << wordsOf(line, met);
    return words;
}

} // namespace rasterlens
