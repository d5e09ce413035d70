#pragma once
#include "core/scene/scene.h"
#include "core/truth/exact_reference.h"

#include <cstdint>
#include <vector>

namespace rasterlens
{

/// Where a sample lies in the texture of its face.
struct ExactTexel {
    std::int32_t column = -1; ///< of level 0, after the texture has been repeated or clamped; -1: not known
    std::int32_t row = -1;
    int level = 0; ///< the whole part of the mip level, not held by the number of levels
};

/// The nearest texel and the mip level of every sample of a picture, decided by integers of any length: texture
/// coordinates are quotients of linear functions, their derivatives quotients of quadratic ones.
///
/// in      snapped faces; the truth about the scene in these settings
/// out     one entry a sample of the truth; not known where no face is seen, or one that is cut
/// exact   the rule of borders between texels (texel_border.h) as it stands, for float32 positions and coordinates
/// cost    some microseconds a sample
[[nodiscard]] std::vector<ExactTexel> exactTexels(const Scene& scene, const Settings& settings,
                                                  const ExactFrame& truth);

/// Multiplies the colours of the truth by what the texture is at each sample, looked up as the settings' filter does:
/// the nearest texel, or the blend of four or eight.
///
/// in      a truth with texture coordinates (ExactOptions::textured), which started in `space`
/// exact   nearest texels as exactTexels() decides them; on faces that are cut, and where the truth started in object
///         space, a coordinate within some 2^-46 of the largest one from a border between texels is decided in double.
///         Blends: to some 1e-12
/// cost    some 50 ns a sample
void textureExactly(const Scene& scene, const Settings& settings, ExactFrame& truth,
                    ReferenceSpace space = ReferenceSpace::Clip);

} // namespace rasterlens
