#include "ui/steps/motion_mode.h"

#include "ui/base/applicability.h"
#include "ui/base/numbers.h"
#include "ui/base/theme.h"
#include "ui/canvas/viewport_widget.h"
#include "ui/steps/lens_view.h"

#include <QCoreApplication>
#include <QPainter>

#include <utility>

namespace rasterlens
{

void MotionLayer::paint(QPainter& painter, const QRect& canvas, const CanvasTransform&,
                        const OverlayOptions& options) const
{
    if (m_lines.isEmpty())
        return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    paintPlate(painter, canvas, QPointF(canvas.topLeft()) + QPointF(12, 12), m_lines,
               textFont(options.thickLines ? 2 : 0));
    painter.restore();
}

MotionMode::MotionMode(Document& document, ViewportWidget& viewport)
    : m_document(document), m_viewport(viewport),
      m_result([this](std::shared_ptr<const Shown> shown) { take(std::move(shown)); },
               [this](Lack lack) {
                   stop();
                   Q_EMIT refused(tr("The motion ended: %1.").arg(lackText(lack)));
               })
{
    constexpr int kTickMs = 40;
    m_clock.setInterval(kTickMs);
    connect(&m_clock, &QTimer::timeout, this, &MotionMode::next);
    m_viewport.addLayer(&m_layer);
}

MotionMode::~MotionMode() { m_viewport.removeLayer(&m_layer); }

void MotionMode::start(Motion motion)
{
    if (const auto why = whyNotMoved(*m_document.scene(), motion)) {
        stop();
        Q_EMIT refused(whyUnsupported(*why));
        return;
    }
    m_shown.reset();
    m_changed = 0;
    m_compared = 0;
    m_motion = motion;
    m_clock.start();
    next();
    Q_EMIT motionChanged();
}

void MotionMode::stop()
{
    m_clock.stop();
    m_result.drop();
    m_shown.reset();
    if (!std::exchange(m_motion, std::nullopt))
        return;
    show();
    Q_EMIT motionChanged();
}

/// A frame that takes longer than a tick is waited for.
void MotionMode::next()
{
    const std::shared_ptr<const Scene> scene = m_document.scene();
    const Settings& settings = m_document.settings();
    if (m_result.isBusy() || m_document.isLoading() || unsupported(*scene, settings))
        return;
    if (whyNotMoved(*scene, *m_motion)) {
        stop(); // of another scene
        return;
    }
    m_result.ask([scene, settings, motion = *m_motion, n = m_shown ? m_shown->n + 1 : 0,
                  last = m_shown](const auto& turn) { return draw(scene, settings, motion, n, last, turn.stop()); },
                 LatestJob::Running::Finish);
}

std::shared_ptr<const MotionMode::Shown> MotionMode::draw(const std::shared_ptr<const Scene>& scene,
                                                          const Settings& settings, Motion motion, std::size_t n,
                                                          const std::shared_ptr<const Shown>& last,
                                                          const std::stop_token& stop)
{
    const MovedScene moved = movedScene(scene, settings, motion, n);
    auto frame = std::make_shared<RenderedFrame>();
    frame->scene = moved.scene;
    frame->settings = moved.settings;
    frame->counted = true;
    static_cast<CountedPicture&>(*frame) =
        drawCounted(*moved.scene, moved.settings, {.depth = true, .ids = true}, stop);
    auto shown = std::make_shared<Shown>(Shown{frame, scene, settings, n, std::nullopt});
    const bool isComparable = last && last->scene == scene && last->settings == settings && !stop.stop_requested();
    if (isComparable)
        shown->change = changeBetween(last->frame->frame, frame->frame);
    return shown;
}

void MotionMode::take(std::shared_ptr<const Shown> shown)
{
    m_shown = std::move(shown);
    if (m_shown->change) {
        m_changed += m_shown->change->colors;
        ++m_compared;
    } else { // the first frame, or the first one after a change
        m_changed = 0;
        m_compared = 0;
    }
    show();
}

void MotionMode::showFrame(Motion motion, std::size_t n)
{
    m_clock.stop();
    m_result.drop();
    const bool isNew = m_motion != motion;
    m_motion = motion;
    const auto drawn = [&](std::size_t frame, const std::shared_ptr<const Shown>& last) {
        return draw(m_document.scene(), m_document.settings(), motion, frame, last, {});
    };
    std::shared_ptr<const Shown> last = m_shown;
    if (n > 0 && (isNew || !last || last->n + 1 != n))
        last = drawn(n - 1, nullptr);
    m_changed = 0;
    m_compared = 0;
    take(drawn(n, n > 0 ? last : nullptr));
    if (isNew)
        Q_EMIT motionChanged();
}

QStringList MotionMode::words() const
{
    if (!m_shown)
        return {};
    const std::size_t n = m_shown->n;
    const int place = motionPlace(*m_motion, n);
    QStringList lines;
    switch (*m_motion) {
    case Motion::Turntable: lines << tr("Turntable, frame %1: turned by %2\u00b0").arg(n).arg(place); break;
    case Motion::Jitter: lines << tr("Jitter, frame %1: %2/256 pixel to the right").arg(n).arg(place); break;
    }
    if (!m_shown->change)
        return lines;
    lines << tr("pixels changed since the last frame: %1, to another face: %2")
                 .arg(grouped(m_shown->change->colors), grouped(m_shown->change->owners));
    if (m_compared > 1)
        lines << tr("%1 a frame on average").arg(grouped((m_changed + m_compared / 2) / m_compared));
    return lines;
}

void MotionMode::show()
{
    m_layer.setLines(m_hasPlate ? words() : QStringList());
    m_viewport.update();
    Q_EMIT frameChanged();
}

} // namespace rasterlens
