#pragma once
#include "core/questions/texel_footprint.h"

#include <QRectF>
#include <QString>
#include <QStringList>

class QPainter;

namespace rasterlens
{

/// The texels that were read and the mip levels, in words of the language in use; one line a level.
[[nodiscard]] QStringList texelWords(const TexelFootprint& footprint);

/// Draws the part of a texture round the footprint of a pixel, v upwards: the texels, the footprint as a parallelogram,
/// the pixel's centre in it, and a frame round each texel that was read, with its weight where there is room.
///
/// in   a footprint with a patch
void paintTexels(QPainter& painter, const QRectF& box, const TexelFootprint& footprint);

/// paintTexels() and texelWords() on a plate of their own in a corner of the canvas, where the pixel is not.
void paintTexelPlate(QPainter& painter, const QRectF& canvas, const QPointF& pixel, const TexelFootprint& footprint);

} // namespace rasterlens
