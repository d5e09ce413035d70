#include "ui/steps/lens_overlay.h"

#include "core/observe/step_text.h"
#include "ui/base/inks.h"
#include "ui/base/theme.h"
#include "ui/steps/step_formula.h"

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

constexpr int kWithinReach = 20000; ///< canvas pixels; farther ends of lines are cut off

struct Paper {
    QColor fill;
    QColor ink;
};

Paper paper()
{
    return {QGuiApplication::palette().color(QPalette::Base), QGuiApplication::palette().color(QPalette::Text)};
}

QColor withAlpha(QColor color, int alpha)
{
    color.setAlpha(alpha);
    return color;
}

/// The part of a line within a rectangle (Liang & Barsky, 1984).
std::optional<QLineF> cut(const QLineF& line, const QRectF& box)
{
    double t0 = 0;
    double t1 = 1;
    const auto side = [&](double distance, double growth) {
        if (growth == 0)
            return distance >= 0;
        const double t = -distance / growth;
        if (growth > 0)
            t0 = std::max(t0, t);
        else
            t1 = std::min(t1, t);
        return true;
    };
    const bool crosses = side(line.x1() - box.left(), line.dx()) && side(box.right() - line.x1(), -line.dx()) &&
                         side(line.y1() - box.top(), line.dy()) && side(box.bottom() - line.y1(), -line.dy());
    if (!crosses || !(t0 <= t1))
        return std::nullopt;
    return QLineF(line.pointAt(t0), line.pointAt(t1));
}

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

double glyphDiameter(double cell) { return std::min(cell * 0.28, 30.0); }

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

/// Text on a plate, readable over anything.
void paintPlate(QPainter& painter, const QRectF& within, QPointF at, const QStringList& lines, const QFont& font)
{
    const QFontMetricsF metrics(font);
    double width = 0;
    for (const QString& line : lines)
        width = std::max(width, metrics.horizontalAdvance(line));
    QRectF plate(at, QSizeF(width + 16, metrics.lineSpacing() * double(lines.size()) + 10));
    if (plate.right() > within.right() - 4)
        plate.moveRight(within.right() - 4);
    if (plate.bottom() > within.bottom() - 4)
        plate.moveBottom(within.bottom() - 4);
    plate.moveTopLeft({std::max(plate.left(), within.left() + 4), std::max(plate.top(), within.top() + 4)});
    const Paper p = paper();
    painter.setPen(QPen(QGuiApplication::palette().color(QPalette::Mid), 1));
    painter.setBrush(withAlpha(p.fill, 240));
    painter.drawRoundedRect(plate, 5, 5);
    painter.setFont(font);
    painter.setPen(p.ink);
    for (int i = 0; i < lines.size(); ++i)
        painter.drawText(plate.topLeft() + QPointF(8, 5 + metrics.ascent() + i * metrics.lineSpacing()), lines[i]);
}

} // namespace

