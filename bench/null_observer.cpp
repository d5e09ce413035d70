// What the null observer costs: the edge-equation rasterizer as it is, beside the same loop written without observers.
// Count the instructions of the two functions (docs/PIPELINE.md says how); the program itself prints what they covered.
#include "core/rasterizers/edge_equation.h"

#include <cstdio>
#include <random>
#include <vector>

using namespace rasterlens;
using Fixed = std::int64_t;

namespace
{

/// As little as a covered sample can do.
struct Sum {
    std::uint64_t samples = 0;
    std::uint64_t places = 0;
    void operator()(int x, int y, const std::array<Fixed, 3>& /*edges*/ = {})
    {
        ++samples;
        places += static_cast<std::uint64_t>(x + 7 * y);
    }
};

/// The loop of the textbook, with the same setup.
void coverByHand(const TriangleSetup<Fixed>& setup, Sum& emit)
{
    const PixelRect& box = setup.bounds;
    const auto& edges = setup.edges;
    std::array<Fixed, 3> row;
    std::array<Fixed, 3> perColumn;
    std::array<Fixed, 3> perRow;
    for (std::size_t i = 0; i < 3; ++i) {
        row[i] = edges[i].at(TriangleSetup<Fixed>::centre(box.x, box.y));
        perColumn[i] = edges[i].a * Grid<Fixed>::kUnit;
        perRow[i] = edges[i].b * Grid<Fixed>::kUnit;
    }
    for (int y = box.y; y < box.y + box.height; ++y) {
        std::array<Fixed, 3> e = row;
        for (int x = box.x; x < box.x + box.width; ++x) {
            if (e[0] >= edges[0].threshold && e[1] >= edges[1].threshold && e[2] >= edges[2].threshold)
                emit(x, y, e);
            for (std::size_t i = 0; i < 3; ++i)
                e[i] += perColumn[i];
        }
        for (std::size_t i = 0; i < 3; ++i)
            row[i] += perRow[i];
    }
}

std::vector<ScreenTriangle> randomTriangles(const Rules& rules)
{
    std::mt19937 random(1);
    std::uniform_int_distribution<int> place(0, rules.width * 256);
    std::vector<ScreenTriangle> triangles(300);
    for (ScreenTriangle& triangle : triangles)
        for (ScreenVertex& v : triangle.vertices)
            v = {glm::dvec2(place(random), place(random)) / 256.0, 0.5, 1, {}};
    return triangles;
}

} // namespace

extern "C" [[gnu::noinline]] void loopWithNullObserver(const TriangleSetup<Fixed>& setup,
                                                       const ScreenTriangle& triangle, const Rules& rules, Sum& sum)
{
    NullObserver observer;
    EdgeEquation::cover(setup, triangle, rules, sum, observer);
}

extern "C" [[gnu::noinline]] void loopByHand(const TriangleSetup<Fixed>& setup, Sum& sum) { coverByHand(setup, sum); }

int main()
{
    Rules rules;
    rules.width = rules.height = 256;
    Sum withObserver;
    Sum byHand;
    for (const ScreenTriangle& triangle : randomTriangles(rules)) {
        const auto setup = setupTriangle<Fixed>(triangle, rules);
        if (!setup)
            continue;
        loopWithNullObserver(*setup, triangle, rules, withObserver);
        loopByHand(*setup, byHand);
    }
    std::printf("covered %llu samples, by hand %llu\n", static_cast<unsigned long long>(withObserver.samples),
                static_cast<unsigned long long>(byHand.samples));
    return withObserver.samples == byHand.samples && withObserver.places == byHand.places ? 0 : 1;
}
