#include "core/truth/chart_list.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <utility>

namespace rasterlens
{
namespace
{

// Coordinates here are in 1/256 pixel, as fixed point has them: floats below 2^16 pixels hold them exactly.
constexpr std::int64_t kUnit = 256;
constexpr int kRowsAnEdge = 40;
constexpr int kNear = 1; ///< pixels to each side of the edge that are tested

struct Point {
    std::int64_t x;
    std::int64_t y;
};

/// A line from A to B, and how each way of evaluation sees a sample.
struct Edge {
    Point a;
    Point b;

    [[nodiscard]] std::int64_t perX() const { return b.y - a.y; }
    [[nodiscard]] std::int64_t perY() const { return a.x - b.x; }
    [[nodiscard]] int exactSign(const Point& p) const
    {
        const std::int64_t e = perX() * (p.x - a.x) + perY() * (p.y - a.y);
        return (e > 0) - (e < 0);
    }
};

template <class T>
T pixels(std::int64_t value)
{
    return static_cast<T>(value) / static_cast<T>(kUnit);
}

template <class T>
int signOf(T value)
{
    return (value > 0) - (value < 0);
}

template <class T>
T direct(const Edge& edge, const Point& p)
{
    const T perX = pixels<T>(edge.b.y) - pixels<T>(edge.a.y);
    const T perY = pixels<T>(edge.a.x) - pixels<T>(edge.b.x);
    return perX * (pixels<T>(p.x) - pixels<T>(edge.a.x)) + perY * (pixels<T>(p.y) - pixels<T>(edge.a.y));
}

/// A sum, and what it lost so far.
///
/// source  Kahan, Further remarks on reducing truncation errors, CACM 8(1), 1965
struct Compensated {
    float sum = 0;
    float lost = 0;

    void add(float value)
    {
        const float wanted = value - lost;
        const float next = sum + wanted;
        lost = (next - sum) - wanted;
        sum = next;
    }
};

enum Way { Running, RunningKahan, Direct, Canonical, Double, kWays };

/// Counts the samples near the edge that come out with another sign than the exact one. The walk begins at the left
/// border of the picture, as that of a bounding box would.
class Counter
{
public:
    void walk(const Edge& edge, std::int64_t row)
    {
        const Point start{kUnit / 2, row * kUnit + kUnit / 2};
        if (edge.perX() == 0)
            return;
        const double crossing = static_cast<double>(edge.a.x) - static_cast<double>(start.y - edge.a.y) *
                                                                    static_cast<double>(edge.perY()) /
                                                                    static_cast<double>(edge.perX());
        const std::int64_t middle = static_cast<std::int64_t>(std::floor(crossing / kUnit));
        const float perX = pixels<float>(edge.perX());
        float running = direct<float>(edge, start);
        Compensated compensated{running, 0};
        Point p = start;
        const std::int64_t first = std::max<std::int64_t>(middle - kNear, 0);
        for (std::int64_t column = 0; column <= middle + kNear; ++column, p.x += kUnit) {
            if (column >= first) {
                ++m_tested;
                const int exact = edge.exactSign(p);
                count(Running, signOf(running), exact);
                count(RunningKahan, signOf(compensated.sum), exact);
                count(Direct, signOf(direct<float>(edge, p)), exact);
                count(Canonical, canonicalSign(edge, p), exact);
                count(Double, signOf(direct<double>(edge, p)), exact);
            }
            running += perX;
            compensated.add(perX);
        }
    }

    [[nodiscard]] double wrongInAMillion(Way way) const
    {
        return m_tested == 0 ? 0 : 1e6 * static_cast<double>(m_wrong[way]) / static_cast<double>(m_tested);
    }

private:
    /// Evaluated from the end with the smaller coordinates, whichever way the edge is walked.
    static int canonicalSign(const Edge& edge, const Point& p)
    {
        const bool turned = std::pair(edge.b.y, edge.b.x) < std::pair(edge.a.y, edge.a.x);
        const Edge held = turned ? Edge{edge.b, edge.a} : edge;
        return turned ? -signOf(direct<float>(held, p)) : signOf(direct<float>(held, p));
    }

    void count(Way way, int sign, int exact) { m_wrong[way] += sign != exact ? 1 : 0; }

    std::uint64_t m_tested = 0;
    std::array<std::uint64_t, kWays> m_wrong{};
};

} // namespace

Chart edgeFunctionChart(const Scene&, const Settings&, const std::stop_token& stop)
{
    constexpr int kEdges = 500;
    constexpr int kFirstPower = 4;
    constexpr int kLastPower = 14; // 16384, the largest viewport
    Chart chart;
    chart.series = {{QT_TRANSLATE_NOOP("Chart", "float32, added up"), {}},
                    {QT_TRANSLATE_NOOP("Chart", "float32, added up with compensation (Kahan)"), {}},
                    {QT_TRANSLATE_NOOP("Chart", "float32, anew at every sample"), {}},
                    {QT_TRANSLATE_NOOP("Chart", "float32, from the same end for both faces"), {}},
                    {QT_TRANSLATE_NOOP("Chart", "float64"), {}}};
    std::mt19937 random(1);
    for (int power = kFirstPower; power <= kLastPower && !stop.stop_requested(); ++power) {
        const std::int64_t size = std::int64_t{1} << power;
        Counter counter;
        for (int i = 0; i < kEdges && !stop.stop_requested(); ++i) {
            // every other edge runs between halves of pixels, and so exactly through the centres of many
            const std::int64_t step = i % 2 == 0 ? 1 : kUnit / 2;
            const auto place = [&] {
                return step * static_cast<std::int64_t>(random() % static_cast<std::uint64_t>(size * kUnit / step));
            };
            const Edge edge{{place(), place()}, {place(), place()}};
            const std::int64_t low = std::min(edge.a.y, edge.b.y) / kUnit;
            const std::int64_t rows = std::max(edge.a.y, edge.b.y) / kUnit - low + 1;
            const std::int64_t walked = std::min<std::int64_t>(rows, kRowsAnEdge);
            for (std::int64_t row = 0; row < walked; ++row)
                counter.walk(edge, low + row * rows / walked);
        }
        chart.x.push_back(static_cast<double>(size));
        for (int way = 0; way < kWays; ++way)
            chart.series[static_cast<std::size_t>(way)].y.push_back(counter.wrongInAMillion(static_cast<Way>(way)));
    }
    chart.notes = {
        {QT_TRANSLATE_NOOP("Chart", "%1 random edges a size, half of them between halves of pixels; samples within %2 "
                                    "pixels of them, in up to %3 rows "
                                    "each."),
         {kEdges, kNear, kRowsAnEdge}},
        {QT_TRANSLATE_NOOP("Chart", "From the same end for both faces the values are wrong as often, but the two "
                                    "faces at an edge never disagree.")}};
    return chart;
}

} // namespace rasterlens
