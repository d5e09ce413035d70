// The table of facts, and how each of them is found.
#include "core/lessons/facts.h"

#include "core/observe/names.h"
#include "core/observe/step_text.h"
#include "core/questions/vertex_table.h"
#include "core/render/steps.h"
#include "core/truth/perspective_curves.h"

#include <algorithm>
#include <utility>

namespace rasterlens
{
namespace
{

using Found = std::optional<FactValue>;

template <class Value>
Found found(Value value)
{
    return Found(std::in_place, std::move(value));
}

template <class Number>
Found number(Number value)
{
    return found(static_cast<double>(value));
}

// ---- counters of the whole picture, and measures against the other one

template <auto Part, auto Counter>
Found counted(MomentFacts& facts, const FactName&)
{
    return number(facts.shown().statistics.*Part.*Counter);
}

template <auto Part, auto Counter>
Found countedSoFar(MomentFacts& facts, const FactName&)
{
    const auto at = facts.position();
    return at ? number(facts.log()->countersAt(*at).*Part.*Counter) : std::nullopt;
}

template <Proof kProof>
Found measured(MomentFacts& facts, const FactName&)
{
    return number(proofValue(kProof, facts.shown(), facts.other()));
}

template <auto Count>
Found judged(MomentFacts& facts, const FactName&)
{
    const bool isJudged = notJudged(facts.open().scene, facts.open().settings) == NotJudged::No;
    return isJudged ? number(facts.judgement().difference.*Count) : std::nullopt;
}

// ---- pixels

/// The pixels for whose index in the arrays of a frame the test holds.
template <class Test>
Found pixelsWhere(MomentFacts& facts, Test&& test)
{
    std::vector<QPoint> pixels;
    const QSize size = facts.open().settings.size;
    for (int y = 0; y < size.height(); ++y)
        for (int x = 0; x < size.width(); ++x)
            if (test(facts.indexOf({x, y})))
                pixels.emplace_back(x, y);
    return found(std::move(pixels));
}

Found winner(MomentFacts& facts, const FactName& name)
{
    return number(facts.shown().frame.ids[facts.indexOf(*name.pixel)]);
}

Found depthAt(MomentFacts& facts, const FactName& name)
{
    return number(facts.shown().frame.depth[facts.indexOf(*name.pixel)]);
}

Found hitsAt(MomentFacts& facts, const FactName& name)
{
    return number(facts.shown().frame.coverage[facts.indexOf(*name.pixel)]);
}

Found colorAt(MomentFacts& facts, const FactName& name)
{
    return found(colorText(facts.shown().frame.image.pixel(*name.pixel)));
}

Found seen(MomentFacts& facts, const FactName& name)
{
    return number(std::ranges::count(facts.shown().frame.ids, static_cast<std::int32_t>(name.face)));
}

Found pixelsOf(MomentFacts& facts, const FactName& name)
{
    return pixelsWhere(
        facts, [&](std::size_t i) { return facts.shown().frame.ids[i] == static_cast<std::int32_t>(name.face); });
}

Found pixelsHitTwice(MomentFacts& facts, const FactName&)
{
    return pixelsWhere(facts, [&](std::size_t i) { return facts.shown().frame.coverage[i] > 1; });
}

Found pixelsHoles(MomentFacts& facts, const FactName&)
{
    return pixelsWhere(
        facts, [&](std::size_t i) { return facts.shown().frame.ids[i] < 0 && facts.other().frame.ids[i] >= 0; });
}

/// The pixels at whose sample something of a kind happens to a face.
Found pixelsOfEvents(MomentFacts& facts, std::uint32_t face, StepKind kind, std::uint8_t flag)
{
    std::vector<QPoint> pixels;
    const StepLog& log = *facts.log();
    for (const std::uint32_t at : log.eventsOf(kind))
        if (const StepEvent& event = log.event(at); event.face == face && event.has(flag))
            pixels.emplace_back(event.x / log.grid(), event.y / log.grid());
    std::ranges::sort(pixels, {}, [](QPoint p) { return std::pair(p.y(), p.x()); });
    pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end()); // clang 14 makes no subrange of std::ranges
    return found(std::move(pixels));
}

Found pixelsTied(MomentFacts& facts, const FactName& name)
{
    return pixelsOfEvents(facts, name.face, StepKind::Sample, StepEvent::kTie);
}

Found pixelsOnLine(MomentFacts& facts, const FactName& name)
{
    return pixelsOfEvents(facts, name.face, StepKind::LineSample, StepEvent::kCovered);
}

/// What became of a face at a pixel; the pixel's report says nothing of faces that do not concern it.
std::optional<WhyFace> whyFace(MomentFacts& facts, const FactName& name)
{
    const WhyReport report = why(facts.open().scene, facts.open().settings, name.pixel->x(), name.pixel->y());
    const WhyFace* face = report.find(name.face);
    return face ? std::optional(*face) : std::nullopt;
}

Found verdict(MomentFacts& facts, const FactName& name)
{
    const auto face = whyFace(facts, name);
    return face ? Found(QString::fromLatin1(whyVerdictId(face->verdict))) : std::nullopt;
}

Found edgeAt(MomentFacts& facts, const FactName& name)
{
    const auto face = whyFace(facts, name);
    if (face && face->hasEdges)
        for (const WhyEdge& edge : face->edges)
            if (edge.name == name.word)
                return number(edge.value / face->unitsPerArea);
    return std::nullopt;
}

Found weightAt(MomentFacts& facts, const FactName& name)
{
    const auto face = whyFace(facts, name);
    const qsizetype corner = QStringLiteral("ABC").indexOf(name.word);
    if (!face || !face->fragment || corner < 0)
        return std::nullopt;
    return number(face->fragment->screen[static_cast<std::size_t>(corner)]);
}

Found fractionAt(MomentFacts& facts, const FactName& name)
{
    const auto face = whyFace(facts, name);
    const qsizetype corner = QStringLiteral("ABC").indexOf(name.word);
    if (!face || !face->fragment || !face->fragment->shaded || corner < 0)
        return std::nullopt;
    return number(face->fragment->weights[static_cast<std::size_t>(corner)]);
}

Found newDepthAt(MomentFacts& facts, const FactName& name)
{
    const auto face = whyFace(facts, name);
    return face && face->fragment ? number(face->fragment->depth) : std::nullopt;
}

// ---- corners, edges and clipping of a face

std::optional<VertexRow> vertexOf(MomentFacts& facts, const FactName& name)
{
    const qsizetype corner = QStringLiteral("ABC").indexOf(name.word);
    if (corner < 0 || name.word.size() != 1)
        return std::nullopt;
    return vertexTable(facts.open().scene, facts.open().settings, name.face)[static_cast<std::size_t>(corner)];
}

template <auto Coordinate>
Found vertexNumber(MomentFacts& facts, const FactName& name)
{
    const auto row = vertexOf(facts, name);
    return row ? number(Coordinate(*row)) : std::nullopt;
}

Found region(MomentFacts& facts, const FactName& name)
{
    const auto row = vertexOf(facts, name);
    return row ? Found(regionText(row->screenRegion)) : std::nullopt;
}

/// The record of one face, with the kinds of steps that are looked at.
std::shared_ptr<const StepLog> faceLog(MomentFacts& facts, std::uint32_t face, StepKinds kinds)
{
    StepFilter filter;
    filter.face = face;
    filter.kinds = kinds;
    return renderSteps(facts.open().scene, facts.open().settings, filter);
}

Found fate(MomentFacts& facts, const FactName& name)
{
    const auto log = faceLog(facts, name.face, kindBit(StepKind::Fate));
    const auto fates = log->eventsOf(StepKind::Fate);
    if (fates.empty())
        return std::nullopt;
    return found(QString::fromLatin1(faceFateId(log->payload<FateStep>(log->event(fates[0])).fate)));
}

Found corners(MomentFacts& facts, const FactName& name)
{
    const StepKinds kinds = kindBit(StepKind::ClipPlane) | kindBit(StepKind::CohenSutherland);
    const auto log = faceLog(facts, name.face, kinds);
    std::size_t count = 3;
    for (const StepEvent& event : log->events())
        if (event.kind == StepKind::ClipPlane)
            count = log->payload<ClipStep>(event).after.size();
        else if (event.kind == StepKind::CohenSutherland)
            count = log->payload<CohenSutherlandStep>(event).after.size();
    return number(count);
}

/// The edge of a face's first triangle by its name.
const StepEdge* edgeNamed(const StepTriangle& triangle, const QString& word)
{
    for (int i = 0; triangle.hasSetup && i < 3; ++i)
        if (edgeName(triangle.setup, i) == word)
            return &triangle.setup.edges[static_cast<std::size_t>(i)];
    return nullptr;
}

template <double StepEdge::*kStep>
Found edgeStep(MomentFacts& facts, const FactName& name)
{
    const auto log = faceLog(facts, name.face, kindBit(StepKind::Setup));
    const auto setups = log->eventsOf(StepKind::Setup);
    const StepTriangle* triangle = setups.empty() ? nullptr : log->triangle(log->event(setups[0]));
    const StepEdge* edge = triangle ? edgeNamed(*triangle, name.word) : nullptr;
    return edge ? number(edge->*kStep / triangle->setup.unitsPerArea) : std::nullopt;
}

Found area(MomentFacts& facts, const FactName& name)
{
    const auto log = faceLog(facts, name.face, kindBit(StepKind::Setup));
    const auto setups = log->eventsOf(StepKind::Setup);
    const StepTriangle* triangle = setups.empty() ? nullptr : log->triangle(log->event(setups[0]));
    return triangle && triangle->hasSetup ? number(triangle->setup.area2 / triangle->setup.unitsPerArea) : std::nullopt;
}

Found trianglesDrawn(MomentFacts& facts, const FactName& name)
{
    const auto log = faceLog(facts, name.face, kindBit(StepKind::Triangle));
    return number(log->eventsOf(StepKind::Triangle).size());
}

// ---- the step that the moment stands at

/// The payload of the step, if it is of that kind.
template <class Payload>
const Payload* payloadAt(MomentFacts& facts)
{
    const StepEvent* event = facts.event();
    return event && event->kind == Payload::kKind ? &facts.log()->payload<Payload>(*event) : nullptr;
}

template <class Payload, auto Read>
Found stepNumber(MomentFacts& facts, const FactName&)
{
    const Payload* payload = payloadAt<Payload>(facts);
    return payload ? number(Read(*payload)) : std::nullopt;
}

Found stepKind(MomentFacts& facts, const FactName&)
{
    const StepEvent* event = facts.event();
    return event ? Found(QString::fromLatin1(stepKindId(event->kind))) : std::nullopt;
}

Found nextDecision(MomentFacts& facts, const FactName&)
{
    const auto at = facts.position();
    const StepEvent* here = facts.event();
    if (!at || !here)
        return std::nullopt;
    const auto next = facts.log()->find(*at, StepDirection::Forward, [&](const StepEvent& event) {
        return event.kind == StepKind::LineDecision && event.face == here->face;
    });
    return next ? number(facts.log()->payload<LineStep>(facts.log()->event(*next)).decision.decision) : std::nullopt;
}

Found stepEdgeValue(MomentFacts& facts, const FactName& name)
{
    const SampleStep* sample = payloadAt<SampleStep>(facts);
    const StepTriangle* triangle = sample ? facts.log()->triangle(*facts.event()) : nullptr;
    for (int i = 0; triangle && i < 3; ++i)
        if (edgeName(triangle->setup, i) == name.word)
            return number(sample->values[static_cast<std::size_t>(i)] / triangle->setup.unitsPerArea);
    return std::nullopt;
}

Found cutFraction(MomentFacts& facts, const FactName& name)
{
    const ClipStep* clip = payloadAt<ClipStep>(facts);
    const auto index = static_cast<std::size_t>(name.numbers[0]);
    return clip && index < clip->cuts.size() ? number(clip->cuts[index].t) : std::nullopt;
}

Found clipPlane(MomentFacts& facts, const FactName&)
{
    const ClipStep* clip = payloadAt<ClipStep>(facts);
    return clip ? Found(QString::fromLatin1(clipPlaneId(clip->plane))) : std::nullopt;
}

Found storedColor(MomentFacts& facts, const FactName& name)
{
    const ResolveStep* step = payloadAt<ResolveStep>(facts);
    const auto index = static_cast<int>(name.numbers[0]) - 1;
    if (!step || index < 0 || index >= step->pixel.count)
        return std::nullopt;
    return Found(colorText(step->pixel.samples[static_cast<std::size_t>(index)].color));
}

Found meanColor(MomentFacts& facts, const FactName&)
{
    const ResolveStep* step = payloadAt<ResolveStep>(facts);
    return step ? Found(colorText(step->pixel.color)) : std::nullopt;
}

Found eventsSoFar(MomentFacts& facts, const FactName&)
{
    const auto at = facts.position();
    return at ? number(*at) : std::nullopt;
}

// ---- work and curves

template <RaceLane AlgorithmRace::*kLane, std::uint64_t OperationCounts::*kCount>
Found work(MomentFacts& facts, const FactName& name)
{
    const AlgorithmRace race = raceAlgorithms(facts.open().scene, facts.open().settings, name.face);
    return number((race.*kLane).total.*kCount);
}

Found mistakeId(MomentFacts& facts, const FactName&)
{
    const QStringList& mistakes = facts.open().settings.mistakes;
    return mistakes.size() == 1 ? Found(mistakes.first()) : std::nullopt;
}

Found spaceFractionOf(MomentFacts&, const FactName& name)
{
    return number(spaceFraction(name.numbers[0], name.numbers[1], name.numbers[2]));
}

Found ndcDepthOf(MomentFacts&, const FactName& name)
{
    return number(ndcDepth(name.numbers[0], name.numbers[1], name.numbers[2]));
}

using Faces = Statistics::Faces;
using Pixels = Statistics::Pixels;

constexpr FactRow kRows[] = {
    {"submitted", "", "", "faces sent", counted<&Statistics::faces, &Faces::submitted>},
    {"rejected", "", "", "faces outside the view volume", counted<&Statistics::faces, &Faces::rejected>},
    {"culled-back", "", "", "faces culled as back faces", counted<&Statistics::faces, &Faces::culledBack>},
    {"culled-front", "", "", "faces culled as front faces", counted<&Statistics::faces, &Faces::culledFront>},
    {"degenerate", "", "", "faces without area on the screen", counted<&Statistics::faces, &Faces::degenerate>},
    {"non-finite", "", "", "faces with a position that is no number", counted<&Statistics::faces, &Faces::nonFinite>},
    {"clipped", "", "", "faces cut by at least one plane", counted<&Statistics::faces, &Faces::clipped>},
    {"created-by-clipping", "", "", "triangles drawn for cut faces",
     counted<&Statistics::faces, &Faces::createdByClipping>},
    {"rasterized", "", "", "faces drawn", counted<&Statistics::faces, &Faces::rasterized>},
    {"tested", "", "", "samples that the rasterizer looked at", counted<&Statistics::pixels, &Pixels::tested>},
    {"covered", "", "", "samples found inside, once for each face", counted<&Statistics::pixels, &Pixels::covered>},
    {"depth-passed", "", "", "fragments that passed the depth test",
     counted<&Statistics::pixels, &Pixels::depthPassed>},
    {"depth-failed", "", "", "fragments that failed it", counted<&Statistics::pixels, &Pixels::depthFailed>},
    {"shaded", "", "", "fragments shaded", counted<&Statistics::pixels, &Pixels::shaded>},
    {"written", "", "", "fragments written", counted<&Statistics::pixels, &Pixels::written>},
    {"hit-twice", "", "", "samples taken by both faces at an edge they share",
     counted<&Statistics::pixels, &Pixels::coveredTwice>},
    {"rasterized-so-far", "", "", "faces drawn, up to the moment's step",
     countedSoFar<&Statistics::faces, &Faces::rasterized>},
    {"tested-so-far", "", "", "samples that the rasterizer looked at, up to the moment's step",
     countedSoFar<&Statistics::pixels, &Pixels::tested>},
    {"covered-so-far", "", "", "samples found inside, once for each face, up to the moment's step",
     countedSoFar<&Statistics::pixels, &Pixels::covered>},
    {"depth-passed-so-far", "", "", "fragments that passed the depth test, up to the moment's step",
     countedSoFar<&Statistics::pixels, &Pixels::depthPassed>},
    {"depth-failed-so-far", "", "", "fragments that failed it, up to the moment's step",
     countedSoFar<&Statistics::pixels, &Pixels::depthFailed>},
    {"written-so-far", "", "", "fragments written, up to the moment's step",
     countedSoFar<&Statistics::pixels, &Pixels::written>},
    {"hit-twice-so-far", "", "", "samples taken by both faces at an edge they share, up to the moment's step",
     countedSoFar<&Statistics::pixels, &Pixels::coveredTwice>},
    {"holes", "", "", "pixels that no face is seen at, though one is in the other picture", measured<Proof::Holes>},
    {"strays", "", "", "pixels that a face is seen at, though none is in the other picture", measured<Proof::Strays>},
    {"wrong-faces", "", "", "pixels at which the other picture shows another face or none",
     measured<Proof::WrongFaces>},
    {"wrong-pixels", "", "", "pixels of another colour than in the other picture", measured<Proof::WrongPixels>},
    {"depth-error", "", "", "largest difference of depth from the other picture where both show one face",
     measured<Proof::DepthError>},
    {"colors", "", "", "different colours in the picture", measured<Proof::Colors>},
    {"missing-light", "", "", "brightness that the other picture has more, in white pixels",
     measured<Proof::MissingLight>},
    {"missing", "", "", "pixels not covered that the exact reference covers", judged<&CoverageDifference::missing>},
    {"extra", "", "", "pixels covered that the exact reference leaves free", judged<&CoverageDifference::extra>},
    {"cracks", "", "", "of the missing pixels those inside, along an edge", judged<&CoverageDifference::neverHit>},
    {"exact-hit-twice", "", "", "pixels hit more often than in the exact reference",
     judged<&CoverageDifference::hitTwice>},
    {"exact-wrong-face", "", "", "pixels where the exact reference shows another face",
     judged<&CoverageDifference::otherFace>},
    {"exact-depth-error", "", "", "largest difference of depth from the exact reference",
     judged<&CoverageDifference::depthMax>},
    {"exact-color-error", "", "", "largest difference of a colour channel from the exact reference, in steps of 255",
     judged<&CoverageDifference::colorMax>},
    {"winner", "P", "X,Y", "the face seen at a pixel, -1 none", winner},
    {"depth", "P", "X,Y", "the depth stored at a pixel", depthAt},
    {"hits", "P", "X,Y", "how many faces cover a pixel", hitsAt},
    {"color", "P", "X,Y", "the colour of a pixel, #rrggbb", colorAt},
    {"seen", "F", "FACE", "at how many pixels a face is seen", seen},
    {"pixels-of", "F", "FACE", "the pixels at which a face is seen", pixelsOf},
    {"pixels-hit-twice", "", "", "the pixels that more than one face covers", pixelsHitTwice},
    {"pixels-holes", "", "", "the pixels counted by holes", pixelsHoles},
    {"pixels-tied", "F", "FACE", "the pixels whose sample lies exactly on an edge of a face", pixelsTied},
    {"pixels-on-line", "F", "FACE", "the pixels of a face's outline", pixelsOnLine},
    {"verdict", "FP", "FACE X,Y", "what became of a face at a pixel, as the verb why tells it", verdict},
    {"edge", "WFP", "EDGE FACE X,Y", "an edge function (BC) of a face at a pixel, in areas of samples", edgeAt},
    {"weight", "WFP", "CORNER FACE X,Y",
     "the weight on the screen of a corner (A, B, C) of a drawn triangle at a pixel", weightAt},
    {"fraction", "WFP", "CORNER FACE X,Y", "the weight of a corner that attributes are interpolated with", fractionAt},
    {"new-depth", "FP", "FACE X,Y", "the depth that a face has at a pixel", newDepthAt},
    {"clip-x", "WF", "CORNER FACE", "x of a corner of a face in clip space",
     vertexNumber<[](const VertexRow& row) { return row.clip.x; }>},
    {"clip-y", "WF", "CORNER FACE", "y of a corner of a face in clip space",
     vertexNumber<[](const VertexRow& row) { return row.clip.y; }>},
    {"clip-z", "WF", "CORNER FACE", "z of a corner of a face in clip space",
     vertexNumber<[](const VertexRow& row) { return row.clip.z; }>},
    {"clip-w", "WF", "CORNER FACE", "w of a corner of a face",
     vertexNumber<[](const VertexRow& row) { return row.clip.w; }>},
    {"screen-x", "WF", "CORNER FACE", "x of a corner on the screen, snapped, in pixels",
     vertexNumber<[](const VertexRow& row) { return row.snapped.x; }>},
    {"screen-y", "WF", "CORNER FACE", "y of a corner on the screen, snapped, in pixels",
     vertexNumber<[](const VertexRow& row) { return row.snapped.y; }>},
    {"corner-depth", "WF", "CORNER FACE", "depth of a corner of a face",
     vertexNumber<[](const VertexRow& row) { return row.depth; }>},
    {"region", "WF", "CORNER FACE", "the region code of a corner: above, below, right, left", region},
    {"fate", "F", "FACE", "what became of a face before coverage", fate},
    {"corners", "F", "FACE", "how many corners clipping leaves of a face", corners},
    {"triangles", "F", "FACE", "how many triangles are drawn for a face", trianglesDrawn},
    {"area", "F", "FACE", "twice the area of a face's first triangle, in samples", area},
    {"per-x", "WF", "EDGE FACE", "what an edge function changes by for a step to the right", edgeStep<&StepEdge::perX>},
    {"per-y", "WF", "EDGE FACE", "what an edge function changes by for a step down", edgeStep<&StepEdge::perY>},
    {"step-kind", "", "", "the kind of the moment's step", stepKind},
    {"steps-so-far", "", "", "the position of the moment's step in the record", eventsSoFar},
    {"p", "", "", "p at a step of a line",
     stepNumber<LineStep, [](const LineStep& step) { return step.decision.decision; }>},
    {"next-p", "", "", "p at the next step of the line", nextDecision},
    {"d-upper", "", "", "at a step of a line, the distance to the farther of the two samples along the shorter axis",
     stepNumber<LineStep, [](const LineStep& step) { return step.dUpper(); }>},
    {"d-lower", "", "", "the distance to the nearer of the two samples along the shorter axis",
     stepNumber<LineStep, [](const LineStep& step) { return step.dLower(); }>},
    {"step-edge", "W", "EDGE", "an edge function at the sample of the step", stepEdgeValue},
    {"span-begin", "", "", "the first sample of a span",
     stepNumber<SpanStep, [](const SpanStep& step) { return step.xBegin; }>},
    {"span-end", "", "", "one past the last sample of a span",
     stepNumber<SpanStep, [](const SpanStep& step) { return step.xEnd; }>},
    {"span-left", "", "", "where the left edge crosses the line of a span, in samples",
     stepNumber<SpanStep, [](const SpanStep& step) { return step.ends.left; }>},
    {"span-right", "", "", "where the right edge crosses the line of a span, in samples",
     stepNumber<SpanStep, [](const SpanStep& step) { return step.ends.right; }>},
    {"alpha", "", "", "the fraction of the way down the long edge at the crossings of a row",
     stepNumber<CrossingStep, [](const CrossingStep& step) { return step.row.alpha; }>},
    {"beta", "", "", "the fraction of the way down the short edge at the crossings of a row",
     stepNumber<CrossingStep, [](const CrossingStep& step) { return step.row.beta; }>},
    {"xa", "", "", "where the long edge crosses the line of a row, in samples",
     stepNumber<CrossingStep, [](const CrossingStep& step) { return step.row.xa; }>},
    {"xb", "", "", "where the short edge crosses the line of a row, in samples",
     stepNumber<CrossingStep, [](const CrossingStep& step) { return step.row.xb; }>},
    {"cut-alpha", "", "", "the fraction of the way down the long edge at the height of the middle corner",
     stepNumber<HalvesStep, [](const HalvesStep& step) { return step.halves.alpha; }>},
    {"cut-x", "", "", "where the long edge is at the height of the middle corner, in samples",
     stepNumber<HalvesStep, [](const HalvesStep& step) { return step.halves.x; }>},
    {"first-lower-row", "", "", "the first row of the lower half, in samples",
     stepNumber<HalvesStep, [](const HalvesStep& step) { return step.halves.firstLowerRow; }>},
    {"sample-color", "N", "N",
     "the colour that the Nth sample of the pixel of the step stores, counted from 1, #rrggbb", storedColor},
    {"mean-color", "", "", "the colour that the samples of the pixel of the step become, #rrggbb", meanColor},
    {"plane", "", "", "the plane that the step clips by", clipPlane},
    {"corners-before", "", "", "corners before the plane of the step",
     stepNumber<ClipStep, [](const ClipStep& step) { return step.before.size(); }>},
    {"corners-after", "", "", "corners after the plane of the step",
     stepNumber<ClipStep, [](const ClipStep& step) { return step.after.size(); }>},
    {"cut", "N", "N", "the fraction t of the Nth cut of the step, counted from 0, from the inside corner", cutFraction},
    {"step-depth", "", "", "the depth of the fragment of the step",
     stepNumber<FragmentStep, [](const FragmentStep& step) { return step.depth; }>},
    {"stored-depth", "", "", "the depth it is compared with",
     stepNumber<FragmentStep, [](const FragmentStep& step) { return step.storedDepth; }>},
    {"equation-candidates", "F", "FACE", "samples looked at for a face by edge equation",
     work<&AlgorithmRace::equation, &OperationCounts::candidates>},
    {"equation-additions", "F", "FACE", "additions and subtractions for a face by edge equation",
     work<&AlgorithmRace::equation, &OperationCounts::additions>},
    {"equation-multiplications", "F", "FACE", "multiplications for a face by edge equation",
     work<&AlgorithmRace::equation, &OperationCounts::multiplications>},
    {"equation-divisions", "F", "FACE", "divisions for a face by edge equation",
     work<&AlgorithmRace::equation, &OperationCounts::divisions>},
    {"walking-candidates", "F", "FACE", "samples looked at for a face by edge walking",
     work<&AlgorithmRace::walking, &OperationCounts::candidates>},
    {"walking-additions", "F", "FACE", "additions and subtractions for a face by edge walking",
     work<&AlgorithmRace::walking, &OperationCounts::additions>},
    {"walking-multiplications", "F", "FACE", "multiplications for a face by edge walking",
     work<&AlgorithmRace::walking, &OperationCounts::multiplications>},
    {"walking-divisions", "F", "FACE", "divisions for a face by edge walking",
     work<&AlgorithmRace::walking, &OperationCounts::divisions>},
    {"mistake", "", "", "the one mistake that is switched on", mistakeId},
    {"space-fraction", "NNN", "M Z1 Z2",
     "n(m): the fraction of the way in space from distance Z1 to Z2 for the fraction M on the screen", spaceFractionOf},
    {"ndc-depth", "NNN", "Z NEAR FAR", "z/w of a distance", ndcDepthOf},
};

} // namespace

std::span<const FactRow> factRows() { return kRows; }

} // namespace rasterlens
