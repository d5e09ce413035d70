#include "core/settings/mistakes.h"

#include "core/settings/mistake_row.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace rasterlens
{
namespace
{

using enum StepKind;

// id, number, title; what one sees; the wrong line; why people write it; scene, proof; the steps it shows at; the rule
// it gets wrong.
constexpr MistakeRow kRows[] = {
    {"all-inclusive", "M1",
     QT_TRANSLATE_NOOP("Mistake", "All edges are inclusive"),
     QT_TRANSLATE_NOOP("Mistake", "Pixels on a shared edge are drawn by both triangles: wrong where colours blend or are counted."),
     QT_TRANSLATE_NOOP("Mistake", "inside = E_AB >= 0 && E_BC >= 0 && E_CA >= 0"),
     QT_TRANSLATE_NOOP("Mistake", "A point on the edge is in the triangle, is it not?"),
     "square-counted", Proof::CoveredTwice, Change::Rises, at(Sample, Span), [](Rules& r) { r.tie = {0, 0}; }},
    {"all-exclusive", "M2",
     QT_TRANSLATE_NOOP("Mistake", "All edges are exclusive"),
     QT_TRANSLATE_NOOP("Mistake", "Pixels on a shared edge are drawn by neither triangle: a row of holes."),
     QT_TRANSLATE_NOOP("Mistake", "inside = E_AB > 0 && E_BC > 0 && E_CA > 0"),
     QT_TRANSLATE_NOOP("Mistake", "It stops pixels from being drawn twice."),
     "square-diagonal",
     Proof::Holes, Change::Rises, at(Sample, Span), [](Rules& r) { r.tie = {1, 1}; }},
    {"either-sign", "M3",
     QT_TRANSLATE_NOOP("Mistake", "Top-left bias with \"all positive or all negative\""),
     QT_TRANSLATE_NOOP("Mistake", "Counter-clockwise triangles are right, at the shared edges of clockwise ones pixels are drawn twice."),
     QT_TRANSLATE_NOOP("Mistake", "inside = all E + bias >= 0 || all E + bias <= 0"),
     QT_TRANSLATE_NOOP("Mistake", "It makes the test independent of the winding; the bias is not."),
     "two-windings", Proof::CoveredTwice,
     Change::Rises, at(Sample),
     [](Rules& r) {
         r.triangleOriented = false;
         r.insideTest = InsideTest::EitherSign;
     }},
    {"float-bias-one", "M4",
     QT_TRANSLATE_NOOP("Mistake", "A fixed bias of 1 on floating-point edges"),
     QT_TRANSLATE_NOOP("Mistake", "A crack between neighbours, the wider the shorter the edge; small triangles vanish."),
     QT_TRANSLATE_NOOP("Mistake", "float bias = ownsPoints ? 0 : -1"),
     QT_TRANSLATE_NOOP("Mistake", "In integers, 1 is the smallest step. In floats it is a pixel."),
     "torus-knot", Proof::Holes, Change::Rises, at(Sample),
     [](Rules& r) {
         r.numberType = NumberType::Float32;
         r.floatTieUnit = 1;
     }},
    {"corner-sampling", "M5",
     QT_TRANSLATE_NOOP("Mistake", "Sampled at the pixel's corner"),
     QT_TRANSLATE_NOOP("Mistake", "The picture sits half a pixel too far right and down."),
     QT_TRANSLATE_NOOP("Mistake", "E_AB(x, y) in place of E_AB(x + 0.5, y + 0.5)"),
     QT_TRANSLATE_NOOP("Mistake", "The loop variables are right there."),
     "triangle-600", Proof::WrongPixels, Change::Rises, at(Viewport, Sample),
     [](Rules& r) { r.screenShift = 0.5; }},
    {"integer-vertices", "M6",
     QT_TRANSLATE_NOOP("Mistake", "Vertices are cast to int"),
     QT_TRANSLATE_NOOP("Mistake", "Edges jump by whole pixels when something moves, and triangles smaller than a pixel collapse."),
     QT_TRANSLATE_NOOP("Mistake", "Vec2i p = {(int)v.x, (int)v.y}"),
     QT_TRANSLATE_NOOP("Mistake", "Pixels have integer coordinates."),
     "tiny-tiles", Proof::Degenerate,
     Change::Rises, at(Viewport), [](Rules& r) { r.verticesTruncated = true; }},
    {"one-winding", "M8",
     QT_TRANSLATE_NOOP("Mistake", "One winding only, and triangles are not oriented"),
     QT_TRANSLATE_NOOP("Mistake", "Clockwise triangles vanish although nothing is culled."),
     QT_TRANSLATE_NOOP("Mistake", "area is not looked at before the edges are set up"),
     QT_TRANSLATE_NOOP("Mistake", "The first triangle one tries works."),
     "two-windings", Proof::Holes, Change::Rises, at(Setup, Sample), [](Rules& r) { r.triangleOriented = false; }},
    {"weights-rotated", "M9",
     QT_TRANSLATE_NOOP("Mistake", "Barycentric weights rotated by one corner"),
     QT_TRANSLATE_NOOP("Mistake", "All colours move on by one corner."),
     QT_TRANSLATE_NOOP("Mistake", "α = E_AB / area in place of E_BC / area"),
     QT_TRANSLATE_NOOP("Mistake", "The edge is named after its first corner; its value belongs to the corner opposite."),
     "triangle-600",
     Proof::WrongPixels, Change::Rises, at(Shade), [](Rules& r) { r.cornerData = CornerData::Next; }},
    {"weights-exchanged", "M9",
     QT_TRANSLATE_NOOP("Mistake", "Two barycentric weights exchanged"),
     QT_TRANSLATE_NOOP("Mistake", "Two corners have each other's colour."),
     QT_TRANSLATE_NOOP("Mistake", "color = α * A + γ * B + β * C"),
     QT_TRANSLATE_NOOP("Mistake", "B and C were swapped to turn the triangle round, and only they."),
     "triangle-600", Proof::WrongPixels, Change::Rises, at(Shade), [](Rules& r) { r.cornerData = CornerData::Exchanged; }},
    {"position-interpolated", "M10",
     QT_TRANSLATE_NOOP("Mistake", "The interpolated position overwrites the pixel's"),
     QT_TRANSLATE_NOOP("Mistake", "Holes like pepper: 6.9999995 is cut to 6, and its neighbour is drawn twice."),
     QT_TRANSLATE_NOOP("Mistake", "x = (int)(α * A.x + β * B.x + γ * C.x)"),
     QT_TRANSLATE_NOOP("Mistake", "Position is an attribute like all others."),
     "triangle-600",
     Proof::Holes, Change::Rises, at(Fragment), [](Rules& r) { r.positionInterpolated = true; }},
    {"sort-positions-only", "M11",
     QT_TRANSLATE_NOOP("Mistake", "Sorting by y moves positions only"),
     QT_TRANSLATE_NOOP("Mistake", "Colours sit at wrong corners, in some triangles and not in others."),
     QT_TRANSLATE_NOOP("Mistake", "if (b.y < a.y) swap(a.position, b.position)"),
     QT_TRANSLATE_NOOP("Mistake", "The sort was there before the colours were."),
     "triangle-600", Proof::WrongPixels, Change::Rises, at(Shade), [](Rules& r) { r.cornerData = CornerData::Unsorted; }},
    {"height-plus-one", "M12",
     QT_TRANSLATE_NOOP("Mistake", "+1 on the height of an edge"),
     QT_TRANSLATE_NOOP("Mistake", "The short edges end beside the middle corner: a spike stands out there, the longer the flatter the edge."),
     QT_TRANSLATE_NOOP("Mistake", "alpha = (y - a.y) / (b.y - a.y + 1)"),
     QT_TRANSLATE_NOOP("Mistake", "It avoids dividing by zero."),
     "flat-edge",
     Proof::WrongFaces, Change::Rises, at(Halves, Crossing, Span),
     [](Rules& r) {
         r.algorithm = Algorithm::EdgeWalking;
         r.extraEdgeHeight = 1;
     }},
    {"steep-columns", "M13",
     QT_TRANSLATE_NOOP("Mistake", "Steep lines column by column"),
     QT_TRANSLATE_NOOP("Mistake", "A line of 1 x 10 ends at y = 20; of vertical lines, which would divide by zero, only a dot is left."),
     QT_TRANSLATE_NOOP("Mistake", "error += dy / dx; while (error > 0.5) ++y"),
     QT_TRANSLATE_NOOP("Mistake", "It looks like the line algorithm, for flat lines."),
     "lines", Proof::Tested, Change::Rises, at(LineDecision, LineSample), [](Rules& r) { r.lineAdvance = LineAdvance::Columns; }},
    {"steep-step", "M13",
     QT_TRANSLATE_NOOP("Mistake", "Steep lines with one pixel a column"),
     QT_TRANSLATE_NOOP("Mistake", "Steep lines are dots that lie far apart, and jump two columns' way at once: 6, 0, 6, 0 rows for 3, 3, 3, 3."),
     QT_TRANSLATE_NOOP("Mistake", "step = error / dx; y += step; error -= 2 * dx * step"),
     QT_TRANSLATE_NOOP("Mistake", "It was made for filling columns, which needs one y of each edge in a column."),
     "lines", Proof::Covered, Change::Falls, at(LineSample), [](Rules& r) { r.lineAdvance = LineAdvance::OneRow; }},
    {"integer-weight", "M14",
     QT_TRANSLATE_NOOP("Mistake", "The weight along a line divided in integers"),
     QT_TRANSLATE_NOOP("Mistake", "Each line has one colour from its first pixel to the last but one."),
     QT_TRANSLATE_NOOP("Mistake", "float t = i / n, both int"),
     QT_TRANSLATE_NOOP("Mistake", "The result is stored in a float."),
     "lines", Proof::Colors, Change::Falls, at(Fragment),
     [](Rules& r) { r.integerLineWeights = true; }},
    {"missing-octant", "M15",
     QT_TRANSLATE_NOOP("Mistake", "An octant of the line algorithm is missing"),
     QT_TRANSLATE_NOOP("Mistake", "Lines in one direction are not drawn."),
     QT_TRANSLATE_NOOP("Mistake", "if (dy > dx && dx > 0 && dy > 0) is never written"),
     QT_TRANSLATE_NOOP("Mistake", "Seven cases work."),
     "lines", Proof::Covered, Change::Falls, at(LineSample), [](Rules& r) { r.lineOctants = 0xff & ~0x2U; }},
    {"missing-last-pixel", "M15",
     QT_TRANSLATE_NOOP("Mistake", "The last pixel of a line is missing"),
     QT_TRANSLATE_NOOP("Mistake", "Lines stop one pixel short: the corners on the right of triangles are open."),
     QT_TRANSLATE_NOOP("Mistake", "if (x1 < x0) swap; for (x = x0; x < x1; ++x)"),
     QT_TRANSLATE_NOOP("Mistake", "Loops end before the end."),
     "lines", Proof::Covered, Change::Falls, at(LineSample),
     [](Rules& r) { r.rightLineEnds = false; }},
    {"affine", "M16",
     QT_TRANSLATE_NOOP("Mistake", "Attributes are linear on the screen"),
     QT_TRANSLATE_NOOP("Mistake", "Tiles and lines break at the diagonal of the square and swim when the camera moves."),
     QT_TRANSLATE_NOOP("Mistake", "uv = α * A.uv + β * B.uv + γ * C.uv"),
     QT_TRANSLATE_NOOP("Mistake", "Right for z, and right without perspective."),
     "tile-square",
     Proof::WrongPixels, Change::Rises, at(Fragment, Shade), [](Rules& r) { r.perspectiveCorrect = false; }},
    {"w-lost", "M17",
     QT_TRANSLATE_NOOP("Mistake", "w is lost before interpolation"),
     QT_TRANSLATE_NOOP("Mistake", "Perspective correction is on and changes nothing: the picture is the affine one."),
     QT_TRANSLATE_NOOP("Mistake", "v = v / v.w, and v.w is 1 from then on"),
     QT_TRANSLATE_NOOP("Mistake", "After the divide nobody needs w any more."),
     "tile-square",
     Proof::WrongPixels, Change::Rises, at(Viewport), [](Rules& r) { r.keptW = KeptW::One; }},
    {"w-not-inverted", "M18",
     QT_TRANSLATE_NOOP("Mistake", "Weights of the correction exchanged: t Z2 for t Z1"),
     QT_TRANSLATE_NOOP("Mistake", "The picture bends the other way: worse than without correction."),
     QT_TRANSLATE_NOOP("Mistake", "n = m * Z2 / ((1 - m) * Z1 + m * Z2)"),
     QT_TRANSLATE_NOOP("Mistake", "The formula is symmetric enough to be remembered wrong."),
     "tile-square", Proof::WrongPixels, Change::Rises, at(Fragment, Shade), [](Rules& r) { r.keptW = KeptW::Itself; }},
    {"w-before-clipping", "M19",
     QT_TRANSLATE_NOOP("Mistake", "w of the unclipped triangle used after clipping"),
     QT_TRANSLATE_NOOP("Mistake", "Textures are torn in triangles that are cut, and right in all others."),
     QT_TRANSLATE_NOOP("Mistake", "the pieces keep the w of corner 0, 1, 2 of the face"),
     QT_TRANSLATE_NOOP("Mistake", "w was stored per face, before there was a clipper."),
     "floor", Proof::WrongPixels, Change::Rises, at(Fragment, Shade), [](Rules& r) { r.clipUpdatesW = false; }},
    {"z-corrected", "M20",
     QT_TRANSLATE_NOOP("Mistake", "z/w gets the perspective correction of attributes"),
     QT_TRANSLATE_NOOP("Mistake", "Depth between the corners is too near: things cut through each other at wrong places."),
     QT_TRANSLATE_NOOP("Mistake", "z = interpolate(A.z / A.w, ...) with perspective weights"),
     QT_TRANSLATE_NOOP("Mistake", "z is an attribute like all others. But z/w is linear on the screen already."),
     "four-z", Proof::DepthError,
     Change::Rises, at(Fragment), [](Rules& r) { r.depthLinear = false; }},
    {"view-z-linear", "M20",
     QT_TRANSLATE_NOOP("Mistake", "The distance is interpolated linearly on the screen"),
     QT_TRANSLATE_NOOP("Mistake", "Depth between the corners is too far: what lies behind shows through the middle of steep faces."),
     QT_TRANSLATE_NOOP("Mistake", "z = α * A.z + β * B.z + γ * C.z with z of view space"),
     QT_TRANSLATE_NOOP("Mistake", "The distance is what depth means. But only 1/z is linear on the screen."),
     "four-z", Proof::WrongFaces,
     Change::Rises, at(Fragment, Viewport), [](Rules& r) { r.depthIsDistance = true; }},
    {"no-near-clip", "M21",
     QT_TRANSLATE_NOOP("Mistake", "No clipping at the near plane"),
     QT_TRANSLATE_NOOP("Mistake", "What is behind the camera comes back mirrored, upside down."),
     QT_TRANSLATE_NOOP("Mistake", "x / w, whatever the sign of w"),
     QT_TRANSLATE_NOOP("Mistake", "The divide works without complaint."),
     "behind-camera", Proof::WrongFaces, Change::Rises, at(Viewport),
     [](Rules& r) { r.clipping = Clipping::None; }},
    {"any-vertex-inside", "M22",
     QT_TRANSLATE_NOOP("Mistake", "A face is kept if any vertex is inside"),
     QT_TRANSLATE_NOOP("Mistake", "A triangle that covers the whole screen vanishes, as all its corners are outside."),
     QT_TRANSLATE_NOOP("Mistake", "if (!inside(a) && !inside(b) && !inside(c)) reject"),
     QT_TRANSLATE_NOOP("Mistake", "What is visible has a corner that is visible."),
     "covering", Proof::Rejected, Change::Rises, at(ClipPlane), [](Rules& r) { r.clipping = Clipping::AnyVertexInside; }},
    {"near-far-reject", "M23",
     QT_TRANSLATE_NOOP("Mistake", "Whole faces are dropped at near and far"),
     QT_TRANSLATE_NOOP("Mistake", "Large triangles vanish as soon as one corner passes the camera."),
     QT_TRANSLATE_NOOP("Mistake", "if (any w < near) reject"),
     QT_TRANSLATE_NOOP("Mistake", "It avoids the division by zero, and cutting."),
     "tunnel", Proof::Holes, Change::Rises, at(ClipPlane),
     [](Rules& r) { r.clipping = Clipping::NearFarReject; }},
    {"cut-corners", "M24",
     QT_TRANSLATE_NOOP("Mistake", "Only edges are clipped"),
     QT_TRANSLATE_NOOP("Mistake", "Where the triangle covers a corner of the screen, the corner is cut off."),
     QT_TRANSLATE_NOOP("Mistake", "polygon = what Cohen-Sutherland leaves of the edges"),
     QT_TRANSLATE_NOOP("Mistake", "A triangle is its three edges."),
     "behind-camera",
     Proof::Holes, Change::Rises, at(CohenSutherland),
     [](Rules& r) {
         r.clipping = Clipping::CohenSutherland;
         r.clipKeepsCorners = false;
     }},
    {"return-for-continue", "M25",
     QT_TRANSLATE_NOOP("Mistake", "return in place of continue"),
     QT_TRANSLATE_NOOP("Mistake", "Everything after the first rejected face is missing."),
     QT_TRANSLATE_NOOP("Mistake", "if (outside) return;"),
     QT_TRANSLATE_NOOP("Mistake", "The body of the loop was a function once."),
     "floor", Proof::Holes, Change::Rises, at(ClipPlane, End),
     [](Rules& r) { r.continuesAfterReject = false; }},
    {"nudged-cut", "M26",
     QT_TRANSLATE_NOOP("Mistake", "Cut vertices are nudged inward by 0.001 pixels"),
     QT_TRANSLATE_NOOP("Mistake", "A cut edge tilts by a hair: pixels whose centres lie exactly on it are lost, a row of holes to the "
          "neighbour that is not cut."),
     QT_TRANSLATE_NOOP("Mistake", "v1.x += 0.001f"),
     QT_TRANSLATE_NOOP("Mistake", "So that the vertex lies inside for certain, and its code is 0."),
     "cut-on-centres", Proof::Holes, Change::Rises, at(CohenSutherland),
     [](Rules& r) {
         r.clipping = Clipping::CohenSutherland;
         r.numberType = NumberType::Float64; // 1/256 of a pixel is coarser than what is added
         r.clipInset = 0.001;
     }},
    {"cull-reversed", "M27",
     QT_TRANSLATE_NOOP("Mistake", "Culling with the wrong sign"),
     QT_TRANSLATE_NOOP("Mistake", "One looks into closed bodies: only the insides of their backs are drawn."),
     QT_TRANSLATE_NOOP("Mistake", "if (area > 0) cull"),
     QT_TRANSLATE_NOOP("Mistake", "y runs down on the screen, so the sign flips."),
     "letter-f", Proof::WrongFaces, Change::Rises, at(Facing),
     [](Rules& r) { r.frontSign = -r.frontSign; }},
    {"cull-by-light", "M27",
     QT_TRANSLATE_NOOP("Mistake", "Culled by the direction of the light"),
     QT_TRANSLATE_NOOP("Mistake", "What faces the camera but not the light is missing."),
     QT_TRANSLATE_NOOP("Mistake", "if (dot(normal, light) < 0) cull"),
     QT_TRANSLATE_NOOP("Mistake", "In the first example light and gaze are one direction."),
     "torus-knot", Proof::Holes, Change::Rises, at(Facing),
     [](Rules& r) {
         r.culling = Culling::Back;
         r.facing = Facing::LightNormal;
     }},
    {"cull-before-divide", "M27",
     QT_TRANSLATE_NOOP("Mistake", "Culled by the area before the divide"),
     QT_TRANSLATE_NOOP("Mistake", "Faces seen at a grazing angle vanish or show their back."),
     QT_TRANSLATE_NOOP("Mistake", "area of clip.x, clip.y, without / w"),
     QT_TRANSLATE_NOOP("Mistake", "The sign does not need the divide, if all w are alike."),
     "tunnel", Proof::Holes, Change::Rises, at(Facing),
     [](Rules& r) { r.facing = Facing::AreaWithoutDivide; }},
    {"cull-before-clip", "M27",
     QT_TRANSLATE_NOOP("Mistake", "Culled by the divided area before clipping"),
     QT_TRANSLATE_NOOP("Mistake", "Faces that reach behind the camera vanish: there the divide turns them round."),
     QT_TRANSLATE_NOOP("Mistake", "area of x / w, y / w of the unclipped face"),
     QT_TRANSLATE_NOOP("Mistake", "It saves clipping what is culled anyway."),
     "tunnel",
     Proof::Holes, Change::Rises, at(Facing), [](Rules& r) { r.facing = Facing::AreaWithoutClipping; }},
    {"no-z-buffer", "M28",
     QT_TRANSLATE_NOOP("Mistake", "No z-buffer"),
     QT_TRANSLATE_NOOP("Mistake", "What is sent last is in front: the mouth shows through the lips."),
     QT_TRANSLATE_NOOP("Mistake", "image.set(x, y, color) without a test"),
     QT_TRANSLATE_NOOP("Mistake", "Culling alone is enough for convex bodies."),
     "head",
     Proof::WrongFaces, Change::Rises, at(Fragment), [](Rules& r) { r.depthTested = false; }},
    {"depth-cleared-to-zero", "M29",
     QT_TRANSLATE_NOOP("Mistake", "z-buffer cleared to 0"),
     QT_TRANSLATE_NOOP("Mistake", "Nothing is drawn."),
     QT_TRANSLATE_NOOP("Mistake", "fill(zbuffer, 0) where smaller is nearer"),
     QT_TRANSLATE_NOOP("Mistake", "Memory is cleared to 0."),
     "games101", Proof::DepthPassed,
     Change::Falls, at(Fragment), [](Rules& r) { r.depthClear = 0; }},
    {"depth-cleared-to-min", "M29",
     QT_TRANSLATE_NOOP("Mistake", "z-buffer cleared to numeric_limits<float>::min()"),
     QT_TRANSLATE_NOOP("Mistake", "Nothing is drawn: min() is the smallest number above 0, not the lowest of all."),
     QT_TRANSLATE_NOOP("Mistake", "fill(zbuffer, numeric_limits<float>::min())"),
     QT_TRANSLATE_NOOP("Mistake", "For int, min() is the lowest number."),
     "games101",
     Proof::DepthPassed, Change::Falls, at(Fragment), [](Rules& r) { r.depthClear = std::numeric_limits<float>::min(); }},
    {"depth-reversed", "M30",
     QT_TRANSLATE_NOOP("Mistake", "The depth comparison is reversed"),
     QT_TRANSLATE_NOOP("Mistake", "What is farthest is in front."),
     QT_TRANSLATE_NOOP("Mistake", "if (z > zbuffer[i])"),
     QT_TRANSLATE_NOOP("Mistake", "Other texts have z growing towards the viewer."),
     "games101", Proof::WrongFaces, Change::Rises, at(Fragment),
     [](Rules& r) {
         r.depthCompare = DepthCompare::Greater;
         r.depthClear = 0;
     }},
    {"depth-written-on-fail", "M30",
     QT_TRANSLATE_NOOP("Mistake", "Depth is written even if the test fails"),
     QT_TRANSLATE_NOOP("Mistake", "A third surface shows through the nearest one where a second one lies between."),
     QT_TRANSLATE_NOOP("Mistake", "zbuffer[i] = z stands below the if, not in it"),
     QT_TRANSLATE_NOOP("Mistake", "A pair of braces."),
     "three-layers", Proof::WrongFaces,
     Change::Rises, at(Fragment), [](Rules& r) { r.depthWrittenOnFail = true; }},
    {"few-depth-bits", "M31",
     QT_TRANSLATE_NOOP("Mistake", "Few depth bits and a near plane close to the eye"),
     QT_TRANSLATE_NOOP("Mistake", "Surfaces close to each other flicker in stripes."),
     QT_TRANSLATE_NOOP("Mistake", "16-bit depth, near = 0.5, far = 1000"),
     QT_TRANSLATE_NOOP("Mistake", "The nearer the near plane, the less is lost, one thinks; it takes most of the depth values."),
     "thin-gap",
     Proof::WrongFaces, Change::Rises, at(Fragment), [](Rules& r) { r.depthFormat = DepthFormat::Unorm16; }},
    {"coverage-times-color", "M32",
     QT_TRANSLATE_NOOP("Mistake", "Coverage times colour in place of stored samples"),
     QT_TRANSLATE_NOOP("Mistake", "Dark lines along edges, also where two triangles of one colour meet."),
     QT_TRANSLATE_NOOP("Mistake", "pixel = color * inside / 4"),
     QT_TRANSLATE_NOOP("Mistake", "Four samples inside: the full colour; two: half of it."),
     "samples",
     Proof::MissingLight, Change::Rises, at(Resolve, End), [](Rules& r) { r.resolve = Resolve::LastFace; }},
    {"one-depth-per-pixel", "M33",
     QT_TRANSLATE_NOOP("Mistake", "One depth for all samples of a pixel"),
     QT_TRANSLATE_NOOP("Mistake", "A fringe of background round what was drawn first: what lies behind fails its test there."),
     QT_TRANSLATE_NOOP("Mistake", "zbuffer[pixel] in place of zbuffer[sample]"),
     QT_TRANSLATE_NOOP("Mistake", "One value a pixel was enough before."),
     "samples",
     Proof::DepthFailed, Change::Rises, at(Fragment), [](Rules& r) { r.depthPerPixel = true; }},
    {"truncated-samples", "M34",
     QT_TRANSLATE_NOOP("Mistake", "inside(int, int) truncates the samples"),
     QT_TRANSLATE_NOOP("Mistake", "Edges are as jagged as with one sample, at four times the cost."),
     QT_TRANSLATE_NOOP("Mistake", "bool inside(int x, int y) called with x + 0.25"),
     QT_TRANSLATE_NOOP("Mistake", "The compiler converts in silence."),
     "samples",
     Proof::Colors, Change::Falls, at(Sample), [](Rules& r) { r.samplesTruncated = true; }},
    {"centre-outside", "M81",
     QT_TRANSLATE_NOOP("Mistake", "MSAA: attributes at a centre that the face does not cover"),
     QT_TRANSLATE_NOOP("Mistake", "Dots in a foreign colour along the edges: texels from beyond the face's part of the texture."),
     QT_TRANSLATE_NOOP("Mistake", "in vec2 uv; without centroid"),
     QT_TRANSLATE_NOOP("Mistake", "With one sample a pixel the centre of what is drawn is always covered."),
     "msaa-sprite", Proof::WrongPixels, Change::Rises, at(Shade),
     [](Rules& r) { r.attributeAt = AttributeAt::Centre; }},
    {"centroid-gradient", "M82",
     QT_TRANSLATE_NOOP("Mistake", "MSAA: derivatives of what is taken at centroids"),
     QT_TRANSLATE_NOOP("Mistake", "Along the edges of faces the texture is blurred or too sharp: the level of detail jumps."),
     QT_TRANSLATE_NOOP("Mistake", "centroid in vec2 uv; .. dFdx(uv) as if all were a pixel apart"),
     QT_TRANSLATE_NOOP("Mistake", "The difference to the neighbour is the derivative, is it not?"),
     "msaa-gradient", Proof::WrongPixels, Change::Rises, at(Shade),
     [](Rules& r) { r.gradientByNeighbours = true; }},
    {"resolved-by-face", "M83",
     QT_TRANSLATE_NOOP("Mistake", "MSAA: resolved while the frame is drawn"),
     QT_TRANSLATE_NOOP("Mistake", "The background shines through every edge that two faces share."),
     QT_TRANSLATE_NOOP("Mistake", "resolve() in the loop over the faces, not after it"),
     QT_TRANSLATE_NOOP("Mistake", "The picture has one colour a pixel, so a pixel is made as soon as there is one."),
     "msaa-seams", Proof::MissingLight, Change::Rises, at(Write),
     [](Rules& r) { r.resolvedByFace = true; }},
    {"stride-exchanged", "M35",
     QT_TRANSLATE_NOOP("Mistake", "Rows of samples at the wrong stride"),
     QT_TRANSLATE_NOOP("Mistake", "The picture is sheared into stripes; in a square window it is right."),
     QT_TRANSLATE_NOOP("Mistake", "samples[y * height + x]"),
     QT_TRANSLATE_NOOP("Mistake", "Tried in a square window."),
     "samples", Proof::WrongPixels, Change::Rises, at(Write),
     [](Rules& r) { r.strideIsRows = true; }},
    {"box-not-clamped", "M36",
     QT_TRANSLATE_NOOP("Mistake", "The bounding box is not clamped to the window"),
     QT_TRANSLATE_NOOP("Mistake", "What hangs over the right border comes in at the left, a row lower; elsewhere memory is overwritten."),
     QT_TRANSLATE_NOOP("Mistake", "for (x = floor(minX); x <= ceil(maxX); ++x)"),
     QT_TRANSLATE_NOOP("Mistake", "Everything was on the screen so far."),
     "overhang",
     Proof::Strays, Change::Rises, at(Setup), [](Rules& r) { r.bounds = Bounds::Unclamped; }},
    {"box-one-short", "M36",
     QT_TRANSLATE_NOOP("Mistake", "The bounding box is off by one"),
     QT_TRANSLATE_NOOP("Mistake", "The last column and the last row of each triangle are missing."),
     QT_TRANSLATE_NOOP("Mistake", "for (x = minX; x < maxX; ++x)"),
     QT_TRANSLATE_NOOP("Mistake", "Loops end before the end."),
     "square-diagonal", Proof::Holes, Change::Rises, at(Setup),
     [](Rules& r) { r.bounds = Bounds::OneShort; }},
    {"int32-overflow", "M37",
     QT_TRANSLATE_NOOP("Mistake", "Edge values in 32 bits"),
     QT_TRANSLATE_NOOP("Mistake", "Above 46,341 pixels, whose square needs more than 31 bits, values wrap round: triangles have holes with "
          "straight edges."),
     QT_TRANSLATE_NOOP("Mistake", "int E_AB = (x - A.x) * (B.y - A.y) - ..."),
     QT_TRANSLATE_NOOP("Mistake", "No screen is that large. Unclipped triangles are."),
     "huge-triangle", Proof::Holes, Change::Rises, at(Sample), [](Rules& r) { r.insideTest = InsideTest::Wrapped32; }},
    {"zero-area-kept", "M38",
     QT_TRANSLATE_NOOP("Mistake", "Triangles without area are not rejected"),
     QT_TRANSLATE_NOOP("Mistake", "Black lines: the weights are 0/0, which no comparison holds back."),
     QT_TRANSLATE_NOOP("Mistake", "α = E_BC / area, without a look at area"),
     QT_TRANSLATE_NOOP("Mistake", "Who would send such triangles?"),
     "zero-area",
     Proof::Rasterized, Change::Rises, at(Facing),
     [](Rules& r) {
         r.rejectsZeroArea = false;
         r.tie = {0, 0};
     }},
    {"small-area-dropped", "M38",
     QT_TRANSLATE_NOOP("Mistake", "Triangles of less than half a pixel are dropped"),
     QT_TRANSLATE_NOOP("Mistake", "Meshes finer than the pixels have holes or vanish."),
     QT_TRANSLATE_NOOP("Mistake", "if (abs(area2) < 1) return"),
     QT_TRANSLATE_NOOP("Mistake", "It avoids dividing by almost zero."),
     "tiny-tiles", Proof::Degenerate, Change::Rises, at(Facing),
     [](Rules& r) { r.smallestArea2 = 1; }},
    {"float-drift", "M39",
     QT_TRANSLATE_NOOP("Mistake", "Edge values added up in float32"),
     QT_TRANSLATE_NOOP("Mistake", "Rounding piles up along a long row: holes and double hits at shared edges."),
     QT_TRANSLATE_NOOP("Mistake", "float E_AB; E_AB += dx"),
     QT_TRANSLATE_NOOP("Mistake", "One addition is cheaper than a product."),
     "long-sliver", Proof::WrongFaces, Change::Rises, at(Sample),
     [](Rules& r) {
         r.numberType = NumberType::Float32;
         r.stepping = Stepping::Incremental;
     }},
    {"y-flipped-once", "M40",
     QT_TRANSLATE_NOOP("Mistake", "y is flipped in one stage only"),
     QT_TRANSLATE_NOOP("Mistake", "The picture stands on its head, and one sees the backs: the windings are flipped with it."),
     QT_TRANSLATE_NOOP("Mistake", "ys = (0.5 + y / w * 0.5) * height"),
     QT_TRANSLATE_NOOP("Mistake", "One of two flips was taken out."),
     "letter-f",
     Proof::WrongPixels, Change::Rises, at(Viewport), [](Rules& r) { r.screenUp = 1; }},
};

/// The rows of all tables, one after the other.
const std::vector<MistakeRow>& rows()
{
    static const std::vector<MistakeRow> all = [] {
        std::vector<MistakeRow> joined;
        for (const std::span<const MistakeRow> table :
             {std::span<const MistakeRow>(kRows), cameraMistakes(), coverageMistakes(), textureMistakes()})
            joined.insert(joined.end(), table.begin(), table.end());
        return joined;
    }();
    return all;
}

} // namespace

std::span<const Mistake> mistakes()
{
    static const std::vector<Mistake> all = [] {
        std::vector<Mistake> made;
        for (const MistakeRow& r : rows())
            made.push_back(
                {r.id, r.number, r.title, r.symptom, r.wrongLine, r.seed, r.scene, r.proof, r.change, r.apply});
        return made;
    }();
    return all;
}

StepKinds stepsOf(const Mistake& mistake)
{
    return rows()[static_cast<std::size_t>(&mistake - mistakes().data())].steps;
}

const Mistake* findMistake(const QString& id)
{
    const auto found =
        std::ranges::find_if(mistakes(), [&](const Mistake& mistake) { return id == QLatin1String(mistake.id); });
    return found == mistakes().end() ? nullptr : &*found;
}

} // namespace rasterlens
