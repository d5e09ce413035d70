#pragma once
#include "core/base/reason.h"
#include "core/scene/scene.h"

#include <QByteArray>
#include <QImage>

#include <optional>

namespace rasterlens
{

/// A picture file as it is, with its transparency.
struct PictureLoad {
    QImage image;                  ///< null where there is a problem
    std::optional<Reason> problem; ///< a sentence without the file name
};

/// The picture in the bytes of a file: TGA by the name's suffix, else any format that Qt knows (PNG, JPEG, BMP, PPM).
///
/// errors  as for loadTexture()
[[nodiscard]] PictureLoad pictureFrom(QByteArray bytes, const QString& name);

struct TextureLoad {
    std::optional<Texture> texture;
    std::optional<Texture> opacity; ///< grey: how opaque the texels are; only where one of them is not wholly
    std::optional<Reason> problem;  ///< why there is none: a sentence without the file name
};

/// Reads a TGA image or one of a format that Qt knows (PNG, JPEG), row 0 to lie at v = 0 (the bottom row of the image).
///
/// out     opaque texels, transparency apart
/// errors  no such file, a directory, not an image, more than 16384 texels a side or than Qt's allocation limit
[[nodiscard]] TextureLoad loadTexture(const QString& path);

/// How opaque a surface is that an image masks, as grey texels.
///
/// in   a loaded image; one of its channels: r, g, b, m (its own transparency), l (luminance) or z (the same); 0: its
///      transparency if it has any, else luminance
[[nodiscard]] Texture maskOf(TextureLoad image, char channel);

/// Makes base + gain * t of every channel t of the texels, held within 0..1.
void spread(Texture& texture, float base, float gain);

} // namespace rasterlens