void paintEdgeGlyph(QPainter& painter, QPointF centre, double diameter, EdgeSign sign)
{
    const double r = diameter / 2;
    const double stroke = std::max(1.0, diameter / 7);
    painter.setBrush(sign == EdgeSign::Plus    ? QColor(kCanvasPlus)
                     : sign == EdgeSign::Minus ? QColor(kCanvasMinus)
                                               : QColor(Qt::white));
    painter.setPen(sign == EdgeSign::Zero || sign == EdgeSign::NotANumber ? QPen(Qt::black, stroke) : QPen(Qt::NoPen));
    const double inset = sign == EdgeSign::Zero || sign == EdgeSign::NotANumber ? stroke / 2 : 0;
    painter.drawEllipse(centre, r - inset, r - inset);
    const double arm = r * 0.55;
    if (sign == EdgeSign::Plus || sign == EdgeSign::Minus) {
        painter.setPen(QPen(Qt::white, stroke, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(centre - QPointF(arm, 0), centre + QPointF(arm, 0));
        if (sign == EdgeSign::Plus)
            painter.drawLine(centre - QPointF(0, arm), centre + QPointF(0, arm));
    } else if (sign == EdgeSign::Zero) {
        painter.setPen(QPen(Qt::black, std::max(1.0, diameter / 9)));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(centre, r * 0.28, r * 0.42);
    } else {
        painter.setPen(QPen(Qt::black, stroke));
        painter.drawLine(centre - QPointF(arm, arm) * 0.7, centre + QPointF(arm, arm) * 0.7);
        painter.drawLine(centre - QPointF(arm, -arm) * 0.7, centre + QPointF(arm, -arm) * 0.7);
    }
}

/// What one paint works with.
struct LensOverlay::View {
    QPainter& painter;
    QRect canvas;
    const CanvasTransform& transform;
    const OverlayOptions& options;
    int grid;
    double cell;                                    ///< canvas pixels a sample
    std::vector<std::pair<QRectF, LensCell>> cells; ///< in sight, from kGlyphsFromCell on

    [[nodiscard]] QPointF at(glm::dvec2 sample) const { return transform.toCanvas(QPointF(sample.x, sample.y) / grid); }
    [[nodiscard]] QRectF box(int x, int y) const { return {at({x, y}), QSizeF(cell, cell)}; }
    [[nodiscard]] double thickness(double pen) const { return options.thickLines ? pen * 1.6 : pen; }
    /// The samples that the canvas shows, cut to a rectangle of samples.
    [[nodiscard]] QRect visible(const PixelRect& of) const
    {
        const auto sampleAt = [&](QPointF p) { return transform.toImage(p) * grid; };
        const QPointF first = sampleAt(QRectF(canvas).topLeft());
        const QPointF last = sampleAt(QRectF(canvas).bottomRight());
        const QRect seen(QPoint(int(std::floor(first.x())), int(std::floor(first.y()))),
                         QPoint(int(std::ceil(last.x())) - 1, int(std::ceil(last.y())) - 1));
        return seen.intersected(QRect(of.x, of.y, of.width, of.height));
    }
    /// A line with a light rim, cut to the canvas.
    void line(glm::dvec2 from, glm::dvec2 to, QColor color, double width, Qt::PenStyle style) const
    {
        const double reach = kWithinReach;
        const QRectF near = QRectF(canvas).adjusted(-40, -40, 40, 40);
        const auto shown = cut(QLineF(at(from), at(to)), near);
        if (!shown || !(shown->length() < reach))
            return;
        painter.setPen(QPen(QColor(255, 255, 255, 200), thickness(width) + 2.4, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(*shown);
        painter.setPen(QPen(color, thickness(width), style, style == Qt::SolidLine ? Qt::RoundCap : Qt::FlatCap));
        painter.drawLine(*shown);
    }
};

void LensOverlay::paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                        const OverlayOptions& options) const
{
    if (!m_model)
        return;
    const int grid = m_model->log().grid();
    View view{painter, canvas, transform, options, grid, transform.zoom / grid, {}};
    painter.save();
    painter.setClipRect(canvas);
    if (m_model->hasSetup() && view.cell >= kGridFromZoom / 2) {
        if (view.cell >= kGlyphsFromCell)
            paintCells(view);
        else
            paintVeils(view);
        paintBounds(view);
    }
    painter.setRenderHint(QPainter::Antialiasing);
    paintEdges(view);
    paintTies(view);
    if (m_model->hasSetup() && view.cell >= kLensNumbersFromCell)
        paintNumbers(view);
    paintWalk(view);
    paintLine(view);
    paintColumn(view);
    paintCurrent(view);
    paintCorners(view);
    paintHover(view);
    painter.restore();
}

/// The colour a sample is veiled with: what is inside, and what was looked at.
QColor LensOverlay::veilOf(const LensCell& cell, const QColor& fill)
{
    const bool waiting = cell.state == LensCell::State::Waiting;
    bool inside = cell.state == LensCell::State::Covered;
    if (waiting && cell.hasValues)
        inside =
            std::none_of(cell.signs.begin(), cell.signs.end(), [](EdgeSign sign) { return sign == EdgeSign::Minus; });
    const double tint = inside ? (waiting ? 0.07 : 0.17) : 0;
    const QColor plus(kCanvasPlus);
    const auto mixed = [&](int a, int b) { return int(std::lround(a + (b - a) * tint)); };
    return {mixed(fill.red(), plus.red()), mixed(fill.green(), plus.green()), mixed(fill.blue(), plus.blue()),
            waiting ? 246 : 250};
}

/// One sample: a veil that leaves the sample's own colour to be seen round its centre, and the three signs.
void LensOverlay::paintCell(QPainter& painter, const QRectF& box, const LensCell& cell)
{
    const QColor veil = veilOf(cell, paper().fill);
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
    painter.setOpacity(cell.state == LensCell::State::Waiting ? 0.33 : 1.0);
    for (std::size_t i = 0; i < 3; ++i)
        paintEdgeGlyph(painter, glyphCentre(box, i), glyphDiameter(s), cell.signs[i]);
    painter.setOpacity(1);
}

/// Samples too small for glyphs: runs of one colour, the picture shining through.
void LensOverlay::paintVeils(View& view) const
{
    constexpr int kVeilOpacity = 205;
    const QColor fill = paper().fill;
    const QRect shown = view.visible(m_model->triangle().setup.bounds);
    for (int y = shown.top(); y <= shown.bottom(); ++y)
        for (int x = shown.left(), next = x; x <= shown.right(); x = next) {
            const QColor veil = veilOf(m_model->cell(x, y), fill);
            while (next <= shown.right() && veilOf(m_model->cell(next, y), fill) == veil)
                ++next;
            view.painter.fillRect(QRectF(view.at({x, y}), view.at({next, y + 1})), withAlpha(veil, kVeilOpacity));
        }
}

void LensOverlay::paintCells(View& view) const
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
            const LensCell cell = m_model->cell(x, y);
            const QRectF box = view.box(x, y);
            view.cells.push_back({box, cell});
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

void LensOverlay::paintNumbers(View& view) const
{
    const StepSetup& setup = m_model->triangle().setup;
    QFont numbers = numberFont();
    numbers.setPixelSize(std::clamp(int(view.cell / 5), 10, 18));
    QFont words = textFont(0);
    words.setPixelSize(std::clamp(int(view.cell / 6), 9, 15));
    const QFontMetricsF wordMetrics(words);
    const QFontMetricsF numberMetrics(numbers);
    const double digit = numberMetrics.horizontalAdvance(QLatin1Char('0'));
    const QColor ink = paper().ink;
    for (const auto& [box, cell] : view.cells) {
        if (!cell.hasValues)
            continue;
        QString text = lensCellText(setup, cell);
        const auto widthOf = [&] {
            return cell.tie ? wordMetrics.horizontalAdvance(text) : digit * double(text.size());
        };
        const double room = box.width() - 3;
        // The glyph says that it is a tie, and whose it is counts most; of a long number the first digits are enough.
        for (const QString& separator : {QStringLiteral(": "), QStringLiteral(", ")})
            if (cell.tie && widthOf() > room)
                text = text.section(separator, 1);
        if (!cell.tie && widthOf() > room)
            text = QString::number(cell.values[std::size_t(cell.deciding)] / setup.unitsPerArea, 'g', 3);
        const double width = widthOf();
        view.painter.setPen(withAlpha(ink, cell.state == LensCell::State::Waiting ? 150 : 255));
        view.painter.setFont(cell.tie ? words : numbers);
        const double ascent = cell.tie ? wordMetrics.ascent() : numberMetrics.ascent();
        view.painter.drawText(QPointF(box.center().x() - width / 2, box.top() + 2 + ascent), text);
    }
}

void LensOverlay::paintBounds(View& view) const
{
    const PixelRect& b = m_model->triangle().setup.bounds;
    const QRectF box(view.at({b.x, b.y}), view.at({b.x + b.width, b.y + b.height}));
    const QRectF shown = box.intersected(QRectF(view.canvas).adjusted(-8, -8, 8, 8));
    view.painter.setBrush(Qt::NoBrush);
    view.painter.setPen(QPen(QColor(255, 255, 255, 210), view.thickness(3)));
    view.painter.drawRect(shown);
    view.painter.setPen(QPen(QColor(60, 66, 76), view.thickness(1.2), Qt::DashDotLine));
    view.painter.drawRect(shown);
}

void LensOverlay::paintEdges(View& view) const
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
    const auto ends = [&](std::size_t i) {
        return triangle.hasSetup ? triangle.setup.vertices[i] : glm::dvec2(triangle.screen.vertices[i].position);
    };
    for (std::size_t i = 0; i < 3; ++i)
        view.line(ends(i), ends((i + 1) % 3), QColor(kEdgeLooks[i].color), 2.6, kEdgeLooks[i].style);
}

/// Where a sample lies on an edge, the line must not hide the glyph that says so.
void LensOverlay::paintTies(View& view)
{
    for (const auto& [box, cell] : view.cells) {
        if (!cell.tie)
            continue;
        view.painter.setOpacity(cell.state == LensCell::State::Waiting ? 0.5 : 1);
        for (std::size_t i = 0; i < 3; ++i)
            if (cell.signs[i] == EdgeSign::Zero)
                paintEdgeGlyph(view.painter, glyphCentre(box, i), glyphDiameter(view.cell), EdgeSign::Zero);
    }
    view.painter.setOpacity(1);
}

void LensOverlay::paintCorners(View& view) const
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
    const QFont font = textFont(view.options.thickLines ? 2 : 3, true);
    view.painter.setFont(font);
    const double size = QFontMetricsF(font).height();
    for (std::size_t i = 0; i < 3; ++i) {
        if (!QRectF(view.canvas).adjusted(-20, -20, 20, 20).contains(at[i]))
            continue;
        view.painter.setPen(QPen(Qt::black, view.thickness(1.8)));
        view.painter.setBrush(Qt::white);
        view.painter.drawEllipse(at[i], view.thickness(4.5), view.thickness(4.5));
        const QLineF outward(middle, at[i]);
        const QPointF way =
            outward.length() > 0 ? QPointF(outward.dx(), outward.dy()) / outward.length() : QPointF(0, -1);
        QPointF centre = at[i] + way * size * 0.85;
        const QRectF room = QRectF(view.canvas).adjusted(size / 2, size / 2, -size / 2, -size / 2);
        centre = {std::clamp(centre.x(), room.left(), std::max(room.left(), room.right())),
                  std::clamp(centre.y(), room.top(), std::max(room.top(), room.bottom()))};
        const QRectF plate(centre - QPointF(size, size) * 0.44, QSizeF(size, size) * 0.88);
        const Paper p = paper();
        view.painter.setPen(Qt::NoPen);
        view.painter.setBrush(withAlpha(p.fill, 225));
        view.painter.drawRoundedRect(plate, 4, 4);
        view.painter.setPen(p.ink);
        view.painter.drawText(plate, Qt::AlignCenter, QString(QLatin1Char(char('A' + i))));
    }
}

/// Edge walking: the two active edges, and where the row's span begins and ends before and after ceil(v - 0.5).
void LensOverlay::paintWalk(View& view) const
{
    const WalkedTriangle* walk = m_model->walk();
    const StepEvent* now = m_model->event();
    const SpanStep* span = m_model->span();
    if (!walk || !span || !now || now->y < 0)
        return;
    const auto& v = walk->vertices;
    const QColor active = QGuiApplication::palette().color(QPalette::Highlight);
    view.line(v[0], v[2], active, 4.5, Qt::SolidLine);
    view.line(span->ends.upperHalf ? v[0] : v[1], span->ends.upperHalf ? v[1] : v[2], active, 4.5, Qt::SolidLine);

    const QRectF row(view.at({span->xBegin, now->y}), view.at({span->xEnd, now->y + 1}));
    view.painter.setBrush(Qt::NoBrush);
    view.painter.setPen(QPen(Qt::white, view.thickness(5)));
    view.painter.drawRect(row);
    view.painter.setPen(QPen(Qt::black, view.thickness(2.2)));
    view.painter.drawRect(row);
    const double r = std::clamp(view.cell / 6, 3.0, 7.0);
    for (const double x : {span->ends.left, span->ends.right}) {
        const QPointF at = view.at({x, now->y + 0.5});
        const QPolygonF diamond{{at + QPointF(0, -r), at + QPointF(r, 0), at + QPointF(0, r), at + QPointF(-r, 0)}};
        view.painter.setPen(QPen(Qt::black, 1.5));
        view.painter.setBrush(QColor(0xffd54f));
        view.painter.drawPolygon(diamond);
    }
    if (view.cell < kGlyphsFromCell)
        return;
    paintPlate(view.painter, view.canvas, row.bottomLeft() + QPointF(4, 6), spanLines(*span), numberFont(0));
}

/// Bresenham: the ideal line, the two samples it is between, and how far it is from each.
void LensOverlay::paintLine(View& view) const
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
        view.painter.setPen(QPen(QColor(chosen ? kCanvasPlus : kCanvasMinus), view.thickness(chosen ? 3.5 : 2),
                                 chosen ? Qt::SolidLine : Qt::DashLine));
        view.painter.drawRect(view.box(candidate.x, candidate.y).adjusted(2, 2, -2, -2));
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

/// Column fill: the rows of the edges in the present column, the least and the greatest of them, and the span between.
void LensOverlay::paintColumn(View& view) const
{
    const FilledColumn* column = m_model->column();
    if (!column)
        return;
    view.painter.setBrush(Qt::NoBrush);
    for (int i = 0; i < column->count; ++i) {
        const int y = column->rows[std::size_t(i)];
        const bool isEnd = y == column->first() || y == column->last();
        view.painter.setPen(QPen(QColor(isEnd ? kCanvasPlus : kCanvasMinus), view.thickness(3), Qt::SolidLine));
        view.painter.drawRect(view.box(column->x, y).adjusted(2, 2, -2, -2));
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

void LensOverlay::paintCurrent(View& view) const
{
    const StepEvent* now = m_model->event();
    if (!now || now->x < 0 || now->y < 0 || now->kind == StepKind::Span)
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

void LensOverlay::paintHover(View& view) const
{
    if (!view.options.hoveredPixel || view.cell < kGlyphsFromCell || !m_model->hasSetup())
        return;
    const int x = view.options.hoveredPixel->x() * view.grid + view.grid / 2;
    const int y = view.options.hoveredPixel->y() * view.grid + view.grid / 2;
    const QStringList lines = lensHoverLines(*m_model, x, y);
    if (!lines.isEmpty())
        paintPlate(view.painter, view.canvas, view.box(x, y).bottomRight() + QPointF(6, 6), lines, numberFont(0));
}

} // namespace rasterlens
