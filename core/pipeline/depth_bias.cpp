#include "core/pipeline/depth_bias.h"

#include "core/settings/depth_rules.h"

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr int kMantissaBits = 23; // of float32, without the hidden bit

double unitOf(std::span<const ScreenVertex> polygon, DepthFormat format)
{
    if (const int largest = largestDepthCode(format); largest > 0)
        return 1.0 / largest;
    float deepest = 0; // a corner that was cut at the far plane is at 1, and no rounding of the cut puts it below
    for (const ScreenVertex& vertex : polygon)
        deepest = std::max(deepest, static_cast<float>(std::abs(vertex.depth)));
    return deepest > 0 ? std::ldexp(1.0, std::ilogb(deepest) - kMantissaBits) : 0;
}

/// Per pixel, where positions are in samples.
double steepnessOf(std::span<const ScreenVertex> polygon, const Rules& rules)
{
    const auto at = [&](std::size_t i) { return glm::dvec3(polygon[i].position, polygon[i].depth); };
    glm::dvec3 normal(0);
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        normal += glm::cross(at(i) - at(0), at(i + 1) - at(0));
    return std::max(std::abs(normal.x), std::abs(normal.y)) / std::abs(normal.z) * rules.sampleGrid;
}

} // namespace

double depthBias(std::span<const ScreenVertex> polygon, const Rules& rules)
{
    const DepthBias& asked = rules.depthBias;
    double bias = asked.constant * unitOf(polygon, rules.depthFormat);
    if (asked.slope != 0) // 0 times an infinite steepness is no number
        bias += asked.slope * steepnessOf(polygon, rules);
    if (asked.clamp > 0)
        return std::min(asked.clamp, bias);
    return asked.clamp < 0 ? std::max(asked.clamp, bias) : bias;
}

} // namespace rasterlens
