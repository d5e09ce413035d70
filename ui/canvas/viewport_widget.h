#pragma once
#include "ui/base/image_export.h"
#include "ui/canvas/depth_picture.h"
#include "ui/canvas/pixel_overlay.h"

#include <QTimer>
#include <QWidget>

#include <optional>

namespace rasterlens
{

/// What is known about one pixel of the present picture.
struct PixelReadout {
    QPoint pixel;
    QRgb color = 0;
    std::optional<float> depth;
    std::optional<int> face; ///< -1: background
    int line = -1;           ///< of the `f` in the scene's file that the face is a part of; -1 none
};

/// The canvas: shows the picture, zooms at the cursor to single pixels, and turns mouse and keys into camera moves.
class ViewportWidget : public QWidget
{
    Q_OBJECT

public:
    /// What the left button drags.
    enum class LeftDrag { Orbits, PansCanvas };

    explicit ViewportWidget(QWidget* parent = nullptr);

    void setFrame(const FramePtr& frame);
    [[nodiscard]] const FramePtr& frame() const { return m_frame; }
    void setLeftDrag(LeftDrag what) { m_leftDrag = what; }
    /// The picture shown is not of the present settings.
    void setStale(bool stale);
    void setCanvasColor(const QColor& color);
    void setThickLines(bool on);
    /// Pixels are an answer: a click or the arrows choose one without selecting it, and nothing is told of it.
    void setAnswering(bool on);
    [[nodiscard]] bool isAnswering() const { return !m_options.tells; }
    /// A part of the canvas that something lies over: fit() keeps the picture clear of it, where that costs little of
    /// its size, and showPixel() its pixel.
    void setCovered(const QRect& part);
    /// Another picture in the left part, and the name of the one shown where there are several.
    void setCompared(const FramePtr& left, const QString& tag);
    /// Where the wipe ends, as a fraction of the picture's width.
    void setWipeAt(double at);
    /// in  painted over the picture and the layers before it, also in figures; until it is removed
    void addLayer(const CanvasLayer* layer);
    void removeLayer(const CanvasLayer* layer);
    /// Brings a pixel that is out of sight into the middle.
    void showPixel(QPoint pixel);

    [[nodiscard]] const CanvasTransform& transform() const { return m_transform; }
    [[nodiscard]] bool isFitted() const { return m_fitted; }
    /// Frames the image, or the given pixels of it, and keeps doing so when the widget is resized.
    void fit(const std::optional<PixelRect>& pixels = std::nullopt);
    /// Shows the surroundings of a point of the picture, and keeps it in the middle when the widget is resized.
    void showAround(QPointF image, double zoom);
    /// The middle of the canvas, or of what the badge leaves free.
    [[nodiscard]] QPointF middle() const;
    void setZoom(double zoom) { zoomAt(pane().center(), zoom); }
    void zoomStep(int direction) { zoomAt(pane().center(), nextZoomStep(m_transform.zoom, direction)); }
    void zoomAt(QPointF canvas, double zoom);

    [[nodiscard]] std::optional<QPoint> selectedPixel() const { return m_options.selectedPixel; }
    [[nodiscard]] std::optional<QPoint> hoveredPixel() const { return m_options.hoveredPixel; }
    void selectPixel(std::optional<QPoint> pixel);
    /// Selects the pixel and brings it into the middle, large enough to see.
    void goToPixel(QPoint pixel);
    [[nodiscard]] std::optional<PixelReadout> readout(QPoint pixel) const;

    [[nodiscard]] const OverlayOptions& overlays() const { return m_options; }
    void setOverlays(const OverlayOptions& options);

