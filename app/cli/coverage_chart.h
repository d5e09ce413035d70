#pragma once
#include "app/cli/input.h"
#include "app/cli/options.h"

namespace rasterlens::cli
{

/// Prints how well the samples of a pixel tell what part of it is covered; or writes it as CSV, JSON, a figure.
///
/// in      the options --csv, --json and --plot of `bench`
/// errors  throws Failure: an algorithm that draws no patterns, an output that cannot be written
void printCoverageChart(const Input& input, const Arguments& arguments);

} // namespace rasterlens::cli
