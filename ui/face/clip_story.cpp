#include "ui/face/clip_story.h"

#include "core/render/steps.h"

#include <algorithm>

namespace rasterlens
{

const ClipStep* ClipStory::stepOf(ClipPlane plane) const
{
    const auto step = std::ranges::find(steps, plane, &ClipStep::plane);
    return step == steps.end() ? nullptr : &*step;
}

std::vector<int> ClipStory::counts() const
{
    std::vector<int> counts{static_cast<int>(corners.size())};
    for (const ClipStep& step : steps)
        counts.push_back(static_cast<int>(step.after.size()));
    if (regions)
        counts.push_back(static_cast<int>(regions->after.size()));
    return counts;
}

Scene sceneOfFace(const Scene& scene, std::uint32_t face)
{
    Scene one;
    one.space = scene.space;
    one.lit = scene.lit;
    one.background = scene.background;
    one.bounds = scene.bounds;
    one.mesh.origin = scene.mesh.origin;
    one.materials.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t vertex = scene.mesh.indices[3 * static_cast<std::size_t>(face) + i];
        one.mesh.vertices.push_back(scene.mesh.vertices[vertex]);
        one.mesh.indices.push_back(static_cast<std::uint32_t>(i));
    }
    return one;
}

ClipStory clipStory(const Scene& scene, const Settings& settings, std::uint32_t face, const std::stop_token& stop)
{
    ClipStory story;
    if (face >= scene.mesh.faceCount())
        return story;
    StepFilter filter;
    filter.kinds = kindBit(StepKind::Vertex) | kindBit(StepKind::ClipPlane) | kindBit(StepKind::CohenSutherland) |
                   kindBit(StepKind::Clipped) | kindBit(StepKind::Fate);
    const auto log = renderSteps(sceneOfFace(scene, face), settings, filter, stop);
    story.rules = log->rules();
    for (std::size_t i = 0; i < log->size(); ++i) {
        const StepEvent& event = log->event(i);
        if (const auto moment = faceMomentAt(*log, i + 1))
            story.named.insert(story.named.end(), moment->corners.begin(), moment->corners.end());
        switch (event.kind) {
        case StepKind::Vertex: {
            const auto& vertex = log->payload<VertexStep>(event);
            story.corners.push_back(vertex.clip);
            story.outsideOf |= vertex.outside;
            break;
        }
        case StepKind::ClipPlane: story.steps.push_back(log->payload<ClipStep>(event)); break;
        case StepKind::CohenSutherland: story.regions = log->payload<CohenSutherlandStep>(event); break;
        case StepKind::Clipped: story.pieces = log->payload<ClippedStep>(event).pieces; break;
        case StepKind::Fate: story.fate = log->payload<FateStep>(event).fate; break;
        case StepKind::Viewport:
        case StepKind::Facing:
        case StepKind::Triangle:
        case StepKind::Setup:
        case StepKind::Outline:
        case StepKind::Walk:
        case StepKind::Sides:
        case StepKind::Halves:
        case StepKind::Crossing:
        case StepKind::Span:
        case StepKind::Column:
        case StepKind::Sample:
        case StepKind::LineDecision:
        case StepKind::LinePosition:
        case StepKind::LineSample:
        case StepKind::Fragment:
        case StepKind::Shade:
        case StepKind::Write:
        case StepKind::Resolve:
        case StepKind::End: break; // the filter leaves them out
        }
    }
    story.result = story.regions          ? story.regions->after
                   : !story.steps.empty() ? story.steps.back().after
                                          : story.corners;
    if (story.fate == FaceFate::Rejected)
        story.result.clear();
    else if (story.pieces == 0)
        story.pieces = std::max(0, static_cast<int>(story.result.size()) - 2);
    return story;
}

} // namespace rasterlens
