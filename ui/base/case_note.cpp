#include "ui/base/case_note.h"

#include <QCoreApplication>
#include <QStringList>

namespace rasterlens
{

QString caseNoteText(const QString& note)
{
    QStringList lines;
    for (const QString& line : note.split(QLatin1Char('\n')))
        lines << (line.isEmpty() ? line : QCoreApplication::translate("HardCase", line.toUtf8().constData()));
    return lines.join(QLatin1Char('\n'));
}

QString caseTitle(const QString& name)
{
    constexpr int kDigits = 3;
    const QString number = name.section(QLatin1Char('_'), 0, 0);
    bool isNumber = false;
    number.toUInt(&isNumber);
    if (!isNumber || number.size() != kDigits)
        return name;
    const QString words = name.section(QLatin1Char('_'), 1).replace(QLatin1Char('_'), QLatin1Char(' '));
    return number + QLatin1Char(' ') + QCoreApplication::translate("HardCase", words.toUtf8().constData());
}

} // namespace rasterlens
