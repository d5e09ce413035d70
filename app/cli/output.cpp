#include "app/cli/output.h"

#include "app/cli/failure.h"

#include <QBuffer>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImageWriter>
#include <QSaveFile>

#include <cstdio>
#include <memory>

namespace rasterlens::cli
{
namespace
{

constexpr int kJpegQuality = 95;

const QStringList& suffixes()
{
    static const QStringList list{QStringLiteral("png"), QStringLiteral("ppm"), QStringLiteral("bmp"),
                                  QStringLiteral("jpg"), QStringLiteral("jpeg")};
    return list;
}

[[noreturn]] void failOutput(const QString& path, const QString& reason)
{
    failInput(QStringLiteral("%1: cannot be written: %2").arg(path, reason));
}

bool isStdout(const QString& path) { return path == QLatin1String("-"); }

/// A device or pipe cannot be replaced by a finished file.
bool isStream(const QString& path)
{
    const QFileInfo info(path);
    return isStdout(path) || (info.exists() && !info.isFile() && !info.isDir());
}

void writeStream(const QString& path, const QByteArray& bytes)
{
    QFile file(path);
    const bool open = isStdout(path) ? file.open(stdout, QIODevice::WriteOnly) : file.open(QIODevice::WriteOnly);
    if (!open || file.write(bytes) != bytes.size() || !file.flush())
        failOutput(isStdout(path) ? QStringLiteral("stdout") : path, file.errorString());
}

/// A file beside its place, complete on disk but not yet in place.
std::unique_ptr<QSaveFile> stage(const QString& path, const QByteArray& bytes)
{
    if (QFileInfo(path).isDir())
        failOutput(path, QStringLiteral("it is a folder; the name of a file is expected"));
    auto file = std::make_unique<QSaveFile>(path);
    if (!file->open(QIODevice::WriteOnly) || file->write(bytes) != bytes.size() || !file->flush())
        failOutput(path, file->errorString());
    return file;
}

} // namespace

void printText(const QString& text) { writeStream(QStringLiteral("-"), text.toUtf8()); }

void OutputFiles::write() const
{
    std::vector<std::unique_ptr<QSaveFile>> staged;
    for (const File& file : m_files)
        if (!isStream(file.path))
            staged.push_back(stage(file.path, file.bytes));
    for (const File& file : m_files)
        if (isStream(file.path))
            writeStream(file.path, file.bytes);
    for (const auto& file : staged)
        if (!file->commit())
            failOutput(file->fileName(), file->errorString());
}

void checkOutputs(const QStringList& paths)
{
    QStringList seen;
    for (const QString& path : paths) {
        const QString name = isStdout(path) ? path : QDir::cleanPath(QFileInfo(path).absoluteFilePath());
        if (seen.contains(name))
            failArguments(QStringLiteral("%1: two outputs have this name; each needs its own").arg(path));
        seen << name;
    }
    for (const QString& path : paths)
        if (!isStream(path))
            stage(path, {}); // and dropped again
}

QString imageSuffixes() { return suffixes().join(QStringLiteral(", ")); }

QByteArray imageFormat(const QString& path)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    if (isStream(path) || suffix.isEmpty())
        return "png";
    if (!suffixes().contains(suffix))
        failArguments(QStringLiteral("%1: \"%2\" is not a format pictures are written in, which are: %3")
                          .arg(path, suffix, imageSuffixes()));
    return suffix.toLatin1();
}

QByteArray imageBytes(const QImage& image, const QByteArray& format)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QImageWriter writer(&buffer, format);
    if (format.startsWith("jp"))
        writer.setQuality(kJpegQuality);
    if (!writer.write(image))
        failInput(
            QStringLiteral("the picture cannot be made a %1: %2").arg(QLatin1String(format), writer.errorString()));
    return bytes;
}

} // namespace rasterlens::cli
