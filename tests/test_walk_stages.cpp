// Edge walking in its stages: outline, corners by height, long and broken edge, cut, crossings row by row. Every number
// is computed once more as a fraction of whole numbers from the corners that the scene was made of.
#include "core/observe/step_text.h"
#include "core/render/render.h"
#include "core/render/steps.h"
#include "core/scenes/builtin_scenes.h"
#include "tests/support.h"

#include <QJsonArray>
#include <QTest>

#include <array>
#include <cstdlib>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr QSize kSize{64, 64}; ///< a power of two, so that clip space holds the corners exactly

/// A whole number of eighths of a pixel: corners lie on quarters, centres on odd multiples of four.
struct Point8 {
    std::int64_t x;
    std::int64_t y;
};

struct Case {
    const char* name;
    std::array<Point8, 3> corners; ///< A, B, C in eighths of a pixel, y down
    const char* sorted;            ///< from the top
    const char* longEdge;          ///< as the house names it
    const char* broken;
    bool longIsLeft;
    int firstRow;
    int firstLowerRow;
    int lastRow;
};

// Sorted, named and divided by hand. A row whose centre lies at the height of corner 1 or 3 is walked, and is empty. An
// edge is named as the triangle goes round counter-clockwise on the screen.
const Case kCases[]{
    {"middle corner right", {{{80, 16}, {40, 400}, {360, 208}}}, "ACB", "AB", "CA BC", true, 2, 26, 49},
    {"middle corner left", {{{320, 24}, {48, 200}, {400, 424}}}, "ABC", "CA", "AB BC", false, 3, 25, 52},
    {"clockwise", {{{320, 24}, {400, 424}, {48, 200}}}, "ACB", "BA", "AC CB", false, 3, 25, 52},
    {"flat top", {{{32, 40}, {96, 360}, {304, 40}}}, "ACB", "AB", "CA BC", true, 5, 5, 44},
    {"flat bottom", {{{168, 24}, {40, 344}, {440, 344}}}, "ABC", "CA", "AB BC", false, 3, 43, 42},
    {"middle corner on a row's centre", {{{88, 20}, {24, 308}, {328, 116}}}, "ACB", "AB", "CA BC", true, 2, 14, 38},
    {"quarters of a pixel", {{{82, 18}, {46, 398}, {358, 206}}}, "ACB", "AB", "CA BC", true, 2, 26, 49},
};

glm::vec4 atEighth(const Point8& p) { return atPixel(double(p.x) / 8, double(p.y) / 8, 0.5, kSize); }

std::shared_ptr<const StepLog> walkedLog(const std::array<Point8, 3>& corners, const char* mistake = nullptr)
{
    Settings settings = plainSettings(kSize);
    settings.algorithm = Algorithm::EdgeWalking;
    if (mistake != nullptr)
        settings.mistakes = {QString::fromLatin1(mistake)};
    return renderSteps(soup({atEighth(corners[0]), atEighth(corners[1]), atEighth(corners[2])}), settings);
}

const Point8& sortedCorner(const Case& one, std::size_t i) { return one.corners[std::size_t(one.sorted[i] - 'A')]; }

/// What a row of a case is crossed at, by fractions of whole numbers.
struct Expected {
    bool upper;
    double alpha;
    double beta;
    double xa; ///< pixels
    double xb;
};

Expected expectedAt(const Case& one, int row, int extraRows)
{
    const Point8& top = sortedCorner(one, 0);
    const Point8& middle = sortedCorner(one, 1);
    const Point8& bottom = sortedCorner(one, 2);
    const std::int64_t y = 8 * std::int64_t(row) + 4;
    const bool upper = y < middle.y || middle.y == bottom.y;
    const Point8& from = upper ? top : middle;
    const Point8& to = upper ? middle : bottom;
    const std::int64_t longHeight = bottom.y - top.y + 8 * extraRows;
    const std::int64_t shortHeight = to.y - from.y + 8 * extraRows;
    // x1 + (y - y1) (x3 - x1) / height, over one denominator
    const auto crossing = [y](const Point8& a, const Point8& b, std::int64_t height) {
        return double(a.x * height + (y - a.y) * (b.x - a.x)) / double(8 * height);
    };
    return {upper, double(y - top.y) / double(longHeight), double(y - from.y) / double(shortHeight),
            crossing(top, bottom, longHeight), crossing(from, to, shortHeight)};
}

