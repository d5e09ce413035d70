#pragma once
#include "core/render/motion.h"
#include "ui/base/latest_result.h"
#include "ui/canvas/figure_sheet.h"
#include "ui/canvas/viewport_widget.h"
#include "ui/document/document.h"
#include "ui/document/render_worker.h"
#include "ui/window/run_animation.h"

#include <QObject>
#include <QRect>

#include <functional>
#include <optional>

namespace rasterlens
{

class MotionMode;
class StepMode;

/// Makes figures for pages and slides of what the canvas shows: the part in sight, at a chosen size of its pixels, with
/// a margin and, below it, a caption, the formula of the present step and a legend.
class FigureExport : public QObject
{
    Q_OBJECT

public:
    /// in  `words`: what the window says of the scene and its settings
    FigureExport(const Document& document, const ViewportWidget& viewport, StepMode& steps, MotionMode& motion,
                 std::function<QString()> words);

    /// in  1..kLargestZoom; nothing: as on the screen
    void setZoom(std::optional<int> zoom) { m_zoom = zoom; }
    [[nodiscard]] std::optional<int> zoom() const { return m_zoom; }
    static constexpr int kLargestZoom = 128;
    /// in  the pixels that figures show; nothing: those in sight
    void setRegion(const std::optional<QRect>& pixels) { m_region = pixels; }
    /// Without texts, a figure is the picture with its overlays alone.
    void setTexts(bool on) { m_texts = on; }
    [[nodiscard]] bool hasTexts() const { return m_texts; }
    /// in  nothing: the words of the window, and the step; empty: no caption
    void setCaption(const std::optional<QString>& caption) { m_caption = caption; }

    /// What is written: picture formats, `svg` and `pdf`.
    [[nodiscard]] static QStringList formats();

    [[nodiscard]] QImage image() const;
    /// The size of image(); empty without a picture.
    [[nodiscard]] QSize size() const;
    /// image() on a white sheet of that size, in its upper left corner.
    [[nodiscard]] QImage imageOn(QSize size) const;
    /// errors  a sentence in the language in use
    [[nodiscard]] std::optional<QString> exportTo(const QString& path) const;
    /// Draws the picture without the present mistakes on a background thread and puts both beside each other;
    /// finished() follows.
    void exportBeforeAfter(const QString& path);
    /// Writes the figures of a run of steps as an animated GIF; finished() follows, unless the user stops it.
    ///
    /// in  the steps are recorded; run: as RunAnimation takes it
    void exportRun(const QString& path, const RunAnimation::Run& run, QWidget* window);
    /// Writes the figures of the frames of a motion as exportRun() does those of steps.
    ///
    /// in  a scene for which whyNotMoved() is empty
    void exportMotion(const QString& path, Motion motion, const RunAnimation::Run& run, QWidget* window);
    [[nodiscard]] bool isBusy() const { return m_right.isBusy(); }

Q_SIGNALS:
    /// errors  a sentence, else empty
    void finished(const QString& path, const QString& error);

private:
    void animate(const QString& path, const RunAnimation::Run& run, RunAnimation::Moments moments, QWidget* window);
    [[nodiscard]] std::optional<ViewportWidget::FigurePart> partOfSheet() const;
    [[nodiscard]] std::optional<ViewportWidget::FigurePart> partWithoutTexts() const;
    [[nodiscard]] QImage imageWithoutTexts() const;
    [[nodiscard]] FigureSheet sheet() const;
    [[nodiscard]] FigureSheet beforeAfter(const FramePtr& right) const;
    [[nodiscard]] FigureTexts texts() const;
    [[nodiscard]] std::vector<LegendEntry> legend() const;
    [[nodiscard]] std::optional<QString> save(const FigureSheet& sheet, const QString& path) const;

    const Document& m_document;
    const ViewportWidget& m_viewport;
    StepMode& m_steps;
    MotionMode& m_motion;
    std::function<QString()> m_words;
    std::optional<int> m_zoom;
    std::optional<QRect> m_region;
    std::optional<ViewportWidget::FigurePart> m_part; ///< that of an animation, wherever the canvas goes
    bool m_texts = true;
    std::optional<QString> m_caption;
    QString m_path; ///< of the pictures before and after
    LatestResult<FramePtr> m_right;
};

} // namespace rasterlens
