#include "core/pipeline/triangle_setup.h"

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

} // namespace

PixelRect boundsByRules(const ScreenTriangle& triangle, const PixelRect& clamped, const Rules& rules)
{
    switch (rules.bounds) {
    case Bounds::OneShort: return {clamped.x, clamped.y, clamped.width - 1, clamped.height - 1};
    case Bounds::Unclamped: {
        const auto& [a, b, c] = triangle.vertices;
        const glm::dvec2 low = glm::min(glm::min(a.position, b.position), c.position);
        const glm::dvec2 high = glm::max(glm::max(a.position, b.position), c.position);
        const SampleRange columns = unclamped(low.x, high.x, rules.columns());
        const SampleRange rows = unclamped(low.y, high.y, rules.rows());
        return {columns.first, rows.first, columns.last - columns.first + 1, rows.last - rows.first + 1};
    }
    case Bounds::Clamped: break;
    }
    return clamped;
}

} // namespace rasterlens
