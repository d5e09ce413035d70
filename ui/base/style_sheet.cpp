#include "ui/base/style_sheet.h"

#include <QRegularExpression>
#include <QSet>
#include <QStyle>
#include <QVariant>
#include <QWidget>

namespace rasterlens
{

StyleSheet fillPlaceholders(const QString& sheet, const QMap<QString, QString>& values)
{
    static const QRegularExpression placeholder(QStringLiteral("@([A-Za-z]*)(@?)"));
    StyleSheet filled;
    QSet<QString> used;
    qsizetype done = 0;
    for (auto found = placeholder.globalMatch(sheet); found.hasNext();) {
        const QRegularExpressionMatch match = found.next();
        const QString name = match.captured(1);
        filled.text += QStringView(sheet).mid(done, match.capturedStart() - done);
        done = match.capturedEnd();
        const bool isKnown = !match.captured(2).isEmpty() && values.contains(name);
        filled.text += isKnown ? values[name] : match.captured();
        if (isKnown)
            used.insert(name);
        else
            filled.unknown << match.captured();
    }
    filled.text += QStringView(sheet).mid(done);
    for (auto value = values.keyBegin(); value != values.keyEnd(); ++value)
        if (!used.contains(*value))
            filled.unused << *value;
    return filled;
}

void setStyleProperty(QWidget& widget, const char* name, const QVariant& value)
{
    if (widget.property(name) == value)
        return;
    widget.setProperty(name, value);
    widget.style()->unpolish(&widget);
    widget.style()->polish(&widget);
    widget.update();
}

} // namespace rasterlens
