// The why-card of a pixel agrees with the picture, and names the number that decided.
#include "core/io/case_file.h"
#include "core/observe/step_text.h"
#include "core/questions/why.h"
#include "core/render/render.h"
#include "core/scenes/builtin_scenes.h"
#include "core/settings/mistakes.h"
#include "tests/seed.h"

#include <QJsonArray>
#include <QTest>

#include <random>

using namespace rasterlens;

namespace
{

Scene builtin(const char* name) { return *makeBuiltinScene(QLatin1String(name)).scene; }

Scene caseScene(const QByteArray& lines) { return *parseCase("size 8 8\n" + lines, QStringLiteral("test.case")).scene; }

// Counter-clockwise with y up; over the left lower half of the screen, over its right upper half.
constexpr char kLower[] = "tri -1 -1 0 1 1 0 0   1 -1 0 1 1 0 0   -1 1 0 1 1 0 0\n";
constexpr char kUpperBehind[] = "tri 1 1 .5 1 0 1 0   -1 1 .5 1 0 1 0   1 -1 .5 1 0 1 0\n";
constexpr char kWholeFar[] = "tri -1 -1 .9 1 0 0 1   3 -1 .9 1 0 0 1   -1 3 .9 1 0 0 1\n";

bool isClose(QRgb a, QRgb b, int steps)
{
    return std::abs(qRed(a) - qRed(b)) <= steps && std::abs(qGreen(a) - qGreen(b)) <= steps &&
           std::abs(qBlue(a) - qBlue(b)) <= steps;
}

} // namespace

class TestWhy : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void agreesWithThePicture();
    void edgeAndTieAreNamed();
    void depthAndOverwriting();
    void facesThatNeverGetThere();
    void edgeWalkingKnowsTheEdges();
    void backgroundHasNoFace();
    void jsonHasEveryRow();
};

void TestWhy::agreesWithThePicture()
{
    const unsigned seed = test::seedOfRun();
    std::mt19937 random(seed);
    const auto upTo = [&](int n) { return std::uniform_int_distribution<int>(0, n)(random); };
    std::vector<Scene> scenes;
    for (const BuiltinScene& scene : builtinScenes())
        if (Scene made = builtin(scene.name); made.mesh.faceCount() < 1000)
            scenes.push_back(std::move(made));
    int covered = 0;
    for (int i = 0; i < 500; ++i) {
        const Scene& scene = scenes[random() % scenes.size()];
        Settings settings = scene.defaults;
        settings.size = {1 + upTo(30), 1 + upTo(30)};
        for (const SettingsField& field : settingsFields())
            if (upTo(2) == 0)
                field.set(settings, field.minimum + upTo(field.maximum - field.minimum));
        if (upTo(3) == 0)
            settings.mistakes = {QString::fromLatin1(mistakes()[random() % mistakes().size()].id)};
        if (unsupported(scene, settings))
            continue;
        Frame frame;
        render(scene, settings, frame, {true, true, true});
        for (int k = 0; k < 5; ++k) {
            const int x = upTo(settings.size.width() - 1);
            const int y = upTo(settings.size.height() - 1);
            const WhyReport report = why(scene, settings, x, y);
            const QByteArray what =
                QStringLiteral("%1 of seed %2, %3 (%4, %5) ").arg(i).arg(seed).arg(scene.id).arg(x).arg(y).toUtf8() +
                settings.mistakes.join(QLatin1Char(' ')).toUtf8();
            const std::size_t at = std::size_t(y) * std::size_t(settings.size.width()) + std::size_t(x);
            const int tolerance = settings.algorithm == Algorithm::Tiled ? 1 : 0; // shown by edge-equation
            QVERIFY2(isClose(report.color, frame.image.pixel(x, y), tolerance), what.constData());
            if (!settings.mistakes.isEmpty())
                continue; // ids and coverage may then stand elsewhere
            QVERIFY2(frame.ids[at] == (report.visibleFace ? int(*report.visibleFace) : -1), what.constData());
            QVERIFY2(!report.visibleFace || report.find(*report.visibleFace) != nullptr, what.constData());
            const auto got = std::ranges::count_if(
                report.faces, [](const WhyFace& f) { return f.verdict >= WhyVerdict::FailedDepth; });
            // Pieces of a clipped face may both hit a sample under other rules; lines and columns may come back to one.
            const bool byCentres = settings.fill == Fill::Solid && settings.algorithm != Algorithm::ColumnFill;
            if (byCentres)
                QVERIFY2(got <= frame.coverage[at], what.constData());
            const bool onceEach = settings.tieRule == TieRule::TopLeft && settings.numberType == NumberType::Fixed &&
                                  settings.coverageRule == CoverageRule::Centre;
            if (byCentres && onceEach)
                QVERIFY2(got == frame.coverage[at], what.constData());
            covered += got > 0 ? 1 : 0;
        }
    }
    QVERIFY(covered > 100);
}

void TestWhy::edgeAndTieAreNamed()
{
    const Scene scene = caseScene(QByteArray(kLower) + kUpperBehind);
    // On the diagonal BC of the first face, which is its right edge; CB of the second is a left edge.
    const WhyReport tie = why(scene, scene.defaults, 3, 3);
    QCOMPARE(tie.faces.size(), std::size_t(2));
    const WhyFace& lost = tie.faces[0];
    QCOMPARE(lost.verdict, WhyVerdict::LostTie);
    QCOMPARE(lost.edge, 1);
    QCOMPARE(lost.edges[1].name, QStringLiteral("BC"));
    QCOMPARE(lost.edges[1].value, 0.0);
    QCOMPARE(lost.edges[1].side, EdgeSide::Neither);
    QCOMPARE(tie.faces[1].verdict, WhyVerdict::Written);
    QCOMPARE(tie.color, 0xff00ff00U);

    // One pixel to the right of the diagonal, whose edge function loses its height of 8 for each pixel.
    const WhyReport outside = why(scene, scene.defaults, 5, 4);
    QCOMPARE(outside.faces[0].verdict, WhyVerdict::OutsideEdge);
    QCOMPARE(outside.faces[0].edge, 1);
    QCOMPARE(whyText(outside, outside.faces[0]), QStringLiteral("face 0: outside edge BC (-8)"));
}

