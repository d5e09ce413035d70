#include "ui/steps/lens_overlay.h"

#include "core/observe/step_text.h"
#include "ui/base/inks.h"
#include "ui/base/theme.h"
#include "ui/steps/diamond_painter.h"
#include "ui/steps/pattern_painter.h"
#include "ui/steps/step_formula.h"
#include "ui/steps/walk_painter.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPainter>
#include <QPalette>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace rasterlens
{
namespace
{

/// The corners of a rectangle for which inside(corner) >= 0, and where its border changes sides.
template <class Distance>
QPolygonF halfOf(const QRectF& box, Distance distance)
{
    const std::array corners{box.topLeft(), box.topRight(), box.bottomRight(), box.bottomLeft()};
    QPolygonF half;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const QPointF a = corners[i];
        const QPointF b = corners[(i + 1) % corners.size()];
        const double da = distance(a);
        const double db = distance(b);
        if (da >= 0)
            half << a;
        if ((da >= 0) != (db >= 0))
            half << a + (b - a) * (da / (da - db));
    }
    return half;
}

/// The samples within the bounds of a triangle, on the canvas.
QRectF boundsOf(const LensView& view, const StepSetup& setup)
{
    const PixelRect& b = setup.bounds;
    return {view.at({b.x, b.y}), view.at({b.x + b.width, b.y + b.height})};
}

/// A frame within a sample, on a light rim that any picture lets see.
void paintFrame(QPainter& painter, const QRectF& box, const QPen& pen)
{
    const QRectF frame = box.adjusted(2, 2, -2, -2);
    painter.setPen(QPen(QColor(255, 255, 255, 200), pen.widthF() + 2.4));
    painter.drawRect(frame);
    painter.setPen(pen);
    painter.drawRect(frame);
}

double glyphDiameter(double cell) { return std::min(cell * 0.28, 42.0); }

/// Numbers grow with the samples, up to the size of the window's type and a little beyond.
int numberPixels(double cell, bool isLarge)
{
    const int most = std::max(18, QFontInfo(QGuiApplication::font()).pixelSize());
    return std::clamp(int(cell / (isLarge ? 4.2 : 5)), 10, most);
}

QPointF glyphCentre(const QRectF& box, std::size_t edge)
{
    const double d = glyphDiameter(box.width());
    return {box.center().x() + (double(edge) - 1) * d * 1.08 + 0.5, box.top() + box.height() * 0.8};
}

quint32 tileKey(const LensCell& cell)
{
    return static_cast<quint32>(cell.signs[0]) | static_cast<quint32>(cell.signs[1]) << 2 |
           static_cast<quint32>(cell.signs[2]) << 4 | static_cast<quint32>(cell.state) << 6 |
           static_cast<quint32>(cell.hasValues) << 8;
}

} // namespace

void LensOverlay::paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                        const OverlayOptions& options) const
{
    if (!m_model)
        return;
    const int grid = m_model->log().grid();
    LensView view{painter, canvas, transform, options, grid, transform.zoom / grid, {}};
    painter.save();
    painter.setClipRect(canvas);
    if (m_model->hasSetup() && view.cell >= kGridFromZoom / 2) {
        lookFar(view);
        if (view.cell >= kGlyphsFromCell)
            paintCells(view);
        else
            paintVeils(view);
        paintBounds(view);
    }
    painter.setRenderHint(QPainter::Antialiasing);
    paintEdges(view);
    paintTies(view);
    // The samples of a pattern lie where the numbers would be; the pointer asks for those.
    const bool hasNumbers = view.cell >= kLensNumbersFromCell && !m_model->log().rules().multiSampled();
    if (m_model->hasSetup() && hasNumbers)
        paintNumbers(view);
    paintPattern(view, *m_model);
    paintWalkOfSample(view);
    paintLine(view);
    paintLinePosition(view);
    paintDiamonds(view, *m_model);
    paintColumn(view);
    paintCurrent(view);
    paintCorners(view);
    paintHover(view);
    m_legendPlate = {};
    if (const auto legend = legendAt(view.cell); legend && view.cell >= kGlyphsFromCell && !m_isLegendBeside)
        m_legendPlate = paintLensLegend(painter, canvas, boundsOf(view, m_model->triangle().setup),
                                        m_model->triangle().setup, *legend);
    paintPatternWords(view, *m_model);
    painter.restore();
}

