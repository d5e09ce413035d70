#pragma once
#include "app/cli/options.h"

#include <QPoint>
#include <QSize>

#include <cstdint>

namespace rasterlens::cli
{

/// The value of `--pixel x,y`, counted from the top left.
///
/// errors  throws Failure: not two whole numbers, or not a pixel of the picture
[[nodiscard]] std::optional<QPoint> pixelOption(const Arguments& arguments, QSize size);

/// A whole number of an option, minimum..maximum.
///
/// errors  throws Failure
[[nodiscard]] std::optional<std::int64_t> wholeOption(const Arguments& arguments, const QString& name,
                                                      std::int64_t minimum, std::int64_t maximum);

} // namespace rasterlens::cli
