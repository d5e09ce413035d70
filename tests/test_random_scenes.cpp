#include "core/scenes/load_scene.h"
// The tiled algorithm against edge-equation, on random scenes and on every scene there is.
// RASTERLENS_SCENES=N draws N random ones; the CTest label `long` draws ten thousand, and every scene and model.
#include "tests/seed.h"
#include "tests/tiled_support.h"

#include <QDirIterator>
#include <QTest>

#include <bit>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

double uniform(std::mt19937& random, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

bool oneOf(std::mt19937& random, unsigned count) { return random() % count == 0; }

/// 1 to 300 pixels a side, small ones more often.
QSize randomSize(std::mt19937& random)
{
    const auto side = [&] { return 1 + int(299 * std::pow(uniform(random, 0, 1), 2)); };
    const int width = side();
    return {width, side()};
}

/// Any bits: denormals, infinities, NaN.
float anyFloat(std::mt19937& random) { return std::bit_cast<float>(static_cast<std::uint32_t>(random())); }

/// Overwrites some numbers of vertices: positions with any bits there are, texture coordinates with any numbers. (That
/// loaders let through. Normals are of length 1, colours finite.)
void spoil(Mesh& mesh, std::mt19937& random)
{
    for (MeshVertex& vertex : mesh.vertices) {
        if (oneOf(random, 20))
            vertex.position[int(random() % 4)] = anyFloat(random);
        if (const float coordinate = anyFloat(random); std::isfinite(coordinate) && oneOf(random, 20))
            vertex.uv[int(random() % 2)] = coordinate;
    }
}

/// Faces between any of the vertices, which are processed once and kept.
void share(Mesh& mesh, std::mt19937& random)
{
    mesh.vertices.resize(std::max<std::size_t>(3, mesh.vertices.size() / 8));
    for (std::uint32_t& index : mesh.indices)
        index = static_cast<std::uint32_t>(random() % mesh.vertices.size());
}

/// Hard triangles in clip space, or one of the built-in scenes.
Scene randomScene(std::mt19937& random, QSize size)
{
    Scene scene;
    if (oneOf(random, 4)) {
        const auto names = builtinScenes();
        scene = *makeBuiltinScene(QString::fromLatin1(names[random() % names.size()].name)).scene;
    } else {
        scene = soup(random, size, 1 + int(random() % 120));
        if (oneOf(random, 3))
            share(scene.mesh, random);
    }
    scene.mesh.faceMaterial.clear();
    if (oneOf(random, 2))
        dress(scene, random);
    if (oneOf(random, 4))
        spoil(scene.mesh, random);
    if (oneOf(random, 4))
        scene.secondPassFrom = 1 + static_cast<std::uint32_t>(random() % scene.mesh.faceCount());
    return scene;
}

/// Anywhere about the scene and inside it.
View randomView(std::mt19937& random)
{
    View view;
    view.yaw = uniform(random, -180, 180);
    view.pitch = uniform(random, -90, 90);
    view.distance = std::pow(10, uniform(random, -1.5, 0.7));
    view.pan = {uniform(random, -1, 1), uniform(random, -1, 1)};
    view.fov = uniform(random, 5, 150);
    if (oneOf(random, 3))
        view.near = std::pow(10, uniform(random, -3, 1));
    if (view.near && oneOf(random, 2))
        view.far = *view.near * (1 + std::pow(10, uniform(random, -2, 4)));
    return view;
}

/// Each field of the table at random every other time, as far as the tiled algorithm can draw it.
Settings randomSettings(const Scene& scene, QSize size, std::mt19937& random)
{
    Settings settings;
    settings.size = size;
    settings.view = randomView(random);
    settings.algorithm = Algorithm::Tiled;
    for (const SettingsField& field : settingsFields()) {
        Settings changed = settings;
        field.set(changed, field.minimum + int(random() % unsigned(field.maximum - field.minimum + 1)));
        changed.algorithm = Algorithm::Tiled;
        if (oneOf(random, 2) && !unsupported(scene, changed))
            settings = changed;
    }
    if (oneOf(random, 2))
        settings.light.towards = glm::dvec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
    else if (oneOf(random, 2))
        settings.light.towards.reset();
    if (oneOf(random, 3))
        settings.depthBias = {uniform(random, -1e3, 1e3), uniform(random, -9, 9), uniform(random, -0.1, 0.1)};
    if (oneOf(random, 3))
        settings.depthRange = {uniform(random, 0, 1), uniform(random, 0, 1)};
    return settings;
}

int sceneCount()
{
    bool given = false;
    const int count = qEnvironmentVariableIntValue("RASTERLENS_SCENES", &given);
    return given ? count : casesOfBuild(200);
}

/// What a scene asks for, drawn by the tiled algorithm as far as it can.
Settings settingsFor(const Scene& scene)
{
    Settings settings = scene.defaults;
    settings.mistakes.clear();
    settings.fill = Fill::Solid;
    settings.algorithm = Algorithm::Tiled;
    return settings;
}

} // namespace

