#include "core/io/file_writer.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSaveFile>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <mutex>
#include <system_error>
#include <utility>
#include <vector>

#ifdef Q_OS_UNIX
#include <fcntl.h>
#include <unistd.h>
#endif

namespace rasterlens
{
namespace
{

/// The number behind the name of an open stream: `-`, `/dev/stdout`, `/dev/fd/7`.
std::optional<int> descriptorOf(const QString& path)
{
    if (path == QLatin1String("-") || path == QLatin1String("/dev/stdout"))
        return 1;
    if (path == QLatin1String("/dev/stderr"))
        return 2;
    for (const QLatin1String folder : {QLatin1String("/dev/fd/"), QLatin1String("/proc/self/fd/")})
        if (path.startsWith(folder)) {
            bool isNumber = false;
            const int number = path.mid(folder.size()).toInt(&isNumber);
            return isNumber ? std::optional(number) : std::nullopt;
        }
    return std::nullopt;
}

#ifdef Q_OS_UNIX
volatile std::sig_atomic_t heldSignal = 0;

extern "C" void holdSignal(int signal) { heldSignal = signal; }

/// While it lives, a signal that would end the program at once waits: what lies beside its place is taken away first.
/// A program that has handlers of its own for these signals keeps them.
class HeldSignals
{
public:
    HeldSignals()
    {
        const std::scoped_lock lock(s_mutex);
        if (s_count++ > 0)
            return;
        for (std::size_t i = 0; i < kSignals.size(); ++i) {
            ::sigaction(kSignals[i], nullptr, &s_former[i]);
            if (s_former[i].sa_handler != SIG_DFL)
                continue;
            struct sigaction action = {};
            action.sa_handler = holdSignal;
            action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND); // the second one ends the program
            ::sigaction(kSignals[i], &action, nullptr);
        }
    }
    ~HeldSignals()
    {
        const std::scoped_lock lock(s_mutex);
        if (--s_count > 0)
            return;
        for (std::size_t i = 0; i < kSignals.size(); ++i)
            if (s_former[i].sa_handler == SIG_DFL)
                ::sigaction(kSignals[i], &s_former[i], nullptr);
        if (const int held = std::exchange(heldSignal, 0); held != 0)
            ::raise(held);
    }
    Q_DISABLE_COPY_MOVE(HeldSignals)

