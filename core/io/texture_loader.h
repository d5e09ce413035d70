#pragma once
#include "core/base/reason.h"
#include "core/scene/scene.h"

#include <optional>

namespace rasterlens
{

struct TextureLoad {
    std::optional<Texture> texture;
    std::optional<Reason> problem; ///< why there is none: a sentence without the file name
};

/// Reads a TGA image or one of a format that Qt knows (PNG, JPEG), row 0 to lie at v = 0 (the bottom row of the image).
///
/// out     opaque texels; transparency is left out
/// errors  no such file, a directory, not an image, more than 16384 texels a side or than Qt's allocation limit
[[nodiscard]] TextureLoad loadTexture(const QString& path);

} // namespace rasterlens
