#include "core/base/grouped.h"
#include "core/truth/chart_list.h"
#include "core/truth/coverage_chart.h"
#include "core/truth/distance_chart.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <limits>

namespace rasterlens
{

Chart samplesChart(const Scene& scene, const Settings& settings, const std::stop_token& stop)
{
    constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
    Chart chart;
    chart.series = {{QT_TRANSLATE_NOOP("Chart", "grids"), {}}, {QT_TRANSLATE_NOOP("Chart", "patterns of MSAA"), {}}};
    std::vector<CoverageRow> rows = coverageChart(scene, settings, stop);
    std::ranges::stable_sort(rows, {}, [](const CoverageRow& row) { return samplesPerPixel(row.samples); });
    for (const CoverageRow& row : rows) {
        const double samples = samplesPerPixel(row.samples);
        if (chart.x.empty() || chart.x.back() != samples) {
            chart.x.push_back(samples);
            for (ChartSeries& series : chart.series)
                series.y.push_back(kNothing);
        }
        chart.series[patternSamples(row.samples) > 1 ? 1 : 0].y.back() = row.rms;
    }
    if (!rows.empty())
        chart.notes = {{QT_TRANSLATE_NOOP("Chart", "%1 pixels are covered in part."), {grouped(rows.front().pixels)}}};
    return chart;
}

Chart farChart(const Scene& scene, const Settings& settings, const std::stop_token& stop)
{
    constexpr std::array kLog2Sides = {0, 4, 8, 12, 16, 20, 24, 32};
    Chart chart;
    chart.series = {{QT_TRANSLATE_NOOP("Chart", "as files are read, from an origin of the mesh"), {}},
                    {QT_TRANSLATE_NOOP("Chart", "float32 from 0"), {}}};
    for (const int log2 : kLog2Sides) {
        if (stop.stop_requested())
            break;
        const DistanceRow row = distanceChart(scene, settings, std::array{log2}).front();
        chart.x.push_back(row.units);
        chart.series[0].y.push_back(static_cast<double>(row.recentred.wrong));
        chart.series[1].y.push_back(static_cast<double>(row.float32.wrong));
    }
    return chart;
}

} // namespace rasterlens
