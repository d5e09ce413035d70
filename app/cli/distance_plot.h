#pragma once
#include "core/truth/distance_chart.h"

#include <QByteArray>
#include <QString>

namespace rasterlens::cli
{

/// How far corners lie from their true places, against the distance from 0 in sizes of the model: both ways of holding
/// positions, and a step of snapping as a line. Both axes are logarithmic.
///
/// in      `stepPixels` of the snapping; `format` is "svg" or "png"
[[nodiscard]] QByteArray distanceFigure(std::span<const DistanceRow> rows, const QString& scene, double stepPixels,
                                        const QByteArray& format);

} // namespace rasterlens::cli
