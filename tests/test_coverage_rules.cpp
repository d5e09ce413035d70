// What a triangle must do to have a pixel: hold its centre, touch its square, or hold the whole square.
#include "core/observe/step_log.h"
#include "core/pipeline/pixel_area.h"
#include "core/questions/why.h"
#include "core/questions/without_effect.h"
#include "core/render/steps.h"
#include "core/truth/exact_reference.h"
#include "tests/support.h"

#include <QTest>

#include <array>
#include <cmath>
#include <vector>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

Settings settingsWith(CoverageRule rule, QSize size)
{
    Settings settings = plainSettings(size);
    settings.algorithm = Algorithm::EdgeEquation;
    settings.coverageRule = rule;
    settings.clipping = Clipping::GuardBand; // faces a little larger than the screen stay whole
    return settings;
}

std::vector<std::uint32_t> coverageOf(const Scene& scene, CoverageRule rule, QSize size)
{
    const Frame frame = draw(scene, settingsWith(rule, size));
    return {frame.coverage.begin(), frame.coverage.end()};
}

int covered(const std::vector<std::uint32_t>& coverage)
{
    return static_cast<int>(std::ranges::count_if(coverage, [](std::uint32_t n) { return n > 0; }));
}

Scene oneTriangle(const std::array<glm::dvec2, 3>& corners, QSize size)
{
    std::vector<glm::vec4> positions;
    for (const glm::dvec2& corner : corners)
        positions.push_back(atPixel(corner.x, corner.y, 0.5, size));
    return soup(positions);
}

/// A corner on the screen or around it; with perspective some lie behind the eye, so that faces are cut.
glm::vec4 randomCorner(Random& random, const glm::dvec2& middle, double reach, bool perspective, QSize size)
{
    glm::vec4 p = atPixel(middle.x + uniform(random, -reach, reach), middle.y + uniform(random, -reach, reach),
                          uniform(random, 0.05, 0.95), size);
    if (perspective) {
        const auto w = static_cast<float>(uniform(random, -0.5, 2));
        p = glm::vec4(p.x * w, p.y * w, static_cast<float>(uniform(random, -2, 2)), w);
    }
    return p;
}

} // namespace

class TestCoverageRules : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void countsByHand_data();
    void countsByHand();
    void exactReferenceAgrees_data();
    void exactReferenceAgrees();
    void rulesStandInOrderWithAreas();
    void stepsTellTheCornerAsked();
    void whyTellsSquareAndArea();
    void refusalsSayWhy_data();
    void refusalsSayWhy();
    void switchesWithoutEffectSayWhy();
};

void TestCoverageRules::countsByHand_data()
{
    QTest::addColumn<std::vector<double>>("corners");
    QTest::addColumn<int>("centre");
    QTest::addColumn<int>("conservative");
    QTest::addColumn<int>("inner");
    // x + y <= 4: squares (x, y) with x + y <= 4 touch it, those with x + y + 2 <= 4 lie in it. Centres with
    // x + y + 1 = 4 lie on the slanted edge, a right one.
    QTest::addRow("slanted at 45 degrees") << std::vector<double>{0, 0, 0, 4, 4, 0} << 6 << 15 << 6;
    // Between 2 and 3 along both axes: its own square, the neighbours that it touches with a side or a corner, and the
    // one beyond the slanted edge with nothing but the border that the edge ends at.
    QTest::addRow("on the corners of a pixel") << std::vector<double>{2, 2, 2, 3, 3, 2} << 0 << 8 << 0;
    QTest::addRow("inside of a pixel") << std::vector<double>{2.25, 2.25, 2.25, 2.5, 2.5, 2.25} << 0 << 1 << 0;
    // A sliver through four pixels of a row: no centre, no square.
    QTest::addRow("a sliver") << std::vector<double>{1.5, 3.0625, 1.5, 3.125, 5.25, 3.0625} << 0 << 5 << 0;
}

