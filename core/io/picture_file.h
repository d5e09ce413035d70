#pragma once
#include "core/base/reason.h"

#include <QByteArray>
#include <QImage>
#include <QString>
#include <QStringList>

#include <optional>

namespace rasterlens
{

/// The formats that pictures are written in, by suffix: `png`, `ppm`, `bmp`, `jpg`, `jpeg`.
[[nodiscard]] const QStringList& pictureSuffixes();

/// The suffix of a file name in small letters; `fallback` for names without suffix, `-`, devices and pipes.
[[nodiscard]] QString formatOf(const QString& path, const QString& fallback = QStringLiteral("png"));

/// Why a file of that name cannot be written: its suffix is none of `formats`.
[[nodiscard]] std::optional<Reason> whyNotFormat(const QString& path, const QStringList& formats);

struct PictureBytes {
    QByteArray bytes;
    std::optional<Reason> problem; ///< why there are none: a sentence without the file name
};

/// The picture as a file of one of the formats.
///
/// errors  the picture is empty or cannot be made a file of that format
[[nodiscard]] PictureBytes pictureBytes(const QImage& image, const QString& format);

} // namespace rasterlens
