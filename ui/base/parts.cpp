#include "ui/base/parts.h"

#include <QHBoxLayout>
#include <QLabel>
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

QWidget* makeTogether(QWidget* name, QWidget* named)
{
    auto* pair = new QWidget;
    auto* row = new QHBoxLayout(pair);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(name);
    row->addWidget(named);
    return pair;
}

QHBoxLayout* makeFieldLine(QWidget* dot, QWidget* name, QWidget* editor, QLabel* key)
{
    auto* line = new QHBoxLayout;
    line->setSpacing(4);
    if (!key)
        key = new QLabel;
    key->setMinimumWidth(14);
    line->addWidget(dot);
    line->addWidget(name, 9);
    line->addWidget(editor, 13);
    line->addWidget(key);
    return line;
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
