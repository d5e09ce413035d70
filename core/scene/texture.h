#pragma once
#include "core/scene/mip_chain.h"

#include <QString>

#include <cstdint>
#include <vector>

namespace rasterlens
{

/// Texels as display values, 0xffRRGGBB. Row 0 lies at v = 0 (a loader flips image files, whose row 0 is on top).
struct Texture {
    QString name;
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> texels; ///< width * height, row by row
    MipChain mips{};                   ///< see mipLevels()
    bool clamp = false;                ///< beyond 0..1 the texels of the border go on; false: the texture repeats

    /// The texture at its own size and smaller ones, made when first asked for; the texels change no more then.
    [[nodiscard]] const MipLevels& mipLevels() const { return mips.of(width, height, texels); }
};

/// 512 x 512 checkerboard with 32-texel cells, (230, 230, 230) and (40, 60, 120): the texture of a scene that has none.
[[nodiscard]] const Texture& checkerTexture();

} // namespace rasterlens