bool isNear(double a, double b) { return std::abs(a - b) <= 1e-12 * (1 + std::abs(b)); }

} // namespace

class TestWalkStages : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void stagesComeInOrder();
    void cornersAreSortedAndEdgesNamed();
    void halvesAreThoseOfTheMiddleCorner();
    void crossingsAreFractions();
    void textbookTriangle();
    void plusOneIsInEveryFraction();
    void plusOneCountsTheTrianglesPixels();
    void pixelFilterKeepsItsRow();
    void flatHalvesAreSaidToBeMissing();
};

void TestWalkStages::stagesComeInOrder()
{
    for (const Case& one : kCases) {
        const auto log = walkedLog(one.corners);
        std::vector<StepKind> kinds;
        for (const StepEvent& event : log->events())
            if (event.kind >= StepKind::Outline && event.kind <= StepKind::Span)
                kinds.push_back(event.kind);
        const std::vector<StepKind> stages{StepKind::Outline, StepKind::Walk, StepKind::Sides, StepKind::Halves};
        QVERIFY2(std::equal(stages.begin(), stages.end(), kinds.begin()), one.name);
        const int rows = one.lastRow - one.firstRow + 1;
        QCOMPARE(kinds.size(), stages.size() + std::size_t(2 * rows));
        for (std::size_t i = stages.size(); i < kinds.size(); i += 2)
            QVERIFY2(kinds[i] == StepKind::Crossing && kinds[i + 1] == StepKind::Span, one.name);
    }
}

void TestWalkStages::cornersAreSortedAndEdgesNamed()
{
    for (const Case& one : kCases) {
        const auto log = walkedLog(one.corners);
        const std::uint32_t walk = log->eventsOf(StepKind::Walk)[0];
        const QString by = stepText(*log, walk);
        for (int i = 0; i < 3; ++i)
            QVERIFY2(by.contains(QStringLiteral("%1 = %2 (").arg(i + 1).arg(QLatin1Char(one.sorted[i]))),
                     qPrintable(by));
        const QJsonObject sides = stepJson(*log, log->eventsOf(StepKind::Sides)[0]);
        QCOMPARE(sides.value("long").toString(), QLatin1String(one.longEdge));
        const QJsonArray broken = sides.value("broken").toArray();
        QCOMPARE(broken[0].toString() + QLatin1Char(' ') + broken[1].toString(), QLatin1String(one.broken));
        QCOMPARE(sides.value("long_edge").toString(), QLatin1String(one.longIsLeft ? "left" : "right"));
        const QString outline = stepText(*log, log->eventsOf(StepKind::Outline)[0]);
        const double height = double(sortedCorner(one, 2).y - sortedCorner(one, 0).y) / 8;
        QVERIFY2(outline.contains(QStringLiteral("%1 %2").arg(QLatin1String(one.longEdge), shortNumber(height))),
                 qPrintable(outline));
    }
}

void TestWalkStages::halvesAreThoseOfTheMiddleCorner()
{
    for (const Case& one : kCases) {
        const auto log = walkedLog(one.corners);
        const HalvesStep& step = log->payload<HalvesStep>(log->event(log->eventsOf(StepKind::Halves)[0]));
        const Point8& top = sortedCorner(one, 0);
        const Point8& middle = sortedCorner(one, 1);
        const Point8& bottom = sortedCorner(one, 2);
        const std::int64_t height = bottom.y - top.y;
        QCOMPARE(step.halves.alpha, double(middle.y - top.y) / double(height));
        QVERIFY2(isNear(step.halves.x,
                        double(top.x * height + (middle.y - top.y) * (bottom.x - top.x)) / double(8 * height)),
                 one.name);
        QCOMPARE(step.walk.firstRow, one.firstRow);
        QCOMPARE(step.halves.firstLowerRow, one.firstLowerRow);
        QCOMPARE(step.walk.lastRow, one.lastRow);
    }
}

