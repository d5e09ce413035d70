#include "core/mistakes.h"

#include <QCoreApplication>

#include <algorithm>
#include <limits>

namespace rasterlens
{
namespace
{

#define TEXT(text) QT_TRANSLATE_NOOP("Mistake", text)

// id, number, title; what one sees; the wrong line; why people write it; scene, proof; the rule it gets wrong.
constexpr Mistake kMistakes[] = {
    {"all-inclusive", "M1", TEXT("All edges are inclusive"),
     TEXT("Pixels on a shared edge are drawn by both triangles: wrong where colours blend or are counted."),
     TEXT("inside = e0 >= 0 && e1 >= 0 && e2 >= 0"), TEXT("A point on the edge is in the triangle, is it not?"),
     "square-counted", Proof::CoveredTwice, Change::Rises, [](Rules& r) { r.tie = {0, 0}; }},
    {"all-exclusive", "M2", TEXT("All edges are exclusive"),
     TEXT("Pixels on a shared edge are drawn by neither triangle: a row of holes."),
     TEXT("inside = e0 > 0 && e1 > 0 && e2 > 0"), TEXT("It stops pixels from being drawn twice."), "square-diagonal",
     Proof::Holes, Change::Rises, [](Rules& r) { r.tie = {1, 1}; }},
    {"either-sign", "M3", TEXT("Top-left bias with \"all positive or all negative\""),
     TEXT("Counter-clockwise triangles are right, at the shared edges of clockwise ones pixels are drawn twice."),
     TEXT("inside = all e + bias >= 0 || all e + bias <= 0"),
     TEXT("It makes the test independent of the winding; the bias is not."), "two-windings", Proof::CoveredTwice,
     Change::Rises,
     [](Rules& r) {
         r.triangleOriented = false;
         r.insideTest = InsideTest::EitherSign;
     }},
    {"float-bias-one", "M4", TEXT("A fixed bias of 1 on floating-point edges"),
     TEXT("A crack between neighbours, the wider the shorter the edge; small triangles vanish."),
     TEXT("float bias = ownsPoints ? 0 : -1"), TEXT("In integers, 1 is the smallest step. In floats it is a pixel."),
     "torus-knot", Proof::Holes, Change::Rises,
     [](Rules& r) {
         r.numberType = NumberType::Float32;
         r.floatTieUnit = 1;
     }},
    {"corner-sampling", "M5", TEXT("Sampled at the pixel's corner"),
     TEXT("The picture sits half a pixel too far right and down."), TEXT("edge(x, y) in place of edge(x + 0.5, y + 0.5)"),
     TEXT("The loop variables are right there."), "triangle-600", Proof::WrongPixels, Change::Rises,
     [](Rules& r) { r.screenShift = 0.5; }},
    {"integer-vertices", "M6", TEXT("Vertices are cast to int"),
     TEXT("Edges jump by whole pixels when something moves, and triangles smaller than a pixel collapse."),
     TEXT("Vec2i p = {(int)v.x, (int)v.y}"), TEXT("Pixels have integer coordinates."), "tiny-tiles", Proof::Degenerate,
     Change::Rises, [](Rules& r) { r.verticesTruncated = true; }},
    {"one-winding", "M8", TEXT("One winding only, and triangles are not oriented"),
     TEXT("Clockwise triangles vanish although nothing is culled."),
     TEXT("area is not looked at before the edges are set up"), TEXT("The first triangle one tries works."),
     "two-windings", Proof::Holes, Change::Rises, [](Rules& r) { r.triangleOriented = false; }},
    {"weights-rotated", "M9", TEXT("Barycentric weights rotated by one corner"),
     TEXT("All colours move on by one corner."), TEXT("e_AB / area is used as the weight of A"),
     TEXT("The edge is named after its first corner; its value belongs to the corner opposite."), "triangle-600",
     Proof::WrongPixels, Change::Rises, [](Rules& r) { r.cornerData = CornerData::Next; }},
    {"weights-exchanged", "M9", TEXT("Two barycentric weights exchanged"), TEXT("Two corners have each other's colour."),
     TEXT("color = u * A + w * B + v * C"), TEXT("B and C were swapped to turn the triangle round, and only they."),
     "triangle-600", Proof::WrongPixels, Change::Rises, [](Rules& r) { r.cornerData = CornerData::Exchanged; }},
    {"position-interpolated", "M10", TEXT("The interpolated position overwrites the pixel's"),
     TEXT("Holes like pepper: 6.9999995 is cut to 6, and its neighbour is drawn twice."),
     TEXT("x = (int)(u * A.x + v * B.x + w * C.x)"), TEXT("Position is an attribute like all others."), "triangle-600",
     Proof::Holes, Change::Rises, [](Rules& r) { r.positionInterpolated = true; }},
    {"sort-positions-only", "M11", TEXT("Sorting by y moves positions only"),
     TEXT("Colours sit at wrong corners, in some triangles and not in others."),
     TEXT("if (b.y < a.y) swap(a.position, b.position)"), TEXT("The sort was there before the colours were."),
     "triangle-600", Proof::WrongPixels, Change::Rises, [](Rules& r) { r.cornerData = CornerData::Unsorted; }},
    {"height-plus-one", "M12", TEXT("+1 on the height of an edge"),
     TEXT("The short edges end beside the middle corner: a kink, and an outline that is off by up to a pixel."),
     TEXT("slope = (b.x - a.x) / (b.y - a.y + 1)"), TEXT("It avoids dividing by zero."), "tiny-tiles",
     Proof::WrongFaces, Change::Rises,
     [](Rules& r) {
         r.algorithm = Algorithm::EdgeWalking;
         r.extraEdgeHeight = 1;
     }},
    {"steep-columns", "M13", TEXT("Steep lines column by column"),
     TEXT("A line of 1 x 10 ends at y = 20; of vertical lines, which would divide by zero, only a dot is left."),
     TEXT("error += dy / dx; while (error > 0.5) ++y"), TEXT("It looks like the line algorithm, for flat lines."),
     "lines", Proof::Tested, Change::Rises, [](Rules& r) { r.lineAdvance = LineAdvance::Columns; }},
    {"integer-weight", "M14", TEXT("The weight along a line divided in integers"),
     TEXT("Each line has one colour from its first pixel to the last but one."), TEXT("float t = i / n, both int"),
     TEXT("The result is stored in a float."), "lines", Proof::Colors, Change::Falls,
     [](Rules& r) { r.integerLineWeights = true; }},
    {"missing-octant", "M15", TEXT("An octant of the line algorithm is missing"),
     TEXT("Lines in one direction are not drawn."), TEXT("if (dy > dx && dx > 0 && dy > 0) is never written"),
     TEXT("Seven cases work."), "lines", Proof::Covered, Change::Falls, [](Rules& r) { r.lineOctants = 0xff & ~0x2U; }},
    {"missing-last-pixel", "M15", TEXT("The last pixel of a line is missing"),
     TEXT("Lines stop one pixel short: the corners on the right of triangles are open."), TEXT("if (x1 < x0) swap; for (x = x0; x < x1; ++x)"),
     TEXT("Loops end before the end."), "lines", Proof::Covered, Change::Falls,
     [](Rules& r) { r.rightLineEnds = false; }},
    {"affine", "M16", TEXT("Attributes are linear on the screen"),
     TEXT("Tiles and lines break at the diagonal of the square and swim when the camera moves."),
     TEXT("uv = u * A.uv + v * B.uv + w * C.uv"), TEXT("Right for z, and right without perspective."), "tile-square",
     Proof::WrongPixels, Change::Rises, [](Rules& r) { r.perspectiveCorrect = false; }},
    {"w-lost", "M17", TEXT("w is lost before interpolation"),
     TEXT("Perspective correction is on and changes nothing: the picture is the affine one."),
     TEXT("v = v / v.w, and v.w is 1 from then on"), TEXT("After the divide nobody needs w any more."), "tile-square",
     Proof::WrongPixels, Change::Rises, [](Rules& r) { r.keptW = KeptW::One; }},
    {"w-not-inverted", "M18", TEXT("Weights of the correction exchanged: t Z2 for t Z1"),
     TEXT("The picture bends the other way: worse than without correction."),
     TEXT("n = m * Z2 / ((1 - m) * Z1 + m * Z2)"), TEXT("The formula is symmetric enough to be remembered wrong."),
     "tile-square", Proof::WrongPixels, Change::Rises, [](Rules& r) { r.keptW = KeptW::Itself; }},
    {"w-before-clipping", "M19", TEXT("w of the unclipped triangle used after clipping"),
     TEXT("Textures are torn in triangles that are cut, and right in all others."),
     TEXT("the pieces keep the w of corner 0, 1, 2 of the face"), TEXT("w was stored per face, before there was a clipper."),
     "floor", Proof::WrongPixels, Change::Rises, [](Rules& r) { r.clipUpdatesW = false; }},
    {"z-corrected", "M20", TEXT("z/w gets the perspective correction of attributes"),
     TEXT("Depth between the corners is too near: things cut through each other at wrong places."),
     TEXT("z = interpolate(A.z / A.w, ...) with perspective weights"),
     TEXT("z is an attribute like all others. But z/w is linear on the screen already."), "four-z", Proof::DepthError,
     Change::Rises, [](Rules& r) { r.depthLinear = false; }},
    {"view-z-linear", "M20", TEXT("The distance is interpolated linearly on the screen"),
     TEXT("Depth between the corners is too far: what lies behind shows through the middle of steep faces."),
     TEXT("z = u * A.z + v * B.z + w * C.z with z of view space"),
     TEXT("The distance is what depth means. But only 1/z is linear on the screen."), "four-z", Proof::WrongFaces,
     Change::Rises, [](Rules& r) { r.depthIsDistance = true; }},
    {"no-near-clip", "M21", TEXT("No clipping at the near plane"),
     TEXT("What is behind the camera comes back mirrored, upside down."), TEXT("x / w, whatever the sign of w"),
     TEXT("The divide works without complaint."), "behind-camera", Proof::WrongFaces, Change::Rises,
     [](Rules& r) { r.clipping = Clipping::None; }},
    {"any-vertex-inside", "M22", TEXT("A face is kept if any vertex is inside"),
     TEXT("A triangle that covers the whole screen vanishes, as all its corners are outside."),
     TEXT("if (!inside(a) && !inside(b) && !inside(c)) reject"), TEXT("What is visible has a corner that is visible."),
     "covering", Proof::Rejected, Change::Rises, [](Rules& r) { r.clipping = Clipping::AnyVertexInside; }},
    {"near-far-reject", "M23", TEXT("Whole faces are dropped at near and far"),
     TEXT("Large triangles vanish as soon as one corner passes the camera."), TEXT("if (any w < near) reject"),
     TEXT("It avoids the division by zero, and cutting."), "tunnel", Proof::Holes, Change::Rises,
     [](Rules& r) { r.clipping = Clipping::NearFarReject; }},
    {"cut-corners", "M24", TEXT("Only edges are clipped"),
     TEXT("Where the triangle covers a corner of the screen, the corner is cut off."),
     TEXT("polygon = what Cohen-Sutherland leaves of the edges"), TEXT("A triangle is its three edges."), "behind-camera",
     Proof::Holes, Change::Rises,
     [](Rules& r) {
         r.clipping = Clipping::CohenSutherland;
         r.clipKeepsCorners = false;
     }},
    {"return-for-continue", "M25", TEXT("return in place of continue"),
     TEXT("Everything after the first rejected face is missing."), TEXT("if (outside) return;"),
     TEXT("The body of the loop was a function once."), "floor", Proof::Holes, Change::Rises,
     [](Rules& r) { r.continuesAfterReject = false; }},
    {"nudged-cut", "M26", TEXT("Cut vertices are nudged inward by 0.001"),
     TEXT("A gap at the border of the screen and in front of the camera."), TEXT("t = t + 0.001"),
     TEXT("So that the vertex lies inside for certain."), "edge-guardband", Proof::Holes, Change::Rises,
     [](Rules& r) { r.clipInset = 0.001; }},
    {"cull-reversed", "M27", TEXT("Culling with the wrong sign"),
     TEXT("One looks into closed bodies: only the insides of their backs are drawn."), TEXT("if (area > 0) cull"),
     TEXT("y runs down on the screen, so the sign flips."), "letter-f", Proof::WrongFaces, Change::Rises,
     [](Rules& r) { r.frontSign = -r.frontSign; }},
    {"cull-by-light", "M27", TEXT("Culled by the direction of the light"),
     TEXT("What faces the camera but not the light is missing."), TEXT("if (dot(normal, light) < 0) cull"),
     TEXT("In the first example light and gaze are one direction."), "torus-knot", Proof::Holes, Change::Rises,
     [](Rules& r) {
         r.culling = Culling::Back;
         r.facing = Facing::LightNormal;
     }},
    {"cull-before-divide", "M27", TEXT("Culled by the area before the divide"),
     TEXT("Faces seen at a grazing angle vanish or show their back."), TEXT("area of clip.x, clip.y, without / w"),
     TEXT("The sign does not need the divide, if all w are alike."), "tunnel", Proof::Holes, Change::Rises,
     [](Rules& r) { r.facing = Facing::AreaWithoutDivide; }},
    {"cull-before-clip", "M27", TEXT("Culled by the divided area before clipping"),
     TEXT("Faces that reach behind the camera vanish: there the divide turns them round."),
     TEXT("area of x / w, y / w of the unclipped face"), TEXT("It saves clipping what is culled anyway."), "tunnel",
     Proof::Holes, Change::Rises, [](Rules& r) { r.facing = Facing::AreaWithoutClipping; }},
    {"no-z-buffer", "M28", TEXT("No z-buffer"), TEXT("What is sent last is in front: the mouth shows through the lips."),
     TEXT("image.set(x, y, color) without a test"), TEXT("Culling alone is enough for convex bodies."), "head",
     Proof::WrongFaces, Change::Rises, [](Rules& r) { r.depthTested = false; }},
    {"depth-cleared-to-zero", "M29", TEXT("z-buffer cleared to 0"), TEXT("Nothing is drawn."),
     TEXT("fill(zbuffer, 0) where smaller is nearer"), TEXT("Memory is cleared to 0."), "games101", Proof::DepthPassed,
     Change::Falls, [](Rules& r) { r.depthClear = 0; }},
    {"depth-cleared-to-min", "M29", TEXT("z-buffer cleared to numeric_limits<float>::min()"),
     TEXT("Nothing is drawn: min() is the smallest number above 0, not the lowest of all."),
     TEXT("fill(zbuffer, numeric_limits<float>::min())"), TEXT("For int, min() is the lowest number."), "games101",
     Proof::DepthPassed, Change::Falls, [](Rules& r) { r.depthClear = std::numeric_limits<float>::min(); }},
    {"depth-reversed", "M30", TEXT("The depth comparison is reversed"),
     TEXT("What is farthest is in front."), TEXT("if (z > zbuffer[i])"),
     TEXT("Other texts have z growing towards the viewer."), "games101", Proof::WrongFaces, Change::Rises,
     [](Rules& r) {
         r.depthCompare = DepthCompare::Greater;
         r.depthClear = 0;
     }},
    {"depth-written-on-fail", "M30", TEXT("Depth is written even if the test fails"),
     TEXT("A third surface shows through the nearest one where a second one lies between."),
     TEXT("zbuffer[i] = z stands below the if, not in it"), TEXT("A pair of braces."), "three-layers", Proof::WrongFaces,
     Change::Rises, [](Rules& r) { r.depthWrittenOnFail = true; }},
    {"few-depth-bits", "M31", TEXT("Few depth bits and a near plane close to the eye"),
     TEXT("Surfaces close to each other flicker in stripes."), TEXT("16-bit depth, near = 0.5, far = 1000"),
     TEXT("The nearer the near plane, the less is lost, one thinks; it takes most of the depth values."), "thin-gap",
     Proof::WrongFaces, Change::Rises, [](Rules& r) { r.depthFormat = DepthFormat::Unorm16; }},
    {"coverage-times-color", "M32", TEXT("Coverage times colour in place of stored samples"),
     TEXT("Dark lines along edges, also where two triangles of one colour meet."),
     TEXT("pixel = color * inside / 4"), TEXT("Four samples inside: the full colour; two: half of it."), "samples",
     Proof::MissingLight, Change::Rises, [](Rules& r) { r.resolve = Resolve::LastFace; }},
    {"one-depth-per-pixel", "M33", TEXT("One depth for all samples of a pixel"),
     TEXT("A fringe of background round what was drawn first: what lies behind fails its test there."),
     TEXT("zbuffer[pixel] in place of zbuffer[sample]"), TEXT("One value a pixel was enough before."), "samples",
     Proof::DepthFailed, Change::Rises, [](Rules& r) { r.depthPerPixel = true; }},
    {"truncated-samples", "M34", TEXT("inside(int, int) truncates the samples"),
     TEXT("Edges are as jagged as with one sample, at four times the cost."),
     TEXT("bool inside(int x, int y) called with x + 0.25"), TEXT("The compiler converts in silence."), "samples",
     Proof::Colors, Change::Falls, [](Rules& r) { r.samplesTruncated = true; }},
    {"stride-exchanged", "M35", TEXT("Rows of samples at the wrong stride"),
     TEXT("The picture is sheared into stripes; in a square window it is right."),
     TEXT("samples[y * height + x]"), TEXT("Tried in a square window."), "samples", Proof::WrongPixels, Change::Rises,
     [](Rules& r) { r.strideIsRows = true; }},
    {"box-not-clamped", "M36", TEXT("The bounding box is not clamped to the window"),
     TEXT("What hangs over the right border comes in at the left, a row lower; elsewhere memory is overwritten."),
     TEXT("for (x = floor(minX); x <= ceil(maxX); ++x)"), TEXT("Everything was on the screen so far."), "overhang",
     Proof::Strays, Change::Rises, [](Rules& r) { r.bounds = Bounds::Unclamped; }},
    {"box-one-short", "M36", TEXT("The bounding box is off by one"),
     TEXT("The last column and the last row of each triangle are missing."), TEXT("for (x = minX; x < maxX; ++x)"),
     TEXT("Loops end before the end."), "square-diagonal", Proof::Holes, Change::Rises,
     [](Rules& r) { r.bounds = Bounds::OneShort; }},
    {"int32-overflow", "M37", TEXT("Edge values in 32 bits"),
     TEXT("Above 46,341 pixels, whose square needs more than 31 bits, values wrap round: triangles have holes with "
          "straight edges."),
     TEXT("int e = (x - a.x) * (b.y - a.y) - ..."), TEXT("No screen is that large. Unclipped triangles are."),
     "huge-triangle", Proof::Holes, Change::Rises, [](Rules& r) { r.insideTest = InsideTest::Wrapped32; }},
    {"zero-area-kept", "M38", TEXT("Triangles without area are not rejected"),
     TEXT("Black lines: the weights are 0/0, which no comparison holds back."),
     TEXT("u = e / area, without a look at area"), TEXT("Who would send such triangles?"), "zero-area",
     Proof::Rasterized, Change::Rises,
     [](Rules& r) {
         r.rejectsZeroArea = false;
         r.tie = {0, 0};
     }},
    {"small-area-dropped", "M38", TEXT("Triangles of less than half a pixel are dropped"),
     TEXT("Meshes finer than the pixels have holes or vanish."), TEXT("if (abs(area2) < 1) return"),
     TEXT("It avoids dividing by almost zero."), "tiny-tiles", Proof::Degenerate, Change::Rises,
     [](Rules& r) { r.smallestArea2 = 1; }},
    {"float-drift", "M39", TEXT("Edge values added up in float32"),
     TEXT("Rounding piles up along a long row: holes and double hits at shared edges."), TEXT("float e; e += dx"),
     TEXT("One addition is cheaper than a product."), "long-sliver", Proof::WrongFaces, Change::Rises,
     [](Rules& r) {
         r.numberType = NumberType::Float32;
         r.stepping = Stepping::Incremental;
     }},
    {"y-flipped-once", "M40", TEXT("y is flipped in one stage only"),
     TEXT("The picture stands on its head, and one sees the backs: the windings are flipped with it."),
     TEXT("ys = (0.5 + y / w * 0.5) * height"), TEXT("One of two flips was taken out."), "letter-f",
     Proof::WrongPixels, Change::Rises, [](Rules& r) { r.screenUp = 1; }},
};

#undef TEXT

} // namespace

std::span<const Mistake> mistakes() { return kMistakes; }

const Mistake* findMistake(const QString& id)
{
    const auto found =
        std::ranges::find_if(kMistakes, [&](const Mistake& mistake) { return id == QLatin1String(mistake.id); });
    return found == std::end(kMistakes) ? nullptr : found;
}

} // namespace rasterlens
