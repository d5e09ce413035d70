#include "core/scenes/load_scene.h"
// The catalogue of hard cases: every file says what must hold; the exact reference and the fixed-point rasterizers hold
// it, and floating point is seen to fail.
#include "core/io/case_file.h"
#include "core/truth/expectations.h"
#include "core/truth/hard_cases.h"
#include "core/truth/variants.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTest>

#include <algorithm>
#include <array>

using namespace rasterlens;

class TestHardCases : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void thereAreEnough();
    void cases_data();
    void cases();
    void theCatalogueIsBuiltIn();
    void allThreeDrawMostOfThem();
    void fixedPointPasses_data();
    void fixedPointPasses();
    void floatingPointFails_data();
    void floatingPointFails();
    void toleranceIsNotExactness();
    void everyKeyCanFail_data();
    void everyKeyCanFail();
    void malformedLinesSayWhy();
};

namespace
{

QStringList caseFiles() { return QDir(QStringLiteral(RASTERLENS_CASES)).entryList({QStringLiteral("*.case")}); }

Outcome referenceOutcome(const Scene& scene)
{
    return outcomeOf(caseTruth(scene, scene.defaults.samples), scene.background);
}

CaseVerdict verdict(const QString& name, const char* variant)
{
    const Scene scene = *loadScene(hardCasePath(name)).scene;
    const Settings settings = changedBy(*findVariant(QLatin1String(variant)), scene.defaults);
    return judgeCase(scene, caseTruth(scene, settings.samples), settings);
}

} // namespace

void TestHardCases::thereAreEnough() { QVERIFY(caseFiles().size() >= 100); }

void TestHardCases::cases_data()
{
    QTest::addColumn<QString>("path");
    for (const QString& file : caseFiles())
        QTest::newRow(qPrintable(file)) << QStringLiteral(RASTERLENS_CASES "/") + file;
}

void TestHardCases::cases()
{
    QFETCH(QString, path);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY2(file.size() < 60000, "a case file is to stay small");
    QVERIFY2(file.readLine().startsWith("# "), "the first line says what must hold");

    const SceneLoad load = loadCase(path);
    QVERIFY2(load.scene, load.diagnostics.empty() ? "no scene" : qPrintable(load.diagnostics.front().text()));
    QVERIFY(!load.scene->note.isEmpty());
    QVERIFY(!load.scene->expectations.empty());
    for (const Expectation& line : checkExpectations(load.scene->expectations, referenceOutcome(*load.scene)))
        QVERIFY2(line.holds,
                 qPrintable(QStringLiteral("expect %1 %2: found %3").arg(line.key, line.value, line.found)));
}

void TestHardCases::theCatalogueIsBuiltIn()
{
    QStringList files;
    for (const QString& name : hardCaseNames())
        files << name + QStringLiteral(".case");
    QCOMPARE(files, caseFiles());
}

/// The cases that edge equation, edge walking and tiled all draw, each of them right.
void TestHardCases::allThreeDrawMostOfThem()
{
    constexpr std::ptrdiff_t kFewest = 230;
    const QStringList names = hardCaseNames();
    const auto isRightInAll = [](const QString& name) {
        const Scene scene = *loadScene(hardCasePath(name)).scene;
        const ExactFrame truth = caseTruth(scene, scene.defaults.samples);
        return std::ranges::all_of(std::array{"edge-equation", "edge-walking", "tiled"}, [&](const char* id) {
            const CaseGrade grade =
                judgeCase(scene, truth, changedBy(*findVariant(QLatin1String(id)), scene.defaults)).grade;
            return grade == CaseGrade::Passes || grade == CaseGrade::PassesWithin;
        });
    };
    const std::ptrdiff_t right = std::ranges::count_if(names, isRightInAll);
    QVERIFY2(right >= kFewest, qPrintable(QStringLiteral("%1 of %2").arg(right).arg(names.size())));
}

void TestHardCases::fixedPointPasses_data()
{
    QTest::addColumn<QString>("name");
    for (const QString& name : hardCaseNames())
        QTest::newRow(qPrintable(name)) << name;
}

