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
    {"no-prestep", "C7", QT_TRANSLATE_NOOP("Mistake", "Edges start at their corner, not at the first row"),
     QT_TRANSLATE_NOOP("Mistake",
                       "Edges are moved by up to what they go in one row, flat ones by many columns: triangles are too "
                       "thin or lopsided, neighbours leave cracks, and all wobbles when it moves."),
     QT_TRANSLATE_NOOP("Mistake", "x = a.x; for (y = ceil(a.y - 0.5); ...; ++y) x += slope"),
     QT_TRANSLATE_NOOP("Mistake", "The edge begins at its corner, does it not? The first row lies below it."),
     "flat-edge", Proof::WrongFaces, Change::Rises, at(Span),
     [](Rules& r) {
         r.algorithm = Algorithm::EdgeWalking;
         r.edgesPreStepped = false;
     }},
    {"snap-y-only", "C8", QT_TRANSLATE_NOOP("Mistake", "Only y is rounded to whole rows"),
     QT_TRANSLATE_NOOP("Mistake",
                       "Shapes are lopsided: each corner goes up or down by up to half a row, and flat edges tilt."),
     QT_TRANSLATE_NOOP("Mistake", "v.y = round(v.y), and v.x keeps its fraction and its slope"),
     QT_TRANSLATE_NOOP("Mistake", "Rows are counted in integers, so y becomes one."), "between-rows", Proof::WrongFaces,
     Change::Rises, at(Viewport), [](Rules& r) { r.rowsRounded = true; }},
    {"ends-not-sorted", "C9", QT_TRANSLATE_NOOP("Mistake", "The two ends of a row are not sorted"),
     QT_TRANSLATE_NOOP("Mistake", "Half of the triangles are missing: those whose middle corner lies on the left."),
     QT_TRANSLATE_NOOP("Mistake", "for (x = xLong; x < xShort; ++x), whichever is the left one"),
     QT_TRANSLATE_NOOP("Mistake", "It holds in the first triangle."), "fan", Proof::Holes, Change::Rises, at(Span),
     [](Rules& r) {
         r.algorithm = Algorithm::EdgeWalking;
         r.spanEndsSorted = false;
     }},
    {"truncate-to-zero", "C15", QT_TRANSLATE_NOOP("Mistake", "Coordinates are cut off towards 0"),
     QT_TRANSLATE_NOOP("Mistake", "What lies up to a pixel beyond the left or the upper border is drawn in the first "
                                  "column or row, a second time."),
     QT_TRANSLATE_NOOP("Mistake", "int x = (int)p.x in place of (int)floor(p.x)"),
     QT_TRANSLATE_NOOP("Mistake", "Both are the same where coordinates are positive."), "points-over-border",
     Proof::Covered, Change::Rises, at(LineSample), [](Rules& r) { r.gridRounding = GridRounding::TowardsZero; }},
    {"no-inside-test", "C16", QT_TRANSLATE_NOOP("Mistake", "The inside test is missing"),
     QT_TRANSLATE_NOOP(
         "Mistake",
         "Every triangle is drawn as its box: slanted borders become corners, and the body is built of bricks."),
     QT_TRANSLATE_NOOP("Mistake", "for (y in box) for (x in box) draw(x, y), without a look at E"),
     QT_TRANSLATE_NOOP("Mistake", "It was commented out while something else was searched for."), "letter-f",
     Proof::Covered, Change::Rises, at(Sample), [](Rules& r) { r.insideTest = InsideTest::None; }},
    {"int16-overflow", "C18", QT_TRANSLATE_NOOP("Mistake", "Products in 16 bits"),
     QT_TRANSLATE_NOOP("Mistake",
                       "A triangle that lies wholly on a small screen has holes and strays with straight edges."),
     QT_TRANSLATE_NOOP("Mistake", "int16_t E_AB = (x - A.x) * (B.y - A.y) - ..."),
     QT_TRANSLATE_NOOP("Mistake", "320 x 240 fits 16 bits, so everything does."), "small-screen", Proof::Holes,
     Change::Rises, at(Sample), [](Rules& r) { r.insideTest = InsideTest::Wrapped16; }},
};

} // namespace

std::span<const MistakeRow> coverageMistakes() { return kRows; }

} // namespace rasterlens
