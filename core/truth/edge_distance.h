#pragma once
#include "core/truth/exact_frame.h"

namespace rasterlens
{

/// How far from an edge ExactFrame::edgeDistance is known; beyond it lies kFarFromEdges or a distance above the band.
constexpr double kEdgeBandPixels = 1.5;
constexpr float kFarFromEdges = 1e9F;

/// Lowers the distances of the samples within kEdgeBandPixels of the segment a b.
///
/// in      pixels of the viewport; the frame's edgeDistance filled
/// cost    linear in the length of the segment
void lowerEdgeDistance(ExactFrame& frame, glm::dvec2 a, glm::dvec2 b);

} // namespace rasterlens
