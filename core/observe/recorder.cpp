#include "core/observe/recorder.h"

#include "core/base/pieces.h"
#include "core/pipeline/shading.h"
#include "core/pipeline/unsnapped.h"

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

/// 320 MB: a log whose events lie far apart holds what happened in between.
constexpr std::size_t kMaxEffects = std::size_t(1) << 24;

template <class... Number>
std::uint8_t finiteFlag(Number... numbers)
{
    return (std::isfinite(numbers) && ...) ? std::uint8_t(0) : StepEvent::kNonFinite;
}

std::uint8_t finiteFlag(const glm::dvec4& p) { return finiteFlag(p.x, p.y, p.z, p.w); }

std::uint8_t flagIf(bool condition, std::uint8_t flag) { return condition ? flag : std::uint8_t(0); }

std::vector<ClipVertex> corners(const ClipPolygon& polygon) { return {polygon.span().begin(), polygon.span().end()}; }

/// The cuts of a plane in the order of the polygon's edges, matched with the corners they made.
std::vector<ClipCut> cutsOf(const ClipStep& step)
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
        ClipCut cut{isInside ? i : next, isInside ? next : i, 0, step.after.empty() ? -1 : corner};
        cut.t = cutParameter(step.distances[static_cast<std::size_t>(cut.inside)],
                             step.distances[static_cast<std::size_t>(cut.outside)]);
        cuts.push_back(cut);
        ++corner;
    }
    return cuts;
}

} // namespace

StepRecorder::StepRecorder(const Scene& scene, const Resolved& resolved, const StepFilter& filter,
                           std::stop_source full)
    : m_scene(&scene), m_rules(resolved.rules), m_filter(filter), m_volume(clipVolume(m_rules)),
      m_stopDrawing(std::move(full)), m_log(std::make_shared<StepLog>()), m_counter(m_rules)
{
    const Rules& rules = m_rules;
    m_log->m_filter = filter;
    m_log->m_rules = rules;
    m_log->m_rightRules = resolved.right;
    m_log->m_mistakes = resolved.mistakes;
    const bool overdraw = rules.shading == Shading::Overdraw;
    m_log->m_clear = {overdraw ? overdrawColor(0) : packColor(scene.background), rules.depthClear};
    m_log->m_checkpoints.push_back({});
    m_stride = rules.strideIsRows ? rules.rows() : rules.columns();
    const std::size_t samples = std::size_t(std::max(rules.columns(), m_stride)) * std::size_t(rules.rows());
    m_log->m_sampleCount = samples;
    const std::stop_token stop = m_stopDrawing.get_token(); // then nothing is drawn
    assignInPieces(m_lastEffect, samples, std::uint32_t(0), stop);
    assignInPieces(m_color, samples, m_log->m_clear.color, stop);
    if (overdraw)
        m_coverCount.resize(samples);
    if (rules.depthPerPixel)
        m_ownDepth.assign(samples, rules.depthClear);
    if (filter.pixels) {
        const PixelRect& p = *filter.pixels;
        m_samples = {p.x * rules.sampleGrid, p.y * rules.sampleGrid, p.width * rules.sampleGrid,
                     p.height * rules.sampleGrid};
    }
}

StepRecorder::Mark StepRecorder::mark() const
{
    Mark mark;
    mark.events = m_log->m_events.size();
    mark.triangles = m_log->m_triangles.size();
    std::size_t i = 0;
    std::apply([&](const auto&... payloads) { ((mark.payloads[i++] = payloads.size()), ...); }, m_log->m_payloads);
    return mark;
}

