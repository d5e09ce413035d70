#pragma once
#include "core/pipeline/statistics.h"
#include "core/render/render.h"
#include "core/scene/scene.h"
#include "core/truth/mistake_proof.h"
#include "ui/base/latest_result.h"

#include <QObject>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace rasterlens
{

/// A finished picture with what it was made from. Shared with the window, never copied.
struct RenderedFrame : CountedPicture {
    std::shared_ptr<const Scene> scene;
    Settings settings;
    bool counted = false;         ///< it has statistics, depth and ids
    bool fast = false;            ///< drawn by the tiled algorithm in place of the chosen one
    bool moving = false;          ///< the first picture of a move of the camera: soon there is another one
    bool timed = false;           ///< its times are worth telling: the algorithm had its threads and memory before
    std::int64_t warmSamples = 0; ///< how many samples its memory was written for before it was drawn
    std::chrono::steady_clock::time_point requested; ///< when the change it shows was made
};

using FramePtr = std::shared_ptr<const RenderedFrame>;

/// Draws frames on a background thread; the latest request wins.
///
/// order   each request is drawn twice by the chosen algorithm: at full speed, which tells the times, and once that is
///         shown and nothing newer waits, counted, with depth and face ids for the pixel read-out. While the camera
///         moves, and where pictures take long, the tiled algorithm draws first where that is the same picture, and the
///         other two follow once nothing newer comes. Camera moves let the first picture finish, so motion stays
///         visible however slow a frame is; any other change stops it. Pictures never wait in a queue: the next one is
///         handed over when the last one has been painted
/// errors  want of memory or threads is told by failed(), and the former picture stays. A large picture is not begun
///         where the system has less memory than it takes
class RenderWorker : public QObject
{
    Q_OBJECT

public:
    explicit RenderWorker(QObject* parent = nullptr);
    ~RenderWorker() override;

    /// in   settings for which unsupported() is empty
    void request(std::shared_ptr<const Scene> scene, const Settings& settings);

    /// Whether the tiled algorithm draws first while the camera moves and where pictures take long.
    void setFastMotion(bool on) { m_fastMotion = on; }
    [[nodiscard]] bool hasFastMotion() const { return m_fastMotion; }

    /// Draws the last request again and again, to measure frames per second: the next one when the last is painted.
    void setContinuous(bool on);
    [[nodiscard]] bool isContinuous() const { return m_continuous; }

    /// Whether a frame is asked for and not yet delivered and counted.
    [[nodiscard]] bool busy() const { return m_result.isBusy() && !m_repeating; }
    /// How many pictures have been drawn, finished or not.
    [[nodiscard]] std::uint64_t picturesDrawn() const { return m_drawn; }
    /// Asks another source than the system how many bytes it can still give; for tests.
    void setFreeMemory(std::function<std::int64_t()> bytes) { m_freeMemory = std::move(bytes); }

Q_SIGNALS:
    void frameReady(const rasterlens::FramePtr& frame);
    void failed(const QString& message);
    /// A large picture of another size than the last one is about to be drawn: what it takes.
    void memoryNeeded(const QString& message);
    void busyChanged(bool busy);

private:
    class Pool;
    using Turn = LatestResult<FramePtr>::Turn;

    /// What is to be drawn.
    struct Request {
        std::shared_ptr<const Scene> scene;
        Settings settings;
        std::optional<Settings> fast; ///< draw with these first
        bool moves = false;           ///< of the last one it differs by the camera alone
        bool repeats = false;         ///< the same as the last one, to measure the rate
        std::chrono::steady_clock::time_point time;
    };

    void ask(Request request, LatestJob::Running running);
    [[nodiscard]] FramePtr work(const Request& request, const Turn& turn);
    [[nodiscard]] FramePtr drawFast(const Request& request, const std::stop_token& stop);
    [[nodiscard]] FramePtr drawPlain(const Request& request, const std::stop_token& stop);
    [[nodiscard]] FramePtr drawCounted(const Request& request, const RenderedFrame& plain, const std::stop_token& stop);
    template <class Draw>
    void withTiled(Frame& frame, Draw&& draw);
    [[nodiscard]] std::shared_ptr<RenderedFrame> newFrame(const Request& request);
    void letGoOfLargeMemory(const Settings& next);
    void take(const FramePtr& frame);
    void giveUp(const QString& why);
    void syncBusy();
    [[nodiscard]] bool memorySuffices(const Settings& settings);
    [[nodiscard]] bool takesLong(const Scene& scene) const;
    [[nodiscard]] bool onlyCameraMoves(const std::shared_ptr<const Scene>& scene, const Settings& settings) const;

    std::shared_ptr<Pool> m_pool;
    std::shared_ptr<const Scene> m_scene;
    Settings m_settings;
    bool m_fastMotion = true;
    bool m_continuous = false;
    bool m_repeating = false; ///< what is asked for last repeats what is shown
    bool m_wasBusy = false;   ///< as busyChanged() told
    double m_lastMs = 0;      ///< of the last picture of m_scene by an algorithm that is not tiled; 0 none yet
    std::function<std::int64_t()> m_freeMemory;
    std::shared_ptr<TiledContext> m_tiled; ///< of every picture, whichever frame it goes to
    bool m_tiledIsLarge = false;           ///< it has drawn a large picture
    std::atomic<bool> m_shown = false;     ///< the request at work has had its first picture
    std::atomic<std::uint64_t> m_drawn = 0;
    LatestResult<FramePtr> m_result; ///< last: its thread uses the members above
};

} // namespace rasterlens

Q_DECLARE_METATYPE(rasterlens::FramePtr)
