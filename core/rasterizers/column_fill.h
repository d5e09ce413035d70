#pragma once
#include "core/pipeline/interpolation.h"
#include "core/pipeline/observer.h"
#include "core/pipeline/stopping.h"
#include "core/rasterizers/lines.h"
#include "core/rasterizers/registry.h"

#include <algorithm>
#include <array>

namespace rasterlens
{

/// Notes for each column of samples the rows in which the three edges cross it, and fills from the least to the
/// greatest.
///
/// The outline belongs to the triangle, so this is no coverage by centres: two triangles hit the samples of an edge
/// that they share twice. Samples outside of the triangle are given the attributes of its border. A vertical edge has
/// both of its ends in its column.
struct ColumnFill {
    static constexpr RasterizerInfo info{Algorithm::ColumnFill,
                                         "a first attempt without a rule for pixel centres, as in courses"};

    [[nodiscard]] static std::optional<Reason> supports(const Rules&) { return std::nullopt; }

    /// Calls emit(x, y, weights) for every sample on the target, column by column from the left, each from above.
    template <class Emit, class Observer>
    static void cover(const ScreenTriangle& triangle, const Rules& rules, Emit& emit, Observer& observer)
    {
        std::array<GridPoint, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = sampleOf(triangle.vertices[i].position);
        std::array<ColumnWalker, 3> edges{ColumnWalker(corners[0], corners[1]), ColumnWalker(corners[1], corners[2]),
                                          ColumnWalker(corners[2], corners[0])};
        const auto [first, last] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
        for (int x = first; x <= std::min(last, rules.columns() - 1) && !isStopped(emit); ++x) {
            if (x >= 0 && !skipsLine(emit, x))
                fillColumn(columnOf(x, edges), triangle, rules, emit, observer);
            for (ColumnWalker& edge : edges)
                if (edge.holds(x) && !edge.isVertical())
                    edge.step();
        }
    }

private:
    static FilledColumn columnOf(int x, const std::array<ColumnWalker, 3>& edges)
    {
        FilledColumn column;
        column.x = x;
        const auto note = [&](int row) { column.rows[static_cast<std::size_t>(column.count++)] = row; };
        for (const ColumnWalker& edge : edges) {
            if (!edge.holds(x))
                continue;
            note(edge.row());
            if (edge.isVertical())
                note(edge.right().y);
        }
        return column;
    }

    template <class Emit, class Observer>
    static void fillColumn(const FilledColumn& column, const ScreenTriangle& triangle, const Rules& rules, Emit& emit,
                           Observer& observer)
    {
        observer.onColumn(column);
        const int first = std::max(column.first(), 0);
        const int last = std::min(column.last(), rules.rows() - 1);
        for (int y = first; y <= last; ++y)
            emit(column.x, y, weightsWithin(triangle, {column.x + 0.5, y + 0.5}));
    }

    /// The barycentric weights of a point or, where the point is outside, of a point of the border near it.
    static Weights weightsWithin(const ScreenTriangle& triangle, const glm::dvec2& point)
    {
        const auto& [a, b, c] = triangle.vertices;
        Weights weights{twiceArea(b.position, c.position, point), twiceArea(c.position, a.position, point),
                        twiceArea(a.position, b.position, point)};
        const double sign = triangle.area2 < 0 ? -1 : 1;
        double sum = 0;
        for (double& weight : weights) {
            weight = std::max(sign * weight, 0.0);
            sum += weight;
        }
        if (!(sum > 0))
            return {1, 0, 0};
        for (double& weight : weights)
            weight /= sum;
        return weights;
    }
};

} // namespace rasterlens
