#include "ui/canvas/depth_picture.h"

#include "ui/canvas/wipe.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rasterlens
{
namespace
{

constexpr int kDecimals = 4;

QString depthText(float depth) { return QString::number(double(depth), 'f', kDecimals); }

/// The range of the depths that faces have stored; 0 to 1 where there are none.
void findRange(const RenderedFrame& frame, DepthPicture& picture)
{
    const DepthBuffer& depth = frame.frame.depth;
    float low = std::numeric_limits<float>::infinity();
    float high = -low;
    for (std::size_t i = 0; i < depth.size(); ++i) {
        const float value = depth[i];
        if (value > 0 && value < 1) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    if (low < high) {
        picture.black = low;
        picture.white = high;
    }
}

} // namespace

std::shared_ptr<const DepthPicture> depthPicture(const RenderedFrame& frame)
{
    const QSize size = frame.frame.image.size();
    const DepthBuffer& depth = frame.frame.depth;
    const auto width = static_cast<std::size_t>(size.width());
    if (!frame.counted || depth.size() != width * static_cast<std::size_t>(size.height()))
        return nullptr;
    auto picture = std::make_shared<DepthPicture>();
    findRange(frame, *picture);
    picture->shown.scene = frame.scene;
    picture->shown.settings = frame.settings;
    QImage image(size, QImage::Format_RGB32);
    const float scale = 255 / (picture->white - picture->black);
    for (int y = 0; y < size.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (std::size_t x = 0; x < width; ++x) {
            const float grey = (depth[std::size_t(y) * width + x] - picture->black) * scale;
            const int channel = grey > 0 ? static_cast<int>(std::lround(std::min(grey, 255.0F))) : 0;
            row[x] = qRgb(channel, channel, channel);
        }
    }
    picture->shown.frame.image = std::move(image);
    return picture;
}

QStringList depthLines(const RenderedFrame& frame, QPoint pixel)
{
    const auto index = std::size_t(pixel.y()) * std::size_t(frame.frame.image.width()) + std::size_t(pixel.x());
    return {depthText(frame.frame.depth[index])};
}

void paintDepthPicture(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                       const RenderedFrame& frame, const DepthPicture* picture, const OverlayOptions& options)
{
    if (!picture) {
        paintTag(painter, canvas, QCoreApplication::translate("rasterlens::DepthPicture", "Depth buffer: not known"));
        return;
    }
    OverlayOptions own = options;
    own.layers.clear();
    paintPicture(painter, canvas, transform, picture->shown, own,
                 [&](QPoint pixel, NumberRoom) { return depthLines(frame, pixel); });
    paintPixelFrames(painter, transform, frame.frame.image.size(), own);
    paintTag(painter, canvas,
             QCoreApplication::translate("rasterlens::DepthPicture", "Depth buffer: black %1, white %2")
                 .arg(depthText(picture->black), depthText(picture->white)));
}

} // namespace rasterlens
