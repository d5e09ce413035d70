#pragma once
#include "app/cli/input.h"
#include "core/truth/experiment.h"

#include <QString>

#include <span>

namespace rasterlens::cli
{

/// What `bench` prints of a scene: a line a row, and below them what the numbers mean and how far they can be trusted.
///
/// in  the rows of one scene, their frontier marked for the measure
[[nodiscard]] QString benchTable(std::span<const ExperimentRow> rows, const Input& input, ErrorMeasure measure);

} // namespace rasterlens::cli
