#include "ui/base/parts.h"

#include <QMenu>
#include <QScrollArea>
#include <QToolButton>

namespace rasterlens
{

QToolButton* makeLink()
{
    auto* link = new QToolButton;
    link->setObjectName(QStringLiteral("link"));
    link->setCursor(Qt::PointingHandCursor);
    return link;
}

QToolButton* makeMenuLink(QMenu* menu)
{
    QToolButton* link = makeLink();
    link->setPopupMode(QToolButton::InstantPopup);
    link->setMenu(menu);
    return link;
}

QWidget* makePanelContent()
{
    auto* content = new QWidget;
    content->setObjectName(QStringLiteral("panelContent"));
    return content;
}

QScrollArea* makePanelScroll()
{
    auto* scroll = new QScrollArea;
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    return scroll;
}

} // namespace rasterlens
