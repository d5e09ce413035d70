#pragma once
#include "core/io/texture_loader.h"

#include <QStringList>

namespace rasterlens
{

/// The endings of the files that loadPicture() reads, in small letters and without the dot.
[[nodiscard]] const QStringList& pictureInputSuffixes();

/// Whether the name ends like a picture or a NumPy array.
[[nodiscard]] bool isPictureName(const QString& path);

/// Reads a picture: PNG, JPEG, BMP, PPM and TGA, or a NumPy array of shape (H, W), (H, W, 3) or (H, W, 4) with row 0 on
/// top: grey, red green blue, and alpha. Numbers are 0..255; floats that do not exceed 1 are 0..1, booleans 0 or 1.
///
/// errors  a sentence without the file name: no such file, not a picture, an array of another shape, numbers out of
///         range
[[nodiscard]] PictureLoad loadPicture(const QString& path);

} // namespace rasterlens
