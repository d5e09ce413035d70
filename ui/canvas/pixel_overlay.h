#pragma once
#include "ui/canvas/canvas_transform.h"
#include "ui/canvas/pixel_numbers.h"
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
    bool wireframe = false;   ///< outlines of all faces that are drawn
    bool boxes = false;       ///< the boxes in which coverage looks for samples
    bool tiles = false;       ///< of the tiled algorithm
    bool outline = true;      ///< of the face that owns the selected pixel
    bool barycentric = false; ///< areas and iso-lines at the selected pixel
    bool midLine = false;     ///< where alpha is nearly one half
    bool texels = false;      ///< the footprint of the selected pixel in the texture
    bool depthBeside = false; ///< the depth buffer in the right half of the canvas
    bool thickLines = false;  ///< presentation
    bool tells = true;        ///< what is known of the hovered pixel
    std::optional<QPoint> selectedPixel;
    std::optional<QPoint> hoveredPixel;
    std::optional<Wipe> wipe;
    QString tag;                            ///< the name of the picture, where there are several
    std::vector<const CanvasLayer*> layers; ///< from the lowest to the highest; not owned
};

/// Whether the painter makes a drawing of lines and areas (SVG, PDF) and not of pixels.
[[nodiscard]] bool isDrawing(const QPainter& painter);

/// Whether a picture is made smaller by the painter's filter, which takes a quarter of the time of means over areas:
/// filled triangles while the camera moves, from half the size on. The filter takes four pixels into account; of a line
/// that is one pixel wide it may leave as little as 1 - 1 / (2 zoom).
[[nodiscard]] bool isScaledQuickly(const RenderedFrame& frame, const CanvasTransform& transform);

/// Paints a picture with its grid, sample positions and pixel values, without other layers.
///
/// in  `linesAt`: what stands in a pixel; empty: what the frame's shading shows
void paintPicture(QPainter& painter, const QRect& canvas, const CanvasTransform& transform, const RenderedFrame& frame,
                  const OverlayOptions& options, const PixelLines& linesAt = {});

/// Paints the frames around the hovered and the selected pixel.
void paintPixelFrames(QPainter& painter, const CanvasTransform& transform, QSize picture,
                      const OverlayOptions& options);

/// Paints the picture, nearest-neighbour from zoom 1 on, and its overlays.
///
/// in    `canvas`: the part of the paint device to fill, in canvas pixels
/// cost  linear in the canvas and in the pixels visible, not in the image
void paintCanvas(QPainter& painter, const QRect& canvas, const CanvasTransform& transform, const RenderedFrame& frame,
                 const OverlayOptions& options);

} // namespace rasterlens
