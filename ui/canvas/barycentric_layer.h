#pragma once
#include "core/derive/pixel_weights.h"
#include "ui/canvas/pixel_overlay.h"

#include <array>
#include <memory>

namespace rasterlens
{

/// Barycentric coordinates at the selected pixel: the three areas with their numbers, the corners A, B and C, and the
/// lines on which alpha, beta and gamma are 0.1, 0.2 and so on.
class BarycentricLayer : public CanvasLayer
{
public:
    /// Null: no face was drawn at the selected pixel, or its weights are not known (yet).
    void setWeights(std::shared_ptr<const PixelWeights> weights) { m_weights = std::move(weights); }
    [[nodiscard]] const std::shared_ptr<const PixelWeights>& weights() const { return m_weights; }
    /// What the areas say, those of A, B and C: the pixel card's numbers.
    [[nodiscard]] std::array<QString, 3> texts() const;

    void paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
               const OverlayOptions& options) const override;
    [[nodiscard]] bool hidesNumbers() const override { return m_hidesNumbers; }
    /// The overlay is switched on: the pixel values would be in the way.
    void setOn(bool on) { m_hidesNumbers = on && m_weights != nullptr; }

private:
    void paintIsoLines(QPainter& painter, const CanvasTransform& transform) const;
    void paintAreas(QPainter& painter, const CanvasTransform& transform, bool thick) const;
    void paintTexts(QPainter& painter, const QRect& canvas, const CanvasTransform& transform) const;

    std::shared_ptr<const PixelWeights> m_weights;
    bool m_hidesNumbers = false;
};

} // namespace rasterlens
