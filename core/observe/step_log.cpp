#include "core/observe/step_log.h"

#include "core/observe/line_count.h"
#include "core/pipeline/fate_count.h"
#include "core/pipeline/triangle_setup.h"

#include <algorithm>
#include <array>

namespace rasterlens
{

bool stopsAt(const StepEvent& event, const StepStop& stop, int grid)
{
    switch (stop.kind) {
    case StepStop::Kind::Pixel:
        return event.x >= 0 && event.y >= 0 && event.x / grid == stop.x && event.y / grid == stop.y;
    case StepStop::Kind::SignChange: return event.has(StepEvent::kSignChange);
    case StepStop::Kind::Tie: return event.has(StepEvent::kTie);
    case StepStop::Kind::DepthFail: return event.kind == StepKind::Fragment && !event.has(StepEvent::kPassed);
    case StepStop::Kind::Clip: return event.kind == StepKind::ClipPlane || event.kind == StepKind::CohenSutherland;
    case StepStop::Kind::NonFinite: return event.has(StepEvent::kNonFinite);
    }
    return false;
}

EdgeValues StepSetup::at(const glm::dvec2& point) const
{
    EdgeValues values;
    for (std::size_t i = 0; i < 3; ++i)
        values[i] = edges[i].a * (point.x * unitsPerSample - edges[i].from.x) +
                    edges[i].b * (point.y * unitsPerSample - edges[i].from.y);
    return values;
}

void StepSetup::move(const glm::dvec2& offset)
{
    for (glm::dvec2& vertex : vertices)
        vertex += offset;
    for (StepEdge& edge : edges)
        edge.from += offset * unitsPerSample;
}

glm::dvec2 testedPoint(const Rules& rules, int x, int y, int sample)
{
    if (rules.multiSampled() && sample >= 0 && !rules.samplesTruncated)
        return glm::dvec2(x + 0.5, y + 0.5) + testedOffset(rules, sample).pixels();
    const int grid = rules.sampleGrid;
    return rules.samplesTruncated ? glm::dvec2(x / grid * grid, y / grid * grid) : glm::dvec2(x + 0.5, y + 0.5);
}

EdgeValues testedValues(const StepSetup& setup, const Rules& rules, int x, int y, int sample)
{
    const glm::dvec2 point = testedPoint(rules, x, y, sample);
    if (rules.coverageRule == CoverageRule::Centre)
        return setup.at(point);
    EdgeValues values;
    for (std::size_t i = 0; i < 3; ++i)
        values[i] = setup.at(point + cornerAsked(setup, i, rules))[i];
    return values;
}

glm::dvec2 cornerAsked(const StepSetup& setup, std::size_t edge, const Rules& rules)
{
    const double reach = cornerReach<double>(rules);
    return {setup.edges[edge].a < 0 ? -reach : reach, setup.edges[edge].b < 0 ? -reach : reach};
}

bool addsUpEdgeValues(const Rules& rules)
{
    return rules.stepping == Stepping::Incremental && rules.coverageRule == CoverageRule::Centre &&
           rules.insideTest == InsideTest::AllPositive && !rules.samplesTruncated;
}

DecidingEdge decidingEdge(const StepSetup& setup, const EdgeValues& values, const Rules& rules)
{
    std::size_t smallest = 0;
    std::size_t largest = 0;
    bool failed = false;
    bool allAtMost = rules.insideTest == InsideTest::EitherSign;
    for (std::size_t i = 0; i < 3; ++i) {
        const bool fails = !(values[i] >= setup.edges[i].threshold);
        if (fails == failed ? values[i] < values[smallest] : fails)
            smallest = i;
        if (values[i] > values[largest])
            largest = i;
        failed = failed || fails;
        allAtMost = allAtMost && values[i] <= setup.edges[i].threshold;
    }
    const bool isCentre = rules.coverageRule == CoverageRule::Centre;
    if (rules.insideTest == InsideTest::None) // as if nothing could fail
        return {smallest, values[smallest], -std::numeric_limits<double>::infinity(), DecidingEdge::Sign::AtLeast,
                isCentre};
    const bool either = failed && allAtMost;
    const std::size_t edge = either ? largest : smallest;
    using Sign = DecidingEdge::Sign;
    return {edge, values[edge], setup.edges[edge].threshold,
            either   ? Sign::AtMost
            : failed ? Sign::Below
                     : Sign::AtLeast,
            isCentre};
}

bool isOfPattern(const StepLog& log, const StepEvent& event)
{
    const bool isInTriangle = event.kind != StepKind::Triangle && event.triangle != StepEvent::kNone;
    return log.rules().multiSampled() && isInTriangle && event.sample >= 0;
}

SampleMask coveredSamples(const StepSetup& setup, const Rules& rules, int x, int y)
{
    unsigned mask = 0;
    for (int sample = 0; sample < rules.patternSamples; ++sample)
        if (decidingEdge(setup, testedValues(setup, rules, x, y, sample), rules).isInside())
            mask |= 1U << sample;
    return static_cast<SampleMask>(mask);
}

bool isStepBoundary(const StepEvent& before, const StepEvent& after, StepLevel level)
{
    if (level == StepLevel::Event || before.face != after.face)
        return true;
    if (level == StepLevel::Face)
        return false;
    if (before.triangle != after.triangle || infoOf(before.kind).phase != infoOf(after.kind).phase)
        return true;
    if (level == StepLevel::Stage)
        return false;
    return before.y != after.y || (level == StepLevel::Sample && before.x != after.x);
}

std::size_t StepLog::step(std::size_t position, StepLevel level, StepDirection direction) const
{
    std::size_t p = std::min(position, size());
    const auto isBoundary = [&](std::size_t at) { return isStepBoundary(m_events[at - 1], m_events[at], level); };
    if (direction == StepDirection::Forward) {
        if (p < size())
            ++p;
        while (p < size() && p > 0 && !isBoundary(p))
            ++p;
    } else {
        if (p > 0)
            --p;
        while (p > 0 && p < size() && !isBoundary(p))
            --p;
    }
    return p;
}

std::optional<std::size_t> StepLog::findStop(std::size_t from, StepDirection direction, const StepStop& stop) const
{
    return find(from, direction, [&](const StepEvent& event) { return stopsAt(event, stop, grid()); });
}

std::optional<std::size_t> StepLog::firstEventOf(std::uint32_t face, int x, int y) const
{
    const StepStop here{StepStop::Kind::Pixel, x, y};
    if (const auto at = find(0, StepDirection::Forward, [&](const StepEvent& event) {
            return event.face == face && stopsAt(event, here, grid());
        }))
        return at;
    return find(0, StepDirection::Forward, [&](const StepEvent& event) { return event.face == face; });
}

void StepLog::count(const StepEvent& event, Statistics& statistics) const
{
    Statistics::Pixels& pixels = statistics.pixels;
    switch (event.kind) {
    case StepKind::Fate: countFate(payload<FateStep>(event).fate, statistics.faces); break;
    case StepKind::Clipped:
        ++statistics.faces.clipped;
        statistics.faces.createdByClipping += static_cast<std::uint64_t>(payload<ClippedStep>(event).pieces);
        break;
    case StepKind::Span: {
        const SpanStep& span = payload<SpanStep>(event);
        pixels.tested += static_cast<std::uint64_t>(span.xEnd - span.xBegin);
        break;
    }
    case StepKind::Sample:
    case StepKind::LineSample: ++pixels.tested; break;
    case StepKind::Fragment:
        ++pixels.covered;
        ++(event.has(StepEvent::kPassed) ? pixels.depthPassed : pixels.depthFailed);
        pixels.coveredTwice += event.has(StepEvent::kHitTwice) ? 1 : 0;
        break;
    case StepKind::Triangle: countLines(triangle(event)->screen, m_rules, statistics.lines); break;
    case StepKind::Shade: ++pixels.shaded; break;
    case StepKind::Write: ++pixels.written; break;
    case StepKind::Vertex:
    case StepKind::ClipPlane:
    case StepKind::CohenSutherland:
    case StepKind::Viewport:
    case StepKind::Facing:
    case StepKind::Setup:
    case StepKind::Outline:
    case StepKind::Walk:
    case StepKind::Sides:
    case StepKind::Halves:
    case StepKind::Crossing:
    case StepKind::Column:
    case StepKind::LineDecision:
    case StepKind::LinePosition:
    case StepKind::Resolve:
    case StepKind::End: break;
    }
}

std::size_t StepLog::resolvedPixels(std::size_t position) const
{
    const auto width = static_cast<std::size_t>(columns() / grid());
    if (position > 0 && m_events[position - 1].kind == StepKind::End)
        return width * static_cast<std::size_t>(rows() / grid());
    const auto resolves = eventsOf(StepKind::Resolve);
    const auto after = std::ranges::lower_bound(resolves, position);
    if (after == resolves.begin())
        return 0;
    const StepEvent& last = m_events[*std::prev(after)];
    return static_cast<std::size_t>(last.y / grid()) * width + static_cast<std::size_t>(last.x / grid()) + 1;
}

Statistics StepLog::countersAt(std::size_t position) const
{
    const auto after = std::ranges::upper_bound(m_checkpoints, position, {}, &Checkpoint::position);
    const Checkpoint& checkpoint = *(after - 1);
    Statistics statistics = checkpoint.statistics;
    for (std::size_t i = checkpoint.position; i < std::min(position, size()); ++i)
        count(m_events[i], statistics);
    return statistics;
}

} // namespace rasterlens
