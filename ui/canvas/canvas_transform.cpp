#include "ui/canvas/canvas_transform.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr std::array kZoomSteps{1.0 / 32, 1.0 / 16, 1.0 / 12, 1.0 / 8, 1.0 / 6, 1.0 / 4, 1.0 / 3, 1.0 / 2,
                                2.0 / 3,  1.0,      2.0,      3.0,     4.0,     6.0,     8.0,     12.0,
                                16.0,     24.0,     32.0,     48.0,    64.0,    96.0,    128.0};

} // namespace

QPoint CanvasTransform::pixelAt(QPointF canvas) const
{
    const QPointF image = toImage(canvas);
    return {static_cast<int>(std::floor(image.x())), static_cast<int>(std::floor(image.y()))};
}

QRect CanvasTransform::pixelsIn(const QRect& canvas, QSize image) const
{
    const QRect visible(pixelAt(canvas.topLeft()), pixelAt(canvas.bottomRight()));
    return visible.intersected(QRect(QPoint(0, 0), image));
}

std::span<const double> zoomSteps() { return kZoomSteps; }

double nextZoomStep(double zoom, int direction)
{
    constexpr double kSame = 1e-9;
    if (direction > 0) {
        const auto next =
            std::find_if(kZoomSteps.begin(), kZoomSteps.end(), [&](double s) { return s > zoom + kSame; });
        return next == kZoomSteps.end() ? kZoomSteps.back() : *next;
    }
    const auto next = std::find_if(kZoomSteps.rbegin(), kZoomSteps.rend(), [&](double s) { return s < zoom - kSame; });
    return next == kZoomSteps.rend() ? kZoomSteps.front() : *next;
}

} // namespace rasterlens
