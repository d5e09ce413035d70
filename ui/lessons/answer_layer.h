#pragma once
#include "ui/canvas/pixel_overlay.h"

#include <QPoint>

#include <vector>

namespace rasterlens
{

/// The pixels of an answer on the canvas: those that were marked, and afterwards which of them were right.
class AnswerLayer : public CanvasLayer
{
public:
    void clear();
    void setMarked(std::vector<QPoint> pixels);
    /// in  the right pixels, once the question is answered
    void setRight(std::vector<QPoint> pixels);

    void paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
               const OverlayOptions& options) const override;
    [[nodiscard]] bool hidesNumbers() const override { return false; }

private:
    std::vector<QPoint> m_marked;
    std::vector<QPoint> m_right;
    bool m_isJudged = false;
};

} // namespace rasterlens
