#pragma once
#include "app/cli/input.h"
#include "app/cli/options.h"

namespace rasterlens::cli
{

/// Prints how far pictures are from the truth as their scene is moved away from 0; or writes it as CSV, JSON, a figure.
///
/// in      the options --csv, --json and --plot of `bench`
/// errors  throws Failure: a scene without a camera, an output that cannot be written
void printDistanceChart(const Input& input, const Arguments& arguments);

} // namespace rasterlens::cli
