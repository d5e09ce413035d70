#include "core/settings/step_kind.h"

#include "core/base/closed_list.h"

#include <QCoreApplication>

#include <array>

namespace rasterlens
{
namespace
{

constexpr int kCoverPhase = 4;

constexpr auto kKinds = std::to_array<StepKindInfo>({
    {StepKind::Vertex, "vertex", QT_TRANSLATE_NOOP("StepListing", "vertex"), Stage::Scene, 0},
    {StepKind::ClipPlane, "clip-plane", QT_TRANSLATE_NOOP("StepListing", "clip plane"), Stage::Clip, 1},
    {StepKind::CohenSutherland, "cohen-sutherland", QT_TRANSLATE_NOOP("StepListing", "Cohen-Sutherland"), Stage::Clip,
     1},
    {StepKind::Viewport, "viewport", QT_TRANSLATE_NOOP("StepListing", "viewport"), Stage::Screen, 2},
    {StepKind::Facing, "facing", QT_TRANSLATE_NOOP("StepListing", "facing"), Stage::Cull, 2},
    {StepKind::Clipped, "clipped", QT_TRANSLATE_NOOP("StepListing", "fan"), Stage::Clip, 2},
    {StepKind::Fate, "fate", QT_TRANSLATE_NOOP("StepListing", "verdict"), Stage::Cull, 2},
    {StepKind::Triangle, "triangle", QT_TRANSLATE_NOOP("StepListing", "triangle"), Stage::Cover, 3},
    {StepKind::Setup, "setup", QT_TRANSLATE_NOOP("StepListing", "setup"), Stage::Cover, 3},
    {StepKind::Outline, "outline", QT_TRANSLATE_NOOP("StepListing", "outline"), Stage::Cover, 3},
    {StepKind::Walk, "walk", QT_TRANSLATE_NOOP("StepListing", "corners by height"), Stage::Cover, 3},
    {StepKind::Sides, "sides", QT_TRANSLATE_NOOP("StepListing", "long and broken edge"), Stage::Cover, 3},
    {StepKind::Halves, "halves", QT_TRANSLATE_NOOP("StepListing", "cut at the middle corner"), Stage::Cover, 3},
    {StepKind::Crossing, "crossing", QT_TRANSLATE_NOOP("StepListing", "crossings"), Stage::Cover, kCoverPhase},
    {StepKind::Span, "span", QT_TRANSLATE_NOOP("StepListing", "span"), Stage::Cover, kCoverPhase},
    {StepKind::Column, "column", QT_TRANSLATE_NOOP("StepListing", "column"), Stage::Cover, kCoverPhase},
    {StepKind::Sample, "sample", QT_TRANSLATE_NOOP("StepListing", "sample"), Stage::Cover, kCoverPhase},
    {StepKind::LineDecision, "line-decision", QT_TRANSLATE_NOOP("StepListing", "line decision"), Stage::Cover,
     kCoverPhase},
    {StepKind::LinePosition, "line-position", QT_TRANSLATE_NOOP("StepListing", "position on the line"), Stage::Cover,
     kCoverPhase},
    {StepKind::LineSample, "line-sample", QT_TRANSLATE_NOOP("StepListing", "line sample"), Stage::Cover, kCoverPhase},
    {StepKind::Fragment, "fragment", QT_TRANSLATE_NOOP("StepListing", "depth test"), Stage::Depth, kCoverPhase},
    {StepKind::Shade, "shade", QT_TRANSLATE_NOOP("StepListing", "shade"), Stage::Shade, kCoverPhase},
    {StepKind::Write, "write", QT_TRANSLATE_NOOP("StepListing", "write"), Stage::Image, kCoverPhase},
    {StepKind::Resolve, "resolve", QT_TRANSLATE_NOOP("StepListing", "mean of the samples"), Stage::Image, 5},
    {StepKind::End, "end", QT_TRANSLATE_NOOP("StepListing", "end of the frame"), Stage::Image, 6},
});
static_assert(isClosedList(kKinds, &StepKindInfo::kind));

} // namespace

const StepKindInfo& infoOf(StepKind kind) { return kKinds[static_cast<std::size_t>(kind)]; }

} // namespace rasterlens
