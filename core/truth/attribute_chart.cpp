#include "core/truth/chart_list.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr int kPixels = 256;

/// The attribute at a fraction m of the row, 0 at the near end and 1 at the far one, `ratio` times as far.
///
/// source  1/w and u/w are linear on the screen: Blinn, Hyperbolic interpolation, IEEE CG&A 12(4), 1992
template <class T>
T divided(T m, T ratio)
{
    const T inverse = (1 - m) + m / ratio; // 1/w, the near end has w = 1
    return (m / ratio) / inverse;
}

/// Divided every `step` pixels, and straight in between.
double piecewise(int pixel, int step, double ratio)
{
    const double m = (pixel + 0.5) / kPixels;
    const double low = std::floor(m * kPixels / step) * step / kPixels;
    const double high = std::min(1.0, low + static_cast<double>(step) / kPixels);
    const double t = (m - low) / (high - low);
    return (1 - t) * divided(low, ratio) + t * divided(high, ratio);
}

} // namespace

Chart attributeChart(const Scene&, const Settings&, const std::stop_token&)
{
    Chart chart;
    chart.series = {{QT_TRANSLATE_NOOP("Chart", "affine"), {}},
                    {QT_TRANSLATE_NOOP("Chart", "divided every 16 pixels"), {}},
                    {QT_TRANSLATE_NOOP("Chart", "divided every 8 pixels"), {}},
                    {QT_TRANSLATE_NOOP("Chart", "perspective, float32"), {}}};
    for (const double ratio : {1.0, 1.25, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0, 48.0, 64.0}) {
        std::array<double, 4> worst{};
        for (int pixel = 0; pixel < kPixels; ++pixel) {
            const double m = (pixel + 0.5) / kPixels;
            const double truth = divided(m, ratio);
            const std::array<double, 4> found{
                m, piecewise(pixel, 16, ratio), piecewise(pixel, 8, ratio),
                static_cast<double>(divided(static_cast<float>(m), static_cast<float>(ratio)))};
            for (std::size_t k = 0; k < found.size(); ++k)
                worst[k] = std::max(worst[k], 255 * std::abs(found[k] - truth));
        }
        chart.x.push_back(ratio);
        for (std::size_t k = 0; k < worst.size(); ++k)
            chart.series[k].y.push_back(worst[k]);
    }
    chart.notes = {
        {QT_TRANSLATE_NOOP("Chart", "A division a pixel, one every 16 or 8, or none: 256, 17, 33 and 0 on this "
                                    "row.")},
        {QT_TRANSLATE_NOOP("Chart", "Half a step is what a picture of 8 bits can show.")}};
    return chart;
}

} // namespace rasterlens