/// Edge walking has a legend of its own, and no signs.
std::optional<LensLegend> LensOverlay::legendAt(double cell) const
{
    if (!m_model || !m_model->hasSetup() || m_model->sides() != nullptr)
        return std::nullopt;
    const Rules& rules = m_model->log().rules();
    return LensLegend(m_model->triangle().setup, rules, cell >= kLensNumbersFromCell && !rules.multiSampled());
}

/// With a pattern edge walking walks a triangle that is moved, so that the sample lies at the centre of its pixel.
void LensOverlay::paintWalkOfSample(LensView& view) const
{
    const Rules& rules = m_model->log().rules();
    if (!rules.multiSampled()) {
        paintWalk(view, *m_model);
        return;
    }
    const glm::dvec2 offset = testedOffset(rules, m_model->sample()).pixels() * view.transform.zoom;
    view.painter.translate(offset.x, offset.y);
    paintWalk(view, *m_model);
    view.painter.translate(-offset.x, -offset.y);
}

/// What the record's window no longer holds of the samples in sight is made anew.
void LensOverlay::lookFar(const LensView& view) const
{
    const QRect seen = view.visible(m_model->triangle().setup.bounds);
    if (!m_coverage || !m_model->wantsFar() || seen.isEmpty())
        return;
    const int left = seen.left() / view.grid;
    const int top = seen.top() / view.grid;
    m_model->setFar(m_coverage(m_model->triangle(),
                               {left, top, seen.right() / view.grid - left + 1, seen.bottom() / view.grid - top + 1}));
}

/// One sample: a veil that leaves the sample's own colour to be seen round its centre, and the three signs.
void LensOverlay::paintCell(QPainter& painter, const QRectF& box, const LensCell& cell)
{
    const QColor veil = lensVeil(cell, paper().fill);
    const double s = box.width();
    const double hole = std::round(s * 0.2);
    const QRectF window(box.center() - QPointF(hole / 2, hole / 2), QSizeF(hole, hole));
    painter.fillRect(QRectF(box.left(), box.top(), s, window.top() - box.top()), veil);
    painter.fillRect(QRectF(box.left(), window.bottom(), s, box.bottom() - window.bottom()), veil);
    painter.fillRect(QRectF(box.left(), window.top(), window.left() - box.left(), hole), veil);
    painter.fillRect(QRectF(window.right(), window.top(), box.right() - window.right(), hole), veil);
    const QColor grid(120, 128, 140, 110);
    painter.fillRect(QRectF(box.left(), box.top(), s, 1), grid);
    painter.fillRect(QRectF(box.left(), box.top() + 1, 1, s - 1), grid);
    if (!cell.hasValues)
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = 0; i < 3; ++i)
        paintGlyph(painter, glyphCentre(box, i), glyphDiameter(s), cell.signs[i], i,
                   cell.state == LensCell::State::Waiting);
}

/// Samples too small for glyphs: runs of one colour, the picture shining through.
void LensOverlay::paintVeils(LensView& view) const
{
    constexpr int kVeilOpacity = 205;
    const QColor fill = paper().fill;
    const QRect shown = view.visible(m_model->triangle().setup.bounds);
    for (int y = shown.top(); y <= shown.bottom(); ++y)
        for (int x = shown.left(), next = x; x <= shown.right(); x = next) {
            const QColor veil = lensVeil(m_model->cell(x, y), fill);
            while (next <= shown.right() && lensVeil(m_model->cell(next, y), fill) == veil)
                ++next;
            view.painter.fillRect(QRectF(view.at({x, y}), view.at({next, y + 1})), withAlpha(veil, kVeilOpacity));
        }
}

