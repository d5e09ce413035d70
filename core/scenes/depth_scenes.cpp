#include "core/scenes/makers.h"
#include "core/scenes/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace rasterlens
{

Scene makePainterCycle()
{
    constexpr std::array<glm::vec3, 3> kColors{{{0.90F, 0.35F, 0.20F}, {0.25F, 0.60F, 0.90F}, {0.95F, 0.80F, 0.25F}}};
    Scene scene = objectScene(false);
    for (int i = 0; i < 3; ++i) {
        // A long blade along one side of a triangle: its broad end is in front, its tip lies behind the next blade.
        const auto turned = [&](double x, double y, double z) {
            const double angle = 2 * kPi * i / 3;
            return glm::dvec3(std::cos(angle) * x - std::sin(angle) * y, std::sin(angle) * x + std::cos(angle) * y, z);
        };
        addFlatTriangle(scene.mesh, turned(-1.25, -0.85, 0.4), turned(1.9, -0.5, -0.4), turned(-1.25, -0.15, 0.4),
                        kColors[static_cast<std::size_t>(i)]);
    }
    return scene;
}

Scene makePiercing()
{
    Scene scene = objectScene(false);
    addFlatTriangle(scene.mesh, {-1.4, -0.9, -0.7}, {1.3, 0, 0.9}, {-1.4, 0.9, -0.7}, {0.90F, 0.45F, 0.15F});
    addFlatTriangle(scene.mesh, {1.4, -0.7, -0.6}, {1.4, 1.0, -0.6}, {-1.3, -0.1, 0.8}, {0.20F, 0.50F, 0.85F});
    return scene;
}

Scene makeZFighting()
{
    constexpr double kDistance = 100;
    constexpr double kGap = 0.1;
    Scene scene = objectScene(false);
    // A wall that leans back a little, and before it, a hand's breadth away everywhere, a panel.
    const auto wall = [&](double x, double y, double gap) {
        return glm::dvec3(x, y, -kDistance - 0.08 * y - 0.03 * x + gap);
    };
    const auto quad = [&](double halfWidth, double halfHeight, double gap, glm::vec3 color) {
        addFlatQuad(scene.mesh, wall(-halfWidth, -halfHeight, gap), wall(halfWidth, -halfHeight, gap),
                    wall(halfWidth, halfHeight, gap), wall(-halfWidth, halfHeight, gap), color);
    };
    quad(40, 30, 0, {0.20F, 0.45F, 0.75F});
    quad(28, 20, kGap, {0.95F, 0.60F, 0.15F});
    scene.defaults.view = viewFrom({0, 0, 0}, {0, 0, -1}, 0.003, 1000);
    return scene;
}

Scene makeFourZ()
{
    constexpr double kNearest = 1;
    constexpr double kFarthest = 10;
    Scene scene = objectScene(false);
    // A point that is seen at `ndc` (height 1 = half the screen) from the distance `depth`.
    const double halfHeight = std::tan(kPi / 8);
    const auto seenAt = [&](double x, double y, double depth) {
        return glm::dvec3(x * halfHeight * depth, y * halfHeight * depth, -depth);
    };
    const auto colorAt = [&](double depth) {
        const float fraction = static_cast<float>((depth - kNearest) / (kFarthest - kNearest));
        return glm::vec3(1 - fraction, 0.3F, fraction);
    };
    const auto corner = [&](double x, double y, double depth) {
        const double fraction = (depth - kNearest) / (kFarthest - kNearest);
        return addVertex(scene.mesh, seenAt(x, y, depth), {0, 0, 1}, colorAt(depth), {fraction, (y + 1) / 2});
    };
    // The board goes from the left, near, to the right, far. On the screen it is a rectangle about the middle.
    const std::uint32_t first = corner(-1, -0.3, kNearest);
    corner(1, -0.3, kFarthest);
    corner(1, 0.3, kFarthest);
    corner(-1, 0.3, kNearest);
    addFace(scene.mesh, first, first + 1, first + 2);
    addFace(scene.mesh, first, first + 2, first + 3);
    // Four markers at equal steps on the screen, each as far away as the board is there: 1/z is linear on the screen.
    for (int i = 0; i < 4; ++i) {
        const double fraction = i / 3.0;
        const double depth = 1 / ((1 - fraction) / kNearest + fraction / kFarthest);
        const double x = 2 * fraction - 1;
        constexpr double kHalf = 0.12;
        addFlatQuad(scene.mesh, seenAt(x - kHalf, 0.45, depth), seenAt(x + kHalf, 0.45, depth),
                    seenAt(x + kHalf, 0.45 + 2 * kHalf, depth), seenAt(x - kHalf, 0.45 + 2 * kHalf, depth),
                    colorAt(depth));
    }
    // Two tiles before the middle of the board, which is 1.818 away: one a little nearer, one farther and so hidden.
    const auto tile = [&](double x, double y, double depth, glm::vec3 color) {
        constexpr double kHalf = 0.05;
        addFlatQuad(scene.mesh, seenAt(x - kHalf, y - kHalf, depth), seenAt(x + kHalf, y - kHalf, depth),
                    seenAt(x + kHalf, y + kHalf, depth), seenAt(x - kHalf, y + kHalf, depth), color);
    };
    tile(0, 0.17, 1.6, kWhite);
    tile(0, -0.17, 2.5, kYellow);
    // Odd sides, so that the middle of the screen is the centre of pixel (320, 240).
    scene.defaults.size = QSize(641, 481);
    scene.defaults.view = viewFrom({0, 0, 0}, {0, 0, -1}, 0.1, 50);
    return scene;
}

namespace
{

/// How far inside the outline of a leaf a point of the unit square lies, about; its tip is above, its stem below.
double insideLeaf(double x, double y)
{
    const double along = (y - 0.16) / 0.8;
    const double blade = along > 0 && along < 1 ? 0.4 * std::pow(std::sin(kPi * along), 0.8) * (1.1 - 0.45 * along) : 0;
    const double stem = y < 0.3 ? 0.025 : 0;
    return std::max(blade, stem) - std::abs(x - 0.5);
}

struct LeafTextures {
    Texture color;
    Texture mask;
};

/// A leaf with veins on pale paper, and how opaque it is: half at its outline.
LeafTextures leafTextures()
{
    constexpr int kSide = 64;
    LeafTextures leaf{{QStringLiteral("leaf"), kSide, kSide, {}}, {QStringLiteral("leaf (opacity)"), kSide, kSide, {}}};
    for (int row = 0; row < kSide; ++row)
        for (int column = 0; column < kSide; ++column) {
            const double x = (column + 0.5) / kSide;
            const double y = (row + 0.5) / kSide;
            const double inside = insideLeaf(x, y);
            const double rib = std::abs(x - 0.5);
            const double vein = std::abs(std::remainder(y - 0.7 * rib, 0.14));
            const bool drawn = rib < 0.02 || vein < 0.012;
            leaf.color.texels.push_back(inside < -0.01 ? 0xffe8e4d8U : drawn ? 0xffb8d080U : 0xff58a038U);
            const auto opacity = static_cast<std::uint32_t>(std::clamp(0.5 + 16 * inside, 0.0, 1.0) * 255 + 0.5);
            leaf.mask.texels.push_back(0xff000000U | opacity * 0x10101U);
        }
    return leaf;
}

} // namespace

Scene makeCutOuts()
{
    Scene scene = objectScene(false);
    const auto leafAt = [&](double x, double y, double z, double turn, glm::vec3 color) {
        const auto corner = [&](double dx, double dy) {
            const glm::dvec2 along(std::cos(turn), std::sin(turn));
            return glm::dvec3(x + along.x * dx - along.y * dy, y + along.y * dx + along.x * dy, z);
        };
        addFlatQuad(scene.mesh, corner(-0.7, -0.7), corner(0.7, -0.7), corner(0.7, 0.7), corner(-0.7, 0.7), color);
    };
    leafAt(0.1, -0.1, 0.9, 0.2, {1, 1, 1});
    leafAt(-0.75, 0.2, 0.7, 0.9, {1, 0.85F, 0.5F});
    leafAt(0.85, 0.3, 0.5, -0.7, {1, 0.7F, 0.45F});
    leafAt(-0.35, -0.65, 0.3, 2.3, {0.9F, 1, 0.7F});
    leafAt(0.55, -0.6, 0.1, -2.2, {1, 0.6F, 0.4F});
    leafAt(0.0, 0.7, -0.1, -0.1, {0.75F, 0.9F, 0.6F});
    scene.mesh.faceMaterial.assign(scene.mesh.faceCount(), 1);
    addFlatQuad(scene.mesh, {-1.7, -1.4, -0.6}, {1.7, -1.4, -0.6}, {1.7, 1.4, -0.6}, {-1.7, 1.4, -0.6},
                {0.35F, 0.5F, 0.8F});
    scene.mesh.faceMaterial.resize(scene.mesh.faceCount(), 0);
    LeafTextures leaf = leafTextures();
    scene.textures = {std::move(leaf.color), std::move(leaf.mask)};
    scene.materials.resize(2);
    scene.materials[0].name = QStringLiteral("wall");
    scene.materials[1].name = QStringLiteral("leaf");
    scene.materials[1].texture = 0;
    scene.materials[1].mask = 1;
    scene.defaults.shading = Shading::Texture;
    return scene;
}

} // namespace rasterlens
