#include "core/scenes/makers.h"
#include "core/scenes/shapes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rasterlens
{

Scene makeCube()
{
    Scene scene = objectScene(true);
    struct Face {
        glm::dvec3 normal, right, up;
        glm::vec3 color;
    };
    const std::array<Face, 6> faces{{{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0.90F, 0.25F, 0.20F}},
                                     {{0, 0, -1}, {-1, 0, 0}, {0, 1, 0}, {0.95F, 0.60F, 0.15F}},
                                     {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}, {0.20F, 0.50F, 0.90F}},
                                     {{-1, 0, 0}, {0, 0, 1}, {0, 1, 0}, {0.30F, 0.75F, 0.35F}},
                                     {{0, 1, 0}, {1, 0, 0}, {0, 0, -1}, {0.95F, 0.90F, 0.40F}},
                                     {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}, {0.60F, 0.40F, 0.80F}}}};
    for (const auto& [normal, right, up, color] : faces)
        addFlatQuad(scene.mesh, normal - right - up, normal + right - up, normal + right + up, normal - right + up,
                    color);
    scene.defaults.view = fitFrom(30, 25);
    return scene;
}

Scene makeSphere()
{
    constexpr int kSectors = 48;
    constexpr int kStacks = 24;
    Scene scene = objectScene(true);
    addGrid(scene.mesh, kSectors, kStacks, [&](int sector, int stack) {
        // The last column lies on the first one bit for bit, and so do the corners of a pole.
        const double longitude = 2 * kPi * (sector % kSectors) / kSectors;
        const double latitude = kPi * stack / kStacks - kPi / 2;
        const bool pole = stack == 0 || stack == kStacks;
        const double radius = pole ? 0 : std::cos(latitude);
        const glm::dvec3 point{radius * std::sin(longitude), pole ? (stack == 0 ? -1 : 1) : std::sin(latitude),
                               radius * std::cos(longitude)};
        return addVertex(scene.mesh, point, point, {0.80F, 0.78F, 0.72F},
                         {static_cast<double>(sector) / kSectors, static_cast<double>(stack) / kStacks});
    });
    return scene;
}

namespace
{

/// The letter F in a plane, counter-clockwise, and its triangles over the corners of the outline.
constexpr std::array<glm::dvec2, 10> kLetterOutline{
    {{0, 0}, {1, 0}, {1, 2}, {2.4, 2}, {2.4, 3}, {1, 3}, {1, 4}, {3, 4}, {3, 5}, {0, 5}}};
constexpr std::array<std::array<std::size_t, 3>, 8> kLetterFaces{
    {{0, 1, 2}, {2, 3, 4}, {2, 4, 5}, {6, 7, 8}, {6, 8, 9}, {0, 2, 5}, {0, 5, 6}, {0, 6, 9}}};

} // namespace

Scene makeLetterF()
{
    constexpr double kHalfDepth = 0.5;
    constexpr glm::vec3 kFront{0.95F, 0.55F, 0.15F};
    constexpr glm::vec3 kBack{0.20F, 0.55F, 0.85F};
    constexpr glm::vec3 kSide{0.75F, 0.75F, 0.70F};
    Scene scene = objectScene(true);
    const auto at = [](std::size_t i, double z) { return glm::dvec3(kLetterOutline[i % kLetterOutline.size()], z); };
    for (const auto& [a, b, c] : kLetterFaces) {
        addFlatTriangle(scene.mesh, at(a, kHalfDepth), at(b, kHalfDepth), at(c, kHalfDepth), kFront);
        addFlatTriangle(scene.mesh, at(a, -kHalfDepth), at(c, -kHalfDepth), at(b, -kHalfDepth), kBack);
    }
    for (std::size_t i = 0; i < kLetterOutline.size(); ++i)
        addFlatQuad(scene.mesh, at(i, -kHalfDepth), at(i + 1, -kHalfDepth), at(i + 1, kHalfDepth), at(i, kHalfDepth),
                    kSide);
    scene.defaults.view = fitFrom(30, 20);
    return scene;
}

