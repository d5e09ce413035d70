#pragma once
#include "core/pipeline/types.h"
#include "core/settings/rules.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

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
    bool owner;  ///< a left or a top edge: points on it belong to the triangle under the top-left rule

    [[nodiscard]] T at(Point<T> p) const { return a * (p.x - from.x) + b * (p.y - from.y); }
};

/// One triangle ready for coverage.
template <class T>
struct TriangleSetup {
    std::array<Point<T>, 3> vertices;     ///< A, B, C counter-clockwise with y up, whatever the face's winding
    std::array<std::uint8_t, 3> source;   ///< which vertex of the screen triangle each of them is
    std::array<EdgeFunction<T>, 3> edges; ///< AB, BC, CA
    PixelRect bounds;                     ///< samples whose centre lies within the vertices' extent and the target

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

/// The bounds of a triangle for rules.bounds.
///
/// in   the bounds clamped to the target, not empty
[[nodiscard]] PixelRect boundsByRules(const ScreenTriangle& triangle, const PixelRect& clamped, const Rules& rules);

template <class T>
[[nodiscard]] EdgeFunction<T> edgeFunction(Point<T> from, Point<T> to, const Rules& rules)
{
    EdgeFunction<T> edge{to.y - from.y, from.x - to.x, from, 0, false};
    // E grows to the right across a left edge, and downwards across a top edge.
    edge.owner = edge.a > 0 || (edge.a == 0 && edge.b > 0);
    edge.threshold = static_cast<T>(edge.owner ? rules.tie.owner : rules.tie.other) * Grid<T>::tieUnit(rules);
    return edge;
}

/// Whether a triangle of this area is set up with B and C exchanged, so that its edge values are positive inside.
template <class T>
[[nodiscard]] bool isTurned(T area2, const Rules& rules)
{
    return area2 < 0 && rules.triangleOriented;
}

/// Edge functions, tie thresholds and bounds of a screen triangle.
///
/// in      positions in samples; fixed point: snapped
/// out     nothing if the bounds hold no sample centre or the area is zero in T
template <class T>
[[nodiscard]] std::optional<TriangleSetup<T>> setupTriangle(const ScreenTriangle& triangle, const Rules& rules)
{
    const auto& [a, b, c] = triangle.vertices;
    const SampleRange columns = samplesBetween(std::min({a.position.x, b.position.x, c.position.x}),
                                               std::max({a.position.x, b.position.x, c.position.x}), rules.columns());
    const SampleRange rows = samplesBetween(std::min({a.position.y, b.position.y, c.position.y}),
                                            std::max({a.position.y, b.position.y, c.position.y}), rules.rows());
    if (columns.first > columns.last || rows.first > rows.last)
        return std::nullopt;

    TriangleSetup<T> setup;
    setup.bounds = {columns.first, rows.first, columns.last - columns.first + 1, rows.last - rows.first + 1};
    setup.source = {0, 1, 2};
    for (std::size_t i = 0; i < 3; ++i)
        setup.vertices[i] = {Grid<T>::fromSamples(triangle.vertices[i].position.x),
                             Grid<T>::fromSamples(triangle.vertices[i].position.y)};
    const T area2 = edgeFunction(setup.vertices[0], setup.vertices[1], rules).at(setup.vertices[2]);
    if (area2 == 0 && rules.rejectsZeroArea)
        return std::nullopt;
    if (isTurned(area2, rules)) {
        std::swap(setup.vertices[1], setup.vertices[2]);
        std::swap(setup.source[1], setup.source[2]);
    }
    for (std::size_t i = 0; i < 3; ++i)
        setup.edges[i] = edgeFunction(setup.vertices[i], setup.vertices[(i + 1) % 3], rules);
    if (rules.bounds != Bounds::Clamped)
        setup.bounds = boundsByRules(triangle, setup.bounds, rules);
    return setup;
}

} // namespace rasterlens
