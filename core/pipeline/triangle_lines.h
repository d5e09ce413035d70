#pragma once
#include "core/pipeline/observer.h"
#include "core/pipeline/types.h"
#include "core/settings/rules.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace rasterlens
{

/// A set of clip planes, one bit a ClipPlane.
using ClipPlanes = std::uint32_t;

[[nodiscard]] constexpr ClipPlanes planeBit(ClipPlane plane) { return 1U << static_cast<unsigned>(plane); }

/// Inside is dot(normal, position) >= offset. Only w >= 1e-5 has an offset; without one a plane does not change under
/// scaling.
struct PlaneEquation {
    glm::dvec4 normal{0, 0, 0, 0};
    double offset = 0;

    /// exact  for float32 positions: where normal.w is 0 or 1 all but one rounding, so the sign is right
    [[nodiscard]] double distance(const glm::dvec4& p) const
    {
        return (normal.x * p.x + normal.y * p.y + normal.z * p.z) + normal.w * p.w - offset;
    }

    /// A distance for any normal.w. Near the plane, the rounding of the product with w would be all that is left of it.
    ///
    /// exact  for float32 positions: the sign, and 31 bits of the value
    [[nodiscard]] double carefulDistance(const glm::dvec4& p) const
    {
        constexpr double kCancelled = 0x1p-20;
        const double rounded = distance(p);
        return std::abs(rounded) > kCancelled * std::abs(normal.w * p.w) ? rounded : distanceRoundedOnce(p);
    }

    /// exact  for float32 positions and a plane without offset: all but one rounding
    [[nodiscard]] double distanceRoundedOnce(const glm::dvec4& p) const
    {
        const double others = normal.x * p.x + normal.y * p.y + normal.z * p.z;
        const bool productIsExact = normal.w == 0 || normal.w == 1;
        return (productIsExact ? others + normal.w * p.w : std::fma(normal.w, p.w, others)) - offset;
    }
};

using PlaneTable = std::array<PlaneEquation, 7>; ///< indexed by ClipPlane

// The numbers of the lines. A plane of the clip volume has the number of its ClipPlane.
constexpr ClipLine kFirstSide = 7; ///< four sides of the viewport, by which Cohen-Sutherland cuts: right to bottom
constexpr ClipLine kEdgeAB = 11;
constexpr ClipLine kEdgeBC = 12;
constexpr ClipLine kEdgeCA = 13;
constexpr std::size_t kClipLines = 14;

[[nodiscard]] constexpr ClipLine lineOf(ClipPlane plane) { return static_cast<ClipLine>(plane); }

/// A triangle and the lines that clipping cuts it by. A line is three numbers, what the corners A, B and C have: the
/// distance to a plane, or 1 for the corner opposite an edge and 0 for the ends of the edge. Everything between the
/// corners is linear, so the point where lines p and q cross has the barycentric weights cross(p, q): no matter how
/// many planes cut the triangle, a corner of what is left is computed from the triangle itself, in one step.
///
/// Answers come from doubles where a bound of their rounding errors shows that they are right, else from integers of
/// any length.
class TriangleLines
{
public:
    /// in   planes: those of `cut` that cut the triangle; all arguments are to outlive the lines
    TriangleLines(const ClipTriangle& triangle, const PlaneTable& cut, const PlaneTable& view, ClipPlanes planes);

    /// Adds the sides of the viewport that the projected edges are cut by.
    void addSides();

    /// Whether a corner is one of the triangle's own vertices.
    [[nodiscard]] static bool isVertex(ClipCorner corner)
    {
        return corner.arriving >= kEdgeAB && corner.leaving >= kEdgeAB;
    }

    /// How far a corner is inside of a line: the estimate where that is right to 30 bits.
    ///
    /// in     estimate: from a rounded position, or NaN
    /// exact  the sign, and 30 bits of the value; minus infinity where the lines of the corner are parallel
    [[nodiscard]] double distance(ClipCorner corner, ClipLine line, double estimate) const;

    /// exact  each coordinate is the double nearest to the true one
    [[nodiscard]] glm::dvec4 position(ClipCorner corner) const;

    /// Whether what is visible of the triangle (w > 0) runs counter-clockwise, y up.
    ///
    /// exact  always
    [[nodiscard]] bool isCounterClockwise() const;

    /// What the vertices of the triangle contribute to a corner; the sum is 1.
    [[nodiscard]] Weights weights(ClipCorner corner) const;

    /// The screen position of a corner in units of 1/2^subpixelBits pixel, half to even.
    ///
    /// in     a corner with w > 0 within the guard band
    /// exact  always
    [[nodiscard]] glm::dvec2 snapped(ClipCorner corner, const Rules& rules) const;

private:
    using Triple = std::array<double, 3>; ///< one number for each of A, B, C

    /// A number and how far it may be from the true one.
    struct Bounded {
        double value;
        double error;

        [[nodiscard]] bool isGood() const; ///< right to 31 bits
    };

    /// Not normalized: their sum may be any number but 0.
    struct DoubleWeights {
        Triple values;
        Triple magnitudes; ///< of the products whose difference each of them is

        [[nodiscard]] Bounded sum(const Triple& of) const;
    };

    /// An axis of the screen: position = (sign * coordinate / w + 1) * units / 2.
    struct ScreenAxis {
        int coordinate;     ///< of clip space: 0 is x, 1 is y
        double sign;        ///< +1 or -1
        std::int64_t units; ///< 1/2^subpixelBits pixel, over the viewport
    };

    /// The plane behind a line that is no edge.
    [[nodiscard]] const PlaneEquation& planeOf(ClipLine line) const
    {
        constexpr auto kRight = static_cast<std::size_t>(ClipPlane::Right);
        return line < kFirstSide ? (*m_cut)[line] : (*m_view)[line - kFirstSide + kRight];
    }

    void addLine(ClipLine line);
    [[nodiscard]] static DoubleWeights crossOf(const Triple& p, const Triple& q);
    [[nodiscard]] Triple coordinates(int axis) const;
    [[nodiscard]] double snappedOn(const ScreenAxis& axis, ClipCorner corner, const DoubleWeights& weights,
                                   const Bounded& w) const;

    // The integer arithmetic, in exact_cut.cpp.
    struct Exact;
    [[nodiscard]] double exactDistance(ClipCorner corner, ClipLine line) const;
    [[nodiscard]] bool isExactlyCounterClockwise() const;
    [[nodiscard]] double exactSnap(ClipCorner corner, const ScreenAxis& axis) const;

    const ClipTriangle* m_triangle;
    const PlaneTable* m_cut;
    const PlaneTable* m_view;
    std::array<Triple, kClipLines> m_lines;
};

} // namespace rasterlens
