#include "ui/document/folder_lock.h"

#include <QFile>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <utility>

namespace rasterlens
{

FolderLock::FolderLock(QString folder, int handle) : m_folder(std::move(folder)), m_handle(handle) {}

FolderLock::~FolderLock() { ::close(m_handle); }

std::unique_ptr<FolderLock> FolderLock::lock(const QString& folder, int operation)
{
    // A file in the folder, open for writing: network file systems lock nothing else.
    const QByteArray path = QFile::encodeName(folder + QStringLiteral("/lock"));
    const int handle = ::open(path.constData(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
    if (handle < 0)
        return nullptr;
    if (::flock(handle, operation) != 0) {
        ::close(handle);
        return nullptr;
    }
    return std::unique_ptr<FolderLock>(new FolderLock(folder, handle));
}

std::unique_ptr<FolderLock> FolderLock::take(const QString& folder) { return lock(folder, LOCK_EX | LOCK_NB); }

std::unique_ptr<FolderLock> FolderLock::waitFor(const QString& folder) { return lock(folder, LOCK_EX); }

} // namespace rasterlens
