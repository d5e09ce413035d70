#include "core/settings/mistake_row.h"
#include "core/settings/mistakes.h"

namespace rasterlens
{
namespace
{

using enum StepKind;

// id, number of the list in docs/MISTAKES.md, title; what one sees; the wrong line; why people write it; scene, proof;
// the steps it shows at; the rule it gets wrong.
constexpr MistakeRow kRows[] = {
    {"order-reversed", "V1", QT_TRANSLATE_NOOP("Mistake", "Matrices multiplied in reverse order"),
     QT_TRANSLATE_NOOP("Mistake", "What should stand in the middle of the picture lies beside it, and moves round the "
                                  "camera where it should turn."),
     QT_TRANSLATE_NOOP("Mistake", "view = translate(-eye) * rotation in place of rotation * translate(-eye)"),
     QT_TRANSLATE_NOOP("Mistake", "Read from left to right, the camera is moved and then turned."), "signpost",
     Proof::WrongPixels, Change::Rises, at(Vertex), [](Rules& r) { r.camera.order = ViewOrder::RotatedFirst; }},
    {"rotation-inverted", "V2", QT_TRANSLATE_NOOP("Mistake", "The camera turns the other way"),
     QT_TRANSLATE_NOOP(
         "Mistake",
         "Turning to the right shows what lies on the left: what was looked at leaves the picture on one side."),
     QT_TRANSLATE_NOOP("Mistake", "view = mat3(right, up, back) in place of its transpose"),
     QT_TRANSLATE_NOOP("Mistake",
                       "The axes of the camera are written as the columns of a matrix, as those of any body are."),
     "signpost", Proof::WrongPixels, Change::Rises, at(Vertex), [](Rules& r) { r.camera.axesAreRows = false; }},
    {"translate-by-target", "V3", QT_TRANSLATE_NOOP("Mistake", "The view is moved by the target, not by the eye"),
     QT_TRANSLATE_NOOP(
         "Mistake",
         "The camera stands where it should look at: inside of the letter, with the back of the scene before it."),
     QT_TRANSLATE_NOOP("Mistake", "view = rotation * translate(-target)"),
     QT_TRANSLATE_NOOP("Mistake", "lookAt has two points, and both are at hand."), "signpost", Proof::WrongPixels,
     Change::Rises, at(Vertex), [](Rules& r) { r.camera.origin = ViewOrigin::Target; }},
    {"near-negative", "V4", QT_TRANSLATE_NOOP("Mistake", "Near plane with its sign"),
     QT_TRANSLATE_NOOP("Mistake", "The picture is turned by 180 degrees: upside down and left for right."),
     QT_TRANSLATE_NOOP("Mistake", "near = -zNear; projection[0][0] = near / right; projection[1][1] = near / top"),
     QT_TRANSLATE_NOOP("Mistake", "One looks along -z, so the near plane lies at -near."), "signpost",
     Proof::WrongPixels, Change::Rises, at(Vertex), [](Rules& r) { r.camera.nearSign = -1; }},
    {"viewport-one-short", "V5", QT_TRANSLATE_NOOP("Mistake", "The viewport is one pixel too small"),
     QT_TRANSLATE_NOOP("Mistake", "The last column and the last row stay empty, and everything is a little too small."),
     QT_TRANSLATE_NOOP("Mistake", "xs = (x / w * 0.5 + 0.5) * (width - 1)"),
     QT_TRANSLATE_NOOP("Mistake", "Columns are numbered from 0 to width - 1."), "square-diagonal", Proof::Holes,
     Change::Rises, at(Viewport), [](Rules& r) { r.viewportShort = 1; }},
    {"normal-by-position-matrix", "V7", QT_TRANSLATE_NOOP("Mistake", "Normals go through the matrix of positions"),
     QT_TRANSLATE_NOOP("Mistake", "The flattened ball is lit like an upright pillar: bright in front, black behind, "
                                  "and its top catches no light from above."),
     QT_TRANSLATE_NOOP("Mistake", "n = mat3(M) * n in place of transpose(inverse(mat3(M))) * n"),
     QT_TRANSLATE_NOOP("Mistake", "A normal is a vector, and vectors are multiplied by the matrix."), "squashed-ball",
     Proof::WrongPixels, Change::Rises, at(Vertex), [](Rules& r) { r.normals.squashed = true; }},
    {"directions-translated", "V8", QT_TRANSLATE_NOOP("Mistake", "Directions are moved like points"),
     QT_TRANSLATE_NOOP("Mistake",
                       "All normals point away from the eye: the body lies in the dark, whichever way its sides look."),
     QT_TRANSLATE_NOOP("Mistake", "n = view * vec4(n, 1) in place of view * vec4(n, 0)"),
     QT_TRANSLATE_NOOP("Mistake", "Every vec4 ends in 1."), "letter-f", Proof::WrongPixels, Change::Rises, at(Vertex),
     [](Rules& r) { r.normals.moved = true; }},
    {"reject-after-divide", "K3", QT_TRANSLATE_NOOP("Mistake", "Faces are rejected by their box after the divide"),
     QT_TRANSLATE_NOOP("Mistake", "A large plane that runs past the camera is gone, though most of it is in sight."),
     QT_TRANSLATE_NOOP("Mistake", "if (min(x / w) > 1 || max(x / w) < -1) reject"),
     QT_TRANSLATE_NOOP("Mistake", "The box on the screen is what one wants to know about."), "road", Proof::Rejected,
     Change::Rises, at(ClipPlane), [](Rules& r) { r.rejectBy = RejectBy::DividedBox; }},
    {"cut-keeps-attributes", "K4",
     QT_TRANSLATE_NOOP("Mistake", "Cut corners keep the attributes of the corner outside"),
     QT_TRANSLATE_NOOP("Mistake", "Texture and colours are torn in faces that are cut, and right in all others."),
     QT_TRANSLATE_NOOP("Mistake", "cut = {lerp(a.position, b.position, t), b.uv, b.normal, b.color}"),
     QT_TRANSLATE_NOOP("Mistake", "The clipper was written for positions."), "floor", Proof::WrongPixels, Change::Rises,
     at(ClipPlane), [](Rules& r) { r.clipInterpolates = false; }},
    {"cut-in-place", "K5", QT_TRANSLATE_NOOP("Mistake", "The polygon is cut in place"),
     QT_TRANSLATE_NOOP(
         "Mistake",
         "Where one corner of a face lies behind the camera, a half of what should be left of it is missing."),
     QT_TRANSLATE_NOOP("Mistake", "v[0] = cut(v[0], v[1]); v[3] = cut(v[0], v[2])"),
     QT_TRANSLATE_NOOP("Mistake",
                       "The corner outside is not needed any more, one thinks: but its other edge is still to be cut."),
     "behind-camera", Proof::Holes, Change::Rises, at(ClipPlane), [](Rules& r) { r.cutStore = CutStore::InPlace; }},
    {"cut-left-at-origin", "K7", QT_TRANSLATE_NOOP("Mistake", "A cut corner is never written"),
     QT_TRANSLATE_NOOP("Mistake", "Spikes run from faces that are cut to the upper left corner of the screen."),
     QT_TRANSLATE_NOOP("Mistake", "polygon.resize(n + 2); polygon[n] = cut(a, b)"),
     QT_TRANSLATE_NOOP("Mistake", "Two corners are made, and one is forgotten."), "behind-camera", Proof::WrongPixels,
     Change::Rises, at(Viewport), [](Rules& r) { r.cutStore = CutStore::LastUnwritten; }},
};

} // namespace

std::span<const MistakeRow> cameraMistakes() { return kRows; }

} // namespace rasterlens
