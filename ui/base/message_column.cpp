#include "ui/base/message_column.h"

#include "ui/base/message_bar.h"

#include <QEvent>
#include <QVBoxLayout>

#include <algorithm>

namespace rasterlens
{
namespace
{

constexpr int kMargin = 10; ///< to the edges of the widget below

} // namespace

MessageColumn::MessageColumn(QWidget* under) : QWidget(under)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    under->installEventFilter(this);
    hide();
}

MessageBar* MessageColumn::addBar()
{
    auto* bar = new MessageBar(this);
    layout()->addWidget(bar);
    m_bars.push_back(bar);
    connect(bar, &MessageBar::changed, this, &MessageColumn::place);
    return bar;
}

void MessageColumn::place()
{
    int width = 0;
    for (const MessageBar* bar : m_bars)
        if (!bar->isHidden())
            width = std::max(width, bar->naturalWidth());
    setVisible(width > 0);
    if (width == 0)
        return;
    const QSize room = parentWidget()->size() - QSize(2 * kMargin, 2 * kMargin);
    width = std::min(width, std::max(room.width(), 1));
    const int height = layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(width) : sizeHint().height();
    setGeometry(kMargin + (room.width() - width) / 2, kMargin + room.height() - height, width, height);
    raise();
}

bool MessageColumn::event(QEvent* event)
{
    const bool done = QWidget::event(event);
    if (event->type() == QEvent::LayoutRequest)
        place();
    return done;
}

bool MessageColumn::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize)
        place();
    return QWidget::eventFilter(watched, event);
}

} // namespace rasterlens
