#pragma once
#include "core/derive/derivation.h"
#include "ui/base/named_places.h"
#include "ui/canvas/pixel_overlay.h"

#include <optional>
#include <utility>
#include <vector>

namespace rasterlens
{

/// The figure of a derivation over the picture: what belongs to the present line with the names of its points, and the
/// symbol under the mouse.
class DerivationLayer : public CanvasLayer
{
public:
    void setMarks(std::vector<CanvasPart> marks) { m_marks = std::move(marks); }
    [[nodiscard]] const std::vector<CanvasPart>& marks() const { return m_marks; }
    /// What has a name of its own in the present line beside the marks: the corners that its symbols belong to.
    void setNamed(std::vector<CanvasPart> parts) { m_named = std::move(parts); }
    /// Whether another layer names the corners of the face: A, B, C, and I1, I2, .. of cuts.
    void setCornersAreNamed(bool on) { m_cornersAreNamed = on; }
    /// The points with a name, as they are painted; pixels of the picture.
    [[nodiscard]] std::vector<NamedPlace> names() const;
    void setHovered(const CanvasPart& part) { m_hovered = part; }

    void paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
               const OverlayOptions& options) const override;
    [[nodiscard]] bool hidesNumbers() const override { return false; }

private:
    void paintNames(QPainter& painter, const QRect& canvas, const CanvasTransform& transform, bool isLarge) const;

    std::vector<CanvasPart> m_marks;
    std::vector<CanvasPart> m_named;
    CanvasPart m_hovered;
    bool m_cornersAreNamed = false;
};

/// Which of the looks of edges (kEdgeLooks) a part of the picture has: that of the edge between its first two corners.
[[nodiscard]] std::optional<std::size_t> edgeLookOf(const CanvasPart& part);

constexpr QRgb kHoveredInk = 0xfff0e442; ///< of the symbol under the mouse

} // namespace rasterlens