namespace
{

/// A point of the leaf: `along` from the stalk (0) to the tip (1), `across` from edge to edge (-1 to 1).
glm::dvec3 leafPoint(double along, double across)
{
    // The rib goes straight up and from the middle on in an arc towards the viewer and down again.
    constexpr double kStraight = 1.1;
    constexpr double kArcRadius = 0.55;
    constexpr double kArcAngle = 3.5;
    const double turn = kArcAngle * std::max(0.0, 2 * along - 1);
    const double rise = kStraight * std::min(1.0, 2 * along) + kArcRadius * std::sin(turn);
    const double forward = kArcRadius * (1 - std::cos(turn));
    const double halfWidth = 0.02 * (1 - along) + 0.75 * std::pow(4 * along * (1 - along), 0.7) * (1.1 - 0.3 * along);
    // Both halves are folded up, towards the front side.
    const double fold = 0.45 * halfWidth * across * across;
    return {halfWidth * across, rise - fold * std::sin(turn), forward + fold * std::cos(turn)};
}

glm::dvec3 leafNormal(double along, double across)
{
    constexpr double kStep = 1e-4;
    const double t = std::clamp(along, 0.01, 0.99);
    const glm::dvec3 acrossStep = leafPoint(t, across + kStep) - leafPoint(t, across - kStep);
    const glm::dvec3 alongStep = leafPoint(t + kStep, across) - leafPoint(t - kStep, across);
    return glm::cross(acrossStep, alongStep);
}

/// Light along the rib and the veins that leave it.
glm::vec3 leafColor(double along, double across)
{
    constexpr glm::vec3 kVein{0.72F, 0.85F, 0.42F};
    constexpr glm::vec3 kBlade{0.25F, 0.62F, 0.22F};
    const double rib = std::exp(-120 * across * across);
    const double veins = 0.5 * std::pow(0.5 + 0.5 * std::cos(2 * kPi * 8 * (along - 0.12 * std::abs(across))), 6);
    return glm::mix(kBlade, kVein, static_cast<float>(std::max(rib, veins)));
}

} // namespace

Scene makeLeaf()
{
    constexpr int kAcross = 24;
    constexpr int kAlong = 80;
    Scene scene = objectScene(true);
    scene.background = {0.80F, 0.84F, 0.88F};
    addGrid(scene.mesh, kAcross, kAlong, [&](int column, int row) {
        const double along = static_cast<double>(row) / kAlong;
        const double across = 2.0 * column / kAcross - 1;
        return addVertex(scene.mesh, leafPoint(along, across), leafNormal(along, across), leafColor(along, across),
                         {(across + 1) / 2, along});
    });
    scene.defaults.view = fitFrom(40, 15);
    return scene;
}

namespace
{

/// The trefoil: twice round the axis, three times round the tube.
glm::dvec3 knotPoint(double t)
{
    const double radius = 2 + std::cos(3 * t);
    return {radius * std::cos(2 * t), radius * std::sin(2 * t), std::sin(3 * t)};
}

} // namespace

Scene makeTorusKnot()
{
    constexpr int kAlong = 320;
    constexpr int kRound = 24;
    constexpr double kTubeRadius = 0.42;
    Scene scene = objectScene(true);
    addGrid(scene.mesh, kRound, kAlong, [&](int side, int step) {
        const double t = 2 * kPi * (step % kAlong) / kAlong;
        const double h = 1e-3;
        const glm::dvec3 tangent = glm::normalize(knotPoint(t + h) - knotPoint(t - h));
        const glm::dvec3 bendVector = knotPoint(t + h) + knotPoint(t - h) - 2.0 * knotPoint(t);
        const glm::dvec3 inwards = glm::normalize(bendVector - tangent * glm::dot(bendVector, tangent));
        const glm::dvec3 sideways = glm::cross(tangent, inwards);
        const double angle = 2 * kPi * (side % kRound) / kRound;
        const glm::dvec3 outwards = std::cos(angle) * inwards + std::sin(angle) * sideways;
        return addVertex(scene.mesh, knotPoint(t) + kTubeRadius * outwards, outwards,
                         rainbow(static_cast<double>(step % kAlong) / kAlong),
                         {static_cast<double>(side) / kRound, 24.0 * step / kAlong});
    });
    return scene;
}

} // namespace rasterlens