    [[nodiscard]] static bool wantsToEnd() { return heldSignal != 0; }

private:
    static constexpr std::array kSignals{SIGINT, SIGTERM, SIGHUP};
    static inline std::mutex s_mutex;
    static inline int s_count = 0;
    static inline std::array<struct sigaction, kSignals.size()> s_former{};
};
#else
struct HeldSignals {
    [[nodiscard]] static bool wantsToEnd() { return false; }
};
#endif

Reason reasonOf(const QFileDevice& file) { return Reason(file.errorString()); }

/// Opens a device or pipe.
///
/// out     false: file.errorString() says why, or `why` does
bool openStream(QFile& file, NoReader noReader, std::optional<Reason>& why)
{
    if (const auto descriptor = descriptorOf(file.fileName())) {
        std::fflush(*descriptor == 2 ? stderr : stdout); // what was printed before comes first
        return file.open(*descriptor, QIODevice::WriteOnly | QIODevice::Unbuffered);
    }
#ifdef Q_OS_UNIX
    if (noReader == NoReader::Refuse) {
        const int descriptor =
            ::open(QFile::encodeName(file.fileName()).constData(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
        if (descriptor < 0) {
            why = errno == ENXIO ? Reason(QT_TRANSLATE_NOOP("Diagnostic", "no program reads from this pipe"))
                                 : Reason(qt_error_string(errno));
            return false;
        }
        ::fcntl(descriptor, F_SETFL, ::fcntl(descriptor, F_GETFL) & ~O_NONBLOCK);
        return file.open(descriptor, QIODevice::WriteOnly | QIODevice::Unbuffered, QFileDevice::AutoCloseHandle);
    }
#else
    Q_UNUSED(noReader);
    Q_UNUSED(why);
#endif
    return file.open(QIODevice::WriteOnly | QIODevice::Unbuffered);
}

/// Writes all of it. What a disk took only a part of is tried again, for Qt then says why the rest does not fit.
bool writeAll(QFileDevice& file, const QByteArray& bytes)
{
    constexpr qsizetype kAtOnce = qsizetype(4) << 20; // then it looks whether the program is to end
    for (qsizetype written = 0; written < bytes.size();) {
        const qint64 taken = file.write(bytes.constData() + written, std::min(bytes.size() - written, kAtOnce));
        if (taken <= 0 || HeldSignals::wantsToEnd())
            return false;
        written += taken;
    }
    return true;
}

std::optional<Reason> writeStream(const QString& path, const QByteArray& bytes, NoReader noReader)
{
    QFile file(path);
    std::optional<Reason> why;
    if (openStream(file, noReader, why) && writeAll(file, bytes))
        return std::nullopt;
    return why ? why : reasonOf(file);
}

/// A file beside its place, complete on the disk but not yet in place.
struct Staged {
    std::unique_ptr<QSaveFile> file;
    std::optional<Reason> problem;
};

Staged stage(const QString& path, const QByteArray& bytes)
{
    if (QFileInfo(path).isDir())
        return {nullptr, QT_TRANSLATE_NOOP("Diagnostic", "it is a folder; the name of a file is expected")};
    auto file = std::make_unique<QSaveFile>(path);
    if (!file->open(QIODevice::WriteOnly | QIODevice::Unbuffered) || !writeAll(*file, bytes))
        return {nullptr, reasonOf(*file)};
    if (auto problem = bringToDisk(*file))
        return {nullptr, std::move(problem)};
    if (file->size() != bytes.size())
        return {nullptr, QT_TRANSLATE_NOOP("Diagnostic", "the disk holds only a part of it")};
    return {std::move(file), std::nullopt};
}

/// Where a file lies or would lie.
QString placeOf(const QString& path)
{
    const QFileInfo info(path);
    if (const QString canonical = info.canonicalFilePath(); !canonical.isEmpty())
        return canonical;
    const QString folder = QFileInfo(info.absolutePath()).canonicalFilePath();
    return folder.isEmpty() ? QDir::cleanPath(info.absoluteFilePath()) : QDir(folder).filePath(info.fileName());
}

std::filesystem::path nativePath(const QString& path)
{
#ifdef Q_OS_WIN
    return path.toStdWString();
#else
    return QFile::encodeName(path).toStdString();
#endif
}

} // namespace

std::optional<WriteFailure> writeFiles(std::span<const OutputFile> files, NoReader noReader)
{
    const bool anyStaged = std::ranges::any_of(files, [](const OutputFile& file) { return !isStream(file.path); });
    const auto held = anyStaged ? std::make_unique<HeldSignals>() : nullptr;
    std::vector<std::unique_ptr<QSaveFile>> staged; // gone before `held` is
    for (const OutputFile& file : files) {
        if (isStream(file.path))
            continue;
        Staged made = stage(file.path, file.bytes);
        if (made.problem)
            return WriteFailure{file.path, *made.problem};
        staged.push_back(std::move(made.file));
    }
    for (const OutputFile& file : files)
        if (isStream(file.path))
            if (const auto problem = writeStream(file.path, file.bytes, noReader))
                return WriteFailure{file.path, *problem};
    for (const auto& file : staged)
        if (!file->commit())
            return WriteFailure{file->fileName(), reasonOf(*file)};
    return std::nullopt;
}

std::optional<Reason> writeFile(const QString& path, const QByteArray& bytes, NoReader noReader)
{
    const OutputFile file{path, bytes};
    const auto failure = writeFiles(std::span(&file, 1), noReader);
    return failure ? std::optional(failure->reason) : std::nullopt;
}

std::optional<Reason> bringToDisk(QFileDevice& file)
{
    errno = 0;
    if (!file.flush()) // QSaveFile keeps no word about it
        return errno != 0 ? Reason(qt_error_string(errno)) : reasonOf(file);
#ifdef Q_OS_UNIX
    // A disk that gives its blocks out late only now finds that it is full. Some file systems know no fsync.
    if (::fsync(file.handle()) != 0 && errno != EINVAL && errno != ENOTSUP && errno != ENOSYS)
        return Reason(qt_error_string(errno));
#endif
    return std::nullopt;
}

std::optional<Reason> whyNotWritable(const QString& path)
{
    if (isStream(path))
        return std::nullopt;
    const HeldSignals held{};
    return stage(path, {}).problem; // the staged file is dropped again
}

bool isStream(const QString& path)
{
    const QFileInfo info(path);
    return descriptorOf(path) || (info.exists() && !info.isFile() && !info.isDir());
}

bool isSameFile(const QString& a, const QString& b)
{
    if (placeOf(a) == placeOf(b))
        return true;
    std::error_code ignored; // one of them is not there
    return std::filesystem::equivalent(nativePath(a), nativePath(b), ignored);
}

std::optional<Reason> whyNotOver(const QString& path, const QStringList& inputs)
{
    if (isStream(path))
        return std::nullopt;
    for (const QString& input : inputs)
        if (isSameFile(path, input))
            return Reason(QT_TRANSLATE_NOOP("Diagnostic",
                                            "it is in use as an input and would be overwritten; another name is "
                                            "expected"));
    return std::nullopt;
}

} // namespace rasterlens
