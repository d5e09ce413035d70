#include "ui/document/render_worker.h"

#include "core/render/count.h"
#include "core/render/picture_memory.h"
#include "core/truth/mistake_proof.h"
#include "ui/base/numbers.h"

#include <algorithm>
#include <mutex>
#include <utility>
#include <vector>

namespace rasterlens
{

/// From here on the first picture of any change is drawn fast.
constexpr double kLongMs = 100;
constexpr std::size_t kLargeScene = 200000; ///< faces from which on a scene counts as slow until it has been timed

/// Keeps the memory of frames the window has let go of.
class RenderWorker::Pool : public std::enable_shared_from_this<RenderWorker::Pool>
{
public:
    /// A frame whose memory was written for so many samples before, or a new one. Memory of other sizes is let go of.
    std::shared_ptr<RenderedFrame> take(std::int64_t samples)
    {
        std::unique_ptr<RenderedFrame> frame;
        {
            const std::lock_guard lock(m_mutex);
            std::erase_if(m_free, [samples](const auto& free) { return free->warmSamples != samples; });
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
        frame->scene.reset();
        const std::lock_guard lock(m_mutex);
        if (m_free.size() < kKept && !isLarge(frame->settings))
            m_free.push_back(std::move(frame)); // within the capacity: takes no memory
    }

    static constexpr std::size_t kKept = 2;
    std::mutex m_mutex;
    std::vector<std::unique_ptr<RenderedFrame>> m_free = [] {
        std::vector<std::unique_ptr<RenderedFrame>> free;
        free.reserve(kKept);
        return free;
    }();
};

RenderWorker::RenderWorker(QObject* parent)
    : QObject(parent), m_pool(std::make_shared<Pool>()), m_freeMemory(freeMemoryBytes),
      m_result([this](const FramePtr& frame) { take(frame); },
               [this](Lack lack) {
                   giveUp(lack == Lack::Memory ? tr("There is not enough memory for a picture of this size.")
                                               : tr("The system does not start so many threads."));
               },
               LatestJob::Late::Taken)
{
}

RenderWorker::~RenderWorker() = default;

void RenderWorker::request(std::shared_ptr<const Scene> scene, const Settings& settings)
{
    const bool moves = onlyCameraMoves(scene, settings);
    const bool goesLarge = isLarge(settings) && (!m_scene || samplesOf(m_settings) != samplesOf(settings));
    Request request{scene, settings, std::nullopt, moves, false, std::chrono::steady_clock::now()};
    if (m_fastMotion && !m_continuous && (moves || takesLong(*scene)))
        request.fast = fastSettings(*scene, settings);
    if (!m_scene || m_scene->id != scene->id)
        m_lastMs = 0;
    if (isLarge(settings) && !memorySuffices(settings))
        return;
    m_scene = std::move(scene);
    m_settings = settings;
    if (goesLarge)
        Q_EMIT memoryNeeded(
            tr("Pictures of %1 x %2 take up to %3 of memory. It is given back with the next smaller one.")
                .arg(grouped(static_cast<std::uint64_t>(settings.size.width())),
                     grouped(static_cast<std::uint64_t>(settings.size.height())),
                     gigabytesText(pictureBytes(settings))));
    ask(std::move(request), moves && !m_shown ? LatestJob::Running::Finish : LatestJob::Running::Interrupt);
}

void RenderWorker::ask(Request request, LatestJob::Running running)
{
    m_repeating = request.repeats;
    m_result.ask([this, request = std::move(request)](const Turn& turn) { return work(request, turn); }, running);
    syncBusy();
}

/// Says so and asks for nothing where a large picture would take more memory than there is: a system that is out of
/// memory does not refuse it but ends the program.
bool RenderWorker::memorySuffices(const Settings& settings)
{
    // The picture that is shown goes as soon as the new one is there.
    const bool isAsLarge = m_scene && samplesOf(m_settings) == samplesOf(settings);
    const std::int64_t needed = isAsLarge ? pictureBytes(settings) / 3 * 2 : pictureBytes(settings);
    const std::int64_t free = m_freeMemory();
    if (needed <= free)
        return true;
    m_result.drop();
    giveUp(tr("There is not enough memory for a picture of this size: it takes %1, and %2 are free.")
               .arg(gigabytesText(needed), gigabytesText(free)));
    return false;
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

/// Fresh memory costs some 20 ms when it is first written to. That belongs to no algorithm, so it is written here,
/// once; beside the time of a large picture it does not show.
void writeOnce(RenderedFrame& picture, const Settings& settings, std::int64_t samples)
{
    if (picture.warmSamples == samples)
        return;
    picture.warmSamples = samples;
    if (isLarge(settings))
        return;
    picture.frame.image = QImage(settings.size, QImage::Format_RGB32);
    picture.frame.image.fill(Qt::black);
    const auto pixels =
        static_cast<std::size_t>(settings.size.width()) * static_cast<std::size_t>(settings.size.height());
    picture.frame.depth.assign(pixels, 0);
}

std::shared_ptr<RenderedFrame> RenderWorker::newFrame(const Request& request)
{
    ++m_drawn;
    const std::int64_t samples = samplesOf(request.settings);
    std::shared_ptr<RenderedFrame> picture = m_pool->take(samples);
    writeOnce(*picture, request.settings, samples);
    picture->scene = request.scene;
    picture->settings = request.settings;
    picture->counted = false;
    picture->fast = false;
    picture->moving = false;
    picture->timed = true;
    picture->requested = request.time;
    return picture;
}

/// Lends a frame the threads and memory of the tiled algorithm while it is drawn.
template <class Draw>
void RenderWorker::withTiled(Frame& frame, Draw&& draw)
{
    struct Loan { // given back also where memory or threads are wanting
        Frame& frame;
        std::shared_ptr<TiledContext>& home;
        ~Loan() { home = std::exchange(frame.tiled, nullptr); }
    };
    frame.tiled = std::exchange(m_tiled, nullptr);
    const Loan loan{frame, m_tiled};
    draw();
}

/// What the tiled algorithm took for a large picture does not stay for small ones.
void RenderWorker::letGoOfLargeMemory(const Settings& next)
{
    if (m_tiledIsLarge && !isLarge(next))
        m_tiled.reset();
    m_tiledIsLarge = isLarge(next);
}

FramePtr RenderWorker::drawFast(const Request& request, const std::stop_token& stop)
{
    const std::shared_ptr<RenderedFrame> picture = newFrame(request);
    picture->fast = true;
    picture->moving = request.moves;
    picture->timed = m_tiled != nullptr;
    withTiled(picture->frame, [&] { render(*request.scene, *request.fast, picture->frame, {}, stop); });
    return picture;
}

FramePtr RenderWorker::drawPlain(const Request& request, const std::stop_token& stop)
{
    const std::shared_ptr<RenderedFrame> picture = newFrame(request);
    picture->moving = request.moves && !request.fast;
    picture->timed = request.settings.algorithm != Algorithm::Tiled || m_tiled != nullptr;
    withTiled(picture->frame, [&] { render(*request.scene, request.settings, picture->frame, {}, stop); });
    if (isLarge(request.settings))
        picture->frame.depth = {}; // the counted picture, which has it too, needs the room
    return picture;
}

/// The counted picture has the colours of the one before it, and tells its times: counting takes time of its own.
FramePtr RenderWorker::drawCounted(const Request& request, const RenderedFrame& plain, const std::stop_token& stop)
{
    const std::shared_ptr<RenderedFrame> picture = newFrame(request);
    withTiled(picture->frame, [&] {
        picture->statistics = countPicture(*request.scene, request.settings, plain.frame, picture->frame, stop);
    });
    picture->frame.times = plain.frame.times;
    picture->timed = plain.timed;
    picture->counted = true;
    return picture;
}

/// On the background thread.
FramePtr RenderWorker::work(const Request& request, const Turn& turn)
{
    constexpr std::chrono::milliseconds kRest(60); // a hand that moves the mouse sends more before that
    const std::stop_token& stop = turn.stop();
    m_shown = false;
    letGoOfLargeMemory(request.settings);
    if (request.fast) {
        turn.deliver(drawFast(request, stop));
        m_shown = true;
        if (stop.stop_requested() || turn.supersededWithin(kRest))
            return nullptr;
    }
    const FramePtr plain = drawPlain(request, stop);
    if (request.repeats || stop.stop_requested())
        return plain;
    turn.deliver(plain);
    m_shown = true;
    if (stop.stop_requested() || turn.superseded())
        return nullptr;
    return drawCounted(request, *plain, stop);
}

void RenderWorker::take(const FramePtr& frame)
{
    if (!frame) // something newer is on its way
        return;
    const bool byTiled = frame->fast || frame->settings.algorithm == Algorithm::Tiled;
    if (!byTiled && frame->scene->id == m_scene->id)
        m_lastMs = frame->frame.times.total;
    Q_EMIT frameReady(frame);
    syncBusy();
    if (m_continuous && !m_result.isBusy())
        ask({m_scene, m_settings, std::nullopt, false, true, std::chrono::steady_clock::now()},
            LatestJob::Running::Finish);
}

void RenderWorker::giveUp(const QString& why)
{
    Q_EMIT failed(why);
    syncBusy();
}

void RenderWorker::syncBusy()
{
    if (std::exchange(m_wasBusy, busy()) != busy())
        Q_EMIT busyChanged(busy());
}

} // namespace rasterlens
