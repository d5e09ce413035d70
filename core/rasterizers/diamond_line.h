#pragma once
#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace rasterlens
{

/// A point in units of 1/256 sample.
struct LinePoint {
    static constexpr std::int64_t kUnit = 256;
    std::int64_t x;
    std::int64_t y;

    [[nodiscard]] static LinePoint of(const glm::dvec2& samples)
    {
        return {std::llround(samples.x * kUnit), std::llround(samples.y * kUnit)};
    }
};

/// Whether a point is in the diamond |dx| + |dy| < 1/2 round the centre of a sample. The two lower edges of its border
/// and the lower corner belong to it, and for steep lines the right corner.
///
/// source  Direct3D 11, Rasterization Rules: Line Rasterization Rules (Aliased, Without Multisampling)
[[nodiscard]] inline bool isInDiamond(LinePoint p, std::int64_t column, std::int64_t row, bool steep)
{
    constexpr std::int64_t kHalf = LinePoint::kUnit / 2;
    const std::int64_t dx = p.x - (column * LinePoint::kUnit + kHalf);
    const std::int64_t dy = p.y - (row * LinePoint::kUnit + kHalf);
    const std::int64_t distance = std::abs(dx) + std::abs(dy);
    return distance < kHalf || (distance == kHalf && (dy > 0 || (steep && dx == kHalf)));
}

/// Calls plot(column, row, t) for every sample whose diamond the line leaves; t is the fraction of the way at which it
/// passes the centre's column, or row where it is steep, 0..1. So a line that goes on in another has no sample twice.
///
/// A line of at most 45 degrees meets a diamond only if it is within it at the centre's column: from any point within,
/// the way there changes y by no more than it lessens |dx|.
///
/// in      |coordinate| <= 2^29
/// exact   integers only
/// source  as isInDiamond()
template <class Plot>
void diamondExitLine(LinePoint from, LinePoint to, Plot&& plot)
{
    constexpr std::int64_t kUnit = LinePoint::kUnit;
    const std::int64_t dx = to.x - from.x;
    const std::int64_t dy = to.y - from.y;
    const bool steep = std::abs(dy) > std::abs(dx);
    // Along the longer axis, and across it.
    const std::int64_t along = steep ? dy : dx;
    const std::int64_t across = steep ? dx : dy;
    const std::int64_t fromAlong = steep ? from.y : from.x;
    const std::int64_t toAlong = steep ? to.y : to.x;
    const std::int64_t fromAcross = steep ? from.x : from.y;
    if (along == 0)
        return;
    const std::int64_t step = along > 0 ? 1 : -1;
    const auto floorOf = [](std::int64_t value, std::int64_t by) {
        return value / by - (value % by != 0 && (value < 0) != (by < 0) ? 1 : 0);
    };
    const std::int64_t last = floorOf(toAlong, kUnit) + step;
    for (std::int64_t i = floorOf(fromAlong, kUnit) - step; i != last + step; i += step) {
        const std::int64_t way = i * kUnit + kUnit / 2 - fromAlong; // to the centre
        // The sample whose upper, or left, border lies before the point: one on a border belongs to the one before it.
        const std::int64_t scaled = fromAcross * std::abs(along) + across * way * step;
        const std::int64_t j = floorOf(scaled - 1, std::abs(along) * kUnit);
        const std::int64_t column = steep ? j : i;
        const std::int64_t row = steep ? i : j;
        const bool startsBefore = way * step >= 0 || isInDiamond(from, column, row, steep);
        const bool endsBehind = (toAlong - fromAlong - way) * step >= 0 && !isInDiamond(to, column, row, steep);
        if (startsBefore && endsBehind) {
            const double t = static_cast<double>(way) / static_cast<double>(along);
            plot(static_cast<int>(column), static_cast<int>(row), t < 0 ? 0.0 : t > 1 ? 1.0 : t);
        }
    }
}

} // namespace rasterlens
