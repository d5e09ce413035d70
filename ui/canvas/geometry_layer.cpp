#include "ui/canvas/geometry_layer.h"

#include "ui/base/theme.h"
#include "ui/canvas/overlay_inks.h"

#include <QCoreApplication>
#include <QPainter>
#include <QPainterPath>
#include <QPolygonF>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr std::size_t kManyLines = 20000; ///< from here on lines are drawn thin and without a seam
constexpr double kLeastTile = 6;          ///< canvas pixels: smaller tiles would hide the picture
constexpr double kNamedTile = 96;         ///< canvas pixels: tiles from here on carry their column and row

QPointF onCanvas(const CanvasTransform& transform, const glm::dvec2& point)
{
    return transform.toCanvas(QPointF(point.x, point.y));
}

bool isFinite(const glm::dvec2& point) { return std::isfinite(point.x) && std::isfinite(point.y); }

/// The part of the picture that the canvas shows, in pixels.
QRectF visiblePart(const QRect& canvas, const CanvasTransform& transform)
{
    return {transform.toImage(canvas.topLeft()), transform.toImage(canvas.bottomRight() + QPoint(1, 1))};
}

bool isInSight(std::span<const glm::dvec2> corners, const QRectF& visible)
{
    glm::dvec2 low = corners.front();
    glm::dvec2 high = low;
    for (const glm::dvec2& corner : corners) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    return low.x <= visible.right() && high.x >= visible.left() && low.y <= visible.bottom() && high.y >= visible.top();
}

QPolygonF midBand(const ScreenPiece& piece, bool corrected, const CanvasTransform& transform)
{
    const auto line = [&](double weight) { return isoLine(piece.corners, piece.invW, 0, weight, corrected); };
    const auto near = line(0.5 + kMidLineHalfWidth);
    const auto far = line(0.5 - kMidLineHalfWidth);
    return {onCanvas(transform, near[0]), onCanvas(transform, near[1]), onCanvas(transform, far[1]),
            onCanvas(transform, far[0])};
}

} // namespace

double wayToWeight(double weight, double invWHere, double invWThere)
{
    // With s the way from there: weight = s here / (s here + (1 - s) there).
    const double s = weight * invWThere / (invWHere * (1 - weight) + weight * invWThere);
    return 1 - s;
}

std::array<glm::dvec2, 2> isoLine(const std::array<glm::dvec2, 3>& corners, const std::array<double, 3>& invW,
                                  std::size_t corner, double weight, bool corrected)
{
    std::array<glm::dvec2, 2> line;
    for (std::size_t i = 0; i < 2; ++i) {
        const std::size_t other = (corner + 1 + i) % 3;
        const double way = wayToWeight(weight, corrected ? invW[corner] : 1, corrected ? invW[other] : 1);
        line[i] = corners[corner] + way * (corners[other] - corners[corner]);
    }
    return line;
}

void GeometryLayer::paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                          const OverlayOptions& options) const
{
    painter.save();
    painter.setClipRect(canvas, Qt::IntersectClip);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRectF visible = visiblePart(canvas, transform);
    if (options.tiles)
        paintTiles(painter, canvas & transform.toCanvas(QRectF(QPointF(0, 0), m_picture)).toAlignedRect(), transform);
    if (m_faces && options.boxes)
        paintBoxes(painter, visible, transform);
    if (m_faces && options.wireframe)
        paintWires(painter, visible, transform, options.thickLines);
    if (m_faces && options.midLine)
        paintMidLines(painter, canvas, transform);
    if (m_faces && options.outline)
        paintOutline(painter, transform, options.thickLines);
    painter.restore();
}

/// Lines between the tiles, and each tile's column and row where there is room; within the picture.
void GeometryLayer::paintTiles(QPainter& painter, const QRect& canvas, const CanvasTransform& transform) const
{
    const double side = m_tileSide * transform.zoom;
    if (side < kLeastTile)
        return;
    const auto first = [&](double origin, int from) { return std::max(0, static_cast<int>((from - origin) / side)); };
    const int left = first(transform.origin.x(), canvas.left());
    const int top = first(transform.origin.y(), canvas.top());
    QList<QLineF> lines;
    for (int i = left; transform.origin.x() + i * side <= canvas.right(); ++i) {
        const double x = transform.origin.x() + i * side;
        lines << QLineF(x, canvas.top(), x, canvas.bottom() + 1);
    }
    for (int i = top; transform.origin.y() + i * side <= canvas.bottom(); ++i) {
        const double y = transform.origin.y() + i * side;
        lines << QLineF(canvas.left(), y, canvas.right() + 1, y);
    }
    paintSeamed(painter, kTileInk, 1, Qt::DashLine, [&] { painter.drawLines(lines); });
    if (side < kNamedTile)
        return;
    painter.setFont(numberFont(-1));
    for (int row = top; transform.origin.y() + row * side <= canvas.bottom(); ++row)
        for (int column = left; transform.origin.x() + column * side <= canvas.right(); ++column) {
            const QPointF corner = transform.origin + QPointF(column * side, row * side);
            paintPlate(painter, QRect(corner.toPoint(), QSizeF(side, side).toSize()), corner,
                       QStringLiteral("%1, %2").arg(column).arg(row), kTileInk);
        }
}

