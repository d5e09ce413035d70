// Files are data: what a model, a session or a lesson names is read from its own folder alone, never from a device or a
// pipe, and neither size nor nesting of a file ends the program.
#include "core/io/reach.h"
#include "core/io/session.h"
#include "core/lessons/lesson.h"
#include "core/scenes/load_scene.h"
#include "scene_files.h"

#include <QBuffer>
#include <QDir>
#include <QFileInfo>
#include <QImage>

#include <sys/stat.h>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr auto kCase = "size 8 8\ntri -1 -1 0 1 1 0 0  1 -1 0 1 0 1 0  -1 1 0 1 0 0 1\n";
constexpr auto kRefused = "it lies outside the model's folder and is read only if that is allowed (--allow-outside)";

/// What comes of reading a file.
template <class Load>
struct Read {
    Load load;
    std::vector<Consent::Refused> refused;
};

template <class Reader>
auto readWith(Outside outside, Reader reader)
{
    const Consent consent(outside);
    auto load = reader();
    return Read<decltype(load)>{std::move(load), consent.refused()};
}

Read<SceneLoad> load(const QString& path, Outside outside = Outside::Refuse)
{
    return readWith(outside, [&] { return loadScene(path); });
}

QByteArray pngBytes()
{
    QImage image(2, 2, QImage::Format_RGB32);
    image.fill(Qt::red);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "png");
    return bytes;
}

QByteArray objOf(const QByteArray& library)
{
    return "mtllib " + library + "\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nusemtl a\nf 1/1 2/1 3/1\n";
}

QByteArray lessonOf(const QByteArray& scene)
{
    return R"({"rasterlens-lesson": 1, "id": "a", "title": {"en": "A", "zh": "甲"}, "steps": [{
        "scene": ")" +
           scene + R"(", "caption": {"en": "One.", "zh": "一。"}}]})";
}

} // namespace

class TestReach : public QObject
{
    Q_OBJECT

