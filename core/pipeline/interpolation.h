#pragma once
#include "core/pipeline/types.h"
#include "core/settings/rules.h"

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
};

/// Coefficients may be off by this much over the whole bounds before the plane is given up: well below the last bit
/// of float32 depth, 2^-24.
constexpr double kPlaneError = 0x1p-30;
constexpr double kPlaneMargin = 4; ///< samples round the bounds where the plane is exact too, for work on blocks

[[nodiscard]] DepthPlane depthPlane(const ScreenTriangle& triangle, double area2, const Rules& rules);

/// The triangle with depth, w and varyings of its corners handed round as `data` says.
[[nodiscard]] ScreenTriangle withCornerData(const ScreenTriangle& triangle, CornerData data);

/// Everything needed to evaluate depth and varyings of one triangle at a sample.
class FaceInterpolation
{
public:
    /// in   a triangle whose area2 != 0
    FaceInterpolation(const ScreenTriangle& triangle, double area2, const Rules& rules);

    /// Screen-space barycentric weights at the centre of sample (x, y): edge value over area.
    [[nodiscard]] Weights weightsAt(int x, int y) const;

    /// Depth at the centre of the sample; linear on the screen.
    ///
    /// in   the weights of the same sample
    [[nodiscard]] double depthAt(int x, int y, const Weights& screen) const;

    /// Depth of a point known by its weights alone (lines).
    [[nodiscard]] double depthOf(const Weights& screen) const;

    /// b_i / w_i over their sum; the weights as they are if perspective correction is off.
    [[nodiscard]] Weights perspective(const Weights& screen) const;

    /// The first rules.varyingCount floats: sum of weight times the vertices' varyings.
    void varyings(const Weights& weights, Varyings& out) const;

    /// The derivatives, at a sample, of the two varyings from `at` on.
    ///
    /// in   weights of that sample, on the screen and after perspective()
    [[nodiscard]] UvGradient uvGradient(const Weights& screen, const Weights& weights, std::size_t at) const;

    [[nodiscard]] const ScreenTriangle& triangle() const { return *m_triangle; }

private:
    const ScreenTriangle* m_triangle;
    double m_inverseArea2;
    DepthPlane m_depth;
    std::size_t m_varyingCount;
    bool m_perspectiveCorrect;
    bool m_depthLinear;
};

} // namespace rasterlens
