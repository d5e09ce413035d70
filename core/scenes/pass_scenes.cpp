#include "core/scenes/makers.h"
#include "core/scenes/shapes.h"

#include <array>
#include <cmath>

namespace rasterlens
{
namespace
{

/// The faces that follow are the second pass.
void beginSecondPass(Scene& scene) { scene.secondPassFrom = static_cast<std::uint32_t>(scene.mesh.faceCount()); }

/// A point of the road that leads away from the eye.
glm::dvec3 onRoad(double across, double along)
{
    constexpr double kSlope = 0.03;
    return {across, -1 + kSlope * across, -along};
}

} // namespace

Scene makeDecal()
{
    Scene scene = objectScene(false);
    scene.defaults.size = QSize(640, 480);
    addFlatQuad(scene.mesh, onRoad(-4, 1.5), onRoad(4, 1.5), onRoad(4, 60), onRoad(-4, 60), {0.36F, 0.38F, 0.42F});
    beginSecondPass(scene);
    const glm::vec3 paint{0.98F, 0.86F, 0.30F};
    // An arrow and, beyond it, stripes: none of them shares a corner with the road.
    addFlatTriangle(scene.mesh, onRoad(-0.9, 3.4), onRoad(0.9, 3.4), onRoad(0, 5.3), paint);
    addFlatQuad(scene.mesh, onRoad(-0.3, 2.1), onRoad(0.3, 2.1), onRoad(0.3, 3.4), onRoad(-0.3, 3.4), paint);
    for (double along = 6.1; along < 40; along *= 1.35)
        addFlatQuad(scene.mesh, onRoad(-2.7, along), onRoad(2.7, along), onRoad(2.7, along * 1.13),
                    onRoad(-2.7, along * 1.13), {0.95F, 0.95F, 0.92F});
    scene.defaults.view = viewFrom({0, 0, 0}, {0, -0.25, -1}, 0.1, 100);
    scene.defaults.depthTest = DepthTest::LessEqual;
    scene.defaults.depthBias = {.constant = -4, .slope = -1};
    return scene;
}

Scene makeWireOverFill()
{
    constexpr int kColumns = 12;
    constexpr int kRows = 8;
    Scene scene = objectScene(false);
    scene.defaults.size = QSize(320, 240);
    const auto height = [](double x, double y) { return 0.55 * std::sin(2.6 * x + 0.4) * std::cos(2.1 * y - 0.3); };
    const auto addSurface = [&](bool isWire) {
        addGrid(scene.mesh, kColumns, kRows, [&](int column, int row) {
            const double x = 3.2 * column / kColumns - 1.6;
            const double y = 2.2 * row / kRows - 1.1;
            const double z = height(x, y);
            const auto light = static_cast<float>(0.62 + 0.5 * z);
            return addVertex(scene.mesh, {x, y, z}, {0, 0, 1},
                             isWire ? glm::vec3(0.05F) : light * glm::vec3(0.55F, 0.80F, 1.0F));
        });
    };
    addSurface(false);
    beginSecondPass(scene);
    addSurface(true);
    scene.defaults.view = fitFrom(52, 30);
    scene.defaults.culling = Culling::None;
    scene.defaults.fill = Fill::Wireframe;
    scene.defaults.sharedEdges =
        SharedEdges::EachFace; // the slopes lift neighbours, and their edges, by different heights
    scene.defaults.depthTest = DepthTest::LessEqual;
    scene.defaults.depthBias = {.constant = -1, .slope = -1};
    return scene;
}

Scene makeEqualPass()
{
    const QSize size(96, 64);
    constexpr double kCode = 43690.0 / 65535; // a depth that 16 bits hold exactly
    Scene scene = clipScene(size);
    const auto addRectangle = [&](glm::dvec2 topLeft, glm::dvec2 bottomRight, double w, glm::vec3 color) {
        const auto corner = [&](double x, double y) {
            MeshVertex vertex = cornerAtPixel({x, y}, size, color, w);
            vertex.position.z = static_cast<float>((2 * kCode - 1) * w);
            return vertex;
        };
        const MeshVertex a = corner(topLeft.x, topLeft.y);
        const MeshVertex b = corner(topLeft.x, bottomRight.y);
        const MeshVertex c = corner(bottomRight.x, bottomRight.y);
        const MeshVertex d = corner(bottomRight.x, topLeft.y);
        addClipTriangle(scene.mesh, a, b, c);
        addClipTriangle(scene.mesh, a, c, d);
    };
    addRectangle({4, 4}, {92, 60}, 1, {0.30F, 0.34F, 0.45F});
    beginSecondPass(scene);
    double w = 1.1;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 7; ++column, w += 0.13)
            addRectangle({8.0 + 12 * column, 8.0 + 13 * row}, {16.0 + 12 * column, 17.0 + 13 * row}, w,
                         rainbow(0.381966 * (7 * row + column)));
    scene.defaults.depthFormat = DepthFormat::Unorm16;
    scene.defaults.depthTest = DepthTest::Equal;
    return scene;
}

