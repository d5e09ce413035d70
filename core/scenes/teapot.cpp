// The Utah teapot of Martin Newell (1975): 32 bicubic Bezier patches, here in a form without their repetitions.
//
// Body, rim, lid and bottom are surfaces of revolution: every ring of their control points is a radius and a height
// times one quarter circle. (The published table rounds one value of the knob, 0.448, to 0.45.) Handle and spout are
// mirrored in the plane y = 0, so one half of each is stored. Coordinates are the published ones, z up.
#include "core/scenes/makers.h"
#include "core/scenes/shapes.h"

#include <array>

namespace rasterlens
{
namespace
{

constexpr int kSteps = 16; ///< cells along a side of a patch
constexpr glm::vec3 kGlaze{0.85F, 0.82F, 0.75F};

template <typename Point>
using Cubic = std::array<Point, 4>;

/// (radius, height), upwards along the outside. A curve starts where the one before it ends.
constexpr std::array<Cubic<glm::dvec2>, 4> kBodyProfile{
    {{{{0, 0}, {1.425, 0}, {1.5, 0.075}, {1.5, 0.15}}},
     {{{1.5, 0.15}, {1.5, 0.225}, {2, 0.45}, {2, 0.9}}},
     {{{2, 0.9}, {2, 1.35}, {1.75, 1.875}, {1.5, 2.4}}},
     {{{1.5, 2.4}, {1.4375, 2.53125}, {1.3375, 2.53125}, {1.4, 2.4}}}}};
constexpr std::array<Cubic<glm::dvec2>, 2> kLidProfile{
    {{{{1.3, 2.4}, {1.3, 2.55}, {0.4, 2.55}, {0.2, 2.7}}}, {{{0.2, 2.7}, {0, 2.85}, {0.8, 3.15}, {0, 3.15}}}}};
constexpr Cubic<glm::dvec2> kQuarterCircle{{{1, 0}, {1, 0.56}, {0.56, 1}, {0, 1}}};

/// Half a tube: four curves along it (x, z), from the inner side of the bend to the outer one, and how far the two
/// between stand out of the plane of symmetry, at each of the four control points along.
struct HalfTube {
    std::array<Cubic<glm::dvec2>, 2> inner;
    std::array<Cubic<glm::dvec2>, 2> outer;
    std::array<Cubic<double>, 2> width;
};
constexpr HalfTube kHandle{
    {{{{{-1.6, 2.025}, {-2.3, 2.025}, {-2.7, 2.025}, {-2.7, 1.8}}},
      {{{-2.7, 1.8}, {-2.7, 1.575}, {-2.5, 1.125}, {-2, 0.9}}}}},
    {{{{{-1.5, 2.25}, {-2.5, 2.25}, {-3, 2.25}, {-3, 1.8}}}, {{{-3, 1.8}, {-3, 1.35}, {-2.65, 0.9375}, {-1.9, 0.6}}}}},
    {{{0.3, 0.3, 0.3, 0.3}, {0.3, 0.3, 0.3, 0.3}}}};
constexpr HalfTube kSpout{
    {{{{{1.7, 1.425}, {2.6, 1.425}, {2.3, 2.1}, {2.7, 2.4}}}, {{{2.7, 2.4}, {2.8, 2.475}, {2.9, 2.475}, {2.8, 2.4}}}}},
    {{{{{1.7, 0.6}, {3.1, 0.825}, {2.4, 2.025}, {3.3, 2.4}}},
      {{{3.3, 2.4}, {3.525, 2.49375}, {3.45, 2.5125}, {3.2, 2.4}}}}},
    {{{0.66, 0.66, 0.25, 0.25}, {0.25, 0.25, 0.15, 0.15}}}};

/// A point of a Bezier curve; at t = 0 and 1 its end points bit for bit.
template <typename Point>
Point pointOn(const Cubic<Point>& curve, double t)
{
    const double s = 1 - t;
    return curve[0] * (s * s * s) + curve[1] * (3 * s * s * t) + curve[2] * (3 * s * t * t) + curve[3] * (t * t * t);
}

template <typename Point>
Point slopeOn(const Cubic<Point>& curve, double t)
{
    const double s = 1 - t;
    return (curve[1] - curve[0]) * (3 * s * s) + (curve[2] - curve[1]) * (6 * s * t) +
           (curve[3] - curve[2]) * (3 * t * t);
}

/// Published coordinates have z up, the scene has y up.
glm::dvec3 yUp(glm::dvec3 p) { return {p.x, p.z, -p.y}; }

/// Patch and parameter within it, of a step counted through several patches.
struct PatchStep {
    std::size_t patch;
    double t;
};
PatchStep patchStep(int step, int patches)
{
    const int patch = std::min(step / kSteps, patches - 1);
    return {static_cast<std::size_t>(patch), static_cast<double>(step - patch * kSteps) / kSteps};
}

glm::dvec2 quarterTurns(glm::dvec2 p, int turns)
{
    for (int i = 0; i < turns; ++i)
        p = {-p.y, p.x};
    return p;
}

template <std::size_t Curves>
void addRevolved(Mesh& mesh, const std::array<Cubic<glm::dvec2>, Curves>& profile)
{
    constexpr int kRound = 4 * kSteps;
    constexpr int kRows = static_cast<int>(Curves) * kSteps;
    addGrid(mesh, kRound, kRows, [&](int column, int row) {
        const PatchStep round = patchStep(column % kRound, 4);
        const PatchStep up = patchStep(row, static_cast<int>(Curves));
        const int turns = static_cast<int>(round.patch);
        const glm::dvec2 circle = quarterTurns(pointOn(kQuarterCircle, round.t), turns);
        const glm::dvec2 circleSlope = quarterTurns(slopeOn(kQuarterCircle, round.t), turns);
        const glm::dvec2 radiusHeight = pointOn(profile[up.patch], up.t);
        const glm::dvec2 slope = slopeOn(profile[up.patch], up.t);
        const glm::dvec3 position{radiusHeight.x * circle, radiusHeight.y};
        // The slope round the axis is the radius times circleSlope. Without that factor the poles have a normal too.
        const glm::dvec3 normal = glm::cross(glm::dvec3(circleSlope, 0), glm::dvec3(slope.x * circle, slope.y));
        return addVertex(mesh, yUp(position), yUp(normal), kGlaze,
                         {static_cast<double>(column) / kRound, static_cast<double>(row) / kRows});
    });
}

/// The control curve across a half tube, from the inner to the outer side, at one of the four control points along.
Cubic<glm::dvec3> crossCurve(const HalfTube& tube, std::size_t patch, std::size_t i)
{
    const glm::dvec2 inner = tube.inner[patch][i];
    const glm::dvec2 outer = tube.outer[patch][i];
    const double width = tube.width[patch][i];
    return {{{inner.x, 0, inner.y}, {inner.x, -width, inner.y}, {outer.x, -width, outer.y}, {outer.x, 0, outer.y}}};
}

/// A half tube and its mirror image.
void addTube(Mesh& mesh, const HalfTube& tube)
{
    constexpr int kRound = 2 * kSteps;
    constexpr int kAlong = 2 * kSteps;
    addGrid(mesh, kRound, kAlong, [&](int column, int row) {
        const PatchStep along = patchStep(row, 2);
        // Round the tube and back: the mirrored half takes the same parameters the other way.
        const bool mirrored = column > kSteps;
        const double across = static_cast<double>(mirrored ? kRound - column : column) / kSteps;
        Cubic<glm::dvec3> points;
        Cubic<glm::dvec3> slopes;
        for (std::size_t i = 0; i < 4; ++i) {
            points[i] = pointOn(crossCurve(tube, along.patch, i), across);
            slopes[i] = slopeOn(crossCurve(tube, along.patch, i), across);
        }
        glm::dvec3 position = pointOn(points, along.t);
        glm::dvec3 normal = glm::cross(pointOn(slopes, along.t), slopeOn(points, along.t));
        if (mirrored) {
            position.y = -position.y;
            normal.y = -normal.y;
        }
        return addVertex(mesh, yUp(position), yUp(normal), kGlaze,
                         {static_cast<double>(column) / kRound, static_cast<double>(row) / kAlong});
    });
}

} // namespace

Scene makeTeapot()
{
    Scene scene = objectScene(true);
    addRevolved(scene.mesh, kBodyProfile);
    addRevolved(scene.mesh, kLidProfile);
    addTube(scene.mesh, kHandle);
    addTube(scene.mesh, kSpout);
    scene.defaults.view = fitFrom(20, 20);
    scene.defaults.culling = Culling::None;
    return scene;
}

} // namespace rasterlens
