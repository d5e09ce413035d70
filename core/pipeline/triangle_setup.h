#pragma once
#include "core/pipeline/types.h"
#include "core/settings/rules.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>

namespace rasterlens
{

/// The numbers coverage is decided with: 24.8 fixed point in 64 bits, float or double.
template <class T>
struct Grid {
    static constexpr T kUnit = 1;                     ///< units a sample
    static constexpr T kCentre = static_cast<T>(0.5); ///< from a sample's corner to its centre
    static constexpr T kSmallest = std::numeric_limits<T>::denorm_min();
    /// What the tie thresholds count in.
    [[nodiscard]] static T tieUnit(const Rules& rules)
    {
        return rules.floatTieUnit > 0 ? static_cast<T>(rules.floatTieUnit) : kSmallest;
    }
    [[nodiscard]] static T fromSamples(double position) { return static_cast<T>(position); }
};

template <>
struct Grid<std::int64_t> {
    static constexpr std::int64_t kUnit = 256;
    static constexpr std::int64_t kCentre = 128;
    [[nodiscard]] static std::int64_t tieUnit(const Rules&) { return 1; }
    /// exact  snapped positions are multiples of 1/256
    [[nodiscard]] static std::int64_t fromSamples(double position) { return static_cast<std::int64_t>(position * 256); }
};

template <class T>
struct Point {
    T x;
    T y;
};

/// E(p) = a (p.x - from.x) + b (p.y - from.y), positive inside the triangle: twice the area of the edge and p.
///
/// source  Pineda, A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988
template <class T>
struct EdgeFunction {
    T a; ///< added for a step of one unit in x
    T b; ///< added for a step of one unit in y
    Point<T> from;
    T threshold; ///< the smallest value that counts as inside

    /// A left or a top edge: points on it belong to the triangle under the top-left rule. E grows to the right across a
    /// left edge, and downwards across a top edge.
    [[nodiscard]] bool owner() const { return a > 0 || (a == 0 && b > 0); }

    [[nodiscard]] T at(Point<T> p) const { return a * (p.x - from.x) + b * (p.y - from.y); }
    /// The value at the corner of a square round p that lies deepest inside; reach < 0: farthest outside.
    ///
    /// source  Akenine-Moller & Aila, Conservative and tiled rasterization using a modified triangle set-up, JGT 10(3),
    ///         2005
    [[nodiscard]] T atCorner(Point<T> p, T reach) const { return at(p) + reach * (std::abs(a) + std::abs(b)); }
};

/// One triangle ready for coverage.
template <class T>
struct TriangleSetup {
    std::array<Point<T>, 3> vertices;     ///< A, B, C counter-clockwise with y up, whatever the face's winding
    std::array<std::uint8_t, 3> source;   ///< which vertex of the screen triangle each of them is
    std::array<EdgeFunction<T>, 3> edges; ///< AB, BC, CA
    PixelRect bounds;                     ///< samples whose centre lies within the vertices' extent and the target,
                                          ///< or whose square touches it

