#include "core/lessons/step_run.h"

#include <QStringList>

namespace rasterlens
{

std::optional<std::pair<std::size_t, std::size_t>> stepRunFromText(const QString& text)
{
    const QStringList ends = text.split(QLatin1Char('-'));
    bool isFirst = false;
    bool isLast = false;
    const qulonglong first = ends.value(0).toULongLong(&isFirst);
    const qulonglong last = ends.value(1).toULongLong(&isLast);
    if (ends.size() != 2 || !isFirst || !isLast || last < first)
        return std::nullopt;
    return std::pair(static_cast<std::size_t>(first), static_cast<std::size_t>(last));
}

} // namespace rasterlens
