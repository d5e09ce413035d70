#include "core/pipeline/interpolation.h"

#include "core/pipeline/triangle_setup.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rasterlens
{
namespace
{

/// Rounds to a multiple of `quantum`, a power of two.
double roundTo(double value, double quantum)
{
    const double magic = quantum * 0x1.8p52;
    return (value + magic) - magic;
}

/// The greatest power of two that is not greater than a positive normal number.
double powerOfTwoBelow(double value)
{
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) & 0x7ff0000000000000U);
}

/// Whether the products in the edge functions, at samples within the extent of the triangle, are whole numbers of at
/// most 53 bits in units of 2^-16.
bool edgesFitDoubles(const ScreenTriangle& triangle)
{
    const auto& [a, b, c] = triangle.vertices;
    const glm::dvec2 extent =
        glm::max(glm::max(a.position, b.position), c.position) - glm::min(glm::min(a.position, b.position), c.position);
    return extent.x * extent.y <= 0x1p36;
}

} // namespace

DepthPlane depthPlane(const ScreenTriangle& triangle, double area2, const Rules& rules)
{
    const auto& [a, b, c] = triangle.vertices;
    const glm::dvec2 ab = b.position - a.position;
    const glm::dvec2 ac = c.position - a.position;
    const double zb = b.depth - a.depth;
    const double zc = c.depth - a.depth;
    const double inverse = 1 / area2;
    const double perX = (zc * ab.y - zb * ac.y) * inverse;
    const double perY = (zb * ac.x - zc * ab.x) * inverse;

    // Where the plane is evaluated: the bounds of the triangle inside the target, and a few samples around.
    const glm::dvec2 low = glm::max(glm::min(glm::min(a.position, b.position), c.position), 0.0) - kPlaneMargin;
    const glm::dvec2 high =
        glm::min(glm::max(glm::max(a.position, b.position), c.position), glm::dvec2(rules.columns(), rules.rows())) +
        kPlaneMargin;
    const double originAtZero = a.depth + perX * (0.5 - a.position.x) + perY * (0.5 - a.position.y);
    const double largest = std::abs(originAtZero) + std::abs(perX) * std::max(std::abs(high.x), kPlaneMargin) +
                           std::abs(perY) * std::max(std::abs(high.y), kPlaneMargin);
    if (!std::isfinite(largest) || !rules.depthLinear || rules.weightUnit > 0)
        return {.byWeights = true};
    const double quantum = powerOfTwoBelow(std::max(largest, 0x1p-900)) * 0x1p-51;
    const double extent = (high.x - low.x) + (high.y - low.y) + 1;
    // What rounding in the gradients themselves may add, seen from vertex a.
    const double steepness = (std::abs(zc * ab.y) + std::abs(zb * ac.y) + std::abs(zb * ac.x) + std::abs(zc * ab.x)) *
                             std::abs(inverse) * 0x1p-52;
    if (!((quantum + steepness) * extent < kPlaneError))
        return {.byWeights = true};
    DepthPlane plane{0, roundTo(perX, quantum), roundTo(perY, quantum), false};
    // Anchored at the vertex with the rounded gradients, so that their rounding does not grow with the distance from
    // the screen's corner.
    plane.origin = roundTo(a.depth + plane.perX * (0.5 - a.position.x) + plane.perY * (0.5 - a.position.y), quantum);
    return plane;
}

ScreenTriangle withCornerData(const ScreenTriangle& triangle, CornerData data)
{
    std::array<std::size_t, 3> from{0, 1, 2};
    switch (data) {
    case CornerData::Own: break;
    case CornerData::Next: from = {1, 2, 0}; break;
    case CornerData::Exchanged: from = {0, 2, 1}; break;
    case CornerData::Unsorted: {
        // The n-th corner from the top is given what the n-th corner of the face has.
        std::array<std::size_t, 3> byY{0, 1, 2};
        std::stable_sort(byY.begin(), byY.end(), [&](std::size_t i, std::size_t j) {
            return triangle.vertices[i].position.y < triangle.vertices[j].position.y;
        });
        for (std::size_t i = 0; i < 3; ++i)
            from[byY[i]] = i;
        break;
    }
    }
    ScreenTriangle out = triangle;
    for (std::size_t i = 0; i < 3; ++i) {
        out.vertices[i] = triangle.vertices[from[i]];
        out.vertices[i].position = triangle.vertices[i].position;
    }
    return out;
}

FaceInterpolation::FaceInterpolation(const ScreenTriangle& triangle, double area2, const Rules& rules, DepthUse use)
    : m_triangle(&triangle), m_inverseArea2(1 / area2),
      m_weightPerEdgeUnit(std::abs(m_inverseArea2) / (double(Grid<std::int64_t>::kUnit) * Grid<std::int64_t>::kUnit)),
      m_isTurned(isTurned(area2, rules)), m_edgesFitDoubles(edgesFitDoubles(triangle)),
      m_depth(use == DepthUse::Read ? depthPlane(triangle, area2, rules) : DepthPlane()),
      m_varyingCount(static_cast<std::size_t>(rules.varyingCount)), m_perspectiveCorrect(rules.perspectiveCorrect),
      m_depthLinear(rules.depthLinear), m_weightUnit(rules.weightUnit)
{
    for (std::size_t k = 0; k < m_varyingCount; ++k)
        for (std::size_t i = 0; i < 3; ++i)
            m_varyings[k][i] = triangle.vertices[i].varyings[k];
}

/// The sum of the three may be another one than 1.
Weights FaceInterpolation::roundedWeights(const Weights& weights) const
{
    const auto rounded = [&](double weight) { return std::floor(weight / m_weightUnit + 0.5) * m_weightUnit; };
    return {rounded(weights[0]), rounded(weights[1]), rounded(weights[2])};
}

double FaceInterpolation::depthOf(const Weights& screen) const
{
    const auto& [a, b, c] = m_triangle->vertices;
    const Weights weights = m_depthLinear ? screen : perspective(screen);
    if (m_weightUnit > 0) {
        const Weights rounded = roundedWeights(weights);
        return rounded[0] * a.depth + rounded[1] * b.depth + rounded[2] * c.depth;
    }
    return a.depth + (weights[1] * (b.depth - a.depth) + weights[2] * (c.depth - a.depth));
}

UvGradient FaceInterpolation::uvGradient(const Weights& screen, const Weights& weights, std::size_t at) const
{
    if (m_triangle->isLine)
        return {};
    const auto& v = m_triangle->vertices;
    glm::dvec2 center(0);
    double inverseW = 0;
    std::array<glm::dvec2, 3> uv;
    std::array<double, 3> q;
    for (std::size_t k = 0; k < 3; ++k) {
        uv[k] = {v[k].varyings[at], v[k].varyings[at + 1]};
        q[k] = m_perspectiveCorrect ? v[k].invW : 1;
        center += weights[k] * uv[k];
        inverseW += screen[k] * q[k];
    }
    // With uv = sum(b q uv_k) / sum(b q), the quotient rule leaves sum(b' q (uv_k - uv)) / sum(b q).
    glm::dvec2 perX(0);
    glm::dvec2 perY(0);
    for (std::size_t k = 0; k < 3; ++k) {
        const glm::dvec2 opposite = v[(k + 2) % 3].position - v[(k + 1) % 3].position;
        const glm::dvec2 pull = (uv[k] - center) * (q[k] * m_inverseArea2 / inverseW);
        perX += opposite.y * pull;
        perY -= opposite.x * pull;
    }
    return {glm::vec2(perX), glm::vec2(perY)};
}

} // namespace rasterlens
