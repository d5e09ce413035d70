#include "ui/base/turning.h"

#include <QEvent>
#include <QWidget>

#include <utility>

namespace rasterlens
{

Turning::Turning(QWidget* panel, int widthBeside, std::function<void(bool)> turn)
    : QObject(panel), m_panel(panel), m_widthBeside(widthBeside), m_turn(std::move(turn))
{
    panel->installEventFilter(this);
}

void Turning::setWidthBeside(int width)
{
    m_widthBeside = width;
    judge();
}

void Turning::judge()
{
    const QWidget* holder = m_panel->parentWidget();
    const bool beside = !holder || holder->width() >= m_widthBeside;
    if (m_beside == beside)
        return;
    m_beside = beside;
    m_turn(beside);
}

bool Turning::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_panel && event->type() == QEvent::ParentChange && m_panel->parentWidget())
        m_panel->parentWidget()->installEventFilter(this);
    if (event->type() == QEvent::Resize || event->type() == QEvent::ParentChange)
        judge();
    return QObject::eventFilter(watched, event);
}

} // namespace rasterlens
