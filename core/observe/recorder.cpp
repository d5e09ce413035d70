#include "core/observe/recorder.h"

#include <algorithm>
#include <utility>

namespace rasterlens
{
namespace
{

/// 320 MB: a log whose events lie far apart holds what happened in between.
constexpr std::size_t kMaxEffects = std::size_t(1) << 24;

/// Whether events of this kind are what a face and its triangle have come to before coverage begins.
bool isContext(StepKind kind) { return infoOf(kind).phase < infoOf(StepKind::Sample).phase; }

} // namespace

StepRecorder::StepRecorder(const Scene& scene, const Resolved& resolved, const StepFilter& filter, FramePlanes& planes,
                           std::stop_source full)
    : m_scene(&scene), m_rules(resolved.rules), m_filter(filter), m_volume(clipVolume(m_rules)),
      m_stopDrawing(std::move(full)), m_planes(&planes), m_log(std::make_shared<StepLog>()), m_counter(m_rules)
{
    const Rules& rules = m_rules;
    m_part.last = filter.cap;
    m_log->m_filter = filter;
    m_log->m_rules = rules;
    m_log->m_rightRules = resolved.right;
    m_log->m_mistakes = resolved.mistakes;
    m_log->m_clear = clearedPixel(scene, rules);
    m_log->m_checkpoints.push_back({});
    m_log->m_sampleCount = storedSamples(rules);
    m_stride = rules.strideIsRows ? rules.rows() : rules.columns();
    m_mergesEffects = filter.face || filter.pixels || filter.kinds != kAllSteps;
    if (filter.pixels) {
        const PixelRect& p = *filter.pixels;
        m_samples = {p.x * rules.sampleGrid, p.y * rules.sampleGrid, p.width * rules.sampleGrid,
                     p.height * rules.sampleGrid};
    }
}

StepRecorder::StepRecorder(const Scene& scene, const Resolved& resolved, const StepFilter& filter, FramePlanes& planes,
                           std::stop_source full, const RecordedPart& part)
    : StepRecorder(scene, resolved, filter, planes, std::move(full))
{
    m_isWindow = true;
    m_part = part;
    m_position = part.from.position;
    m_isResuming = part.from.isWithinFace();
    m_counter = CountingObserver(m_rules, part.from.statistics, part.doubleHits);
    m_log->m_first = part.first;
    if (part.first == 0)
        beginWindow();
}

StepRecorder::StepRecorder(const Scene& scene, const Resolved& resolved, const StepFilter& filter, FramePlanes& planes,
                           std::stop_source full, std::size_t mostEvents, StepIndex& index)
    : StepRecorder(scene, resolved, filter, planes, std::move(full))
{
    m_index = &index;
    m_part.last = mostEvents;
}

StepRecorder::Mark StepRecorder::mark() const
{
    Mark mark;
    mark.position = m_position;
    mark.events = m_index != nullptr ? m_pending.size() : m_log->m_events.size();
    mark.triangles = m_log->m_triangles.size();
    std::size_t i = 0;
    std::apply([&](const auto&... payloads) { ((mark.payloads[i++] = payloads.size()), ...); }, m_log->m_payloads);
    return mark;
}

/// Takes back what was stored in the log since, but for its effects.
void StepRecorder::shorten(const Mark& mark)
{
    m_log->m_events.resize(mark.events);
    m_log->m_triangles.resize(mark.triangles);
    std::size_t i = 0;
    const auto cut = [&](auto& payloads) {
        payloads.erase(payloads.begin() + static_cast<std::ptrdiff_t>(mark.payloads[i++]), payloads.end());
    };
    std::apply([&](auto&... payloads) { (cut(payloads), ...); }, m_log->m_payloads);
    while (m_log->m_checkpoints.size() > 1 && m_log->m_checkpoints.back().position > mark.events)
        m_log->m_checkpoints.pop_back();
}

void StepRecorder::rollBack(const Mark& mark)
{
    m_gap = m_gap || m_position > mark.position;
    m_position = mark.position;
    if (m_index != nullptr) {
        m_pending.resize(mark.events);
        return;
    }
    const bool hasEvents = m_log->m_events.size() > mark.events;
    const std::size_t firstOwn = hasEvents ? m_log->m_events[mark.events].effects : m_log->m_effects.size();
    shorten(mark);
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
    m_faceKept = m_triangleKept = true; // nothing is pending any more
}

void StepRecorder::beginFaceOf(std::uint32_t face)
{
    dropPending();
    m_face = face;
    m_sample = 0;
    m_triangle = StepEvent::kNone;
    m_faceKept = false;
    m_triangleKept = true;
    if (isBeforeWindow())
        shorten({});
    if (m_filter.pixels)
        m_faceMark = mark();
}

void StepRecorder::leaveFaces()
{
    dropPending();
    m_face = m_triangle = StepEvent::kNone;
    m_faceKept = m_triangleKept = true;
}

void StepRecorder::beginFace(std::size_t nth, std::uint32_t face)
{
    dropPending();
    m_now = {};
    m_now.face = nth;
    const bool isSecondOfPair = m_rules.depthInLockstep && face % 2 == 1; // it goes by what the first one has read
    if (m_index != nullptr && m_index->wantsPoint(++m_work) && !isSecondOfPair)
        keepPoint(m_now);
}

bool StepRecorder::takeTriangle(std::size_t nth)
{
    if (nth == 0)
        m_geometryMark = mark();
    m_now.triangle = nth;
    return !m_isResuming || nth >= m_part.from.triangle;
}

bool StepRecorder::skipsLine(int line)
{
    if (m_isResuming && line < m_part.from.line)
        return true;
    if (m_isResuming && line == m_part.from.line)
        m_now.calls = m_part.from.callsBeforeLine;
    m_now.line = line;
    m_now.callsBeforeLine = m_now.calls;
    return false;
}

void StepRecorder::beginPass(int sample)
{
    m_isPassKnown = skipsLine(sample);
    m_previousX = m_previousY = -2; // of another pass
}

bool StepRecorder::takeCall()
{
    if (m_isPassKnown)
        return false;
    ++m_now.calls;
    if (m_isResuming && m_now.calls <= m_part.from.calls)
        return false;
    if (std::exchange(m_isResuming, false))
        m_faceKept = m_triangleKept = true;
    // Where the samples of a pixel are to share a depth at the end of the triangle, none but this end is a moment to
    // draw on from.
    if (m_index != nullptr && m_index->wantsPoint(++m_work) && m_now.calls > 1 && !m_rules.depthPerPixel &&
        !m_rules.depthInLockstep && !isPending()) {
        ResumePoint before = m_now;
        --before.calls;
        keepPoint(before);
    }
    return !m_full || !m_isWindow;
}

bool StepRecorder::takePixel(int x, int y)
{
    if (!takeCall())
        return false;
    const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(m_stride);
    m_planes->make(m_planes->layout.of(first + static_cast<std::size_t>(x)));
    return true;
}

void StepRecorder::beginPixel(std::size_t nth)
{
    leaveFaces();
    if (m_planes->layout.hasPixels)
        m_planes->make(m_planes->layout.of(nth));
    m_now = {};
    m_now.resolves = true;
    m_now.calls = nth;
    if (m_index != nullptr && m_index->wantsPoint(++m_work))
        keepPoint(m_now);
}

void StepRecorder::keepPoint(const ResumePoint& now)
{
    ResumePoint point = now;
    point.position = m_position;
    point.statistics = m_counter.statistics();
    m_index->addPoint(point, m_work, *m_planes);
}

void StepRecorder::endTriangle()
{
    for (const auto& [x, y] : m_newDepths)
        shareDepth(x, y);
    m_newDepths.clear();
}

/// Copies the depth of a sample to the others of its pixel, as SampleRouter does.
void StepRecorder::shareDepth(int x, int y)
{
    const int grid = m_rules.sampleGrid;
    const int left = x / grid * grid;
    const int top = y / grid * grid;
    const float depth = m_planes->depth[sampleIndex(x, y)];
    for (int row = top; row < top + grid; ++row)
        for (int column = left; column < left + grid; ++column) {
            const std::uint32_t sample = sampleIndex(column, row);
            const std::int32_t owner = m_planes->owners[sample];
            const Pixel before{m_planes->color[sample], m_planes->depth[sample]};
            m_planes->depth[sample] = depth;
            if (before.depth != depth)
                addEffect({sample, {before, owner}, {{before.color, depth}, owner}});
        }
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
    for (const StepEvent& event : m_pending)
        m_index->add(event);
    m_pending.clear();
    if (wasPending && m_position >= m_part.last)
        cutAtEnd();
    return !m_full;
}

/// Ends the log at its last event; there may be more, which might have been taken back.
void StepRecorder::cutAtEnd()
{
    const std::size_t over = m_position - m_part.last;
    if (over == 0 && !m_isWindow)
        return; // whether it is cut off, the next event tells
    std::vector<StepEvent>& events = m_log->m_events;
    events.resize(events.size() - std::min(over, events.size()));
    while (m_log->m_checkpoints.size() > 1 && m_log->m_checkpoints.back().position > events.size())
        m_log->m_checkpoints.pop_back();
    m_position = m_part.last;
    setFull();
}

void StepRecorder::setFull()
{
    m_full = true;
    m_log->m_truncated = !m_isWindow;
    m_stopDrawing.request_stop();
}

void StepRecorder::beginWindow()
{
    m_log->m_lead = m_log->m_events.size();
    m_log->m_effects.clear();
    m_log->m_checkpoints = {{static_cast<std::uint32_t>(m_log->m_lead), m_counter.statistics()}};
    m_gap = false;
}

StepEvent StepRecorder::faceEvent(StepKind kind, std::uint8_t flags) const
{
    StepEvent event;
    event.kind = kind;
    event.flags = flags;
    event.face = m_face;
    event.triangle = m_triangle;
    event.sample = static_cast<std::int8_t>(m_sample);
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

bool StepRecorder::store(StepEvent event)
{
    if (m_full || (m_filter.kinds & kindBit(event.kind)) == 0) {
        m_gap = true;
        return false;
    }
    if (m_position >= m_part.last && !isPending() && !m_isResuming) {
        setFull();
        return false;
    }
    if (m_index == nullptr)
        return storeInLog(event);
    ++m_position;
    if (isPending())
        m_pending.push_back(event);
    else
        m_index->add(event);
    return false;
}

bool StepRecorder::storeInLog(StepEvent event)
{
    const bool isBefore = isBeforeWindow();
    m_position += m_isResuming ? 0 : 1;
    const bool isStored = !isBefore || isContext(event.kind);
    if (isStored) {
        event.effects = static_cast<std::uint32_t>(m_log->m_effects.size());
        m_log->m_events.push_back(event);
    }
    if (isBefore) {
        if (!m_isResuming && m_position == m_part.first)
            beginWindow();
        return isStored;
    }
    const std::size_t position = m_log->m_events.size();
    if (m_gap || position - m_log->m_checkpoints.back().position >= StepLog::kCheckpointEvents)
        m_log->m_checkpoints.push_back({static_cast<std::uint32_t>(position), m_counter.statistics()});
    m_gap = false;
    if (m_isWindow && !isPending() && (m_position >= m_part.last || m_log->m_effects.size() >= m_part.mostEffects))
        setFull();
    return true;
}

void StepRecorder::addEffect(const StepEffect& effect)
{
    if (m_index != nullptr)
        m_index->touch(effect.sample);
    m_planes->touch(effect.sample);
    // What a window draws after its end is taken back, so it has to be known.
    if (m_index != nullptr || isBeforeWindow() || (m_full && !m_isWindow))
        return;
    std::vector<StepEffect>& effects = m_log->m_effects;
    if (m_mergesEffects) {
        m_lastEffect.resize(m_log->m_sampleCount);
        std::uint32_t& last = m_lastEffect[effect.sample];
        if (last >= gapBegin() && last < effects.size() && effects[last].sample == effect.sample) {
            effects[last].after = effect.after;
            return;
        }
        last = static_cast<std::uint32_t>(effects.size());
    }
    if (effects.size() >= kMaxEffects && !m_isWindow)
        setFull();
    else
        effects.push_back(effect);
}

std::shared_ptr<const StepLog> StepRecorder::finish(bool stopped, const QImage& picture)
{
    m_sample = 0; // of the grid: a pixel that was resolved had none
    endTriangle();
    dropPending();
    StepLog& log = *m_log;
    log.m_stopped = stopped && !m_full;
    log.m_faceLines = m_scene->mesh.faceLine;
    if (m_full || stopped) {
        for (std::size_t i = log.m_effects.size(); m_isWindow && i-- > gapBegin();)
            m_planes->put(log.m_effects[i].sample, log.m_effects[i].before);
        log.m_effects.resize(gapBegin());
    } else {
        m_filter = {};
        m_part.last = StepIndex::kMostPositions + 1;
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
