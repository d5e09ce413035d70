// Lines of a scene (`line` in case files): every pipeline that draws them against the exact reference, and what is said
// where they are not drawn.
#include "core/io/case_file.h"
#include "core/questions/unchanged.h"
#include "core/questions/why.h"
#include "core/questions/without_effect.h"
#include "core/render/steps.h"
#include "core/truth/exact_line.h"
#include "core/truth/hard_cases.h"
#include "tests/support.h"

#include <QTest>

#include <array>
#include <cmath>
#include <set>
#include <utility>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

Scene parsed(const QByteArray& text)
{
    const SceneLoad load = parseCase(text, QStringLiteral("lines.case"));
    if (!load.scene)
        qFatal("%s", qPrintable(load.diagnostics.front().text()));
    return *load.scene;
}

QByteArray cornerText(Random& random, bool onTies)
{
    const double w = std::exp2(integer(random, -2, 3)) * (integer(random, 0, 9) == 0 ? -1 : 1);
    const auto place = [&] { return onTies ? integer(random, -6, 38) / 16.0 - 1 : uniform(random, -1.4, 1.4); };
    QByteArray text;
    for (const double value : {place() * w, place() * w, uniform(random, -1.2, 1.2) * w, w})
        text += ' ' + QByteArray::number(value, 'g', 9);
    for (int i = 0; i < 3; ++i)
        text += ' ' + QByteArray::number(integer(random, 0, 8) / 8.0);
    return text;
}

/// A corner of a triangle that no plane cuts.
QByteArray insideText(Random& random)
{
    QByteArray text;
    for (int i = 0; i < 3; ++i)
        text += ' ' + QByteArray::number(uniform(random, -0.95, 0.95), 'g', 9);
    text += " 1";
    for (int i = 0; i < 3; ++i)
        text += ' ' + QByteArray::number(integer(random, 0, 8) / 8.0);
    return text;
}

/// Lines and some triangles in clip space; many of the lines have ties, leave the picture or go behind the eye.
QByteArray randomCase(Random& random, int round)
{
    static constexpr const char* kRules[] = {"inclusive", "half-open", "diamond-exit"};
    QByteArray text = "size 32 32\nline_rule " + QByteArray(kRules[round % 3]) + '\n';
    if (round % 2 == 0)
        text += "line_ties canonical\n";
    if (round % 5 == 0)
        text += "ssaa 2\n";
    if (round % 7 == 0)
        text += "subpixel_bits 2\n";
    if (round % 4 == 0)
        text += "depth_format unorm16\n";
    for (int i = 0; i < 12; ++i) {
        const bool onTies = i % 2 == 0;
        if (i % 6 == 5)
            text += "tri" + insideText(random) + insideText(random) + insideText(random) + '\n';
        else
            text += "line" + cornerText(random, onTies) + cornerText(random, onTies) + '\n';
    }
    return text;
}

const char* kFlatLine = "line -0.8125 0.5 0 1 1 0 0  0.8125 -0.25 0.5 1 0 0 1\n";

} // namespace

class TestSceneLines : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void centreLinesAreNearest();
    void randomLinesAreExact();
    void wrongLinesAreFound();
    void fillAndCullingDoNotMatter();
    void attributesRunAlong();
    void stepsAndAnswersKnowLines();
    void statisticsCountThem();
    void whatIsNotDrawnSaysWhy();
    void switchesOfLinesAreOpen();
};

/// Among all samples of a column (or row) the one chosen is nearest to the line, by distances of its own.
void TestSceneLines::centreLinesAreNearest()
{
    Random random = seededRandom();
    for (int round = 0; round < 2000; ++round) {
        const auto place = [&] { return integer(random, -20, 20); };
        const glm::ivec2 from(place(), place());
        const glm::ivec2 to(place(), place());
        const std::vector<glm::ivec2> samples = exactCentreLine(from, to);
        const glm::ivec2 way = to - from;
        const int axis = std::abs(way.y) > std::abs(way.x) ? 1 : 0;
        QCOMPARE(samples.size(), std::size_t(std::abs(way[axis]) + 1));
        QVERIFY(samples.front() == from && samples.back() == to);
        for (const glm::ivec2& sample : samples) {
            // twice the area between the line and the sample, or its neighbours across the line
            const auto away = [&](int aside) {
                glm::ivec2 at = sample - from;
                at[1 - axis] += aside;
                return std::abs(way.x * at.y - way.y * at.x);
            };
            QVERIFY(away(0) <= away(1) && away(0) <= away(-1));
            const int towardsStart = way[1 - axis] > 0 ? -1 : 1;
            if (way[1 - axis] != 0)
                QVERIFY(away(0) < away(towardsStart)); // a tie goes to the start's side
        }
    }
}

