#include "core/scenes/load_scene.h"
// Session files: what is saved comes back; broken ones are named with their line. And loadScene's choice of a reader.
#include "core/io/reach.h"
#include "core/io/session.h"
#include "core/lessons/moment.h"
#include "core/scenes/builtin_scenes.h"
#include "scene_files.h"

#include <QDir>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

#include <limits>

using namespace rasterlens;
using namespace rasterlens::test;

class TestSession : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void roundTrip();
    void viewsNeedNoCaption();
    void pathsAreRelativeToTheFile();
    void savedWholeOrNotAtAll();
    void broken_data();
    void broken();
    void movedTogetherOrAlone();
    void modelIsLookedForByItsName_data();
    void modelIsLookedForByItsName();
    void missingModelIsSaid();
    void newerVersion();
    void unknownKeysAreNamed();
    void contradictionWithTheScene();
    void sessionsByContent();
    void byteOrderMark();
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
    settings.projection = Projection::Orthographic;
    settings.light.towards = glm::dvec3(-1.0 / 3, 2, 0);
    settings.view.eye = {0.1, 1.0 / 3, -1e-7};
    settings.mistakes = {QStringLiteral("all-inclusive")};
    session.settings = toJson(settings);
    session.vertices = {{2, {0.1F, -1e-30F, 3e38F, 1}}, {7, {0, 0, 0, 1}}};
    const QString path = folder.path(QStringLiteral("s.json"));
    QCOMPARE(saveSession(session, path), std::nullopt);
    const SessionLoad load = loadSession(path);
    QVERIFY2(load.session && load.diagnostics.empty(), qPrintable(textOf(load.diagnostics)));
    QCOMPARE(load.session->scene, session.scene);
    QVERIFY(settingsOf(*load.session, {}).settings == settings);
    QVERIFY(load.session->vertices == session.vertices);

    const Scene original = *loadScene(session.scene).scene;
    Scene moved = original;
    QVERIFY(editVertices(moved, session, path).empty());
    QVERIFY(movedVertices(original.mesh, moved.mesh) == session.vertices);
    session.vertices[1000] = {0, 0, 0, 1};
    verifyRemark(editVertices(moved, session, path), path + QStringLiteral(": "), QStringLiteral("names vertex 1000"));

    const QString least = folder.write(QStringLiteral("least.json"), R"({"rasterlens": 1, "scene": "stress:tiny"})");
    QVERIFY(loadSession(least).session);
    QVERIFY(settingsOf(*loadSession(least).session, settings).settings == settings); // what it does not name stays
    const QString one = folder.write(QStringLiteral("one.json"),
                                     R"({"rasterlens": 1, "scene": "stress:tiny", "settings": {"culling": "none"}})");
    settings.culling = Culling::None;
    QVERIFY(settingsOf(*loadSession(one).session, settings).settings == settings);
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

    const QString outside = folder.write(QStringLiteral("head.obj"), "v 0 0 0\n");
    QCOMPARE(saveSession({outside, {}, {}}, path), std::nullopt);
    const QString up = folder.write(QStringLiteral("a/up.json"), R"({"rasterlens": 1, "scene": "../head.obj"})");
    QVERIFY(!loadSession(path).session && !loadSession(up).session); // what test_reach is about
    const Consent consent(Outside::Allow);
    QCOMPARE(loadSession(path).session->scene, outside);
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
    row("version 0", R"({"rasterlens": 0, "scene": "stress:tiny"})", 0, "\"rasterlens\": 1 is expected");
    row("version in words", R"({"rasterlens": "1", "scene": "stress:tiny"})", 0, "\"rasterlens\": 1 is expected");
    row("UTF-16", QByteArray("\xff\xfe{\0}\0", 6), 0, "the text is UTF-16; UTF-8 or ASCII is expected");
    row("UTF-16 without mark", QByteArray("{\0\n\0}\0", 6), 0, "the text is UTF-16");
    row("no scene", R"({"rasterlens": 1})", 0, "\"scene\" takes the name of a scene");
    row("scene is a number", R"({"rasterlens": 1, "scene": 5})", 0, "\"scene\" takes the name");
    row("settings is a list", R"({"rasterlens": 1, "scene": "a.obj", "settings": []})", 0,
        "\"settings\" takes an object");
    row("vertices is a list", R"({"rasterlens": 1, "scene": "a.obj", "vertices": []})", 0,
        "\"vertices\" takes an object");
    row("vertex without w", R"({"rasterlens": 1, "scene": "a.obj", "vertices": {"0": [1, 2, 3]}})", 0,
        "\"vertices\" takes an index and a position");
    row("vertex beyond float32", R"({"rasterlens": 1, "scene": "a.obj", "vertices": {"0": [1, 2, 3, 1e300]}})", 0,
        "\"vertices\" takes an index and a position");
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

