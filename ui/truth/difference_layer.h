#pragma once
#include "ui/canvas/pixel_overlay.h"

namespace rasterlens
{

class Comparison;

/// Over the heat map: by how much the colour of a pixel in B differs from that in A, in place of the heat's colours.
class DifferenceLayer : public CanvasLayer
{
public:
    explicit DifferenceLayer(const Comparison& comparison) : m_comparison(comparison) {}

    /// The canvas shows the heat map.
    void setShown(bool on) { m_shown = on; }

    void paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
               const OverlayOptions& options) const override;
    [[nodiscard]] bool hidesNumbers() const override { return m_shown; }

private:
    const Comparison& m_comparison;
    bool m_shown = false;
};

} // namespace rasterlens
