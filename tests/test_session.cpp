// Session files: what is saved comes back; broken ones are named with their line. And loadScene's choice of a reader.
#include "core/io/session.h"
#include "core/scenes/builtin_scenes.h"
#include "scene_files.h"

#include <QDir>
#include <QTest>

#include <limits>

using namespace rasterlens;
using namespace rasterlens::test;

class TestSession : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void roundTrip();
    void pathsAreRelativeToTheFile();
    void savedWholeOrNotAtAll();
    void broken_data();
    void broken();
    void loadSceneChoosesTheReader();
    void boundingSphereOfFinitePositions();
    void checker();
};

void TestSession::roundTrip()
{
    const Folder folder;
    Session session{QStringLiteral("builtin:cube"), {}, {}};
    Settings settings;
    settings.size = {640, 480};
    settings.culling = Culling::Front;
    settings.reversedZ = true;
    settings.view.eye = {0.1, 1.0 / 3, -1e-7};
    settings.mistakes = {QStringLiteral("all-inclusive")};
    session.settings = toJson(settings);
    session.vertices = {{2, {0.1F, -1e-30F, 3e38F, 1}}, {7, {0, 0, 0, 1}}};
    const QString path = folder.path(QStringLiteral("s.json"));
    QCOMPARE(saveSession(session, path), std::nullopt);
    const SessionLoad load = loadSession(path);
    QVERIFY2(load.session && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    QCOMPARE(load.session->scene, session.scene);
    QVERIFY(settingsOf(*load.session, {}) == settings);
    QVERIFY(load.session->vertices == session.vertices);

    const Scene original = *loadScene(session.scene).scene;
    Scene moved = original;
    QVERIFY(moveVertices(moved, session, path).empty());
    QVERIFY(movedVertices(original.mesh, moved.mesh) == session.vertices);
    session.vertices[1000] = {0, 0, 0, 1};
    verifyRemark(moveVertices(moved, session, path), path + QStringLiteral(": "), QStringLiteral("names vertex 1000"));

    const QString least = folder.write(QStringLiteral("least.json"), R"({"rasterlens": 1, "scene": "stress:tiny"})");
    QVERIFY(loadSession(least).session);
    QVERIFY(settingsOf(*loadSession(least).session, settings) == settings); // what it does not name stays
    const QString one = folder.write(QStringLiteral("one.json"),
                                     R"({"rasterlens": 1, "scene": "stress:tiny", "settings": {"culling": "none"}})");
    settings.culling = Culling::None;
    QVERIFY(settingsOf(*loadSession(one).session, settings) == settings);
}

void TestSession::pathsAreRelativeToTheFile()
{
    const Folder folder;
    QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("a/models")));
    const QString path = folder.path(QStringLiteral("a/s.json"));
    const QString inside = folder.path(QStringLiteral("a/models/head.obj"));
    QCOMPARE(saveSession({inside, {}, {}}, path), std::nullopt);
    QFile file(path);
    QVERIFY(file.open(QIODevice::ReadOnly));
    QVERIFY(file.readAll().contains("\"models/head.obj\""));
    QCOMPARE(loadSession(path).session->scene, inside);

    const QString outside = folder.path(QStringLiteral("head.obj"));
    QCOMPARE(saveSession({outside, {}, {}}, path), std::nullopt);
    QCOMPARE(loadSession(path).session->scene, outside);

    const QString up = folder.write(QStringLiteral("a/up.json"), R"({"rasterlens": 1, "scene": "../head.obj"})");
    QCOMPARE(loadSession(up).session->scene, outside);
}

void TestSession::savedWholeOrNotAtAll()
{
    const Folder folder;
    const QString path = folder.path(QStringLiteral("none/s.json"));
    const auto problem = saveSession({QStringLiteral("builtin:cube"), {}, {}}, path);
    QVERIFY(problem && textOf(*problem).startsWith(QLatin1String("the file cannot be written: ")));
    const auto directory = saveSession({QStringLiteral("builtin:cube"), {}, {}}, folder.path());
    QVERIFY(directory.has_value());
    const QString good = folder.path(QStringLiteral("s.json"));
    QCOMPARE(saveSession({QStringLiteral("builtin:cube"), {}, {}}, good), std::nullopt);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files), QStringList{QStringLiteral("s.json")});
}