/// A model above the session's folder is found when both are moved, and when the session is moved alone.
void TestSession::movedTogetherOrAlone()
{
    const Folder folder;
    QDir root(folder.path());
    QVERIFY(root.mkpath(QStringLiteral("work/sessions")) && root.mkpath(QStringLiteral("work/models")));
    const Consent consent(Outside::Allow);
    const QString model = folder.write(QStringLiteral("work/models/m.obj"), "v 0 0 0\n");
    const QString session = folder.path(QStringLiteral("work/sessions/s.json"));
    QCOMPARE(saveSession({model, {}, {}}, session), std::nullopt);

    QVERIFY(root.mkdir(QStringLiteral("elsewhere")));
    const QString alone = folder.path(QStringLiteral("elsewhere/s.json"));
    QVERIFY(QFile::copy(session, alone));
    const SessionLoad absolute = loadSession(alone);
    QVERIFY(absolute.session && absolute.session->sceneFound);
    QCOMPARE(absolute.session->scene, model);

    // The relative place wins where both hold a model.
    QVERIFY(root.mkpath(QStringLiteral("copy/sessions")) && root.mkpath(QStringLiteral("copy/models")));
    QVERIFY(QFile::copy(model, folder.path(QStringLiteral("copy/models/m.obj"))));
    const QString copied = folder.path(QStringLiteral("copy/sessions/s.json"));
    QVERIFY(QFile::copy(session, copied));
    QCOMPARE(loadSession(copied).session->scene, folder.path(QStringLiteral("copy/models/m.obj")));
    QVERIFY(loadSession(copied).diagnostics.empty());

    QVERIFY(root.rename(QStringLiteral("work"), QStringLiteral("moved")));
    const SessionLoad relative = loadSession(folder.path(QStringLiteral("moved/sessions/s.json")));
    QVERIFY(relative.session && relative.session->sceneFound && relative.diagnostics.empty());
    QCOMPARE(relative.session->scene, folder.path(QStringLiteral("moved/models/m.obj")));
}

void TestSession::modelIsLookedForByItsName_data()
{
    QTest::addColumn<QString>("stored");
    QTest::addColumn<QString>("place");
    const auto row = [](const char* name, const char* stored, const char* place) {
        QTest::newRow(name) << QString::fromLatin1(stored) << QString::fromLatin1(place);
    };
    row("beside", "/gone/models/m.obj", "a/b/m.obj");
    row("in a folder of its name beside", "/gone/models/m.obj", "a/b/models/m.obj");
    row("above", "/gone/models/m.obj", "a/m.obj");
    row("in a folder of its name above", "models/m.obj", "a/models/m.obj");
    row("of Windows, beside", "C:\\gone\\models\\m.obj", "a/b/m.obj");
    row("of Windows, relative", "..\\models\\m.obj", "a/models/m.obj");
    row("a case", "/gone/m.case", "a/b/m.case");
}

void TestSession::modelIsLookedForByItsName()
{
    QFETCH(QString, stored);
    QFETCH(QString, place);
    const Folder folder;
    QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("a/b/models")));
    QVERIFY(QDir(folder.path()).mkpath(QStringLiteral("a/models")));
    const QString model = folder.write(place, "v 0 0 0\n");
    const QByteArray json = QJsonDocument(QJsonObject{{"rasterlens", 1}, {"scene", stored}}).toJson();
    const QString path = folder.write(QStringLiteral("a/b/s.json"), json);
    const bool isBelow = place.startsWith(QLatin1String("a/b/"));
    QCOMPARE(loadSession(path).session && loadSession(path).session->sceneFound, isBelow);
    const Consent consent(Outside::Allow);
    const SessionLoad load = loadSession(path);
    QVERIFY2(load.session && load.session->sceneFound, qPrintable(textOf(load.diagnostics)));
    QCOMPARE(load.session->scene, model);
    verifyRemark(load.diagnostics, path + QStringLiteral(": "), model + QStringLiteral(" is used"));
    QVERIFY(!load.session->isPartial);
}

