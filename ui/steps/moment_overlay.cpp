#include "ui/steps/moment_overlay.h"

#include "core/observe/names.h"
#include "ui/base/inks.h"
#include "ui/base/language.h"
#include "ui/base/step_words.h"
#include "ui/base/theme.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <numeric>

namespace rasterlens
{
namespace
{

constexpr double kOutline = 2.6;
constexpr double kOutlineBefore = 1.6;

QString translated(const char* text) { return QCoreApplication::translate("Moment", text); }

QString stepLine(const FaceMoment& moment, const Rules& rules)
{
    const auto cornerName = [&] {
        return moment.corner < moment.corners.size() ? moment.corners[moment.corner].name : QString();
    };
    const auto corners = [&] {
        return moment.corners.empty()
                   ? translated(QT_TRANSLATE_NOOP("Moment", "nothing is left"))
                   : translated(QT_TRANSLATE_NOOP("Moment", "%1 corners are left")).arg(moment.corners.size());
    };
    switch (moment.kind) {
    case StepKind::Vertex:
        return translated(QT_TRANSLATE_NOOP("Moment", "corner %1 comes from the mesh")).arg(cornerName());
    case StepKind::ClipPlane:
        return translated(QT_TRANSLATE_NOOP("Moment", "cut by the plane %1: %2"))
            .arg(stepWords(Reason(clipPlaneId(*moment.plane))), corners());
    case StepKind::CohenSutherland:
        return translated(QT_TRANSLATE_NOOP("Moment", "cut at the sides of the screen: %1")).arg(corners());
    case StepKind::Viewport: {
        const auto place = moment.corner < moment.corners.size() ? moment.corners[moment.corner].snapped : std::nullopt;
        if (!place)
            break;
        const glm::dvec2 pixels = *place / double(rules.sampleGrid);
        return translated(QT_TRANSLATE_NOOP("Moment", "corner %1 goes to pixel position (%2, %3)"))
            .arg(cornerName(), shortNumber(pixels.x), shortNumber(pixels.y));
    }
    case StepKind::Facing:
    case StepKind::Fate:
        if (moment.fate)
            return translated(QT_TRANSLATE_NOOP("Moment", "verdict: %1"))
                .arg(stepWords(Reason(faceFateId(*moment.fate))));
        break;
    case StepKind::Clipped: return translated(QT_TRANSLATE_NOOP("Moment", "what is left is drawn as a fan"));
    case StepKind::Triangle:
    case StepKind::Setup:
    case StepKind::Outline:
    case StepKind::Walk:
    case StepKind::Sides:
    case StepKind::Halves:
    case StepKind::Crossing:
    case StepKind::Span:
    case StepKind::Column:
    case StepKind::Sample:
    case StepKind::LineDecision:
    case StepKind::LinePosition:
    case StepKind::LineSample:
    case StepKind::Fragment:
    case StepKind::Shade:
    case StepKind::Write:
    case StepKind::Resolve:
    case StepKind::End: break;
    }
    return {};
}

} // namespace

QStringList momentLines(const FaceMoment& moment, const Rules& rules)
{
    const QString step = stepLine(moment, rules);
    QStringList lines{
        step.isEmpty()
            ? translated(QT_TRANSLATE_NOOP("Moment", "face %1")).arg(moment.face)
            : translated(QT_TRANSLATE_NOOP("Moment", "face %1: %2")).arg(QString::number(moment.face), step)};
    QStringList behind;
    for (const MomentCorner& corner : moment.corners)
        if (!corner.onScreen(rules))
            behind << corner.name;
    if (!behind.isEmpty())
        lines << translated(QT_TRANSLATE_NOOP("Moment", "not in front of the eye: %1")).arg(listed(behind));
    return lines;
}

void MomentOverlay::paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                          const OverlayOptions& options) const
{
    if (!m_moment)
        return;
    const int grid = m_rules.sampleGrid;
    LensView view{painter, canvas, transform, options, grid, transform.zoom / grid, {}};
    painter.save();
    painter.setClipRect(canvas);
    painter.setRenderHint(QPainter::Antialiasing);
    paintArea(view);
    paintOutline(view, m_moment->before, QColor(kCanvasMinus), kOutlineBefore, Qt::DashLine);
    paintOutline(view, m_moment->corners, QColor(kCanvasPlus), kOutline, Qt::SolidLine);
    const std::vector<QRectF> taken = paintCorners(view);
    const QStringList lines = momentLines(*m_moment, m_rules);
    const QFont font = textFont(options.thickLines ? 2 : 0);
    const QSizeF size = textPlate(canvas, canvas.topLeft(), lines, font).size();
    paintPlate(painter, canvas, freeCorner(canvas, size, taken), lines, font);
    painter.restore();
}

void MomentOverlay::paintOutline(LensView& view, const std::vector<MomentCorner>& corners, const QColor& color,
                                 double width, Qt::PenStyle style) const
{
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n && n > 1; ++i) {
        if (n == 2 && i == 1)
            break; // one edge, not there and back
        if (const auto edge = edgeOnScreen(corners[i], corners[(i + 1) % n], m_rules))
            view.line((*edge)[0], (*edge)[1], color, width, style);
    }
}

/// The polygon's area, if all of it is in front of the eye.
void MomentOverlay::paintArea(LensView& view) const
{
    QPolygonF area;
    for (const MomentCorner& corner : m_moment->corners)
        if (const auto place = corner.onScreen(m_rules))
            area << view.at(*place);
    if (std::size_t(area.size()) != m_moment->corners.size() || area.size() < 3)
        return;
    view.painter.setPen(Qt::NoPen);
    view.painter.setBrush(withAlpha(QColor(kCanvasPlus), 40));
    view.painter.drawPolygon(area);
}

/// A dot for each corner, filled once it stands on the screen, and its name beside it, away from the others; what they
/// take up.
std::vector<QRectF> MomentOverlay::paintCorners(LensView& view) const
{
    QPolygonF places;
    for (const MomentCorner& corner : m_moment->corners)
        if (const auto place = corner.onScreen(m_rules))
            places << view.at(*place);
    const QRectF extent = places.boundingRect();
    // A face that is hardly to be seen is not to be hidden by its corners.
    const double radius = std::clamp(std::max(extent.width(), extent.height()) / 8, 1.5, view.thickness(4.5));
    const QPointF middle = std::accumulate(places.begin(), places.end(), QPointF()) / std::max(1, int(places.size()));
    std::vector<NamedPlace> names;
    for (const MomentCorner& corner : m_moment->corners) {
        const auto place = corner.onScreen(m_rules);
        if (!place)
            continue;
        names.push_back({view.at(*place), corner.name});
        view.painter.setPen(QPen(corner.snapped ? Qt::white : Qt::black, view.thickness(1.6)));
        view.painter.setBrush(corner.snapped ? QColor(kCanvasPlus) : QColor(Qt::white));
        view.painter.drawEllipse(names.back().at, radius, radius);
    }
    view.painter.setFont(textFont(view.options.thickLines ? 2 : 1, true));
    const std::vector<LensView::NamePlate> plates = view.namePlates(names, middle);
    view.paintNames(plates);
    std::vector<QRectF> taken;
    for (const LensView::NamePlate& plate : plates)
        taken.push_back(plate.plate);
    for (const NamedPlace& name : names)
        taken.emplace_back(name.at - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
    return taken;
}

} // namespace rasterlens
