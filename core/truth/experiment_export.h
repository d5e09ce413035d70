#pragma once
#include "core/truth/experiment.h"

#include <QByteArray>

namespace rasterlens
{

/// The rows as a JSON array: `scene`, `variant`, `settings`, `threads`, `simd`, `ms`, `ns_per_covered_pixel`,
/// `mtri_per_s`, `error` and `frontier`. What was not measured is null; the PSNR of equal pictures, for which JSON has
/// no number, is kInfinitePsnr.
[[nodiscard]] QByteArray experimentJson(std::span<const ExperimentRow> rows);

/// The rows as CSV: a line of names, then a line a row, with the columns of experimentJson(); names of nested values
/// are joined by `_`. What was not measured is empty.
[[nodiscard]] QByteArray experimentCsv(std::span<const ExperimentRow> rows);

constexpr double kInfinitePsnr = 999;

} // namespace rasterlens
