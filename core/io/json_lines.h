#pragma once
#include <QByteArray>
#include <QMap>
#include <QString>
#include <QStringList>

namespace rasterlens
{

/// The line of a JSON text on which each of its values stands, which QJsonDocument does not tell.
///
/// A *path* names a value by the keys and indices that lead to it, with slashes between them: `steps/2/caption/en`. The
/// path of the whole text is empty.
class JsonLines
{
public:
    /// in    a text that QJsonDocument reads without an error
    /// cost  linear in the text
    explicit JsonLines(const QByteArray& text);

    /// The line, counted from 1, of the key of a member or of the first character of an element. Where the text has no
    /// value of this path, the line of the innermost value around it.
    [[nodiscard]] int lineOf(QString path) const;

    /// The paths of keys that stand twice in one object; QJsonDocument keeps the last value of each. With its line.
    [[nodiscard]] const QMap<QString, int>& repeated() const { return m_repeated; }

private:
    QMap<QString, int> m_lines;
    QMap<QString, int> m_repeated;
};

/// The path of a member or an element of the value at `path`.
[[nodiscard]] QString jsonPath(const QString& path, const QString& key);

} // namespace rasterlens
