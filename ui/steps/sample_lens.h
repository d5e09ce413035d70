#pragma once
#include "core/observe/step_cursor.h"
#include "ui/canvas/pixel_overlay.h"

namespace rasterlens
{

/// With several samples a pixel: shows the samples themselves until the step that makes their mean, and at that step
/// what they store and the sum.
///
/// cost  that of the canvas, once
class SampleLens : public CanvasLayer
{
public:
    /// in  null: nothing is painted; must outlive its use here
    void setCursor(const StepCursor* cursor) { m_cursor = cursor; }

    void paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
               const OverlayOptions& options) const override;
    [[nodiscard]] bool hidesNumbers() const override { return isAtWork(); }

private:
    /// There are samples that are not yet one colour.
    [[nodiscard]] bool isAtWork() const;
    void paintSamples(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                      const OverlayOptions& options) const;
    void paintPatterns(QPainter& painter, const QRect& seen, const CanvasTransform& transform) const;
    void paintStored(QPainter& painter, const CanvasTransform& transform, const ResolvedPixel& pixel) const;
    void paintResolve(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                      const ResolvedPixel& pixel) const;
    void paintHover(QPainter& painter, const QRect& canvas, const CanvasTransform& transform, QPoint pixel) const;
    [[nodiscard]] QPointF placeOfPlate(const QRect& canvas, const CanvasTransform& transform, const QRectF& box,
                                       const QStringList& lines) const;
    [[nodiscard]] int changesOfColor(const QRect& pixels) const;

    const StepCursor* m_cursor = nullptr;
};

} // namespace rasterlens
