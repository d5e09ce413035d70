// Observers do not change pixels: the plain frame and the counted one are the same for every scene and any settings.
#include "core/render/count.h"
#include "core/render/draw.h"
#include "core/settings/mistakes.h"
#include "tests/support.h"

#include <QJsonDocument>
#include <QTest>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

/// A random value for every field of the table.
Settings randomSettings(Random& random, Settings settings)
{
    for (const SettingsField& field : settingsFields())
        field.set(settings, integer(random, field.minimum, field.maximum));
    settings.threads = integer(random, 0, 4);
    if (integer(random, 0, 3) > 0) // the other rules need one algorithm, one number type and one sample a pixel
        settings.coverageRule = CoverageRule::Centre;
    if (dividedEvery(settings.interpolation) > 1 && integer(random, 0, 3) > 0) // one algorithm has it
        settings.interpolation = Interpolation::Perspective;
    settings.size = {integer(random, 1, 60), integer(random, 1, 60)};
    return settings;
}

QString text(const Settings& settings)
{
    return QString::fromUtf8(QJsonDocument(toJson(settings)).toJson(QJsonDocument::Compact));
}

/// Built-in ones, and a soup that crosses every plane of the view volume.
std::vector<Scene> severalScenes(Random& random)
{
    std::vector<Scene> scenes;
    for (const char* name : {"cube", "letter-f", "behind-camera", "painter-cycle", "leaf", "floor"})
        scenes.push_back(*makeBuiltinScene(QLatin1String(name)).scene);
    std::vector<glm::vec4> positions;
    for (int i = 0; i < 90; ++i)
        positions.emplace_back(uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, -1.5, 1.5),
                               uniform(random, -0.5, 2));
    scenes.push_back(soup(positions));
    return scenes;
}

/// Asks for the end at the first covered sample, and counts what is covered all the same.
struct StopAtFirstSample : NullObserver {
    std::stop_source source;
    int fragments = 0;

    void onFragment(const Fragment&, float, bool)
    {
        source.request_stop();
        ++fragments;
    }
};

} // namespace

class TestObservers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void builtinScenes_data();
    void builtinScenes();
    void randomSettingsOfAllFields();
    void whatIsNotAskedForChangesNothing();
    void stoppingEndsTheWork();
    void stoppingEndsWithinAFace_data();
    void stoppingEndsWithinAFace();
};

void TestObservers::builtinScenes_data()
{
    QTest::addColumn<QString>("name");
    for (const BuiltinScene& scene : rasterlens::builtinScenes())
        QTest::newRow(scene.name) << QString::fromLatin1(scene.name);
}

void TestObservers::builtinScenes()
{
    QFETCH(QString, name);
    const Scene scene = *makeBuiltinScene(name).scene;
    Settings settings = scene.defaults;
    settings.size = settings.size.boundedTo({240, 180});
    Frame counted;
    const Statistics s = renderCounted(scene, settings, counted, kAllOutputs);
    QCOMPARE(difference(draw(scene, settings), counted), QString());
    // The counters say what the arrays show.
    QVERIFY(s.pixels.covered > 0);
    if (settings.samples == Samples::One) {
        std::uint64_t covered = 0;
        for (const std::uint16_t n : counted.coverage)
            covered += n;
        QCOMPARE(s.pixels.covered, covered);
    }
    QVERIFY(s.pixels.coveredTwice == 0);
}

void TestObservers::randomSettingsOfAllFields()
{
    Random random = seededRandom();
    const std::vector<Scene> scenes = severalScenes(random);
    int run = 0;
    int skipped = 0;
    for (int i = 0; i < 2500; ++i) {
        const Scene& scene = scenes[std::size_t(i) % scenes.size()];
        const Settings settings = randomSettings(random, scene.defaults);
        if (unsupported(scene, settings)) {
            ++skipped;
            continue;
        }
        ++run;
        Frame counted;
        const Statistics s = renderCounted(scene, settings, counted, kAllOutputs);
        const Frame plain = draw(scene, settings);
        const QString text = difference(plain, counted);
        QVERIFY2(text.isEmpty(), qPrintable(text + ::text(settings)));
        Frame later; // counted afterwards, without its colours
        later.image = QImage(3, 2, QImage::Format_RGB32);
        QVERIFY(countPicture(scene, settings, plain, later) == s);
        QVERIFY(later.image == counted.image && later.ids == counted.ids && later.depth == counted.depth);
        const Statistics::Faces& f = s.faces;
        QCOMPARE(f.submitted, f.rejected + f.culledBack + f.culledFront + f.degenerate + f.nonFinite + f.rasterized);
        QCOMPARE(s.pixels.covered, s.pixels.depthPassed + s.pixels.depthFailed);
        const bool oncePerSample = settings.algorithm == Algorithm::Tiled; // what is hidden later is not shaded
        QVERIFY(oncePerSample ? s.pixels.written <= s.pixels.depthPassed : s.pixels.written == s.pixels.depthPassed);
    }
    qInfo("%d settings drawn, %d not supported", run, skipped);
    QVERIFY(run > 500);
}