    /// `files/own`, the folder of the files that are opened, and others around it.
    struct Disk {
        Folder folder;
        Disk()
        {
            QDir(folder.path()).mkpath(QStringLiteral("own/sub"));
            QDir(folder.path()).mkpath(QStringLiteral("own-not"));
        }
        [[nodiscard]] QString path(const char* name) const { return folder.path(QLatin1String(name)); }
        QString write(const char* name, const QByteArray& bytes) const
        {
            return folder.write(QLatin1String(name), bytes);
        }
    };

private Q_SLOTS:
    void namesThatLeadOut_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("within");
        const auto row = [](const char* name, bool within) {
            QTest::newRow(name) << QString::fromLatin1(name) << within;
        };
        row("a.png", true);
        row("./a.png", true);
        row("sub/a.png", true);
        row("sub/../a.png", true);
        row("missing/a.png", true);
        row("..a.png", true);
        row(":/rasterlens/cases/a.case", true);
        row("../a.png", false);
        row("sub/../../a.png", false);
        row("../own-not/a.png", false);
        row("../own", true);
        row("/etc/passwd", false);
        row("//server/share/a.png", false);
        row("/dev/zero", false);
        row("out/a.png", false);
        row("out", false);
        row("home/a.png", true);
        row("circle", false);
        row("out/../a.png", false);
    }

    void namesThatLeadOut()
    {
        QFETCH(QString, name);
        QFETCH(bool, within);
        const Disk disk;
        QVERIFY(QFile::link(QStringLiteral("../own-not"), disk.path("own/out")));
        QVERIFY(QFile::link(QStringLiteral("sub"), disk.path("own/home")));
        QVERIFY(QFile::link(QStringLiteral("circle"), disk.path("own/circle")));
        const Reach reach{disk.path("own")};
        QCOMPARE(reach.covers(name), within);
        QCOMPARE(reach.covers(QDir(reach.folder).absoluteFilePath(name)), within);
        const Reach agreed{disk.path("own"), Outside::Allow};
        QVERIFY(agreed.covers(name));
    }

    void materialsOutsideAreNotRead_data()
    {
        QTest::addColumn<QByteArray>("library");
        QTest::newRow("above") << QByteArray("../m.mtl");
        QTest::newRow("backslashes") << QByteArray("..\\m.mtl");
        QTest::newRow("absolute") << QByteArray("ABSOLUTE");
        QTest::newRow("another case") << QByteArray("../M.MTL");
        QTest::newRow("a link") << QByteArray("link.mtl");
        QTest::newRow("percent signs") << QByteArray("..%2Fm.mtl");
        QTest::newRow("a comment behind it") << QByteArray("../m.mtl # ours");
    }

    void materialsOutsideAreNotRead()
    {
        QFETCH(QByteArray, library);
        const Disk disk;
        const QString outside = disk.write("m.mtl", "newmtl a\nKd 0.25 0.5 0.75\n");
        QVERIFY(QFile::link(QStringLiteral("../m.mtl"), disk.path("own/link.mtl")));
        const QString obj = disk.write("own/m.obj", objOf(library.replace("ABSOLUTE", outside.toUtf8())));
        const auto [refused, named] = load(obj);
        QVERIFY(refused.scene && refused.scene->materials[0].diffuse != glm::vec3(0.25F, 0.5F, 0.75F));
        if (library != "..%2Fm.mtl") { // which is also the name of a file that might lie within
            verifyRemark(refused.diagnostics, obj + QStringLiteral(":1: "), QLatin1String(kRefused));
            QCOMPARE(named.size(), 1U);
            QCOMPARE(named[0].owner, obj);
        }
        const auto [agreed, none] = load(obj, Outside::Allow);
        QCOMPARE(agreed.scene->materials[0].diffuse, glm::vec3(0.25F, 0.5F, 0.75F));
        QVERIFY(none.empty());
    }

    void texturesOutsideAreNotRead_data()
    {
        QTest::addColumn<QByteArray>("image");
        QTest::addColumn<bool>("within");
        QTest::newRow("above") << QByteArray("../t.png") << false;
        QTest::newRow("absolute") << QByteArray("ABSOLUTE") << false;
        QTest::newRow("a link") << QByteArray("link.png") << false;
        // The reach is that of the model, not that of the file of materials in a folder below.
        QTest::newRow("beside the model") << QByteArray("../near.png") << true;
    }

    void texturesOutsideAreNotRead()
    {
        QFETCH(QByteArray, image);
        QFETCH(bool, within);
        const Disk disk;
        const QString outside = disk.write("t.png", pngBytes());
        disk.write("own/near.png", pngBytes());
        const bool isBelow = image == "../near.png";
        QVERIFY(QFile::link(QStringLiteral("../t.png"), disk.path("own/link.png")));
        const QByteArray mtl = "newmtl a\nmap_Kd " + image.replace("ABSOLUTE", outside.toUtf8()) + "\n";
        const QString library = disk.write(isBelow ? "own/sub/m.mtl" : "own/m.mtl", mtl);
        const QString obj = disk.write("own/m.obj", objOf(isBelow ? "sub/m.mtl" : "m.mtl"));
        const auto [refused, named] = load(obj);
        QCOMPARE(refused.scene->textures.size(), within ? 1U : 0U);
        QCOMPARE(named.size(), within ? 0U : 1U);
        if (!within)
            verifyRemark(refused.diagnostics, library + QStringLiteral(":2: "), QLatin1String(kRefused));
        QCOMPARE(load(obj, Outside::Allow).load.scene->textures.size(), 1U);
    }

    void texturesOfCasesOutsideAreNotRead()
    {
        const Disk disk;
        disk.write("t.png", pngBytes());
        disk.write("own/sub/t.png", pngBytes());
        const QByteArray text = QByteArray(kCase).replace("tri", "texture ../t.png\ntri");
        const QString path = disk.write("own/a.case", text);
        const auto [refused, named] = load(path);
        QVERIFY(!refused.scene && named.size() == 1);
        verifyRemark(refused.diagnostics, path + QStringLiteral(":2: "), QLatin1String(kRefused));
        QVERIFY(load(path, Outside::Allow).load.scene);
        const auto [own, none] = load(disk.write("own/b.case", QByteArray(text).replace("../", "sub/")));
        QVERIFY(own.scene && none.empty());
    }

    /// Exporters write the path of the machine that they ran on; a file of that name beside the model is its own.
    void namesOfOtherMachinesAreFoundBeside()
    {
        const Disk disk;
        disk.write("own/t.png", pngBytes());
        disk.write("own/m.mtl", "newmtl a\nmap_Kd /home/else/t.png\n");
        const auto [found, refused] = load(disk.write("own/m.obj", objOf("m.mtl")));
        QCOMPARE(found.scene->textures.size(), 1U);
        QVERIFY(refused.empty());
    }

    void scenesOfSessionsOutsideAreNotOpened()
    {
        const Disk disk;
        const QString scene = disk.write("a.case", kCase);
        const QString hidden = disk.write("own/sub/a.case", kCase);
        QVERIFY(QFile::link(QStringLiteral("../a.case"), disk.path("own/link.case")));
        for (const QString& name : {QStringLiteral("../a.case"), scene, QStringLiteral("link.case")}) {
            const QString session =
                disk.write("own/s.json", R"({"rasterlens": 1, "scene": ")" + name.toUtf8() + R"("})");
            const SessionLoad refused = loadSession(session);
            QVERIFY(!refused.session);
            verifyRemark(refused.diagnostics, session + QStringLiteral(": "), QStringLiteral("(--allow-outside)"));
            const auto [agreed, none] = readWith(Outside::Allow, [&] { return loadSession(session); });
            QVERIFY(agreed.session && agreed.session->sceneFound && none.empty());
            const SessionLoad chosen = loadSession(session, scene);
            QCOMPARE(chosen.session->scene, scene);
        }
        const SessionLoad own = loadSession(disk.write("own/o.json", R"({"rasterlens": 1, "scene": "sub/a.case"})"));
        QCOMPARE(own.session->scene, hidden);
    }

    void scenesOfLessonsOutsideAreNotOpened()
    {
        const Disk disk;
        const QString scene = disk.write("a.case", kCase);
        disk.write("own/sub/a.case", kCase);
        for (const QByteArray& name : {QByteArray("../a.case"), scene.toUtf8()}) {
            const QString lesson = disk.write("own/l.json", lessonOf(name));
            const LessonLoad refused = loadLesson(lesson);
            QVERIFY(!refused.lesson);
            verifyRemark(refused.diagnostics, lesson + QStringLiteral(":2: "),
                         QStringLiteral("lies outside the lesson's folder"));
            const auto [agreed, none] = readWith(Outside::Allow, [&] { return loadLesson(lesson); });
            QVERIFY2(agreed.lesson && agreed.lesson->slides[0].moment.scene == scene,
                     qPrintable(textOf(agreed.diagnostics)));
        }
        QVERIFY(loadLesson(disk.write("own/o.json", lessonOf("sub/a.case"))).lesson);
    }

    /// A pipe would keep the program waiting, a device may give bytes for ever.
    void pipesAndDevicesAreNotRead_data()
    {
        QTest::addColumn<QString>("device");
        QTest::newRow("pipe") << QString();
        QTest::newRow("zero") << QStringLiteral("/dev/zero");
        QTest::newRow("terminal") << QStringLiteral("/dev/tty");
    }

    void pipesAndDevicesAreNotRead()
    {
        QFETCH(QString, device);
        const Disk disk;
        const auto place = [&](const char* name) {
            const QString path = disk.path(name);
            QFile::remove(path);
            const bool made =
                device.isEmpty() ? ::mkfifo(QFile::encodeName(path).constData(), 0600) == 0 : QFile::link(device, path);
            if (!made)
                qFatal("%s cannot be made", name);
            return path;
        };
        const QString said = QStringLiteral("this is a device or a pipe; a file is expected");
        for (const char* name : {"own/p.obj", "own/p.case"})
            verifyRemark(loadScene(place(name)).diagnostics, disk.path(name), said);
        verifyRemark(loadSession(place("own/p.json")).diagnostics, disk.path("own/p.json"), said);
        verifyRemark(loadLesson(disk.path("own/p.json")).diagnostics, disk.path("own/p.json"), said);
        QVERIFY(!isLesson(disk.path("own/p.json")));
        place("own/p.mtl");
        verifyRemark(load(disk.write("own/a.obj", objOf("p.mtl")), Outside::Allow).load.diagnostics, {}, said);
        place("own/p.png");
        disk.write("own/b.mtl", "newmtl a\nmap_Kd p.png\nmap_d p.png\n");
        verifyRemark(load(disk.write("own/b.obj", objOf("b.mtl")), Outside::Allow).load.diagnostics, {}, said);
        LoadOptions options;
        options.texture = disk.path("own/p.png");
        verifyRemark(loadScene(disk.path("own/b.obj"), options).diagnostics, options.texture, said);
        const QString session = disk.write("own/s.json", R"({"rasterlens": 1, "scene": "p.case"})");
        const Consent consent(Outside::Allow);
        QVERIFY(!loadSession(session).session->sceneFound);
        const LessonLoad lesson = loadLesson(disk.write("own/l.json", lessonOf("p.case")));
        verifyRemark(lesson.diagnostics, {}, QStringLiteral("there is no scene \"p.case\""));
    }

    void hugeFilesAreRefusedUnread()
    {
        const Disk disk;
        const QString said = QStringLiteral("the file is larger than 2 GB");
        const auto huge = [&](const char* name) {
            QFile file(disk.path(name)); // has a size, but takes no place on the disk
            if (!file.open(QIODevice::WriteOnly) || !file.resize(qint64(3) << 30))
                qFatal("%s cannot be made", name);
            return file.fileName();
        };
        for (const char* name : {"own/h.obj", "own/h.case"})
            verifyRemark(loadScene(huge(name)).diagnostics, disk.path(name), said);
        verifyRemark(loadSession(huge("own/h.json")).diagnostics, disk.path("own/h.json"), said);
        verifyRemark(loadLesson(disk.path("own/h.json")).diagnostics, disk.path("own/h.json"), said);
        huge("own/h.mtl");
        verifyRemark(load(disk.write("own/a.obj", objOf("h.mtl"))).load.diagnostics, {}, said);
        huge("own/h.png");
        disk.write("own/b.mtl", "newmtl a\nmap_Kd h.png\n");
        verifyRemark(load(disk.write("own/b.obj", objOf("b.mtl"))).load.diagnostics, {}, said);
    }

    void deepNestingIsAnError()
    {
        const Disk disk;
        constexpr int kDeep = 200000;
        const QByteArray deep = QByteArray(kDeep, '[') + QByteArray(kDeep, ']');
        const QString session =
            disk.write("own/s.json", R"({"rasterlens": 1, "scene": "builtin:cube", "settings": )" + deep + "}");
        verifyRemark(loadSession(session).diagnostics, session + QStringLiteral(":1: "), QStringLiteral("broken JSON"));
        const QString lesson = disk.write("own/l.json", R"({"rasterlens-lesson": 1, "steps": )" + deep + "}");
        verifyRemark(loadLesson(lesson).diagnostics, lesson + QStringLiteral(":1: "), QStringLiteral("broken JSON"));
    }

    /// A library is read once, however often and by whatever name it is asked for.
    void librariesThatNameEachOtherEnd()
    {
        const Disk disk;
        disk.write("own/m.mtl", "newmtl a\nKd 1 0 0\nmtllib m.mtl\ncall m.mtl\n");
        QByteArray obj;
        for (int i = 0; i < 1000; ++i)
            obj += i % 2 == 0 ? "mtllib m.mtl\n" : "mtllib ./m.mtl\n";
        const SceneLoad scene = loadScene(disk.write("own/m.obj", obj + objOf("m.mtl")));
        QVERIFY(scene.scene && scene.scene->materials.size() == 1);
    }
};

QTEST_GUILESS_MAIN(TestReach)
#include "test_reach.moc"