void TestSceneLines::randomLinesAreExact()
{
    Random random = seededRandom();
    std::uint64_t covered = 0;
    std::uint64_t clipped = 0;
    for (int round = 0; round < 150; ++round) {
        const QByteArray text = randomCase(random, round);
        const Scene scene = parsed(text);
        const ExactFrame truth = caseTruth(scene, scene.defaults.samples);
        for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking}) {
            Settings settings = scene.defaults;
            settings.algorithm = algorithm;
            const CaseVerdict verdict = judgeCase(scene, truth, settings);
            QVERIFY2(verdict.grade == CaseGrade::Passes || verdict.grade == CaseGrade::PassesWithin,
                     qPrintable(textOf(verdict.reasons) + QLatin1Char('\n') + QString::fromLatin1(text)));
            covered += verdict.difference.covered;
        }
        Frame frame;
        clipped += renderCounted(scene, scene.defaults, frame).faces.clipped;
    }
    QVERIFY(covered > 10000 && clipped > 200);
}

/// The judge is no yes-man: other rules and other ties are told.
void TestSceneLines::wrongLinesAreFound()
{
    const Scene scene = parsed("size 32 32\nline -0.90625 0.90625 0 1 1 0 0  0.09375 0.40625 0 1 1 0 0\n"
                               "line 0.09375 -0.40625 0 1 1 0 0  -0.90625 0.09375 0 1 1 0 0\n");
    const ExactFrame truth = caseTruth(scene, Samples::One);
    QCOMPARE(judgeCase(scene, truth, scene.defaults).grade, CaseGrade::Passes);
    Settings wrong = scene.defaults;
    wrong.lineTies = LineTies::Canonical;
    QCOMPARE(judgeCase(scene, truth, wrong).grade, CaseGrade::Fails);
    wrong = scene.defaults;
    wrong.lineRule = LineRule::HalfOpen;
    const CaseVerdict verdict = judgeCase(scene, truth, wrong);
    QCOMPARE(verdict.grade, CaseGrade::Fails);
    QCOMPARE(verdict.difference.missing, std::uint64_t(2));
    wrong.lineRule = LineRule::DiamondExit;
    QCOMPARE(judgeCase(scene, truth, wrong).grade, CaseGrade::Fails);
}

void TestSceneLines::fillAndCullingDoNotMatter()
{
    const Scene scene = parsed(QByteArray("size 32 32\n") + kFlatLine);
    const Frame right = draw(scene, scene.defaults);
    QVERIFY(std::ranges::count(right.coverage, std::uint16_t(1)) == 27);
    for (const Fill fill : {Fill::Solid, Fill::Wireframe, Fill::Points})
        for (const Culling culling : {Culling::None, Culling::Back, Culling::Front})
            for (const SharedEdges shared : {SharedEdges::Once, SharedEdges::EachFace}) {
                Settings settings = scene.defaults;
                settings.fill = fill;
                settings.culling = culling;
                settings.sharedEdges = shared;
                settings.algorithm = Algorithm::ColumnFill;
                settings.depthBias = {.constant = 100, .slope = 3};
                QCOMPARE(difference(draw(scene, settings), right), QString());
            }
}

void TestSceneLines::attributesRunAlong()
{
    // Depth is linear on the screen, colour where w differs is not.
    const Scene scene = parsed("size 32 32\nline -0.90625 0.03125 0 1 1 0 0  3.625 0.125 2 4 0 0 1\n");
    const Frame frame = draw(scene, scene.defaults);
    for (int x = 1; x <= 30; ++x) {
        const double t = (x - 1) / 29.0;
        const std::size_t at = std::size_t(15 * 32 + x);
        QCOMPARE(frame.ids[at], 0);
        QVERIFY(std::abs(double(frame.depth[at]) - (0.5 + 0.25 * t)) < 1e-6);
        const double blue = t / 4 / (1 - t + t / 4);
        QVERIFY(std::abs(qBlue(frame.image.pixel(x, 15)) - 255 * blue) <= 0.51);
    }
}

