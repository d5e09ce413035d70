#pragma once
#include <QColor>
#include <QFont>

class QApplication;

namespace rasterlens
{

enum class ThemeKind { Light, Dark };

/// The look of the whole window.
struct Look {
    ThemeKind kind = ThemeKind::Light;
    bool presentation = false; ///< 18 pt and thick lines, readable from the last row

    friend bool operator==(const Look&, const Look&) = default;
};

/// Colours beyond those of QPalette. The palette's roles are used thus: Window behind the cards, Base the cards, Mid
/// their border, PlaceholderText secondary text, AlternateBase soft accent, Highlight accent.
struct ThemeColors {
    QColor window, card, border, text, muted, accent, onAccent, accentSoft, canvas;
    QColor infoFill, warningFill, errorFill, errorText;
};

[[nodiscard]] const ThemeColors& themeColors(ThemeKind kind);

/// Sets style, palette, font and style sheet of the application.
void applyLook(QApplication& application, const Look& look);

/// Digits of equal width, at the application's size plus `pointDelta`.
[[nodiscard]] QFont numberFont(qreal pointDelta = 0);

[[nodiscard]] QFont textFont(qreal pointDelta, bool bold = false);

} // namespace rasterlens
