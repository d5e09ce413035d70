#pragma once
#include "core/scene/scene.h"
#include "core/settings/settings.h"

#include <QByteArray>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace rasterlens
{

/// How far a picture of a model far from 0 is from the true one.
struct DistanceError {
    double corner = 0; ///< largest distance of a corner from its true place on the screen, pixels, before snapping
    std::uint64_t wrong = 0; ///< pixels: missing, extra, hit too often or too seldom, of another face
};

/// One row of the chart: the model at one distance from 0.
struct DistanceRow {
    double units = 0;          ///< from 0 to the box's centre, in the units of the scene
    double relativeSize = 0;   ///< the box's longest side over that
    std::uint64_t covered = 0; ///< pixels, in truth
    DistanceError recentred;   ///< as loaders hold it: positions told from an origin of its own (origin.h)
    DistanceError float32;     ///< as float32 coordinates hold it: positions told from 0
};

/// Moves a scene away from 0, in doubles, and draws it both ways under the same camera.
///
/// in      a scene in object space; how far each row moves it: 2^n of its box's longest sides along x, -y and z each
/// out     one row a distance, in order; `progress` is told how many are done
/// exact   wrong pixels against the exact reference from object space, which here starts from the positions in double
/// cost    two pictures and an exact one a row
[[nodiscard]] std::vector<DistanceRow> distanceChart(const Scene& scene, const Settings& settings,
                                                     std::span<const int> log2Sides,
                                                     const std::function<void(std::size_t done)>& progress = {});

/// An array of `{"distance", "relative_size", "covered", "recentred": {"corner_px", "wrong_pixels"}, "float32": {..}}`.
[[nodiscard]] QByteArray distanceJson(std::span<const DistanceRow> rows);
/// The rows as CSV, with the columns of distanceJson(); names of nested values are joined by `_`.
[[nodiscard]] QByteArray distanceCsv(std::span<const DistanceRow> rows);

} // namespace rasterlens
