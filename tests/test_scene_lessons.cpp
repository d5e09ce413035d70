// Every built-in scene shows what its note promises: the setting it is made for changes the picture, or keeps it right.
#include "core/render/render.h"
#include "core/scenes/builtin_scenes.h"

#include <QTest>

using namespace rasterlens;

namespace
{

Scene make(const QString& name)
{
    Scene scene = *makeBuiltinScene(name).scene;
    // Large pictures at half their size: the same lesson in less time.
    if (scene.defaults.size.width() > 1000)
        scene.defaults.size /= 2;
    return scene;
}

struct Shot {
    Frame frame;
    Statistics statistics;
};

template <typename Change>
Shot draw(const Scene& scene, Change change)
{
    Settings settings = scene.defaults;
    change(settings);
    Shot shot;
    shot.statistics = renderCounted(scene, settings, shot.frame, {.ids = true});
    return shot;
}

Shot draw(const Scene& scene)
{
    return draw(scene, [](Settings&) {});
}

int differentPixels(const Shot& a, const Shot& b)
{
    int count = 0;
    for (int y = 0; y < a.frame.image.height(); ++y)
        for (int x = 0; x < a.frame.image.width(); ++x)
            count += a.frame.image.pixel(x, y) != b.frame.image.pixel(x, y);
    return count;
}

int emptyPixels(const Shot& shot) { return static_cast<int>(std::ranges::count(shot.frame.ids, -1)); }

int pixelsOfFace(const Shot& shot, int face) { return static_cast<int>(std::ranges::count(shot.frame.ids, face)); }

} // namespace

class TestSceneLessons : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void squareIsCoveredOnce();
    void triangle600CoversWhatItShould();
    void fanIsCoveredOnce();
    void depthTestHidesWhatIsBehind_data();
    void depthTestHidesWhatIsBehind();
    void painterFails_data();
    void painterFails();
    void tilesBreakUnderAffineInterpolation();
    void coveringFillsTheScreen();
    void nothingIsMissingAroundTheCamera_data();
    void nothingIsMissingAroundTheCamera();
    void guardBandClipsLess();
    void leafLosesItsBack();
    void closedSolidsLoseNothingByCulling_data();
    void closedSolidsLoseNothingByCulling();
    void panelFightsWithTheWall();
    void markersHaveTheColourOfTheBoard();
};

void TestSceneLessons::squareIsCoveredOnce()
{
    const Scene scene = make("square-diagonal");
    const Shot right = draw(scene);
    QCOMPARE(emptyPixels(right), 0);
    QCOMPARE(right.statistics.pixels.covered, 64U);
    QCOMPARE(right.statistics.pixels.coveredTwice, 0U);
    const Shot inclusive = draw(scene, [](Settings& s) { s.tieRule = TieRule::Inclusive; });
    QCOMPARE(inclusive.statistics.pixels.coveredTwice, 8U);
    const Shot exclusive = draw(scene, [](Settings& s) { s.tieRule = TieRule::Exclusive; });
    QCOMPARE(emptyPixels(exclusive), 8);
}

void TestSceneLessons::triangle600CoversWhatItShould()
{
    // All three edges run through pixel centres. Counted in whole numbers: 39,800 centres inside, 300 owned on edges.
    const Shot shot = draw(make("triangle-600"));
    QCOMPARE(shot.statistics.pixels.covered, 40'100U);
    QCOMPARE(shot.statistics.pixels.coveredTwice, 0U);
}

void TestSceneLessons::fanIsCoveredOnce()
{
    const Scene scene = make("fan");
    const Shot right = draw(scene);
    QCOMPARE(right.statistics.pixels.coveredTwice, 0U);
    QVERIFY(right.frame.ids[32 * 65 + 32] >= 0);
    const Shot exclusive = draw(scene, [](Settings& s) { s.tieRule = TieRule::Exclusive; });
    QCOMPARE(exclusive.frame.ids[32 * 65 + 32], -1);
}

void TestSceneLessons::depthTestHidesWhatIsBehind_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("leastDifference");
    QTest::newRow("games101") << QStringLiteral("games101") << 1000;
    QTest::newRow("head") << QStringLiteral("head") << 1000;
    QTest::newRow("torus-knot") << QStringLiteral("torus-knot") << 1000;
}

void TestSceneLessons::depthTestHidesWhatIsBehind()
{
    QFETCH(int, leastDifference);
    QFETCH(QString, name);
    const Scene scene = make(name);
    const Shot without = draw(scene, [](Settings& s) { s.visibility = Visibility::SubmissionOrder; });
    QVERIFY(differentPixels(draw(scene), without) > leastDifference);
}

void TestSceneLessons::painterFails_data()
{
    QTest::addColumn<QString>("name");
    QTest::addColumn<int>("leastDifference");
    QTest::newRow("painter-cycle") << QStringLiteral("painter-cycle") << 300;
    QTest::newRow("piercing") << QStringLiteral("piercing") << 1000;
}

