#pragma once
#include <QDockWidget>

namespace rasterlens
{

/// Shows a dock, before the other tabs of its place. raise() alone does nothing for the dock that was raised last,
/// though another tab may lie over it since: a click on a tab does not change the order of the docks.
inline void bringToFront(QDockWidget& dock)
{
    dock.show();
    dock.lower();
    dock.raise();
}

} // namespace rasterlens