void LensOverlay::paintCells(LensView& view) const
{
    const QRect shown = view.visible(m_model->triangle().setup.bounds);
    const bool wholePixels = view.cell == std::floor(view.cell);
    const bool vectors = isDrawing(view.painter) || !wholePixels;
    const QSize size(int(view.cell), int(view.cell));
    const QColor fill = paper().fill;
    if (m_tileSize != size || m_tilePaper != fill)
        m_tiles.clear();
    m_tileSize = size;
    m_tilePaper = fill;
    for (int y = shown.top(); y <= shown.bottom(); ++y)
        for (int x = shown.left(); x <= shown.right(); ++x) {
            LensCell cell = m_model->cell(x, y);
            const QRectF box = view.box(x, y);
            view.cells.push_back({box, cell});
            if (m_model->log().rules().multiSampled())
                cell.hasValues = false; // signs are those of the centre, and samples lie in their place
            if (vectors) {
                view.painter.save();
                paintCell(view.painter, box, cell);
                view.painter.restore();
                continue;
            }
            QPixmap& tile = m_tiles[tileKey(cell)];
            if (tile.isNull()) {
                tile = QPixmap(size);
                tile.fill(Qt::transparent);
                QPainter painter(&tile);
                paintCell(painter, QRectF(QPointF(0, 0), QSizeF(size)), cell);
            }
            view.painter.drawPixmap(box.topLeft().toPoint(), tile);
        }
}

void LensOverlay::paintNumbers(LensView& view) const
{
    const StepSetup& setup = m_model->triangle().setup;
    QFont numbers = numberFont();
    numbers.setPixelSize(numberPixels(view.cell, view.options.thickLines));
    QFont words = textFont(0);
    words.setPixelSize(std::max(9, numberPixels(view.cell, view.options.thickLines) * 5 / 6));
    const QFontMetricsF wordMetrics(words);
    const QFontMetricsF numberMetrics(numbers);
    const double digit = numberMetrics.horizontalAdvance(QLatin1Char('0'));
    for (const auto& [box, cell] : view.cells) {
        if (!cell.hasValues)
            continue;
        QString text = lensCellText(setup, cell);
        const auto widthOf = [&, isTie = cell.tie] {
            return isTie ? wordMetrics.horizontalAdvance(text) : digit * double(text.size());
        };
        const double room = box.width() - 3;
        // The glyph says that it is a tie, and whose it is counts most; of a long number the first digits are enough.
        for (const QString& separator : {QStringLiteral(": "), QStringLiteral(", ")})
            if (cell.tie && widthOf() > room)
                text = text.section(separator, 1);
        if (!cell.tie && widthOf() > room)
            text = QString::number(cell.values[std::size_t(cell.deciding)] / setup.unitsPerArea, 'g', 3);
        const double width = widthOf();
        view.painter.setPen(lensNumberColor(cell.state));
        view.painter.setFont(cell.tie ? words : numbers);
        const double ascent = cell.tie ? wordMetrics.ascent() : numberMetrics.ascent();
        view.painter.drawText(QPointF(box.center().x() - width / 2, box.top() + 2 + ascent), text);
    }
}

void LensOverlay::paintBounds(LensView& view) const
{
    const QRectF box = boundsOf(view, m_model->triangle().setup);
    const QRectF shown = box.intersected(QRectF(view.canvas).adjusted(-8, -8, 8, 8));
    view.painter.setBrush(Qt::NoBrush);
    view.painter.setPen(QPen(QColor(255, 255, 255, 210), view.thickness(3)));
    view.painter.drawRect(shown);
    view.painter.setPen(QPen(QColor(60, 66, 76), view.thickness(1.2), Qt::DashDotLine));
    view.painter.drawRect(shown);
}

void LensOverlay::paintEdges(LensView& view) const
{
    const StepTriangle& triangle = m_model->triangle();
    if (m_model->hasSetup() && view.cell >= kGridFromZoom / 2) {
        const StepSetup& setup = triangle.setup;
        const PixelRect all{0, 0, m_model->log().columns(), m_model->log().rows()};
        const QRectF picture =
            QRectF(view.at({all.x, all.y}), view.at({all.width, all.height})).intersected(QRectF(view.canvas));
        view.painter.setPen(Qt::NoPen);
        for (std::size_t i = 0; i < 3; ++i) {
            const StepEdge& edge = setup.edges[i];
            const double units = setup.unitsPerSample * view.grid / view.transform.zoom;
            const QPointF origin = view.transform.origin;
            view.painter.setBrush(withAlpha(QColor(kEdgeLooks[i].color), 10));
            view.painter.drawPolygon(halfOf(picture, [&](QPointF p) {
                return edge.a * ((p.x() - origin.x()) * units - edge.from.x) +
                       edge.b * ((p.y() - origin.y()) * units - edge.from.y);
            }));
        }
    }
    if (m_model->sides())
        return; // told apart by other colours now
    const auto ends = [&](std::size_t i) {
        return triangle.hasSetup ? triangle.setup.vertices[i] : glm::dvec2(triangle.screen.vertices[i].position);
    };
    for (std::size_t i = 0; i < 3; ++i)
        view.line(ends(i), ends((i + 1) % 3), QColor(kEdgeLooks[i].color), 2.6, kEdgeLooks[i].style);
}

