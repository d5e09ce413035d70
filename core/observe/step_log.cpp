#include "core/observe/step_log.h"

#include <algorithm>
#include <array>

namespace rasterlens
{
namespace
{

struct KindInfo {
    const char* id;
    Stage stage;
    int phase; ///< what a step of a stage goes by; all that follows for a sample is one phase
};

constexpr int kCoverPhase = 4;

constexpr std::array<KindInfo, kStepKinds> kKinds{{
    {"vertex", Stage::Scene, 0},
    {"clip-plane", Stage::Clip, 1},
    {"cohen-sutherland", Stage::Clip, 1},
    {"viewport", Stage::Screen, 2},
    {"facing", Stage::Cull, 2},
    {"clipped", Stage::Clip, 2},
    {"fate", Stage::Cull, 2},
    {"triangle", Stage::Cover, 3},
    {"setup", Stage::Cover, 3},
    {"walk", Stage::Cover, 3},
    {"span", Stage::Cover, kCoverPhase},
    {"sample", Stage::Cover, kCoverPhase},
    {"line-decision", Stage::Cover, kCoverPhase},
    {"line-sample", Stage::Cover, kCoverPhase},
    {"fragment", Stage::Depth, kCoverPhase},
    {"shade", Stage::Shade, kCoverPhase},
    {"write", Stage::Image, kCoverPhase},
    {"end", Stage::Image, 5},
}};

const KindInfo& infoOf(StepKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

bool stops(const StepEvent& event, const StepStop& stop, int grid)
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

void countFate(FaceFate fate, Statistics::Faces& faces)
{
    ++faces.submitted;
    switch (fate) {
    case FaceFate::Rejected: ++faces.rejected; break;
    case FaceFate::CulledBack: ++faces.culledBack; break;
    case FaceFate::CulledFront: ++faces.culledFront; break;
    case FaceFate::Degenerate: ++faces.degenerate; break;
    case FaceFate::NonFinite: ++faces.nonFinite; break;
    case FaceFate::Rasterized: ++faces.rasterized; break;
    }
}

} // namespace

const char* stepKindId(StepKind kind) { return infoOf(kind).id; }

Stage stageOf(StepKind kind) { return infoOf(kind).stage; }

const char* edgeSideId(EdgeSide side)
{
    switch (side) {
    case EdgeSide::Left: return "left";
    case EdgeSide::Top: return "top";
    case EdgeSide::Neither: break;
    }
    return "neither";
}

unsigned screenRegion(const glm::dvec4& p)
{
    const double x = p.x / p.w;
    const double y = p.y / p.w;
    return (x < -1 ? kRegionLeft : 0U) | (x > 1 ? kRegionRight : 0U) | (y < -1 ? kRegionBelow : 0U) |
           (y > 1 ? kRegionAbove : 0U);
}

EdgeValues StepSetup::at(int x, int y) const
{
    EdgeValues values;
    for (std::size_t i = 0; i < 3; ++i)
        values[i] = edges[i].a * ((x + 0.5) * unitsPerSample - edges[i].from.x) +
                    edges[i].b * ((y + 0.5) * unitsPerSample - edges[i].from.y);
    return values;
}

bool StepLog::isBoundary(std::size_t position, StepLevel level) const
{
    const StepEvent& before = m_events[position - 1];
    const StepEvent& after = m_events[position];
    if (level == StepLevel::Event || before.face != after.face)
        return true;
    if (level == StepLevel::Face)
        return false;
    if (before.triangle != after.triangle || infoOf(before.kind).phase != infoOf(after.kind).phase)
        return true;
    return level == StepLevel::Row && before.y != after.y;
}

std::size_t StepLog::step(std::size_t position, StepLevel level, StepDirection direction) const
{
    std::size_t p = std::min(position, size());
    if (direction == StepDirection::Forward) {
        if (p < size())
            ++p;
        while (p < size() && p > 0 && !isBoundary(p, level))
            ++p;
    } else {
        if (p > 0)
            --p;
        while (p > 0 && p < size() && !isBoundary(p, level))
            --p;
    }
    return p;
}

std::optional<std::size_t> StepLog::findStop(std::size_t from, StepDirection direction, const StepStop& stop) const
{
    return find(from, direction, [&](const StepEvent& event) { return stops(event, stop, m_grid); });
}

std::optional<std::size_t> StepLog::firstEventOf(std::uint32_t face, int x, int y) const
{
    const StepStop here{StepStop::Kind::Pixel, x, y};
    if (const auto at = find(0, StepDirection::Forward,
                             [&](const StepEvent& event) { return event.face == face && stops(event, here, m_grid); }))
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
        statistics.faces.createdByClipping += static_cast<std::uint64_t>(payload<FanStep>(event).pieces);
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
    case StepKind::Shade: ++pixels.shaded; break;
    case StepKind::Write: ++pixels.written; break;
    case StepKind::Vertex:
    case StepKind::ClipPlane:
    case StepKind::CohenSutherland:
    case StepKind::Viewport:
    case StepKind::Facing:
    case StepKind::Triangle:
    case StepKind::Setup:
    case StepKind::Walk:
    case StepKind::LineDecision:
    case StepKind::End: break;
    }
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