void TestCoverageRules::countsByHand()
{
    QFETCH(std::vector<double>, corners);
    QFETCH(int, centre);
    QFETCH(int, conservative);
    QFETCH(int, inner);
    const QSize size(8, 8);
    const Scene scene = oneTriangle(
        {glm::dvec2(corners[0], corners[1]), glm::dvec2(corners[2], corners[3]), glm::dvec2(corners[4], corners[5])},
        size);
    QCOMPARE(covered(coverageOf(scene, CoverageRule::Centre, size)), centre);
    QCOMPARE(covered(coverageOf(scene, CoverageRule::Conservative, size)), conservative);
    QCOMPARE(covered(coverageOf(scene, CoverageRule::Inner, size)), inner);
}

void TestCoverageRules::exactReferenceAgrees_data()
{
    QTest::addColumn<CoverageRule>("rule");
    QTest::addColumn<double>("reach");
    QTest::addColumn<bool>("perspective");
    for (const auto& [name, rule] :
         {std::pair("conservative", CoverageRule::Conservative), std::pair("inner", CoverageRule::Inner)}) {
        QTest::addRow("%s, a pixel", name) << rule << 1.0 << false;
        QTest::addRow("%s, some pixels", name) << rule << 6.0 << false;
        QTest::addRow("%s, a screen", name) << rule << 60.0 << false;
        QTest::addRow("%s, larger than the screen", name) << rule << 2000.0 << false;
        QTest::addRow("%s, cut", name) << rule << 30.0 << true;
    }
}

/// Squares are asked in another way there: whether a corner of one lies in the other, or their borders meet.
void TestCoverageRules::exactReferenceAgrees()
{
    QFETCH(CoverageRule, rule);
    QFETCH(double, reach);
    QFETCH(bool, perspective);
    const QSize size(48, 32);
    Random random = seededRandom();
    for (int picture = 0; picture < casesOfBuild(16); ++picture) {
        std::vector<glm::vec4> corners;
        for (int face = 0; face < 25; ++face) {
            const glm::dvec2 middle(uniform(random, -4, size.width() + 4), uniform(random, -4, size.height() + 4));
            for (int k = 0; k < 3; ++k)
                corners.push_back(randomCorner(random, middle, reach, perspective, size));
        }
        const Scene scene = soup(corners);
        Settings settings = settingsWith(rule, size);
        settings.clipping = Clipping::Frustum;
        settings.subpixelBits = picture % 2 == 0 ? 8 : integer(random, 0, 7);
        const Frame frame = draw(scene, settings);
        const ExactFrame exact = exactReference(scene, settings);
        for (std::size_t at = 0; at < exact.cover.size(); ++at)
            QVERIFY2(frame.coverage[at] == exact.cover[at],
                     qPrintable(QStringLiteral("picture %1, %2 bits, pixel (%3, %4): %5 instead of %6")
                                    .arg(picture)
                                    .arg(settings.subpixelBits)
                                    .arg(at % std::size_t(size.width()))
                                    .arg(at / std::size_t(size.width()))
                                    .arg(frame.coverage[at])
                                    .arg(exact.cover[at])));
        for (std::size_t at = 0; at < exact.id.size(); ++at)
            QCOMPARE(frame.ids[at], exact.id[at]);
    }
}

