#include "core/questions/race.h"

#include "core/render/steps.h"

#include <algorithm>
#include <iterator>
#include <limits>

namespace rasterlens
{
namespace
{

/// E = a (x - x0) + b (y - y0)
constexpr OperationCounts kEdgeFunction{0, 3, 2, 0};

OperationCounts& operator+=(OperationCounts& a, const OperationCounts& b)
{
    a.candidates += b.candidates;
    a.additions += b.additions;
    a.multiplications += b.multiplications;
    a.divisions += b.divisions;
    return a;
}

OperationCounts times(std::uint64_t n, const OperationCounts& c)
{
    return {n * c.candidates, n * c.additions, n * c.multiplications, n * c.divisions};
}

/// What the loops of edge_equation.h cost.
class EquationCost
{
public:
    explicit EquationCost(const Rules& rules) : m_incremental(addsUpEdgeValues(rules)) {}

    /// A and B of three edges; stepping: three start values, and A and B for a whole sample.
    [[nodiscard]] OperationCounts start() const
    {
        OperationCounts cost{0, 6, 0, 0};
        if (m_incremental) {
            cost += times(3, kEdgeFunction);
            cost += {0, 0, 6, 0};
        }
        return cost;
    }
    [[nodiscard]] OperationCounts row() const { return {0, m_incremental ? 3U : 0U, 0, 0}; }
    [[nodiscard]] OperationCounts sample() const
    {
        OperationCounts cost = m_incremental ? OperationCounts{0, 3, 0, 0} : times(3, kEdgeFunction);
        cost.candidates = 1;
        return cost;
    }

private:
    bool m_incremental;
};

/// What the loops of edge_walking.h cost.
class WalkingCost
{
public:
    explicit WalkingCost(const Rules& rules)
        : m_incremental(rules.stepping == Stepping::Incremental), m_fixed(rules.numberType == NumberType::Fixed)
    {
    }

    /// On which side of the long edge the middle vertex lies.
    [[nodiscard]] OperationCounts start() const { return {0, 4, 2, 0}; }
    /// Slopes of the two edges of a half, and where they cross its first row.
    [[nodiscard]] OperationCounts half() const
    {
        OperationCounts cost{0, 2, 0, 1};
        cost += jump();
        return times(2, cost);
    }
    /// Both edges one row down, and their ends rounded.
    [[nodiscard]] OperationCounts row() const
    {
        OperationCounts cost = m_incremental ? OperationCounts{0, m_fixed ? 2U : 1U, 0, 0} : jump();
        cost += {0, 1, 0, 0};
        return times(2, cost);
    }
    [[nodiscard]] OperationCounts sample() const { return {1, 0, 0, 0}; }

private:
    /// x0 + (row - y0) slope; in fixed point as quotient and remainder of (x0 dy + (row - y0) dx) / dy.
    [[nodiscard]] OperationCounts jump() const
    {
        return m_fixed ? OperationCounts{0, 3, 2, 1} : OperationCounts{0, 2, 1, 0};
    }

    bool m_incremental;
    bool m_fixed;
};

std::shared_ptr<const StepLog> stepsOf(const Scene& scene, Settings settings, Algorithm algorithm, std::uint32_t face,
                                       const std::stop_token& stop)
{
    settings.algorithm = algorithm;
    settings.fill = Fill::Solid;
    settings.attributePath = AttributePath::Planes;
    settings.interpolation = Interpolation::Perspective; // the race is about coverage
    settings.mistakes.removeIf([&](const QString& id) {  // those of the other lane
        Rules rules;
        rules.algorithm = algorithm;
        if (const Mistake* mistake = findMistake(id))
            mistake->apply(rules);
        return rules.algorithm != algorithm;
    });
    StepFilter filter;
    filter.face = face;
    filter.kinds =
        kindBit(StepKind::Setup) | kindBit(StepKind::Walk) | kindBit(StepKind::Span) | kindBit(StepKind::Sample);
    return renderSteps(scene, settings, filter, stop);
}

RaceLane runEquation(const StepLog& log)
{
    const EquationCost cost(log.rules());
    RaceLane lane;
    lane.algorithm = Algorithm::EdgeEquation;
    int row = std::numeric_limits<int>::min();
    for (const StepEvent& event : log.events()) {
        if (event.kind == StepKind::Setup && log.triangle(event)->hasSetup) {
            lane.total += cost.start();
            row = log.triangle(event)->setup.bounds.y;
        } else if (event.kind == StepKind::Sample) {
            if (event.y != row)
                lane.total += cost.row();
            row = event.y;
            lane.total += cost.sample();
            lane.ticks.push_back({event.x, event.y, event.has(StepEvent::kCovered), lane.total});
        }
    }
    return lane;
}

RaceLane runWalking(const StepLog& log)
{
    const WalkingCost cost(log.rules());
    RaceLane lane;
    lane.algorithm = Algorithm::EdgeWalking;
    std::optional<bool> upperHalf;
    for (const StepEvent& event : log.events()) {
        if (event.kind == StepKind::Walk) {
            lane.total += cost.start();
            upperHalf.reset();
        } else if (event.kind == StepKind::Span) {
            const SpanStep& span = log.payload<SpanStep>(event);
            if (upperHalf != span.ends.upperHalf)
                lane.total += cost.half();
            upperHalf = span.ends.upperHalf;
            lane.total += cost.row();
            for (int x = span.xBegin; x < span.xEnd; ++x) {
                lane.total += cost.sample();
                lane.ticks.push_back({x, event.y, true, lane.total});
            }
        }
    }
    return lane;
}

std::vector<RaceSample> chosen(const RaceLane& lane)
{
    std::vector<RaceSample> samples;
    for (const RaceTick& tick : lane.ticks)
        if (tick.covered)
            samples.push_back({tick.x, tick.y});
    std::ranges::sort(samples);
    return samples;
}

std::vector<RaceSample> without(const std::vector<RaceSample>& a, const std::vector<RaceSample>& b)
{
    std::vector<RaceSample> rest;
    std::ranges::set_difference(a, b, std::back_inserter(rest));
    std::ranges::sort(rest, {}, [](const RaceSample& s) { return std::pair(s.y, s.x); });
    return rest;
}

} // namespace

AlgorithmRace raceAlgorithms(const Scene& scene, const Settings& settings, std::uint32_t face,
                             const std::stop_token& stop)
{
    AlgorithmRace race;
    race.walking = runWalking(*stepsOf(scene, settings, Algorithm::EdgeWalking, face, stop));
    race.equation = runEquation(*stepsOf(scene, settings, Algorithm::EdgeEquation, face, stop));
    if (stop.stop_requested())
        return race;
    const std::vector<RaceSample> walking = chosen(race.walking);
    const std::vector<RaceSample> equation = chosen(race.equation);
    race.onlyWalking = without(walking, equation);
    race.onlyEquation = without(equation, walking);
    return race;
}

} // namespace rasterlens
