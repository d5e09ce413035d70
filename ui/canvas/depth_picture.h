#pragma once
#include "ui/canvas/pixel_overlay.h"

#include <memory>

namespace rasterlens
{

/// The depth buffer of a frame as a picture.
struct DepthPicture {
    RenderedFrame shown; ///< only the picture, in greys
    float black = 0;     ///< the stored depth that is black, and all below it
    float white = 1;     ///< the stored depth that is white, and all above it
};

/// Greys from the smallest to the largest depth that a face has stored: cleared pixels, at 0 or 1, are at their end.
///
/// out  null where the frame has no depth (yet)
[[nodiscard]] std::shared_ptr<const DepthPicture> depthPicture(const RenderedFrame& frame);

/// What the depth picture says of a pixel: the stored depth, as the readout and the depth view write it.
[[nodiscard]] QStringList depthLines(const RenderedFrame& frame, QPoint pixel);

/// Paints the depth picture of a frame with what the canvas lays over pixels, and which depths are black and white.
///
/// in  picture: of this frame; null: the frame has no depth
void paintDepthPicture(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                       const RenderedFrame& frame, const DepthPicture* picture, const OverlayOptions& options);

} // namespace rasterlens
