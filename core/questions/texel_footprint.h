#pragma once
#include "core/observe/step_log.h"
#include "core/scene/scene.h"
#include "core/settings/rules.h"

#include <QSize>
#include <glm/glm.hpp>

#include <optional>

namespace rasterlens
{

/// What a sample covers of a texture: the parallelogram round a place that the steps to its neighbours span.
struct TexelFootprint {
    QSize size;       ///< of the texture, texels
    glm::dvec2 place; ///< texels from the corner of the first one, before the texture is repeated
    glm::dvec2 right; ///< texels to the next sample on the right
    glm::dvec2 down;  ///< texels to the next one below
    double level = 0; ///< mip level
};

/// The footprint of a fragment; nothing where no texture is looked up.
///
/// in   the triangle it belongs to, shaded, and the rules it was drawn by
[[nodiscard]] std::optional<TexelFootprint> texelFootprint(const Scene& scene, const Rules& rules,
                                                           const ScreenTriangle& triangle, const FragmentStep& step);

} // namespace rasterlens