/// Inner within centre within conservative; what has area in a pixel touches its square, and what holds the square
/// has all of its area.
void TestCoverageRules::rulesStandInOrderWithAreas()
{
    const QSize size(16, 16);
    Random random = seededRandom();
    for (int i = 0; i < casesOfBuild(400); ++i) {
        std::array<glm::dvec2, 3> corners;
        for (glm::dvec2& corner : corners)
            corner = {integer(random, -16 * 4, 16 * 20) / 16.0, integer(random, -16 * 4, 16 * 20) / 16.0};
        const Scene scene = oneTriangle(corners, size);
        const auto centre = coverageOf(scene, CoverageRule::Centre, size);
        const auto conservative = coverageOf(scene, CoverageRule::Conservative, size);
        const auto inner = coverageOf(scene, CoverageRule::Inner, size);
        ScreenTriangle triangle{};
        for (std::size_t k = 0; k < 3; ++k)
            triangle.vertices[k].position = corners[k];
        const bool hasArea = covered(conservative) > 0;
        for (int y = 0; y < 16; ++y)
            for (int x = 0; x < 16; ++x) {
                const auto at = std::size_t(16 * y + x);
                QVERIFY(inner[at] <= centre[at] && centre[at] <= conservative[at]);
                const double area = areaInPixel(triangle, x, y, 1);
                QVERIFY(area >= 0 && area <= 1 + 1e-12);
                if (hasArea && area > 1e-9)
                    QVERIFY(conservative[at] > 0);
                QCOMPARE(inner[at] > 0, hasArea && area > 1 - 1e-9);
            }
    }
}

void TestCoverageRules::stepsTellTheCornerAsked()
{
    const QSize size(8, 8);
    const Scene scene = oneTriangle({glm::dvec2(1.25, 0.75), glm::dvec2(2.5, 6.5), glm::dvec2(6.75, 3.25)}, size);
    for (const CoverageRule rule : {CoverageRule::Conservative, CoverageRule::Inner}) {
        const Settings settings = settingsWith(rule, size);
        const auto log = renderSteps(scene, settings);
        int samples = 0;
        for (std::size_t i = 0; i < log->events().size(); ++i) {
            const StepEvent& event = log->event(i);
            if (event.kind != StepKind::Sample)
                continue;
            ++samples;
            const EdgeValues& told = log->payload<SampleStep>(event).values;
            const StepSetup& setup = log->triangle(event)->setup;
            const EdgeValues asked = testedValues(setup, log->rules(), event.x, event.y);
            for (std::size_t edge = 0; edge < 3; ++edge) {
                QCOMPARE(told[edge], asked[edge]);
                // the extreme of the four corners
                double extreme = 0;
                for (const auto& [dx, dy] : {std::pair(0, 0), std::pair(1, 0), std::pair(0, 1), std::pair(1, 1)}) {
                    const double value = setup.at({event.x + dx, event.y + dy})[edge];
                    const bool isFirst = dx == 0 && dy == 0;
                    extreme = isFirst                              ? value
                              : rule == CoverageRule::Conservative ? std::max(extreme, value)
                                                                   : std::min(extreme, value);
                }
                QCOMPARE(told[edge], extreme);
            }
            QCOMPARE(event.has(StepEvent::kCovered), told[0] >= 0 && told[1] >= 0 && told[2] >= 0);
            QVERIFY(!event.has(StepEvent::kTie));
        }
        QVERIFY(samples > 20);
    }
}

/// The edge x + y = 7.5 cuts a corner off pixel (3, 4), an eighth of it.
void TestCoverageRules::whyTellsSquareAndArea()
{
    const QSize size(8, 8);
    const Scene scene = oneTriangle({glm::dvec2(0, 0), glm::dvec2(0, 7.5), glm::dvec2(7.5, 0)}, size);
    const auto verdict = [&](CoverageRule rule, int x, int y) {
        return why(scene, settingsWith(rule, size), x, y).find(0)->verdict;
    };
    const auto text = [&](CoverageRule rule, int x, int y) {
        const WhyReport report = why(scene, settingsWith(rule, size), x, y);
        return whyText(report, *report.find(0));
    };
    QVERIFY(std::abs(why(scene, settingsWith(CoverageRule::Centre, size), 3, 4).find(0)->area - 0.125) < 1e-12);
    QCOMPARE(verdict(CoverageRule::Centre, 3, 4), WhyVerdict::OutsideEdge);
    QVERIFY2(text(CoverageRule::Centre, 3, 4).endsWith(QLatin1String("; 12.5 % of the pixel's area")),
             qPrintable(text(CoverageRule::Centre, 3, 4)));
    QCOMPARE(verdict(CoverageRule::Conservative, 3, 4), WhyVerdict::Written);
    QCOMPARE(verdict(CoverageRule::Inner, 3, 4), WhyVerdict::OutsideEdge);
    QVERIFY2(text(CoverageRule::Inner, 3, 4).contains(QLatin1String("a part of the pixel's square lies outside edge")),
             qPrintable(text(CoverageRule::Inner, 3, 4)));
    QVERIFY2(
        text(CoverageRule::Conservative, 6, 6).contains(QLatin1String("the whole square of the pixel lies outside")),
        qPrintable(text(CoverageRule::Conservative, 6, 6)));
    QCOMPARE(verdict(CoverageRule::Inner, 1, 1), WhyVerdict::Written);
    QVERIFY(!text(CoverageRule::Inner, 1, 1).contains(QLatin1String("of the pixel's area"))); // all of it
}

