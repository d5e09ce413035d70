#pragma once
#include "core/pipeline/types.h"
#include "core/settings/rules.h"

#include <span>

namespace rasterlens
{

/// What rules.depthBias adds to the depth of every corner of a face.
///
/// in      the corners of the face on the screen, after clipping; their polygon has an area
/// out     min(clamp, constant * unit + slope * steepness) where clamp > 0, max() where clamp < 0. The unit of unorm
///         formats is their smallest value above 0, 1 / (2^bits - 1); that of float32 is 2^(e - 23), e the exponent of
///         the largest |depth| of the corners. The steepness is max(|dz/dx|, |dz/dy|) a pixel, of the plane
///         through the corners; through more than three, which snapping has moved a little, of their mean plane
/// source  Direct3D 11.3 Functional Specification, 15.10 Depth Bias; Vulkan 1.3, Depth Bias; the mean plane: Newell's
///         method (Sutherland, Sproull & Schumacker, Computing Surveys 6(1), 1974)
[[nodiscard]] double depthBias(std::span<const ScreenVertex> polygon, const Rules& rules);

} // namespace rasterlens