void TestSession::missingModelIsSaid()
{
    const Folder folder;
    const QString path =
        folder.write(QStringLiteral("s.json"), R"({"rasterlens": 1, "scene": "models/m.obj", "settings": {}})");
    const SessionLoad load = loadSession(path);
    QVERIFY(load.session && !load.session->sceneFound);
    verifyRemark(load.diagnostics, path + QStringLiteral(": "), QStringLiteral("beside the session"));
    QCOMPARE(load.session->scene, folder.path(QStringLiteral("models/m.obj")));
    QVERIFY(loadSession(folder.write(QStringLiteral("b.json"), R"({"rasterlens": 1, "scene": "builtin:cube"})"))
                .session->sceneFound);
}

/// What is understood is opened, the rest named; what nothing can be made of is still an error.
void TestSession::newerVersion()
{
    const Folder folder;
    const QString path = folder.write(QStringLiteral("s.json"), R"({"rasterlens": 2.5, "scene": "builtin:cube",
        "mood": "calm", "vertices": {"0": [1, 2, 3, 4], "all": "up", "1": [1, 2]},
        "settings": {"culling": "front", "shading": "marble", "gloss": 3, "subpixel-bits": 12, "size": "640x480x3",
                     "mistakes": ["all-inclusive", "of-the-future"], "view": {"yaw": 30, "roll": 5, "pitch": "up"}}})");
    const SessionLoad load = loadSession(path);
    QVERIFY2(load.session, qPrintable(textOf(load.diagnostics)));
    verifyRemark(load.diagnostics, path + QStringLiteral(": "),
                 QStringLiteral("made by a newer version (2.5); this one reads 1"));
    for (const char* named : {"\"mood\"", "\"marble\"", "\"gloss\"", "\"12\"", "\"size\"", "\"roll\"", "\"pitch\"",
                              "\"of-the-future\"", "\"all\"", "\"1\""})
        verifyRemark(load.diagnostics, path + QStringLiteral(": "), QLatin1String(named));
    QVERIFY(!hasErrors(load.diagnostics));
    QVERIFY(load.session->isPartial);
    const SettingsParse parse = settingsOf(*load.session, {});
    QVERIFY(parse.errors.empty());
    Settings expected;
    expected.culling = Culling::Front;
    expected.view.yaw = 30;
    expected.mistakes = {QStringLiteral("all-inclusive")};
    QVERIFY(parse.settings == expected);
    QVERIFY(load.session->vertices == (std::map<std::uint32_t, glm::dvec4>{{0, {1, 2, 3, 4}}}));

    for (const char* wrong : {R"({"rasterlens": 2})", R"({"rasterlens": 2, "scene": 5})"})
        QVERIFY2(!loadSession(folder.write(QStringLiteral("w.json"), wrong)).session, wrong);
    for (const char* odd : {R"({"rasterlens": 2, "scene": "builtin:cube", "settings": []})",
                            R"({"rasterlens": 2, "scene": "builtin:cube", "vertices": 1, "settings": {"view": 3}})"})
        QVERIFY2(loadSession(folder.write(QStringLiteral("o.json"), odd)).session, odd);
}

void TestSession::unknownKeysAreNamed()
{
    const Folder folder;
    const QString path = folder.write(QStringLiteral("s.json"), R"({"rasterlens": 1, "scene": "builtin:cube",
        "colour": 1, "settings": {"culling": "front", "gloss": 1}})");
    const SessionLoad load = loadSession(path);
    QVERIFY2(load.session, qPrintable(textOf(load.diagnostics)));
    verifyRemark(load.diagnostics, path + QStringLiteral(": "), QStringLiteral("there is no key \"colour\""));
    verifyRemark(load.diagnostics, path + QStringLiteral(": "), QStringLiteral("there is no setting \"gloss\""));
    QVERIFY(load.session->isPartial);
    QCOMPARE(settingsOf(*load.session, {}).settings.culling, Culling::Front);
}

