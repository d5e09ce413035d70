#include "core/scenes/makers.h"
#include "core/scenes/shapes.h"

#include <cmath>

namespace rasterlens
{
namespace
{

constexpr glm::vec3 kLight{0.90F, 0.87F, 0.80F};
constexpr glm::vec3 kDark{0.45F, 0.50F, 0.55F};

/// Appends an upright box without its bottom.
void addBox(Mesh& mesh, glm::dvec3 low, glm::dvec3 high, glm::vec3 color)
{
    const auto corner = [&](bool right, bool up, bool front) {
        return glm::dvec3(right ? high.x : low.x, up ? high.y : low.y, front ? high.z : low.z);
    };
    const auto side = [&](glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d, float shade) {
        addFlatQuad(mesh, a, b, c, d, shade * color);
    };
    side(corner(false, false, true), corner(true, false, true), corner(true, true, true), corner(false, true, true), 1);
    side(corner(true, false, false), corner(false, false, false), corner(false, true, false), corner(true, true, false),
         0.6F);
    side(corner(true, false, true), corner(true, false, false), corner(true, true, false), corner(true, true, true),
         0.75F);
    side(corner(false, false, false), corner(false, false, true), corner(false, true, true), corner(false, true, false),
         0.75F);
    side(corner(false, true, true), corner(true, true, true), corner(true, true, false), corner(false, true, false),
         0.9F);
}

} // namespace

Scene makeSignpost()
{
    constexpr int kCells = 4; // on each side of the middle
    Scene scene = objectScene(false);
    scene.background = {0.55F, 0.72F, 0.90F};
    scene.defaults.size = QSize(640, 480);
    for (int row = -kCells; row < kCells; ++row)
        for (int column = -kCells; column < kCells; ++column) {
            const glm::dvec3 corner(column, 0, row);
            addFlatQuad(scene.mesh, corner + glm::dvec3(0, 0, 1), corner + glm::dvec3(1, 0, 1),
                        corner + glm::dvec3(1, 0, 0), corner, (row + column) % 2 == 0 ? kLight : kDark);
        }
    // A letter F of three bars, and a pillar on either side behind it.
    constexpr glm::vec3 kLetter{0.95F, 0.55F, 0.15F};
    addBox(scene.mesh, {-0.6, 0, -0.15}, {-0.2, 2.2, 0.15}, kLetter);
    addBox(scene.mesh, {-0.2, 1.8, -0.15}, {0.7, 2.2, 0.15}, kLetter);
    addBox(scene.mesh, {-0.2, 0.9, -0.15}, {0.4, 1.3, 0.15}, kLetter);
    addBox(scene.mesh, {-2.6, 0, -3.4}, {-2.1, 1.6, -2.9}, {0.85F, 0.25F, 0.25F});
    addBox(scene.mesh, {2.1, 0, -3.4}, {2.6, 1.6, -2.9}, {0.30F, 0.70F, 0.35F});
    scene.defaults.view = viewFrom({1.2, 1.9, 5.6}, {0, 1.0, 0}, 0.1, 40);
    return scene;
}

Scene makeRoad()
{
    constexpr int kCells = 10; // ahead, and on each side
    constexpr double kSide = 14;
    Scene scene = objectScene(false);
    scene.background = {0.55F, 0.72F, 0.90F};
    scene.defaults.size = QSize(640, 480);
    for (int row = 0; row < kCells; ++row)
        for (int column = -kCells / 2; column < kCells / 2; ++column) {
            const glm::dvec3 corner(column * kSide, -0.3, -row * kSide);
            const glm::vec3 green =
                (row + column) % 2 == 0 ? glm::vec3(0.42F, 0.62F, 0.33F) : glm::vec3(0.36F, 0.55F, 0.30F);
            addFlatQuad(scene.mesh, corner, corner + glm::dvec3(kSide, 0, 0), corner + glm::dvec3(kSide, 0, -kSide),
                        corner + glm::dvec3(0, 0, -kSide), green);
        }
    // From far on the right, beyond the border of the screen, to the left behind the eye: two triangles a strip, and
    // x / w of all corners lies to the right of the screen, since w is below 0 where x is.
    const auto addStrip = [&](double from, double to, double height, glm::vec3 color) {
        const auto right = [&](double across) { return glm::dvec3(60, height, -84 - 12 * across); };
        const auto left = [&](double across) { return glm::dvec3(-40, height, 16 - 12 * across); };
        addFlatQuad(scene.mesh, left(from), right(from), right(to), left(to), color);
    };
    addStrip(0, 1, 0, {0.33F, 0.33F, 0.36F});
    addStrip(0.47, 0.53, 0.1, {0.95F, 0.90F, 0.55F});
    scene.defaults.view = viewFrom({0, 8, 0}, {0, 6, -20}, 0.5, 300);
    scene.defaults.culling = Culling::None;
    return scene;
}

Scene makeSquashedBall()
{
    constexpr int kSectors = 48;
    constexpr int kStacks = 24;
    const glm::dvec3 stretch{1, 0.3, 1};
    Scene scene = objectScene(true);
    scene.defaults.size = QSize(640, 480);
    scene.stretch = glm::vec3(stretch);
    addGrid(scene.mesh, kSectors, kStacks, [&](int sector, int stack) {
        const double longitude = 2 * kPi * (sector % kSectors) / kSectors;
        const double latitude = kPi * stack / kStacks - kPi / 2;
        const bool pole = stack == 0 || stack == kStacks;
        const double radius = pole ? 0 : std::cos(latitude);
        const glm::dvec3 point{radius * std::sin(longitude), pole ? (stack == 0 ? -1 : 1) : std::sin(latitude),
                               radius * std::cos(longitude)};
        return addVertex(scene.mesh, point * stretch, point / stretch, {0.85F, 0.75F, 0.55F});
    });
    scene.defaults.view = fitFrom(0, 30);
    return scene;
}

} // namespace rasterlens
