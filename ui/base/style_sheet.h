#pragma once
#include <QMap>
#include <QString>
#include <QStringList>

class QVariant;
class QWidget;

namespace rasterlens
{

/// A style sheet whose placeholders have been filled.
struct StyleSheet {
    QString text;
    QStringList unknown; ///< placeholders without a value, which stay in the text
    QStringList unused;  ///< names of values that no placeholder asks for
};

/// Puts values in the place of `@name@`. An @ without its second one is an unknown placeholder, too.
[[nodiscard]] StyleSheet fillPlaceholders(const QString& sheet, const QMap<QString, QString>& values);

/// Sets a property that selectors of the style sheet ask for, as `QLabel[kind="error"]` does, and styles the widget
/// anew where that changes the property.
void setStyleProperty(QWidget& widget, const char* name, const QVariant& value);

} // namespace rasterlens
