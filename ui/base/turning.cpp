#include "ui/base/turning.h"

#include <QEvent>
#include <QFontInfo>
#include <QWidget>

#include <utility>

namespace rasterlens
{

Turning::Turning(QWidget* panel, int widthBeside, std::function<void(bool)> turn)
    : QObject(panel), m_panel(panel), m_widthBeside(widthBeside), m_turn(std::move(turn))
{
    panel->installEventFilter(this);
}

void Turning::judge()
{
    const QWidget* holder = m_panel->parentWidget();
    constexpr double kUsualType = 13; // pixels
    const double wanted = m_widthBeside * QFontInfo(m_panel->font()).pixelSize() / kUsualType;
    const bool beside = !holder || holder->width() >= wanted;
    if (m_beside == beside)
        return;
    m_beside = beside;
    m_turn(beside);
}

bool Turning::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == m_panel && event->type() == QEvent::ParentChange && m_panel->parentWidget())
        m_panel->parentWidget()->installEventFilter(this);
    switch (event->type()) {
    case QEvent::Resize:
    case QEvent::ParentChange:
    case QEvent::FontChange:
    case QEvent::StyleChange: judge(); break;
    default: break;
    }
    return QObject::eventFilter(watched, event);
}

} // namespace rasterlens
