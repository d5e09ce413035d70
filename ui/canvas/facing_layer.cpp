#include "ui/canvas/facing_layer.h"

#include "ui/base/theme.h"
#include "ui/canvas/overlay_inks.h"
#include "ui/canvas/pixel_numbers.h"

#include <QCoreApplication>
#include <QPainter>

#include <utility>

namespace rasterlens
{
namespace
{

QString sideText(bool front)
{
    return front ? QCoreApplication::translate("rasterlens::FacingLayer", "front")
                 : QCoreApplication::translate("rasterlens::FacingLayer", "back");
}

} // namespace

void FacingLayer::show(const RenderedFrame& frame, std::span<const std::int32_t> ids,
                       std::shared_ptr<const ScreenFaces> faces)
{
    auto picture = std::make_shared<RenderedFrame>();
    picture->scene = frame.scene;
    picture->settings = frame.settings;
    picture->frame.ids.assign(ids.begin(), ids.end());
    QImage image = frame.frame.image.copy();
    const auto width = static_cast<std::size_t>(image.width());
    for (int y = 0; y < image.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (std::size_t x = 0; x < width; ++x) {
            const std::int32_t face = ids[std::size_t(y) * width + x];
            if (face >= 0)
                row[x] = faces->faces[static_cast<std::size_t>(face)].front ? kFrontColor : kBackColor;
        }
    }
    picture->frame.image = std::move(image);
    m_picture = std::move(picture);
    m_faces = std::move(faces);
}

QStringList FacingLayer::lines(QPoint pixel, NumberRoom room) const
{
    const auto at = std::size_t(pixel.y()) * std::size_t(m_picture->frame.image.width()) + std::size_t(pixel.x());
    const std::int32_t face = m_picture->frame.ids[at];
    if (face < 0)
        return {QString()};
    QStringList lines{sideText(m_faces->faces[static_cast<std::size_t>(face)].front)};
    if (room == NumberRoom::Details)
        lines << QStringLiteral("#%1").arg(face);
    return lines;
}

void FacingLayer::paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
                        const OverlayOptions& options) const
{
    if (!m_picture)
        return;
    paintPicture(painter, canvas, transform, *m_picture, options,
                 [this](QPoint pixel, NumberRoom room) { return lines(pixel, room); });
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(textFont(0, true));
    const QPointF corner(canvas.bottomRight()); // plates are held within the canvas
    const QRect room = canvas.adjusted(6, 6, -6, -6);
    const QRectF back = paintPlate(painter, room, corner, sideText(false), kBackColor);
    paintPlate(painter, room.adjusted(0, 0, -int(back.width()) - 8, 0), corner, sideText(true), kFrontColor);
    painter.restore();
}

} // namespace rasterlens
