#include "core/render/line_samples.h"

#include "core/pipeline/observer.h"
#include "core/rasterizers/diamond_line.h"
#include "core/rasterizers/lines.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace rasterlens
{
namespace
{

/// The part of a line within the open diamond round the centre of a sample.
std::optional<MetDiamond> met(const glm::dvec2& from, const glm::dvec2& to, int column, int row)
{
    const glm::dvec2 start = from - (glm::dvec2(column, row) + 0.5);
    const glm::dvec2 way = to - from;
    MetDiamond diamond{column, row, 0, 1, false};
    for (const glm::dvec2& outwards : {glm::dvec2(1, 1), glm::dvec2(1, -1), glm::dvec2(-1, 1), glm::dvec2(-1, -1)}) {
        const double outside = glm::dot(outwards, start) - 0.5; // at the start; it grows by `speed` on the way
        const double speed = glm::dot(outwards, way);
        if (speed == 0 && outside >= 0)
            return std::nullopt;
        if (speed > 0)
            diamond.leaves = std::min(diamond.leaves, -outside / speed);
        if (speed < 0)
            diamond.enters = std::max(diamond.enters, -outside / speed);
    }
    if (diamond.enters >= diamond.leaves)
        return std::nullopt;
    return diamond;
}

} // namespace

std::vector<glm::ivec2> lineSamples(const glm::dvec2& from, const glm::dvec2& to, const Rules& rules)
{
    std::vector<glm::ivec2> samples;
    NullObserver nobody;
    const auto plot = [&](int x, int y, double) { samples.emplace_back(x, y); };
    drawLine(from, to, rules, plot, nobody);
    return samples;
}

std::vector<MetDiamond> diamondsOf(const glm::dvec2& from, const glm::dvec2& to, const PixelRect& part)
{
    std::map<std::pair<int, int>, double> drawn; // by row and column: where the line passes the centre's column, or row
    diamondExitLine(LinePoint::of(from), LinePoint::of(to), [&](int column, int row, double t) {
        if (column >= part.x && row >= part.y && column < part.x + part.width && row < part.y + part.height)
            drawn.emplace(std::pair(row, column), t);
    });
    // A line never leaves the box of its ends, nor do the samples that it draws by more than a border.
    const glm::dvec2 low = glm::floor(glm::min(from, to)) - 1.0;
    const glm::dvec2 high = glm::floor(glm::max(from, to)) + 1.0;
    const auto begin = [](double at, int first) { return static_cast<int>(std::max(at, double(first))); };
    const auto end = [](double at, int first, int size) {
        return static_cast<int>(std::min(at, double(first) + size - 1)) + 1;
    };
    std::vector<MetDiamond> diamonds;
    for (int row = begin(low.y, part.y); row < end(high.y, part.y, part.height); ++row)
        for (int column = begin(low.x, part.x); column < end(high.x, part.x, part.width); ++column) {
            std::optional<MetDiamond> diamond = met(from, to, column, row);
            const auto found = drawn.find({row, column});
            if (!diamond && found != drawn.end()) // it passes through the corner that belongs to the diamond
                diamond = MetDiamond{column, row, found->second, found->second, true};
            if (!diamond)
                continue;
            diamond->drawn = found != drawn.end();
            diamonds.push_back(*diamond);
        }
    return diamonds;
}

} // namespace rasterlens
