#include "ui/steps/step_session.h"

#include "core/render/render.h"

#include <algorithm>
#include <array>
#include <new>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kTickMs = 16;
/// So many events are recorded in a tenth of a second.
constexpr std::size_t kBeginning = std::size_t(1) << 20;

} // namespace

StepSession::StepSession(Document& document, QObject* parent)
    : QObject(parent), m_document(document),
      m_result([this](Recorded recorded) { take(std::move(recorded)); }, [this](Lack lack) { giveUp(lack); })
{
    m_clock.setInterval(kTickMs);
    m_clock.setTimerType(Qt::PreciseTimer);
    connect(&m_clock, &QTimer::timeout, this, &StepSession::advance);
    connect(&m_document, &Document::settingsChanged, this, [this] {
        if (m_scene != m_document.scene())
            drop();
        recordAnew();
    });
}

void StepSession::open()
{
    if (m_open)
        return;
    m_open = true;
    Q_EMIT openChanged(true);
    recordAnew();
}

void StepSession::close()
{
    if (!m_open)
        return;
    m_open = false;
    m_putOff = {};
    m_result.drop();
    drop();
    syncRecording();
    Q_EMIT openChanged(false);
}

StepFilter StepSession::filter() const
{
    constexpr StepKinds kGeometry = kindBit(StepKind::Triangle) - 1; // all kinds before
    constexpr StepKinds kCoverage = (kindBit(StepKind::Fragment) - 1) & ~kGeometry;
    StepFilter filter;
    filter.cap = kBeginning;
    switch (m_scope) {
    case StepScope::Frame: break;
    case StepScope::Geometry: filter.kinds = kGeometry; break;
    case StepScope::Coverage: filter.kinds = kCoverage; break;
    case StepScope::SelectedFace: filter.face = m_selectedFace; break;
    case StepScope::Rectangle: filter.pixels = m_rectangle; break;
    case StepScope::SelectedPixel:
        if (m_selectedPixel)
            filter.pixels = PixelRect{m_selectedPixel->x(), m_selectedPixel->y(), 1, 1};
        break;
    }
    return filter;
}

void StepSession::recordAnew()
{
    if (!m_open)
        return;
    m_isBeginning = false;
    m_putOff = {};
    if (unsupported(*m_document.scene(), m_document.settings())) {
        m_result.drop();
        drop();
        syncRecording();
        return;
    }
    const auto record = [scene = m_document.scene(), settings = m_document.settings(),
                         filter = filter()](const auto& turn) -> Recorded {
        auto beginning = recordBeginning(scene, settings, filter, turn.stop());
        if (!beginning->truncated())
            return {std::move(beginning)};
        turn.deliver({std::move(beginning), true});
        return {recordSteps(scene, settings, filter, turn.stop())};
    };
    m_result.ask(record, LatestJob::Running::Interrupt);
    syncRecording();
}

void StepSession::giveUp(Lack lack)
{
    drop(); // the former record is one of other settings
    syncRecording();
    Q_EMIT failed(lack == Lack::Memory ? tr("There is not enough memory to record this frame.")
                                       : tr("This frame was not recorded: %1.").arg(lackText(lack)));
}

void StepSession::take(Recorded recorded)
{
    const std::size_t position = this->position();
    m_scene = m_document.scene();
    m_settings = recordedAs(m_document.settings());
    m_lookedAt = {};
    m_coverage.reset();
    m_finder.reset();
    m_cursor.reset();
    m_record = std::move(recorded.record);
    m_isBeginning = recorded.isBeginning;
    ++m_recordNumber;
    try {
        m_cursor = std::make_unique<StepCursor>(m_record);
        m_finder = std::make_unique<StepFinder>(m_record);
        m_cursor->moveTo(position);
        m_lookedAt = currentTriangle();
    } catch (const std::bad_alloc&) {
        giveUp(Lack::Memory);
        return;
    }
    syncRecording();
    Q_EMIT logChanged();
    Q_EMIT positionChanged();
    if (m_putOff && !m_isBeginning)
        std::exchange(m_putOff, {})();
}

