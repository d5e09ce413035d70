#pragma once
#include "core/settings/settings.h"

#include <cstdint>

namespace rasterlens
{

/// What an event of a step log is about. The order is that of the pipeline.
enum class StepKind : std::uint8_t {
    Vertex,          ///< a face fetches a vertex: VertexStep
    ClipPlane,       ///< ClipStep
    CohenSutherland, ///< CohenSutherlandStep
    Viewport,        ///< ViewportStep
    Facing,          ///< FacingStep
    Clipped,         ///< ClippedStep: a cut face is drawn as a fan
    Fate,            ///< FateStep: what became of the face before coverage
    Triangle,        ///< a screen triangle begins; see StepLog::triangle
    Setup,           ///< its edge functions; see StepLog::triangle
    Outline,         ///< edge walking begins: three edges, not yet told apart
    Walk,            ///< edge walking sorts the corners: WalkStep
    Sides,           ///< edge walking tells the long edge from the broken one: SidesStep
    Halves,          ///< edge walking cuts the triangle at the middle corner: HalvesStep
    Crossing,        ///< edge walking finds where the edges cross a row: CrossingStep
    Span,            ///< edge walking fills a row: SpanStep
    Column,          ///< column fill fills a column: ColumnFillStep
    Sample,          ///< edge equation tests a sample: SampleStep
    LineDecision,    ///< Bresenham: LineStep
    LinePosition,    ///< a line by DDA: LinePositionStep
    LineSample,      ///< a sample of a line, a corner or a filled column
    Fragment,        ///< interpolation and depth test: FragmentStep
    Shade,           ///< ShadeStep
    Write,           ///< WriteStep
    Resolve,         ///< the samples of a pixel become one colour: ResolveStep
    End,             ///< the frame is finished
};
constexpr int kStepKinds = static_cast<int>(StepKind::End) + 1;

/// A set of kinds, one bit a StepKind.
using StepKinds = std::uint32_t;
[[nodiscard]] constexpr StepKinds kindBit(StepKind kind) { return 1U << static_cast<unsigned>(kind); }
constexpr StepKinds kAllSteps = (1U << kStepKinds) - 1;

/// One row of the table of kinds.
struct StepKindInfo {
    StepKind kind;
    const char* id;    ///< stable, `clip-plane`: logs and JSON
    const char* title; ///< QT_TRANSLATE_NOOP("StepListing", ...)
    Stage stage;       ///< of the pipeline strip
    int phase;         ///< what a step of a stage goes by; all that follows for a sample is one phase
};

[[nodiscard]] const StepKindInfo& infoOf(StepKind kind);
/// The stable name of a kind.
[[nodiscard]] inline const char* stepKindId(StepKind kind) { return infoOf(kind).id; }
/// The stage of the pipeline strip the kind belongs to.
[[nodiscard]] inline Stage stageOf(StepKind kind) { return infoOf(kind).stage; }

} // namespace rasterlens
