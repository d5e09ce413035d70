#pragma once
#include <QPointF>
#include <QRect>
#include <QRectF>
#include <QSize>

#include <span>

namespace rasterlens
{

/// From image pixels to canvas pixels: canvas = origin + zoom * image. From zoom 1 on, both are whole numbers, but for
/// zooms from 1 to 4 on the stage, which are whole quarters.
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

} // namespace rasterlens
