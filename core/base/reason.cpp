#include "core/base/reason.h"

#include <QStringList>

#include <iterator>

namespace rasterlens
{

QString textOf(const Reason& reason, Translate translate)
{
    if (reason.text == nullptr)
        return reason.name;
    const QString text = translate != nullptr ? translate(reason.text) : QString::fromUtf8(reason.text);
    // One pass, as a name may hold a %1 itself.
    const QStringList parts = text.split(QLatin1Char('%'));
    QString words = parts.front();
    for (const QString& part : parts.sliced(1)) {
        const int place = part.isEmpty() ? 0 : part.front().digitValue();
        const bool isFilled = place > 0 && place <= std::ssize(reason.arguments);
        words += isFilled ? textOf(reason.arguments[static_cast<std::size_t>(place - 1)], translate) + part.sliced(1)
                          : QLatin1Char('%') + part;
    }
    return words;
}

} // namespace rasterlens
