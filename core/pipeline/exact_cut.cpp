#include "core/pipeline/clipping.h"

#include <boost/multiprecision/cpp_int.hpp>

namespace rasterlens
{
namespace
{

using Rational = boost::multiprecision::cpp_rational;

Rational exactDistance(const glm::dvec4& p, const PlaneEquation& plane)
{
    Rational distance(-plane.offset);
    for (int k = 0; k < 4; ++k)
        distance += Rational(plane.normal[k]) * Rational(p[k]);
    return distance;
}

} // namespace

glm::dvec4 cutExactly(const glm::dvec4& inside, const glm::dvec4& outside, const PlaneEquation& plane)
{
    const Rational in = exactDistance(inside, plane);
    const Rational out = exactDistance(outside, plane);
    const Rational length = in - out;
    glm::dvec4 cut;
    for (int k = 0; k < 4; ++k)
        cut[k] = static_cast<double>(Rational((in * Rational(outside[k]) - out * Rational(inside[k])) / length));
    return cut;
}

} // namespace rasterlens
