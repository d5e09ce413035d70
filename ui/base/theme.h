#pragma once
#include "ui/base/style_sheet.h"

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

/// The colour around the picture. The canvas paints it, so the style sheet has no name for this colour.
[[nodiscard]] QColor canvasColor(ThemeKind kind);

/// `resources/style.qss` with the colours, font sizes and fonts of a look.
///
/// errors  ends the program where the resource is missing
[[nodiscard]] StyleSheet styleSheetOf(const Look& look);

/// Sets style, palette, font and style sheet of the application. The palette's roles are used thus: Window behind the
/// cards, Base the cards, Mid their border, PlaceholderText secondary text, AlternateBase soft accent, Highlight
/// accent.
void applyLook(QApplication& application, const Look& look);

/// The two halves of applyLook(). A large window takes the style sheet once it is built: under a style sheet Qt goes
/// through all children of a widget anew whenever the widget gets another parent.
void applyPlainLook(QApplication& application, const Look& look);
void applyStyleSheet(QApplication& application, const Look& look);

/// Digits of equal width, at the application's size plus `pointDelta`.
[[nodiscard]] QFont numberFont(qreal pointDelta = 0);

[[nodiscard]] QFont textFont(qreal pointDelta, bool bold = false);

} // namespace rasterlens
