#pragma once
#include "core/observe/step_log.h"
#include "ui/steps/lens_model.h"

#include <QColor>
#include <QPointF>
#include <QRect>

#include <array>

class QPainter;

namespace rasterlens
{

/// The hue and the pen style of the edges AB, BC, CA.
struct EdgeLook {
    QRgb color;
    Qt::PenStyle style;
};
constexpr std::array<EdgeLook, 3> kEdgeLooks{
    {{0xff6a3d9a, Qt::SolidLine}, {0xff005f54, Qt::DashLine}, {0xff6f4700, Qt::DotLine}}};

/// The colours of a glyph: filled where the sample was looked at, hollow where it still waits.
struct GlyphColors {
    QColor disc;
    QColor sign;
};
/// Of the application's palette; sign and disc differ by a contrast of at least 7:1.
[[nodiscard]] GlyphColors glyphColors(EdgeSign sign, bool isHollow);

/// A sign in a circle, whose rim has the hue of its edge: 0 AB, 1 BC, 2 CA.
void paintGlyph(QPainter& painter, QPointF centre, double diameter, EdgeSign sign, std::size_t edge, bool isHollow);

/// Tells beside the picture which edge has which line and rim, what the signs say, and what the number is; nothing
/// where there is no room.
///
/// in  canvas pixels
void paintLensLegend(QPainter& painter, const QRect& canvas, const QRectF& picture, const StepSetup& setup,
                     bool hasNumbers);

} // namespace rasterlens
