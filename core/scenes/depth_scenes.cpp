#include "core/scenes/makers.h"
#include "core/scenes/shapes.h"

#include <array>
#include <cmath>

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

} // namespace rasterlens
