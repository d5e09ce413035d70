#pragma once
#include "core/pipeline/interpolation.h"
#include "core/pipeline/shading.h"

namespace rasterlens
{

/// Whether the rules take texture coordinates or their derivatives from elsewhere than the corners and the sample.
[[nodiscard]] bool takesOtherTexels(const Rules& rules);

/// Texture coordinates and derivatives as those rules have them.
///
/// in   takesOtherTexels(); screen: the weights of the sample
/// out  varyings: the coordinates at kVaryingUv; the gradient, if the filter reads it
void takeOtherTexels(const FaceInterpolation& interpolation, const Rules& rules, const Weights& screen,
                     Varyings& varyings, UvGradient& gradient);

} // namespace rasterlens