void GeometryLayer::paintBoxes(QPainter& painter, const QRectF& visible, const CanvasTransform& transform) const
{
    QList<QRectF> boxes;
    for (const ScreenPiece& piece : m_faces->pieces) {
        const QRectF box(QPointF(piece.boxLow.x, piece.boxLow.y), QPointF(piece.boxHigh.x, piece.boxHigh.y));
        if (!box.isEmpty() && box.intersects(visible))
            boxes << transform.toCanvas(box);
    }
    if (static_cast<std::size_t>(boxes.size()) < kManyLines) {
        paintSeamed(painter, kBoxInk, 1, Qt::DashLine, [&] { painter.drawRects(boxes); });
        return;
    }
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(QColor(kBoxInk), 0.5));
    painter.drawRects(boxes);
}

void GeometryLayer::paintWires(QPainter& painter, const QRectF& visible, const CanvasTransform& transform,
                               bool thick) const
{
    QList<QLineF> lines;
    for (const ScreenFace& face : m_faces->faces) {
        const std::span<const glm::dvec2> corners = m_faces->cornersOf(face);
        if (corners.empty() || !std::ranges::all_of(corners, isFinite) || !isInSight(corners, visible))
            continue;
        for (std::size_t i = 0; i < corners.size(); ++i)
            lines << QLineF(onCanvas(transform, corners[i]), onCanvas(transform, corners[(i + 1) % corners.size()]));
    }
    if (static_cast<std::size_t>(lines.size()) < kManyLines) {
        paintSeamed(painter, kWireInk, thick ? 2 : 1, Qt::SolidLine, [&] { painter.drawLines(lines); });
        return;
    }
    painter.setPen(QPen(QColor(kWireInk), 0.5));
    painter.drawLines(lines);
}

/// The band in which alpha is nearly one half, in white: of the face that owns the selected pixel, or of all faces.
/// Where perspective moves it, a dashed outline shows where it would be without.
void GeometryLayer::paintMidLines(QPainter& painter, const QRect& canvas, const CanvasTransform& transform) const
{
    const bool isOne = m_winner && *m_winner < m_faces->faces.size();
    const std::span<const ScreenPiece> pieces =
        isOne ? m_faces->piecesOf(m_faces->faces[*m_winner]) : std::span<const ScreenPiece>(m_faces->pieces);
    for (const ScreenPiece& piece : pieces) {
        const bool hasW = std::ranges::all_of(piece.invW, [](double w) { return std::isfinite(w) && w > 0; });
        if (!std::ranges::all_of(piece.corners, isFinite) || !hasW)
            continue;
        const QPolygonF drawn = midBand(piece, m_faces->perspective, transform);
        const QPolygonF other = midBand(piece, !m_faces->perspective, transform);
        painter.setPen(QPen(QColor(kCanvasInk), 1));
        painter.setBrush(QColor(kMidLineInk));
        painter.drawPolygon(drawn);
        const bool isMoved = QLineF(drawn[0], other[0]).length() + QLineF(drawn[1], other[1]).length() > 1;
        if (isMoved)
            paintSeamed(painter, kMidLineInk, 1.5, Qt::DashLine, [&] { painter.drawPolygon(other); });
        if (!isOne)
            continue;
        const QString perspective = QCoreApplication::translate("rasterlens::GeometryLayer", "perspective");
        const QString linear = QCoreApplication::translate("rasterlens::GeometryLayer", "linear on the screen");
        painter.setFont(textFont(-1));
        paintPlate(painter, canvas, drawn[0], m_faces->perspective && isMoved ? perspective : linear, kMidLineInk);
        if (isMoved)
            paintPlate(painter, canvas, other[1], m_faces->perspective ? linear : perspective, kMidLineInk);
    }
}

void GeometryLayer::paintOutline(QPainter& painter, const CanvasTransform& transform, bool thick) const
{
    if (!m_winner || *m_winner >= m_faces->faces.size())
        return;
    QPolygonF outline;
    for (const glm::dvec2& corner : m_faces->cornersOf(m_faces->faces[*m_winner]))
        if (isFinite(corner))
            outline << onCanvas(transform, corner);
    if (outline.size() >= 3)
        paintSeamed(painter, kOutlineInk, thick ? 4 : 2, Qt::SolidLine, [&] { painter.drawPolygon(outline); });
}

} // namespace rasterlens
