// The nearest texel and the mip level of a sample, decided by integers: against values worked out by hand, and the
// rasterizers against them.
#include "core/io/case_file.h"
#include "core/pipeline/shading.h"
#include "core/questions/why.h"
#include "core/render/render.h"
#include "core/truth/exact_reference.h"
#include "core/truth/exact_texels.h"
#include "tests/seed.h"

#include <QJsonArray>
#include <QJsonObject>
#include <QTest>

#include <cmath>
#include <random>

using namespace rasterlens;

namespace
{

constexpr int kSide = 16;

/// A square of pixels in which u and v are u0 + x du, v0 + y dv, with a texture whose texels all differ.
Scene sceneOf(double u0, double du, double v0, double dv, int texels)
{
    const SceneLoad load = parseCase("size 16 16\ntexture checker 2\n", QStringLiteral("a.case"));
    Scene scene = *load.scene;
    Texture& texture = scene.textures.front();
    texture.width = texture.height = texels;
    texture.texels.clear();
    for (int i = 0; i < texels * texels; ++i)
        texture.texels.push_back(0xff000000U | static_cast<std::uint32_t>(i * 7919 + 1));
    const auto corner = [&](double x, double y) {
        MeshVertex vertex;
        vertex.position = {2 * x / kSide - 1, 1 - 2 * y / kSide, 0, 1};
        vertex.uv = {static_cast<float>(u0 + x * du), static_cast<float>(v0 + y * dv)};
        scene.mesh.indices.push_back(static_cast<std::uint32_t>(scene.mesh.vertices.size()));
        scene.mesh.vertices.push_back(vertex);
    };
    const double ends[6][2] = {{0, 0}, {0, kSide}, {kSide, 0}, {kSide, 0}, {0, kSide}, {kSide, kSide}};
    for (const auto& end : ends)
        corner(end[0], end[1]);
    return scene;
}

std::vector<ExactTexel> texelsOf(const Scene& scene)
{
    return exactTexels(scene, scene.defaults, exactReference(scene, scene.defaults));
}

/// Samples whose colour is not that of the exact texel.
int wrongTexels(const Scene& scene, Algorithm algorithm)
{
    Settings settings = scene.defaults;
    settings.algorithm = algorithm;
    Frame frame;
    render(scene, settings, frame);
    const std::vector<ExactTexel> exact = texelsOf(scene);
    int wrong = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const Texture& texture = scene.textures.front();
        const int x = static_cast<int>(i) % frame.image.width();
        const int y = static_cast<int>(i) / frame.image.width();
        const std::uint32_t texel =
            texture.texels[static_cast<std::size_t>(exact[i].row * texture.width + exact[i].column)];
        wrong += frame.image.pixel(x, y) != texel ? 1 : 0;
    }
    return wrong;
}

} // namespace

class TestExactTexels : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void bordersBelongToTheUpperTexel();
    void rasterizersAgree();
    void levelsChangeAtPowersOfTwo();
    void cutFacesAreNotKnown();
    void footprintTellsPlaceStepsAndLevel();
    void levelsAreShownInColours();
};

void TestExactTexels::bordersBelongToTheUpperTexel()
{
    // Eight texels on eight columns, and borders at the centres: u W = x - 4 at column x.
    const Scene scene = sceneOf(-4.5 / 8, 1.0 / 8, 0.03, 0, 8);
    const std::vector<ExactTexel> exact = texelsOf(scene);
    for (int x = 0; x < kSide; ++x) {
        QCOMPARE(exact[static_cast<std::size_t>(x)].column, (x - 4 + 8) % 8);
        QCOMPARE(exact[static_cast<std::size_t>(x)].row, 0);
    }
    // A hair below the border, by less than rounding accounts for, counts as on it; by more it does not.
    QCOMPARE(texelsOf(sceneOf(0.5 - 0x1p-24, 0, 0.03, 0, 8)).front().column, 4);
    QCOMPARE(texelsOf(sceneOf(0.5 - 0x1p-20, 0, 0.03, 0, 8)).front().column, 3);
    // Clamped, the last texel goes on.
    Scene clamped = sceneOf(-1, 0.25, 0.03, 0, 8);
    clamped.textures.front().clamp = true;
    QCOMPARE(texelsOf(clamped).front().column, 0);
    QCOMPARE(texelsOf(clamped)[kSide - 1].column, 7);
}

void TestExactTexels::rasterizersAgree()
{
    const unsigned seed = test::seedOfRun();
    std::mt19937 random(seed);
    const auto any = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
    for (int i = 0; i < 40; ++i) {
        // Multiples of 1/64 put many centres on borders exactly, also mirrored ones and those left of 0.
        const auto step = [&] { return std::round(any(-32, 32)) / 64; };
        const Scene scene = sceneOf(step(), step(), step(), step(), 1 << (i % 5));
        for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking, Algorithm::Tiled})
            QVERIFY2(wrongTexels(scene, algorithm) == 0,
                     qPrintable(QStringLiteral("scene %1, seed %2").arg(i).arg(seed)));
    }
}

