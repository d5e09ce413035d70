#include "core/truth/edge_distance.h"

#include <algorithm>
#include <cmath>

namespace rasterlens
{

namespace
{

double distanceToSegment(glm::dvec2 p, glm::dvec2 a, glm::dvec2 b)
{
    const glm::dvec2 along = b - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0;
    return glm::length(p - a - t * along);
}

/// Samples of one axis that may lie in low..high (pixels of the viewport), cut to the window.
struct Range {
    int begin;
    int end;
};

Range samplesBetween(double low, double high, int windowStart, int count, int grid)
{
    const auto index = [&](double pixels) { return (pixels - windowStart) * grid; };
    return {static_cast<int>(std::clamp(std::floor(index(low)), 0.0, static_cast<double>(count))),
            static_cast<int>(std::clamp(std::ceil(index(high)) + 1, 0.0, static_cast<double>(count)))};
}

} // namespace

void lowerEdgeDistance(ExactFrame& frame, glm::dvec2 a, glm::dvec2 b)
{
    if (a.y > b.y)
        std::swap(a, b);
    const double slope = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0;
    a -= frame.offset; // as if the samples lay at their centres
    b -= frame.offset;
    const auto center = [&](int sample, int start) { return start + (sample + 0.5) / frame.sampleGrid; };
    const Range rows =
        samplesBetween(a.y - kEdgeBandPixels, b.y + kEdgeBandPixels, frame.window.y, frame.height, frame.sampleGrid);
    for (int row = rows.begin; row < rows.end; ++row) {
        const double y = center(row, frame.window.y);
        // the stretch of the segment within the band above and below this row
        double left = a.x;
        double right = b.x;
        if (b.y > a.y) {
            left = a.x + slope * (std::clamp(y - kEdgeBandPixels, a.y, b.y) - a.y);
            right = a.x + slope * (std::clamp(y + kEdgeBandPixels, a.y, b.y) - a.y);
        }
        const Range columns =
            samplesBetween(std::min(left, right) - kEdgeBandPixels, std::max(left, right) + kEdgeBandPixels,
                           frame.window.x, frame.width, frame.sampleGrid);
        for (int column = columns.begin; column < columns.end; ++column) {
            const double distance = distanceToSegment({center(column, frame.window.x), y}, a, b);
            float& stored = frame.edgeDistance[static_cast<std::size_t>(row) * static_cast<std::size_t>(frame.width) +
                                               static_cast<std::size_t>(column)];
            stored = std::min(stored, static_cast<float>(distance));
        }
    }
}

} // namespace rasterlens
