#pragma once
#include "core/settings/depth_rules.h"

#include <algorithm>
#include <cmath>

namespace rasterlens
{

/// How a depth becomes what the buffer stores.
struct DepthStore {
    DepthFormat format = DepthFormat::Float32;
    double low = 0; ///< depths are held within low..high
    double high = 1;
    bool truncates = false; ///< unorm formats take the code below in place of the nearest one

    DepthStore(DepthFormat format) : format(format) {}
    explicit DepthStore(const Rules& rules)
        : format(rules.depthFormat), low(std::min(rules.depthRange.near, rules.depthRange.far)),
          high(std::max(rules.depthRange.near, rules.depthRange.far)), truncates(rules.depthTruncated)
    {
    }
};

/// The nearest value the depth format can store, held within the depth range; NaN gives its low end.
///
/// out     unorm formats as the float32 nearest to n / (2^bits - 1), which keeps order and distinctness
/// source  Direct3D 11.3 Functional Specification, 17.10 Depth Clamp and 17.11 Depth Comparison
[[nodiscard]] inline float storedDepth(double depth, const DepthStore& store)
{
    const double notBelow = depth > store.low ? depth : store.low;
    const double held = notBelow < store.high ? notBelow : store.high;
    const int largest = largestDepthCode(store.format);
    if (largest == 0)
        return static_cast<float>(held);
    const double code = store.truncates ? std::floor(held * largest) : std::nearbyint(held * largest);
    return static_cast<float>(code / largest);
}

/// Whether a fragment of this depth replaces the stored one.
[[nodiscard]] inline bool depthPasses(float depth, float stored, DepthCompare compare)
{
    switch (compare) {
    case DepthCompare::Less: return depth < stored;
    case DepthCompare::LessEqual: return depth <= stored;
    case DepthCompare::Equal: return depth == stored;
    case DepthCompare::GreaterEqual: return depth >= stored;
    case DepthCompare::Greater: return depth > stored;
    case DepthCompare::NotEqual: return depth != stored;
    case DepthCompare::Always: break;
    }
    return true;
}

} // namespace rasterlens
