#pragma once
#include <QString>

#include <vector>

namespace rasterlens
{

/// What tells one state of a file on the disk from another. A missing file has the default values.
struct FileStamp {
    bool exists = false;
    qint64 bytes = 0;
    qint64 modified = 0; ///< ticks of the file system's clock

    friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// errors  a file that cannot be asked about counts as missing
[[nodiscard]] FileStamp stampOf(const QString& path);

/// A file that a loader asked for, whether it was there or not.
struct InputFile {
    QString path; ///< absolute
    FileStamp stamp;
};

/// While it lives, it lists every file that loaders ask for on this thread. A scene is made of files that only its
/// loaders know: an OBJ names its MTL, the MTL its textures. A caller that watches files opens a log before loading.
///
/// order   as asked for, each path once; only one log at a time on a thread
class InputLog
{
public:
    InputLog();
    ~InputLog();
    InputLog(const InputLog&) = delete;
    InputLog& operator=(const InputLog&) = delete;

    [[nodiscard]] const std::vector<InputFile>& files() const { return m_files; }

    /// For loaders, just before they read `path`: a change while they read counts as one that came later.
    static void note(const QString& path);

private:
    std::vector<InputFile> m_files;
};

} // namespace rasterlens