void StepSession::drop()
{
    setPlaying(false);
    m_isBeginning = false;
    m_putOff = {};
    m_scene.reset();
    if (!m_record)
        return;
    m_lookedAt = {};
    m_coverage.reset();
    m_finder.reset();
    m_cursor.reset();
    m_record.reset();
    Q_EMIT logChanged();
    Q_EMIT positionChanged();
}

void StepSession::syncRecording()
{
    if (std::exchange(m_wasRecording, isRecording()) != isRecording())
        Q_EMIT recordingChanged(isRecording());
}

void StepSession::moveTo(std::size_t position)
{
    m_putOff = {};
    position = std::min(position, size());
    if (!m_cursor || position == m_cursor->position())
        return;
    try {
        m_cursor->moveTo(position);
        m_lookedAt = currentTriangle();
    } catch (const std::bad_alloc&) {
        giveUp(Lack::Memory);
        return;
    }
    Q_EMIT positionChanged();
}

void StepSession::step(StepLevel level, StepDirection direction)
{
    setPlaying(false);
    if (!m_finder)
        return;
    const std::size_t to = m_finder->step(position(), level, direction);
    if (m_isBeginning && direction == StepDirection::Forward && to == size())
        whenWhole([this, level, direction] { step(level, direction); });
    else
        moveTo(to);
}

void StepSession::moveToEnd()
{
    setPlaying(false);
    whenWhole([this] { moveTo(size()); });
}

void StepSession::whenWhole(std::function<void()> request)
{
    if (!m_isBeginning) {
        request();
        return;
    }
    m_putOff = std::move(request);
    Q_EMIT playbackChanged();
}

void StepSession::runUntil(const StepStop& stop)
{
    setPlaying(false);
    if (!m_finder)
        return;
    const auto at = m_finder->findStop(position(), StepDirection::Forward, stop);
    if (!at && m_isBeginning) {
        whenWhole([this, stop] { runUntil(stop); });
        return;
    }
    moveTo(at ? *at + 1 : size());
    if (!at)
        Q_EMIT stopMissed();
}

std::optional<std::size_t> StepSession::firstEventOf(std::uint32_t face, QPoint pixel)
{
    return m_finder ? m_finder->firstEventOf(face, pixel.x(), pixel.y()) : std::nullopt;
}

std::shared_ptr<const StepLog> StepSession::coverage(const StepTriangle& triangle, const PixelRect& pixels)
{
    if (!m_record)
        return nullptr;
    const auto& [a, b, c] = triangle.screen.vertices;
    const std::array corners{a.position, b.position, c.position};
    if (!m_coverage || m_coverage->corners != corners || !(m_coverage->pixels == pixels))
        m_coverage = {corners, pixels, m_record->coverage(triangle.screen, pixels)};
    return m_coverage->log;
}

std::optional<std::uint32_t> StepSession::lastFaceAt(QPoint pixel)
{
    if (!m_finder)
        return std::nullopt;
    const auto at = m_finder->findStop(size(), StepDirection::Backward, {StepStop::Kind::Pixel, pixel.x(), pixel.y()});
    return at ? std::optional(m_finder->event(*at).face) : std::nullopt;
}

void StepSession::setPlaying(bool on)
{
    on = on && m_cursor && size() > 0;
    if (on == isPlaying())
        return;
    if (on) {
        if (position() == size() && !m_isBeginning)
            moveTo(0);
        m_owedSteps = 0;
        m_sinceTick.start();
        m_clock.start();
    } else {
        m_clock.stop();
    }
    Q_EMIT playbackChanged();
}

void StepSession::setSpeed(double speed)
{
    speed = std::clamp(speed, kSlowestSteps, kFastestSteps);
    if (speed == m_speed)
        return;
    m_speed = speed;
    Q_EMIT playbackChanged();
}

void StepSession::setPlayBy(PlayBy by)
{
    if (by == m_playBy)
        return;
    m_playBy = by;
    m_owedSteps = 0;
    Q_EMIT playbackChanged();
}

void StepSession::setSeconds(double seconds)
{
    if (seconds == m_seconds)
        return;
    m_seconds = seconds;
    Q_EMIT playbackChanged();
}

void StepSession::setLooping(bool on)
{
    if (on == m_looping)
        return;
    m_looping = on;
    Q_EMIT playbackChanged();
}

