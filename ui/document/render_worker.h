#pragma once
#include "core/pipeline/statistics.h"
#include "core/render/render.h"
#include "core/scene/scene.h"
#include "ui/base/latest_task.h"

#include <QObject>

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>

namespace rasterlens
{

/// A finished picture with what it was made from. Shared with the window, never copied.
struct RenderedFrame {
    std::shared_ptr<const Scene> scene;
    Settings settings;
    Frame frame;           ///< depth and ids only where `statistics` is set
    Statistics statistics; ///< meaningful where `counted`
    bool counted = false;
    bool fast = false;  ///< drawn by the tiled algorithm in place of the chosen one
    bool timed = false; ///< its times are worth telling: the algorithm had its threads and memory before
    std::chrono::steady_clock::time_point requested; ///< when the change it shows was made
};

using FramePtr = std::shared_ptr<const RenderedFrame>;

/// Draws frames on a background thread; the latest request wins.
///
/// order   while the camera moves, and where pictures take long, first a picture by the tiled algorithm where that is
/// the same;
///         then, once nothing newer comes, the picture by the chosen algorithm at full speed; then the same counted,
///         with depth and face ids for the pixel read-out, and with the times of a further picture at full speed: the
///         first one after a change had memory to take and threads to start. Camera moves let the first picture finish,
///         so motion stays visible however slow a frame is; any other change stops it.
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

    /// Draws the last request again and again, to measure frames per second.
    void setContinuous(bool on);
    [[nodiscard]] bool isContinuous() const { return m_continuous; }

    /// Whether a frame is asked for and not yet delivered and counted.
    [[nodiscard]] bool busy() const { return m_delivered != m_requested; }

Q_SIGNALS:
    void frameReady(const rasterlens::FramePtr& frame);
    void failed(const QString& message);
    void busyChanged(bool busy);

private:
    class Pool;

    /// What is to be drawn.
    struct Request {
        std::shared_ptr<const Scene> scene;
        Settings settings;
        quint64 serial = 0;
        bool warm = false;            ///< the last picture was drawn in the same way
        std::optional<Settings> fast; ///< draw with these first
        std::chrono::steady_clock::time_point time;
    };

    void work(const Request& request, const std::stop_token& stop);
    void drawFast(const Request& request, const std::stop_token& stop);
    void drawCounted(const Request& request, const std::stop_token& stop);
    template <class Draw>
    void withTiled(Frame& frame, Draw&& draw);
    [[nodiscard]] std::shared_ptr<RenderedFrame> newFrame(const Request& request);
    void deliver(FramePtr frame, quint64 serial);
    void giveUp(quint64 serial, const QString& why);
    [[nodiscard]] bool takesLong(const Scene& scene) const;
    [[nodiscard]] bool onlyCameraMoves(const std::shared_ptr<const Scene>& scene, const Settings& settings) const;

    std::shared_ptr<Pool> m_pool;
    std::shared_ptr<const Scene> m_scene;
    Settings m_settings;
    quint64 m_requested = 0;
    quint64 m_delivered = 0;
    bool m_fastMotion = true;
    double m_lastMs = 0; ///< of the last picture of m_scene by an algorithm that is not tiled; 0 none yet
    std::shared_ptr<TiledContext> m_tiled; ///< of every picture, whichever frame it goes to
    std::atomic<bool> m_shown = false;     ///< the request at work has had its first picture
    std::atomic<bool> m_continuous = false;
    LatestTask m_task; ///< last: its thread uses the members above
};

} // namespace rasterlens

Q_DECLARE_METATYPE(rasterlens::FramePtr)
