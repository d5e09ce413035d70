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

} // namespace rasterlens
