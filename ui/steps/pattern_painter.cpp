#include "ui/steps/pattern_painter.h"

#include "core/observe/step_text.h"
#include "ui/base/inks.h"
#include "ui/base/language.h"
#include "ui/base/theme.h"

#include <QCoreApplication>

#include <algorithm>
#include <bit>

namespace rasterlens
{
namespace
{

constexpr double kWordsFromCell = 24; ///< canvas pixels a pixel

QString translated(const char* text) { return QCoreApplication::translate("Lens", text); }

/// A pixel of the triangle: what it covers of it, and where it is shaded.
struct PatternPixel {
    int x;
    int y;
    SampleMask covered;
    glm::dvec2 shadedAt; ///< pixels
    bool shadedOutside;  ///< of the triangle
};

PatternPixel patternPixel(const LensModel& model, int x, int y)
{
    const Rules& rules = model.log().rules();
    const StepSetup& setup = model.triangle().setup;
    PatternPixel pixel{x, y, coveredSamples(setup, rules, x, y), {}, false};
    pixel.shadedAt = glm::dvec2(x + 0.5, y + 0.5) + shadingOffset(rules, pixel.covered);
    pixel.shadedOutside = !decidingEdge(setup, setup.at(pixel.shadedAt), rules).isInside();
    return pixel;
}

bool isEach(const Rules& rules) { return rules.attributeAt == AttributeAt::Sample; }

void paintSamples(const LensView& view, const Rules& rules, const PatternPixel& pixel, int present)
{
    const double radius = std::clamp(view.cell * (rules.patternSamples > 8 ? 0.045 : 0.06), 2.0, 7.0);
    for (int sample = 0; sample < rules.patternSamples; ++sample) {
        const QPointF at = view.at(testedPoint(rules, pixel.x, pixel.y, sample));
        paintSampleMark(view.painter, at, radius, (pixel.covered >> sample & 1U) != 0, view.thickness(1));
        if (sample != present)
            continue;
        view.painter.setBrush(Qt::NoBrush);
        view.painter.setPen(QPen(Qt::white, view.thickness(4.4)));
        view.painter.drawEllipse(at, radius + 4, radius + 4);
        view.painter.setPen(QPen(Qt::black, view.thickness(2.2)));
        view.painter.drawEllipse(at, radius + 4, radius + 4);
    }
}

/// `E_BC = -0.375, E_CA = -2`: the edges by which a point is outside.
QString edgesOutside(const StepSetup& setup, const glm::dvec2& point)
{
    const EdgeValues values = setup.at(point);
    QStringList edges;
    for (std::size_t i = 0; i < 3; ++i)
        if (values[i] < setup.edges[i].threshold)
            edges << QStringLiteral("%1 = %2").arg(edgeValueName(setup, int(i)),
                                                   edgeValueText(values[i], setup.unitsPerArea));
    return edges.join(QStringLiteral(", "));
}

QString numbersOf(SampleMask samples)
{
    QStringList numbers;
    for (SampleMask left = samples; left != 0; left &= static_cast<SampleMask>(left - 1))
        numbers << QString::number(std::countr_zero(left) + 1);
    return listed(numbers);
}

QString placeWords(const LensModel& model, const PatternPixel& pixel)
{
    const Rules& rules = model.log().rules();
    if (isEach(rules))
        return translated(QT_TRANSLATE_NOOP("Lens", "shaded at each of them"));
    if (shadingOffset(rules, pixel.covered) != glm::dvec2(0))
        return translated(QT_TRANSLATE_NOOP("Lens", "shaded once, at sample %1, the first covered one"))
            .arg(std::countr_zero(pixel.covered) + 1);
    if (!pixel.shadedOutside)
        return translated(QT_TRANSLATE_NOOP("Lens", "shaded once, at the centre"));
    return translated(QT_TRANSLATE_NOOP("Lens", "shaded once, at the centre, outside of the face: %1"))
        .arg(edgesOutside(model.triangle().setup, pixel.shadedAt));
}

} // namespace

void paintSampleMark(QPainter& painter, QPointF at, double radius, bool isCovered, double thickness)
{
    painter.setPen(QPen(Qt::white, 3 * thickness));
    painter.setBrush(isCovered ? QColor(kCanvasPlus) : QColor(Qt::white));
    painter.drawEllipse(at, radius, radius);
    painter.setPen(QPen(isCovered ? QColor(kCanvasPlus).darker(160) : QColor(90, 96, 106), 1.4 * thickness));
    painter.drawEllipse(at, radius, radius);
}

void paintPlaceMark(QPainter& painter, QPointF at, double arm, bool isOutside, double thickness)
{
    const QColor color(isOutside ? kCanvasMinus : kCanvasPlus);
    for (const auto& [ink, width] : {std::pair(QColor(Qt::white), 4.5), std::pair(color, 2.4)}) {
        painter.setPen(QPen(ink, width * thickness));
        painter.drawLine(at - QPointF(arm, arm), at + QPointF(arm, arm));
        painter.drawLine(at + QPointF(-arm, arm), at + QPointF(arm, -arm));
    }
}

QStringList patternWords(const LensModel& model, int x, int y)
{
    const Rules& rules = model.log().rules();
    const PatternPixel pixel = patternPixel(model, x, y);
    const QString title = translated(QT_TRANSLATE_NOOP("Lens", "pixel (%1, %2): ")).arg(x).arg(y);
    if (pixel.covered == 0)
        return {title +
                translated(QT_TRANSLATE_NOOP("Lens", "none of %1 samples is covered")).arg(rules.patternSamples)};
    return {title + translated(QT_TRANSLATE_NOOP("Lens", "%1 of %2 samples are covered: %3"))
                        .arg(std::popcount(pixel.covered))
                        .arg(rules.patternSamples)
                        .arg(numbersOf(pixel.covered)),
            placeWords(model, pixel)};
}

void paintPattern(LensView& view, const LensModel& model)
{
    const StepLog& log = model.log();
    if (!log.rules().multiSampled() || !model.hasSetup() || view.cell < kGlyphsFromCell)
        return;
    const StepEvent* now = model.event();
    const bool isHere = now != nullptr && model.ownsEvent() && now->x >= 0 && now->y >= 0;
    const QRect shown = view.visible(model.triangle().setup.bounds);
    for (int y = shown.top(); y <= shown.bottom(); ++y)
        for (int x = shown.left(); x <= shown.right(); ++x) {
            const PatternPixel pixel = patternPixel(model, x, y);
            paintSamples(view, log.rules(), pixel, isHere && now->x == x && now->y == y ? int(now->sample) : -1);
            if (pixel.covered != 0 && !isEach(log.rules()))
                paintPlaceMark(view.painter, view.at(pixel.shadedAt), std::clamp(view.cell * 0.11, 3.0, 9.0),
                               pixel.shadedOutside, view.thickness(1));
        }
}

void paintPatternWords(LensView& view, const LensModel& model)
{
    const StepEvent* now = model.event();
    if (!model.log().rules().multiSampled() || !model.hasSetup() || now == nullptr || !model.ownsEvent())
        return;
    if (now->x >= 0 && now->y >= 0 && view.cell >= kWordsFromCell && !view.options.hoveredPixel)
        paintPlate(view.painter, view.canvas, view.box(now->x + 1, now->y + 1).topLeft() + QPointF(6, 6),
                   patternWords(model, now->x, now->y), numberFont(0));
}

} // namespace rasterlens
