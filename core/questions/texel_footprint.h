#pragma once
#include "core/observe/step_log.h"
#include "core/pipeline/texel_reads.h"
#include "core/scene/scene.h"
#include "core/settings/rules.h"

#include <QSize>
#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace rasterlens
{

/// A part of a mip level, to be drawn.
struct TexelPatch {
    int level = 0;
    QSize levelSize; ///< texels
    double column =
        0; ///< of the first texel, before the texture is repeated or its border goes on; row 0 lies at v = 0
    double row = 0;
    QSize size;                        ///< texels
    std::vector<std::uint32_t> texels; ///< 0xffRRGGBB, from the lowest row on
};

/// What a sample covers of a texture: the parallelogram round a place that the steps to its neighbours span.
struct TexelFootprint {
    QSize size;       ///< of the texture, texels
    glm::dvec2 place; ///< texels from the corner of the first one, before the texture is repeated
    glm::dvec2 right; ///< texels to the next sample on the right
    glm::dvec2 down;  ///< texels to the next one below
    double level = 0; ///< mip level
    TextureFilter filter = TextureFilter::Nearest;
    std::vector<TexelRead> reads; ///< empty where the shading shows the level alone
    TexelPatch patch;             ///< what lies round the parallelogram; empty where its place is no number

    /// The corners of the parallelogram in texels of the texture: from the one left of and above the pixel's centre on,
    /// in the order in which the corners of the pixel lie round it.
    [[nodiscard]] std::array<glm::dvec2, 4> corners() const
    {
        const glm::dvec2 x = 0.5 * right;
        const glm::dvec2 y = 0.5 * down;
        return {place - x - y, place + x - y, place + x + y, place - x + y};
    }
};

/// The footprint of a fragment; nothing where no texture is looked up.
///
/// in   the triangle it belongs to, shaded, and the rules it was drawn by
[[nodiscard]] std::optional<TexelFootprint> texelFootprint(const Scene& scene, const Rules& rules,
                                                           const ScreenTriangle& triangle, const FragmentStep& step);

} // namespace rasterlens
