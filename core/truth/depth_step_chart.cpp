#include "core/pipeline/depth_test.h"
#include "core/scene/camera.h"
#include "core/truth/chart_list.h"

#include <QCoreApplication>

#include <cmath>
#include <limits>

namespace rasterlens
{
namespace
{

constexpr int kPlaces = 31;
constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// Depth 0..1 of a distance, as perspective squeezes it; reversed: 1..0.
struct Squeeze {
    double near;
    double far;
    bool reversed;

    [[nodiscard]] double depth(double distance) const
    {
        return reversed ? near / (far - near) * (far / distance - 1) : far / (far - near) * (1 - near / distance);
    }
};

/// The least distance beyond `from` at which another depth is stored; nothing up to far.
double nextChange(double from, const Squeeze& squeeze, DepthFormat format)
{
    const float stored = storedDepth(squeeze.depth(from), format);
    double same = from;
    double other = squeeze.far;
    if (storedDepth(squeeze.depth(other), format) == stored)
        return kNothing;
    constexpr int kHalvings = 60;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = (same + other) / 2;
        (storedDepth(squeeze.depth(middle), format) == stored ? same : other) = middle;
    }
    return other;
}

/// From one change of the stored depth to the next one.
double stepAt(double distance, const Squeeze& squeeze, DepthFormat format)
{
    const double first = nextChange(distance, squeeze, format);
    return first < squeeze.far ? nextChange(first, squeeze, format) - first : kNothing;
}

/// z' rises by (f n / (f - n)) / d^2 for a unit of distance, and by a code for every 1 / (2^bits - 1).
double stepByFormula(double distance, const Squeeze& squeeze, DepthFormat format)
{
    const double slope = squeeze.far * squeeze.near / (squeeze.far - squeeze.near) / (distance * distance);
    return 1 / slope / largestDepthCode(format);
}

} // namespace

Chart depthStepChart(const Scene& scene, const Settings& settings, const std::stop_token&)
{
    const Matrices matrices = cameraMatrices(scene, settings);
    const bool hasCamera = !matrices.orthographic && matrices.near > 0;
    const double near = hasCamera ? matrices.near : 0.1;
    const double far = hasCamera ? matrices.far : 100;
    Chart chart;
    chart.series = {{QT_TRANSLATE_NOOP("Chart", "float32"), {}},
                    {QT_TRANSLATE_NOOP("Chart", "float32, reversed"), {}},
                    {QT_TRANSLATE_NOOP("Chart", "unorm24"), {}},
                    {QT_TRANSLATE_NOOP("Chart", "unorm16"), {}},
                    {QT_TRANSLATE_NOOP("Chart", "unorm24 by d\u00b2 (f - n) / (f n) / 2^24"), {}, false},
                    {QT_TRANSLATE_NOOP("Chart", "unorm16 by d\u00b2 (f - n) / (f n) / 2^16"), {}, false}};
    const Squeeze forwards{near, far, false};
    const Squeeze backwards{near, far, true};
    for (int i = 0; i < kPlaces; ++i) {
        // not at the planes themselves, where a step would reach beyond them
        const double distance = near * std::pow(far / near, (i + 0.5) / kPlaces);
        chart.x.push_back(distance);
        chart.series[0].y.push_back(stepAt(distance, forwards, DepthFormat::Float32));
        chart.series[1].y.push_back(stepAt(distance, backwards, DepthFormat::Float32));
        chart.series[2].y.push_back(stepAt(distance, forwards, DepthFormat::Unorm24));
        chart.series[3].y.push_back(stepAt(distance, forwards, DepthFormat::Unorm16));
        chart.series[4].y.push_back(stepByFormula(distance, forwards, DepthFormat::Unorm24));
        chart.series[5].y.push_back(stepByFormula(distance, forwards, DepthFormat::Unorm16));
    }
    const auto text = [](double value) { return QString::number(value, 'g', 4); };
    chart.notes = {{hasCamera ? QT_TRANSLATE_NOOP("Chart", "Near and far of the camera: %1 and %2.")
                              : QT_TRANSLATE_NOOP("Chart", "No perspective camera here: near and far are %1 and %2."),
                    {text(near), text(far)}},
                   {QT_TRANSLATE_NOOP("Chart", "Where a curve ends, everything up to far is stored as one depth.")}};
    return chart;
}

} // namespace rasterlens
