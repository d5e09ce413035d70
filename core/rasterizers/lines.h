#pragma once
#include "core/pipeline/line_places.h"
#include "core/pipeline/observer.h"
#include "core/pipeline/types.h"
#include "core/rasterizers/diamond_line.h"
#include "core/settings/rules.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <utility>

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

/// Draws a line by adding the slope in floating point and rounding, both ends included. The observer is told every
/// position before its sample is plotted.
///
/// source  digital differential analyzer: Foley & van Dam, Computer Graphics, section 3.2.1
template <class Plot, class Observer>
void ddaLine(GridPoint from, GridPoint to, Plot&& plot, Observer& observer)
{
    const int steps = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
    const double perStepX = steps > 0 ? double(to.x - from.x) / steps : 0;
    const double perStepY = steps > 0 ? double(to.y - from.y) / steps : 0;
    double x = from.x;
    double y = from.y;
    for (int i = 0; i <= steps; ++i, x += perStepX, y += perStepY) {
        const auto column = static_cast<int>(std::lround(x));
        const auto row = static_cast<int>(std::lround(y));
        observer.onLinePosition({i, steps, x, y, perStepX, perStepY, column, row});
        plot(column, row, steps > 0 ? double(i) / steps : 0.0);
    }
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

/// The rows by which an edge moves on before the next column, and the error that is left.
struct ColumnStep {
    std::int64_t rows;
    std::int64_t error; ///< in units of 1 / (2 dx) of a row
};

/// One row a column: `rows = error / dx; error -= 2 dx rows`. The error counts in halves of dx, so the steps of a line
/// steeper than 45 degrees are twice as long as they should be, and every other one is missing: 6, 0, 6, 0 for 3, 3,
/// 3, 3.
///
/// in   dx > 0
[[nodiscard]] constexpr ColumnStep columnStep(std::int64_t error, std::int64_t dx)
{
    if (error < dx)
        return {0, error};
    const std::int64_t rows = error / dx;
    return {rows, error - 2 * dx * rows};
}

/// Follows a line column by column from its left end to its right end, and knows one row of each column.
class ColumnWalker
{
public:
    ColumnWalker(GridPoint from, GridPoint to)
        : m_left(from.x <= to.x ? from : to), m_right(from.x <= to.x ? to : from), m_row(m_left.y)
    {
    }

    [[nodiscard]] GridPoint left() const { return m_left; }
    [[nodiscard]] GridPoint right() const { return m_right; }
    [[nodiscard]] bool isVertical() const { return m_left.x == m_right.x; }
    [[nodiscard]] bool holds(int x) const { return x >= m_left.x && x <= m_right.x; }
    [[nodiscard]] int row() const { return static_cast<int>(m_row); }

    /// From one column of the line to the next.
    void step()
    {
        const std::int64_t dy = std::int64_t(m_right.y) - m_left.y;
        const ColumnStep next = columnStep(m_error + 2 * std::abs(dy), std::int64_t(m_right.x) - m_left.x);
        m_row += dy > 0 ? next.rows : -next.rows;
        m_error = next.error;
    }

private:
    GridPoint m_left;
    GridPoint m_right;
    std::int64_t m_row;
    std::int64_t m_error = 0;
};

/// The line with one sample a column, whatever its slope: steep lines are full of holes. A vertical line, where error /
/// dx divides by zero, loses all samples but one.
template <class Plot>
void oneRowLine(GridPoint from, GridPoint to, Plot&& plot)
{
    ColumnWalker line(from, to);
    const int columns = std::abs(to.x - from.x);
    for (int x = line.left().x; x <= line.right().x; ++x) {
        plot(x, line.row(), columns > 0 ? double(std::abs(x - from.x)) / columns : 0.0);
        if (columns > 0)
            line.step();
    }
}

/// Draws the line from the centre of one sample to that of another, ends included.
template <class Plot, class Observer>
void centreLine(GridPoint from, GridPoint to, const Rules& rules, Plot&& plot, Observer& observer)
{
    if (rules.line == LineAlgorithm::Bresenham)
        bresenhamLine(from, to, plot, observer);
    else
        ddaLine(from, to, plot, observer);
}

/// Draws a line by the rules: plot(x, y, t) for each of its samples, also off the target.
template <class Plot, class Observer>
void drawLine(const glm::dvec2& start, const glm::dvec2& end, const Rules& rules, Plot&& plot, Observer& observer)
{
    const GridPoint from = sampleOf(start);
    const GridPoint to = sampleOf(end);
    if ((rules.lineOctants >> octantOf(from, to) & 1U) == 0)
        return;
    if (rules.lineAdvance == LineAdvance::Columns)
        return columnLine(from, to, plot);
    if (rules.lineAdvance == LineAdvance::OneRow)
        return oneRowLine(from, to, plot);
    if (rules.lineRule == LineRule::DiamondExit)
        return diamondExitLine(LinePoint::of(start), LinePoint::of(end), plot);
    const auto plotWanted = [&](int x, int y, double t) {
        if (rules.lineRule == LineRule::Inclusive || x != to.x || y != to.y)
            plot(x, y, t);
    };
    const bool isBackward = std::pair(from.y, from.x) > std::pair(to.y, to.x);
    if (!rules.lineTiesByDirection && isBackward)
        return centreLine(
            to, from, rules, [&](int x, int y, double t) { plotWanted(x, y, 1 - t); }, observer);
    centreLine(from, to, rules, plotWanted, observer);
}

/// Draws the edges of a triangle that no other face draws: emit(x, y, weights) for every sample, also off the target.
template <class Emit, class Observer>
void drawWireframe(const ScreenTriangle& triangle, const Rules& rules, Emit& emit, Observer& observer)
{
    for (std::size_t i = 0; i < 3; ++i) {
        if (!triangle.drawsEdge(i))
            continue;
        const std::size_t j = (i + 1) % 3;
        const glm::dvec2& start = triangle.vertices[i].position;
        const glm::dvec2& end = triangle.vertices[j].position;
        const GridPoint rightEnd = sampleOf(sampleOf(start).x > sampleOf(end).x ? start : end);
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
        drawLine(start, end, rules, plot, observer);
    }
}

/// Draws the three corners of a triangle.
template <class Emit, class Observer>
void drawPoints(const ScreenTriangle& triangle, const Rules& rules, Emit& emit, Observer&)
{
    for (std::size_t i = 0; i < 3; ++i) {
        Weights weights{0, 0, 0};
        weights[i] = 1;
        const GridPoint p = sampleOf(triangle.vertices[i].position, rules.gridRounding);
        emit(p.x, p.y, weights);
    }
}

} // namespace rasterlens