    [[nodiscard]] static Point<T> centre(int x, int y)
    {
        return {static_cast<T>(x) * Grid<T>::kUnit + Grid<T>::kCentre,
                static_cast<T>(y) * Grid<T>::kUnit + Grid<T>::kCentre};
    }
};

/// Samples [first, last] along one axis whose centre lies in [low, high], clamped to [0, size).
struct SampleRange {
    int first;
    int last; ///< < first: none
};

[[nodiscard]] inline SampleRange samplesBetween(double low, double high, int size)
{
    const double first = std::ceil(low - 0.5);
    const double last = std::floor(high - 0.5);
    return {first > 0 ? static_cast<int>(std::min(first, double(size))) : 0,
            last < size - 1 ? static_cast<int>(std::max(last, -1.0)) : size - 1};
}

/// Samples between positions that are in units of 1/256 sample.
[[nodiscard]] inline SampleRange samplesBetween(std::int64_t low, std::int64_t high, int size)
{
    constexpr int kUnitBits = 8;
    constexpr std::int64_t kCentre = Grid<std::int64_t>::kCentre;
    const std::int64_t first = (low + kCentre - 1) >> kUnitBits; // the first centre at low or right of it
    const std::int64_t last = (high - kCentre) >> kUnitBits;     // the last at high or left of it
    return {static_cast<int>(std::clamp<std::int64_t>(first, 0, size)),
            static_cast<int>(std::clamp<std::int64_t>(last, -1, size - 1))};
}

/// How far from the centre of a sample, along both axes, the corner of its square lies where an edge function is asked:
/// the corner that lies deepest inside the edge (conservative, > 0), or the one that lies farthest outside (inner, <
/// 0).
template <class T>
[[nodiscard]] constexpr T cornerReach(const Rules& rules)
{
    switch (rules.coverageRule) {
    case CoverageRule::Centre: break;
    case CoverageRule::Conservative: return Grid<T>::kCentre;
    case CoverageRule::Inner: return -Grid<T>::kCentre;
    }
    return 0;
}

/// The bounds of a triangle for rules.bounds, or for rules.wholeRows.
///
/// in   the bounds clamped to the target; not empty but for whole rows
[[nodiscard]] PixelRect boundsByRules(const ScreenTriangle& triangle, const PixelRect& clamped, const Rules& rules);

template <class T>
[[nodiscard]] EdgeFunction<T> edgeFunction(Point<T> from, Point<T> to, const Rules& rules)
{
    EdgeFunction<T> edge{to.y - from.y, from.x - to.x, from, 0};
    edge.threshold = static_cast<T>(edge.owner() ? rules.tie.owner : rules.tie.other) * Grid<T>::tieUnit(rules);
    return edge;
}

/// Whether a triangle of this area is set up with B and C exchanged, so that its edge values are positive inside.
template <class T>
[[nodiscard]] bool isTurned(T area2, const Rules& rules)
{
    return area2 < 0 && rules.triangleOriented;
}

/// The samples whose centre lies within the extent of the corners, and the target; none: width or height is 0 or less.
/// Conservative: whose square touches the extent.
///
/// in  corners  the positions of the triangle in T; only fixed point may be asked for its bounds in T
template <class T>
[[nodiscard]] PixelRect boundsWithin(const ScreenTriangle& triangle, const std::array<Point<T>, 3>& corners,
                                     const Rules& rules)
{
    const auto within = [&]<class U>(U a, U b, U c, int size) {
        const U reach = std::max(cornerReach<U>(rules), U(0));
        return samplesBetween(std::min({a, b, c}) - reach, std::max({a, b, c}) + reach, size);
    };
    const auto rect = [](SampleRange columns, SampleRange rows) {
        return PixelRect{columns.first, rows.first, columns.last - columns.first + 1, rows.last - rows.first + 1};
    };
    if constexpr (std::is_same_v<T, std::int64_t>) {
        const auto& [a, b, c] = corners;
        return rect(within(a.x, b.x, c.x, rules.columns()), within(a.y, b.y, c.y, rules.rows()));
    } else {
        const glm::dvec2& a = triangle.vertices[0].position;
        const glm::dvec2& b = triangle.vertices[1].position;
        const glm::dvec2& c = triangle.vertices[2].position;
        return rect(within(a.x, b.x, c.x, rules.columns()), within(a.y, b.y, c.y, rules.rows()));
    }
}

/// Fills a set-up, see setupTriangle(), unless there is nothing to draw.
template <class T>
[[nodiscard]] bool setUp(TriangleSetup<T>& setup, const ScreenTriangle& triangle, const Rules& rules)
{
    std::array<Point<T>, 3> corners;
    for (std::size_t i = 0; i < 3; ++i)
        corners[i] = {Grid<T>::fromSamples(triangle.vertices[i].position.x),
                      Grid<T>::fromSamples(triangle.vertices[i].position.y)};
    setup.bounds = boundsWithin(triangle, corners, rules);
    if ((setup.bounds.width <= 0 || setup.bounds.height <= 0) && !rules.wholeRows)
        return false;

    const T area2 = edgeFunction(corners[0], corners[1], rules).at(corners[2]);
    if (area2 == 0 && rules.rejectsZeroArea)
        return false;
    setup.source = {0, 1, 2};
    if (isTurned(area2, rules)) {
        std::swap(corners[1], corners[2]);
        std::swap(setup.source[1], setup.source[2]);
    }
    setup.vertices = corners;
    for (std::size_t i = 0; i < 3; ++i)
        setup.edges[i] = edgeFunction(corners[i], corners[(i + 1) % 3], rules);
    if (rules.bounds != Bounds::Clamped || rules.wholeRows)
        setup.bounds = boundsByRules(triangle, setup.bounds, rules);
    return true;
}

/// Edge functions, tie thresholds and bounds of a screen triangle.
///
/// in      positions in samples; fixed point: snapped
/// out     nothing if the bounds hold no sample centre or the area is zero in T
template <class T>
[[nodiscard]] std::optional<TriangleSetup<T>> setupTriangle(const ScreenTriangle& triangle, const Rules& rules)
{
    std::optional<TriangleSetup<T>> setup(std::in_place);
    if (!setUp(*setup, triangle, rules))
        setup.reset();
    return setup;
}

} // namespace rasterlens
