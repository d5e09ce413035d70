#include "core/builtin_scenes.h"

#include "core/scenes/makers.h"

#include <QCoreApplication>

#include <algorithm>

namespace rasterlens
{
namespace
{

#define TEXT(text) QT_TRANSLATE_NOOP("BuiltinScene", text)

constexpr BuiltinScene kScenes[] = {
    {"triangle", TEXT("Triangle"), TEXT("One triangle with a red, a green and a blue corner."), makeTriangle},
    {"square-diagonal", TEXT("Square cut by its diagonal"),
     TEXT(
         "The diagonal runs through the centres of 8 pixels. Each of them must belong to one triangle, not to both and "
         "not to none."),
     makeSquareDiagonal},
    {"triangle-600", TEXT("Triangle on 600 x 600"),
     TEXT(
         "The corners (100, 200), (300, 400) and (400, 100), with y counted upwards as in tinyrenderer. On the screen, "
         "where y runs down, they are (100, 400), (300, 200) and (400, 500); the order is clockwise."),
     makeTriangle600},
    {"games101", TEXT("GAMES101: two triangles"),
     TEXT("The front triangle is sent first. Without a depth test the back one is painted over it."), makeGames101},
    {"tile-square", TEXT("4 x 4 tiles in perspective"),
     TEXT("Two triangles. With affine interpolation the tiles and the white middle line break at the diagonal."),
     makeTileSquare},
    {"head", TEXT("Head with an open mouth"),
     TEXT("Faces are sent from the front to the back. Without the depth test the cavity behind the lips shows through, "
          "although back faces are culled."),
     makeHead},
    {"teapot", TEXT("Utah teapot"),
     TEXT("32 Bezier patches. The published model is open between lid and body and at the spout, so back faces are "
          "kept."),
     makeTeapot},
    {"torus-knot", TEXT("Torus knot"), TEXT("A closed surface that hides itself many times."), makeTorusKnot},
    {"floor", TEXT("Floor to the horizon"),
     TEXT("The floor passes under and behind the camera. Without near clipping the foreground is lost; with the depth "
          "test off as well, what lies behind hangs upside down in the sky."),
     makeFloor},
    {"letter-f", TEXT("Letter F"),
     TEXT("Orange in front, blue at the back. An F shows every flip, and every mistake of winding."), makeLetterF},
    {"leaf", TEXT("Leaf"),
     TEXT("An open surface: where the leaf turns its back, back-face culling tears a hole into it. Turn culling off."),
     makeLeaf},
    {"fan", TEXT("Fan"),
     TEXT("16 triangles meet at the centre of the middle pixel. Under the top-left rule exactly one of them owns it."),
     makeFan},
    {"tunnel", TEXT("Tunnel through the camera"),
     TEXT("The tube starts behind the camera: its first rings lie behind the eye or cross its plane, where w is 0."),
     makeTunnel},
    {"cube", TEXT("Cube"), TEXT("Closed and convex, one colour a face. Culling alone hides what is hidden."), makeCube},
    {"sphere", TEXT("Sphere"), TEXT("Closed and convex, with smooth normals. Compare flat, Gouraud and Phong shading."),
     makeSphere},
    {"painter-cycle", TEXT("Three blades in a circle"),
     TEXT("Each lies over the next, so no order of painting is right. The depth test decides pixel by pixel."),
     makePainterCycle},
    {"piercing", TEXT("Two triangles that pierce each other"),
     TEXT("Each is in front in one half. The painter's algorithm shows one of them whole."), makePiercing},
    {"z-fighting", TEXT("Z-fighting"),
     TEXT("The orange panel is in front everywhere. The near plane is so close that depth cannot tell it from the "
          "wall."),
     makeZFighting},
    {"slivers", TEXT("Sheaf of needles"),
     TEXT("Triangles thinner than a pixel: most centres fall between them. Try more samples."), makeSlivers},
    {"behind-camera", TEXT("A corner behind the camera"),
     TEXT(
         "The green corner lies behind the eye. The division by its negative w turns the triangle inside out unless it "
         "is clipped first."),
     makeBehindCamera},
    {"covering", TEXT("Larger than the screen"),
     TEXT("All corners of the large triangle lie outside, yet it covers the screen. Rejecting faces without a corner "
          "inside loses it."),
     makeCovering},
    {"edge-guardband", TEXT("Blades over the border"),
     TEXT("They leave the screen on all sides, every third beyond the guard band. Compare how many faces are clipped."),
     makeEdgeGuardband},
    {"lines", TEXT("Lines in all directions"),
     TEXT("A star in wireframe: slopes 0, 1/3, 1 and 3 in all octants, from pixel centre to pixel centre."), makeLines},
    {"four-z", TEXT("Board for four z values"),
     TEXT(
         "The board goes from distance 1 on the left to 10 on the right, the markers stand at thirds of the screen. In "
         "the middle z/w is 0.8938 and the distance 1.818: z/w is linear on the screen, the distance is not. "
         "Board and markers have equal colours at equal distances, unless interpolation is affine."),
     makeFourZ},
};

#undef TEXT

Scene makeWhole(const BuiltinScene& entry)
{
    Scene scene = entry.make();
    scene.id = QStringLiteral("builtin:") + QLatin1String(entry.name);
    scene.title = QString::fromUtf8(entry.title);
    scene.note = QString::fromUtf8(entry.note);
    scene.bounds = boundingSphere(scene.mesh);
    if (scene.materials.empty()) {
        Material material;
        material.name = QLatin1String(entry.name);
        scene.materials.push_back(material);
    }
    return scene;
}

} // namespace

std::span<const BuiltinScene> builtinScenes() { return kScenes; }

SceneLoad makeBuiltinScene(const QString& name)
{
    const auto entry =
        std::ranges::find_if(kScenes, [&](const BuiltinScene& s) { return name == QLatin1String(s.name); });
    if (entry != std::end(kScenes))
        return {makeWhole(*entry), {}};
    QStringList names;
    for (const BuiltinScene& scene : kScenes)
        names << QLatin1String(scene.name);
    const QString message =
        QStringLiteral("there is no such built-in scene; expected one of: %1").arg(names.join(QStringLiteral(", ")));
    return {std::nullopt, {{Severity::Error, QStringLiteral("builtin:") + name, 0, message}}};
}

} // namespace rasterlens
