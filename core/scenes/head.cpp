// A head out of ellipsoids, balls and capsules, blended into one surface: neck, ears, eyes, and a mouth that opens into
// a cavity wider than the lips.
#include "core/scenes/makers.h"
#include "core/scenes/surface_nets.h"

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

double ball(glm::dvec3 p, glm::dvec3 center, double radius) { return glm::length(p - center) - radius; }

/// The distance to an ellipsoid, right on the surface and near enough around it.
double ellipsoid(glm::dvec3 p, glm::dvec3 center, glm::dvec3 radii)
{
    const glm::dvec3 scaled = (p - center) / radii;
    const double length = glm::length(scaled);
    return length * (length - 1) / std::max(glm::length(scaled / radii), 1e-9);
}

double capsule(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b, double radiusA, double radiusB)
{
    const double t = std::clamp(glm::dot(p - a, b - a) / glm::dot(b - a, b - a), 0.0, 1.0);
    return glm::length(p - glm::mix(a, b, t)) - std::lerp(radiusA, radiusB, t);
}

/// The union of two solids with a fillet of about the given size.
double join(double a, double b, double fillet)
{
    const double h = std::max(fillet - std::abs(a - b), 0.0) / fillet;
    return std::min(a, b) - 0.25 * fillet * h * h;
}

double carve(double solid, double hole, double fillet) { return -join(-solid, hole, fillet); }

constexpr glm::dvec3 kEye{0.27, 0.12, 0.60};
constexpr double kEyeRadius = 0.15;
constexpr double kMouthHeight = -0.53;
constexpr double kNeckCut = -1.3;

double mouth(glm::dvec3 p)
{
    const double cavity = ellipsoid(p, {0, kMouthHeight - 0.03, 0.34}, {0.30, 0.19, 0.30});
    const double opening = ellipsoid(p, {0, kMouthHeight, 0.75}, {0.19, 0.095, 0.42});
    return join(cavity, opening, 0.05);
}

double lips(glm::dvec3 p)
{
    const double upper = capsule(p, {0, kMouthHeight + 0.11, 0.76}, {0.19, kMouthHeight + 0.02, 0.64}, 0.055, 0.03);
    const double lower = capsule(p, {0, kMouthHeight - 0.12, 0.73}, {0.19, kMouthHeight - 0.02, 0.64}, 0.065, 0.03);
    return join(upper, lower, 0.04);
}

/// Negative inside the head. The face looks along +z; left and right are alike.
double headDistance(glm::dvec3 p)
{
    p.x = std::abs(p.x);
    double d = ellipsoid(p, {0, 0.38, -0.10}, {0.74, 0.80, 0.90});
    d = join(d, ellipsoid(p, {0, -0.30, 0.14}, {0.56, 0.70, 0.58}), 0.30);
    d = join(d, ball(p, {0, -0.88, 0.46}, 0.15), 0.25);
    d = join(d, ball(p, {0.36, -0.16, 0.50}, 0.20), 0.25);
    d = join(d, capsule(p, {0, -0.4, -0.28}, {0, -1.8, -0.36}, 0.42, 0.46), 0.20);
    d = join(d, capsule(p, {0.10, 0.36, 0.74}, {0.44, 0.34, 0.58}, 0.07, 0.06), 0.15);
    d = carve(d, ball(p, {0.28, 0.12, 0.86}, 0.19), 0.15);
    d = join(d, ball(p, kEye, kEyeRadius), 0.02);
    d = join(d, capsule(p, {0, 0.26, 0.76}, {0, -0.14, 0.96}, 0.06, 0.10), 0.10);
    d = join(d, ball(p, {0.10, -0.19, 0.85}, 0.075), 0.08);
    d = join(d, ellipsoid(p, {0.76, 0.05, -0.10}, {0.08, 0.24, 0.16}), 0.08);
    d = carve(d, ellipsoid(p, {0.85, 0.06, -0.06}, {0.06, 0.14, 0.09}), 0.05);
    d = join(d, lips(p), 0.06);
    d = carve(d, mouth(p), 0.04);
    d = join(d, ellipsoid(p, {0, kMouthHeight - 0.17, 0.42}, {0.16, 0.07, 0.22}), 0.05);
    return std::max(d, kNeckCut - p.y);
}

glm::vec3 headColor(glm::dvec3 p)
{
    constexpr glm::vec3 kSkin{0.90F, 0.70F, 0.56F};
    constexpr glm::vec3 kLip{0.78F, 0.36F, 0.34F};
    constexpr glm::vec3 kCavity{0.45F, 0.08F, 0.10F};
    constexpr glm::vec3 kEyeWhite{0.96F, 0.95F, 0.93F};
    constexpr glm::vec3 kIris{0.20F, 0.32F, 0.45F};
    constexpr glm::vec3 kBrow{0.35F, 0.22F, 0.14F};
    p.x = std::abs(p.x);
    // The way to the pupil is measured from the axis of the gaze.
    if (ball(p, kEye, kEyeRadius) < 0.012)
        return glm::length(glm::dvec2(p - kEye)) < 0.06 ? kIris : kEyeWhite;
    if (mouth(p) < 0.02 && p.z < 0.70)
        return kCavity;
    if (lips(p) < 0.015)
        return kLip;
    if (capsule(p, {0.12, 0.40, 0.78}, {0.42, 0.40, 0.62}, 0.055, 0.045) < 0.02)
        return kBrow;
    return kSkin;
}

} // namespace

Scene makeHead()
{
    Scene scene = objectScene(true);
    constexpr double kCell = 0.046;
    const CellBox box{{-0.95, kNeckCut - 0.07, -1.1}, kCell, {42, 58, 50}};
    scene.mesh = surfaceNets(box, headDistance, headColor);
    scene.defaults.view = fitFrom(20, 5);
    return scene;
}

} // namespace rasterlens
