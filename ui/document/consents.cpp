#include "ui/document/consents.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace rasterlens
{
namespace
{

constexpr auto kKey = "mayNameFilesOutside";
constexpr int kMost = 200; ///< files; the oldest ones are asked about anew

QString nameOf(const QString& file) { return QDir::cleanPath(QFileInfo(file).absoluteFilePath()); }

QStringList kept() { return QSettings().value(kKey).toStringList(); }

} // namespace

Consents& Consents::ofProgram()
{
    static Consents consents;
    return consents;
}

void Consents::add(const QString& file)
{
    QStringList files = kept();
    files.removeAll(nameOf(file));
    files.prepend(nameOf(file));
    if (files.size() > kMost)
        files.resize(kMost);
    QSettings().setValue(kKey, files);
}

std::function<Outside(const QString& file)> Consents::decided(const QString& own) const
{
    QStringList files = kept();
    if (!own.isEmpty())
        files << nameOf(own);
    return [files, all = m_all](const QString& file) {
        return all || files.contains(nameOf(file)) ? Outside::Allow : Outside::Refuse;
    };
}

/// One file at a time: a session whose model is refused names nothing else.
void Consents::tell(const std::vector<Consent::Refused>& all)
{
    if (all.empty())
        return;
    m_hasTold = true;
    QStringList paths;
    for (const Consent::Refused& one : all)
        paths << one.path;
    paths.removeDuplicates();
    QMetaObject::invokeMethod(
        this, [this, file = all.front().owner, paths] { Q_EMIT refused(file, paths); }, Qt::QueuedConnection);
}

} // namespace rasterlens
