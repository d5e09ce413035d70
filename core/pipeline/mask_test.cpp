#include "core/pipeline/mask_test.h"

#include "core/pipeline/shading.h"

namespace rasterlens
{

MaskTest maskTest(const Scene& scene, std::uint32_t face, const Rules& rules)
{
    MaskTest test;
    test.mask = rules.maskUv >= 0 ? maskOfFace(scene, face) : nullptr;
    if (test.mask == nullptr)
        return test;
    const Material& material = scene.materials[scene.mesh.faceMaterial.empty() ? 0 : scene.mesh.faceMaterial[face]];
    test.scale = material.maskScale;
    test.offset = material.maskOffset;
    test.filter = rules.textureFilter;
    test.uv = static_cast<std::size_t>(rules.maskUv);
    return test;
}

float opacityAt(const MaskTest& test, const FaceInterpolation& interpolation, const Weights& screen,
                const Weights& weights)
{
    const auto& [a, b, c] = interpolation.triangle().vertices;
    const auto at = [&, &a = a, &b = b, &c = c](std::size_t k) { // clang 14 wants bindings by name
        return static_cast<float>(weights[0] * a.varyings[k] + weights[1] * b.varyings[k] + weights[2] * c.varyings[k]);
    };
    const glm::vec2 uv(at(test.uv), at(test.uv + 1));
    UvGradient gradient;
    if (test.filter == TextureFilter::Trilinear) {
        gradient = interpolation.uvGradient(screen, weights, test.uv);
        gradient.perX *= test.scale;
        gradient.perY *= test.scale;
    }
    return sampleTexture(*test.mask, uv * test.scale + test.offset, test.filter, gradient).r;
}

} // namespace rasterlens
