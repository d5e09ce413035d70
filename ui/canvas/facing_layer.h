#pragma once
#include "core/questions/screen_faces.h"
#include "ui/canvas/pixel_overlay.h"

#include <cstdint>
#include <memory>
#include <span>

namespace rasterlens
{

/// The view of facings: in place of its colour each pixel shows whether the face that owns it is a front or a back
/// face.
class FacingLayer : public CanvasLayer
{
public:
    /// in  `ids`: the face that owns each pixel of the frame, -1 none; as many as it has pixels
    void show(const RenderedFrame& frame, std::span<const std::int32_t> ids, std::shared_ptr<const ScreenFaces> faces);
    void hide() { m_picture.reset(); }
    /// Null while it is hidden.
    [[nodiscard]] const std::shared_ptr<const RenderedFrame>& picture() const { return m_picture; }
    /// What stands in a pixel: which way its face looks, and with room for details the face.
    [[nodiscard]] QStringList lines(QPoint pixel, NumberRoom room) const;

    void paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
               const OverlayOptions& options) const override;
    [[nodiscard]] bool hidesNumbers() const override { return false; }

private:
    std::shared_ptr<const RenderedFrame> m_picture;
    std::shared_ptr<const ScreenFaces> m_faces;
};

constexpr QRgb kFrontColor = 0xff56b4e9;
constexpr QRgb kBackColor = 0xffd55e00;

} // namespace rasterlens
