#pragma once
#include "core/pipeline/line_places.h"
#include "core/pipeline/observer.h"
#include "core/pipeline/types.h"
#include "core/settings/rules.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace rasterlens
{

/// Calls plot(x, y, t) for every sample of the line, both ends included; t is the fraction of the way, 0..1.
/// The observer is told every decision.
///
/// covers  all octants: a step along the longer axis always, along the shorter one when the decision variable says
///         that the upper candidate is nearer, p = 2 dy - dx to begin with
/// exact   integers only
/// source  Bresenham, IBM Systems Journal 4(1), 1965
template <class Plot, class Observer>
void bresenhamLine(GridPoint from, GridPoint to, Plot&& plot, Observer& observer)
{
    const int stepX = to.x < from.x ? -1 : 1;
    const int stepY = to.y < from.y ? -1 : 1;
    const int dx = std::abs(to.x - from.x);
    const int dy = std::abs(to.y - from.y);
    const bool steep = dy > dx;
    const int longer = std::max(dx, dy);
    const int shorter = std::min(dx, dy);
    int decision = 2 * shorter - longer;
    GridPoint p = from;
    for (int i = 0; i <= longer; ++i) {
        plot(p.x, p.y, longer > 0 ? double(i) / longer : 0.0);
        const bool sideways = decision > 0;
        if (i < longer)
            observer.onLineDecision({i, p.x, p.y, decision, longer, shorter, steep, sideways});
        if (sideways) {
            (steep ? p.x : p.y) += steep ? stepX : stepY;
            decision -= 2 * longer;
        }
        (steep ? p.y : p.x) += steep ? stepY : stepX;
        decision += 2 * shorter;
    }
}

/// Draws a line by adding the slope in floating point and rounding, both ends included.
///
/// source  digital differential analyzer: Foley & van Dam, Computer Graphics, section 3.2.1
template <class Plot>
void ddaLine(GridPoint from, GridPoint to, Plot&& plot)
{
    const int steps = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    const double perStepX = steps > 0 ? double(to.x - from.x) / steps : 0;
    const double perStepY = steps > 0 ? double(to.y - from.y) / steps : 0;
    double x = from.x;
    double y = from.y;
    for (int i = 0; i <= steps; ++i, x += perStepX, y += perStepY)
        plot(static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)), steps > 0 ? double(i) / steps : 0.0);
}

/// The line column by column, dy/dx rows in each, the last column included: it runs past its end, the farther the
/// steeper it is. A vertical line, where dy/dx divides by zero, loses all samples but the first.
template <class Plot>
void columnLine(GridPoint from, GridPoint to, Plot&& plot)
{
    const int stepX = to.x < from.x ? -1 : 1;
    const int stepY = to.y < from.y ? -1 : 1;
    const int columns = std::abs(to.x - from.x);
    plot(from.x, from.y, 0.0);
    if (columns == 0)
        return;
    const double perColumn = double(std::abs(to.y - from.y)) / columns;
    double error = 0;
    int y = from.y;
    for (int i = 0; i <= columns; ++i) {
        const int x = from.x + i * stepX;
        const double t = double(i) / columns;
        plot(x, y, t);
        for (error += perColumn; error > 0.5; error -= 1) {
            y += stepY;
            plot(x, y, t);
        }
    }
}

/// Draws the three edges of a triangle: emit(x, y, weights) for every sample, also off the target.
template <class Emit, class Observer>
void drawWireframe(const ScreenTriangle& triangle, const Rules& rules, Emit& emit, Observer& observer)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t j = (i + 1) % 3;
        const GridPoint from = sampleOf(triangle.vertices[i].position);
        const GridPoint to = sampleOf(triangle.vertices[j].position);
        const GridPoint rightEnd = from.x > to.x ? from : to;
        const auto plot = [&](int x, int y, double t) {
            if (!rules.rightLineEnds && x == rightEnd.x && y == rightEnd.y)
                return;
            if (rules.integerLineWeights)
                t = std::floor(t);
            Weights weights{0, 0, 0};
            weights[i] = 1 - t;
            weights[j] = t;
            emit(x, y, weights);
        };
        if ((rules.lineOctants >> octantOf(from, to) & 1U) == 0)
            continue;
        if (rules.lineAdvance == LineAdvance::Columns)
            columnLine(from, to, plot);
        else if (rules.line == LineAlgorithm::Bresenham)
            bresenhamLine(from, to, plot, observer);
        else
            ddaLine(from, to, plot);
    }
}

/// Draws the three corners of a triangle.
template <class Emit, class Observer>
void drawPoints(const ScreenTriangle& triangle, const Rules&, Emit& emit, Observer&)
{
    for (std::size_t i = 0; i < 3; ++i) {
        Weights weights{0, 0, 0};
        weights[i] = 1;
        const GridPoint p = sampleOf(triangle.vertices[i].position);
        emit(p.x, p.y, weights);
    }
}

} // namespace rasterlens
