#pragma once
#include "core/base/reason.h"

#include <vector>

namespace rasterlens
{

/// One line of a chart: a value for each x; NaN: none there.
struct ChartSeries {
    const char* name;
    std::vector<double> y;
    bool measured = true; ///< false: a formula, to compare with
};

struct Chart {
    std::vector<double> x;
    std::vector<ChartSeries> series;
    std::vector<Reason> notes; ///< what was drawn, and what to see
};

} // namespace rasterlens
