// Multi-sampling in the tiled algorithm: every sample as edge-equation has it, on every instruction set.
#include "core/scenes/load_scene.h"
#include "tests/seed.h"
#include "tests/tiled_support.h"

#include <QTest>

#include <array>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr std::array kPatterns{Samples::Msaa2, Samples::Msaa4, Samples::Msaa8, Samples::Msaa16};

Settings settingsWith(Samples samples, QSize size)
{
    Settings settings;
    settings.samples = samples;
    settings.size = size;
    return settings;
}

} // namespace

class TestTiledPatterns : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawsHardTrianglesAlike_data();
    void drawsHardTrianglesAlike();
    void drawsEveryShadingAlike();
    void drawsEveryDepthTestAlike();
    void drawsFacesBeyondTheTargetAlike();
};

void TestTiledPatterns::drawsHardTrianglesAlike_data()
{
    QTest::addColumn<int>("samples");
    for (const Samples samples : kPatterns)
        QTest::addRow("msaa%d", patternSamples(samples)) << int(samples);
}

void TestTiledPatterns::drawsHardTrianglesAlike()
{
    QFETCH(int, samples);
    const unsigned seed = seedOfRun();
    for (int i = 0; i < casesOfBuild(12); ++i) {
        std::mt19937 random(seed + unsigned(i));
        const QSize size(1 + int(random() % 200), 1 + int(random() % 200));
        const Scene scene = soup(random, size, 1 + int(random() % 150));
        Settings settings = settingsWith(static_cast<Samples>(samples), size);
        settings.culling = Culling::None;
        settings.subpixelBits = i % 3 == 0 ? int(random() % 9) : 8;
        const QString d = compareAll(scene, settings, simds(), {1, 2});
        QVERIFY2(d.isEmpty(), qPrintable(QStringLiteral("RASTERLENS_SEED=%1: %2").arg(seed + unsigned(i)).arg(d)));
    }
}

void TestTiledPatterns::drawsEveryShadingAlike()
{
    std::mt19937 random(seedOfRun());
    const QSize size(150, 90);
    Scene scene = soup(random, size, 100);
    dress(scene, random);
    for (const Shading shading :
         {Shading::Gouraud, Shading::Flat, Shading::RandomFlat, Shading::Texture, Shading::Phong, Shading::Depth,
          Shading::Normals, Shading::Uv, Shading::Overdraw, Shading::TriangleId})
        for (const TextureFilter filter : {TextureFilter::Nearest, TextureFilter::Bilinear, TextureFilter::Trilinear}) {
            if (filter != TextureFilter::Nearest && shading != Shading::Texture && shading != Shading::Phong)
                continue;
            Settings settings = settingsWith(Samples::Msaa4, size);
            settings.shading = shading;
            settings.textureFilter = filter;
            const QString d = compareAll(scene, settings, simds(), {2});
            QVERIFY2(d.isEmpty(),
                     qPrintable(QStringLiteral("shading %1, filter %2: %3").arg(int(shading)).arg(int(filter)).arg(d)));
        }
}

void TestTiledPatterns::drawsEveryDepthTestAlike()
{
    std::mt19937 random(seedOfRun());
    const QSize size(100, 80);
    const Scene scene = soup(random, size, 80);
    for (const DepthTest test : {DepthTest::Less, DepthTest::LessEqual, DepthTest::Greater, DepthTest::GreaterEqual,
                                 DepthTest::Always, DepthTest::None})
        for (const DepthFormat format : {DepthFormat::Float32, DepthFormat::Unorm16})
            for (const bool reversed : {false, true}) {
                Settings settings = settingsWith(Samples::Msaa8, size);
                settings.depthTest = test;
                settings.depthFormat = format;
                settings.reversedZ = reversed;
                const QString d = compareAll(scene, settings, {Simd::Auto, Simd::Scalar}, {1});
                QVERIFY2(d.isEmpty(), qPrintable(d));
            }
}

/// Triangles that end within half a pixel of the target: their samples may lie in pixels whose centres they miss.
void TestTiledPatterns::drawsFacesBeyondTheTargetAlike()
{
    std::mt19937 random(seedOfRun());
    const QSize size(65, 33);
    for (const Samples samples : kPatterns) {
        Scene scene = clipScene(size);
        std::uniform_real_distribution<double> near(-1, 1);
        for (int i = 0; i < 60; ++i) {
            const double right = i % 2 == 0 ? 0 : size.width();
            const double bottom = i % 4 < 2 ? 0 : size.height();
            std::array<glm::vec4, 3> corners;
            for (glm::vec4& corner : corners)
                corner = fromScreen(right + near(random), bottom + near(random), 0.5 + near(random) / 4, 1, size);
            addTriangle(scene, corners, random);
        }
        Settings settings = settingsWith(samples, size);
        settings.culling = Culling::None;
        const QString d = compareAll(scene, settings, simds(), {1});
        QVERIFY2(d.isEmpty(), qPrintable(d));
    }
}

QTEST_APPLESS_MAIN(TestTiledPatterns)
#include "test_tiled_patterns.moc"
