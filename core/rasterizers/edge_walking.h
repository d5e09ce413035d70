#pragma once
#include "core/pipeline/fragment_stage.h"
#include "core/pipeline/observer.h"
#include "core/pipeline/stopping.h"
#include "core/pipeline/triangle_setup.h"
#include "core/rasterizers/registry.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rasterlens
{

/// What ceil(v - 0.5) and its counterpart make of the point v where an edge crosses the centre line of a row. Under
/// Rules::wholeRows a row is crossed at its upper border, and corners of samples stand in place of their centres.
struct RowCrossing {
    std::int64_t atOrAfter; ///< first sample whose centre is not left of the edge
    std::int64_t after;     ///< first sample whose centre is right of the edge
};

/// How far from the corner of a sample a row is crossed, on both axes.
template <class T>
[[nodiscard]] constexpr T crossedAt(const Rules& rules)
{
    return rules.wholeRows ? T(0) : Grid<T>::kCentre;
}

/// Follows one edge down, row by row.
///
/// in   upper.y < lower.y
template <class T>
class EdgeWalker
{
public:
    EdgeWalker(Point<T> upper, Point<T> lower, int firstRow, const Rules& rules)
        : m_upper(upper), m_slope((lower.x - upper.x) / (lower.y - upper.y)), m_crossedAt(crossedAt<T>(rules)),
          m_stepping(rules.stepping)
    {
        if (!rules.edgesPreStepped)
            m_upper.y = TriangleSetup<T>::centre(0, firstRow).y;
        jumpTo(firstRow);
    }

    [[nodiscard]] RowCrossing crossing() const
    {
        const T v = m_x - m_crossedAt;
        return {hold(std::ceil(v)), hold(std::floor(v)) + 1};
    }

    /// Where the edge crosses the row, in samples.
    [[nodiscard]] double position() const { return static_cast<double>(m_x); }

    /// The next row down: one addition, or the line equation anew.
    void step()
    {
        if (m_stepping == Stepping::Incremental)
            m_x += m_slope;
        else
            jumpTo(m_row + 1);
    }

    /// Evaluates the line equation anew at a row: what additions have rounded away does not reach the next half.
    void restartAt(int row) { jumpTo(row); }

private:
    static std::int64_t hold(T sample)
    {
        constexpr T kFar = 1 << 30;
        return sample > -kFar ? static_cast<std::int64_t>(std::min(sample, kFar)) : -(1 << 30); // also NaN
    }

    void jumpTo(int row)
    {
        m_row = row;
        m_x = m_upper.x + (static_cast<T>(row) * Grid<T>::kUnit + m_crossedAt - m_upper.y) * m_slope;
    }

    Point<T> m_upper;
    T m_slope; ///< samples a row
    T m_x = 0; ///< where the edge crosses the row
    T m_crossedAt;
    int m_row = 0;
    Stepping m_stepping;
};

/// Fixed point: the crossing is a fraction of integers, stepped as quotient and remainder, so it is exact.
template <>
class EdgeWalker<std::int64_t>
{
public:
    using T = std::int64_t;

    EdgeWalker(Point<T> upper, Point<T> lower, int firstRow, const Rules& rules)
        : m_upper(upper), m_dx(lower.x - upper.x), m_dy(lower.y - upper.y), m_crossedAt(crossedAt<T>(rules)),
          m_stepping(rules.stepping)
    {
        if (!rules.edgesPreStepped)
            m_upper.y = TriangleSetup<T>::centre(0, firstRow).y;
        const Fraction perRow = divide(Grid<T>::kUnit * m_dx);
        m_perRow = perRow;
        jumpTo(firstRow);
    }

    [[nodiscard]] RowCrossing crossing() const { return {m_x.floor + (m_x.rest > 0 ? 1 : 0), m_x.floor + 1}; }

    /// Where the edge crosses the row, in samples.
    [[nodiscard]] double position() const
    {
        return static_cast<double>(m_x.floor) + static_cast<double>(m_x.rest) / static_cast<double>(denominator()) +
               static_cast<double>(m_crossedAt) / Grid<T>::kUnit;
    }

    void step()
    {
        if (m_stepping == Stepping::Direct) {
            jumpTo(m_row + 1);
            return;
        }
        m_x.floor += m_perRow.floor;
        m_x.rest += m_perRow.rest;
        if (m_x.rest >= denominator()) {
            m_x.rest -= denominator();
            ++m_x.floor;
        }
    }

    /// Nothing to do at the row the edge has come to: steps of fractions are exact.
    void restartAt(int) {}

private:
    /// floor + rest / denominator, 0 <= rest < denominator
    struct Fraction {
        T floor;
        T rest;
    };

    [[nodiscard]] T denominator() const { return Grid<T>::kUnit * m_dy; }

    [[nodiscard]] Fraction divide(T numerator) const
    {
        Fraction f{numerator / denominator(), numerator % denominator()};
        if (f.rest < 0) {
            f.rest += denominator();
            --f.floor;
        }
        return f;
    }

    void jumpTo(int row)
    {
        m_row = row;
        const T down = row * Grid<T>::kUnit + m_crossedAt - m_upper.y;
        m_x = divide((m_upper.x - m_crossedAt) * m_dy + down * m_dx);
    }

    Point<T> m_upper;
    T m_dx;
    T m_dy;
    T m_crossedAt;
    Stepping m_stepping;
    Fraction m_perRow{}; ///< samples
    Fraction m_x{};      ///< samples, measured from the first centre or corner
    int m_row = 0;
};

/// The fraction of the way in space that belongs to the fraction m of the way on the screen, from a point at depth w1
/// to one at w2.
///
/// source  Heckbert & Moreton, Interpolation for Polygon Texture Mapping and Shading, 1991
[[nodiscard]] inline double perspectiveFraction(double m, double w1, double w2)
{
    return m * w1 / ((1 - m) * w2 + m * w1);
}

/// What edge-then-span carries along an edge and then along a span.
struct CarriedPoint {
    double x; ///< samples
    double w;
    Interpolants values;

    [[nodiscard]] CarriedPoint towards(const CarriedPoint& other, double m, const Rules& rules) const
    {
        const double n = rules.perspectiveCorrect ? perspectiveFraction(m, w, other.w) : m;
        CarriedPoint p;
        p.x = std::lerp(x, other.x, m);
        p.w = std::lerp(w, other.w, n);
        p.values.carriedDepth = std::lerp(values.carriedDepth, other.values.carriedDepth, rules.depthLinear ? m : n);
        for (std::size_t i = 0; i < 3; ++i) {
            p.values.onScreen[i] = std::lerp(values.onScreen[i], other.values.onScreen[i], m);
            p.values.weights[i] = std::lerp(values.weights[i], other.values.weights[i], n);
        }
        return p;
    }
};

/// Sorts the vertices by y, follows the long edge and the two short ones down, and fills the spans between them.
struct EdgeWalking {
    static constexpr RasterizerInfo info{Algorithm::EdgeWalking, "Foley & van Dam, Computer Graphics, section 3.6"};

    [[nodiscard]] static std::optional<Reason> supports(const Rules&) { return std::nullopt; }

    /// Calls emit(x, y) for every covered sample, row by row from the top, left to right, or emit.drawRow() for rows of
    /// them where it has that; with edge-then-span emit(x, y, what was interpolated on the way).
    template <class T, class Emit, class Observer>
    static void cover(const TriangleSetup<T>& setup, const ScreenTriangle& triangle, const Rules& rules, Emit& emit,
                      Observer& observer)
    {
        observer.onOutline();
        const Sorted<T> s = sortByY(setup);
        if (s.vertices[0].y == s.vertices[2].y)
            return; // no edge to follow
        const Rows rows = rowsOf(s, setup.bounds, rules);
        const WalkedTriangle walk = observed(s, rows);
        observer.onWalk(walk);
        observer.onSides(walk);
        observer.onHalves(walk, observedHalves(walk, rules));
        int y = rows.first;
        const auto endOf = [&](std::size_t i) {
            const T extra = static_cast<T>(rules.extraEdgeHeight) * Grid<T>::kUnit;
            return Point<T>{s.vertices[i].x, s.vertices[i].y + extra};
        };
        if (y > rows.last)
            return;
        EdgeWalker<T> longEdge(s.vertices[0], endOf(2), y, rules);
        // Upper half: long edge and upper short edge. The row through the middle vertex belongs to the lower half
        // unless there is none.
        if (isUpperHalf(y, s, rules)) {
            EdgeWalker<T> shortEdge(s.vertices[0], endOf(1), y, rules);
            for (; y <= rows.last && isUpperHalf(y, s, rules) && !isStopped(emit);
                 ++y, longEdge.step(), shortEdge.step())
                fillSpan(y, longEdge, shortEdge, s, setup, triangle, rules, emit, observer);
        }
        if (y <= rows.last && !isStopped(emit)) {
            longEdge.restartAt(y);
            EdgeWalker<T> shortEdge(s.vertices[1], endOf(2), y, rules);
            for (; y <= rows.last && !isStopped(emit); ++y, longEdge.step(), shortEdge.step())
                fillSpan(y, longEdge, shortEdge, s, setup, triangle, rules, emit, observer);
        }
    }

private:
    template <class T>
    struct Sorted {
        std::array<Point<T>, 3> vertices;   ///< top, middle, bottom
        std::array<std::uint8_t, 3> source; ///< which vertex of the screen triangle each of them is
        bool longEdgeIsLeft;
    };

    struct Rows {
        int first;
        int last;
    };

    template <class T>
    static Sorted<T> sortByY(const TriangleSetup<T>& setup)
    {
        std::array<std::uint8_t, 3> order{0, 1, 2};
        const auto sortPair = [&](std::uint8_t& i, std::uint8_t& j) {
            const Point<T>& a = setup.vertices[i];
            const Point<T>& b = setup.vertices[j];
            if (b.y != a.y ? b.y < a.y : b.x < a.x)
                std::swap(i, j);
        };
        sortPair(order[0], order[1]);
        sortPair(order[1], order[2]);
        sortPair(order[0], order[1]);
        Sorted<T> s;
        for (std::size_t i = 0; i < 3; ++i) {
            s.vertices[i] = setup.vertices[order[i]];
            s.source[i] = setup.source[order[i]];
        }
        // The middle vertex lies right of the long edge if the long edge is the left one.
        const auto& [top, middle, bottom] = s.vertices;
        s.longEdgeIsLeft = (bottom.y - top.y) * (middle.x - top.x) > (bottom.x - top.x) * (middle.y - top.y);
        return s;
    }

    /// The rows of the bounds, less one whose centre lies on a horizontal edge that does not own its points.
    template <class T>
    static Rows rowsOf(const Sorted<T>& s, const PixelRect& bounds, const Rules& rules)
    {
        Rows rows{bounds.y, bounds.y + bounds.height - 1};
        if (rules.wholeRows)
            return rows;
        const auto& [top, middle, bottom] = s.vertices;
        if (top.y == middle.y && rules.tie.owner > 0 && TriangleSetup<T>::centre(0, rows.first).y <= top.y)
            ++rows.first;
        if (bottom.y == middle.y && rules.tie.other > 0 && TriangleSetup<T>::centre(0, rows.last).y >= bottom.y)
            --rows.last;
        return rows;
    }

    template <class T>
    static bool isUpperHalf(int row, const Sorted<T>& s, const Rules& rules)
    {
        const T middle = s.vertices[1].y;
        return s.vertices[2].y == middle || heightOf<T>(row, rules) < middle;
    }

    /// Where a row is crossed.
    template <class T>
    static T heightOf(int row, const Rules& rules)
    {
        return static_cast<T>(row) * Grid<T>::kUnit + crossedAt<T>(rules);
    }

    template <class T>
    static WalkedTriangle observed(const Sorted<T>& s, const Rows& rows)
    {
        const auto inSamples = [](const Point<T>& p) {
            return glm::dvec2(static_cast<double>(p.x), static_cast<double>(p.y)) / double(Grid<T>::kUnit);
        };
        return {{inSamples(s.vertices[0]), inSamples(s.vertices[1]), inSamples(s.vertices[2])},
                s.source,
                s.longEdgeIsLeft,
                rows.first,
                rows.last};
    }

    static WalkedHalves observedHalves(const WalkedTriangle& walk, const Rules& rules)
    {
        const auto& [top, middle, bottom] = walk.vertices;
        const double alpha = (middle.y - top.y) / (bottom.y - top.y + rules.extraEdgeHeight);
        const double firstLower =
            bottom.y == middle.y ? walk.lastRow + 1 : std::ceil(middle.y - crossedAt<double>(rules));
        const double held =
            std::clamp(firstLower, double(walk.firstRow), double(std::max(walk.firstRow, walk.lastRow + 1)));
        return {alpha, top.x + alpha * (bottom.x - top.x), static_cast<int>(held)};
    }

    template <class T>
    static RowCrossings observedCrossings(int y, const Sorted<T>& s, double xa, double xb, const Rules& rules)
    {
        const auto fraction = [&](std::size_t i, std::size_t j) {
            const double down = static_cast<double>(heightOf<T>(y, rules) - s.vertices[i].y);
            const double height = static_cast<double>(s.vertices[j].y - s.vertices[i].y);
            return down / (height + double(rules.extraEdgeHeight) * double(Grid<T>::kUnit));
        };
        const bool upperHalf = isUpperHalf(y, s, rules);
        return {y,
                y + crossedAt<double>(rules),
                upperHalf,
                fraction(0, 2),
                upperHalf ? fraction(0, 1) : fraction(1, 2),
                xa,
                xb,
                0,
                0};
    }

    template <class T, class Emit, class Observer>
    static void fillSpan(int y, const EdgeWalker<T>& longEdge, const EdgeWalker<T>& shortEdge, const Sorted<T>& s,
                         const TriangleSetup<T>& setup, const ScreenTriangle& triangle, const Rules& rules, Emit& emit,
                         Observer& observer)
    {
        if (skipsLine(emit, y))
            return;
        const bool longIsLeft =
            rules.wholeRows ? longEdge.position() < shortEdge.position() : s.longEdgeIsLeft || !rules.spanEndsSorted;
        const EdgeWalker<T>& leftEdge = longIsLeft ? longEdge : shortEdge;
        const EdgeWalker<T>& rightEdge = longIsLeft ? shortEdge : longEdge;
        const RowCrossing left = leftEdge.crossing();
        const RowCrossing right = rightEdge.crossing();
        // Start inclusive, end exclusive: a left edge owns its points, a right one does not.
        std::int64_t begin = rules.tie.owner > 0 ? left.after : left.atOrAfter;
        std::int64_t end = rules.tie.other > 0 ? right.atOrAfter : right.after;
        if (rules.wholeRows) {
            begin = left.after - 1;
            end = right.after;
        }
        const std::int64_t boundsEnd = std::int64_t(setup.bounds.x) + setup.bounds.width;
        const int xBegin = static_cast<int>(std::clamp<std::int64_t>(begin, setup.bounds.x, boundsEnd));
        const int xEnd = static_cast<int>(std::clamp<std::int64_t>(end, xBegin, boundsEnd));
        RowCrossings crossings = observedCrossings(y, s, longEdge.position(), shortEdge.position(), rules);
        crossings.xBegin = xBegin;
        crossings.xEnd = xEnd;
        observer.onCrossing(crossings);
        observer.onSpan(y, xBegin, xEnd,
                        {leftEdge.position(), rightEdge.position(), longIsLeft, isUpperHalf(y, s, rules), begin, end,
                         rules.tie.owner <= 0, rules.tie.other <= 0, rules.wholeRows});
        if (rules.attributePath == AttributePath::Planes) {
            emitRow(y, xBegin, xEnd, emit);
        } else if (xBegin < xEnd) {
            emitCarried(y, xBegin, xEnd, s, triangle, rules, emit);
        }
    }

    template <class Emit>
    static void emitRow(int y, int xBegin, int xEnd, Emit& emit)
    {
        if constexpr (requires { emit.drawRow(y, xBegin, xEnd); }) {
            emit.drawRow(y, xBegin, xEnd);
        } else {
            for (int x = xBegin; x < xEnd; ++x)
                emit(x, y);
        }
    }

    /// Interpolates along the long and the short edge to the row, then along the span to every sample.
    template <class T, class Emit>
    static void emitCarried(int y, int xBegin, int xEnd, const Sorted<T>& s, const ScreenTriangle& triangle,
                            const Rules& rules, Emit& emit)
    {
        const auto point = [&](std::size_t i) {
            const ScreenVertex& v = triangle.vertices[s.source[i]];
            CarriedPoint p{v.position.x, 1 / v.invW, {v.depth, {0, 0, 0}, {0, 0, 0}}};
            p.values.onScreen[s.source[i]] = p.values.weights[s.source[i]] = 1;
            return p;
        };
        const auto onEdge = [&](std::size_t i, std::size_t j) {
            const double upper = triangle.vertices[s.source[i]].position.y;
            const double lower = triangle.vertices[s.source[j]].position.y;
            return point(i).towards(point(j), (y + 0.5 - upper) / (lower - upper), rules);
        };
        const double middle = triangle.vertices[s.source[1]].position.y;
        const bool upperHalf = y + 0.5 < middle || s.vertices[1].y == s.vertices[2].y;
        const CarriedPoint a = onEdge(0, 2);
        const CarriedPoint b = upperHalf ? onEdge(0, 1) : onEdge(1, 2);
        const auto onSpan = [&](int x) { return a.towards(b, a.x != b.x ? (x + 0.5 - a.x) / (b.x - a.x) : 0, rules); };
        if (rules.dividedEvery == 1)
            for (int x = xBegin; x < xEnd; ++x)
                emit(x, y, onSpan(x).values);
        else
            emitStretches(y, xBegin, xEnd, rules, onSpan, emit);
    }

    /// Divides at the first sample of every stretch of the span, and at the last sample of the span. Between two of
    /// these, weights and depth run straight.
    ///
    /// source  M. Abrash, Graphics Programming Black Book, chapter 70: Quake divides at every 16th pixel
    template <class OnSpan, class Emit>
    static void emitStretches(int y, int xBegin, int xEnd, const Rules& rules, const OnSpan& onSpan, Emit& emit)
    {
        const auto between = [](const Weights& from, const Weights& to, double way) {
            return Weights{std::lerp(from[0], to[0], way), std::lerp(from[1], to[1], way),
                           std::lerp(from[2], to[2], way)};
        };
        const int last = xEnd - 1;
        Interpolants from = onSpan(xBegin).values;
        emit(xBegin, y, from);
        for (int x = xBegin; x < last;) {
            const int next = std::min(x + rules.dividedEvery, last);
            const Interpolants to = onSpan(next).values;
            for (int at = x + 1; at < next; ++at) {
                const double way = static_cast<double>(at - x) / (next - x);
                emit(at, y,
                     Interpolants{std::lerp(from.carriedDepth, to.carriedDepth, way),
                                  between(from.onScreen, to.onScreen, way), between(from.weights, to.weights, way)});
            }
            emit(next, y, to);
            from = to;
            x = next;
        }
    }
};

} // namespace rasterlens
