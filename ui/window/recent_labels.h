#pragma once
#include <QStringList>

namespace rasterlens
{

/// What a menu says of recent files: the name and as much of the folder as fits in a line, from its end; more of it
/// where two files of one name could otherwise not be told apart.
///
/// order   as `paths`, which are absolute
[[nodiscard]] QStringList recentLabels(const QStringList& paths);

} // namespace rasterlens
