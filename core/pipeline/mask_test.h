#pragma once
#include "core/pipeline/interpolation.h"
#include "core/scene/scene.h"
#include "core/settings/rules.h"

namespace rasterlens
{

/// The alpha test: below this opacity a face has a hole.
constexpr float kLeastOpacity = 0.5F;

/// What the alpha test reads of a face.
struct MaskTest {
    const Texture* mask = nullptr; ///< null: the face has no holes
    glm::vec2 scale{1, 1};
    glm::vec2 offset{0, 0};
    TextureFilter filter = TextureFilter::Nearest;
    std::size_t uv = 0; ///< where the texture coordinates are among the varyings
};

/// in   rules.maskUv tells whether there is a test at all
[[nodiscard]] MaskTest maskTest(const Scene& scene, std::uint32_t face, const Rules& rules);

/// How opaque a face with a mask is at a sample, 0..1: the mask, filtered as textures are.
///
/// in     the barycentric weights of the sample, on the screen and after perspective correction
/// exact  all algorithms ask this function, so they agree on every hole bit for bit
[[nodiscard]] float opacityAt(const MaskTest& test, const FaceInterpolation& interpolation, const Weights& screen,
                              const Weights& weights);

/// Whether a face has a hole at a sample. What is no number is no hole.
[[nodiscard]] inline bool isHole(const MaskTest& test, const FaceInterpolation& interpolation, const Weights& screen,
                                 const Weights& weights)
{
    return test.mask != nullptr && opacityAt(test, interpolation, screen, weights) < kLeastOpacity;
}

} // namespace rasterlens
