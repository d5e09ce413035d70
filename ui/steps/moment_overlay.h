#pragma once
#include "core/observe/face_moment.h"
#include "ui/canvas/pixel_overlay.h"
#include "ui/steps/lens_view.h"

#include <optional>
#include <utility>

namespace rasterlens
{

/// Paints what a face has come to while its geometry is stepped: the polygon of that moment with the names of its
/// corners, at a cut also the polygon before it, and a line of words.
class MomentOverlay : public CanvasLayer
{
public:
    /// in  nothing: nothing is painted
    void setMoment(std::optional<FaceMoment> moment, const Rules& rules)
    {
        m_moment = std::move(moment);
        m_rules = rules;
    }
    [[nodiscard]] const std::optional<FaceMoment>& moment() const { return m_moment; }

    void paint(QPainter& painter, const QRect& canvas, const CanvasTransform& transform,
               const OverlayOptions& options) const override;
    [[nodiscard]] bool hidesNumbers() const override { return m_moment.has_value(); }

private:
    void paintOutline(LensView& view, const std::vector<MomentCorner>& corners, const QColor& color, double width,
                      Qt::PenStyle style) const;
    void paintArea(LensView& view) const;
    std::vector<QRectF> paintCorners(LensView& view) const;

    std::optional<FaceMoment> m_moment;
    Rules m_rules;
};

/// What happens in the step, and which corners cannot be shown. In the language in use.
[[nodiscard]] QStringList momentLines(const FaceMoment& moment, const Rules& rules);

} // namespace rasterlens
