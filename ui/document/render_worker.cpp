#include "ui/document/render_worker.h"

#include <mutex>
#include <new>
#include <system_error>
#include <utility>
#include <vector>

namespace rasterlens
{

/// From here on the first picture of any change is drawn fast.
constexpr double kLongMs = 100;
constexpr std::size_t kLargeScene = 200000; ///< faces: so long take the other algorithms, which nobody timed yet

/// Times below it are taken from a picture into memory that was written before: fresh memory costs some 20 ms.
constexpr double kMemoryMattersMs = 600;

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
    const bool moves = onlyCameraMoves(scene, settings);
    const bool wasBusy = busy();
    Request request{scene, settings, ++m_requested, moves, std::nullopt, std::chrono::steady_clock::now()};
    if (m_fastMotion && !m_continuous && (moves || takesLong(*scene)))
        request.fast = fastSettings(*scene, settings);
    if (!m_scene || m_scene->id != scene->id)
        m_lastMs = 0;
    m_scene = std::move(scene);
    m_settings = settings;
    m_task.post([this, request = std::move(request)](const std::stop_token& stop) { work(request, stop); },
                moves && !m_shown ? LatestTask::Running::Finish : LatestTask::Running::Interrupt);
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

bool RenderWorker::takesLong(const Scene& scene) const
{
    const bool isTimed = m_scene && m_scene->id == scene.id && m_lastMs > 0;
    return isTimed ? m_lastMs >= kLongMs : scene.mesh.faceCount() >= kLargeScene;
}

bool RenderWorker::onlyCameraMoves(const std::shared_ptr<const Scene>& scene, const Settings& settings) const
{
    Settings sameView = settings;
    sameView.view = m_settings.view;
    return scene == m_scene && sameView == m_settings && !(settings == m_settings);
}

std::shared_ptr<RenderedFrame> RenderWorker::newFrame(const Request& request)
{
    std::shared_ptr<RenderedFrame> picture = m_pool->take();
    picture->scene = request.scene;
    picture->settings = request.settings;
    picture->counted = false;
    picture->fast = false;
    picture->timed = false;
    picture->requested = request.time;
    return picture;
}

/// Lends a frame the threads and memory of the tiled algorithm while it is drawn.
template <class Draw>
void RenderWorker::withTiled(Frame& frame, Draw&& draw)
{
    frame.tiled = std::exchange(m_tiled, nullptr);
    draw();
    m_tiled = std::exchange(frame.tiled, nullptr);
}

void RenderWorker::drawFast(const Request& request, const std::stop_token& stop)
{
    const std::shared_ptr<RenderedFrame> picture = newFrame(request);
    picture->fast = true;
    picture->timed = m_tiled != nullptr;
    withTiled(picture->frame, [&] { render(*request.scene, *request.fast, picture->frame, {}, stop); });
    if (!stop.stop_requested())
        deliver(picture, request.serial);
}

void RenderWorker::drawCounted(const Request& request, const std::stop_token& stop)
{
    const std::shared_ptr<RenderedFrame> picture = newFrame(request);
    const auto draw = [&] { render(*request.scene, request.settings, picture->frame, {}, stop); };
    withTiled(picture->frame, [&] {
        draw();
        if (picture->frame.times.total < kMemoryMattersMs)
            draw();
        const StageTimes times = picture->frame.times;
        picture->statistics = renderCounted(*request.scene, request.settings, picture->frame,
                                            {.depth = true, .ids = true, .coverage = false}, stop);
        picture->frame.times = times;
    });
    picture->counted = true;
    picture->timed = true;
    if (!stop.stop_requested())
        deliver(picture, request.serial);
}

void RenderWorker::work(const Request& request, const std::stop_token& stop)
{
    constexpr std::chrono::milliseconds kRest(60); // a hand that moves the mouse sends more before that
    const quint64 serial = request.serial;
    m_shown = false;
    try {
        if (request.fast) {
            drawFast(request, stop);
            m_shown = true;
            if (stop.stop_requested() || m_task.supersededWithin(kRest))
                return;
        }
        bool counted = false;
        do {
            const std::shared_ptr<RenderedFrame> picture = newFrame(request);
            picture->timed = request.warm || counted;
            withTiled(picture->frame, [&] { render(*request.scene, request.settings, picture->frame, {}, stop); });
            if (stop.stop_requested())
                return;
            deliver(picture, serial);
            m_shown = true;
            if (counted || m_task.superseded())
                continue;
            drawCounted(request, stop);
            counted = true;
        } while (m_continuous && !m_task.superseded() && !stop.stop_requested());
    } catch (const std::bad_alloc&) {
        giveUp(serial, tr("There is not enough memory for a picture of this size."));
    } catch (const std::system_error&) {
        giveUp(serial, tr("The system does not start so many threads."));
    }
}

void RenderWorker::giveUp(quint64 serial, const QString& why)
{
    QMetaObject::invokeMethod(
        this,
        [this, serial, why] {
            m_delivered = serial;
            Q_EMIT failed(why);
            Q_EMIT busyChanged(busy());
        },
        Qt::QueuedConnection);
}

void RenderWorker::deliver(FramePtr frame, quint64 serial)
{
    QMetaObject::invokeMethod(
        this,
        [this, frame = std::move(frame), serial] {
            const bool wasBusy = busy();
            if (frame->counted)
                m_delivered = serial;
            const bool byTiled = frame->fast || frame->settings.algorithm == Algorithm::Tiled;
            if (!byTiled && frame->scene->id == m_scene->id)
                m_lastMs = frame->frame.times.total;
            Q_EMIT frameReady(frame);
            if (wasBusy && !busy())
                Q_EMIT busyChanged(false);
        },
        Qt::QueuedConnection);
}

} // namespace rasterlens