void TestSceneLines::stepsAndAnswersKnowLines()
{
    const auto scene = std::make_shared<const Scene>(
        parsed(QByteArray("size 32 32\ntri -1 -1 0.9 1 0 1 0  1 -1 0.9 1 0 1 0  1 1 0.9 1 0 1 0\n") + kFlatLine));
    Frame frame;
    const Statistics counted = renderCounted(*scene, scene->defaults, frame, kAllOutputs);
    const auto log = renderSteps(*scene, scene->defaults);
    QVERIFY(log->countersAt(log->size()) == counted);
    QCOMPARE(log->eventsOf(StepKind::LineDecision).size(), std::size_t(26));
    QVERIFY(log->eventsOf(StepKind::Setup).size() == 1); // of the triangle alone
    const auto record = recordSteps(scene, scene->defaults);
    FramePlanes planes;
    std::size_t decisions = 0;
    for (std::size_t first = 0; first < record->size(); first += 50)
        decisions += record->window(first, 50, planes)->eventsOf(StepKind::LineDecision).size();
    QVERIFY(decisions >= 26);
    QVERIFY(std::ranges::equal(planes.owners, frame.ids));
    for (const QPoint& pixel : {QPoint(3, 8), QPoint(16, 14), QPoint(28, 19), QPoint(30, 30)}) {
        const WhyReport report = why(*scene, scene->defaults, pixel.x(), pixel.y());
        const std::int32_t face = frame.ids[std::size_t(pixel.y() * 32 + pixel.x())];
        QCOMPARE(report.visibleFace ? std::int32_t(*report.visibleFace) : -1, face);
        if (face == 1)
            QVERIFY(whyText(report, *report.find(1)).contains(QLatin1String("written")));
    }
}

void TestSceneLines::statisticsCountThem()
{
    const Scene scene = parsed("size 32 32\nline -1 0 0 1 1 1 1  1 0 0 1 1 1 1\nline -1 0 3 1 1 1 1  1 0 3 1 1 1 1\n"
                               "line 0 0 0 1 1 1 1  3 0 0 1 1 1 1\nline 0 0 nan 1 1 1 1  1 0 0 1 1 1 1\n");
    Frame frame;
    const Statistics statistics = renderCounted(scene, scene.defaults, frame);
    QCOMPARE(statistics.faces.submitted, std::uint64_t(4));
    QCOMPARE(statistics.faces.rasterized, std::uint64_t(2));
    QCOMPARE(statistics.faces.rejected, std::uint64_t(1));
    QCOMPARE(statistics.faces.nonFinite, std::uint64_t(1));
    QCOMPARE(statistics.faces.clipped, std::uint64_t(1));
    QCOMPARE(statistics.lines.drawn, std::uint64_t(2));
    QCOMPARE(statistics.pixels.coveredTwice, std::uint64_t(0));
    const QJsonObject json = toJson(statistics, {}, scene.defaults, scene.defaults);
    QCOMPARE(json[QLatin1String("lines")].toObject()[QLatin1String("drawn")].toInt(), 2);
}

void TestSceneLines::whatIsNotDrawnSaysWhy()
{
    const Scene scene = parsed(QByteArray("size 32 32\n") + kFlatLine);
    const auto reason = [&](auto&& change) {
        Settings settings = scene.defaults;
        change(settings);
        const auto why = unsupported(scene, settings);
        return why ? textOf(*why) : QString();
    };
    QVERIFY(reason([](Settings&) {}).isEmpty());
    QVERIFY(reason([](Settings& s) { s.algorithm = Algorithm::Tiled; }).contains(QLatin1String("lines")));
    QVERIFY(reason([](Settings& s) { s.samples = Samples::Msaa4; }).contains(QLatin1String("lines")));
    QVERIFY(reason([](Settings& s) { s.clipping = Clipping::CohenSutherland; }).contains(QLatin1String("lines")));
}

void TestSceneLines::switchesOfLinesAreOpen()
{
    const Settings solid;
    for (const char* id : {"line", "line-rule", "line-ties"}) {
        const SettingsField& field = *findSettingsField(QLatin1String(id));
        QVERIFY(whyWithoutEffect(field, solid));
        QVERIFY(!whyWithoutEffect(field, solid, true));
    }
    QVERIFY(whyWithoutEffect(*findSettingsField(QStringLiteral("shared-edges")), solid, true));
    const Scene scene = parsed(QByteArray("size 32 32\n") + kFlatLine);
    Settings wrong = scene.defaults;
    wrong.mistakes = {QStringLiteral("missing-last-pixel")};
    QVERIFY(!whyUnchanged(*findMistake(wrong.mistakes.front()), wrong, frameFacts(scene, wrong)));
    QVERIFY(draw(scene, wrong).image != draw(scene, scene.defaults).image);
}

QTEST_APPLESS_MAIN(TestSceneLines)
#include "test_scene_lines.moc"