/// Where a sample lies on an edge, the line must not hide the glyph that says so.
void LensOverlay::paintTies(LensView& view)
{
    for (const auto& [box, cell] : view.cells) {
        if (!cell.tie)
            continue;
        for (std::size_t i = 0; i < 3; ++i)
            if (cell.signs[i] == EdgeSign::Zero)
                paintGlyph(view.painter, glyphCentre(box, i), glyphDiameter(view.cell), EdgeSign::Zero, i,
                           cell.state == LensCell::State::Waiting);
    }
}

void LensOverlay::paintCorners(LensView& view) const
{
    const StepTriangle& triangle = m_model->triangle();
    std::array<QPointF, 3> at;
    QPointF middle;
    for (std::size_t i = 0; i < 3; ++i) {
        at[i] = view.at(triangle.screen.vertices[i].position);
        middle += at[i] / 3;
    }
    // The letters of a triangle that is hardly to be seen would hide its neighbours.
    constexpr double kLabelsFromSide = 40;
    const QRectF extent = QPolygonF{{at[0], at[1], at[2]}}.boundingRect();
    if (std::max(extent.width(), extent.height()) < kLabelsFromSide)
        return;
    std::vector<NamedPlace> names;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!QRectF(view.canvas).adjusted(-20, -20, 20, 20).contains(at[i]))
            continue;
        names.push_back({at[i], walkedCornerName(*m_model, i)});
        view.painter.setPen(QPen(Qt::black, view.thickness(1.8)));
        view.painter.setBrush(Qt::white);
        view.painter.drawEllipse(at[i], view.thickness(4.5), view.thickness(4.5));
    }
    view.painter.setFont(textFont(view.options.thickLines ? 2 : 3, true));
    view.cornerNames(names, middle);
}

/// Bresenham: the ideal line, the two samples it is between, and how far it is from each.
void LensOverlay::paintLine(LensView& view) const
{
    const LineStep* step = m_model->line();
    const auto ends = m_model->lineEnds();
    if (!step || !ends)
        return;
    const LineDecision& d = step->decision;
    const auto centre = [](glm::ivec2 p) { return glm::dvec2(p) + 0.5; };
    view.line(centre((*ends)[0]), centre((*ends)[1]), QColor(Qt::black), 1.8, Qt::DashLine);
    const int axis = d.steep ? 1 : 0;
    const glm::ivec2 way = glm::sign((*ends)[1] - (*ends)[0]);
    glm::ivec2 lower(d.x, d.y);
    lower[axis] += way[axis];
    glm::ivec2 upper = lower;
    upper[1 - axis] += way[1 - axis];
    view.painter.setBrush(Qt::NoBrush);
    for (const glm::ivec2 candidate : {lower, upper}) {
        const bool chosen = (candidate == upper) == d.sideways;
        paintFrame(view.painter, view.box(candidate.x, candidate.y),
                   QPen(QColor(chosen ? kCanvasPlus : kCanvasMinus), view.thickness(chosen ? 3.5 : 2),
                        chosen ? Qt::SolidLine : Qt::DashLine));
    }
    glm::dvec2 ideal = centre(lower);
    ideal[1 - axis] += step->dLower() * way[1 - axis];
    view.line(centre(lower), ideal, QColor(kCanvasPlus), 3, Qt::SolidLine);
    view.line(ideal, centre(upper), QColor(kCanvasMinus), 3, Qt::SolidLine);
    if (view.cell < kGlyphsFromCell)
        return;
    paintPlate(view.painter, view.canvas,
               view.box(std::max(upper.x, lower.x) + 1, std::max(upper.y, lower.y) + 1).topLeft(),
               {QStringLiteral("d_lower = %1").arg(shortNumber(step->dLower())),
                QStringLiteral("d_upper = %1").arg(shortNumber(step->dUpper())),
                QStringLiteral("p_%1 = %2").arg(d.step).arg(d.decision)},
               numberFont(0));
}

