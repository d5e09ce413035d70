#pragma once
#include "core/observe/step_log.h"

namespace rasterlens
{

/// Calls visit(payload) with what the event holds.
template <class Visit>
void visitPayload(const StepLog& log, const StepEvent& event, Visit&& visit)
{
    switch (event.kind) {
    case StepKind::Vertex: visit(log.payload<VertexStep>(event)); break;
    case StepKind::ClipPlane: visit(log.payload<ClipStep>(event)); break;
    case StepKind::CohenSutherland: visit(log.payload<CohenSutherlandStep>(event)); break;
    case StepKind::Viewport: visit(log.payload<ViewportStep>(event)); break;
    case StepKind::Facing: visit(log.payload<FacingStep>(event)); break;
    case StepKind::Clipped: visit(log.payload<ClippedStep>(event)); break;
    case StepKind::Fate: visit(log.payload<FateStep>(event)); break;
    case StepKind::Walk: visit(log.payload<WalkStep>(event)); break;
    case StepKind::Sides: visit(log.payload<SidesStep>(event)); break;
    case StepKind::Halves: visit(log.payload<HalvesStep>(event)); break;
    case StepKind::Crossing: visit(log.payload<CrossingStep>(event)); break;
    case StepKind::Span: visit(log.payload<SpanStep>(event)); break;
    case StepKind::Column: visit(log.payload<ColumnFillStep>(event)); break;
    case StepKind::Sample: visit(log.payload<SampleStep>(event)); break;
    case StepKind::LineDecision: visit(log.payload<LineStep>(event)); break;
    case StepKind::LinePosition: visit(log.payload<LinePositionStep>(event)); break;
    case StepKind::Fragment: visit(log.payload<FragmentStep>(event)); break;
    case StepKind::Shade: visit(log.payload<ShadeStep>(event)); break;
    case StepKind::Write: visit(log.payload<WriteStep>(event)); break;
    case StepKind::Resolve: visit(log.payload<ResolveStep>(event)); break;
    case StepKind::Triangle:
    case StepKind::Setup:
    case StepKind::Outline:
    case StepKind::LineSample:
    case StepKind::End: break;
    }
}

} // namespace rasterlens
