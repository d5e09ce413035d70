#include "ui/window/recent_labels.h"

#include <QDir>
#include <QFileInfo>

namespace rasterlens
{
namespace
{

constexpr qsizetype kFolderLetters = 44;
const QString kSlash = QStringLiteral("/");

QString folderOf(const QString& path)
{
    const QString folder = QFileInfo(path).absolutePath();
    const QString home = QDir::homePath();
    if (folder == home || folder.startsWith(home + kSlash))
        return QStringLiteral("~") + folder.mid(home.size());
    return folder;
}

/// The last `parts` names of a folder, or all of it if at most one would be left out.
QString lastNames(const QString& folder, qsizetype parts)
{
    const QStringList names = folder.split(kSlash);
    return names.size() <= parts + 1 ? folder
                                     : QStringLiteral("\u2026/") + names.mid(names.size() - parts).join(kSlash);
}

/// How many names of the folder stay in a line, at least one.
qsizetype namesThatFit(const QString& folder)
{
    const qsizetype all = folder.count(kSlash) + 1;
    for (qsizetype parts = all; parts > 1; --parts)
        if (lastNames(folder, parts).size() <= kFolderLetters)
            return parts;
    return 1;
}

} // namespace

QStringList recentLabels(const QStringList& paths)
{
    QStringList labels;
    for (const QString& path : paths) {
        const QString name = QFileInfo(path).fileName();
        const QString folder = folderOf(path);
        qsizetype parts = namesThatFit(folder);
        const auto isAmbiguous = [&] {
            for (const QString& other : paths)
                if (other != path && QFileInfo(other).fileName() == name &&
                    lastNames(folderOf(other), parts) == lastNames(folder, parts))
                    return true;
            return false;
        };
        while (parts <= folder.count(kSlash) && isAmbiguous())
            ++parts;
        labels << QStringLiteral("%1  \u2013  %2").arg(name, lastNames(folder, parts));
    }
    return labels;
}

} // namespace rasterlens