void TestWhy::depthAndOverwriting()
{
    const Scene scene = caseScene(QByteArray(kWholeFar) + kLower + kWholeFar);
    const WhyReport report = why(scene, scene.defaults, 1, 6);
    QCOMPARE(report.faces.size(), std::size_t(3));
    QCOMPARE(report.faces[0].verdict, WhyVerdict::Written);
    QCOMPARE(report.faces[0].overwrittenBy, std::optional(1U));
    QCOMPARE(report.faces[1].verdict, WhyVerdict::Written);
    QVERIFY(!report.faces[1].overwrittenBy);
    QCOMPARE(report.faces[2].verdict, WhyVerdict::FailedDepth);
    QCOMPARE(report.faces[2].fragment->storedDepth, 0.5F);
    QCOMPARE(report.faces[2].fragment->depth, 0.95F);
    QCOMPARE(whyText(report, report.faces[2]), QStringLiteral("face 2: failed the depth test: not 0.949999988 < 0.5"));
    QCOMPARE(report.visibleFace, std::optional(1U));
    QCOMPARE(report.depth, 0.5F);
}

void TestWhy::facesThatNeverGetThere()
{
    const QByteArray clockwise = "tri -1 -1 0 1 1 0 0   -1 1 0 1 1 0 0   1 -1 0 1 1 0 0\n";
    const QByteArray beyondFar = "tri -1 -1 2 1 1 0 0   1 -1 2 1 1 0 0   -1 1 2 1 1 0 0\n";
    const QByteArray noNumber = "tri nan 0 0 1 1 0 0   1 -1 2 1 1 0 0   -1 1 2 1 1 0 0\n";
    const QByteArray needle = "tri -1 -1 0 1 1 0 0   0 0 0 1 1 0 0   1 1 0 1 1 0 0\n";
    const QByteArray leftOfScreen = "tri -3 -1 0 1 1 0 0   -2 -1 0 1 1 0 0   -3 1 0 1 1 0 0\n";
    // Its part in the lower left lies before the near plane.
    const QByteArray slanted = "tri -1 -1 -3 1 1 0 0   1 -1 0 1 1 0 0   -1 1 0 1 1 0 0\n";
    const Scene scene = caseScene("cull back\n" + clockwise + beyondFar + noNumber + needle + leftOfScreen + slanted);
    const WhyReport report = why(scene, scene.defaults, 1, 6);
    QCOMPARE(report.find(0)->verdict, WhyVerdict::CulledBack);
    QCOMPARE(report.find(0)->facing->value, -32.0);
    QCOMPARE(report.find(1)->verdict, WhyVerdict::Rejected);
    QCOMPARE(planesText(report.find(1)->planes), QStringLiteral("far"));
    QCOMPARE(report.find(2)->verdict, WhyVerdict::NonFinite);
    QCOMPARE(report.find(3)->verdict, WhyVerdict::Degenerate);
    QVERIFY(report.find(4) == nullptr);
    QCOMPARE(report.find(5)->verdict, WhyVerdict::ClippedAway);
    QCOMPARE(planesText(report.find(5)->planes), QStringLiteral("near"));
}

void TestWhy::edgeWalkingKnowsTheEdges()
{
    const Scene scene = caseScene(QByteArray(kLower) + kUpperBehind);
    Settings walking = scene.defaults;
    walking.algorithm = Algorithm::EdgeWalking;
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x) {
            const WhyReport a = why(scene, scene.defaults, x, y);
            const WhyReport b = why(scene, walking, x, y);
            QCOMPARE(a.faces.size(), b.faces.size());
            for (std::size_t i = 0; i < a.faces.size(); ++i)
                QCOMPARE(whyText(a, a.faces[i]), whyText(b, b.faces[i]));
        }
}

void TestWhy::backgroundHasNoFace()
{
    const Scene scene = caseScene("tri -1 -1 0 1 1 0 0   -.5 -1 0 1 1 0 0   -1 -.5 0 1 1 0 0\n");
    const WhyReport report = why(scene, scene.defaults, 7, 0);
    QVERIFY(report.faces.empty());
    QVERIFY(!report.visibleFace);
    QCOMPARE(report.color, report.background);
}

void TestWhy::jsonHasEveryRow()
{
    const Scene scene = caseScene(QByteArray(kLower) + kUpperBehind);
    const QJsonObject json = toJson(why(scene, scene.defaults, 3, 3));
    QCOMPARE(json.value(QStringLiteral("visible_face")).toInt(-1), 1);
    const QJsonArray rows = json.value(QStringLiteral("faces")).toArray();
    QCOMPARE(rows.size(), 2);
    QCOMPARE(rows[0].toObject().value(QStringLiteral("verdict")).toString(), QStringLiteral("lost-tie"));
    QCOMPARE(rows[0].toObject().value(QStringLiteral("edges")).toArray().size(), 3);
}

QTEST_APPLESS_MAIN(TestWhy)
#include "test_why.moc"
