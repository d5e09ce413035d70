#include "ui/canvas/texel_layer.h"

#include "ui/canvas/texel_plate.h"

namespace rasterlens
{

void TexelLayer::paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                       const OverlayOptions& options) const
{
    if (options.texels && m_footprint)
        paintTexelPlate(painter, QRectF(canvas), transform.toCanvas(QPointF(m_pixel) + QPointF(0.5, 0.5)),
                        *m_footprint);
}

} // namespace rasterlens