void StepRecorder::rollBack(const Mark& mark)
{
    const bool hasEvents = m_log->m_events.size() > mark.events;
    const std::size_t firstOwn = hasEvents ? m_log->m_events[mark.events].effects : m_log->m_effects.size();
    m_log->m_events.resize(mark.events);
    m_log->m_triangles.resize(mark.triangles);
    std::size_t i = 0;
    const auto shorten = [&](auto& payloads) {
        payloads.erase(payloads.begin() + static_cast<std::ptrdiff_t>(mark.payloads[i++]), payloads.end());
    };
    std::apply([&](auto&... payloads) { (shorten(payloads), ...); }, m_log->m_payloads);
    while (m_log->m_checkpoints.back().position > mark.events)
        m_log->m_checkpoints.pop_back();
    m_gap = m_gap || hasEvents;
    // What happened since belongs to the next stored event: one effect a sample is enough.
    const std::vector<StepEffect> later(m_log->m_effects.begin() + static_cast<std::ptrdiff_t>(firstOwn),
                                        m_log->m_effects.end());
    m_log->m_effects.resize(firstOwn);
    for (const StepEffect& effect : later)
        addEffect(effect);
}

void StepRecorder::dropPending()
{
    if (!m_filter.pixels || m_full)
        return;
    if (!m_triangleKept)
        rollBack(m_triangleMark);
    if (!m_faceKept)
        rollBack(m_faceMark);
}

void StepRecorder::beginFace(std::uint32_t face)
{
    dropPending();
    m_face = face;
    m_triangle = StepEvent::kNone;
    m_faceKept = false;
    m_triangleKept = true;
    if (m_filter.pixels)
        m_faceMark = mark();
}

void StepRecorder::leaveFaces()
{
    dropPending();
    m_face = m_triangle = StepEvent::kNone;
    m_faceKept = m_triangleKept = true;
}

bool StepRecorder::admit(int y, int xBegin, int xEnd)
{
    if (!isFaceWanted())
        return false;
    if (!m_filter.pixels)
        return true;
    if (!isRowWanted(y) || xEnd <= m_samples.x || xBegin >= m_samples.x + m_samples.width)
        return false;
    const bool wasPending = isPending();
    m_faceKept = m_triangleKept = true;
    if (wasPending && m_log->m_events.size() > m_filter.cap) {
        m_log->m_events.resize(m_filter.cap);
        while (m_log->m_checkpoints.back().position > m_filter.cap)
            m_log->m_checkpoints.pop_back();
        setFull();
    }
    return !m_full;
}

void StepRecorder::setFull()
{
    m_full = true;
    m_log->m_truncated = true;
    m_stopDrawing.request_stop();
}

StepEvent StepRecorder::faceEvent(StepKind kind, std::uint8_t flags) const
{
    StepEvent event;
    event.kind = kind;
    event.flags = flags;
    event.face = m_face;
    event.triangle = m_triangle;
    return event;
}

StepEvent StepRecorder::sampleEvent(StepKind kind, int x, int y, std::uint8_t flags) const
{
    StepEvent event = faceEvent(kind, flags);
    event.x = x;
    event.y = y;
    return event;
}

void StepRecorder::storeFaceEvent(StepKind kind, std::uint8_t flags) { store(faceEvent(kind, flags)); }

template <class Payload>
void StepRecorder::storePayload(StepEvent event, Payload&& payload)
{
    auto& payloads = std::get<std::vector<std::decay_t<Payload>>>(m_log->m_payloads);
    event.payload = static_cast<std::uint32_t>(payloads.size());
    const std::size_t before = m_log->m_events.size();
    store(event);
    if (m_log->m_events.size() > before)
        payloads.push_back(std::forward<Payload>(payload));
}

void StepRecorder::store(StepEvent event)
{
    if (m_full || (m_filter.kinds & kindBit(event.kind)) == 0) {
        m_gap = true;
        return;
    }
    if (m_log->m_events.size() >= m_filter.cap && !isPending()) {
        setFull();
        return;
    }
    event.effects = static_cast<std::uint32_t>(m_log->m_effects.size());
    m_log->m_events.push_back(event);
    const std::size_t position = m_log->m_events.size();
    if (m_gap || position - m_log->m_checkpoints.back().position >= StepLog::kCheckpointEvents)
        m_log->m_checkpoints.push_back({static_cast<std::uint32_t>(position), m_counter.statistics()});
    m_gap = false;
}