/// DDA: the ideal line, the position on it, the sample it is rounded to, and how far that is.
void LensOverlay::paintLinePosition(LensView& view) const
{
    const LinePosition* p = m_model->linePosition();
    if (!p)
        return;
    const glm::dvec2 at(p->x + 0.5, p->y + 0.5);
    const glm::dvec2 perStep(p->perStepX, p->perStepY);
    view.line(at - double(p->step) * perStep, at + double(p->steps - p->step) * perStep, QColor(Qt::black), 1.8,
              Qt::DashLine);
    view.painter.setBrush(Qt::NoBrush);
    paintFrame(view.painter, view.box(p->column, p->row), QPen(QColor(kCanvasPlus), view.thickness(3.5)));
    view.line({p->column + 0.5, p->row + 0.5}, at, QColor(kCanvasPlus), 3, Qt::SolidLine);
    if (view.cell < kGlyphsFromCell)
        return;
    const QString name = p->steep() ? QStringLiteral("x") : QStringLiteral("y");
    paintPlate(view.painter, view.canvas, view.box(p->column + 1, p->row + 1).topLeft(),
               {QStringLiteral("%1 = %2").arg(name, shortNumber(p->steep() ? p->x : p->y)),
                QStringLiteral("round(%1) = %2").arg(name).arg(p->steep() ? p->column : p->row),
                QStringLiteral("error = %1").arg(shortNumber(p->error()))},
               numberFont(0));
}

/// Column fill: the rows of the edges in the present column, the least and the greatest of them, and the span between.
void LensOverlay::paintColumn(LensView& view) const
{
    const FilledColumn* column = m_model->column();
    if (!column)
        return;
    view.painter.setBrush(Qt::NoBrush);
    for (int i = 0; i < column->count; ++i) {
        const int y = column->rows[std::size_t(i)];
        const bool isEnd = y == column->first() || y == column->last();
        paintFrame(view.painter, view.box(column->x, y),
                   QPen(QColor(isEnd ? kCanvasPlus : kCanvasMinus), view.thickness(3)));
    }
    const QPointF below = view.box(column->x + 1, column->last() + 1).topLeft();
    if (view.cell < kGlyphsFromCell)
        return;
    QStringList lines{QStringLiteral("x = %1").arg(column->x)};
    if (column->count > 0)
        lines << QStringLiteral("min = %1").arg(column->first()) << QStringLiteral("max = %1").arg(column->last());
    else
        lines << QCoreApplication::translate("Lens", "no edge: the list of y is empty");
    paintPlate(view.painter, view.canvas, below, lines, numberFont(0));
}

void LensOverlay::paintCurrent(LensView& view) const
{
    const StepEvent* now = m_model->event();
    if (!now || now->x < 0 || now->y < 0 || now->kind == StepKind::Span || now->kind == StepKind::Crossing)
        return;
    const QRectF box = view.box(now->x, now->y);
    const double least = 5;
    const double grow = std::max(0.0, (least - box.width()) / 2);
    view.painter.setBrush(Qt::NoBrush);
    view.painter.setPen(QPen(Qt::white, view.thickness(6), Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    view.painter.drawRect(box.adjusted(-grow, -grow, grow + 1, grow + 1));
    view.painter.setPen(QPen(Qt::black, view.thickness(3.4), Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    view.painter.drawRect(box.adjusted(-grow, -grow, grow + 1, grow + 1));
}

void LensOverlay::paintHover(LensView& view) const
{
    if (!view.options.hoveredPixel || !view.options.tells || view.cell < kGlyphsFromCell)
        return;
    const int x = view.options.hoveredPixel->x() * view.grid + view.grid / 2;
    const int y = view.options.hoveredPixel->y() * view.grid + view.grid / 2;
    QStringList lines = m_model->hasSetup() ? lensHoverLines(*m_model, x, y) : diamondWords(*m_model, x, y);
    if (m_model->log().rules().multiSampled())
        lines += patternWords(*m_model, x, y);
    if (!lines.isEmpty())
        paintPlate(view.painter, view.canvas, view.box(x, y).bottomRight() + QPointF(6, 6), lines, numberFont(0));
}

} // namespace rasterlens
