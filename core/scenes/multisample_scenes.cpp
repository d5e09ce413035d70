#include "core/scenes/makers.h"
#include "core/scenes/shapes.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr QSize kSize(96, 64);

/// A scene of multi-sampling that takes attributes at covered places.
Scene multisampleScene(Samples samples)
{
    Scene scene = clipScene(kSize);
    scene.defaults.samples = samples;
    scene.defaults.attributeAt = AttributeAt::Centroid;
    return scene;
}

MeshVertex cornerWith(glm::dvec2 pixel, glm::dvec2 uv)
{
    MeshVertex vertex = cornerAtPixel(pixel, kSize, kWhite);
    vertex.uv = glm::vec2(uv);
    return vertex;
}

/// An atlas: a sprite in the middle, and what belongs to others round it.
Texture spriteAtlas()
{
    constexpr int kSide = 64;
    Texture atlas{QStringLiteral("atlas"), kSide, kSide, {}};
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const bool isSprite = x >= kSide / 4 && x < 3 * kSide / 4 && y >= kSide / 4 && y < 3 * kSide / 4;
            atlas.texels.push_back(!isSprite ? 0xffff00c8 : (x / 8 + y / 8) % 2 == 0 ? 0xff1f5a46 : 0xff2b7a5e);
        }
    return atlas;
}

/// A square sheet, turned, that shows the sprite.
void addSheet(Scene& scene, glm::dvec2 centre, double half, double degrees)
{
    const double angle = degrees * kPi / 180;
    const glm::dvec2 right(half * std::cos(angle), half * std::sin(angle));
    const glm::dvec2 down(-right.y, right.x);
    const MeshVertex a = cornerWith(centre - right - down, {0.25, 0.75});
    const MeshVertex b = cornerWith(centre - right + down, {0.25, 0.25});
    const MeshVertex c = cornerWith(centre + right + down, {0.75, 0.25});
    const MeshVertex d = cornerWith(centre + right - down, {0.75, 0.75});
    addClipTriangle(scene.mesh, a, b, c);
    addClipTriangle(scene.mesh, c, d, a);
}

} // namespace

Scene makeMsaaSprite()
{
    Scene scene = multisampleScene(Samples::Msaa4);
    addSheet(scene, {24.3, 32.2}, 15, 12);
    addSheet(scene, {67.1, 31.7}, 17, 33);
    setTexture(scene, spriteAtlas());
    return scene;
}

Scene makeMsaaGradient()
{
    Scene scene = multisampleScene(Samples::Msaa8);
    // Needles as wide as a pixel, side by side in one plane. Their stripes are three to a pixel, so all is grey.
    constexpr int kNeedles = 66;
    const auto at = [](double x, double y) { return cornerWith({x, y}, {3 * x / 64, 0.5}); };
    for (int i = 0; i < kNeedles; ++i) {
        const double left = 10.2 + 1.25 * i;
        addClipTriangle(scene.mesh, at(left, 4), at(left - 6.3, 60), at(left - 5.05, 60));
        addClipTriangle(scene.mesh, at(left, 4), at(left - 5.05, 60), at(left + 1.25, 4));
    }
    Texture stripes{QStringLiteral("stripes"), 64, 64, {}};
    for (int i = 0; i < 64 * 64; ++i)
        stripes.texels.push_back(i % 2 == 0 ? 0xffffffff : 0xff000000);
    setTexture(scene, std::move(stripes));
    scene.defaults.textureFilter = TextureFilter::Trilinear;
    return scene;
}

Scene makeMsaaSeams()
{
    Scene scene = multisampleScene(Samples::Msaa4);
    scene.background = {0.08F, 0.12F, 0.25F};
    constexpr int kSpokes = 20;
    const glm::dvec2 centre(47.6, 32.3);
    const auto rim = [&](int i) {
        const double angle = 2 * kPi * i / kSpokes + 0.07;
        return cornerAtPixel(centre + 28.0 * glm::dvec2(std::cos(angle), -std::sin(angle)), kSize, kYellow);
    };
    for (int i = 0; i < kSpokes; ++i)
        addClipTriangle(scene.mesh, cornerAtPixel(centre, kSize, kYellow), rim(i), rim(i + 1));
    return scene;
}

} // namespace rasterlens
