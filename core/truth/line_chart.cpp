#include "core/render/line_samples.h"
#include "core/truth/chart_list.h"
#include "core/truth/exact_line.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace rasterlens
{
namespace
{

constexpr int kBin = 5; ///< degrees
constexpr int kBins = 90 / kBin + 1;
constexpr int kLines = 400;      ///< an angle
constexpr double kLength = 40.3; ///< pixels

struct RuleOfLines {
    const char* name;
    LineRule rule;
    LineAlgorithm algorithm;
};
constexpr RuleOfLines kRules[] = {
    {QT_TRANSLATE_NOOP("Chart", "both ends, Bresenham"), LineRule::Inclusive, LineAlgorithm::Bresenham},
    {QT_TRANSLATE_NOOP("Chart", "both ends, DDA"), LineRule::Inclusive, LineAlgorithm::Dda},
    {QT_TRANSLATE_NOOP("Chart", "without the last, Bresenham"), LineRule::HalfOpen, LineAlgorithm::Bresenham},
    {QT_TRANSLATE_NOOP("Chart", "diamond exit"), LineRule::DiamondExit, LineAlgorithm::Bresenham}};

bool isLess(const glm::ivec2& a, const glm::ivec2& b) { return std::pair(a.y, a.x) < std::pair(b.y, b.x); }

/// How many samples are in one of two sets only.
std::size_t differing(std::vector<glm::ivec2> a, std::vector<glm::ivec2> b)
{
    std::vector<glm::ivec2> different;
    for (std::vector<glm::ivec2>* samples : {&a, &b})
        std::ranges::sort(*samples, isLess);
    std::ranges::set_symmetric_difference(a, b, std::back_inserter(different), isLess);
    return different.size();
}

} // namespace

Chart lineChart(const Scene&, const Settings&, const std::stop_token& stop)
{
    Chart chart;
    for (const RuleOfLines& rule : kRules)
        chart.series.push_back({rule.name, {}});
    std::mt19937 random(1);
    for (int bin = 0; bin < kBins && !stop.stop_requested(); ++bin) {
        std::vector<std::size_t> wrong(std::size(kRules), 0);
        std::size_t pixels = 0;
        for (int i = 0; i < kLines && !stop.stop_requested(); ++i) {
            const double angle = bin * kBin * std::numbers::pi / 180;
            const glm::i64vec2 from(random() % 4096, random() % 4096); // 1/256 pixel
            const glm::i64vec2 to = from + glm::i64vec2(std::llround(256 * kLength * std::cos(angle)),
                                                        -std::llround(256 * kLength * std::sin(angle)));
            const std::vector<glm::ivec2> truth = exactLine(from, to);
            pixels += truth.size();
            for (std::size_t k = 0; k < std::size(kRules); ++k) {
                Rules rules;
                rules.lineRule = kRules[k].rule;
                rules.line = kRules[k].algorithm;
                wrong[k] += differing(truth, lineSamples(glm::dvec2(from) / 256.0, glm::dvec2(to) / 256.0, rules));
            }
        }
        chart.x.push_back(bin * kBin);
        for (std::size_t k = 0; k < std::size(kRules); ++k)
            chart.series[k].y.push_back(100 * static_cast<double>(wrong[k]) / static_cast<double>(pixels));
    }
    chart.notes = {
        {QT_TRANSLATE_NOOP("Chart", "%1 lines of %2 pixels an angle, their ends anywhere in a pixel."),
         {kLines, QString::number(kLength)}},
        {QT_TRANSLATE_NOOP("Chart", "Lines from pixel to pixel lie up to half a pixel beside the edge that they "
                                    "stand for; the diamonds go by the edge.")}};
    return chart;
}

} // namespace rasterlens