/// Whether a variant draws no such case. The tests test_multisample_answers and test_coverage_rules have the reasons.
static bool isRefused(const QLatin1String& variant, const Scene& scene)
{
    const Settings& s = scene.defaults;
    if (s.coverageRule != CoverageRule::Centre)
        return variant != QLatin1String("edge-equation");
    if (variant == QLatin1String("edge-walking-spans"))
        return patternSamples(s.samples) > 1;
    if (variant != QLatin1String("tiled"))
        return false;
    return !scene.mesh.lines.empty() || (patternSamples(s.samples) > 1 && s.attributeAt != AttributeAt::Centre);
}

void TestHardCases::fixedPointPasses()
{
    QFETCH(QString, name);
    const Scene scene = *loadScene(hardCasePath(name)).scene;
    const ExactFrame truth = caseTruth(scene, scene.defaults.samples);
    for (const char* id : {"edge-equation", "edge-walking", "edge-walking-spans", "tiled"}) {
        const CaseVerdict v = judgeCase(scene, truth, changedBy(*findVariant(QLatin1String(id)), scene.defaults));
        if (isRefused(QLatin1String(id), scene)) {
            QCOMPARE(v.grade, CaseGrade::Unsupported);
            continue;
        }
        QVERIFY2(v.grade == CaseGrade::Passes || v.grade == CaseGrade::PassesWithin,
                 qPrintable(QLatin1String(id) + QStringLiteral(": ") + textOf(v.reasons)));
    }
}

void TestHardCases::floatingPointFails_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("failing");
    QTest::addColumn<QString>("reason");
    const auto row = [](const char* name, const char* failing, const char* reason) {
        QTest::newRow(name) << QString::fromLatin1(name) << QString::fromLatin1(failing) << QString::fromLatin1(reason);
    };
    row("124_cancellation_one_unit_inside", "edge-equation-float32", "1 missing, first at (2605, 3238)");
    row("125_cancellation_one_unit_outside", "edge-equation-float32-direct", "1 extra");
    row("175_drift_float32_missing", "edge-equation-float32", "10 missing, first at (16382, 0)");
    row("176_drift_float32_extra", "edge-equation-float32", "2 extra, first at (13588, 1)");
    row("018_fan_96_slivers", "edge-walking-float32", "1 hit too often");
    row("119_perspective_ratio_10000", "edge-equation-affine", "expect color");
    row("161_snap_bits_0_mesh", "edge-equation-float64", "");
}

void TestHardCases::floatingPointFails()
{
    QFETCH(QString, name);
    QFETCH(QString, failing);
    QFETCH(QString, reason);
    const CaseVerdict v = verdict(name, qPrintable(failing));
    QCOMPARE(v.grade, CaseGrade::Fails);
    QVERIFY2(textOf(v.reasons).contains(reason), qPrintable(textOf(v.reasons)));
    // What drifts is the running sum: evaluated anew, the same numbers are right.
    if (name.contains(QLatin1String("drift")))
        QCOMPARE(verdict(name, "edge-equation-float32-direct").grade, CaseGrade::Passes);
}

void TestHardCases::toleranceIsNotExactness()
{
    const CaseVerdict depth = verdict(QStringLiteral("111_depth_one_ulp_apart"), "edge-equation");
    QCOMPARE(depth.grade, CaseGrade::PassesWithin);
    QVERIFY(depth.difference.otherFace > 0 && !depth.reasons.empty());
    const CaseVerdict snapped = verdict(QStringLiteral("164_exact_moves_one_pixel"), "edge-equation");
    QCOMPARE(snapped.grade, CaseGrade::PassesWithin);
    QVERIFY(snapped.difference.tolerated > 0);
    // Where there is only one face, another one is wrong whatever its depth.
    QCOMPARE(verdict(QStringLiteral("009_edges_grid_on_centres"), "edge-equation-bits-0").grade, CaseGrade::Fails);
}

