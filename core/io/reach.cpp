#include "core/io/reach.h"

#include "core/io/path_bytes.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace rasterlens
{
namespace
{

using Path = std::filesystem::path;

thread_local Consent* present = nullptr;

Path pathOf(const QString& path) { return bytesOfPath(path).toStdString(); }

/// Whether every part of the folder's path begins the other path, too.
bool startsWith(const Path& path, const Path& folder)
{
    return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

} // namespace

bool Reach::covers(const QString& path) const
{
    const QString absolute = QDir(folder).absoluteFilePath(path);
    if (outside == Outside::Allow || absolute.startsWith(QLatin1Char(':')))
        return true;
    if (!startsWith(pathOf(QDir::cleanPath(absolute)), pathOf(QDir::cleanPath(QDir(folder).absolutePath()))))
        return false;
    std::error_code unknown; // a link that leads in a circle, a folder that may not be read
    const Path followed = std::filesystem::weakly_canonical(pathOf(absolute), unknown);
    const Path home = unknown ? Path() : std::filesystem::weakly_canonical(pathOf(folder), unknown);
    return !unknown && startsWith(followed, home);
}

Consent::Consent(Outside outside) : Consent([outside](const QString&) { return outside; }) {}

Consent::Consent(std::function<Outside(const QString& file)> of)
    : m_of(std::move(of)), m_former(std::exchange(present, this))
{
}

Consent::~Consent() { present = m_former; }

Reach Consent::reachOf(const QString& file)
{
    return {QFileInfo(file).absolutePath(), present != nullptr ? present->m_of(file) : Outside::Refuse};
}

void Consent::refuse(const QString& owner, const QString& path)
{
    if (present != nullptr)
        present->m_refused.push_back({owner, path});
}

Reason outsideReason()
{
    return QT_TRANSLATE_NOOP("Diagnostic", "it lies outside the model's folder and is read only if that is allowed "
                                           "(--allow-outside)");
}

} // namespace rasterlens
