#pragma once
#include "ui/document/render_worker.h"

#include <QPointF>
#include <QRect>
#include <QRectF>
#include <QSize>

#include <optional>
#include <span>
#include <vector>

class QPainter;

namespace rasterlens
{

/// From image pixels to canvas pixels: canvas = origin + zoom * image. From zoom 1 on, both are whole numbers.
struct CanvasTransform {
    double zoom = 1;
    QPointF origin{0, 0};

    [[nodiscard]] QPointF toCanvas(QPointF image) const { return origin + image * zoom; }
    [[nodiscard]] QPointF toImage(QPointF canvas) const { return (canvas - origin) / zoom; }
    [[nodiscard]] QRectF toCanvas(QRectF image) const { return {toCanvas(image.topLeft()), image.size() * zoom}; }
    [[nodiscard]] QPoint pixelAt(QPointF canvas) const;

    /// The pixels that a part of the canvas shows, cut to the image.
    [[nodiscard]] QRect pixelsIn(const QRect& canvas, QSize image) const;

    friend bool operator==(const CanvasTransform&, const CanvasTransform&) = default;
};

/// The zoom steps of the wheel, growing.
[[nodiscard]] std::span<const double> zoomSteps();
[[nodiscard]] double nextZoomStep(double zoom, int direction);

constexpr double kGridFromZoom = 8;
constexpr double kSampleDotsFromZoom = 16;
constexpr double kNumbersFromZoom = 48;

struct OverlayOptions;

/// Something more to be painted over the picture and its grid.
class CanvasLayer
{
public:
    virtual ~CanvasLayer() = default;
    virtual void paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                       const OverlayOptions& options) const = 0;
    /// The pixel values would be in the way.
    [[nodiscard]] virtual bool hidesNumbers() const = 0;
};

/// Another picture of the same size in the left part of the canvas.
struct Wipe {
    FramePtr left;
    double at = 0.5; ///< where it ends, as a fraction of the picture's width
};

/// What lies over the picture. Each is drawn from its zoom on.
struct OverlayOptions {
    bool grid = true;
    bool sampleDots = true;
    bool numbers = true;
    bool thickLines = false; ///< presentation
    std::optional<QPoint> selectedPixel;
    std::optional<QPoint> hoveredPixel;
    std::optional<Wipe> wipe;
    QString tag;                            ///< the name of the picture, where there are several
    std::vector<const CanvasLayer*> layers; ///< from the lowest to the highest; not owned
};

/// Paints the picture, nearest-neighbour from zoom 1 on, and its overlays.
///
/// in    `canvas`: the part of the paint device to fill, in canvas pixels
/// cost  linear in the canvas and in the pixels visible, not in the image
void paintCanvas(QPainter& painter, const QRect& canvas, const CanvasTransform& transform, const RenderedFrame& frame,
                 const OverlayOptions& options);

} // namespace rasterlens