void StepRecorder::addEffect(const StepEffect& effect)
{
    if (m_full)
        return;
    std::vector<StepEffect>& effects = m_log->m_effects;
    std::uint32_t& last = m_lastEffect[effect.sample];
    if (last >= gapBegin() && last < effects.size() && effects[last].sample == effect.sample) {
        effects[last].after = effect.after;
        return;
    }
    if (effects.size() >= kMaxEffects) {
        setFull();
        return;
    }
    last = static_cast<std::uint32_t>(effects.size());
    effects.push_back(effect);
}

void StepRecorder::onVertex(std::uint32_t face, int corner, std::uint32_t meshVertex, const ClipVertex& clip)
{
    if (face != m_face)
        beginFace(face);
    if (!isFaceWanted())
        return;
    storePayload(faceEvent(StepKind::Vertex, finiteFlag(clip.positionClip)),
                 VertexStep{corner, meshVertex, m_scene->mesh.vertices[meshVertex].position, m_scene->mesh.origin, clip,
                            outcode(clip.positionClip, m_volume).view});
}

void StepRecorder::onFace(std::uint32_t face, FaceFate fate)
{
    m_counter.onFace(face, fate);
    if (!isFaceWanted()) {
        m_gap = true;
        return;
    }
    storePayload(faceEvent(StepKind::Fate, flagIf(fate == FaceFate::NonFinite, StepEvent::kNonFinite)), FateStep{fate});
}

void StepRecorder::onClipPlane(std::uint32_t, ClipPlane plane, const ClipPolygon& before, const ClipPolygon& after)
{
    if (!isFaceWanted())
        return;
    ClipStep step{plane, corners(before), corners(after), {}, {}};
    step.distances.assign(before.distances.begin(), before.distances.begin() + before.count);
    step.cuts = cutsOf(step);
    storePayload(faceEvent(StepKind::ClipPlane), std::move(step));
}

void StepRecorder::onCohenSutherland(std::uint32_t, const ClipPolygon& before, const ClipPolygon& after)
{
    if (!isFaceWanted())
        return;
    CohenSutherlandStep step{corners(before), corners(after), {}};
    for (const ClipVertex& vertex : step.before)
        step.regions.push_back(screenRegion(vertex.positionClip));
    storePayload(faceEvent(StepKind::CohenSutherland), std::move(step));
}

void StepRecorder::onViewport(std::uint32_t, int corner, const ClipVertex& clip, const ScreenVertex& screen)
{
    if (!isFaceWanted())
        return;
    const glm::dvec4& p = clip.positionClip;
    const glm::dvec2 unsnapped = unsnappedPosition(p, m_rules);
    const std::uint8_t flags = finiteFlag(unsnapped.x, unsnapped.y, screen.depth, screen.invW);
    storePayload(faceEvent(StepKind::Viewport, flags), ViewportStep{corner, p, unsnapped, screen});
}

void StepRecorder::onClipped(std::uint32_t face, int pieces)
{
    m_counter.onClipped(face, pieces);
    if (!isFaceWanted()) {
        m_gap = true;
        return;
    }
    storePayload(faceEvent(StepKind::Clipped), ClippedStep{pieces});
}

void StepRecorder::onFacing(std::uint32_t, const FacingDecision& decision)
{
    if (isFaceWanted())
        storePayload(faceEvent(StepKind::Facing, finiteFlag(decision.value)), FacingStep{decision});
}

void StepRecorder::onTriangle(const ScreenTriangle& triangle)
{
    m_counter.onTriangle(triangle);
    m_previousX = m_previousY = -2;
    if (!isFaceWanted())
        return;
    if (m_filter.pixels) {
        if (!m_triangleKept)
            rollBack(m_triangleMark);
        m_triangleMark = mark();
        m_triangleKept = false;
    }
    for (std::size_t i = 0; i < 3; ++i)
        m_invW[i] = triangle.vertices[i].invW;
    m_triangle = static_cast<std::uint32_t>(m_log->m_triangles.size());
    m_log->m_triangles.push_back({triangle, false, {}});
    storeFaceEvent(StepKind::Triangle);
}

