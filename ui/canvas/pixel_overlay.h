#pragma once
#include "ui/canvas/canvas_transform.h"
#include "ui/canvas/wipe.h"

#include <QPoint>
#include <QString>

#include <optional>
#include <span>
#include <vector>

class QPainter;

namespace rasterlens
{

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

/// Whether the painter makes a drawing of lines and areas (SVG, PDF) and not of pixels.
[[nodiscard]] bool isDrawing(const QPainter& painter);

/// Paints the picture, nearest-neighbour from zoom 1 on, and its overlays.
///
/// in    `canvas`: the part of the paint device to fill, in canvas pixels
/// cost  linear in the canvas and in the pixels visible, not in the image
void paintCanvas(QPainter& painter, const QRect& canvas, const CanvasTransform& transform, const RenderedFrame& frame,
                 const OverlayOptions& options);

} // namespace rasterlens
