#pragma once
#include "core/base/reason.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <optional>
#include <span>

class QFileDevice;

// The one way in which both programs write files: a file is complete on the disk before it takes its place, so that a
// full disk never costs the file that was there.

namespace rasterlens
{

/// A finished file and where it belongs.
struct OutputFile {
    QString path; ///< `-` is stdout
    QByteArray bytes;
};

/// What is to be done where no program reads from a pipe yet.
enum class NoReader {
    Wait,   ///< as command lines do
    Refuse, ///< as a window does, which is not to stand still
};

struct WriteFailure {
    QString path;
    Reason reason; ///< a sentence without the file name, of the context "Diagnostic"
};

/// Writes the files: all of them are written whole, or none is touched. Devices, pipes and `-` are written to as they
/// are, before any file is replaced.
///
/// order   every file is made beside its place, flushed, checked and brought to the disk; then all take their places
/// errors  the first one that cannot be written; files that were there then stay as they are
[[nodiscard]] std::optional<WriteFailure> writeFiles(std::span<const OutputFile> files,
                                                     NoReader noReader = NoReader::Wait);

/// Writes one file in the same way.
[[nodiscard]] std::optional<Reason> writeFile(const QString& path, const QByteArray& bytes,
                                              NoReader noReader = NoReader::Wait);

/// Hands what is buffered to the disk and asks whether it arrived. QSaveFile::commit() does not report it.
[[nodiscard]] std::optional<Reason> bringToDisk(QFileDevice& file);

/// Why no file can be made at that place, as far as that is known before it is written. A file that is there already
/// stays as it is.
[[nodiscard]] std::optional<Reason> whyNotWritable(const QString& path);

/// True for `-`, devices and pipes: what cannot be replaced by a finished file.
[[nodiscard]] bool isStream(const QString& path);

/// Whether two names lead to one file: through links, `..` and the like, also where the file is still to be written.
[[nodiscard]] bool isSameFile(const QString& a, const QString& b);

/// Why an export must not take this place: it is one of the files that the picture is made of.
[[nodiscard]] std::optional<Reason> whyNotOver(const QString& path, const QStringList& inputs);

} // namespace rasterlens
