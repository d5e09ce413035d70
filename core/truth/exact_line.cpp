#include "core/truth/exact_line.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rasterlens
{
namespace
{

using Point = glm::i64vec2;
constexpr std::int64_t kUnit = 256;
constexpr std::int64_t kHalf = kUnit / 2;

struct Fraction {
    std::int64_t top;
    std::int64_t bottom; ///< > 0
    [[nodiscard]] bool isLess(const Fraction& other) const { return top * other.bottom < other.top * bottom; }
};

bool isSteep(const Point& from, const Point& to) { return std::abs(to.y - from.y) > std::abs(to.x - from.x); }

/// Within the diamond, on one of its two lower sides, or on the corner that belongs to it.
///
/// in   from the centre
bool isWithin(const Point& p, bool steep)
{
    const std::int64_t distance = std::abs(p.x) + std::abs(p.y);
    return distance < kHalf || (distance == kHalf && (p.y > 0 || (steep && p.x == kHalf)));
}

} // namespace

bool leavesDiamond(const glm::i64vec2& from, const glm::i64vec2& to, int column, int row)
{
    const bool steep = isSteep(from, to);
    const Point centre(column * kUnit + kHalf, row * kUnit + kHalf);
    const Point a = from - centre;
    const Point b = to - centre;
    if (isWithin(b, steep) || isWithin(a, steep))
        return !isWithin(b, steep);
    Fraction enter{0, 1};
    Fraction leave{1, 1};
    bool passes = true;
    for (const int sx : {-1, 1})
        for (const int sy : {-1, 1}) {
            const std::int64_t da = kHalf - sx * a.x - sy * a.y;
            const std::int64_t db = kHalf - sx * b.x - sy * b.y;
            passes = passes && (da > 0 || db > 0);
            if (da < db && enter.isLess({-da, db - da}))
                enter = {-da, db - da};
            if (da > db && Fraction{da, da - db}.isLess(leave))
                leave = {da, da - db};
        }
    const Point corner = steep ? Point(kHalf, 0) : Point(0, kHalf);
    const Point way = b - a;
    const Point toCorner = corner - a;
    const std::int64_t along = toCorner.x * way.x + toCorner.y * way.y;
    const bool meetsCorner =
        toCorner.x * way.y == toCorner.y * way.x && along > 0 && along < way.x * way.x + way.y * way.y;
    return (passes && enter.isLess(leave)) || meetsCorner;
}

std::vector<glm::ivec2> exactLine(const glm::i64vec2& from, const glm::i64vec2& to)
{
    const int axis = isSteep(from, to) ? 1 : 0;
    const auto sampleOf = [](std::int64_t position) { return static_cast<int>(position >> 8); };
    const double way = static_cast<double>(to[axis] - from[axis]);
    std::vector<glm::ivec2> samples;
    for (int i = sampleOf(std::min(from[axis], to[axis])) - 1; i <= sampleOf(std::max(from[axis], to[axis])) + 1; ++i) {
        // where about the line passes there; two samples to either side are more than enough
        const double t = way == 0 ? 0 : (static_cast<double>(i * kUnit + kHalf - from[axis])) / way;
        const double across =
            static_cast<double>(from[1 - axis]) + t * static_cast<double>(to[1 - axis] - from[1 - axis]);
        const int middle = static_cast<int>(std::floor(across / kUnit));
        for (int j = middle - 2; j <= middle + 2; ++j) {
            const glm::ivec2 sample = axis == 0 ? glm::ivec2(i, j) : glm::ivec2(j, i);
            if (leavesDiamond(from, to, sample.x, sample.y))
                samples.push_back(sample);
        }
    }
    return samples;
}

std::vector<glm::ivec2> exactCentreLine(const glm::ivec2& from, const glm::ivec2& to)
{
    const glm::ivec2 way = to - from;
    const int axis = std::abs(way.y) > std::abs(way.x) ? 1 : 0;
    const std::int64_t longer = std::abs(way[axis]);
    const std::int64_t shorter = std::abs(way[1 - axis]);
    std::vector<glm::ivec2> samples;
    for (std::int64_t i = 0; i <= longer; ++i) {
        // i * shorter / longer, to the nearest whole number, down from a half
        const std::int64_t aside = longer > 0 ? (2 * i * shorter + longer - 1) / (2 * longer) : 0;
        glm::ivec2 sample = from;
        sample[axis] += static_cast<int>(way[axis] < 0 ? -i : i);
        sample[1 - axis] += static_cast<int>(way[1 - axis] < 0 ? -aside : aside);
        samples.push_back(sample);
    }
    return samples;
}

} // namespace rasterlens