void TestExactTexels::levelsChangeAtPowersOfTwo()
{
    for (const double texels : {0.5, 1.0, 2.0, 3.999, 4.0, 5.0, 8.0, 32.0}) {
        const int level = std::max(0, static_cast<int>(std::floor(std::log2(texels))));
        QCOMPARE(texelsOf(sceneOf(0, texels / 64, 0, 0, 64)).front().level, level);
        QCOMPARE(texelsOf(sceneOf(0, 0, 0, -texels / 64, 64)).front().level, level);
    }
    // Just below a power of two in float32.
    const double below = static_cast<double>(std::nextafter(2.0F / 64 * kSide, 0.0F)) / kSide;
    QCOMPARE(texelsOf(sceneOf(0, below, 0, 0, 64)).front().level, 0);
    QCOMPARE(texelsOf(sceneOf(0.3, 0, 0.7, 0, 64)).front().level, 0); // no derivative
}

void TestExactTexels::cutFacesAreNotKnown()
{
    Scene scene = sceneOf(0, 0.1, 0, 0.1, 8);
    scene.mesh.vertices[0].position.x = -1.5F;
    const std::vector<ExactTexel> exact = texelsOf(scene);
    QCOMPARE(exact.front().column, -1);
    QVERIFY(exact.back().column >= 0);
    ExactFrame truth = exactReference(scene, scene.defaults);
    QVERIFY(!textureExactly(scene, scene.defaults, truth));
}

void TestExactTexels::footprintTellsPlaceStepsAndLevel()
{
    // 64 texels: 4 a sample to the right, half of one down, which is up in the texture.
    const Scene scene = sceneOf(0, 4.0 / 64, 1, -0.5 / 64, 64);
    const WhyReport report = why(scene, scene.defaults, 3, 5);
    const WhyFace* face = report.visibleFace ? report.find(*report.visibleFace) : nullptr;
    QVERIFY(face && face->texels);
    QCOMPARE(face->texels->size, QSize(64, 64));
    const auto isNear = [](const glm::dvec2& a, const glm::dvec2& b) { return glm::distance(a, b) < 1e-4; };
    QVERIFY(isNear(face->texels->place, {14, 64 - 2.75}));
    QVERIFY(isNear(face->texels->right, {4, 0}) && isNear(face->texels->down, {0, -0.5}));
    QVERIFY(std::abs(face->texels->level - 2) < 1e-5);
    const QJsonObject json =
        toJson(report)[QLatin1String("faces")].toArray()[int(face - report.faces.data())].toObject();
    QVERIFY(std::abs(json[QLatin1String("texels")][QLatin1String("level")].toDouble() - 2) < 1e-5);

    // The wrong level is told where it is taken: twice as many levels.
    Settings doubled = scene.defaults;
    doubled.mistakes = {QStringLiteral("lod-doubled")};
    const WhyReport wrong = why(scene, doubled, 3, 5);
    QVERIFY(std::abs(wrong.find(*wrong.visibleFace)->texels->level - 4) < 1e-5);

    Settings plain = scene.defaults;
    plain.shading = Shading::Gouraud;
    const WhyReport untextured = why(scene, plain, 3, 5);
    QVERIFY(!untextured.find(*untextured.visibleFace)->texels);
}

void TestExactTexels::levelsAreShownInColours()
{
    for (const int level : {0, 1, 2, 5}) {
        const Scene scene = sceneOf(0, double(1 << level) / 64, 0, 0, 64);
        Settings settings = scene.defaults;
        settings.shading = Shading::MipLevel;
        for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking}) {
            settings.algorithm = algorithm;
            Frame frame;
            render(scene, settings, frame);
            QCOMPARE(frame.image.pixel(3, 4), packColor(levelColor(float(level))));
            QCOMPARE(frame.image.pixel(15, 15), frame.image.pixel(3, 4));
        }
        settings.algorithm = Algorithm::Tiled;
        const auto reason = unsupported(scene, settings);
        QVERIFY(reason && textOf(*reason).contains(QLatin1String("mip-level")));
    }
    QVERIFY(levelColor(0.5F) != levelColor(0) && levelColor(0.5F) != levelColor(1));
    QVERIFY(levelColor(8) == levelColor(20) && levelColor(-1) == levelColor(0));
}

QTEST_APPLESS_MAIN(TestExactTexels)
#include "test_exact_texels.moc"
