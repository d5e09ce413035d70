#pragma once
#include <QColor>

class QPalette;

namespace rasterlens
{

// On the canvas, whose picture may have any colour: signs there have a glyph or an outline as well.
constexpr QRgb kCanvasPlus = 0xff005a8c;
constexpr QRgb kCanvasMinus = 0xff8f3c00; ///< also what is wrong
constexpr QRgb kCanvasInk = 0xff12151a;   ///< outlines, and behind white letters

/// Colours that mean something, the same in every panel; never the only sign of it.
struct Inks {
    QColor plus;  ///< inside, passed, the first of two
    QColor minus; ///< outside, failed, the second of two
    QColor third; ///< third curve, third edge
};

[[nodiscard]] bool isDark(const QPalette& palette);
/// Readable on the cards of the palette.
[[nodiscard]] Inks inksFor(const QPalette& palette);

} // namespace rasterlens
