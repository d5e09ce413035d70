// Depths of the tiled algorithm that are not the usual ones: tests of equality, bias, range, depth clamp and two
// passes, as edge-equation has them, on every instruction set.
#include "core/pipeline/depth_test.h"
#include "core/tiled/exact_path.h"
#include "tests/seed.h"
#include "tests/tiled_support.h"

#include <QTest>

#include <array>
#include <bit>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

double uniform(std::mt19937& random, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// Draws each face of the scene once more in a second pass: the same triangle with its corners in another order, and
/// every third one a little nearer.
void addSecondPass(Scene& scene)
{
    const std::size_t faces = scene.mesh.faceCount();
    scene.secondPassFrom = static_cast<std::uint32_t>(faces);
    for (std::size_t face = 0; face < faces; ++face)
        for (const std::size_t k : {1, 2, 0}) {
            MeshVertex vertex = scene.mesh.vertices[scene.mesh.indices[3 * face + k]];
            vertex.position.z -= face % 3 == 0 ? 0.01F : 0.0F;
            scene.mesh.indices.push_back(static_cast<std::uint32_t>(scene.mesh.vertices.size()));
            scene.mesh.vertices.push_back(vertex);
        }
    if (!scene.mesh.faceMaterial.empty())
        scene.mesh.faceMaterial.insert(scene.mesh.faceMaterial.end(), scene.mesh.faceMaterial.begin(),
                                       scene.mesh.faceMaterial.end());
}

DepthBias randomBias(std::mt19937& random)
{
    const double clamp = random() % 3 == 0 ? uniform(random, -0.1, 0.1) : 0;
    return {uniform(random, -100, 100), random() % 3 == 0 ? 0 : uniform(random, -4, 4), clamp};
}

DepthRange randomRange(std::mt19937& random)
{
    constexpr std::array kRanges{DepthRange{0.25, 0.75}, DepthRange{0.9, 0.1}, DepthRange{0.5, 0.5}, DepthRange{1, 0},
                                 DepthRange{0, 0.1}};
    return kRanges[random() % kRanges.size()];
}

template <class Field, std::size_t kCount>
void choose(std::mt19937& random, Field& field, const std::array<Field, kCount>& values)
{
    field = values[random() % kCount];
}

} // namespace

class TestTiledDepth : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void everyComparisonIsOneRunOfDifferences();
    void drawsEveryDepthAlike_data();
    void drawsEveryDepthAlike();
};

void TestTiledDepth::everyComparisonIsOneRunOfDifferences()
{
    const std::array depths{0.0F,  std::numeric_limits<float>::denorm_min(),
                            0.25F, std::nextafter(0.25F, 1.0F),
                            0.5F,  std::nextafter(1.0F, 0.0F),
                            1.0F};
    Rules rules;
    for (const DepthCompare compare :
         {DepthCompare::Less, DepthCompare::LessEqual, DepthCompare::Equal, DepthCompare::GreaterEqual,
          DepthCompare::Greater, DepthCompare::NotEqual, DepthCompare::Always})
        for (const bool tested : {true, false}) {
            rules.depthCompare = compare;
            rules.depthTested = tested;
            const tiled::PassingDifferences passing = tiled::passingDifferences(rules, 0);
            for (const float depth : depths)
                for (const float stored : depths)
                    QCOMPARE(passing.holds(std::bit_cast<std::int32_t>(depth), std::bit_cast<std::int32_t>(stored)),
                             !tested || depthPasses(depth, stored, compare));
        }
    // The first of two passes has a comparison of its own.
    rules.depthTested = true;
    rules.depthCompare = DepthCompare::Equal;
    rules.firstPassFaces = 1;
    QVERIFY(tiled::passingDifferences(rules, 0).holds(1, 2) && !tiled::passingDifferences(rules, 0).holds(2, 2));
    QVERIFY(tiled::passingDifferences(rules, 1).holds(2, 2) && !tiled::passingDifferences(rules, 1).holds(1, 2));
}

void TestTiledDepth::drawsEveryDepthAlike_data()
{
    QTest::addColumn<int>("samples");
    for (const Samples samples : {Samples::One, Samples::Grid2, Samples::Msaa4, Samples::Msaa8})
        QTest::addRow("%s", qPrintable(valueId(*findSettingsField("samples"),
                                               [&] {
                                                   Settings settings;
                                                   settings.samples = samples;
                                                   return settings;
                                               }())))
            << int(samples);
}

void TestTiledDepth::drawsEveryDepthAlike()
{
    QFETCH(int, samples);
    const unsigned seed = seedOfRun();
    std::size_t secondPassSeen = 0;
    for (int i = 0; i < casesOfBuild(30); ++i) {
        std::mt19937 random(seed + unsigned(i));
        const QSize size(1 + int(random() % 150), 1 + int(random() % 150));
        Scene scene = soup(random, size, 1 + int(random() % 60));
        if (random() % 2 == 0)
            dress(scene, random);
        Settings settings;
        settings.size = size;
        settings.samples = static_cast<Samples>(samples);
        settings.culling = Culling::None;
        choose(random, settings.shading,
               std::array{Shading::Gouraud, Shading::Texture, Shading::Depth, Shading::Phong});
        choose(random, settings.depthTest,
               std::array{DepthTest::Less, DepthTest::LessEqual, DepthTest::Equal, DepthTest::GreaterEqual,
                          DepthTest::Greater, DepthTest::NotEqual, DepthTest::Always});
        choose(random, settings.depthFormat,
               std::array{DepthFormat::Float32, DepthFormat::Float32, DepthFormat::Unorm24, DepthFormat::Unorm8});
        choose(random, settings.clipping,
               std::array{Clipping::Frustum, Clipping::GuardBand, Clipping::DepthClamp, Clipping::DepthClamp});
        settings.clipZ = random() % 2 == 0 ? ClipZ::Gl : ClipZ::D3d;
        settings.reversedZ = random() % 3 == 0;
        if (random() % 2 == 0)
            settings.depthBias = randomBias(random);
        if (random() % 2 == 0)
            settings.depthRange = randomRange(random);
        if (random() % 2 == 0)
            addSecondPass(scene);
        if (random() % 4 == 0)
            scene.depthClear = 0.4;
        QVERIFY(!unsupported(scene, settings));
        const QString d = compareAll(scene, settings, simds());
        QVERIFY2(d.isEmpty(), qPrintable(QStringLiteral("RASTERLENS_SEED=%1: %2").arg(seed + unsigned(i)).arg(d)));
        Frame frame;
        settings.algorithm = Algorithm::Tiled;
        render(scene, settings, frame, kAll);
        secondPassSeen += std::size_t(std::ranges::count_if(frame.ids, [&](std::int32_t id) {
            return scene.secondPassFrom > 0 && id >= std::int32_t(scene.secondPassFrom);
        }));
    }
    QVERIFY(secondPassSeen > 0);
}

QTEST_APPLESS_MAIN(TestTiledDepth)
#include "test_tiled_depth.moc"
