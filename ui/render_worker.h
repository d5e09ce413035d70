#pragma once
#include "core/observe/statistics.h"
#include "core/render.h"
#include "core/scene.h"
#include "ui/latest_task.h"

#include <QObject>

#include <atomic>
#include <memory>

namespace rasterlens
{

/// A finished picture with what it was made from. Shared with the window, never copied.
struct RenderedFrame {
    std::shared_ptr<const Scene> scene;
    Settings settings;
    Frame frame;           ///< depth and ids only where `statistics` is set
    Statistics statistics; ///< meaningful where `counted`
    bool counted = false;
};

using FramePtr = std::shared_ptr<const RenderedFrame>;

/// Draws frames on a background thread; the latest request wins.
///
/// order   first the picture at full speed, then, if nothing newer waits, the same picture counted, with depth and face
/// ids
///         for the pixel read-out. Camera moves let the frame at work finish, so motion stays visible however slow a
///         frame is; any other change stops it.
class RenderWorker : public QObject
{
    Q_OBJECT

public:
    explicit RenderWorker(QObject* parent = nullptr);
    ~RenderWorker() override;

    /// in   settings for which unsupported() is empty
    void request(std::shared_ptr<const Scene> scene, const Settings& settings);

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

    void work(const std::shared_ptr<const Scene>& scene, const Settings& settings, quint64 serial,
              std::stop_token stop);
    void deliver(FramePtr frame, quint64 serial);
    [[nodiscard]] bool mustInterrupt(const std::shared_ptr<const Scene>& scene, const Settings& settings) const;

    std::shared_ptr<Pool> m_pool;
    std::shared_ptr<const Scene> m_scene;
    Settings m_settings;
    quint64 m_requested = 0;
    quint64 m_delivered = 0;
    std::atomic<bool> m_counting = false;
    std::atomic<bool> m_continuous = false;
    LatestTask m_task; ///< last: its thread uses the members above
};

} // namespace rasterlens

Q_DECLARE_METATYPE(rasterlens::FramePtr)
