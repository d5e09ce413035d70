#include "core/pipeline/triangle_lines.h"

namespace rasterlens
{
namespace
{

/// Relative error of a sum of three products of a weight and a number, in terms of the products before weights cancel:
/// a weight's four factors, its products and their difference round once each, and so do product and sums; 2^-53 each.
constexpr double kRoundings = 10 * 0x1p-53;

} // namespace

bool TriangleLines::Bounded::isGood() const { return error <= 0x1p-31 * std::abs(value); }

TriangleLines::Bounded TriangleLines::DoubleWeights::sum(const Triple& of) const
{
    Bounded result{0, 0};
    for (std::size_t i = 0; i < 3; ++i) {
        result.value += values[i] * of[i];
        result.error += magnitudes[i] * std::abs(of[i]);
    }
    result.error *= kRoundings;
    return result;
}

TriangleLines::TriangleLines(const ClipTriangle& triangle, const PlaneTable& cut, const PlaneTable& view,
                             ClipPlanes planes)
    : m_triangle(&triangle), m_cut(&cut), m_view(&view)
{
    for (ClipLine line = 0; line < kFirstSide; ++line)
        if ((planes & 1U << line) != 0)
            addLine(line);
    m_lines[kEdgeAB] = {0, 0, 1};
    m_lines[kEdgeBC] = {1, 0, 0};
    m_lines[kEdgeCA] = {0, 1, 0};
}

void TriangleLines::addSides()
{
    for (ClipLine line = kFirstSide; line < kEdgeAB; ++line)
        addLine(line);
}

void TriangleLines::addLine(ClipLine line)
{
    for (std::size_t i = 0; i < 3; ++i)
        m_lines[line][i] = planeOf(line).distanceRoundedOnce(m_triangle->vertices[i].positionClip);
}

TriangleLines::DoubleWeights TriangleLines::crossOf(const Triple& p, const Triple& q)
{
    DoubleWeights weights;
    for (std::size_t i = 0; i < 3; ++i) {
        const double plus = p[(i + 1) % 3] * q[(i + 2) % 3];
        const double minus = p[(i + 2) % 3] * q[(i + 1) % 3];
        weights.values[i] = plus - minus;
        weights.magnitudes[i] = std::abs(plus) + std::abs(minus);
    }
    return weights;
}

bool TriangleLines::isCounterClockwise() const
{
    // det[x y w] as x weighted by cross(y, w)
    const Triple y = coordinates(1);
    const Triple w = coordinates(3);
    const Bounded determinant = crossOf(y, w).sum(coordinates(0));
    return determinant.isGood() ? determinant.value > 0 : isExactlyCounterClockwise();
}

TriangleLines::Triple TriangleLines::coordinates(int axis) const
{
    const auto& [a, b, c] = m_triangle->vertices;
    return {a.positionClip[axis], b.positionClip[axis], c.positionClip[axis]};
}

double TriangleLines::distance(ClipCorner corner, ClipLine line, double estimate) const
{
    constexpr double kWanted = 0x1p-30;
    if (corner.arriving == line || corner.leaving == line)
        return 0;
    if (isVertex(corner))
        return estimate; // its position is not rounded
    const DoubleWeights weights = crossOf(m_lines[corner.arriving], m_lines[corner.leaving]);
    const Bounded distance = weights.sum(m_lines[line]);
    const Bounded total = weights.sum({1, 1, 1});
    if (!distance.isGood() || !total.isGood())
        return exactDistance(corner, line);
    const double value = distance.value / total.value;
    return std::abs(estimate - value) <= kWanted * std::abs(value) ? estimate : value;
}

double TriangleLines::snappedOn(const ScreenAxis& axis, ClipCorner corner, const DoubleWeights& weights,
                                const Bounded& w) const
{
    const Bounded p = weights.sum(coordinates(axis.coordinate));
    const double halfSize = static_cast<double>(axis.units) / 2;
    const double quotient = axis.sign * p.value / w.value;
    const double estimate = (quotient + 1) * halfSize;
    // The error of a quotient: that of the numerator, and that of the denominator times the quotient.
    const double scale = std::abs(quotient) + 1;
    const double error = (2 * (p.error + scale * w.error) / std::abs(w.value) + kRoundings * scale) * halfSize;
    const double below = std::floor(estimate);
    const double fromTie = estimate - below - 0.5;
    if (!w.isGood() || !(std::abs(fromTie) > error))
        return exactSnap(corner, axis);
    return fromTie < 0 ? below : below + 1;
}

glm::dvec2 TriangleLines::snapped(ClipCorner corner, const Rules& rules) const
{
    const auto units = [&](int pixels) { return std::int64_t{pixels} << rules.subpixelBits; };
    const DoubleWeights weights = crossOf(m_lines[corner.arriving], m_lines[corner.leaving]);
    const Bounded w = weights.sum(coordinates(3));
    return {snappedOn({0, 1, units(rules.width - rules.viewportShort)}, corner, weights, w),
            snappedOn({1, rules.screenUp, units(rules.height - rules.viewportShort)}, corner, weights, w)};
}

} // namespace rasterlens
