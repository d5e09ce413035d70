#pragma once
#include "core/observe/step_log.h"
#include "ui/base/inks.h"
#include "ui/steps/lens_model.h"

#include <QColor>
#include <QPointF>
#include <QRect>

#include <cstddef>

class QPainter;

namespace rasterlens
{

/// The colours of a glyph: filled where the sample was looked at, hollow where it still waits.
struct GlyphColors {
    QColor disc;
    QColor sign;
};
/// The colours in the application's palette: sign and disc differ by a contrast of at least 7:1.
[[nodiscard]] GlyphColors glyphColors(EdgeSign sign, bool isHollow);

/// The colour that veils a sample: what is inside, and what was looked at.
[[nodiscard]] QColor lensVeil(const LensCell& cell, const QColor& paper);
/// The colour of the number on the veil.
[[nodiscard]] QColor lensNumberColor(LensCell::State state);

/// A sign in a circle, whose rim has the hue of its edge: 0 AB, 1 BC, 2 CA.
void paintGlyph(QPainter& painter, QPointF centre, double diameter, EdgeSign sign, std::size_t edge, bool isHollow);

/// Tells beside the picture which edge has which line and rim, what the signs say, and what the number is; with
/// multi-sampling what the marks of samples say. Nothing where there is no room.
///
/// in  canvas pixels
void paintLensLegend(QPainter& painter, const QRect& canvas, const QRectF& picture, const StepSetup& setup,
                     const Rules& rules, bool hasNumbers);

} // namespace rasterlens
