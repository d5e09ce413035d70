#pragma once
#include "core/settings/depth_rules.h"

#include <cmath>

namespace rasterlens
{

/// The nearest value the depth format can store, held within 0..1; NaN gives 0.
///
/// out   unorm formats as the float32 nearest to n / (2^bits - 1), which keeps order and distinctness
[[nodiscard]] inline float storedDepth(double depth, DepthFormat format)
{
    const double positive = depth > 0 ? depth : 0;
    const double held = positive < 1 ? positive : 1;
    const int largest = largestDepthCode(format);
    return static_cast<float>(largest > 0 ? std::nearbyint(held * largest) / largest : held);
}

/// Whether a fragment of this depth replaces the stored one.
[[nodiscard]] inline bool depthPasses(float depth, float stored, DepthCompare compare)
{
    switch (compare) {
    case DepthCompare::Less: return depth < stored;
    case DepthCompare::LessEqual: return depth <= stored;
    case DepthCompare::Greater: return depth > stored;
    case DepthCompare::GreaterEqual: return depth >= stored;
    case DepthCompare::Always: break;
    }
    return true;
}

} // namespace rasterlens
