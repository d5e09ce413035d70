#include "ui/lessons/answer_layer.h"

#include "ui/base/inks.h"

#include <QPainter>

#include <algorithm>

namespace rasterlens
{
namespace
{

/// A frame within a pixel, on a light rim that any picture lets see.
void paintFrame(QPainter& painter, const QRectF& box, const QColor& color, Qt::PenStyle style)
{
    const double pen = std::clamp(box.width() / 12, 2.0, 6.0);
    const QRectF frame = box.adjusted(pen, pen, -pen, -pen);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(Qt::white, pen + 3, Qt::SolidLine, Qt::SquareCap, Qt::MiterJoin));
    painter.drawRect(frame);
    painter.setPen(QPen(color, pen, style, Qt::FlatCap, Qt::MiterJoin));
    painter.drawRect(frame);
}

void paintCross(QPainter& painter, const QRectF& box)
{
    const double inset = box.width() / 4;
    const QRectF cross = box.adjusted(inset, inset, -inset, -inset);
    for (const auto& [color, width] : {std::pair(QColor(Qt::white), 6.0), std::pair(QColor(kCanvasMinus), 3.0)}) {
        painter.setPen(QPen(color, width));
        painter.drawLine(cross.topLeft(), cross.bottomRight());
        painter.drawLine(cross.bottomLeft(), cross.topRight());
    }
}

} // namespace

void AnswerLayer::clear()
{
    m_marked.clear();
    m_right.clear();
    m_isJudged = false;
}

void AnswerLayer::setMarked(std::vector<QPoint> pixels)
{
    clear();
    m_marked = std::move(pixels);
}

void AnswerLayer::setRight(std::vector<QPoint> pixels)
{
    m_right = std::move(pixels);
    m_isJudged = true;
}

/// Marked: a blue frame. Afterwards a wrong one is crossed, and one that was missed has a dashed frame.
void AnswerLayer::paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                        const OverlayOptions&) const
{
    const auto boxOf = [&](QPoint pixel) { return transform.toCanvas(QRectF(pixel, QSizeF(1, 1))); };
    const auto isIn = [](const std::vector<QPoint>& pixels, QPoint pixel) {
        return std::ranges::find(pixels, pixel) != pixels.end();
    };
    painter.save();
    painter.setClipRect(canvas);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const QPoint pixel : m_marked) {
        const bool isWrong = m_isJudged && !isIn(m_right, pixel);
        paintFrame(painter, boxOf(pixel), QColor(isWrong ? kCanvasMinus : kCanvasPlus), Qt::SolidLine);
        if (isWrong)
            paintCross(painter, boxOf(pixel));
    }
    for (const QPoint pixel : m_right)
        if (!isIn(m_marked, pixel))
            paintFrame(painter, boxOf(pixel), QColor(kCanvasPlus), Qt::DashLine);
    painter.restore();
}

} // namespace rasterlens
