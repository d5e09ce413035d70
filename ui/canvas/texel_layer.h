#pragma once
#include "core/questions/texel_footprint.h"
#include "ui/canvas/pixel_overlay.h"

#include <QPoint>

#include <memory>
#include <utility>

namespace rasterlens
{

/// The footprint of the selected pixel in the texture, on a plate in a corner of the canvas.
class TexelLayer : public CanvasLayer
{
public:
    /// Null: no texture is looked up at the selected pixel, or its footprint is not known (yet).
    void setFootprint(std::shared_ptr<const TexelFootprint> footprint, const QPoint& pixel)
    {
        m_footprint = std::move(footprint);
        m_pixel = pixel;
    }
    [[nodiscard]] const std::shared_ptr<const TexelFootprint>& footprint() const { return m_footprint; }

    void paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
               const OverlayOptions& options) const override;
    [[nodiscard]] bool hidesNumbers() const override { return false; }

private:
    std::shared_ptr<const TexelFootprint> m_footprint;
    QPoint m_pixel;
};

} // namespace rasterlens
