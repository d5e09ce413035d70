#pragma once
#include <QPoint>

#include <cstdint>
#include <optional>

namespace rasterlens
{

/// Where a derivation takes its numbers from. What a topic does not need it does not read.
struct DerivationPlace {
    std::uint32_t face = 0;
    std::optional<QPoint> pixel; ///< pixels from the top left; empty: one inside the face is chosen
    std::optional<int> edge;     ///< from corner 0, 1, 2 to the one after it: AB, BC, CA; empty: the topic's own choice
    double m = 0.5;              ///< perspective, depth-curve: part of the way along the edge, 0 < m < 1
    std::optional<double> depth; ///< depth-curve: a distance of its own choice; empty: half-way from near to far
};

} // namespace rasterlens
