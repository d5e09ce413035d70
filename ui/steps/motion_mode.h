#pragma once
#include "core/render/motion.h"
#include "ui/base/latest_result.h"
#include "ui/canvas/pixel_overlay.h"
#include "ui/document/document.h"
#include "ui/document/render_worker.h"

#include <QObject>
#include <QStringList>
#include <QTimer>

#include <cstdint>
#include <memory>
#include <optional>

namespace rasterlens
{

class ViewportWidget;

/// What the last frame of a motion has changed, on a plate over the picture.
class MotionLayer : public CanvasLayer
{
public:
    void setLines(const QStringList& lines) { m_lines = lines; }
    void paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
               const OverlayOptions& options) const override;
    [[nodiscard]] bool hidesNumbers() const override { return false; }

private:
    QStringList m_lines;
};

/// Moves the picture by itself, and counts the pixels that each frame changes: what flickers, and what swims, is seen
/// and has a number. The document stays as it is; a change of it is taken up with the next frame.
class MotionMode : public QObject
{
    Q_OBJECT

public:
    MotionMode(Document& document, ViewportWidget& viewport);
    ~MotionMode() override;

    /// Moves from where the picture is; refused() where the scene does not move so.
    void start(Motion motion);
    void stop();
    [[nodiscard]] std::optional<Motion> motion() const { return m_motion; }
    /// Shows one frame of a motion, and what it changes against the one before, and stands still.
    ///
    /// in      a scene for which whyNotMoved() is empty
    /// errors  throws std::bad_alloc
    void showFrame(Motion motion, std::size_t n);

    /// Whether words() lie on a plate over the picture.
    void setPlate(bool on) { m_hasPlate = on; }

    /// The present frame; null where nothing moves.
    [[nodiscard]] FramePtr frame() const { return m_shown ? m_shown->frame : nullptr; }
    /// Where the motion is, and what its last frame has changed.
    [[nodiscard]] QStringList words() const;
    /// What the present frame has changed since the last one; nothing for the first one.
    [[nodiscard]] std::optional<FrameChange> change() const { return m_shown ? m_shown->change : std::nullopt; }

Q_SIGNALS:
    void frameChanged();  ///< another frame is to be shown, or none any more
    void motionChanged(); ///< what moves, or that nothing does any more
    void refused(const QString& message);

private:
    struct Shown {
        FramePtr frame;
        std::shared_ptr<const Scene> scene; ///< of the document
        Settings settings;                  ///< of the document
        std::size_t n = 0;
        std::optional<FrameChange> change;
    };

    void next();
    void take(std::shared_ptr<const Shown> shown);
    void show();
    [[nodiscard]] static std::shared_ptr<const Shown> draw(const std::shared_ptr<const Scene>& scene,
                                                           const Settings& settings, Motion motion, std::size_t n,
                                                           const std::shared_ptr<const Shown>& last,
                                                           const std::stop_token& stop);

    Document& m_document;
    ViewportWidget& m_viewport;
    MotionLayer m_layer;
    QTimer m_clock;
    std::optional<Motion> m_motion;
    bool m_hasPlate = true;
    std::shared_ptr<const Shown> m_shown;
    std::uint64_t m_changed = 0; ///< pixels, in all frames that were compared
    std::uint64_t m_compared = 0;
    LatestResult<std::shared_ptr<const Shown>> m_result; ///< last: its thread uses the members above
};

} // namespace rasterlens
