#pragma once
#include "core/pipeline/types.h"
#include "core/settings/rules.h"

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>

namespace rasterlens
{

/// Twice the signed area of a screen triangle, in samples squared; positive is counter-clockwise seen with y up.
///
/// exact   for snapped positions
[[nodiscard]] inline double twiceArea(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.y - a.y) * (c.x - a.x) - (b.x - a.x) * (c.y - a.y);
}

/// Depth over a triangle as a plane whose coefficients are rounded so that every value at a sample inside the
/// triangle's bounds is exact in double, in whatever order the terms are added: all rasterizers, stepping or not,
/// get the same depth bit for bit.
///
/// in      sample (x, y); the plane is evaluated at its centre
/// covers  needles, whose gradient is too steep for that, and depth that is not to be linear, by barycentric weights
///         of exact edge values
struct DepthPlane {
    double origin = 0; ///< at the centre of sample (0, 0)
    double perX = 0;
    double perY = 0;
    bool byWeights = false;

    [[nodiscard]] double at(int x, int y) const { return origin + perX * x + perY * y; }
};

/// Coefficients may be off by this much over the whole bounds before the plane is given up: well below the last bit
/// of float32 depth, 2^-24.
constexpr double kPlaneError = 0x1p-30;
constexpr double kPlaneMargin = 4; ///< samples round the bounds where the plane is exact too, for work on blocks

[[nodiscard]] DepthPlane depthPlane(const ScreenTriangle& triangle, double area2, const Rules& rules);

/// The triangle with depth, w and varyings of its corners handed round as `data` says.
[[nodiscard]] ScreenTriangle withCornerData(const ScreenTriangle& triangle, CornerData data);

/// Whether the depths of a triangle are read: by the depth test, a shading or an output.
enum class DepthUse { Read, Ignored };

/// Everything needed to evaluate depth and varyings of one triangle at a sample.
class FaceInterpolation
{
public:
    /// Values of the edge functions AB, BC, CA of a TriangleSetup in fixed point.
    using EdgeIntegers = std::array<std::int64_t, 3>;

    /// in   a triangle whose area2 != 0, or a line, of which only points known by their weights may be asked for; whose
    ///      depths are ignored must not be asked for one
    FaceInterpolation(const ScreenTriangle& triangle, double area2, const Rules& rules, DepthUse use = DepthUse::Read);

    /// Screen-space barycentric weights at the centre of sample (x, y): edge value over area.
    [[nodiscard]] Weights weightsAt(int x, int y) const { return weightsAt(glm::dvec2(x + 0.5, y + 0.5)); }

    /// Screen-space barycentric weights at a point, in samples.
    [[nodiscard]] Weights weightsAt(const glm::dvec2& p) const
    {
        const auto& [a, b, c] = m_triangle->vertices;
        const double wa = twiceArea(b.position, c.position, p) * m_inverseArea2;
        const double wb = twiceArea(c.position, a.position, p) * m_inverseArea2;
        return {wa, wb, 1 - wa - wb};
    }

    /// Screen-space barycentric weights at the centre of sample (x, y), from its edge values where these are at hand.
    [[nodiscard]] Weights weightsAt(int x, int y, const EdgeIntegers& edges) const
    {
        if (!m_edgesFitDoubles)
            return weightsAt(x, y);
        const double wa = static_cast<double>(edges[1]) * m_weightPerEdgeUnit;
        const double wb = static_cast<double>(m_isTurned ? edges[0] : edges[2]) * m_weightPerEdgeUnit;
        return {wa, wb, 1 - wa - wb};
    }

    /// Depth at the centre of the sample; linear on the screen.
    ///
    /// in   screen(): the weights of the same sample; called only where there is no plane
    template <std::invocable ComputeWeights>
    [[nodiscard]] double depthAt(int x, int y, ComputeWeights&& screen) const
    {
        return m_depth.byWeights ? depthOf(screen()) : m_depth.at(x, y);
    }
    [[nodiscard]] double depthAt(int x, int y, const Weights& screen) const
    {
        return depthAt(x, y, [&] { return screen; });
    }

    /// Depth beside the centre of a sample, by an offset in samples; linear on the screen.
    [[nodiscard]] double depthAt(int x, int y, const glm::dvec2& offset) const
    {
        if (m_depth.byWeights)
            return depthOf(weightsAt(glm::dvec2(x + 0.5, y + 0.5) + offset));
        return m_depth.at(x, y) + (m_depth.perX * offset.x + m_depth.perY * offset.y);
    }

    /// Depth of a point known by its weights alone (lines).
    [[nodiscard]] double depthOf(const Weights& screen) const;

    /// b_i / w_i over their sum; the weights as they are if perspective correction is off.
    [[nodiscard]] Weights perspective(const Weights& screen) const
    {
        return m_perspectiveCorrect ? corrected(screen) : screen;
    }

    /// b_i / w_i over their sum.
    [[nodiscard]] Weights corrected(const Weights& screen) const
    {
        const auto& [a, b, c] = m_triangle->vertices;
        const double wa = screen[0] * a.invW;
        const double wb = screen[1] * b.invW;
        const double wc = screen[2] * c.invW;
        const double w = 1 / (wa + wb + wc);
        return {wa * w, wb * w, wc * w};
    }

    /// Varying k: the sum of weight times what the vertices have.
    [[nodiscard]] float varying(std::size_t k, const Weights& weights) const
    {
        const auto& [a, b, c] = m_varyings[k];
        return static_cast<float>(weights[0] * a + weights[1] * b + weights[2] * c);
    }

    /// The first rules.varyingCount floats.
    void varyings(const Weights& weights, Varyings& out) const
    {
        for (std::size_t k = 0; k < m_varyingCount; ++k)
            out[k] = varying(k, weights);
    }

    /// The derivatives, at a sample, of the two varyings from `at` on; 0 on a line, which has none across itself.
    ///
    /// in   weights of that sample, on the screen and after perspective()
    [[nodiscard]] UvGradient uvGradient(const Weights& screen, const Weights& weights, std::size_t at) const;

    [[nodiscard]] const DepthPlane& planeOfDepth() const { return m_depth; }
    [[nodiscard]] bool correctsPerspective() const { return m_perspectiveCorrect; }
    [[nodiscard]] const ScreenTriangle& triangle() const { return *m_triangle; }

private:
    [[nodiscard]] Weights roundedWeights(const Weights& weights) const;

    const ScreenTriangle* m_triangle;
    double m_inverseArea2;
    double m_weightPerEdgeUnit; ///< edge values are positive inside, whatever the sign of area2
    bool m_isTurned;            ///< the set-up has B and C exchanged, so the edge opposite B is its first one
    bool m_edgesFitDoubles;     ///< doubles hold all products of edge functions without rounding
    DepthPlane m_depth;
    std::size_t m_varyingCount;
    std::array<std::array<double, 3>, kMaxVaryings> m_varyings; ///< those that are carried, of A, B and C
    bool m_perspectiveCorrect;
    bool m_depthLinear;
    double m_weightUnit; ///< rules.weightUnit
};

} // namespace rasterlens