void TestSession::broken_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<int>("line");
    QTest::addColumn<QString>("phrase");
    const auto row = [](const char* name, const QByteArray& text, int line, const char* phrase) {
        QTest::newRow(name) << text << line << QString::fromLatin1(phrase);
    };
    row("empty", "", 0, "the file is empty");
    row("not JSON", "hello", 1, "broken JSON");
    row("comma missing", "{\n  \"rasterlens\": 1\n  \"scene\": \"stress:tiny\"\n}\n", 3, "broken JSON");
    row("truncated", "{\n\"rasterlens\": 1,\n\"scene\": \"x", 3, "broken JSON");
    row("array", "[1, 2]", 1, "a JSON object is expected");
    row("binary", QByteArray("\0\1\2\3", 4), 1, "broken JSON");
    row("no version", R"({"scene": "stress:tiny"})", 0, "\"rasterlens\": 1 is expected");
    row("later version", R"({"rasterlens": 2, "scene": "stress:tiny"})", 0, "\"rasterlens\": 1 is expected");
    row("no scene", R"({"rasterlens": 1})", 0, "\"scene\" takes the name of a scene");
    row("scene is a number", R"({"rasterlens": 1, "scene": 5})", 0, "\"scene\" takes the name");
    row("unknown key", R"({"rasterlens": 1, "scene": "a.obj", "colour": 1})", 0, "there is no key \"colour\"");
    row("settings is a list", R"({"rasterlens": 1, "scene": "a.obj", "settings": []})", 0,
        "\"settings\" takes an object");
    row("vertices is a list", R"({"rasterlens": 1, "scene": "a.obj", "vertices": []})", 0,
        "\"vertices\" takes an object");
    row("vertex without w", R"({"rasterlens": 1, "scene": "a.obj", "vertices": {"0": [1, 2, 3]}})", 0,
        "\"vertices\" takes an index and a position");
    row("vertex beyond float32", R"({"rasterlens": 1, "scene": "a.obj", "vertices": {"0": [1, 2, 3, 1e300]}})", 0,
        "\"vertices\" takes an index and a position");
    row("unknown setting", R"({"rasterlens": 1, "scene": "a.obj", "settings": {"gloss": 1}})", 0,
        "there is no setting \"gloss\"");
    row("setting out of range", R"({"rasterlens": 1, "scene": "a.obj", "settings": {"subpixel-bits": 12}})", 0,
        "subpixel-bits");
    row("size out of range", R"({"rasterlens": 1, "scene": "a.obj", "settings": {"size": "0x0"}})", 0,
        "\"size\" takes");
}

void TestSession::broken()
{
    QFETCH(QByteArray, text);
    QFETCH(int, line);
    QFETCH(QString, phrase);
    const Folder folder;
    const QString path = folder.write(QStringLiteral("s.json"), text);
    const SessionLoad load = loadSession(path);
    QVERIFY(!load.session);
    const QString place = line > 0 ? QStringLiteral("%1:%2: ").arg(path).arg(line) : path + QStringLiteral(": ");
    verifyRemark(load.diagnostics, place, phrase);
}

void TestSession::loadSceneChoosesTheReader()
{
    const Folder folder;
    const QString obj = folder.write(QStringLiteral("A.OBJ"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    QVERIFY(loadScene(obj).scene);
    QCOMPARE(loadScene(obj).scene->id, obj);
    QVERIFY(loadScene(folder.write(QStringLiteral("a.Case"), "size 1 1\n")).scene);
    const SceneLoad stress = loadScene(QStringLiteral("stress:large"), {false, {64, 32}, {}});
    QVERIFY(stress.scene);
    QCOMPARE(stress.scene->defaults.size, QSize(64, 32));
    for (const QString& name :
         {QStringLiteral("builtin:no such"), QStringLiteral("stress:no such"), QStringLiteral("a.stl"), QString()}) {
        const SceneLoad load = loadScene(name);
        QVERIFY(!load.scene && hasErrors(load.diagnostics));
    }
    verifyRemark(loadScene(QStringLiteral("a.stl")).diagnostics, QStringLiteral("a.stl: "),
                 QStringLiteral("an .obj or .case file, builtin:NAME or stress:NAME"));
}

void TestSession::boundingSphereOfFinitePositions()
{
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    Mesh mesh;
    QVERIFY(boundingSphere(mesh).center == glm::dvec3(0) && boundingSphere(mesh).radius == 1);
    mesh.vertices = {{.position = {kInfinity, 0, 0, 1}}, {.position = {0, std::nanf(""), 0, 1}}};
    QVERIFY(boundingSphere(mesh).center == glm::dvec3(0) && boundingSphere(mesh).radius == 1);
    mesh.vertices.push_back({.position = {-1, 2, 3, 1}});
    mesh.vertices.push_back({.position = {5, 2, 3, 1}});
    QVERIFY(boundingSphere(mesh).center == glm::dvec3(2, 2, 3) && boundingSphere(mesh).radius == 3);
    mesh.vertices = {{.position = {3e38F, 3e38F, 3e38F, 1}}, {.position = {-3e38F, -3e38F, -3e38F, 1}}};
    QVERIFY(std::isfinite(boundingSphere(mesh).radius));
}

void TestSession::checker()
{
    const Texture& checker = checkerTexture();
    QCOMPARE(checker.width, 512);
    QCOMPARE(checker.height, 512);
    QCOMPARE(checker.texels.size(), std::size_t{512 * 512});
    QCOMPARE(checker.texels[0], 0xffe6e6e6U);
    QCOMPARE(checker.texels[31], 0xffe6e6e6U);
    QCOMPARE(checker.texels[32], 0xff283c78U);
    QCOMPARE(checker.texels[32 * 512], 0xff283c78U);
    QCOMPARE(checker.texels[32 * 512 + 32], 0xffe6e6e6U);
}

QTEST_GUILESS_MAIN(TestSession)
#include "test_session.moc"
