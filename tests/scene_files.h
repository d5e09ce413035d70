#pragma once
// Files made for a test, and the diagnostics they lead to.
#include "core/scene/scene.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace rasterlens::test
{

class Folder
{
public:
    /// Writes a file and returns its path.
    QString write(const QString& name, const QByteArray& text) const
    {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("cannot write %s", qPrintable(file.fileName()));
        return file.fileName();
    }

    QString path(const QString& name = {}) const { return name.isEmpty() ? m_folder.path() : m_folder.filePath(name); }

private:
    QTemporaryDir m_folder;
};

/// All remarks, one a line.
inline QString textOf(const Diagnostics& diagnostics)
{
    QStringList lines;
    for (const Diagnostic& diagnostic : diagnostics)
        lines << diagnostic.text();
    return lines.join(QLatin1Char('\n'));
}

/// Fails unless one of the remarks begins with `prefix` and holds `phrase`.
inline void verifyRemark(const Diagnostics& diagnostics, const QString& prefix, const QString& phrase)
{
    for (const Diagnostic& diagnostic : diagnostics)
        if (diagnostic.text().startsWith(prefix) && textOf(diagnostic.message).contains(phrase))
            return;
    QFAIL(qPrintable(QStringLiteral("expected \"%1 ..%2..\", got:\n%3").arg(prefix, phrase, textOf(diagnostics))));
}

} // namespace rasterlens::test
