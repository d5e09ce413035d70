// Shading by the tiled algorithm against edge-equation: every shading, texture filter and number of samples, on every
// instruction set.
#include "tests/seed.h"
#include "tests/tiled_support.h"

#include <QTest>

#include <array>
#include <initializer_list>
#include <limits>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

/// What differs with any of the shadings, both sides of faces seen, or nothing.
QString compareShadings(const Scene& scene, Settings settings, std::initializer_list<Shading> shadings)
{
    settings.culling = Culling::None;
    for (const Shading shading : shadings) {
        settings.shading = shading;
        const QString d = compareAll(scene, settings, simds(), {1});
        if (!d.isEmpty())
            return d;
    }
    return {};
}

} // namespace

class TestTiledShading : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawsShadingsAlike_data();
    void drawsShadingsAlike();
    void drawsMovedLightsAndParallelRays();
    void findsTexelsOnTheirBorders();
    void findsTexelsWhereCoordinatesPassZero();
    void findsTexelsOfAnyTriangle();
    void drawsAttributesThatAreNoNumbers();
    void drawsWOfEitherSign();
    void wrapsCoordinatesAlike();
};

void TestTiledShading::drawsShadingsAlike_data()
{
    QTest::addColumn<Settings>("settings");
    const SettingsField& shading = *findSettingsField("shading");
    const SettingsField& filter = *findSettingsField("texture-filter");
    const SettingsField& samples = *findSettingsField("samples");
    Settings settings;
    for (int i = shading.minimum; i <= shading.maximum; ++i)
        for (int j = filter.minimum; j <= filter.maximum; ++j)
            for (int k = samples.minimum; k <= samples.maximum; ++k) {
                shading.set(settings, i);
                filter.set(settings, j);
                samples.set(settings, k);
                if (settings.shading == Shading::MipLevel)
                    continue; // tiled says that it does not draw it
                const bool textured = settings.shading == Shading::Texture || settings.shading == Shading::Phong;
                if (j == filter.minimum || textured)
                    QTest::addRow("%s %s %s", qPrintable(valueId(shading, settings)),
                                  qPrintable(valueId(filter, settings)), qPrintable(valueId(samples, settings)))
                        << settings;
            }
}

void TestTiledShading::drawsShadingsAlike()
{
    QFETCH(Settings, settings);
    const std::vector<Simd> all = simds();
    std::mt19937 random(5);
    const SceneLoad mesh = makeBuiltinScene(RASTERLENS_SANITIZED ? "sphere" : "head");
    QVERIFY(mesh.scene);
    for (const bool lit : {false, true})
        for (const Interpolation interpolation : {Interpolation::Perspective, Interpolation::Affine}) {
            if (RASTERLENS_SANITIZED && lit != (interpolation == Interpolation::Perspective))
                continue; // two of the four, which take every way through the kernels
            settings.size = lit ? QSize(70, 40) : QSize(50, 70);
            settings.culling = lit ? Culling::Back : Culling::None;
            settings.view.distance = 0.7; // some of it is cut
            settings.interpolation = interpolation;
            Scene scene = lit ? *mesh.scene : soup(random, settings.size, 40);
            dress(scene, random);
            const QString d = compareAll(scene, settings, all, {2});
            QVERIFY2(d.isEmpty(), qPrintable(d));
        }
}

void TestTiledShading::drawsMovedLightsAndParallelRays()
{
    std::mt19937 random(6);
    Scene scene = *makeBuiltinScene("sphere").scene;
    dress(scene, random);
    Settings settings;
    settings.size = {70, 40};
    settings.view.distance = 0.7;
    for (const Projection projection : {Projection::Perspective, Projection::Orthographic})
        for (const Light& light :
             {Light(), Light{glm::dvec3(-1, 0.25, 0.5)}, Light{glm::dvec3(0, 0, -1)}, Light{std::nullopt}}) {
            settings.projection = projection;
            settings.light = light;
            const QString d = compareShadings(
                scene, settings,
                {Shading::Gouraud, Shading::Flat, Shading::Texture, Shading::Phong, Shading::Depth, Shading::Uv});
            QVERIFY2(d.isEmpty(), qPrintable(lightText(light) + QStringLiteral(": ") + d));
        }
}

/// Two texels a pixel: every centre lies on the border of two texels, and the wrong one would be seen.
void TestTiledShading::findsTexelsOnTheirBorders()
{
    std::mt19937 random(9);
    const QSize size(96, 64);
    for (const int side : {64, 48, 7}) {
        Scene scene = clipScene(size);
        scene.textures = {noise(random, side, side)};
        scene.materials[0].texture = 0;
        addTriangle(scene,
                    {fromScreen(0, 0, 0.5, 1, size), fromScreen(0, 64, 0.5, 1, size), fromScreen(96, 64, 0.5, 1, size)},
                    random);
        addTriangle(scene,
                    {fromScreen(0, 0, 0.5, 1, size), fromScreen(96, 64, 0.5, 1, size), fromScreen(96, 0, 0.5, 1, size)},
                    random);
        for (MeshVertex& v : scene.mesh.vertices) {
            v.uv = glm::vec2(v.position.x + 1, v.position.y + 1) * glm::vec2(96, 64) / float(side);
            v.color = {1, 1, 1};
        }
        for (const Shading shading : {Shading::Texture, Shading::Uv}) {
            Settings settings;
            settings.size = size;
            settings.shading = shading;
            const QString d = compareAll(scene, settings, simds(), {1});
            QVERIFY2(d.isEmpty(), qPrintable(d));
        }
    }
}

