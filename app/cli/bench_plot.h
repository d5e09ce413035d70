#pragma once
#include "core/truth/experiment.h"

#include <QByteArray>

namespace rasterlens::cli
{

/// Speed against error as a figure: a panel a scene, a dot a variant, bars from p10 to p90, the frontier as a line.
/// Both axes are logarithmic; dots without any error stand left of a gap, at 0. Dots on the frontier are labelled.
///
/// in      rows with marked frontier; `format` is "svg" or "png"
/// out     the file; text is in the font of the system, sizes in pixels
[[nodiscard]] QByteArray experimentFigure(std::span<const ExperimentRow> rows, ErrorMeasure measure,
                                          const QString& format);

} // namespace rasterlens::cli
