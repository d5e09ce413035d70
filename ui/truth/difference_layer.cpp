#include "ui/truth/difference_layer.h"

#include "ui/base/numbers.h"
#include "ui/canvas/pixel_numbers.h"
#include "ui/truth/comparison.h"

namespace rasterlens
{

void DifferenceLayer::paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                            const OverlayOptions& options) const
{
    const FramePtr heat = m_comparison.frame();
    if (!m_shown || !heat || !m_comparison.hasAmounts() || !options.numbers || transform.zoom < kNumbersFromZoom)
        return;
    const QImage& picture = heat->frame.image;
    paintPixelNumbers(painter, transform.pixelsIn(canvas, picture.size()), transform, picture,
                      [this](QPoint pixel, NumberRoom) -> QStringList {
                          const auto both = m_comparison.at(pixel);
                          return {both ? channelChanges(both->a, both->b) : QString()};
                      });
}

} // namespace rasterlens
