#include "core/observe/step_pips.h"

#include <algorithm>

namespace rasterlens
{

PipKind pipKindOf(const StepEvent& event)
{
    if (event.has(StepEvent::kTie))
        return PipKind::Tie;
    switch (event.kind) {
    case StepKind::ClipPlane:
    case StepKind::CohenSutherland:
    case StepKind::Clipped: return PipKind::Clip;
    case StepKind::Facing:
    case StepKind::Fate: return PipKind::Cull;
    case StepKind::Sample: return event.has(StepEvent::kCovered) ? PipKind::Sample : PipKind::Outside;
    case StepKind::Span:
    case StepKind::Column:
    case StepKind::LineSample: return PipKind::Sample;
    case StepKind::Fragment: return event.has(StepEvent::kPassed) ? PipKind::Other : PipKind::DepthFail;
    case StepKind::Vertex:
    case StepKind::Viewport:
    case StepKind::Triangle:
    case StepKind::Setup:
    case StepKind::Outline:
    case StepKind::Walk:
    case StepKind::Sides:
    case StepKind::Halves:
    case StepKind::Crossing:
    case StepKind::LineDecision:
    case StepKind::LinePosition:
    case StepKind::Shade:
    case StepKind::Write:
    case StepKind::Resolve:
    case StepKind::End: break;
    }
    return PipKind::Other;
}

void PipCounts::add(const StepEvent& event)
{
    if (m_size == kMostRuns * m_eventsOfRun) {
        for (std::size_t i = 0; i < kMostRuns / 2; ++i)
            for (std::size_t kind = 0; kind < kPipKinds; ++kind)
                m_runs[i][kind] = m_runs[2 * i][kind] + m_runs[2 * i + 1][kind];
        m_runs.resize(kMostRuns / 2);
        m_eventsOfRun *= 2;
    }
    if (m_size++ % m_eventsOfRun == 0)
        m_runs.push_back({});
    ++m_runs.back()[std::size_t(pipKindOf(event))];
}

std::vector<PipKind> PipCounts::columns(int count) const
{
    const auto width = std::size_t(std::max(count, 1));
    std::vector<Counts> counts(width);
    const double perEvent = double(width - 1) / std::max(1.0, double(m_size));
    for (std::size_t run = 0; run < m_runs.size(); ++run) {
        const std::size_t first = run * m_eventsOfRun;
        const std::size_t last = std::min(first + m_eventsOfRun, m_size);
        Counts& column = counts[std::size_t(double(first + (last - first + 1) / 2) * perEvent)];
        for (std::size_t kind = 0; kind < kPipKinds; ++kind)
            column[kind] += m_runs[run][kind];
    }
    constexpr auto kCommon = std::size_t(PipKind::Cull);
    std::vector<PipKind> bins(width, PipKind::None);
    for (std::size_t column = 0; column < width; ++column) {
        const Counts& here = counts[column];
        std::size_t shown = here[std::size_t(PipKind::Other)] > 0 ? std::size_t(PipKind::Other) : 0;
        for (std::size_t kind = std::size_t(PipKind::Sample); kind < kPipKinds; ++kind) {
            const bool outnumbers = here[kind] > (shown > std::size_t(PipKind::Other) ? here[shown] : 0);
            if (kind <= kCommon ? outnumbers : here[kind] > 0)
                shown = kind;
        }
        bins[column] = PipKind(shown);
    }
    return bins;
}

} // namespace rasterlens
