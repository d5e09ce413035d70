#pragma once
#include "core/truth/charts.h"

#include <QByteArray>

namespace rasterlens::cli
{

/// A chart as a picture.
///
/// in  scene   the name of what it is about; empty where that does not matter
/// in  format  svg or png
[[nodiscard]] QByteArray chartFigure(const ChartInfo& info, const Chart& chart, const QString& scene,
                                     const QByteArray& format);

} // namespace rasterlens::cli
