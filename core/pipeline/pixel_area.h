#pragma once
#include "core/pipeline/types.h"

#include <QSize>

#include <vector>

namespace rasterlens
{

/// The share of a pixel's square that a triangle covers, 0..1: what the samples of a pixel estimate.
///
/// in     positions in samples, of which a pixel has `grid` along each axis
/// exact  to rounding
/// source Sutherland & Hodgman, Reentrant Polygon Clipping, CACM 17(1), 1974
[[nodiscard]] double areaInPixel(const ScreenTriangle& triangle, int x, int y, int grid);

/// Adds the shares of all pixels of a target.
///
/// in   positions in pixels; one entry a pixel, row by row
void addAreas(const ScreenTriangle& triangle, QSize size, std::vector<double>& areas);

} // namespace rasterlens