void TestWalkStages::crossingsAreFractions()
{
    std::size_t rows = 0;
    for (const Case& one : kCases) {
        const auto log = walkedLog(one.corners);
        for (const std::uint32_t i : log->eventsOf(StepKind::Crossing)) {
            const RowCrossings& row = log->payload<CrossingStep>(log->event(i)).row;
            const Expected expected = expectedAt(one, row.y, 0);
            QCOMPARE(row.y, one.firstRow + int(rows++ % std::size_t(one.lastRow - one.firstRow + 1)));
            QCOMPARE(row.upperHalf, expected.upper);
            QCOMPARE(row.upperHalf, row.y < one.firstLowerRow);
            QCOMPARE(row.alpha, expected.alpha);
            QCOMPARE(row.beta, expected.beta);
            QVERIFY2(isNear(row.xa, expected.xa) && isNear(row.xb, expected.xb), one.name);
            const SpanStep& span = log->payload<SpanStep>(log->event(i + 1));
            QCOMPARE(double(span.ends.begin), std::ceil(std::min(expected.xa, expected.xb) - 0.5));
            QCOMPARE(double(span.ends.end), std::ceil(std::max(expected.xa, expected.xb) - 0.5));
        }
        rows = 0;
    }
}

/// (100, 200), (300, 400), (400, 100) with y up, in 600 rows: 1 is B, 2 is A, 3 is C.
void TestWalkStages::textbookTriangle()
{
    const Scene scene = *makeBuiltinScene(QStringLiteral("triangle-600")).scene;
    Settings settings = scene.defaults;
    settings.algorithm = Algorithm::EdgeWalking;
    StepFilter filter;
    filter.kinds =
        kindBit(StepKind::Walk) | kindBit(StepKind::Halves) | kindBit(StepKind::Crossing) | kindBit(StepKind::Span);
    const auto log = renderSteps(scene, settings, filter);
    const WalkedTriangle& walk = log->payload<WalkStep>(log->event(log->eventsOf(StepKind::Walk)[0])).walk;
    QVERIFY(walk.vertices[0] == glm::dvec2(300, 200));
    QVERIFY(walk.vertices[1] == glm::dvec2(100, 400));
    QVERIFY(walk.vertices[2] == glm::dvec2(400, 500));
    const HalvesStep& halves = log->payload<HalvesStep>(log->event(log->eventsOf(StepKind::Halves)[0]));
    QCOMPARE(halves.halves.alpha, 2.0 / 3);
    QVERIFY(isNear(halves.halves.x, 1100.0 / 3));
    QCOMPARE(halves.halves.firstLowerRow, 400);
    const auto crossings = log->eventsOf(StepKind::Crossing);
    QCOMPARE(crossings.size(), std::size_t(300));
    const auto row = [&](int y) { return log->payload<CrossingStep>(log->event(crossings[std::size_t(y - 200)])).row; };
    // alpha = (y - 200) / 300, xa = 300 + 100 alpha; beta = (y - 200) / 200, xb = 300 - 200 beta, below 400
    // (y - 400) / 100 and xb = 100 + 300 beta, at y = 200.5, 299.5, 399.5, 400.5, 499.5.
    const std::array<std::array<double, 5>, 5> expected{{{200, 1.0 / 600, 1801.0 / 6, 1.0 / 400, 299.5},
                                                         {299, 199.0 / 600, 1999.0 / 6, 199.0 / 400, 200.5},
                                                         {399, 399.0 / 600, 366.5, 399.0 / 400, 100.5},
                                                         {400, 401.0 / 600, 2201.0 / 6, 1.0 / 200, 101.5},
                                                         {499, 599.0 / 600, 2399.0 / 6, 199.0 / 200, 398.5}}};
    for (const auto& [y, alpha, xa, beta, xb] : expected) {
        const RowCrossings at = row(int(y));
        QCOMPARE(at.alpha, alpha);
        QCOMPARE(at.beta, beta);
        QVERIFY(isNear(at.xa, xa) && isNear(at.xb, xb));
        QCOMPARE(at.upperHalf, y < 400);
    }
    std::int64_t covered = 0;
    for (const std::uint32_t i : log->eventsOf(StepKind::Span)) {
        const SpanStep& span = log->payload<SpanStep>(log->event(i));
        covered += span.xEnd - span.xBegin;
    }
    QCOMPARE(covered, 40100);
}

