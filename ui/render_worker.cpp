#include "ui/render_worker.h"

#include <mutex>
#include <new>
#include <utility>
#include <vector>

namespace rasterlens
{

/// Keeps the memory of frames the window has let go of.
class RenderWorker::Pool : public std::enable_shared_from_this<RenderWorker::Pool>
{
public:
    std::shared_ptr<RenderedFrame> take()
    {
        std::unique_ptr<RenderedFrame> frame;
        {
            const std::lock_guard lock(m_mutex);
            if (!m_free.empty()) {
                frame = std::move(m_free.back());
                m_free.pop_back();
            }
        }
        if (!frame)
            frame = std::make_unique<RenderedFrame>();
        return {frame.release(), [pool = weak_from_this()](RenderedFrame* used) {
                    std::unique_ptr<RenderedFrame> owned(used);
                    if (const auto alive = pool.lock())
                        alive->giveBack(std::move(owned));
                }};
    }

private:
    void giveBack(std::unique_ptr<RenderedFrame> frame)
    {
        constexpr std::size_t kKept = 2;
        frame->scene.reset();
        const std::lock_guard lock(m_mutex);
        if (m_free.size() < kKept)
            m_free.push_back(std::move(frame));
    }

    std::mutex m_mutex;
    std::vector<std::unique_ptr<RenderedFrame>> m_free;
};

RenderWorker::RenderWorker(QObject* parent) : QObject(parent), m_pool(std::make_shared<Pool>()) {}

RenderWorker::~RenderWorker() { m_continuous = false; }

void RenderWorker::request(std::shared_ptr<const Scene> scene, const Settings& settings)
{
    const auto running = mustInterrupt(scene, settings) ? LatestTask::Running::Interrupt : LatestTask::Running::Finish;
    const bool wasBusy = busy();
    m_scene = std::move(scene);
    m_settings = settings;
    const quint64 serial = ++m_requested;
    m_task.post(
        [this, scene = m_scene, settings, serial](std::stop_token stop) { work(scene, settings, serial, stop); },
        running);
    if (!wasBusy)
        Q_EMIT busyChanged(true);
}

void RenderWorker::setContinuous(bool on)
{
    if (m_continuous == on)
        return;
    m_continuous = on;
    if (on && m_scene)
        request(m_scene, m_settings);
}

bool RenderWorker::mustInterrupt(const std::shared_ptr<const Scene>& scene, const Settings& settings) const
{
    Settings sameView = settings;
    sameView.view = m_settings.view;
    return m_counting || scene != m_scene || !(sameView == m_settings);
}

void RenderWorker::work(const std::shared_ptr<const Scene>& scene, const Settings& settings, quint64 serial,
                        std::stop_token stop)
{
    bool counted = false;
    try {
        do {
            const std::shared_ptr<RenderedFrame> picture = m_pool->take();
            picture->scene = scene;
            picture->settings = settings;
            picture->counted = false;
            render(*scene, settings, picture->frame, {}, stop);
            if (stop.stop_requested())
                return;
            deliver(picture, serial);

            if (counted || m_task.superseded())
                continue;
            m_counting = true;
            const StageTimes times = picture->frame.times;
            const std::shared_ptr<RenderedFrame> inspected = m_pool->take();
            inspected->scene = scene;
            inspected->settings = settings;
            inspected->statistics = renderCounted(*scene, settings, inspected->frame,
                                                  {.depth = true, .ids = true, .coverage = false}, stop);
            inspected->counted = true;
            inspected->frame.times = times;
            m_counting = false;
            if (stop.stop_requested())
                return;
            deliver(inspected, serial);
            counted = true;
        } while (m_continuous && !m_task.superseded() && !stop.stop_requested());
    } catch (const std::bad_alloc&) {
        m_counting = false;
        QMetaObject::invokeMethod(
            this,
            [this, serial] {
                m_delivered = serial;
                Q_EMIT failed(tr("There is not enough memory for a picture of this size."));
                Q_EMIT busyChanged(busy());
            },
            Qt::QueuedConnection);
    }
}

void RenderWorker::deliver(FramePtr frame, quint64 serial)
{
    QMetaObject::invokeMethod(
        this,
        [this, frame = std::move(frame), serial] {
            const bool wasBusy = busy();
            if (frame->counted)
                m_delivered = serial;
            Q_EMIT frameReady(frame);
            if (wasBusy && !busy())
                Q_EMIT busyChanged(false);
        },
        Qt::QueuedConnection);
}

} // namespace rasterlens
