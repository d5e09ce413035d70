#pragma once
#include "core/pipeline/types.h"
#include "core/scene/texture.h"
#include "core/settings/rules.h"

#include <cstdint>
#include <vector>

namespace rasterlens
{

/// A texel that sampleTexture() reads.
struct TexelRead {
    int level = 0;     ///< mip level; 0 is the texture itself
    double column = 0; ///< a whole number, before the texture is repeated or its border goes on; row 0 lies at v = 0
    double row = 0;
    int x = 0; ///< which texel of the level that is
    int y = 0;
    double weight = 0; ///< in the colour; the weights add up to 1
    std::uint32_t color = 0;
};

/// The texels that sampleTexture() reads for the same arguments, those of weight 0 as well: one, the four of a blend
/// from the lower left on row by row, or the four of each of two mip levels.
[[nodiscard]] std::vector<TexelRead> texelReads(const Texture& texture, const glm::vec2& uv, TextureFilter filter,
                                                const UvGradient& gradient = {}, const TexelRules& rules = {});

} // namespace rasterlens
