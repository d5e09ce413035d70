#include "ui/steps/step_session.h"

#include "core/render/render.h"

#include <algorithm>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kTickMs = 16;

} // namespace

StepSession::StepSession(Document& document, QObject* parent)
    : QObject(parent), m_document(document),
      m_result([this](std::shared_ptr<const StepLog> log) { take(std::move(log)); },
               [this](Lack lack) { giveUp(lack); })
{
    m_clock.setInterval(kTickMs);
    m_clock.setTimerType(Qt::PreciseTimer);
    connect(&m_clock, &QTimer::timeout, this, &StepSession::advance);
    connect(&m_document, &Document::settingsChanged, this, [this] {
        if (m_scene != m_document.scene())
            drop();
        record();
    });
}

void StepSession::open()
{
    if (m_open)
        return;
    m_open = true;
    Q_EMIT openChanged(true);
    record();
}

void StepSession::close()
{
    if (!m_open)
        return;
    m_open = false;
    m_result.drop();
    drop();
    syncRecording();
    Q_EMIT openChanged(false);
}

StepFilter StepSession::filter() const
{
    StepFilter filter;
    if (m_scope == StepScope::SelectedFace)
        filter.face = m_selectedFace;
    if (m_scope == StepScope::Rectangle)
        filter.pixels = m_rectangle;
    return filter;
}

void StepSession::record()
{
    if (!m_open)
        return;
    if (unsupported(*m_document.scene(), m_document.settings())) {
        m_result.drop();
        drop();
        syncRecording();
        return;
    }
    m_result.ask([scene = m_document.scene(), settings = m_document.settings(),
                  filter = filter()](const auto& turn) { return renderSteps(*scene, settings, filter, turn.stop()); },
                 LatestJob::Running::Interrupt);
    syncRecording();
}

void StepSession::giveUp(Lack lack)
{
    drop(); // the former record is one of other settings
    syncRecording();
    Q_EMIT failed(lack == Lack::Memory ? tr("There is not enough memory to record this frame.")
                                       : tr("This frame was not recorded: %1.").arg(lackText(lack)));
}

void StepSession::take(std::shared_ptr<const StepLog> log)
{
    const std::size_t position = this->position();
    m_scene = m_document.scene();
    m_settings = recordedAs(m_document.settings());
    m_log = std::move(log);
    m_cursor = std::make_unique<StepCursor>(m_log);
    m_cursor->moveTo(position);
    m_triangle = currentTriangle();
    syncRecording();
    Q_EMIT logChanged();
    Q_EMIT positionChanged();
}

void StepSession::drop()
{
    setPlaying(false);
    m_scene.reset();
    if (!m_log)
        return;
    m_triangle = nullptr;
    m_cursor.reset();
    m_log.reset();
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
    position = std::min(position, size());
    if (!m_cursor || position == m_cursor->position())
        return;
    m_cursor->moveTo(position);
    m_triangle = currentTriangle();
    Q_EMIT positionChanged();
}

void StepSession::step(StepLevel level, StepDirection direction)
{
    setPlaying(false);
    if (m_log)
        moveTo(m_log->step(position(), level, direction));
}

bool StepSession::runUntil(const StepStop& stop)
{
    setPlaying(false);
    if (!m_log)
        return false;
    const auto at = m_log->findStop(position(), StepDirection::Forward, stop);
    moveTo(at ? *at + 1 : size());
    return at.has_value();
}

void StepSession::setPlaying(bool on)
{
    on = on && m_cursor && size() > 0;
    if (on == isPlaying())
        return;
    if (on) {
        if (position() == size())
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

void StepSession::setLooping(bool on)
{
    if (on == m_looping)
        return;
    m_looping = on;
    Q_EMIT playbackChanged();
}

void StepSession::advance()
{
    m_owedSteps += double(m_sinceTick.restart()) / 1000 * kStepsPerSecond * m_speed;
    const auto steps = static_cast<std::size_t>(m_owedSteps);
    if (steps == 0)
        return;
    m_owedSteps -= double(steps);
    if (position() == size())
        moveTo(0); // only a loop plays on at the end
    else
        moveTo(position() + steps);
    if (position() == size() && !m_looping)
        setPlaying(false);
}

void StepSession::setScope(StepScope scope)
{
    if (scope == m_scope)
        return;
    m_scope = scope;
    record();
    Q_EMIT selectionChanged();
}

void StepSession::setRectangle(const std::optional<PixelRect>& pixels)
{
    m_rectangle = pixels;
    if (m_scope == StepScope::Rectangle)
        record();
}

void StepSession::selectPixel(std::optional<QPoint> pixel)
{
    if (pixel == m_selectedPixel)
        return;
    m_selectedPixel = pixel;
    Q_EMIT selectionChanged();
}

void StepSession::selectFace(std::optional<std::uint32_t> face)
{
    if (face == m_selectedFace)
        return;
    m_selectedFace = face;
    if (m_scope == StepScope::SelectedFace)
        record();
    m_triangle = currentTriangle();
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

const StepEvent* StepSession::currentTriangle() const
{
    const StepEvent* now = event();
    const auto wanted = face();
    if (!m_log || !wanted)
        return nullptr;
    // Triangles come in the order of drawing, the painter's faces in any order.
    const auto triangles = m_log->eventsOf(StepKind::Triangle);
    const bool isNow = now && now->face == *wanted && now->triangle != StepEvent::kNone;
    const auto first =
        isNow ? std::ranges::lower_bound(triangles, now->triangle, {},
                                         [&](std::uint32_t i) { return m_log->event(i).triangle; })
              : std::ranges::find(triangles, *wanted, [&](std::uint32_t i) { return m_log->event(i).face; });
    if (first == triangles.end() || m_log->event(*first).face != *wanted)
        return nullptr;
    return &m_log->event(*first);
}

} // namespace rasterlens