/// A near plane beyond the far plane that the scene brings: said, and no setting is taken.
void TestSession::contradictionWithTheScene()
{
    const Folder folder;
    const QString path = folder.write(
        QStringLiteral("s.json"),
        R"({"rasterlens": 1, "scene": "builtin:cube", "settings": {"culling": "front", "view": {"near": 150}}})");
    const SessionLoad load = loadSession(path);
    QVERIFY(load.session && load.diagnostics.empty());
    Settings base;
    QVERIFY(settingsOf(*load.session, base).errors.empty());
    base.view.far = 120;
    const SettingsParse parse = settingsOf(*load.session, base);
    QCOMPARE(parse.errors.size(), 1U);
    QVERIFY2(textOf(parse.errors.front())
                 .startsWith(QStringLiteral("the far plane is at 120, but must lie beyond the near plane at 150")),
             qPrintable(textOf(parse.errors.front())));
    QVERIFY(parse.settings == base);
    base.view.far = 151;
    QVERIFY(settingsOf(*load.session, base).errors.empty());
}

void TestSession::sessionsByContent()
{
    const Folder folder;
    const QByteArray json = R"({"rasterlens": 1, "scene": "builtin:cube"})";
    for (const char* name : {"a.json", "a.JSON", "a.session", "a", "a.txt", "a.rasterlens"})
        QVERIFY2(isSession(folder.write(QLatin1String(name), json)), name);
    QVERIFY(isSession(folder.write(QStringLiteral("blank.txt"), "\xef\xbb\xbf \n\t" + json)));
    QVERIFY(isSession(QStringLiteral("missing.json")));
    for (const char* name : {"a.obj", "a.case"})
        QVERIFY2(!isSession(folder.write(QLatin1String(name), json)), name);
    QVERIFY(!isSession(folder.write(QStringLiteral("list.txt"), "[1, 2]")));
    QVERIFY(!isSession(folder.write(QStringLiteral("empty.txt"), "")));
    QVERIFY(!isSession(QStringLiteral("builtin:cube")));
    QVERIFY(!isSession(QStringLiteral("missing.txt")));
    QVERIFY(!isSession(folder.path()));
}

void TestSession::byteOrderMark()
{
    const Folder folder;
    const QByteArray mark = "\xef\xbb\xbf";
    QVERIFY(loadSession(folder.write(QStringLiteral("s.json"), mark + R"({"rasterlens": 1, "scene": "builtin:cube"})"))
                .session);
    const QByteArray text = "size 8 8\ntri -1 -1 0 1 1 0 0  1 -1 0 1 0 1 0  0 1 0 1 0 0 1\n";
    const SceneLoad marked = loadScene(folder.write(QStringLiteral("m.case"), mark + text));
    QVERIFY2(marked.scene, qPrintable(textOf(marked.diagnostics)));
    QCOMPARE(marked.scene->mesh.faceCount(), std::size_t(1));
    QByteArray little;
    QByteArray big;
    for (const char c : text) {
        little.append(c).append('\0');
        big.append('\0').append(c);
    }
    for (const QByteArray& wide : {QByteArray("\xff\xfe" + little), QByteArray("\xfe\xff" + big), little, big}) {
        const QString path = folder.write(QStringLiteral("w.case"), wide);
        const SceneLoad load = loadScene(path);
        QVERIFY(!load.scene);
        verifyRemark(load.diagnostics, path + QStringLiteral(": "),
                     QStringLiteral("the text is UTF-16; UTF-8 or ASCII is expected"));
    }
    verifyRemark(loadScene(folder.write(QStringLiteral("4.case"), QByteArray("\xff\xfe\0\0s\0\0\0", 8))).diagnostics,
                 folder.path(), QStringLiteral("the text is UTF-32"));
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

/// Only slides of lessons have a caption.
void TestSession::viewsNeedNoCaption()
{
    const auto view = QJsonDocument::fromJson(R"({"pixel": [3, 4], "overlay": ["wireframe"], "step": "tie"})").object();
    const SessionViewLoad load = sessionView(view, QStringLiteral("moment.json"));
    QVERIFY2(load.diagnostics.empty(), qPrintable(load.diagnostics.empty() ? QString() : load.diagnostics[0].text()));
    QCOMPARE(load.moment.pixel, std::optional(QPoint(3, 4)));
    QVERIFY(load.moment.caption.en.isEmpty());
}

QTEST_GUILESS_MAIN(TestSession)
#include "test_session.moc"