void TestCoverageRules::refusalsSayWhy_data()
{
    QTest::addColumn<QString>("field");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("says");
    const QString corners = QStringLiteral("ask the corners of every pixel");
    QTest::addRow("edge walking") << QStringLiteral("algorithm") << QStringLiteral("edge-walking") << corners;
    QTest::addRow("column fill") << QStringLiteral("algorithm") << QStringLiteral("column-fill") << corners;
    QTest::addRow("tiled") << QStringLiteral("algorithm") << QStringLiteral("tiled") << corners;
    QTest::addRow("lines") << QStringLiteral("fill") << QStringLiteral("wireframe") << corners;
    QTest::addRow("floats") << QStringLiteral("number-type") << QStringLiteral("float32")
                            << QStringLiteral("number-type fixed");
    QTest::addRow("samples") << QStringLiteral("samples") << QStringLiteral("2x2") << QStringLiteral("need samples 1");
    QTest::addRow("patterns") << QStringLiteral("samples") << QStringLiteral("msaa4")
                              << QStringLiteral("need samples 1");
}

void TestCoverageRules::refusalsSayWhy()
{
    QFETCH(QString, field);
    QFETCH(QString, value);
    QFETCH(QString, says);
    const QSize size(8, 8);
    const Scene scene = oneTriangle({glm::dvec2(1, 1), glm::dvec2(1, 6), glm::dvec2(6, 1)}, size);
    Settings settings = settingsWith(CoverageRule::Inner, size);
    QVERIFY(!unsupported(scene, settings));
    QVERIFY(!setFromText(*findSettingsField(field), value, settings));
    const auto reason = unsupported(scene, settings);
    QVERIFY(reason);
    QVERIFY2(textOf(*reason).contains(says), qPrintable(textOf(*reason)));
    settings.coverageRule = CoverageRule::Centre;
    QVERIFY(!unsupported(scene, settings));
}

void TestCoverageRules::switchesWithoutEffectSayWhy()
{
    const QSize size(8, 8);
    for (const char* id : {"tie-rule", "stepping"}) {
        const SettingsField* field = findSettingsField(QLatin1String(id));
        QVERIFY(!whyWithoutEffect(*field, settingsWith(CoverageRule::Centre, size)));
        QVERIFY(whyWithoutEffect(*field, settingsWith(CoverageRule::Inner, size)));
    }
    // A triangle whose corners lie on centres: every tie rule draws the same squares.
    const Scene scene = oneTriangle({glm::dvec2(1.5, 1.5), glm::dvec2(1.5, 6.5), glm::dvec2(6.5, 1.5)}, size);
    Settings settings = settingsWith(CoverageRule::Conservative, size);
    const Frame first = draw(scene, settings);
    for (const TieRule tie : {TieRule::Inclusive, TieRule::Exclusive})
        for (const Stepping stepping : {Stepping::Incremental, Stepping::Direct}) {
            settings.tieRule = tie;
            settings.stepping = stepping;
            QCOMPARE(draw(scene, settings).coverage, first.coverage);
        }
}

QTEST_APPLESS_MAIN(TestCoverageRules)
#include "test_coverage_rules.moc"
