#include "app/cli/output.h"

#include "app/cli/failure.h"
#include "core/io/picture_file.h"

namespace rasterlens::cli
{
namespace
{

[[noreturn]] void failOutput(const QString& path, const Reason& reason)
{
    failInput(QStringLiteral("%1: cannot be written: %2")
                  .arg(path == QLatin1String("-") ? QStringLiteral("stdout") : path, textOf(reason)));
}

} // namespace

void printText(const QString& text)
{
    if (const auto problem = writeFile(QStringLiteral("-"), text.toUtf8()))
        failOutput(QStringLiteral("-"), *problem);
}

void OutputFiles::write() const
{
    if (const auto failure = writeFiles(m_files))
        failOutput(failure->path, failure->reason);
}

void checkOutputs(const QStringList& paths)
{
    for (qsizetype i = 0; i < paths.size(); ++i)
        for (qsizetype before = 0; before < i; ++before)
            if (isSameFile(paths[i], paths[before]) && (paths[i] == QLatin1String("-") || !isStream(paths[i])))
                failArguments(QStringLiteral("%1: two outputs have this name; each needs its own").arg(paths[i]));
    for (const QString& path : paths)
        if (const auto problem = whyNotWritable(path))
            failOutput(path, *problem);
}

void checkInputsStay(const QStringList& outputs, const QStringList& inputs)
{
    for (const QString& output : outputs)
        if (const auto problem = whyNotOver(output, inputs))
            failArguments(QStringLiteral("%1: %2").arg(output, textOf(*problem)));
}

QString imageSuffixes() { return pictureSuffixes().join(QStringLiteral(", ")); }

QString imageFormat(const QString& path)
{
    if (const auto problem = whyNotFormat(path, pictureSuffixes()))
        failArguments(QStringLiteral("%1: %2").arg(path, textOf(*problem)));
    return formatOf(path);
}

QByteArray imageBytes(const QImage& image, const QString& format)
{
    PictureBytes picture = pictureBytes(image, format);
    if (picture.problem)
        failInput(textOf(*picture.problem));
    return picture.bytes;
}

} // namespace rasterlens::cli