class TestRandomScenes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void drawsRandomScenesAlike();
    void drawsEverySceneAlike_data();
    void drawsEverySceneAlike();
};

/// Also into a frame that holds whatever the scenes before left in it.
void TestRandomScenes::drawsRandomScenesAlike()
{
    const unsigned seed = seedOfRun();
    const std::vector<Simd> all = simds();
    Frame kept;
    qint64 seen = 0;
    for (int i = 0; i < sceneCount(); ++i) {
        std::mt19937 random(seed + unsigned(i));
        const QSize size = randomSize(random);
        const Scene scene = randomScene(random, size);
        Settings settings = randomSettings(scene, size, random);
        const auto tell = [&](const QString& what) {
            return QStringLiteral("RASTERLENS_SEED=%1 RASTERLENS_SCENES=1: %2").arg(seed + unsigned(i)).arg(what);
        };
        const QString d = compareAll(scene, settings, {all[random() % all.size()]});
        QVERIFY2(d.isEmpty(), qPrintable(tell(d)));
        settings.simd = Simd::Auto;
        settings.threads = 1 + int(random() % 3);
        const Outputs outputs{
            .depth = oneOf(random, 2), .ids = true, .coverage = oneOf(random, 2), .picture = !oneOf(random, 4)};
        Frame fresh;
        render(scene, settings, fresh, outputs);
        render(scene, settings, kept, outputs);
        const bool same = fresh.coverage == kept.coverage && fresh.ids == kept.ids &&
                          sameBits(fresh.depth, kept.depth) && fresh.image == kept.image;
        QVERIFY2(same, qPrintable(tell(QStringLiteral("in a frame used before"))));
        seen += std::count_if(fresh.ids.begin(), fresh.ids.end(), [](int id) { return id >= 0; });
    }
    QVERIFY(sceneCount() == 1 || seen > sceneCount()); // pictures are not empty
}

void TestRandomScenes::drawsEverySceneAlike_data()
{
    if (RASTERLENS_SANITIZED && !qEnvironmentVariableIsSet("RASTERLENS_SCENES"))
        QSKIP("a million faces take minutes under the sanitizers: random_scenes_long draws them");
    QTest::addColumn<QString>("name");
    const auto add = [](const QString& name) { QTest::newRow(qPrintable(name)) << name; };
    for (const BuiltinScene& scene : builtinScenes())
        add(QStringLiteral("builtin:") + QLatin1String(scene.name));
    for (const char* name : {"tiny", "medium", "large", "fill-front-to-back", "fill-back-to-front"})
        add(QStringLiteral("stress:") + QLatin1String(name));
    for (const char* folder : {RASTERLENS_SHARED "/models", RASTERLENS_SHARED "/cases", RASTERLENS_CASES}) {
        QDirIterator files(QLatin1String(folder), {"*.obj", "*.case"}, QDir::Files, QDirIterator::Subdirectories);
        while (files.hasNext())
            add(files.next());
    }
}

/// As it asks to be drawn, cases at their own size.
void TestRandomScenes::drawsEverySceneAlike()
{
    QFETCH(QString, name);
    constexpr QSize kSize(480, 270);
    const SceneLoad load = loadScene(name, {.peerMesh = false, .size = kSize, .texture = {}});
    QVERIFY(load.scene);
    Settings settings = settingsFor(*load.scene);
    if (!name.endsWith(QLatin1String(".case")))
        settings.size = kSize;
    if (const auto reason = unsupported(*load.scene, settings))
        QSKIP(qPrintable(textOf(*reason)));
    const QString d = compareAll(*load.scene, settings, {Simd::Auto});
    QVERIFY2(d.isEmpty(), qPrintable(d));
}

QTEST_APPLESS_MAIN(TestRandomScenes)
#include "test_random_scenes.moc"
