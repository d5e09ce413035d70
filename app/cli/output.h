#pragma once
#include "core/io/file_writer.h"

#include <QByteArray>
#include <QImage>
#include <QString>
#include <QStringList>

#include <vector>

namespace rasterlens::cli
{

/// Prints UTF-8 to stdout.
///
/// errors  throws Failure when stdout cannot take it
void printText(const QString& text);

/// The files of one run: all of them are written whole, or none is touched.
/// `-` is stdout. Devices and pipes are written to as they are, before any file is replaced.
class OutputFiles
{
public:
    void add(const QString& path, const QByteArray& bytes) { m_files.push_back({path, bytes}); }

    /// errors  throws Failure when one cannot be written
    void write() const;

private:
    std::vector<OutputFile> m_files;
};

/// What can be known of the outputs before the work begins. Files that are there already stay as they are.
///
/// errors  throws Failure when two have one name, or one cannot be written
void checkOutputs(const QStringList& paths);

/// No output may take the place of a file that the picture is made of.
///
/// errors  throws Failure when one would
void checkInputsStay(const QStringList& outputs, const QStringList& inputs);

/// The formats a picture can be written in, by suffix: `png, ppm, bmp, jpg, jpeg`.
[[nodiscard]] QString imageSuffixes();

/// The format of a picture's file name; PNG for `-` and for names without suffix.
///
/// errors  throws Failure for a suffix that is none of imageSuffixes()
[[nodiscard]] QString imageFormat(const QString& path);

/// The picture as a file in that format.
[[nodiscard]] QByteArray imageBytes(const QImage& image, const QString& format);

} // namespace rasterlens::cli
