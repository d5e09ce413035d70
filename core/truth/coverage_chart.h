#pragma once
#include "core/scene/scene.h"
#include "core/settings/settings.h"

#include <QByteArray>

#include <cstdint>
#include <span>
#include <stop_token>
#include <vector>

namespace rasterlens
{

/// How well the samples of a pixel tell what part of it is covered: one row of the chart.
struct CoverageRow {
    Samples samples = Samples::One;
    std::uint64_t pixels = 0; ///< those that faces cover in part
    double rms = 0;           ///< of (covered samples / samples) - area, in pixels
    double mean = 0;          ///< of its absolute value
    double largest = 0;
};

/// The area of each pixel that the faces of a scene cover, row by row: the areas of all faces that are drawn, added up.
///
/// exact   to some units of 2^-52: corners as they are snapped, cut by pixels in double
[[nodiscard]] std::vector<double> coveredAreas(const Scene& scene, const Settings& settings);

/// The counts of covered samples against covered areas, for grids of 1 to 4 and patterns of 2 to 16 samples.
///
/// in      settings whose algorithm draws patterns; samples are those of the rows
/// errors  `stop` ends the work early
[[nodiscard]] std::vector<CoverageRow> coverageChart(const Scene& scene, const Settings& settings,
                                                     const std::stop_token& stop = {});

[[nodiscard]] QByteArray coverageCsv(std::span<const CoverageRow> rows);
[[nodiscard]] QByteArray coverageJson(std::span<const CoverageRow> rows);

} // namespace rasterlens
