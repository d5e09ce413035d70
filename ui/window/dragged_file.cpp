#include "ui/window/dragged_file.h"

#include <QDropEvent>
#include <QMimeData>
#include <QUrl>

namespace rasterlens
{

QString draggedFile(const QMimeData& data)
{
    const QList<QUrl> addresses = data.urls();
    return !addresses.isEmpty() && addresses.first().isLocalFile() ? addresses.first().toLocalFile() : QString();
}

bool acceptAsCopy(QDropEvent& event)
{
    const Qt::DropActions offered = event.possibleActions();
    if (!(offered & (Qt::CopyAction | Qt::LinkAction)))
        return false;
    event.setDropAction(offered & Qt::CopyAction ? Qt::CopyAction : Qt::LinkAction);
    event.accept();
    return true;
}

} // namespace rasterlens
