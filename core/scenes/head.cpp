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

constexpr glm::dvec3 kEye{0.27, 0.10, 0.60};
constexpr double kEyeRadius = 0.15;
constexpr double kMouthHeight = -0.53;
constexpr double kNeckCut = -1.3;

double mouth(glm::dvec3 p)
{
    const double cavity = ellipsoid(p, {0, kMouthHeight - 0.03, 0.30}, {0.30, 0.19, 0.28});
    const double opening = ellipsoid(p, {0, kMouthHeight, 0.75}, {0.18, 0.09, 0.46});
    return join(cavity, opening, 0.05);
}

/// A ring that follows the curve of the face.
double lips(glm::dvec3 p)
{
    const glm::dvec2 radii{0.19, 0.12};
    const glm::dvec2 scaled = glm::dvec2(p.x, p.y - kMouthHeight) / radii;
    const double length = glm::length(scaled);
    const double fromRing = length * (length - 1) / std::max(glm::length(scaled / radii), 1e-9);
    const double fromFace = p.z - (0.715 + 0.15 * (p.y - kMouthHeight) - 2.2 * p.x * p.x);
    return glm::length(glm::dvec2(fromRing, fromFace)) - 0.055;
}

/// Eyelids leave a slit of the eyeball free.
double lids(glm::dvec3 p)
{
    const double shell = ball(p, kEye, kEyeRadius + 0.03);
    const double upper = kEye.y + 0.06 - p.y;
    const double lower = p.y - (kEye.y - 0.075);
    // The rim is rounded like the fillets: the part of the shell that neither half-space leaves out.
    return -join(-shell, -std::min(upper, lower), 0.03);
}

double brows(glm::dvec3 p)
{
    const glm::dvec3 inner{0.13, 0.36, 0.79};
    const glm::dvec3 top{0.30, 0.41, 0.73};
    const glm::dvec3 outer{0.46, 0.33, 0.60};
    return std::min(capsule(p, inner, top, 0.045, 0.04), capsule(p, top, outer, 0.04, 0.025));
}

/// Negative inside the head. The face looks along +z; left and right are alike.
double headDistance(glm::dvec3 p)
{
    p.x = std::abs(p.x);
    double d = ellipsoid(p, {0, 0.38, -0.10}, {0.74, 0.80, 0.90});
    d = join(d, ellipsoid(p, {0, -0.30, 0.14}, {0.57, 0.70, 0.58}), 0.30);
    d = join(d, ball(p, {0, -0.88, 0.46}, 0.15), 0.25);
    d = join(d, ball(p, {0.36, -0.16, 0.50}, 0.20), 0.25);
    d = join(d, capsule(p, {0, -0.4, -0.28}, {0, -1.8, -0.36}, 0.42, 0.46), 0.20);
    d = join(d, capsule(p, {0.10, 0.34, 0.74}, {0.44, 0.32, 0.58}, 0.07, 0.06), 0.15);
    d = carve(d, ball(p, {0.28, 0.10, 0.86}, 0.19), 0.15);
    d = join(d, lids(p), 0.10);
    d = join(d, ball(p, kEye, kEyeRadius), 0.02);
    d = join(d, capsule(p, {0, 0.26, 0.76}, {0, -0.14, 0.96}, 0.06, 0.10), 0.10);
    d = join(d, ball(p, {0.10, -0.19, 0.85}, 0.075), 0.10);
    d = join(d, ellipsoid(p, {0.76, 0.05, -0.10}, {0.08, 0.24, 0.16}), 0.08);
    d = carve(d, ellipsoid(p, {0.85, 0.06, -0.06}, {0.06, 0.14, 0.09}), 0.05);
    d = join(d, brows(p) + 0.02, 0.04);
    d = join(d, lips(p), 0.08);
    d = carve(d, mouth(p), 0.04);
    d = join(d, ellipsoid(p, {0, kMouthHeight - 0.17, 0.38}, {0.16, 0.08, 0.22}), 0.05);
    return carve(d, p.y - kNeckCut, 0.15);
}

glm::vec3 headColor(glm::dvec3 p)
{
    constexpr glm::vec3 kSkin{0.90F, 0.70F, 0.56F};
    constexpr glm::vec3 kLip{0.78F, 0.36F, 0.34F};
    constexpr glm::vec3 kCavity{0.45F, 0.08F, 0.10F};
    constexpr glm::vec3 kEyeWhite{0.96F, 0.95F, 0.93F};
    constexpr glm::vec3 kIris{0.15F, 0.30F, 0.50F};
    constexpr glm::vec3 kBrow{0.35F, 0.22F, 0.14F};
    // One inside the region where `distance` is negative, zero beyond a soft border.
    const auto within = [](double distance) { return static_cast<float>(1 - glm::smoothstep(0.0, 0.03, distance)); };
    p.x = std::abs(p.x);
    glm::vec3 color = glm::mix(kSkin, kBrow, within(brows(p) - 0.005));
    color = glm::mix(color, kLip, within(lips(p) - 0.005));
    if (p.z < 0.66)
        color = glm::mix(color, kCavity, within(mouth(p) - 0.01));
    if (p.z > kEye.z) {
        color = glm::mix(color, kEyeWhite, within(2 * ball(p, kEye, kEyeRadius) - 0.01));
        if (ball(p, kEye, kEyeRadius) < 0.01)
            color = glm::mix(color, kIris, within(glm::length(glm::dvec2(p - kEye)) - 0.04));
    }
    return color;
}

/// Cells are finest about the face and double their size towards the back of the head.
glm::dvec3 headGridPoint(glm::dvec3 share)
{
    const glm::dvec3 t = glm::mix(glm::dvec3(-1, -0.87, -0.92), glm::dvec3(1, 1, 0.34), share);
    return {0.98 * t.x * (0.75 + 0.25 * t.x * t.x), -0.2 + 1.45 * t.y * (0.75 + 0.25 * t.y * t.y),
            0.75 + 1.9 * t.z * (0.7 - 0.4 * t.z)};
}

} // namespace

Scene makeHead()
{
    const glm::ivec3 cells{42, 58, 46};
    Scene scene = objectScene(true);
    const auto place = [&](glm::dvec3 point) { return headGridPoint(point / glm::dvec3(cells)); };
    scene.mesh = surfaceNets({cells, place, 0.03}, headDistance, headColor);
    // A texture is thrown onto the face from the front.
    for (MeshVertex& vertex : scene.mesh.vertices)
        vertex.uv = glm::vec2(vertex.position) / 3.0F + 0.5F;
    scene.defaults.view = fitFrom(20, 5);
    return scene;
}

} // namespace rasterlens
