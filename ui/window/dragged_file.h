#pragma once
#include <QString>

class QDropEvent;
class QMimeData;

namespace rasterlens
{

/// The file of this machine that is dragged; empty where there is none, where the list of addresses is empty, or where
/// the other program has not sent it.
[[nodiscard]] QString draggedFile(const QMimeData& data);

/// Accepts a drag, always as one that leaves the file where it is: who drags to move would delete it afterwards.
///
/// out  false: the other program offers neither a copy nor a link, and the drag is not accepted
bool acceptAsCopy(QDropEvent& event);

} // namespace rasterlens
