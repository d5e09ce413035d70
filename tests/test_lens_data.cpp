// The numbers overlays and boards show: edge values as text, vertices in every space, curves, the race.
#include "core/io/case_file.h"
#include "core/observe/names.h"
#include "core/observe/step_text.h"
#include "core/questions/race.h"
#include "core/questions/vertex_table.h"
#include "core/render/steps.h"
#include "core/scenes/builtin_scenes.h"
#include "core/truth/perspective_curves.h"

#include <QRegularExpression>
#include <QTest>

#include <cmath>

using namespace rasterlens;

namespace
{

Scene builtin(const char* name) { return *makeBuiltinScene(QLatin1String(name)).scene; }

bool isNear(double a, double b, double tolerance = 1e-12) { return std::abs(a - b) <= tolerance; }

} // namespace

class TestLensData : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void edgeValuesAsText();
    void everyEventHasText();
    void planesAreToldAsTheyCut();
    void verticesInEverySpace();
    void snappedVerticesAreThoseOfTheLog();
    void perspectiveCurves();
    void fourZBoard();
    void raceCountsEverySample();
    void racersAgreeUnderFixedPoint();
};

void TestLensData::edgeValuesAsText()
{
    QCOMPARE(edgeValueText(-229376, 65536), QStringLiteral("-3.5"));
    QCOMPARE(edgeValueText(0, 65536), QStringLiteral("0"));
    QCOMPARE(edgeValueText(1, 65536), QStringLiteral("0.0000152587890625"));
    QCOMPARE(edgeValueText(-1, 65536), QStringLiteral("-0.0000152587890625"));
    QCOMPARE(edgeValueText(65536.0 * 12 + 32768, 65536), QStringLiteral("12.5"));
    QCOMPARE(edgeValueText(0.1, 1), QStringLiteral("0.1"));
    QCOMPARE(edgeValueText(std::nan(""), 65536), QStringLiteral("nan"));
}

void TestLensData::everyEventHasText()
{
    Settings settings;
    for (const char* name : {"tunnel", "lines", "piercing"})
        for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking}) {
            const Scene scene = builtin(name);
            settings = scene.defaults;
            settings.size = {16, 12};
            settings.algorithm = algorithm;
            settings.clipping = algorithm == Algorithm::EdgeWalking ? Clipping::CohenSutherland : Clipping::Frustum;
            const auto log = renderSteps(scene, settings);
            for (std::size_t i = 0; i < log->size(); ++i) {
                const QString id = QLatin1String(stepKindId(log->event(i).kind));
                QVERIFY(stepText(*log, i).startsWith(QStringLiteral("%1 %2").arg(i).arg(id)));
                QCOMPARE(stepJson(*log, i).value(QStringLiteral("event")).toString(), id);
            }
        }
}

/// `x <= 1023 w` where the sides of a guard band cut: a corner made there has x = 1023 w.
void TestLensData::planesAreToldAsTheyCut()
{
    const Scene scene = builtin("behind-camera");
    static const QRegularExpression side(QStringLiteral("^([xy]) [\u2264\u2265] (\u2212?)(?:([0-9.]+) )?w$"));
    for (const Clipping clipping : {Clipping::Frustum, Clipping::GuardBand, Clipping::CohenSutherland}) {
        Settings settings = scene.defaults;
        settings.size = {64, 48};
        settings.clipping = clipping;
        const auto log = renderSteps(scene, settings);
        int cuts = 0;
        for (const std::uint32_t i : log->eventsOf(StepKind::ClipPlane)) {
            const ClipStep& step = log->payload<ClipStep>(log->event(i));
            const auto told = side.match(clipPlaneFormula(step.plane, log->rules()));
            if (!told.hasMatch())
                continue; // near or far
            const double factor =
                (told.captured(2).isEmpty() ? 1 : -1) * (told.captured(3).isEmpty() ? 1 : told.captured(3).toDouble());
            QCOMPARE(std::abs(factor) == 1, clipping == Clipping::Frustum);
            for (const ClipCut& cut : step.cuts) {
                ++cuts;
                const glm::dvec4 p = step.after[std::size_t(cut.corner)].positionClip;
                const double coordinate = told.captured(1) == QLatin1String("x") ? p.x : p.y;
                QVERIFY(std::abs(coordinate - factor * p.w) <= 1e-5 * std::abs(coordinate));
            }
        }
        QVERIFY(cuts >= 2);
    }
}

void TestLensData::verticesInEverySpace()
{
    const Scene scene = builtin("cube");
    Settings settings = scene.defaults;
    settings.size = {200, 100};
    settings.subpixelBits = 4;
    for (std::uint32_t face = 0; face < scene.mesh.faceCount(); ++face)
        for (const VertexRow& row : vertexTable(scene, settings, face)) {
            QCOMPARE(glm::vec4(row.object), scene.mesh.vertices[row.meshVertex].position);
            QVERIFY(isNear(row.clip.w, -row.view.z, 1e-5)); // w of a perspective is the distance along the gaze
            QVERIFY(isNear(row.screen.x, (row.clip.x / row.clip.w + 1) * 100, 1e-9));
            QVERIFY(isNear(row.screen.y, (1 - row.clip.y / row.clip.w) * 50, 1e-9));
            QCOMPARE(row.snapped.x * 16, std::round(row.snapped.x * 16));
            QVERIFY(isNear(row.snapped.x, row.screen.x, 1.0 / 32 + 1e-9));
            QVERIFY(isNear(row.snapped.y, row.screen.y, 1.0 / 32 + 1e-9));
            QVERIFY(isNear(row.depth, row.ndc.z * 0.5 + 0.5, 1e-9));
            QCOMPARE(row.outside, 0U);
        }
    const Scene outside =
        *parseCase("size 8 8\ntri -3 0 0 1 1 1 1  0 2 0 1 1 1 1  2 -2 -5 1 1 1 1\n", QStringLiteral("outside.case"))
             .scene;
    const auto rows = vertexTable(outside, outside.defaults, 0);
    QCOMPARE(planesText(rows[0].outside), QStringLiteral("left"));
    QCOMPARE(planesText(rows[1].outside), QStringLiteral("top"));
    QCOMPARE(planesText(rows[2].outside), QStringLiteral("right+bottom+near"));
    QCOMPARE(rows[2].screenRegion, kRegionRight | kRegionBelow);
}

