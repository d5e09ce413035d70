#include "ui/window/focus_order.h"

#include <QApplication>
#include <QDockWidget>
#include <QScrollArea>
#include <QWidget>

#include <algorithm>
#include <utility>

namespace rasterlens
{

FocusOrder::FocusOrder(QWidget& window, QWidget& canvas, std::vector<QWidget*> groups)
    : QObject(&window), m_window(window), m_canvas(canvas), m_groups(std::move(groups))
{
    connect(qApp, &QApplication::focusChanged, this, [this](const QWidget* old, const QWidget* now) {
        const bool wasLeft = old && !now && old->window() == &m_window && m_window.isActiveWindow();
        if (wasLeft && !QApplication::activePopupWidget() && !QApplication::activeModalWidget())
            m_canvas.setFocus(Qt::OtherFocusReason);
    });
}

std::size_t FocusOrder::groupOf(const QWidget* widget) const
{
    const auto holds = [widget](const QWidget* group) { return group == widget || group->isAncestorOf(widget); };
    return static_cast<std::size_t>(std::ranges::find_if(m_groups, holds) - m_groups.begin());
}

/// Whether the widget is part of a panel whose tab is not the front one: the layout puts that outside of the window.
bool FocusOrder::liesBehind(const QWidget& widget) const
{
    for (const QWidget* around = &widget; around; around = around->parentWidget())
        if (qobject_cast<const QDockWidget*>(around))
            return !m_window.rect().intersects(around->geometry());
    return false;
}

std::vector<QWidget*> FocusOrder::widgets() const
{
    std::vector<QWidget*> found;
    QWidget* widget = &m_window;
    do {
        const bool takesTab = (widget->focusPolicy() & Qt::TabFocus) == Qt::TabFocus && !widget->focusProxy();
        if (takesTab && widget->isVisibleTo(&m_window) && widget->isEnabled() && widget->window() == &m_window &&
            !liesBehind(*widget))
            found.push_back(widget);
        widget = widget->nextInFocusChain();
    } while (widget != &m_window);
    std::ranges::stable_sort(found, {}, [this](const QWidget* w) { return groupOf(w); });
    return found;
}

bool FocusOrder::move(bool forward)
{
    const std::vector<QWidget*> all = widgets();
    if (all.empty())
        return false;
    const auto present = std::ranges::find(all, m_window.focusWidget());
    const auto count = static_cast<std::ptrdiff_t>(all.size());
    const auto at = present == all.end() ? (forward ? -1 : 0) : present - all.begin();
    QWidget* next = all[static_cast<std::size_t>((at + (forward ? 1 : count - 1)) % count)];
    next->setFocus(forward ? Qt::TabFocusReason : Qt::BacktabFocusReason);
    for (QWidget* around = next->parentWidget(); around; around = around->parentWidget())
        if (auto* scroll = qobject_cast<QScrollArea*>(around))
            scroll->ensureWidgetVisible(next);
    return true;
}

} // namespace rasterlens