void TestSceneLessons::painterFails()
{
    QFETCH(int, leastDifference);
    QFETCH(QString, name);
    const Scene scene = make(name);
    const Shot painter = draw(scene, [](Settings& s) { s.visibility = Visibility::Painter; });
    QVERIFY(differentPixels(draw(scene), painter) > leastDifference);
}

void TestSceneLessons::tilesBreakUnderAffineInterpolation()
{
    const Scene scene = make("tile-square");
    const Shot affine = draw(scene, [](Settings& s) { s.interpolation = Interpolation::Affine; });
    QVERIFY(differentPixels(draw(scene), affine) > 10'000);
}

void TestSceneLessons::coveringFillsTheScreen()
{
    const Scene scene = make("covering");
    QCOMPARE(emptyPixels(draw(scene)), 0);
    const Shot rejected = draw(scene, [](Settings& s) { s.clipping = Clipping::AnyVertexInside; });
    QCOMPARE(pixelsOfFace(rejected, 0), 0);
    QVERIFY(pixelsOfFace(rejected, 1) > 0);
}

void TestSceneLessons::nothingIsMissingAroundTheCamera_data()
{
    QTest::addColumn<QString>("name");
    QTest::newRow("floor") << QStringLiteral("floor");
    QTest::newRow("tunnel") << QStringLiteral("tunnel");
    QTest::newRow("behind-camera") << QStringLiteral("behind-camera");
}

void TestSceneLessons::nothingIsMissingAroundTheCamera()
{
    QFETCH(QString, name);
    const Scene scene = make(name);
    const QPoint bottom(scene.defaults.size.width() * 2 / 3, scene.defaults.size.height() - 1);
    const auto idAt = [&](const Shot& shot) {
        return shot.frame.ids[static_cast<std::size_t>(bottom.y() * scene.defaults.size.width() + bottom.x())];
    };
    QVERIFY(idAt(draw(scene)) >= 0);
    QCOMPARE(idAt(draw(scene, [](Settings& s) { s.clipping = Clipping::NearFarReject; })), -1);
}

void TestSceneLessons::guardBandClipsLess()
{
    const Scene scene = make("edge-guardband");
    const Shot frustum = draw(scene);
    const Shot guardBand = draw(scene, [](Settings& s) { s.clipping = Clipping::GuardBand; });
    QCOMPARE(frustum.statistics.faces.clipped, scene.mesh.faceCount());
    QVERIFY(guardBand.statistics.faces.clipped > 0);
    QVERIFY(guardBand.statistics.faces.clipped < frustum.statistics.faces.clipped / 2);
}

void TestSceneLessons::leafLosesItsBack()
{
    const Scene scene = make("leaf");
    const Shot whole = draw(scene, [](Settings& s) { s.culling = Culling::None; });
    QVERIFY(differentPixels(draw(scene), whole) > 2000);
}

void TestSceneLessons::closedSolidsLoseNothingByCulling_data()
{
    QTest::addColumn<QString>("name");
    for (const char* name : {"cube", "sphere", "letter-f", "torus-knot", "head"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void TestSceneLessons::closedSolidsLoseNothingByCulling()
{
    QFETCH(QString, name);
    const Scene scene = make(name);
    const Shot culled = draw(scene);
    const Shot whole = draw(scene, [](Settings& s) { s.culling = Culling::None; });
    QVERIFY(culled.statistics.faces.culledBack > 0);
    // Culling keeps the silhouette: no pixel loses its surface.
    QCOMPARE(emptyPixels(culled), emptyPixels(whole));
}

void TestSceneLessons::panelFightsWithTheWall()
{
    const Scene scene = make("z-fighting");
    // Without a depth test the panel, sent last, is whole.
    const Shot truth = draw(scene, [](Settings& s) { s.visibility = Visibility::SubmissionOrder; });
    const int wrong = differentPixels(draw(scene), truth);
    QVERIFY2(wrong > 500, qPrintable(QString::number(wrong)));
    const Shot reversed = draw(scene, [](Settings& s) {
        s.reversedZ = true;
        s.clipZ = ClipZ::D3d;
    });
    QCOMPARE(differentPixels(reversed, truth), 0);
}

void TestSceneLessons::markersHaveTheColourOfTheBoard()
{
    const Scene scene = make("four-z");
    const auto redAt = [](const Shot& shot, int x, int y) { return qRed(shot.frame.image.pixel(x, y)); };
    const Shot right = draw(scene);
    const Shot affine = draw(scene, [](Settings& s) { s.interpolation = Interpolation::Affine; });
    // Thirds of the board, which is 481 pixels wide about pixel 320: first the board, then the marker above it.
    for (const int x : {240, 400}) {
        QVERIFY(std::abs(redAt(right, x, 240) - redAt(right, x, 120)) <= 1);
        QVERIFY(std::abs(redAt(affine, x, 240) - redAt(affine, x, 120)) > 20);
    }
    QCOMPARE(redAt(right, 320, 240), 232);
}

QTEST_GUILESS_MAIN(TestSceneLessons)
#include "test_scene_lessons.moc"
