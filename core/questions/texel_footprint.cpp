#include "core/questions/texel_footprint.h"

#include "core/pipeline/texel_path.h"

namespace rasterlens
{

std::optional<TexelFootprint> texelFootprint(const Scene& scene, const Rules& rules, const ScreenTriangle& triangle,
                                             const FragmentStep& step)
{
    const bool readsTexels =
        rules.shading == Shading::Texture || rules.shading == Shading::Phong || rules.shading == Shading::MipLevel;
    const Texture* texture = readsTexels ? faceUniforms(scene, triangle.face, rules).texture : nullptr;
    if (texture == nullptr || !step.shaded)
        return std::nullopt;
    const FaceInterpolation interpolation(triangle, triangle.area2, rules, DepthUse::Ignored);
    UvGradient gradient = interpolation.uvGradient(step.screen, step.weights, kVaryingUv);
    if (takesOtherTexels(rules)) {
        Varyings varyings = step.varyings;
        takeOtherTexels(interpolation, rules, step.screen, varyings, gradient);
    }
    const glm::dvec2 size(texture->width, texture->height);
    TexelFootprint footprint;
    footprint.size = {texture->width, texture->height};
    footprint.place = size * glm::dvec2(step.varyings[kVaryingUv], step.varyings[kVaryingUv + 1]);
    footprint.right = size * glm::dvec2(gradient.perX);
    footprint.down = size * glm::dvec2(gradient.perY);
    footprint.level = static_cast<double>(mipLevel(*texture, gradient, rules.texels));
    return footprint;
}

} // namespace rasterlens
