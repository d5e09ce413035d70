// What the recorder makes of each callback.
#include "core/observe/recorder.h"

#include "core/pipeline/shading.h"
#include "core/pipeline/unsnapped.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

namespace rasterlens
{
namespace
{

template <class... Number>
std::uint8_t finiteFlag(Number... numbers)
{
    return (std::isfinite(numbers) && ...) ? std::uint8_t(0) : StepEvent::kNonFinite;
}

std::uint8_t finiteFlag(const glm::dvec4& p) { return finiteFlag(p.x, p.y, p.z, p.w); }

std::uint8_t flagIf(bool condition, std::uint8_t flag) { return condition ? flag : std::uint8_t(0); }

std::vector<ClipVertex> corners(const ClipPolygon& polygon) { return {polygon.span().begin(), polygon.span().end()}; }

/// The cuts of a plane in the order of the polygon's edges, matched with the corners they made.
std::vector<ClipCut> cutsOf(const ClipStep& step, CutStore store)
{
    std::vector<ClipCut> cuts;
    const int n = static_cast<int>(step.before.size());
    int corner = 0; // corners of `after` come in the order of the walk round `before`
    for (int i = 0; i < n; ++i) {
        const int next = (i + 1) % n;
        const bool isInside = step.distances[static_cast<std::size_t>(i)] >= 0;
        const bool nextInside = step.distances[static_cast<std::size_t>(next)] >= 0;
        corner += isInside ? 1 : 0;
        if (isInside == nextInside)
            continue;
        const bool isMoved = step.distances[static_cast<std::size_t>((i + n - 1) % n)] >= 0; // by the cut before
        if (store == CutStore::InPlace && !isInside && isMoved)
            continue;
        ClipCut cut{isInside ? i : next, isInside ? next : i, 0, step.after.empty() ? -1 : corner};
        cut.t = cutParameter(step.distances[static_cast<std::size_t>(cut.inside)],
                             step.distances[static_cast<std::size_t>(cut.outside)]);
        cuts.push_back(cut);
        ++corner;
    }
    return cuts;
}

} // namespace

template <class MakePayload>
void StepRecorder::storeWith(StepEvent event, MakePayload&& makePayload)
{
    auto& payloads = std::get<std::vector<std::invoke_result_t<MakePayload>>>(m_log->m_payloads);
    event.payload = static_cast<std::uint32_t>(payloads.size());
    if (store(event))
        payloads.push_back(makePayload());
}

void StepRecorder::onVertex(std::uint32_t face, int corner, std::uint32_t meshVertex, const ClipVertex& clip)
{
    if (face != m_face)
        beginFaceOf(face);
    if (!isFaceWanted())
        return;
    storeWith(faceEvent(StepKind::Vertex, finiteFlag(clip.positionClip)), [&] {
        const Mesh& mesh = m_scene->mesh;
        return VertexStep{corner,      meshVertex, mesh.vertices[meshVertex].position,
                          mesh.origin, clip,       outcode(clip.positionClip, m_volume).view};
    });
}

void StepRecorder::onFace(std::uint32_t face, FaceFate fate)
{
    if (!m_isResuming)
        m_counter.onFace(face, fate);
    if (!isFaceWanted()) {
        m_gap = true;
        return;
    }
    storeWith(faceEvent(StepKind::Fate, flagIf(fate == FaceFate::NonFinite, StepEvent::kNonFinite)),
              [&] { return FateStep{fate}; });
}

void StepRecorder::onClipPlane(std::uint32_t, ClipPlane plane, const ClipPolygon& before, const ClipPolygon& after)
{
    if (!isFaceWanted())
        return;
    storeWith(faceEvent(StepKind::ClipPlane), [&] {
        ClipStep step{plane, corners(before), corners(after), {}, {}};
        step.distances.assign(before.distances.begin(), before.distances.begin() + before.count);
        step.cuts = cutsOf(step, m_rules.cutStore);
        return step;
    });
}

void StepRecorder::onCohenSutherland(std::uint32_t, const ClipPolygon& before, const ClipPolygon& after)
{
    if (!isFaceWanted())
        return;
    storeWith(faceEvent(StepKind::CohenSutherland), [&] {
        CohenSutherlandStep step{corners(before), corners(after), {}};
        for (const ClipVertex& vertex : step.before)
            step.regions.push_back(screenRegion(vertex.positionClip));
        return step;
    });
}

void StepRecorder::onViewport(std::uint32_t, int corner, const ClipVertex& clip, const ScreenVertex& screen)
{
    if (!isFaceWanted())
        return;
    const glm::dvec4& p = clip.positionClip;
    const glm::dvec2 unsnapped = unsnappedPosition(p, m_rules);
    const std::uint8_t flags = finiteFlag(unsnapped.x, unsnapped.y, screen.depth, screen.invW);
    storeWith(faceEvent(StepKind::Viewport, flags), [&] { return ViewportStep{corner, p, unsnapped, screen}; });
}

void StepRecorder::onClipped(std::uint32_t face, int pieces)
{
    if (!m_isResuming)
        m_counter.onClipped(face, pieces);
    if (!isFaceWanted()) {
        m_gap = true;
        return;
    }
    storeWith(faceEvent(StepKind::Clipped), [&] { return ClippedStep{pieces}; });
}

void StepRecorder::onFacing(std::uint32_t, const FacingDecision& decision)
{
    if (isFaceWanted())
        storeWith(faceEvent(StepKind::Facing, finiteFlag(decision.value)), [&] { return FacingStep{decision}; });
}

void StepRecorder::onTriangle(const ScreenTriangle& triangle)
{
    endTriangle();
    if (m_isResuming)
        m_counter.beginTriangle(triangle);
    else
        m_counter.onTriangle(triangle);
    m_isLine = false;
    m_sample = 0;
    m_now.calls = m_now.callsBeforeLine = 0;
    m_now.line = std::numeric_limits<int>::min();
    m_previousX = m_previousY = -2;
    if (!isFaceWanted()) {
        m_gap = true; // its lines are counted
        return;
    }
    if (m_filter.pixels && !m_triangleKept)
        rollBack(m_triangleMark);
    if (isBeforeWindow())
        shorten(m_geometryMark);
    if (m_filter.pixels) {
        m_triangleMark = mark();
        m_triangleKept = false;
    }
    for (std::size_t i = 0; i < 3; ++i)
        m_invW[i] = triangle.vertices[i].invW;
    if (m_index != nullptr) {
        m_triangle = static_cast<std::uint32_t>(m_now.triangle);
    } else {
        m_triangle = static_cast<std::uint32_t>(m_log->m_triangles.size());
        m_log->m_triangles.push_back({triangle, false, {}});
    }
    storeFaceEvent(StepKind::Triangle);
}

/// The set-up of the triangle, as it lies on the screen: with a pattern it was moved for each sample.
void StepRecorder::keepSetup(StepSetup setup, const PixelRect& bounds)
{
    if (m_rules.multiSampled())
        setup.move(testedOffset(m_rules, m_sample).pixels());
    setup.bounds = bounds;
    m_log->m_triangles.back().hasSetup = true;
    m_log->m_triangles.back().setup = setup;
}

void StepRecorder::onWalk(const WalkedTriangle& walk)
{
    if (isFaceWanted())
        storeWith(faceEvent(StepKind::Walk), [&] { return WalkStep{walk}; });
}

void StepRecorder::onOutline()
{
    if (isFaceWanted())
        storeFaceEvent(StepKind::Outline);
}

void StepRecorder::onSides(const WalkedTriangle& walk)
{
    if (isFaceWanted())
        storeWith(faceEvent(StepKind::Sides), [&] { return SidesStep{walk}; });
}

void StepRecorder::onHalves(const WalkedTriangle& walk, const WalkedHalves& halves)
{
    if (isFaceWanted())
        storeWith(faceEvent(StepKind::Halves, finiteFlag(halves.alpha, halves.x)), [&] {
            return HalvesStep{walk, halves};
        });
}

void StepRecorder::onCrossing(const RowCrossings& row)
{
    if (takeCall() && admit(row.y, row.xBegin, row.xEnd))
        storeWith(sampleEvent(StepKind::Crossing, -1, row.y, finiteFlag(row.alpha, row.beta, row.xa, row.xb)),
                  [&] { return CrossingStep{row}; });
}

void StepRecorder::onSpan(int y, int xBegin, int xEnd, const SpanEnds& ends)
{
    if (!takeCall())
        return;
    m_counter.onSpan(y, xBegin, xEnd, ends);
    if (!admit(y, xBegin, xEnd)) {
        m_gap = true;
        return;
    }
    storeWith(sampleEvent(StepKind::Span, -1, y, finiteFlag(ends.left, ends.right)), [&] {
        return SpanStep{xBegin, xEnd, ends};
    });
}

void StepRecorder::takeSample(int x, int y, const EdgeValues& values, bool covered)
{
    const bool isTaken = takeCall();
    if (m_isResuming && m_now.calls < m_part.from.calls)
        return; // the first that is taken asks for its neighbour, the one before it, and for no other
    if (isTaken)
        m_counter.onSample(x, y, values, covered);
    if (!isRowWanted(y)) {
        m_gap = true;
        return;
    }
    std::array<int, 3> signs;
    for (std::size_t i = 0; i < 3; ++i)
        signs[i] = (values[i] > 0) - (values[i] < 0);
    const bool hasLeft = m_previousX == x - 1 && m_previousY == y;
    const bool changes = hasLeft && signs != m_previousSigns;
    m_previousSigns = signs;
    m_previousX = x;
    m_previousY = y;
    if (!isTaken)
        return;
    if (!admit(y, x, x + 1)) {
        m_gap = true;
        return;
    }
    const bool inside = std::ranges::all_of(signs, [](int sign) { return sign >= 0; });
    const bool onEdge = std::ranges::any_of(signs, [](int sign) { return sign == 0; });
    std::uint8_t flags = finiteFlag(values[0], values[1], values[2]);
    flags |= flagIf(covered, StepEvent::kCovered);
    flags |= flagIf(m_rules.coverageRule == CoverageRule::Centre && inside && onEdge && flags != StepEvent::kNonFinite,
                    StepEvent::kTie);
    flags |= flagIf(changes, StepEvent::kSignChange);
    storeWith(sampleEvent(StepKind::Sample, x, y, flags), [&] { return SampleStep{values}; });
}

void StepRecorder::onColumn(const FilledColumn& column)
{
    if (!takeCall())
        return;
    // A column that meets the pixels that are asked for, or any column where all are.
    const int y = std::clamp(m_samples.y, column.first(), std::max(column.first(), column.last()));
    if (admit(y, column.x, column.x + 1))
        storeWith(sampleEvent(StepKind::Column, column.x, -1), [&] { return ColumnFillStep{column}; });
}

void StepRecorder::onLineDecision(const LineDecision& decision)
{
    if (takeCall() && admit(decision.y, decision.x, decision.x + 1))
        storeWith(sampleEvent(StepKind::LineDecision, decision.x, decision.y), [&] { return LineStep{decision}; });
}

void StepRecorder::onLinePosition(const LinePosition& position)
{
    if (takeCall() && admit(position.row, position.column, position.column + 1))
        storeWith(sampleEvent(StepKind::LinePosition, position.column, position.row),
                  [&] { return LinePositionStep{position}; });
}

void StepRecorder::onLineSample(int x, int y, bool onTarget)
{
    m_counter.onLineSample(x, y, onTarget);
    m_isLine = m_isLine || onTarget;
    if (!admit(y, x, x + 1)) {
        m_gap = true;
        return;
    }
    store(sampleEvent(StepKind::LineSample, x, y, flagIf(onTarget, StepEvent::kCovered)));
}

void StepRecorder::onFragment(const Fragment& fragment, float storedDepth, bool passed)
{
    const std::uint64_t twice = m_counter.statistics().pixels.coveredTwice;
    m_counter.onFragment(fragment, storedDepth, passed);
    const bool isSecondHit = m_counter.statistics().pixels.coveredTwice != twice;
    if (isSecondHit && m_index != nullptr)
        m_index->addDoubleHit(m_counter.statistics().pixels.covered);
    const std::uint32_t sample = sampleIndex(fragment.x, fragment.y);
    std::uint32_t& color = m_planes->color[sample];
    if (!m_planes->coverCount.empty() && m_planes->coverCount[sample] != 0xffff) {
        const std::uint32_t before = m_planes->coverCount[sample]++;
        color = overdrawColor(before + 1);
        const std::int32_t owner = m_planes->owners[sample];
        addEffect({sample, {{overdrawColor(before), storedDepth}, owner}, {{color, storedDepth}, owner}});
    }
    if (!passed && m_rules.depthWrittenOnFail)
        writePixel(fragment.x, fragment.y, {color, storedDepth}, {{color, fragment.depth}, m_planes->owners[sample]});
    if (!admit(fragment.y, fragment.x, fragment.x + 1)) {
        m_gap = true;
        return;
    }
    const bool shaded = passed || !m_rules.depthBeforeShading;
    const bool interpolated = shaded && m_rules.varyingCount > 0;
    const Weights& weights = interpolated ? fragment.weights : fragment.screen;
    double invW = 0;
    for (std::size_t i = 0; i < 3; ++i)
        invW += fragment.screen[i] * m_invW[i];
    std::uint8_t flags = finiteFlag(weights[0], weights[1], weights[2], invW);
    flags |= flagIf(passed, StepEvent::kPassed);
    flags |= flagIf(isSecondHit, StepEvent::kHitTwice);
    flags |= flagIf(!m_planes->ownDepth.empty() && m_planes->ownDepth[sample] != storedDepth, StepEvent::kSharedDepth);
    flags |= flagIf(m_rules.depthInLockstep && m_rules.depthTested && !m_planes->depth.empty() &&
                        m_planes->depth[sample] != storedDepth,
                    StepEvent::kSharedDepth);
    storeWith(sampleEvent(StepKind::Fragment, fragment.x, fragment.y, flags), [&] {
        FragmentStep step{fragment.screen, weights, invW, fragment.depth, storedDepth, {}, shaded};
        if (interpolated)
            std::copy_n(fragment.varyings.begin(), m_rules.varyingCount, step.varyings.begin());
        return step;
    });
}

void StepRecorder::writePixel(int x, int y, Pixel before, const StepEffect::State& after)
{
    const std::uint32_t sample = sampleIndex(x, y);
    if (m_rules.depthPerPixel && m_rules.depthTested && !m_isLine && before.depth != after.pixel.depth)
        m_newDepths.push_back({x, y});
    m_planes->color[sample] = after.pixel.color;
    if (!m_planes->depth.empty())
        m_planes->depth[sample] = after.pixel.depth;
    const std::int32_t ownerBefore = std::exchange(m_planes->owners[sample], after.owner);
    addEffect({sample, {before, ownerBefore}, after});
}

void StepRecorder::onShared(int x, int y, Pixel before, Pixel after)
{
    writePixel(x, y, before, {after, m_planes->owners[sampleIndex(x, y)]});
}

void StepRecorder::onShade(const Fragment& fragment, std::uint32_t color)
{
    m_counter.onShade(fragment, color);
    if (!admit(fragment.y, fragment.x, fragment.x + 1)) {
        m_gap = true;
        return;
    }
    storeWith(sampleEvent(StepKind::Shade, fragment.x, fragment.y), [&] { return ShadeStep{color}; });
}

void StepRecorder::onWrite(int x, int y, Pixel before, Pixel after)
{
    m_counter.onWrite(x, y, before, after);
    const std::uint32_t sample = sampleIndex(x, y);
    if (!m_planes->coverCount.empty()) // the picture shows how often a sample was covered, whatever is written
        before.color = after.color = overdrawColor(m_planes->coverCount[sample]);
    if (!m_planes->ownDepth.empty())
        m_planes->ownDepth[sample] = after.depth;
    writePixel(x, y, before, {after, static_cast<std::int32_t>(m_face)});
    if (!admit(y, x, x + 1)) {
        m_gap = true;
        return;
    }
    storeWith(sampleEvent(StepKind::Write, x, y), [&] { return WriteStep{before, after}; });
}

/// A pixel in which nothing was drawn has a step only where the filter asks for it.
void StepRecorder::onResolve(const ResolvedPixel& pixel)
{
    endTriangle(); // the last one
    leaveFaces();
    m_sample = -1;
    const auto isCleared = [&](const Pixel& sample) { return sample == m_log->m_clear; };
    const auto samples = std::span(pixel.samples).first(static_cast<std::size_t>(pixel.count));
    const int grid = m_rules.sampleGrid;
    const int x = pixel.x * grid;
    const int y = pixel.y * grid;
    const bool isAsked = m_filter.pixels && x >= m_samples.x && x < m_samples.x + m_samples.width && y >= m_samples.y &&
                         y < m_samples.y + m_samples.height;
    const bool isWanted = m_filter.pixels ? isAsked : !std::ranges::all_of(samples, isCleared);
    if (isWanted && !m_filter.face && !m_full)
        storeWith(sampleEvent(StepKind::Resolve, x, y), [&] { return ResolveStep{pixel}; });
}

} // namespace rasterlens