void TestLensData::snappedVerticesAreThoseOfTheLog()
{
    const Scene scene = builtin("triangle");
    Settings settings = scene.defaults;
    settings.size = {33, 21};
    settings.samples = Samples::Grid2;
    const auto log = renderSteps(scene, settings);
    const auto rows = vertexTable(scene, settings, 0);
    const StepTriangle& triangle = *log->triangle(log->event(log->eventsOf(StepKind::Triangle)[0]));
    for (std::size_t i = 0; i < 3; ++i)
        QVERIFY(rows[i].snapped * 2.0 == triangle.screen.vertices[i].position);
}

void TestLensData::perspectiveCurves()
{
    QVERIFY(isNear(spaceFraction(0.5, 1, 10), 1.0 / 11));
    QVERIFY(isNear(spaceFraction(0.25, 3, 3), 0.25));
    const auto curve = spaceFractionCurve(1, 4, 11);
    QCOMPARE(curve.size(), std::size_t(11));
    QCOMPARE(curve.front().y, 0.0);
    QCOMPARE(curve.back().y, 1.0);
    for (const CurvePoint& p : curve) // the point in space is seen where it should be: 1/z is linear on the screen
        QVERIFY(isNear(1 / std::lerp(1.0, 4.0, p.y), std::lerp(1.0, 0.25, p.x)));
    QVERIFY(isNear(squeezedDepth(1, 1, 9), 1));
    QVERIFY(isNear(squeezedDepth(9, 1, 9), 9));
    QVERIFY(squeezedDepth(5, 1, 9) > 5);
    QVERIFY(isNear(squeezedDepthCurve(1, 9, 3)[1].y, 10 - 9.0 / 5));
}

void TestLensData::fourZBoard()
{
    const FourZ board = fourZ(0.1, 50, 1, 10, 0.5);
    const auto rounded = [](double v) { return QString::number(v, 'f', 4); };
    QCOMPARE(rounded(board.ndc.truth), QStringLiteral("0.8938"));
    QCOMPARE(rounded(board.ndc.linear), QStringLiteral("0.8938"));
    QCOMPARE(rounded(board.ndc.corrected), QStringLiteral("0.8200"));
    QVERIFY(isNear(board.ndc.linearError, 0));
    QVERIFY(isNear(board.view.truth, 20.0 / 11));
    QVERIFY(isNear(board.view.corrected, 20.0 / 11));
    QVERIFY(isNear(board.view.linear, 5.5));
    QVERIFY(isNear(board.view.linearError, 5.5 - 20.0 / 11));
}

void TestLensData::raceCountsEverySample()
{
    const Scene scene = builtin("square-diagonal");
    const AlgorithmRace race = raceAlgorithms(scene, scene.defaults, 0);
    // The box of 8 x 8 samples, of which the lower half without its 8 ties is covered: 28.
    QCOMPARE(race.equation.total.candidates, std::uint64_t(64));
    QCOMPARE(race.walking.total.candidates, std::uint64_t(28));
    // Incremental: three additions a sample, three a row after the first, 6 + 9 to begin with.
    QCOMPARE(race.equation.total.additions, std::uint64_t(64 * 3 + 7 * 3 + 15));
    QCOMPARE(race.equation.total.multiplications, std::uint64_t(12));
    QCOMPARE(race.equation.total.divisions, std::uint64_t(0));
    // One half only, its two edges: a slope and a start each.
    QCOMPARE(race.walking.total.divisions, std::uint64_t(4));
    // The side of the long edge, two edges to begin with, and both stepped and rounded in eight rows.
    QCOMPARE(race.walking.total.additions, std::uint64_t(4 + 2 * 5 + 8 * 2 * 3));
    for (const RaceLane* lane : {&race.walking, &race.equation})
        for (std::size_t i = 0; i < lane->ticks.size(); ++i)
            QCOMPARE(lane->ticks[i].soFar.candidates, std::uint64_t(i + 1));
}

void TestLensData::racersAgreeUnderFixedPoint()
{
    const Scene scene = builtin("piercing");
    Settings settings = scene.defaults;
    settings.size = {61, 47};
    for (std::uint32_t face = 0; face < 2; ++face) {
        const AlgorithmRace race = raceAlgorithms(scene, settings, face);
        QVERIFY(race.walking.ticks.size() > 50);
        QVERIFY(race.onlyWalking.empty());
        QVERIFY(race.onlyEquation.empty());
    }
    settings.tieRule = TieRule::Inclusive;
    QVERIFY(raceAlgorithms(scene, settings, 0).onlyEquation.empty());
}

QTEST_APPLESS_MAIN(TestLensData)
#include "test_lens_data.moc"
