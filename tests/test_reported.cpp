// Inputs that once broke something, as they were reported; they lie among the inputs that fuzzing begins with
// (tests/fuzz/corpus), which holds them under the sanitizers, too.
#include "core/io/npy.h"
#include "core/io/session.h"
#include "core/render/render.h"
#include "core/scenes/load_scene.h"
#include "core/truth/array_difference.h"
#include "core/truth/exact_reference.h"
#include "scene_files.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

QString reported(const char* name) { return QStringLiteral(RASTERLENS_CORPUS "/") + QLatin1String(name); }

QByteArray bytesOf(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

Frame drawn(const Scene& scene, Settings settings, Algorithm algorithm)
{
    settings.algorithm = algorithm;
    Frame frame;
    if (const auto why = unsupported(scene, settings))
        qFatal("%s", qPrintable(textOf(*why)));
    render(scene, settings, frame, {.depth = true, .ids = true, .coverage = true});
    return frame;
}

/// The largest difference of a channel.
int difference(const QImage& a, const QImage& b)
{
    int most = a.size() == b.size() ? 0 : 256;
    for (int y = 0; y < a.height() && most < 256; ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            most = std::max(
                {most, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
        }
    return most;
}

} // namespace

class TestReported : public QObject
{
    Q_OBJECT

    Folder m_files;

private Q_SLOTS:
    void clippingOfFarCornersIsExact_data()
    {
        QTest::addColumn<int>("covered");
        QTest::newRow("clip_1e8_extra_3") << 120;
        QTest::newRow("clip_1e10_missing_120") << 120;
        QTest::newRow("clip_extra_189") << 0;
    }

    void clippingOfFarCornersIsExact()
    {
        QFETCH(int, covered);
        const QByteArray text = bytesOf(reported("case/") + QLatin1String(QTest::currentDataTag()));
        const SceneLoad load = loadScene(m_files.write(QStringLiteral("a.case"), text));
        QVERIFY2(load.scene, qPrintable(textOf(load.diagnostics)));
        const Settings settings = load.scene->defaults;
        const ExactFrame exact = exactReference(*load.scene, settings);
        QCOMPARE(std::accumulate(exact.cover.begin(), exact.cover.end(), 0), covered);
        for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking, Algorithm::Tiled}) {
            const Frame frame = drawn(*load.scene, settings, algorithm);
            QVERIFY(std::equal(exact.cover.begin(), exact.cover.end(), frame.coverage.begin(), frame.coverage.end()));
        }
    }

    /// Without clipping what lies behind the eye is divided by its w as well.
    void withoutClippingAllAlgorithmsAgree()
    {
        const SceneLoad load = loadScene(m_files.write(QStringLiteral("w.case"), bytesOf(reported("case/w_zero"))));
        QVERIFY(load.scene);
        Settings settings = load.scene->defaults;
        for (const Clipping clipping : {Clipping::None, Clipping::NearFarReject}) {
            settings.clipping = clipping;
            const Frame expected = drawn(*load.scene, settings, Algorithm::EdgeEquation);
            for (const Algorithm algorithm : {Algorithm::EdgeWalking, Algorithm::Tiled}) {
                const Frame frame = drawn(*load.scene, settings, algorithm);
                QVERIFY(difference(expected.image, frame.image) <= 1);
                QCOMPARE(frame.ids, expected.ids);
            }
        }
    }

    /// The texture coordinate v is 0.5 at every centre: on the border of two texels.
    void texelsOnBordersAreTheSame()
    {
        const SceneLoad load = loadScene(m_files.write(QStringLiteral("t.obj"), bytesOf(reported("obj/texel_border"))));
        QVERIFY2(load.scene, qPrintable(textOf(load.diagnostics)));
        Settings settings = load.scene->defaults;
        settings.size = {20, 17};
        settings.shading = Shading::Texture;
        settings.textureFilter = TextureFilter::Nearest;
        const Frame expected = drawn(*load.scene, settings, Algorithm::EdgeEquation);
        for (const Algorithm algorithm : {Algorithm::EdgeWalking, Algorithm::Tiled})
            QVERIFY(difference(expected.image, drawn(*load.scene, settings, algorithm).image) <= 1);
    }

    void bilinearTexelsAreWritten()
    {
        const QByteArray all = bytesOf(reported("obj/bilinear_lane"));
        const QByteArray between = "\n#MTL\n";
        const qsizetype at = all.indexOf(between);
        QVERIFY(at > 0);
        m_files.write(QStringLiteral("m.mtl"), all.mid(at + between.size()));
        const SceneLoad load = loadScene(m_files.write(QStringLiteral("b.obj"), all.left(at)));
        QVERIFY2(load.scene, qPrintable(textOf(load.diagnostics)));
        Settings settings = load.scene->defaults;
        settings.size = {40, 30};
        settings.shading = Shading::Texture;
        settings.textureFilter = TextureFilter::Bilinear;
        const Frame expected = drawn(*load.scene, settings, Algorithm::EdgeEquation);
        for (const Simd simd : {Simd::Scalar, Simd::Auto}) {
            settings.simd = simd;
            const Frame frame = drawn(*load.scene, settings, Algorithm::Tiled);
            QVERIFY(difference(expected.image, frame.image) <= 1);
            QVERIFY(std::ranges::none_of(frame.depth, [](float depth) { return std::isnan(depth); }));
        }
    }

    void arraysWithoutRowsAreCompared()
    {
        const NpyRead read = readNpy(bytesOf(reported("npy/zero_rows")));
        QVERIFY2(read.array, "an array may be empty");
        const ArrayDifference found = difference(*read.array, *read.array);
        QCOMPARE(found.values, std::uint64_t(0));
        QCOMPARE(found.differing, std::uint64_t(0));
    }

    /// A near plane beyond the scene's far plane: the reason is told, the other settings are not dropped in silence.
    void settingsThatContradictTheSceneAreTold()
    {
        const SessionLoad load =
            loadSession(m_files.write(QStringLiteral("s.json"), bytesOf(reported("session/near_dropped"))));
        QVERIFY2(load.session, qPrintable(textOf(load.diagnostics)));
        const SceneLoad scene = loadScene(load.session->scene);
        const SettingsParse parse = settingsOf(*load.session, scene.scene->defaults);
        QVERIFY(!parse.errors.empty());
        QVERIFY2(textOf(parse.errors[0]).contains(QLatin1String("near plane")), qPrintable(textOf(parse.errors[0])));
    }
};

QTEST_GUILESS_MAIN(TestReported)
#include "test_reported.moc"
