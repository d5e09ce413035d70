#include "core/pipeline/triangle_setup.h"

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

/// So far beyond the target a box goes that is not clamped to it: farther ones would keep the machine busy for hours.
constexpr double kFarthest = 1024;

SampleRange unclamped(double low, double high, int size)
{
    return {static_cast<int>(std::ceil(std::max(low, -kFarthest) - 0.5)),
            static_cast<int>(std::floor(std::min(high, size + kFarthest) - 0.5))};
}

/// Rows from the first whole height to the last, columns that hold a part of the triangle; none: height 0 or less.
PixelRect wholeNumbers(const glm::dvec2& low, const glm::dvec2& high, const Rules& rules)
{
    const auto held = [](double at, int size) { return static_cast<int>(std::clamp(at, -1.0, double(size))); };
    const int left = std::max(held(std::floor(low.x), rules.columns()), 0);
    const int right = std::min(held(std::floor(high.x), rules.columns()), rules.columns() - 1);
    const int top = std::max(held(std::ceil(low.y), rules.rows()), 0);
    const int bottom = std::min(held(std::floor(high.y), rules.rows()), rules.rows() - 1);
    return {left, top, right - left + 1, bottom - top + 1};
}

} // namespace

PixelRect boundsByRules(const ScreenTriangle& triangle, const PixelRect& clamped, const Rules& rules)
{
    const auto& [a, b, c] = triangle.vertices;
    const glm::dvec2 low = glm::min(glm::min(a.position, b.position), c.position);
    const glm::dvec2 high = glm::max(glm::max(a.position, b.position), c.position);
    if (rules.wholeRows)
        return wholeNumbers(low, high, rules);
    switch (rules.bounds) {
    case Bounds::OneShort: return {clamped.x, clamped.y, clamped.width - 1, clamped.height - 1};
    case Bounds::Unclamped: {
        const SampleRange columns = unclamped(low.x, high.x, rules.columns());
        const SampleRange rows = unclamped(low.y, high.y, rules.rows());
        return {columns.first, rows.first, columns.last - columns.first + 1, rows.last - rows.first + 1};
    }
    case Bounds::Clamped: break;
    }
    return clamped;
}

} // namespace rasterlens
