#include "core/scenes/builtin_scenes.h"

#include "core/scenes/makers.h"

#include <QCoreApplication>

#include <algorithm>

namespace rasterlens
{
namespace
{

constexpr BuiltinScene kScenes[] = {
    {"triangle", QT_TRANSLATE_NOOP("BuiltinScene", "Triangle"),
     QT_TRANSLATE_NOOP("BuiltinScene", "One triangle with a red, a green and a blue corner."), makeTriangle},
    {"square-diagonal", QT_TRANSLATE_NOOP("BuiltinScene", "Square cut by its diagonal"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "The diagonal runs through the centres of 8 pixels. Each of them must belong to one triangle, not to both and "
         "not to none."),
     makeSquareDiagonal},
    {"triangle-600", QT_TRANSLATE_NOOP("BuiltinScene", "Triangle on 600 x 600"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "The corners (100, 200), (300, 400) and (400, 100), with y counted upwards as in tinyrenderer. On the screen, "
         "where y runs down, they are (100, 400), (300, 200) and (400, 500); the order is clockwise."),
     makeTriangle600},
    {"games101", QT_TRANSLATE_NOOP("BuiltinScene", "GAMES101: two triangles"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "The front triangle is sent first. Without a depth test the back one is painted over it."),
     makeGames101},
    {"games101-tilted", QT_TRANSLATE_NOOP("BuiltinScene", "GAMES101: the same pixels, tilted"),
     QT_TRANSLATE_NOOP("BuiltinScene", "The two triangles of GAMES101 with every corner moved along its ray to the "
                                       "eye: they cover the same pixels, but "
                                       "the w of a face are 3.5, 7, 14 and 10, 20, 5. Affine interpolation, a lost w "
                                       "and a corrected depth show here."),
     makeGames101Tilted},
    {"tile-square", QT_TRANSLATE_NOOP("BuiltinScene", "4 x 4 tiles in perspective"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "Two triangles. With affine interpolation the tiles and the white middle line break at the diagonal."),
     makeTileSquare},
    {"head", QT_TRANSLATE_NOOP("BuiltinScene", "Head with an open mouth"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "Faces are sent from the front to the back. Without the depth test the cavity behind the lips shows through, "
         "although back faces are culled."),
     makeHead},
    {"teapot", QT_TRANSLATE_NOOP("BuiltinScene", "Utah teapot"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "32 Bezier patches. The published model is open between lid and body and at the spout, so back faces are "
         "kept."),
     makeTeapot},
    {"torus-knot", QT_TRANSLATE_NOOP("BuiltinScene", "Torus knot"),
     QT_TRANSLATE_NOOP("BuiltinScene", "A closed surface that hides itself many times."), makeTorusKnot},
    {"floor", QT_TRANSLATE_NOOP("BuiltinScene", "Floor to the horizon"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "The floor passes under and behind the camera. Without near clipping the foreground is lost; with the depth "
         "test off as well, what lies behind hangs upside down in the sky."),
     makeFloor},
    {"letter-f", QT_TRANSLATE_NOOP("BuiltinScene", "Letter F"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "Orange in front, blue at the back. An F shows every flip, and every mistake of winding."),
     makeLetterF},
    {"leaf", QT_TRANSLATE_NOOP("BuiltinScene", "Leaf"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "An open surface: where the leaf turns its back, back-face culling tears a hole into it. Turn culling off."),
     makeLeaf},
    {"fan", QT_TRANSLATE_NOOP("BuiltinScene", "Fan"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "16 triangles meet at the centre of the middle pixel. Under the top-left rule exactly one of them owns it."),
     makeFan},
    {"tunnel", QT_TRANSLATE_NOOP("BuiltinScene", "Tunnel through the camera"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "The tube starts behind the camera: its first rings lie behind the eye or cross its plane, where w is 0."),
     makeTunnel},
    {"cube", QT_TRANSLATE_NOOP("BuiltinScene", "Cube"),
     QT_TRANSLATE_NOOP("BuiltinScene", "Closed and convex, one colour a face. Culling alone hides what is hidden."),
     makeCube},
    {"sphere", QT_TRANSLATE_NOOP("BuiltinScene", "Sphere"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "Closed and convex, with smooth normals. Compare flat, Gouraud and Phong shading."),
     makeSphere},
    {"painter-cycle", QT_TRANSLATE_NOOP("BuiltinScene", "Three blades in a circle"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "Each lies over the next, so no order of painting is right. The depth test decides pixel by pixel."),
     makePainterCycle},
    {"piercing", QT_TRANSLATE_NOOP("BuiltinScene", "Two triangles that pierce each other"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "Each is in front in one half. The painter's algorithm shows one of them whole."),
     makePiercing},
    {"z-fighting", QT_TRANSLATE_NOOP("BuiltinScene", "Z-fighting"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "The orange panel is in front everywhere. The near plane is so close that depth cannot tell it from the "
         "wall."),
     makeZFighting},
    {"slivers", QT_TRANSLATE_NOOP("BuiltinScene", "Sheaf of needles"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "Triangles thinner than a pixel: most centres fall between them. Try more samples."),
     makeSlivers},
    {"behind-camera", QT_TRANSLATE_NOOP("BuiltinScene", "A corner behind the camera"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "The green corner lies behind the eye. The division by its negative w turns the triangle inside out unless it "
         "is clipped first."),
     makeBehindCamera},
    {"covering", QT_TRANSLATE_NOOP("BuiltinScene", "Larger than the screen"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "All corners of the large triangle lie outside, yet it covers the screen. Rejecting faces without a corner "
         "inside loses it."),
     makeCovering},
    {"edge-guardband", QT_TRANSLATE_NOOP("BuiltinScene", "Blades over the border"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "They leave the screen on all sides, every third beyond the guard band. Compare how many faces are clipped."),
     makeEdgeGuardband},
    {"lines", QT_TRANSLATE_NOOP("BuiltinScene", "Lines in all directions"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "A star in wireframe: slopes 0, 1/3, 1 and 3 in all octants, from pixel centre to pixel centre."),
     makeLines},
    {"four-z", QT_TRANSLATE_NOOP("BuiltinScene", "Board for four z values"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "The board goes from distance 1 on the left to 10 on the right, the markers stand at thirds of the screen. In "
         "the middle z/w is 0.8938 and the distance 1.818: z/w is linear on the screen, the distance is not. "
         "Board and markers have equal colours at equal distances, unless interpolation is affine."),
     makeFourZ},
    {"decal", QT_TRANSLATE_NOOP("BuiltinScene", "Paint on a road"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "Two passes: the road, then paint in its plane. Depths of the two are as good as equal, and without the depth "
         "bias chance decides pixel by pixel which is nearer."),
     makeDecal},
    {"wire-over-fill", QT_TRANSLATE_NOOP("BuiltinScene", "Wireframe over a surface"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "Two passes: a surface, then the lines of its faces. A pixel of a line is up to half a pixel "
                       "beside the line; how much depth that is depends on the slope of the face."),
     makeWireOverFill},
    {"equal-pass", QT_TRANSLATE_NOOP("BuiltinScene", "A second pass at equal depth"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "Two passes: a board, then tiles at the same depth, drawn where depths are equal. Each has "
                       "another w, so that z/w is off by a rounding, which 16 bits must round away."),
     makeEqualPass},
    {"beam-to-eye", QT_TRANSLATE_NOOP("BuiltinScene", "A beam up to the eye"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "The near plane cuts the beam, and one looks into it. Where depths are clamped in place of "
                       "clipping, what lies before the plane is drawn too, all of it at depth 0."),
     makeBeamToEye},
    {"lockstep", QT_TRANSLATE_NOOP("BuiltinScene", "Three pairs of triangles"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "Of each pair the warm triangle is nearer and is sent first. Two threads without a lock draw "
                       "the two at the same time."),
     makeLockstep},
    {"cut-outs", QT_TRANSLATE_NOOP("BuiltinScene", "Leaves cut out of squares"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "Six squares and a wall, sent from front to back. Around each leaf the texture is transparent: without the "
         "alpha test the corners of a square hide what lies behind, because they write depth although nothing is to "
         "be seen there."),
     makeCutOuts},
    {"square-counted", QT_TRANSLATE_NOOP("BuiltinScene", "The square, hits counted"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "The square cut by its diagonal; colours tell how many triangles cover a pixel. It must be one."),
     makeSquareCounted},
    {"thin-gap", QT_TRANSLATE_NOOP("BuiltinScene", "A panel close before a wall"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "As in z-fighting, but with the near plane at 0.5: 32-bit depth can tell panel and wall apart, 16 bits "
         "cannot."),
     makeThinGap},
    {"three-layers", QT_TRANSLATE_NOOP("BuiltinScene", "Near, far, middle"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "Three rectangles, sent in this order: orange in front, blue at the back, green between them."),
     makeThreeLayers},
    {"two-windings", QT_TRANSLATE_NOOP("BuiltinScene", "Two squares, two windings"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "The left square is counter-clockwise, the right one clockwise. A rule must treat both alike. "
                       "Colours tell how many triangles cover a pixel."),
     makeTwoWindings},
    {"line-ties", QT_TRANSLATE_NOOP("BuiltinScene", "Diagonals drawn both ways"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "Both triangles of a rectangle draw its diagonal, one from each end. It passes half-way between "
                       "two pixels: a choice that depends on the direction makes it two pixels thick there."),
     makeLineTies},
    {"tiny-tiles", QT_TRANSLATE_NOOP("BuiltinScene", "Tiles smaller than a pixel"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "From half a pixel on the left to several on the right. However small they are, together they cover every "
         "pixel once."),
     makeTinyTiles},
    {"samples", QT_TRANSLATE_NOOP("BuiltinScene", "Edges between samples"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "2 x 2 samples a pixel. The orange triangle is nearer and sent first; the white square is cut by its "
         "diagonal, of which nothing may be seen."),
     makeSamples},
    {"msaa-sprite", QT_TRANSLATE_NOOP("BuiltinScene", "MSAA: sheets with a part of a texture"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "4 samples a pixel, attributes at centroids. Round the sheets' part of the texture all is magenta, "
         "which must not be seen."),
     makeMsaaSprite},
    {"msaa-gradient", QT_TRANSLATE_NOOP("BuiltinScene", "MSAA: needles under fine stripes"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "8 samples a pixel, attributes at centroids. The needles lie in one plane, and their stripes are "
         "finer than the pixels: all must be grey."),
     makeMsaaGradient},
    {"msaa-seams", QT_TRANSLATE_NOOP("BuiltinScene", "MSAA: a disc of 20 triangles"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "4 samples a pixel. The triangles share their edges, of which nothing may be seen."),
     makeMsaaSeams},
    {"zero-area", QT_TRANSLATE_NOOP("BuiltinScene", "Triangles without area"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "Three triangles are flattened to lines through pixel centres. They must not be seen."),
     makeZeroArea},
    {"long-sliver", QT_TRANSLATE_NOOP("BuiltinScene", "Two needles of 4,000 pixels"),
     QT_TRANSLATE_NOOP("BuiltinScene", "They share a long edge. What is added up along it must not drift."),
     makeLongSliver},
    {"huge-triangle", QT_TRANSLATE_NOOP("BuiltinScene", "A triangle of 60,000 pixels"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "Not clipped: on the left half of the screen an edge value needs more than 32 bits."),
     makeHugeTriangle},
    {"overhang", QT_TRANSLATE_NOOP("BuiltinScene", "Over the right border"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "With a guard band the triangle is not clipped; the bounding box alone keeps it on the screen."),
     makeOverhang},
    {"flat-edge", QT_TRANSLATE_NOOP("BuiltinScene", "Flat edges"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "Three arrow heads, whose lower halves mirror the upper ones. The edges of the flattest fall by 2 "
         "rows on 28 columns: what is off by a part of a row is off by many columns."),
     makeFlatEdge},
    {"cut-on-centres", QT_TRANSLATE_NOOP("BuiltinScene", "A cut edge through pixel centres"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "The common edge y = x + 8 runs through the centres of 40 pixels. It is cut at the left border for the orange "
         "triangle; the blue one has a corner there. The corner outside has code 1001: cut on the left it is still "
         "1000, "
         "above."),
     makeCutOnCentres},
    {"between-rows", QT_TRANSLATE_NOOP("BuiltinScene", "Corners between the rows"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "Three arrow heads, whose lower halves mirror the upper ones. Their tips lie at half "
                       "rows, the other corners elsewhere between them."),
     makeBetweenRows},
    {"small-screen", QT_TRANSLATE_NOOP("BuiltinScene", "A screen of 320 x 240"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "All corners lie on the screen, yet twice the area is 67,944: 16 bits, of which one "
                       "is for the sign, hold it no more."),
     makeSmallScreen},
    {"points-over-border", QT_TRANSLATE_NOOP("BuiltinScene", "Points over the border"),
     QT_TRANSLATE_NOOP("BuiltinScene", "A point in every pixel, and more of them beyond the left and the upper border. "
                                       "Colours tell how often a pixel is hit: once."),
     makePointsOverBorder},
    {"signpost", QT_TRANSLATE_NOOP("BuiltinScene", "A letter before two pillars"),
     QT_TRANSLATE_NOOP("BuiltinScene", "The red pillar stands on the left, the green one on the right, and the floor "
                                       "ends behind them: every wrong step of the camera shows."),
     makeSignpost},
    {"road", QT_TRANSLATE_NOOP("BuiltinScene", "A road from far right to behind"),
     QT_TRANSLATE_NOOP("BuiltinScene", "The corners on the left lie behind the eye. Divided by their negative w they "
                                       "come out on the right, where all others are."),
     makeRoad},
    {"squashed-ball", QT_TRANSLATE_NOOP("BuiltinScene", "A ball pressed flat"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "A sphere stretched by 1, 0.3 and 1. Its normals are not stretched but pressed the other way round."),
     makeSquashedBall},
    {"picture-card", QT_TRANSLATE_NOOP("BuiltinScene", "A picture of 10 x 10 texels"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "A letter in a frame that is one texel wide on every side, blended between the centres of texels."),
     makePictureCard},
    {"texels-about-zero", QT_TRANSLATE_NOOP("BuiltinScene", "Texels left and right of 0"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "u and v are 0 in the middle and run from -1.5 to 1.5. All texels are 8 pixels wide."),
     makeTexelsAboutZero},
    {"disc-floor", QT_TRANSLATE_NOOP("BuiltinScene", "Discs to the horizon"),
     QT_TRANSLATE_NOOP(
         "BuiltinScene",
         "A texture with mip levels that repeats every 2.5 units. Where it repeats, both sides have one colour."),
     makeDiscFloor},
    {"coarse-ball", QT_TRANSLATE_NOOP("BuiltinScene", "A glazed ball of few faces"),
     QT_TRANSLATE_NOOP("BuiltinScene",
                       "48 cells with smooth normals. In the highlights light is brighter than a screen can show."),
     makeCoarseBall},
};

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
    return {std::nullopt,
            {{Severity::Error,
              QStringLiteral("builtin:") + name,
              0,
              {QT_TRANSLATE_NOOP("Diagnostic", "there is no such built-in scene; expected one of: %1"),
               {names.join(QStringLiteral(", "))}}}}};
}

} // namespace rasterlens
