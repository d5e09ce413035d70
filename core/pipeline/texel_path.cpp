#include "core/pipeline/texel_path.h"

namespace rasterlens
{
namespace
{

glm::vec2 placeOnScreen(const ScreenTriangle& triangle, const Weights& screen, const Rules& rules)
{
    glm::dvec2 place(0);
    for (std::size_t i = 0; i < 3; ++i)
        place += screen[i] * triangle.vertices[i].position;
    return glm::vec2(place / glm::dvec2(rules.columns(), rules.rows()));
}

} // namespace

bool takesOtherTexels(const Rules& rules)
{
    const bool readsTexels =
        rules.shading == Shading::Texture || rules.shading == Shading::Phong || rules.shading == Shading::MipLevel;
    return readsTexels && (rules.texels.uv != UvSource::Corners || rules.texels.level != LevelSource::Sample);
}

void takeOtherTexels(const FaceInterpolation& interpolation, const Rules& rules, const Weights& screen,
                     Varyings& varyings, UvGradient& gradient)
{
    const auto u = static_cast<std::size_t>(kVaryingUv);
    if (rules.texels.uv == UvSource::Screen) {
        const glm::vec2 place = placeOnScreen(interpolation.triangle(), screen, rules);
        varyings[u] = place.x;
        varyings[u + 1] = place.y;
        gradient = {{1.0F / static_cast<float>(rules.columns()), 0}, {0, 1.0F / static_cast<float>(rules.rows())}};
    }
    switch (rules.texels.level) {
    case LevelSource::Sample: break;
    case LevelSource::Face: {
        constexpr Weights kMiddle{1.0 / 3, 1.0 / 3, 1.0 / 3};
        gradient = interpolation.uvGradient(kMiddle, interpolation.perspective(kMiddle), u);
        break;
    }
    case LevelSource::WrappedSample: gradient = wrappedGradient({varyings[u], varyings[u + 1]}, gradient); break;
    }
}

} // namespace rasterlens
