#pragma once
#include <QString>

#include <memory>

namespace rasterlens
{

/// The exclusive right to a folder, among all programs that ask for it. The system takes it back when the program ends,
/// also when it is killed. (QLockFile notes the process number instead, which another program may have by then.)
class FolderLock
{
public:
    /// Null if another program has the right, or if there is no such folder.
    [[nodiscard]] static std::unique_ptr<FolderLock> take(const QString& folder);
    /// Waits until no other program has the right, then takes it. Null if there is no such folder.
    [[nodiscard]] static std::unique_ptr<FolderLock> waitFor(const QString& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    [[nodiscard]] const QString& folder() const { return m_folder; }

private:
    FolderLock(QString folder, int handle);
    static std::unique_ptr<FolderLock> lock(const QString& folder, int operation);

    QString m_folder;
    int m_handle;
};

} // namespace rasterlens
