#pragma once

class QMenu;
class QScrollArea;
class QToolButton;
class QWidget;

namespace rasterlens
{

/// A button without a frame, in the colour of a link.
[[nodiscard]] QToolButton* makeLink();

/// A link that opens a menu.
[[nodiscard]] QToolButton* makeMenuLink(QMenu* menu);

/// A widget for the inside of a scroll area, through which the card behind is seen.
[[nodiscard]] QWidget* makePanelContent();

/// A scroll area of a panel: no frame, no horizontal scroll bar, and the keyboard's focus goes to what lies inside.
[[nodiscard]] QScrollArea* makePanelScroll();

} // namespace rasterlens
