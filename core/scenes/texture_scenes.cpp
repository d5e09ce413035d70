#include "core/scenes/makers.h"
#include "core/scenes/shapes.h"

#include <array>
#include <cmath>
#include <string_view>

namespace rasterlens
{
namespace
{

/// A letter F in a frame, the top row first.
constexpr std::array<std::string_view, 10> kLetterRows{"##########", "#        #", "#  FFFFF #", "#  F     #",
                                                       "#  F     #", "#  FFFF  #", "#  F     #", "#  F     #",
                                                       "#        #", "##########"};

Texture letterTexture()
{
    const auto side = static_cast<int>(kLetterRows.size());
    Texture texture{QStringLiteral("letter"), side, side, {}};
    for (std::size_t row = kLetterRows.size(); row-- > 0;)
        for (const char field : kLetterRows[row])
            texture.texels.push_back(field == '#' ? 0xff2f5fa8 : field == 'F' ? 0xffd9482b : 0xfff4ecd8);
    texture.clamp = true;
    return texture;
}

/// Light, with a dark disc in the middle: where it repeats, both sides are alike.
Texture discTexture()
{
    constexpr int kSide = 128;
    Texture texture{QStringLiteral("disc"), kSide, kSide, {}};
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const double radius = std::hypot(x + 0.5 - kSide / 2.0, y + 0.5 - kSide / 2.0);
            texture.texels.push_back(radius < 0.36 * kSide ? 0xff5b2f26 : 0xfff2ead8);
        }
    return texture;
}

} // namespace

Scene makePictureCard()
{
    Scene scene = objectScene(false);
    scene.defaults.size = QSize(640, 480);
    addFlatQuad(scene.mesh, {-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, kWhite);
    setTexture(scene, letterTexture());
    scene.defaults.textureFilter = TextureFilter::Bilinear;
    scene.defaults.view = fitFrom(25, 10);
    return scene;
}

Scene makeTexelsAboutZero()
{
    constexpr int kTexels = 4;
    const QSize size(96, 96);
    Scene scene = clipScene(size);
    // Two repeats in each direction from the middle, where u and v are 0.
    const auto corner = [&](double x, double y) {
        MeshVertex vertex = cornerAtPixel({x, y}, size, kWhite);
        vertex.uv = {static_cast<float>((x - 48) / 32), static_cast<float>((48 - y) / 32)};
        return vertex;
    };
    addClipTriangle(scene.mesh, corner(0, 0), corner(0, 96), corner(96, 0));
    addClipTriangle(scene.mesh, corner(96, 0), corner(0, 96), corner(96, 96));
    Texture texture{QStringLiteral("four"), kTexels, kTexels, {}};
    constexpr std::array<std::uint32_t, kTexels> kColors{0xffd9482b, 0xffe8a33d, 0xff2f5fa8, 0xff7fb069};
    for (int y = 0; y < kTexels; ++y)
        for (int x = 0; x < kTexels; ++x)
            texture.texels.push_back(kColors[static_cast<std::size_t>((x + y) % kTexels)]);
    setTexture(scene, texture);
    return scene;
}

Scene makeDiscFloor()
{
    constexpr int kColumns = 2;
    constexpr int kRows = 2;
    constexpr double kHalfWidth = 48;
    constexpr double kAhead = 120;
    Scene scene = objectScene(false);
    scene.background = {0.55F, 0.72F, 0.90F};
    scene.defaults.size = QSize(480, 360);
    addGrid(scene.mesh, kColumns, kRows, [&](int column, int row) {
        const double x = kHalfWidth * (2.0 * column / kColumns - 1);
        const double z = 4 - kAhead * row / kRows;
        return addVertex(scene.mesh, {x, 0, z}, {0, 1, 0}, kWhite, glm::dvec2(x, -z) * 0.4);
    });
    setTexture(scene, discTexture());
    scene.defaults.textureFilter = TextureFilter::Trilinear;
    scene.defaults.view = viewFrom({0.7, 2.2, 0}, {0.7, 1.5, -4}, 0.1, 200);
    scene.defaults.culling = Culling::None;
    return scene;
}

Scene makeCoarseBall()
{
    constexpr int kSectors = 8;
    constexpr int kStacks = 6;
    Scene scene = objectScene(true);
    scene.defaults.size = QSize(640, 480);
    addGrid(scene.mesh, kSectors, kStacks, [&](int sector, int stack) {
        const double longitude = 2 * kPi * (sector % kSectors) / kSectors;
        const double latitude = kPi * stack / kStacks - kPi / 2;
        const bool pole = stack == 0 || stack == kStacks;
        const double radius = pole ? 0 : std::cos(latitude);
        const glm::dvec3 point{radius * std::sin(longitude), pole ? (stack == 0 ? -1 : 1) : std::sin(latitude),
                               radius * std::cos(longitude)};
        return addVertex(scene.mesh, point, point, {0.95F, 0.70F, 0.40F});
    });
    Material material;
    material.name = QStringLiteral("glaze");
    material.specular = glm::vec3(0.9F);
    material.shininess = 16;
    scene.materials = {material};
    scene.defaults.shading = Shading::Phong;
    scene.defaults.view = fitFrom(20, 20);
    return scene;
}

} // namespace rasterlens
