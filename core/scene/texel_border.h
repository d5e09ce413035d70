#pragma once
#include <cmath>

namespace rasterlens
{

// The rule of borders between texels. A texel begins at its lower border. A coordinate that lies below a border by no
// more than float32 and the order of its sums account for counts as on it: else that rounding would draw noise where
// samples lie on a border exactly. The two numbers are no fractions that samples meet by themselves.
constexpr float kBorderReach = 0x1p-20F;   ///< texels
constexpr float kBorderShare = 0x1.4p-22F; ///< of the distance from coordinate 0

/// The number of the texel that holds a coordinate given in texels, before it is wrapped or clamped.
[[nodiscard]] inline float texelFloor(float texels)
{
    return std::floor(texels + (std::abs(texels) * kBorderShare + kBorderReach));
}

} // namespace rasterlens