Scene makeBeamToEye()
{
    Scene scene = objectScene(false);
    scene.defaults.size = QSize(640, 480);
    addFlatQuad(scene.mesh, {-8, -6, -9}, {8, -6, -9}, {8, 6, -9}, {-8, 6, -9}, {0.32F, 0.45F, 0.62F});
    // A square beam from the wall to just before the eye, in rings of four corners.
    constexpr double kHalf = 0.35;
    const std::array<glm::dvec2, 4> corners{{{-kHalf, -kHalf}, {kHalf, -kHalf}, {kHalf, kHalf}, {-kHalf, kHalf}}};
    const std::array<glm::vec3, 4> colors{
        {{0.55F, 0.25F, 0.10F}, {0.90F, 0.45F, 0.15F}, {0.98F, 0.68F, 0.30F}, {0.75F, 0.35F, 0.12F}}};
    const auto at = [&](std::size_t i, double z) {
        const double away = (-z - 0.2) / 8;
        return glm::dvec3(corners[i % 4] + glm::dvec2(0.25 + 1.6 * away, 0.2 + 1.1 * away), z);
    };
    for (std::size_t i = 0; i < 4; ++i)
        addFlatQuad(scene.mesh, at(i, -0.2), at(i, -8.5), at(i + 1, -8.5), at(i + 1, -0.2), colors[i]);
    addFlatQuad(scene.mesh, at(0, -0.2), at(1, -0.2), at(2, -0.2), at(3, -0.2), {0.98F, 0.90F, 0.55F});
    scene.defaults.view = viewFrom({0, 0, 0}, {0, 0, -1}, 1.6, 20);
    scene.defaults.culling = Culling::None;
    return scene;
}

Scene makeLockstep()
{
    const QSize size(160, 120);
    Scene scene = clipScene(size);
    const auto add = [&](glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, double depth, glm::vec3 color) {
        const auto corner = [&](glm::dvec2 p) {
            MeshVertex vertex = cornerAtPixel(p, size, color);
            vertex.position.z = static_cast<float>(2 * depth - 1);
            return vertex;
        };
        addClipTriangle(scene.mesh, corner(a), corner(b), corner(c));
    };
    // The nearer face of each pair is sent first.
    add({20, 14}, {12, 74}, {78, 52}, 0.20, {0.95F, 0.60F, 0.15F});
    add({72, 10}, {30, 48}, {84, 92}, 0.30, {0.15F, 0.35F, 0.75F});
    add({96, 20}, {70, 84}, {146, 70}, 0.50, {0.95F, 0.85F, 0.30F});
    add({148, 16}, {92, 50}, {138, 108}, 0.60, {0.20F, 0.50F, 0.85F});
    add({60, 56}, {24, 112}, {104, 100}, 0.70, {0.90F, 0.40F, 0.30F});
    add({112, 62}, {50, 84}, {120, 116}, 0.80, {0.25F, 0.65F, 0.60F});
    return scene;
}

} // namespace rasterlens