/// Where so many steps of playing lead to.
std::size_t StepSession::playedTo(std::size_t steps)
{
    constexpr std::array kLevels{StepLevel::Event, StepLevel::Sample, StepLevel::Row, StepLevel::Face,
                                 StepLevel::Stage};
    if (m_playBy == PlayBy::Event || m_playBy == PlayBy::Seconds)
        return position() + steps;
    std::size_t to = position();
    for (std::size_t i = 0; i < steps && to < size(); ++i)
        to = m_finder->step(to, kLevels[std::size_t(m_playBy)], StepDirection::Forward);
    return to;
}

void StepSession::advance()
{
    const double seconds = double(m_sinceTick.restart()) / 1000;
    if (m_isBeginning && (m_playBy == PlayBy::Seconds || position() == size()))
        return; // how much there is, is not known yet
    m_owedSteps +=
        m_playBy == PlayBy::Seconds ? seconds * double(size()) / m_seconds : seconds * kStepsPerSecond * m_speed;
    const auto steps = static_cast<std::size_t>(m_owedSteps);
    if (steps == 0)
        return;
    m_owedSteps -= double(steps);
    if (position() == size())
        moveTo(0); // only a loop plays on at the end
    else
        moveTo(playedTo(steps));
    if (position() == size() && !m_looping && !m_isBeginning)
        setPlaying(false);
}

void StepSession::setScope(StepScope scope)
{
    if (scope == m_scope)
        return;
    m_scope = scope;
    recordAnew();
    Q_EMIT selectionChanged();
}

void StepSession::setRectangle(const std::optional<PixelRect>& pixels)
{
    m_rectangle = pixels;
    if (m_scope == StepScope::Rectangle)
        recordAnew();
}

void StepSession::selectPixel(std::optional<QPoint> pixel)
{
    if (pixel == m_selectedPixel)
        return;
    m_selectedPixel = pixel;
    Q_EMIT selectionChanged(); // before a record begins, so that the canvas has the same pixel by then
    if (m_scope == StepScope::SelectedPixel)
        recordAnew();
}

void StepSession::selectFace(std::optional<std::uint32_t> face)
{
    if (face == m_selectedFace)
        return;
    m_selectedFace = face;
    if (m_scope == StepScope::SelectedFace)
        recordAnew();
    m_lookedAt = currentTriangle();
    Q_EMIT selectionChanged();
    if (m_cursor)
        Q_EMIT positionChanged();
}

std::optional<std::uint32_t> StepSession::face() const
{
    if (m_selectedFace)
        return m_selectedFace;
    const StepEvent* now = event();
    return now && now->face != StepEvent::kNone ? std::optional(now->face) : std::nullopt;
}

StepSession::LookedAt StepSession::currentTriangle()
{
    const StepEvent* now = event();
    const auto wanted = face();
    const std::shared_ptr<const StepLog> log = this->log();
    if (!log || !wanted)
        return {};
    // Triangles come in the order of drawing, the painter's faces in any order.
    const auto triangles = log->eventsOf(StepKind::Triangle);
    const bool isNow = now && now->face == *wanted && now->triangle != StepEvent::kNone;
    const auto first = isNow
                           ? std::ranges::lower_bound(triangles, now->triangle, {},
                                                      [&](std::uint32_t i) { return log->event(i).triangle; })
                           : std::ranges::find(triangles, *wanted, [&](std::uint32_t i) { return log->event(i).face; });
    if (first == triangles.end() || log->event(*first).face != *wanted)
        return m_selectedFace ? triangleElsewhere(*wanted) : LookedAt{};
    return {log, &log->event(*first), positionInLog()};
}

/// The first triangle of a face that is not at work here.
StepSession::LookedAt StepSession::triangleElsewhere(std::uint32_t face)
{
    const auto events = m_record->index().eventsOf(face);
    if (!events)
        return {};
    const std::shared_ptr<const StepLog> log = m_finder->windowAt(events->first);
    const auto triangles = log->eventsOf(StepKind::Triangle);
    const auto first = std::ranges::find(triangles, face, [&](std::uint32_t i) { return log->event(i).face; });
    if (first == triangles.end())
        return {};
    const std::size_t now = std::clamp(position(), log->first(), log->last());
    return {log, &log->event(*first), position() <= log->first() ? 0 : now - log->first() + log->lead()};
}

} // namespace rasterlens