/// M12: one row more in every height, of the long edge, too.
void TestWalkStages::plusOneIsInEveryFraction()
{
    for (const Case& one : kCases) {
        const auto log = walkedLog(one.corners, "height-plus-one");
        QVERIFY(!log->eventsOf(StepKind::Crossing).empty());
        for (const std::uint32_t i : log->eventsOf(StepKind::Crossing)) {
            const RowCrossings& row = log->payload<CrossingStep>(log->event(i)).row;
            const Expected expected = expectedAt(one, row.y, 1);
            QCOMPARE(row.alpha, expected.alpha);
            QCOMPARE(row.beta, expected.beta);
            QVERIFY2(isNear(row.xa, expected.xa) && isNear(row.xb, expected.xb), one.name);
        }
    }
}

/// What docs/MISTAKES.md says of M12 in the triangle of [004], whose program is counted by its own loop.
void TestWalkStages::plusOneCountsTheTrianglesPixels()
{
    Scene scene = *makeBuiltinScene(QStringLiteral("triangle-600")).scene;
    Settings settings = scene.defaults;
    Frame frame;
    QCOMPARE(renderCounted(scene, settings, frame).pixels.covered, 40'100U);
    settings.mistakes = {QStringLiteral("height-plus-one")};
    QCOMPARE(renderCounted(scene, settings, frame).pixels.covered, 39'999U);
    settings.mistakes = {QStringLiteral("whole-rows")};
    QCOMPARE(renderCounted(scene, settings, frame).pixels.covered, 40'201U);
    settings.mistakes << QStringLiteral("height-plus-one");
    QCOMPARE(renderCounted(scene, settings, frame).pixels.covered, 40'301U);
    const std::array<glm::ivec2, 3> v{{{400, 100}, {100, 200}, {300, 400}}};
    const auto floorDivide = [](int a, int b) { return a >= 0 ? a / b : -((b - 1 - a) / b); };
    const auto at = [&](std::size_t i, std::size_t j, int y) {
        return v[i].x + floorDivide((y - v[i].y) * (v[j].x - v[i].x), v[j].y - v[i].y + 1);
    };
    int covered = 0;
    for (int y = v[0].y; y <= v[2].y; ++y)
        covered += std::abs(at(0, 2, y) - (y > v[1].y ? at(1, 2, y) : at(0, 1, y))) + 1;
    QCOMPARE(covered, 40'301);
}

void TestWalkStages::pixelFilterKeepsItsRow()
{
    Settings settings = plainSettings(kSize);
    settings.algorithm = Algorithm::EdgeWalking;
    StepFilter filter;
    filter.pixels = PixelRect{15, 20, 1, 1};
    const auto& corners = kCases[0].corners;
    const auto log =
        renderSteps(soup({atEighth(corners[0]), atEighth(corners[1]), atEighth(corners[2])}), settings, filter);
    const auto crossings = log->eventsOf(StepKind::Crossing);
    QCOMPARE(crossings.size(), std::size_t(1));
    QCOMPARE(log->event(crossings[0]).y, 20);
    QCOMPARE(log->eventsOf(StepKind::Sides).size(), std::size_t(1));
}

void TestWalkStages::flatHalvesAreSaidToBeMissing()
{
    const auto said = [](const Case& one) {
        const auto log = walkedLog(one.corners);
        return stepText(*log, log->eventsOf(StepKind::Halves)[0]);
    };
    QVERIFY2(said(kCases[3]).contains(QStringLiteral("there is no upper half: rows of the lower half 5..44")),
             qPrintable(said(kCases[3])));
    QVERIFY2(said(kCases[4]).contains(QStringLiteral("there is no lower half: rows of the upper half 3..42")),
             qPrintable(said(kCases[4])));
}

QTEST_GUILESS_MAIN(TestWalkStages)
#include "test_walk_stages.moc"
