// The integer arithmetic behind TriangleLines, for the few corners that doubles leave in doubt.
#include "core/base/nearest_double.h"
#include "core/pipeline/triangle_lines.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <limits>

namespace rasterlens
{
namespace
{

/// Integers of any length. What comes of triangles of float32 positions fits 2048 bits and allocates nothing.
using Integer = boost::multiprecision::number<
    boost::multiprecision::cpp_int_backend<2048, 0, boost::multiprecision::signed_magnitude,
                                           boost::multiprecision::unchecked,
                                           std::allocator<boost::multiprecision::limb_type>>,
    boost::multiprecision::et_off>;
using Integers = std::array<Integer, 3>;

constexpr int kMantissaBits = 53;
constexpr int kNoExponent = std::numeric_limits<int>::max();

/// The exponent of the last bit of a double's mantissa. in: finite; 0 has none
int lastExponent(double value)
{
    if (value == 0)
        return kNoExponent;
    int exponent = 0;
    auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), kMantissaBits));
    for (exponent -= kMantissaBits; mantissa % 2 == 0; mantissa /= 2)
        ++exponent;
    return exponent;
}

/// value / 2^exponent, an integer. in: exponent <= lastExponent(value)
Integer integerOf(double value, int exponent)
{
    if (value == 0)
        return 0;
    const int last = lastExponent(value);
    return Integer(static_cast<std::int64_t>(std::ldexp(value, -last))) << static_cast<unsigned>(last - exponent);
}

/// One coordinate, or the distances to one plane, of A, B and C: integers times 2^exponent.
struct Column {
    Integers values;
    int exponent;
};

Column columnOf(const std::array<double, 3>& values)
{
    Column column{{}, 0};
    const int last = std::min({lastExponent(values[0]), lastExponent(values[1]), lastExponent(values[2])});
    column.exponent = last == kNoExponent ? 0 : last;
    for (std::size_t i = 0; i < 3; ++i)
        column.values[i] = integerOf(values[i], column.exponent);
    return column;
}

/// The sum of two columns.
Column sum(const Column& a, const Column& b)
{
    Column result{{}, std::min(a.exponent, b.exponent)};
    for (std::size_t i = 0; i < 3; ++i)
        result.values[i] = (a.values[i] << static_cast<unsigned>(a.exponent - result.exponent)) +
                           (b.values[i] << static_cast<unsigned>(b.exponent - result.exponent));
    return result;
}

Column product(const Column& a, double factor)
{
    const int exponent = factor == 0 ? 0 : lastExponent(factor);
    Column result{{}, a.exponent + exponent};
    for (std::size_t i = 0; i < 3; ++i)
        result.values[i] = a.values[i] * integerOf(factor, exponent);
    return result;
}

Integer dot(const Integers& a, const Integers& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Integer total(const Integers& a) { return a[0] + a[1] + a[2]; }

Integers crossProduct(const Integers& p, const Integers& q)
{
    Integers product;
    for (std::size_t i = 0; i < 3; ++i)
        product[i] = p[(i + 1) % 3] * q[(i + 2) % 3] - p[(i + 2) % 3] * q[(i + 1) % 3];
    return product;
}

/// The weights of the point where two lines cross; their sum is > 0, unless the lines are parallel.
Integers crossingWeights(const Integers& p, const Integers& q)
{
    Integers weights = crossProduct(p, q);
    if (total(weights).sign() < 0)
        for (Integer& weight : weights)
            weight = -weight;
    return weights;
}

/// One coordinate of A, B and C.
Column axisColumn(const ClipTriangle& triangle, int axis)
{
    const auto& [a, b, c] = triangle.vertices;
    return columnOf({a.positionClip[axis], b.positionClip[axis], c.positionClip[axis]});
}

/// How far A, B and C are inside a plane.
Column distanceColumn(const ClipTriangle& triangle, const PlaneEquation& plane)
{
    Column distances = columnOf({-plane.offset, -plane.offset, -plane.offset});
    for (int axis = 0; axis < 4; ++axis)
        distances = sum(distances, product(axisColumn(triangle, axis), plane.normal[axis]));
    return distances;
}

/// in: denominator > 0
std::int64_t roundHalfToEven(const Integer& numerator, const Integer& denominator)
{
    Integer quotient;
    Integer remainder;
    divide_qr(numerator, denominator, quotient, remainder);
    auto rounded = static_cast<std::int64_t>(quotient);
    if (remainder.sign() < 0) {
        remainder += denominator;
        --rounded;
    }
    const int side = Integer(2 * remainder).compare(denominator);
    return side > 0 || (side == 0 && rounded % 2 != 0) ? rounded + 1 : rounded;
}

/// The mean of a column by weights.
double mean(const Column& column, const Integers& weights)
{
    if (total(weights).is_zero())
        return -std::numeric_limits<double>::infinity(); // parallel lines: nowhere on the triangle
    return std::ldexp(nearestQuotient(dot(column.values, weights), total(weights)), column.exponent);
}

} // namespace

/// The integers of a clipper's triangle.
struct TriangleLines::Exact {
    const TriangleLines& lines;

    [[nodiscard]] Column column(ClipLine line) const
    {
        switch (line) {
        case kEdgeAB: return columnOf({0, 0, 1});
        case kEdgeBC: return columnOf({1, 0, 0});
        case kEdgeCA: return columnOf({0, 1, 0});
        default: return distanceColumn(*lines.m_triangle, lines.planeOf(line));
        }
    }

    [[nodiscard]] Integers weights(ClipCorner corner) const
    {
        return crossingWeights(column(corner.arriving).values, column(corner.leaving).values);
    }
};

double TriangleLines::exactDistance(ClipCorner corner, ClipLine line) const
{
    return mean(Exact{*this}.column(line), Exact{*this}.weights(corner));
}

glm::dvec4 TriangleLines::position(ClipCorner corner) const
{
    const Integers weights = Exact{*this}.weights(corner);
    glm::dvec4 position;
    for (int axis = 0; axis < 4; ++axis)
        position[axis] = mean(axisColumn(*m_triangle, axis), weights);
    return position;
}

Weights TriangleLines::weights(ClipCorner corner) const
{
    const Integers weights = Exact{*this}.weights(corner);
    const Integer sum = total(weights);
    return {nearestQuotient(weights[0], sum), nearestQuotient(weights[1], sum), nearestQuotient(weights[2], sum)};
}

bool TriangleLines::isExactlyCounterClockwise() const
{
    const Column x = axisColumn(*m_triangle, 0);
    return dot(x.values, crossProduct(axisColumn(*m_triangle, 1).values, axisColumn(*m_triangle, 3).values)).sign() > 0;
}

double TriangleLines::exactSnap(ClipCorner corner, const ScreenAxis& axis) const
{
    const Integers weights = Exact{*this}.weights(corner);
    const Column w = axisColumn(*m_triangle, 3);
    const Column p = sum(product(axisColumn(*m_triangle, axis.coordinate), axis.sign), w); // its exponent is not larger
    const Integer numerator = dot(p.values, weights) * axis.units;
    const Integer denominator = (2 * dot(w.values, weights)) << static_cast<unsigned>(w.exponent - p.exponent);
    if (denominator.sign() <= 0)
        return 0; // behind the eye: no corner of a clipped triangle
    return static_cast<double>(roundHalfToEven(numerator, denominator));
}

} // namespace rasterlens