void StepRecorder::onWalk(const WalkedTriangle& walk)
{
    if (isFaceWanted())
        storePayload(faceEvent(StepKind::Walk), WalkStep{walk});
}

void StepRecorder::onOutline()
{
    if (isFaceWanted())
        storeFaceEvent(StepKind::Outline);
}

void StepRecorder::onSides(const WalkedTriangle& walk)
{
    if (isFaceWanted())
        storePayload(faceEvent(StepKind::Sides), SidesStep{walk});
}

void StepRecorder::onHalves(const WalkedTriangle& walk, const WalkedHalves& halves)
{
    if (isFaceWanted())
        storePayload(faceEvent(StepKind::Halves, finiteFlag(halves.alpha, halves.x)), HalvesStep{walk, halves});
}

void StepRecorder::onCrossing(const RowCrossings& row)
{
    if (admit(row.y, row.xBegin, row.xEnd))
        storePayload(sampleEvent(StepKind::Crossing, -1, row.y, finiteFlag(row.alpha, row.beta, row.xa, row.xb)),
                     CrossingStep{row});
}

void StepRecorder::onSpan(int y, int xBegin, int xEnd, const SpanEnds& ends)
{
    m_counter.onSpan(y, xBegin, xEnd, ends);
    if (!admit(y, xBegin, xEnd)) {
        m_gap = true;
        return;
    }
    storePayload(sampleEvent(StepKind::Span, -1, y, finiteFlag(ends.left, ends.right)), SpanStep{xBegin, xEnd, ends});
}

void StepRecorder::onSample(int x, int y, const EdgeValues& values, bool covered)
{
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
    if (!admit(y, x, x + 1)) {
        m_gap = true;
        return;
    }
    const bool inside = std::ranges::all_of(signs, [](int sign) { return sign >= 0; });
    const bool onEdge = std::ranges::any_of(signs, [](int sign) { return sign == 0; });
    std::uint8_t flags = finiteFlag(values[0], values[1], values[2]);
    flags |= flagIf(covered, StepEvent::kCovered);
    flags |= flagIf(inside && onEdge && flags != StepEvent::kNonFinite, StepEvent::kTie);
    flags |= flagIf(changes, StepEvent::kSignChange);
    storePayload(sampleEvent(StepKind::Sample, x, y, flags), SampleStep{values});
}

void StepRecorder::onColumn(const FilledColumn& column)
{
    // A column that meets the pixels that are asked for, or any column where all are.
    const int y = std::clamp(m_samples.y, column.first(), std::max(column.first(), column.last()));
    if (admit(y, column.x, column.x + 1))
        storePayload(sampleEvent(StepKind::Column, column.x, -1), ColumnFillStep{column});
}

void StepRecorder::onLineDecision(const LineDecision& decision)
{
    if (admit(decision.y, decision.x, decision.x + 1))
        storePayload(sampleEvent(StepKind::LineDecision, decision.x, decision.y), LineStep{decision});
}

