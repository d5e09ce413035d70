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
    {"third-weight-independent", "D8", QT_TRANSLATE_NOOP("Mistake", "Three weights, each rounded by itself"),
     QT_TRANSLATE_NOOP("Mistake", "Faces one close behind the other show through in specks: the sum of the weights is "
                                  "not 1, and depth is off by what is missing."),
     QT_TRANSLATE_NOOP("Mistake", "gamma = round(areaC / area, 8 bits) in place of 1 - alpha - beta"),
     QT_TRANSLATE_NOOP("Mistake", "All three corners are treated alike."), "thin-gap", Proof::WrongFaces, Change::Rises,
     at(Fragment), [](Rules& r) { r.weightUnit = 1.0 / 256; }},
    {"v-flipped", "T1", QT_TRANSLATE_NOOP("Mistake", "v runs the other way"),
     QT_TRANSLATE_NOOP("Mistake", "The texture stands on its head."),
     QT_TRANSLATE_NOOP("Mistake", "row = (1 - v) * height"),
     QT_TRANSLATE_NOOP("Mistake", "Files begin with their upper row; here row 0 is the lower one already."),
     "picture-card", Proof::WrongPixels, Change::Rises, at(Vertex), [](Rules& r) { r.texels.vUp = false; }},
    {"xy-for-uv", "T2", QT_TRANSLATE_NOOP("Mistake", "The place on the screen is used for u and v"),
     QT_TRANSLATE_NOOP("Mistake",
                       "The texture sticks to the screen: the body is a window behind which it stands still."),
     QT_TRANSLATE_NOOP("Mistake", "color = texture(x / width, y / height)"),
     QT_TRANSLATE_NOOP("Mistake", "x and y are the names at hand in the loop."), "picture-card", Proof::WrongPixels,
     Change::Rises, at(Shade), [](Rules& r) { r.texels.uv = UvSource::Screen; }},
    {"no-half-texel", "T3", QT_TRANSLATE_NOOP("Mistake", "Bilinear filter without the half texel"),
     QT_TRANSLATE_NOOP("Mistake", "The texture drifts by half a texel to the right and up; borders are thick on one "
                                  "side and thin on the other."),
     QT_TRANSLATE_NOOP("Mistake", "i = floor(u * W); f = fract(u * W)"),
     QT_TRANSLATE_NOOP("Mistake", "Texel i lies at i, does it not? Its centre lies at i + 0.5."), "picture-card",
     Proof::WrongPixels, Change::Rises, at(Shade), [](Rules& r) { r.texels.centre = 0; }},
    {"lod-per-face", "T5", QT_TRANSLATE_NOOP("Mistake", "One mip level for a whole face"),
     QT_TRANSLATE_NOOP(
         "Mistake",
         "Sharpness jumps from face to face; in large faces the near part is blurred and the far part flickers."),
     QT_TRANSLATE_NOOP("Mistake", "level = log2(sqrt(texelArea(face) / screenArea(face))), once a face"),
     QT_TRANSLATE_NOOP("Mistake", "Is the level not constant in a triangle?"), "disc-floor", Proof::WrongPixels,
     Change::Rises, at(Shade), [](Rules& r) { r.texels.level = LevelSource::Face; }},
    {"wrap-before-derivative", "T6", QT_TRANSLATE_NOOP("Mistake", "Derivatives of wrapped coordinates"),
     QT_TRANSLATE_NOOP("Mistake", "At every repeat of the texture runs a line of one colour: the smallest level."),
     QT_TRANSLATE_NOOP("Mistake", "u = fract(u); level = log2(length(ddx(u)) * W)"),
     QT_TRANSLATE_NOOP("Mistake", "Wrapping belongs to the look-up, and the level too."), "disc-floor",
     Proof::WrongPixels, Change::Rises, at(Shade), [](Rules& r) { r.texels.level = LevelSource::WrappedSample; }},
    {"lod-doubled", "T7", QT_TRANSLATE_NOOP("Mistake", "Level from areas as if from lengths"),
     QT_TRANSLATE_NOOP("Mistake", "The texture is blurred far too near, twice as many levels as there should be."),
     QT_TRANSLATE_NOOP("Mistake", "level = log2(max(dot(dx, dx), dot(dy, dy))), without the 0.5"),
     QT_TRANSLATE_NOOP("Mistake", "The squares are at hand, and the root is dear."), "disc-floor", Proof::WrongPixels,
     Change::Rises, at(Shade), [](Rules& r) { r.texels.levelsPerDoubling = 2; }},
    {"negative-uv", "T8", QT_TRANSLATE_NOOP("Mistake", "Negative coordinates are cut off towards 0"),
     QT_TRANSLATE_NOOP(
         "Mistake", "The texels left and right of 0 fall together: one is twice as wide, and all beyond it are moved."),
     QT_TRANSLATE_NOOP("Mistake", "i = (int)(u * W) mod W"),
     QT_TRANSLATE_NOOP("Mistake", "(int) rounds down where u is positive."), "texels-about-zero", Proof::WrongPixels,
     Change::Rises, at(Shade), [](Rules& r) { r.texels.floored = false; }},
    {"no-clamp", "T9", QT_TRANSLATE_NOOP("Mistake", "Light is not clamped before it becomes a byte"),
     QT_TRANSLATE_NOOP("Mistake", "In the highlights colours begin again at black: rings of wrong colours."),
     QT_TRANSLATE_NOOP("Mistake", "unsigned char c = 255 * color"),
     QT_TRANSLATE_NOOP("Mistake", "Nothing was brighter than white so far."), "coarse-ball", Proof::WrongPixels,
     Change::Rises, at(Shade), [](Rules& r) { r.colorsClamped = false; }},
    {"not-normalized", "T9", QT_TRANSLATE_NOOP("Mistake", "Interpolated normals are not normalized"),
     QT_TRANSLATE_NOOP("Mistake", "Highlights sit at the corners of faces and fade between them."),
     QT_TRANSLATE_NOOP("Mistake", "n = alpha * A.n + beta * B.n + gamma * C.n, and no normalize(n)"),
     QT_TRANSLATE_NOOP("Mistake", "The normals of the corners have length 1."), "coarse-ball", Proof::WrongPixels,
     Change::Rises, at(Shade), [](Rules& r) { r.normals.normalized = false; }},
};

} // namespace

std::span<const MistakeRow> textureMistakes() { return kRows; }

} // namespace rasterlens
