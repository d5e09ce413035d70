#pragma once
#include <QColor>

class QPalette;

namespace rasterlens
{

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
