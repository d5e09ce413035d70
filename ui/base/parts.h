#pragma once

class QHBoxLayout;
class QLabel;
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

/// A name and what it names, which never stand in two lines of a FlowLayout.
[[nodiscard]] QWidget* makeTogether(QWidget* name, QWidget* named);

/// The line of a field of the settings: a dot or the room of one, the name, what is edited, and the hint at a key or
/// the room of one.
[[nodiscard]] QHBoxLayout* makeFieldLine(QWidget* dot, QWidget* name, QWidget* editor, QLabel* key = nullptr);

/// A widget for the inside of a scroll area, through which the card behind is seen.
[[nodiscard]] QWidget* makePanelContent();

/// A scroll area of a panel: no frame, no horizontal scroll bar, and the keyboard's focus goes to what lies inside.
[[nodiscard]] QScrollArea* makePanelScroll();

} // namespace rasterlens
