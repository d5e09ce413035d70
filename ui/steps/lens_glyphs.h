#pragma once
#include "core/observe/step_log.h"
#include "ui/base/inks.h"
#include "ui/steps/lens_model.h"

#include <QColor>
#include <QPointF>
#include <QRect>
#include <QRectF>
#include <QSizeF>
#include <QString>

#include <array>
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

/// Tells which edge has which line and rim, what the signs say, and what the number is; with multi-sampling what the
/// marks of samples say.
struct LensLegend {
    LensLegend(const StepSetup& setup, const Rules& rules, bool withNumbers);

    [[nodiscard]] QSizeF size() const; ///< in the window's type
    /// in  a plate of this size
    void paint(QPainter& painter, const QRectF& plate) const;
    bool operator==(const LensLegend&) const = default;

    std::array<QString, 3> edges;
    bool isPattern;
    AttributeAt attributeAt;
    bool hasNumbers;
};

/// Paints the legend beside the samples that are looked at.
///
/// in   canvas pixels
/// out  its plate; empty: there was no room, and nothing was painted
QRectF paintLensLegend(QPainter& painter, const QRect& canvas, const QRectF& samples, const StepSetup& setup,
                       const LensLegend& legend);

} // namespace rasterlens
