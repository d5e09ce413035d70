#pragma once
#include "core/base/reason.h"

#include <QByteArray>
#include <QImage>
#include <QSize>

#include <optional>

namespace rasterlens
{

/// The size that the header of a Truevision TGA image states, or nothing if it is too short for a header.
[[nodiscard]] std::optional<QSize> tgaSize(const QByteArray& file);

struct TgaImage {
    QImage image;                  ///< Format_RGB32, with alpha Format_ARGB32, row 0 on top; null if there is a problem
    std::optional<Reason> problem; ///< a sentence without the file name
};

/// Reads a TGA image: Qt's plugin knows neither run-length packed nor grey nor palette images.
///
/// in      a size fit to be allocated (see tgaSize)
/// covers  palette, true colour and grey, plain or run-length packed; 8, 15, 16, 24 and 32 bits; any corner as the
///         first one; alpha where the file says that it has 8 bits of it, and some pixel is not wholly transparent
/// errors  other kinds, and files that end early
/// source  Truevision TGA File Format Specification, version 2.0, 1991
[[nodiscard]] TgaImage readTga(const QByteArray& file);

} // namespace rasterlens
