#pragma once
#include "app/cli/input.h"
#include "app/cli/options.h"
#include "core/truth/charts.h"

namespace rasterlens::cli
{

/// Makes a chart of `bench --chart` and prints its table, or writes what --csv, --json and --plot ask for.
void printChart(const ChartInfo& info, const Input& input, const Arguments& arguments);

} // namespace rasterlens::cli