/// Sums in double that should be 0 may be 1e-17 to either side, and float32 keeps the sign.
void TestTiledShading::findsTexelsWhereCoordinatesPassZero()
{
    for (const char* name : {"floor", "tunnel", "torus-knot"}) {
        const SceneLoad load = makeBuiltinScene(name);
        QVERIFY(load.scene);
        for (const Shading shading : {Shading::Texture, Shading::Phong, Shading::Uv})
            for (const QSize size : {QSize(257, 131), QSize(127, 61)}) {
                Settings settings = load.scene->defaults;
                settings.size = size;
                settings.shading = shading;
                settings.textureFilter = TextureFilter::Nearest;
                const QString d = compareAll(*load.scene, settings, simds(), {1});
                QVERIFY2(d.isEmpty(), qPrintable(QStringLiteral("%1 %2: %3").arg(name).arg(size.width()).arg(d)));
            }
    }
}

/// So many texels that samples lie on all sides of their borders as closely as float32 can tell and closer; each has a
/// colour of its own.
void TestTiledShading::findsTexelsOfAnyTriangle()
{
    std::mt19937 random(11);
    const QSize size(240, 160);
    for (const QSize texels : {QSize(2048, 1024), QSize(1000, 777)})
        for (const float repeats : {0.3F, 4.0F, 60.0F}) {
            Scene scene = soup(random, size, 50);
            scene.textures = {noise(random, texels.width(), texels.height())};
            scene.materials[0].texture = 0;
            for (MeshVertex& v : scene.mesh.vertices) {
                v.uv *= repeats;
                v.color = {1, 1, 1};
            }
            Settings settings;
            settings.size = size;
            settings.culling = Culling::None;
            settings.shading = Shading::Texture;
            const QString d = compareAll(scene, settings, simds(), {1});
            QVERIFY2(d.isEmpty(), qPrintable(d));
        }
}

void TestTiledShading::drawsAttributesThatAreNoNumbers()
{
    constexpr float kInf = std::numeric_limits<float>::infinity();
    std::mt19937 random(10);
    const QSize size(80, 60);
    Scene scene = soup(random, size, 60);
    dress(scene, random);
    const std::array odd{0.0F, kInf, -kInf, std::numeric_limits<float>::quiet_NaN(), 1e30F, -1e9F, 1e-42F};
    const auto some = [&] { return odd[random() % odd.size()]; };
    for (MeshVertex& v : scene.mesh.vertices) {
        if (random() % 3 == 0)
            v.uv = {some(), some()};
        if (random() % 3 == 0)
            v.normal = {some(), some(), some()};
    }
    Settings settings;
    settings.size = size;
    const QString d =
        compareShadings(scene, settings, {Shading::Texture, Shading::Phong, Shading::Normals, Shading::Uv});
    QVERIFY2(d.isEmpty(), qPrintable(d));
}

/// Corners near and far, before and behind the eye, and nothing is cut: 1/w may vanish within a triangle.
void TestTiledShading::drawsWOfEitherSign()
{
    std::mt19937 random(13);
    std::uniform_real_distribution<float> unit(-1, 1);
    const QSize size(80, 60);
    for (int round = 0; round < casesOfBuild(60); ++round) {
        Scene scene = soup(random, size, 3); // few, that none is hidden
        dress(scene, random);
        const float decades = round % 3 == 0 ? 1.0F : 25.0F;
        for (MeshVertex& v : scene.mesh.vertices)
            v.position *= std::pow(10.0F, decades * unit(random)) * (random() % 4 == 0 ? -1.0F : 1.0F);
        Settings settings;
        settings.size = size;
        settings.clipping = Clipping::None;
        const QString d =
            compareShadings(scene, settings, {Shading::Gouraud, Shading::Texture, Shading::Phong, Shading::Uv});
        QVERIFY2(d.isEmpty(), qPrintable(d));
    }
}

/// Edges along sample centres where u is 0: the fraction of what comes out is 0 or almost 1.
void TestTiledShading::wrapsCoordinatesAlike()
{
    std::mt19937 random(14);
    const auto range = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    const QSize size(90, 70);
    for (const float largest : {1.0F, 1e5F, 1e20F}) {
        Scene scene = clipScene(size);
        for (int i = 0; i < 60; ++i) {
            const double x = std::floor(range(5, 80)) + 0.5;
            const auto corner = [&](double at) {
                return fromScreen(at, range(0, 70), range(0, 1), range(0.5, 8), size);
            };
            addTriangle(scene, {corner(x), corner(x), corner(x + range(-20, 20))}, random);
            scene.mesh.vertices[3 * std::size_t(i)].uv.x = scene.mesh.vertices[3 * std::size_t(i) + 1].uv.x = 0;
            scene.mesh.vertices[3 * std::size_t(i) + 2].uv *= largest;
        }
        Settings settings;
        settings.size = size;
        settings.culling = Culling::None;
        settings.shading = Shading::Uv;
        const QString d = compareAll(scene, settings, simds(), {1});
        QVERIFY2(d.isEmpty(), qPrintable(d));
    }
}

QTEST_APPLESS_MAIN(TestTiledShading)
#include "test_tiled_shading.moc"
