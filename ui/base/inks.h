#pragma once
#include <QColor>

#include <array>

class QPalette;

namespace rasterlens
{

// On the canvas, whose picture may have any colour: signs there have a glyph or an outline as well.
constexpr QRgb kCanvasPlus = 0xff005a8c;
constexpr QRgb kCanvasMinus = 0xff8f3c00; ///< also what is wrong
constexpr QRgb kCanvasInk = 0xff12151a;   ///< outlines, and behind white letters

// Edge walking: the edge from the highest to the lowest corner, a full line, and the two beside it, dashed.
constexpr QRgb kCanvasLongEdge = 0xffaa103b;
constexpr QRgb kCanvasBrokenEdge = 0xff005e80;

/// The hue and the pen style of the edges AB, BC, CA.
struct EdgeLook {
    QRgb color;
    Qt::PenStyle style;
};
constexpr std::array<EdgeLook, 3> kEdgeLooks{
    {{0xff6a3d9a, Qt::SolidLine}, {0xff005f54, Qt::DashLine}, {0xff6f4700, Qt::DotLine}}};

/// Colours that mean something, the same in every panel; never the only sign of it.
struct Inks {
    QColor plus;  ///< inside, passed, the first of two
    QColor minus; ///< outside, failed, the second of two
    QColor third; ///< third curve, third edge
};

[[nodiscard]] bool isDark(const QPalette& palette);
/// Readable on the cards of the palette.
[[nodiscard]] Inks inksFor(const QPalette& palette);
/// The hues of the edges AB, BC, CA as text on the cards of the palette.
[[nodiscard]] std::array<QColor, 3> edgeInksFor(const QPalette& palette);

} // namespace rasterlens