    /// Where the picture is shown: the whole canvas, or its left half while the depth buffer is shown beside it.
    [[nodiscard]] QRect pane() const;
    /// Where the depth buffer is shown; empty while it is not.
    [[nodiscard]] QRect depthPane() const;
    /// The depth buffer of the frame as it is shown beside it; null while it is not, or not known.
    [[nodiscard]] const std::shared_ptr<const DepthPicture>& depthShown() const { return m_depthShown; }
    /// A part of the picture and how it is painted.
    struct FigurePart {
        CanvasTransform transform;
        QSize picture; ///< canvas pixels
        QSize size;    ///< with the depth buffer beside the picture
    };
    /// The visible part as it is shown, or the whole image at a zoom.
    ///
    /// errors  nothing without a picture, and where the figure would be too large
    [[nodiscard]] std::optional<FigurePart> figurePart(std::optional<int> zoom) const;
    /// The part of the picture that is in sight, as it is shown or at another zoom; or some pixels of it.
    ///
    /// errors  nothing without a picture, and where the figure would be too large
    [[nodiscard]] std::optional<FigurePart> partInSight(std::optional<int> zoom,
                                                        const std::optional<QRect>& pixels = std::nullopt) const;
    /// Paints a part with its overlays.
    ///
    /// in  `instead`: another picture of the same size, without the layers that belong to the one shown; null: that one
    void paintFigure(QPainter& painter, const FigurePart& part, const RenderedFrame* instead = nullptr) const;

    /// The picture with its overlays: the visible part as it is shown, or the whole image at a zoom.
    ///
    /// errors  a null image where the figure would be too large
    [[nodiscard]] QImage figure(std::optional<int> zoom = std::nullopt) const;
    /// Writes the figure as an SVG drawing of lines and areas.
    ///
    /// errors  a sentence in the language in use
    [[nodiscard]] std::optional<QString> saveSvgFigure(std::optional<int> zoom, const ExportTarget& target) const;

    QSize sizeHint() const override { return {640, 480}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

Q_SIGNALS:
    void viewChanged();               ///< zoom or origin
    void pixelChanged();              ///< hovered or selected pixel
    void pixelChosen();               ///< by a click
    void pixelAnswered(QPoint pixel); ///< by a click, while pixels are an answer
    void orbited(QPointF drag);
    void cameraPanned(QPointF drag);
    void dollied(double factor);
    void gestureEnded();
    void frameShown(const rasterlens::FramePtr& frame); ///< painted for the first time

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    enum class Drag { None, PanCanvas, Orbit, PanCamera, Dolly, Wipe };

    [[nodiscard]] Drag dragFor(const QMouseEvent& event) const;
    [[nodiscard]] bool looksLikeTheShown(const RenderedFrame& frame) const;
    [[nodiscard]] QSize imageSize() const;
    [[nodiscard]] CanvasTransform fitted(const QRectF& shown, const QRect& place, int margin) const;
    [[nodiscard]] CanvasTransform fittedBesideBadge(const QRectF& shown) const;
    void applyFit();
    void placeAgain();
    void leaveFit();
    void setTransform(CanvasTransform transform);
    void hover(std::optional<QPoint> pixel);
    void nudge(QPoint step);
    void choose(QPoint pixel);
    [[nodiscard]] bool isOnWipe(QPointF canvas) const;
    void moveWipe(double column);
    void paintStaleMark(QPainter& painter) const;
    void paintFocus(QPainter& painter) const;
    void paintPanes(QPainter& painter) const;
    void syncDepth();
    [[nodiscard]] QPointF inPane(QPointF canvas) const;

    FramePtr m_frame;
    CanvasTransform m_transform;
    OverlayOptions m_options;
    Wipe m_wipe;
    std::shared_ptr<const DepthPicture> m_depthShown;
    std::optional<PixelRect> m_fitPixels;
    bool m_fitted = true;
    std::optional<QPointF> m_centre; ///< of the picture, kept in the middle; none once the user has moved it
    bool m_stale = false;
    bool m_frameShown = true;
    QRect m_covered;
    QColor m_canvasColor;
    LeftDrag m_leftDrag = LeftDrag::Orbits;
    Drag m_drag = Drag::None;
    QPointF m_pressedAt;
    QPointF m_lastDragAt;
    bool m_moved = false;
    int m_wheelRest = 0;   ///< eighths of a degree not yet spent
    QTimer m_wheelGesture; ///< a pause ends the wheel's gesture
};

} // namespace rasterlens
