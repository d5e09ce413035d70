#include "core/truth/perspective_curves.h"

#include <cmath>

namespace rasterlens
{
namespace
{

template <class Function>
std::vector<CurvePoint> curve(double from, double to, int points, Function&& function)
{
    std::vector<CurvePoint> curve;
    for (int i = 0; i < points; ++i) {
        const double x = std::lerp(from, to, double(i) / (points - 1));
        curve.push_back({x, function(x)});
    }
    return curve;
}

DepthGuess guess(double truth, double first, double last, double m, double n)
{
    const double linear = std::lerp(first, last, m);
    const double corrected = std::lerp(first, last, n);
    return {truth, linear, corrected, linear - truth, corrected - truth};
}

} // namespace

double spaceFraction(double m, double z1, double z2) { return m * z1 / ((1 - m) * z2 + m * z1); }

std::vector<CurvePoint> spaceFractionCurve(double z1, double z2, int points)
{
    return curve(0, 1, points, [&](double m) { return spaceFraction(m, z1, z2); });
}

double squeezedDepth(double z, double n, double f) { return n + f - n * f / z; }

std::vector<CurvePoint> squeezedDepthCurve(double n, double f, int points)
{
    return curve(n, f, points, [&](double z) { return squeezedDepth(z, n, f); });
}

double ndcDepth(double z, double n, double f) { return (f + n - 2 * f * n / z) / (f - n); }

FourZ fourZ(double n, double f, double z1, double z2, double m)
{
    // On the screen 1/z is linear.
    const double z = 1 / std::lerp(1 / z1, 1 / z2, m);
    const double fraction = spaceFraction(m, z1, z2);
    return {fraction, guess(ndcDepth(z, n, f), ndcDepth(z1, n, f), ndcDepth(z2, n, f), m, fraction),
            guess(z, z1, z2, m, fraction)};
}

} // namespace rasterlens