void StepRecorder::onLineSample(int x, int y, bool onTarget)
{
    m_counter.onLineSample(x, y, onTarget);
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
    const std::uint32_t sample = sampleIndex(fragment.x, fragment.y);
    if (!m_coverCount.empty() && m_coverCount[sample] != 0xffff) {
        const std::uint32_t before = m_coverCount[sample]++;
        m_color[sample] = overdrawColor(before + 1);
        addEffect({sample, {overdrawColor(before), storedDepth}, {m_color[sample], storedDepth}});
    }
    if (!passed && m_rules.depthWrittenOnFail)
        addEffect({sample, {m_color[sample], storedDepth}, {m_color[sample], fragment.depth}});
    if (!admit(fragment.y, fragment.x, fragment.x + 1)) {
        m_gap = true;
        return;
    }
    const bool shaded = passed || !m_rules.depthBeforeShading;
    const bool interpolated = shaded && m_rules.varyingCount > 0;
    FragmentStep step{
        fragment.screen, interpolated ? fragment.weights : fragment.screen, 0, fragment.depth, storedDepth, {}, shaded};
    for (std::size_t i = 0; i < 3; ++i)
        step.invW += fragment.screen[i] * m_invW[i];
    if (interpolated)
        std::copy_n(fragment.varyings.begin(), m_rules.varyingCount, step.varyings.begin());
    std::uint8_t flags = finiteFlag(step.weights[0], step.weights[1], step.weights[2], step.invW);
    flags |= flagIf(passed, StepEvent::kPassed);
    flags |= flagIf(m_counter.statistics().pixels.coveredTwice != twice, StepEvent::kHitTwice);
    flags |= flagIf(!m_ownDepth.empty() && m_ownDepth[sample] != storedDepth, StepEvent::kSharedDepth);
    storePayload(sampleEvent(StepKind::Fragment, fragment.x, fragment.y, flags), step);
}

void StepRecorder::onShade(const Fragment& fragment, std::uint32_t color)
{
    m_counter.onShade(fragment, color);
    if (!admit(fragment.y, fragment.x, fragment.x + 1)) {
        m_gap = true;
        return;
    }
    storePayload(sampleEvent(StepKind::Shade, fragment.x, fragment.y), ShadeStep{color});
}

void StepRecorder::onWrite(int x, int y, Pixel before, Pixel after)
{
    m_counter.onWrite(x, y, before, after);
    const std::uint32_t sample = sampleIndex(x, y);
    if (!m_coverCount.empty()) // the picture shows how often a sample was covered, whatever is written
        before.color = after.color = overdrawColor(m_coverCount[sample]);
    m_color[sample] = after.color;
    if (!m_ownDepth.empty())
        m_ownDepth[sample] = after.depth;
    addEffect({sample, before, after});
    if (!admit(y, x, x + 1)) {
        m_gap = true;
        return;
    }
    storePayload(sampleEvent(StepKind::Write, x, y), WriteStep{before, after});
}

/// A pixel in which nothing was drawn has a step only where the filter asks for it.
void StepRecorder::onResolve(const ResolvedPixel& pixel)
{
    leaveFaces();
    const auto isCleared = [&](const Pixel& sample) { return sample == m_log->m_clear; };
    const auto samples = std::span(pixel.samples).first(static_cast<std::size_t>(pixel.count));
    const int grid = m_rules.sampleGrid;
    const int x = pixel.x * grid;
    const int y = pixel.y * grid;
    const bool isAsked = m_filter.pixels && x >= m_samples.x && x < m_samples.x + m_samples.width && y >= m_samples.y &&
                         y < m_samples.y + m_samples.height;
    const bool isWanted = m_filter.pixels ? isAsked : !std::ranges::all_of(samples, isCleared);
    if (isWanted && !m_filter.face && !m_full)
        storePayload(sampleEvent(StepKind::Resolve, x, y), ResolveStep{pixel});
}

std::shared_ptr<const StepLog> StepRecorder::finish(bool stopped, const QImage& picture)
{
    dropPending();
    StepLog& log = *m_log;
    log.m_stopped = stopped && !m_full;
    log.m_faceLines = m_scene->mesh.faceLine;
    if (m_full || stopped) {
        log.m_effects.resize(gapBegin());
    } else {
        m_filter = {};
        m_filter.cap = log.m_events.size() + 1;
        m_face = m_triangle = StepEvent::kNone;
        storeFaceEvent(StepKind::End);
    }
    if (m_rules.resolve != Resolve::AllSamples)
        log.m_finished = picture;
    for (std::size_t i = 0; i < log.m_events.size(); ++i)
        log.m_byKind[static_cast<std::size_t>(log.m_events[i].kind)].push_back(static_cast<std::uint32_t>(i));
    return std::move(m_log);
}

} // namespace rasterlens
