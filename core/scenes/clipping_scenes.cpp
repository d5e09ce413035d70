#include "core/scenes/makers.h"
#include "core/scenes/shapes.h"

#include <array>
#include <cmath>

namespace rasterlens
{

Scene makeFloor()
{
    constexpr int kColumns = 8;
    constexpr int kRows = 16;
    constexpr double kHalfWidth = 160;
    constexpr double kBehind = 10;
    constexpr double kAhead = 310;
    constexpr double kTexturesPerUnit = 0.25;
    Scene scene = objectScene(false);
    scene.background = {0.55F, 0.72F, 0.90F};
    addGrid(scene.mesh, kColumns, kRows, [&](int column, int row) {
        const double x = kHalfWidth * (2.0 * column / kColumns - 1);
        const double z = kBehind - (kBehind + kAhead) * row / kRows;
        return addVertex(scene.mesh, {x, 0, z}, {0, 1, 0}, kWhite, glm::dvec2(x, -z) * kTexturesPerUnit);
    });
    setTexture(scene, checkerboard(QStringLiteral("floor"), 64, 4, 0xffece5d8, 0xff5b4a42));
    scene.defaults.view = viewFrom({0, 1.6, 0}, {0, 1.1, -4}, 0.1, 400);
    scene.defaults.culling = Culling::None;
    return scene;
}

Scene makeTunnel()
{
    constexpr int kSides = 16;
    constexpr int kRings = 24;
    constexpr double kRadius = 1.5;
    constexpr double kBehind = 6;
    constexpr double kRingLength = 3;
    Scene scene = objectScene(false);
    scene.background = {0, 0, 0};
    const auto point = [&](int side, int ring) {
        const double angle = 2 * kPi * (side % kSides) / kSides;
        const double z = kBehind - kRingLength * ring;
        const double bend = 0.0012 * std::min(z, 0.0) * z;
        return glm::dvec3(kRadius * std::cos(angle) - bend, kRadius * std::sin(angle) + 0.3 * bend, z);
    };
    for (int ring = 0; ring < kRings; ++ring)
        for (int side = 0; side < kSides; ++side) {
            const float light = 1 - 0.8F * static_cast<float>(ring) / kRings;
            const glm::vec3 color = (side + ring) % 2 == 0 ? glm::vec3(0.95F, 0.92F, 0.85F) : rainbow(ring / 12.0);
            addFlatQuad(scene.mesh, point(side, ring), point(side + 1, ring), point(side + 1, ring + 1),
                        point(side, ring + 1), light * color);
        }
    scene.defaults.view = viewFrom({0.25, -0.2, 0}, {0.1, 0, -10}, 0.1, 100);
    return scene;
}

Scene makeBehindCamera()
{
    Scene scene = objectScene(false);
    const glm::dvec3 normal{0, 1, 0};
    addVertex(scene.mesh, {-2.5, -0.6, -5}, normal, kRed, {0, 0});
    addVertex(scene.mesh, {0.8, -1.2, 4}, normal, kGreen, {1, 0});
    addVertex(scene.mesh, {3, 1.6, -7}, normal, kBlue, {1, 1});
    addFace(scene.mesh, 0, 1, 2);
    scene.defaults.view = viewFrom({0, 0, 0}, {0, 0, -1}, 0.1, 50);
    scene.defaults.culling = Culling::None;
    return scene;
}

Scene makeCovering()
{
    Scene scene = objectScene(false);
    const glm::dvec3 normal{0, 0, 1};
    addVertex(scene.mesh, {-4, -1.6, -2}, normal, kRed, {0, 0});
    addVertex(scene.mesh, {4, -1.6, -2}, normal, kGreen, {1, 0});
    addVertex(scene.mesh, {0, 3.2, -2}, normal, kBlue, {0.5, 1});
    addFace(scene.mesh, 0, 1, 2);
    addFlatTriangle(scene.mesh, {-0.3, -0.25, -1.5}, {0.3, -0.25, -1.5}, {0, 0.3, -1.5}, kWhite);
    scene.defaults.view = viewFrom({0, 0, 0}, {0, 0, -1}, 0.1, 50);
    return scene;
}

Scene makeEdgeGuardband()
{
    constexpr int kBlades = 20;
    const QSize size(1280, 960);
    Scene scene = clipScene(size);
    const glm::dvec2 center{640, 480};
    for (int blade = 0; blade < kBlades; ++blade) {
        const double angle = 2 * kPi * (blade + 0.35) / kBlades;
        const double halfAngle = 0.3 * 2 * kPi / kBlades;
        // In turn: just over the border, far out but inside a guard band of 32,768 pixels, and beyond that.
        constexpr std::array<double, 3> kReach{1000, 12'000, 120'000};
        const double reach = kReach[static_cast<std::size_t>(blade % 3)];
        const auto polar = [&](double turn, double radius) {
            return center + radius * glm::dvec2(std::cos(turn), -std::sin(turn));
        };
        const glm::vec3 color = rainbow(static_cast<double>(blade) / kBlades);
        addClipTriangle(scene.mesh, cornerAtPixel(polar(angle, 120), size, color),
                        cornerAtPixel(polar(angle - halfAngle, reach), size, color),
                        cornerAtPixel(polar(angle + halfAngle, reach), size, color));
    }
    return scene;
}

Scene makeSlivers()
{
    constexpr int kNeedles = 72;
    Scene scene = objectScene(false);
    for (int needle = 0; needle < kNeedles; ++needle) {
        // A hyperboloid of straight stalks, the tips turned against the feet.
        const double turn = 2 * kPi * needle / kNeedles;
        const glm::dvec3 foot{0.45 * std::cos(turn), -1.2, 0.45 * std::sin(turn)};
        const glm::dvec3 tip{0.9 * std::cos(turn + 2.4), 1.2 + 0.15 * std::sin(5 * turn), 0.9 * std::sin(turn + 2.4)};
        const double width = 0.002 + 0.006 * (needle % 6);
        const glm::dvec3 step{width, 0, 0};
        addFlatTriangle(scene.mesh, foot - step, foot + step, tip, rainbow(static_cast<double>(needle) / kNeedles));
    }
    scene.defaults.culling = Culling::None;
    return scene;
}

} // namespace rasterlens
