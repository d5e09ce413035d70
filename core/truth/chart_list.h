#pragma once
#include "core/scene/scene.h"
#include "core/settings/settings.h"
#include "core/truth/chart.h"

#include <stop_token>

// What makes the charts of charts.cpp. A part of it, which alone includes this header.

namespace rasterlens
{

/// How many faces snapping turns over, takes the area of, or folds, for 0 to 8 subpixel bits.
///
/// exact  by the geometry of the exact reference
[[nodiscard]] Chart snappingChart(const Scene& scene, const Settings& settings, const std::stop_token& stop);

/// How far two surfaces have to be apart to be stored as different depths, over their distance, for each format.
[[nodiscard]] Chart depthStepChart(const Scene& scene, const Settings& settings, const std::stop_token& stop);

/// Which share of the samples edge functions in floating point get wrong, over the size of the coordinates, for several
/// ways to evaluate them.
///
/// exact  against 64-bit integers
[[nodiscard]] Chart edgeFunctionChart(const Scene& scene, const Settings& settings, const std::stop_token& stop);

/// Which share of a line's pixels each line rule has otherwise than the diamonds of the true line, over its angle.
[[nodiscard]] Chart lineChart(const Scene& scene, const Settings& settings, const std::stop_token& stop);

/// How wrong a colour is on a row of 256 pixels, over the ratio of the distances of its ends: affine, divided every 16
/// or 8 pixels, perspective in float32.
[[nodiscard]] Chart attributeChart(const Scene& scene, const Settings& settings, const std::stop_token& stop);

/// The errors of coverageChart().
[[nodiscard]] Chart samplesChart(const Scene& scene, const Settings& settings, const std::stop_token& stop);

/// The wrong pixels of distanceChart().
[[nodiscard]] Chart farChart(const Scene& scene, const Settings& settings, const std::stop_token& stop);

} // namespace rasterlens