/// Depth, weights and attributes are computed only where the picture or another output reads them: a frame that is
/// asked for less holds the same, and so does one whose observer reads all of them.
void TestObservers::whatIsNotAskedForChangesNothing()
{
    Random random = seededRandom();
    const std::vector<Scene> scenes = severalScenes(random);
    int wrong = 0;
    for (int i = 0; i < 1500; ++i) {
        const Scene& scene = scenes[std::size_t(i) % scenes.size()];
        Settings settings = randomSettings(random, scene.defaults);
        if (i % 2 == 0) {
            const auto mistake = std::size_t(integer(random, 0, int(mistakes().size()) - 1));
            settings.mistakes = QStringList{QString::fromLatin1(mistakes()[mistake].id)};
        }
        if (unsupported(scene, settings))
            continue;
        wrong += i % 2 == 0;
        Frame all;
        (void)renderCounted(scene, settings, all, kAllOutputs);
        for (unsigned asked = 1; asked < 16; ++asked) {
            const Outputs outputs{(asked & 1) != 0, (asked & 2) != 0, (asked & 4) != 0, (asked & 8) != 0};
            Frame some;
            render(scene, settings, some, outputs);
            QVERIFY2((!outputs.depth || some.depth == all.depth) && (!outputs.ids || some.ids == all.ids) &&
                         (!outputs.coverage || some.coverage == all.coverage) &&
                         (!outputs.picture || some.image == all.image),
                     qPrintable(QStringLiteral("outputs %1 ").arg(asked) + ::text(settings)));
        }
    }
    QVERIFY(wrong > 100);
}

void TestObservers::stoppingEndsTheWork()
{
    const Scene scene = *makeBuiltinScene(QStringLiteral("teapot")).scene;
    Settings settings = scene.defaults;
    settings.size = {64, 48};
    std::stop_source stop;
    stop.request_stop();
    Frame frame;
    const Statistics s = renderCounted(scene, settings, frame, kAllOutputs, stop.get_token());
    QVERIFY(s.faces.submitted < scene.mesh.faceCount());
    QCOMPARE(frame.image.size(), settings.size);
}

void TestObservers::stoppingEndsWithinAFace_data()
{
    QTest::addColumn<Settings>("settings");
    for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking})
        for (const Stepping stepping : {Stepping::Direct, Stepping::Incremental})
            for (const bool mistaken : {false, true}) {
                Settings settings;
                settings.algorithm = algorithm;
                settings.stepping = stepping;
                if (mistaken)
                    settings.mistakes = {QStringLiteral("inside-either-sign")};
                QTest::addRow("%s%s%s", algorithm == Algorithm::EdgeEquation ? "equation" : "walking",
                              stepping == Stepping::Direct ? ", direct" : "", mistaken ? ", mistaken" : "")
                    << settings;
            }
}

/// One face may be all there is to a large picture: not more than the row at work is finished.
void TestObservers::stoppingEndsWithinAFace()
{
    QFETCH(Settings, settings);
    constexpr int kSide = 60;
    settings.size = {kSide, kSide};
    const Scene scene = clipScene({{-1, 1, 0, 1}, {-1, -3, 0, 1}, {3, 1, 0, 1}}, {0, 1, 2});
    StopAtFirstSample observer;
    Frame frame;
    drawScene(scene, resolve(settings, scene), frame, kAllOutputs, observer, observer.source.get_token());
    QVERIFY(observer.fragments > 0);
    QVERIFY2(observer.fragments <= kSide, qPrintable(QString::number(observer.fragments)));
}

QTEST_APPLESS_MAIN(TestObservers)
#include "test_observers.moc"
