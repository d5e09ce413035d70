#pragma once
#include "core/base/reason.h"

#include <QByteArray>
#include <QImage>
#include <QString>
#include <QStringList>

#include <functional>
#include <optional>

class QFileDialog;
class QPainter;
class QWidget;

namespace rasterlens
{

/// Where an export goes.
struct ExportTarget {
    QString path;       ///< `-` is stdout; a device or pipe is written to as it is
    QStringList inputs; ///< files whose place the export must not take: those the picture is made of
    bool waits = false; ///< for a program that reads from a pipe; a window is not to stand still
};

/// That a file could not be written, as a sentence in the language in use.
///
/// in  why: of the context "Diagnostic"
[[nodiscard]] QString notWritten(const QString& path, const Reason& why);

/// Writes a finished file whole or not at all.
///
/// errors  a sentence in the language in use: an input of the picture, or what the system says
[[nodiscard]] std::optional<QString> saveBytes(const QByteArray& bytes, const ExportTarget& target);

/// Writes a picture in the format that the suffix names, PNG where there is none.
///
/// in      otherFormats: what the caller writes by itself, for the sentence about a suffix that stands for nothing
/// errors  a sentence in the language in use: also that there is no such format, with those there are
[[nodiscard]] std::optional<QString> savePicture(const QImage& image, const ExportTarget& target,
                                                 const QStringList& otherFormats = {});

/// Writes what `paint` draws as an SVG drawing.
///
/// errors  a sentence in the language in use
[[nodiscard]] std::optional<QString> saveSvg(QSize size, const ExportTarget& target,
                                             const std::function<void(QPainter&)>& paint);

/// Writes what `paint` draws as one page of PDF, a unit being 1/96 inch; pixels painted as areas stay sharp.
///
/// errors  a sentence in the language in use
[[nodiscard]] std::optional<QString> savePdf(QSize size, const ExportTarget& target,
                                             const std::function<void(QPainter&)>& paint);

/// Why a file of that name is not written, as a sentence in the language in use: its suffix is none of the formats.
[[nodiscard]] std::optional<QString> formatProblem(const QString& path, const QStringList& formats);

/// A dialog, not yet open, that asks where to write; choosing another format changes the suffix of the name.
///
/// in      formats: suffixes; one that means the same as the one before it (jpg, jpeg) shares its line
[[nodiscard]] QFileDialog* newExportDialog(QWidget* parent, const QString& title, const QString& suggestion,
                                           const QStringList& formats);

} // namespace rasterlens