void TestHardCases::everyKeyCanFail_data()
{
    QTest::addColumn<QString>("key");
    QTest::addColumn<QString>("right");
    QTest::addColumn<QString>("wrong");
    const auto row = [](const char* key, const char* right, const char* wrong) {
        QTest::newRow(key) << QString::fromLatin1(key) << QString::fromLatin1(right) << QString::fromLatin1(wrong);
    };
    row("covered", "15", "16");
    row("watertight", "0", "true");
    row("holes", "1", "0");
    row("hit_twice", "4", "0");
    row("max_count", "2", "1");
    row("covers", "1 3 2", "1 3 1");
    row("winner", "10 2", "10 3");
    row("pixel", "1 1 -1", "1 1 0");
    row("front_wins", "1", "2");
    row("depth", "0 0 0.5", "0 0 0.51");
    row("color", "0 0 255 0 0", "0 0 252 0 0");
    row("nonfinite", "2", "0");
    row("clip_vertices", "3", "4");
}

void TestHardCases::everyKeyCanFail()
{
    // A ring of eight faces round the hole (1, 1) of 4 x 4 pixels, two that are no faces, and two more over the
    // lowest row. As strips of four faces only the last shows nothing but its front.
    QByteArray text = "size 4 4\n";
    const auto rectangle = [&text](int x0, int y0, int x1, int y1, const char* z) {
        const auto x = [](int v) { return QByteArray::number(v / 2.0 - 1); };
        const auto y = [](int v) { return QByteArray::number(1 - v / 2.0); };
        const auto corner = [&](int cx, int cy) { return ' ' + x(cx) + ' ' + y(cy) + ' ' + z + " 1 1 0 0"; };
        text += "tri" + corner(x0, y0) + corner(x0, y1) + corner(x1, y1) + '\n';
        text += "tri" + corner(x0, y0) + corner(x1, y1) + corner(x1, y0) + '\n';
    };
    rectangle(0, 0, 4, 1, "0");
    rectangle(0, 1, 1, 4, "0");
    rectangle(2, 1, 4, 4, "0");
    rectangle(1, 2, 2, 4, "0");
    for (int i = 0; i < 2; ++i)
        text += "tri nan 0 0 1 0 0 0  0 0 0 1 0 0 0  0 1 0 1 0 0 0\n";
    text += "tri -1 -1 -0.5 1 1 0 0  1 -1 -0.5 1 1 0 0  1 -0.5 -0.5 1 1 0 0\n";
    text += "tri -1 -1 -0.5 1 1 0 0  1 -0.5 -0.5 1 1 0 0  -1 -0.5 -0.5 1 1 0 0\n";
    const SceneLoad load = parseCase(text, QStringLiteral("ring"));
    QVERIFY(load.scene);
    const Outcome outcome = referenceOutcome(*load.scene);
    QFETCH(QString, key);
    QFETCH(QString, right);
    QFETCH(QString, wrong);
    const Expectation holds = checkExpectations({{key, right}}, outcome).front();
    QVERIFY2(holds.holds, qPrintable(holds.found));
    QVERIFY(!checkExpectations({{key, wrong}}, outcome).front().holds);
}

void TestHardCases::malformedLinesSayWhy()
{
    const SceneLoad load = parseCase("size 4 4\n", QStringLiteral("empty"));
    const Outcome outcome = referenceOutcome(*load.scene);
    const auto found = [&](const char* key, const char* value) {
        const Expectation line =
            checkExpectations({{QString::fromLatin1(key), QString::fromLatin1(value)}}, outcome).front();
        return line.holds ? QStringLiteral("holds") : line.found;
    };
    QCOMPARE(found("coverd", "1"), QStringLiteral("not a key"));
    QCOMPARE(found("covered", "many"), QStringLiteral("1 numbers expected"));
    QCOMPARE(found("pixel", "1 2"), QStringLiteral("3 numbers expected"));
    QCOMPARE(found("pixel", "4 0 -1"), QStringLiteral("no such pixel in the window"));
    QCOMPARE(found("pixel", "3 3 -1"), QStringLiteral("holds"));
}

QTEST_APPLESS_MAIN(TestHardCases)
#include "test_hard_cases.moc"
