// The command line as scripts see it: exit codes, messages, and files that are written whole or not at all.
#include "cli_support.h"
#include "core/io/npy.h"
#include "core/scenes/builtin_scenes.h"
#include "core/settings/mistakes.h"
#include "core/settings/settings.h"

#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <memory>
#include <utility>
#include <variant>
#include <vector>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

/// A red rectangle over the left half of 8 x 6 pixels at depth 0.75.
constexpr char kCase[] = "size 8 6\n"
                         "tri -1 -1 0.5 1 1 0 0   0 -1 0.5 1 1 0 0   0 1 0.5 1 1 0 0\n"
                         "tri -1 -1 0.5 1 1 0 0   0 1 0.5 1 1 0 0   -1 1 0.5 1 1 0 0\n";

constexpr char kObj[] = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n";

} // namespace

class TestCli : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void helpAndVersion();
    void badCalls_data();
    void badCalls();
    void allOutputsOrNone();
    void fullDiskIsAnError();
    void littleMemoryIsAnError_data();
    void littleMemoryIsAnError();
    void pictureGoesToStdout();
    void drawsWithoutAPicture();
    void arraysHaveTheShapeOfThePicture();
    void sizeComesFromTheSceneUnlessGiven();
    void numbersAreReadAsPeopleTypeThem();
    void everyOptionReachesTheSettings();
    void sessionIsTheBase();
    void countersAreConserved_data();
    void countersAreConserved();
    void statisticsNameWhatWorked();
    void missingInstructionsAreNamed();
    void infoAsTextAndJson();

private:
    std::unique_ptr<QTemporaryDir> m_folder;

    QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    QStringList entries() const { return QDir(m_folder->path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot); }
    Run call(const QString& words) const { return run(words.split(QLatin1Char(' ')), m_folder->path()); }
    QJsonObject statisticsOf(const QString& words) const;
};

void TestCli::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(m_folder->isValid());
    writeFile(path("a.case"), kCase);
    writeFile(path("a.obj"), kObj);
    writeFile(path("empty.obj"), {});
    writeFile(path("bad.case"), "size 8 6\ntriangle 1 2 3\n");
    writeFile(path("broken.json"), "{\n\"rasterlens\": 1,\n\"scene\" \n}");
    writeFile(path("text.txt"), "hello");
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("folder")));
    QVERIFY(filled(4, 4, qRgb(0, 0, 0)).save(path("4x4.png")));
    QVERIFY(filled(8, 4, qRgb(0, 0, 0)).save(path("8x4.png")));
    const float numbers[] = {0, 1};
    writeFile(path("f.npy"), npyBytes(std::span<const float>(numbers), 1, 2));
    writeFile(path("tall.npy"), npyBytes(std::span<const float>(numbers), 2, 1));
    writeFile(path("none.npy"), npyBytes(std::span<const float>(), 0, 2));
    QVERIFY(filled(2, 2, qRgb(9, 9, 9)).save(path("t.png")));
    writeFile(path("t.mtl"), "newmtl m\nmap_Kd t.png\n");
    writeFile(path("textured.obj"), QByteArray("mtllib t.mtl\nusemtl m\n") + kObj);
    writeFile(path("session.json"), R"({"rasterlens": 1, "scene": "a.case", "settings": {}})");
}

void TestCli::helpAndVersion()
{
    for (const char* words : {"--help", "-h", "render --help", "render -h", "info --help", "diff --help",
                              "render a.case --help --size 1x1"}) {
        const Run help = call(QLatin1String(words));
        QCOMPARE(help.exitCode, 0);
        QCOMPARE(help.err, QString());
        QVERIFY2(help.out.startsWith("Usage: rasterlens-cli "), words);
        QVERIFY2(help.out.contains("Exit codes: 0 "), words);
        for (const QByteArray& line : help.out.split('\n'))
            QVERIFY2(line.size() <= 100, line.constData());
    }
    for (const char* words : {"--version", "render --version"})
        QCOMPARE(call(QLatin1String(words)).out, QByteArray("rasterlens-cli " RASTERLENS_VERSION "\n"));
    const QByteArray help = call(QStringLiteral("render --help")).out;
    for (const SettingsField& field : settingsFields())
        QVERIFY2(help.contains(QByteArray("--") + field.id), field.id);
    for (const BuiltinScene& scene : builtinScenes())
        QVERIFY2(help.contains(scene.name), scene.name);
    const QByteArray list = call(QStringLiteral("render --list-mistakes")).out;
    QCOMPARE(list.count('\n'), static_cast<qsizetype>(mistakes().size()));
    for (const Mistake& mistake : mistakes())
        QVERIFY2(list.contains(mistake.id), mistake.id);
}

void TestCli::badCalls_data()
{
    // A message that ends in * is a beginning.
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* words, int exitCode, const char* message) {
        QTest::newRow(words) << exitCode << QString::fromLatin1(message);
    };
    row("", 2, "rasterlens-cli: a verb is missing; expected: render, info, diff*");
    row("draw", 2, "rasterlens-cli: \"draw\" is not a verb; expected: render, info, diff*");
    row("--verbose", 2, "rasterlens-cli: \"--verbose\" is not a verb; expected: render*");
    row("render", 2,
        "rasterlens-cli render: SCENE is missing; expected: rasterlens-cli render SCENE [-o out.png] [options]");
    row("render a.case b.case", 2,
        "rasterlens-cli render: \"b.case\" is one argument too many; expected: rasterlens-cli render SCENE [-o "
        "out.png] "
        "[options]");
    row("render  --size 4x4", 2, "rasterlens-cli render: an argument is empty; expected: rasterlens-cli render SCENE*");
    row("render a.case --cullling none", 2,
        "rasterlens-cli render: there is no option --cullling; did you mean --culling?");
    row("render a.case --xylophone", 2,
        "rasterlens-cli render: there is no option --xylophone; \"rasterlens-cli render --help\" lists all");
    row("render a.case -x", 2, "rasterlens-cli render: there is no option -x; did you mean -o?");
    row("render a.case --culling sideways", 2,
        "--culling: \"sideways\" is not a value of culling, which takes: back, front, none");
    row("render a.case --light 0,0,0", 2, "--light: \"0,0,0\" is not a value of light, which takes: head, or three*");
    row("render a.case --light nan,0,1", 2, "--light: \"nan,0,1\" is not a value of light*");
    row("render a.case --light 1,2", 2, "--light: \"1,2\" is not a value of light*");
    row("render a.case --culling", 2, "rasterlens-cli render: --culling needs a value: --culling ID");
    row("render a.case --culling --size 4x4", 2, "rasterlens-cli render: --culling needs a value: --culling ID");
    row("render a.case --culling=", 2, "rasterlens-cli render: --culling needs a value: --culling ID");
    row("render a.case --reversed-z=maybe", 2,
        "rasterlens-cli render: \"maybe\" is not a value of --reversed-z, which takes: true, false");
    row("render a.case --subpixel-bits 9", 2,
        "--subpixel-bits: \"9\" is not a value of subpixel-bits, which takes: 0 to 8");
    row("render a.case --subpixel-bits -1", 2,
        "--subpixel-bits: \"-1\" is not a value of subpixel-bits, which takes: 0 to 8");
    row("render a.case --subpixel-bits 1.5", 2,
        "--subpixel-bits: \"1.5\" is not a value of subpixel-bits, which takes: 0 to 8");
    for (const char* threads : {"many", "-1", "257"})
        QTest::newRow(qPrintable(QStringLiteral("render a.case --threads %1").arg(QLatin1String(threads))))
            << 2
            << QStringLiteral("--threads: \"%1\" is not a value of threads, which takes: auto, or 1 to 256")
                   .arg(QLatin1String(threads));
    for (const char* size : {"0x0", "99999x1", "4", "4x", "-4x4", "4x4x4", "1e1x4", "16385x1", "nan"})
        QTest::newRow(qPrintable(QStringLiteral("render a.case --size %1").arg(QLatin1String(size))))
            << 2
            << QStringLiteral(
                   "--size: \"%1\" is not a value of size, which takes: WIDTHxHEIGHT in pixels, 1 to 16384 each")
                   .arg(QLatin1String(size));
    for (const char* fov : {"180", "0", "-45", "wide", "nan", "inf", "45,45"})
        QTest::newRow(qPrintable(QStringLiteral("render a.obj --fov %1").arg(QLatin1String(fov))))
            << 2
            << QStringLiteral(
                   "--fov: \"%1\" is not a value of fov, which takes: the vertical angle in degrees, 0.001 to 179.9")
                   .arg(QLatin1String(fov));
    for (const double near : {2.0, 1.0})
        row(qPrintable(QStringLiteral("render a.obj --near %1 --far 1").arg(near)), 2,
            qPrintable(
                QStringLiteral("--far: the far plane is at 1, but must lie beyond the near plane at %1: z' = n + f - "
                               "nf/z runs from n to f, which leaves no depth between")
                    .arg(near)));
    for (const char* near : {"0", "-0.1"})
        row(qPrintable(QStringLiteral("render a.obj --near %1 --far 5").arg(QLatin1String(near))), 2,
            qPrintable(
                QStringLiteral("--near: the near plane is at %1, but must lie before the eye, at more than 0: with "
                               "n = 0, z' = n + f - nf/z is f for every z, and x' = nx/z is 0 for every x")
                    .arg(QLatin1String(near))));
    row("render a.obj --far -1", 2, "--far: the far plane is at -1, but must lie before the eye, at more than 0");
    row("render a.obj --near wide", 2,
        "--near: \"wide\" is not a value of near, which takes: a distance greater than 0");
    row("render a.obj --view side", 2, "--view: \"side\" is not a value of view, which takes: fit");
    row("render a.obj --eye (1,2", 2, "--eye: \"(1,2\" is not a value of eye, which takes: three numbers x,y,z");
    row("render a.obj --eye 1,2", 2, "--eye: \"1,2\" is not a value of eye, which takes: three numbers x,y,z");
    row("render a.obj --eye 1,2,x", 2, "--eye: \"1,2,x\" is not a value of eye, which takes: three numbers x,y,z");
    row("render a.obj --eye 0,0,0", 2, "--eye: the eye is where the target is; two different points are expected");
    row("render a.obj --eye 0,5,0", 2, "--up: points along the gaze; another direction is expected");
    row("render a.obj --target 1,2,3", 2, "--target: needs --eye beside it");
    row("render a.obj --up 1,2,3", 2, "--up: needs --eye beside it");
    row("render a.obj --eye 0,0,5 --orbit 1,2", 2,
        "--eye: cannot be combined with --orbit; one of the two is expected");
    row("render a.obj --eye 0,0,5 --view fit", 2, "--eye: cannot be combined with --view; one of the two is expected");
    row("render a.obj --orbit 10", 2,
        "--orbit: \"10\" is not a value of orbit, which takes: yaw,pitch in degrees, the pitch from -90 to 90");
    row("render a.obj --orbit 0,91", 2,
        "--orbit: \"0,91\" is not a value of orbit, which takes: yaw,pitch in degrees, the pitch from -90 to 90");
    row("render a.case --mistake nonsense", 2,
        "--mistake: there is no mistake \"nonsense\"; --list-mistakes lists those there are");
    row("render a.case --attribute-path edge-then-span", 2, "rasterlens-cli render: *");
    row("render a.case -o", 2, "rasterlens-cli render: -o needs a value: -o FILE");
    row("render a.case -o out.gif", 2,
        "out.gif: \"gif\" is not a format pictures are written in, which are: png, ppm, bmp, jpg, jpeg");
    row("render a.case -o - --stats -", 2, "-: two outputs have this name; each needs its own");
    row("render a.case -o x.png --stats ./x.png", 2, "./x.png: two outputs have this name; each needs its own");
    row("render missing.obj", 3, "missing.obj: *");
    row("render missing.case", 3, "missing.case: *");
    row("render missing.json", 3, "missing.json: *");
    row("render folder", 3, "folder: *");
    row("render text.txt", 3, "text.txt: *");
    row("render empty.obj", 3, "empty.obj: *");
    row("render bad.case", 3, "bad.case:2: *");
    row("render broken.json", 3, "broken.json:4: *");
    row("render builtin:nonsense", 3, "builtin:nonsense: *");
    row("render stress:nonsense", 3, "stress:nonsense: *");
    row("render a.obj --texture missing.png", 3, "missing.png: *");
    row("render missing.obj -o nowhere/out.png", 3, "nowhere/out.png: cannot be written: *"); // said before the work
    row("render a.case -o folder", 3, "folder: cannot be written: it is a folder; the name of a file is expected");
    row("render a.case -o nowhere/out.png", 3, "nowhere/out.png: cannot be written: *");
    row("render a.case -o text.txt/out.png", 3, "text.txt/out.png: cannot be written: *");
    row("render a.case --stats nowhere/s.json", 3, "nowhere/s.json: cannot be written: *");
    row("info", 2, "rasterlens-cli info: SCENE is missing; expected: rasterlens-cli info SCENE [options]");
    row("info missing.obj", 3, "missing.obj: *");
    row("info a.obj --culling none", 2, "rasterlens-cli info: there is no option --culling; *");
    row("diff 4x4.png", 2,
        "rasterlens-cli diff: B is missing; expected: rasterlens-cli diff A B [-o heat.png] [--threshold T] [--json "
        "F.json]");
    row("diff 4x4.png 8x4.png", 3, "8x4.png: is 8x4, but 4x4.png is 4x4; pictures of equal size are expected");
    row("diff 4x4.png missing.png", 3, "missing.png: cannot be read: *");
    row("diff text.txt 4x4.png", 3,
        "text.txt: is not a picture that can be read; PNG, PPM, BMP, JPEG or TGA is expected: *");
    row("diff 4x4.png folder", 3, "folder: cannot be read: *");
    row("diff 4x4.png 4x4.png --threshold -1", 2,
        "--threshold: \"-1\" is not a value of threshold, which takes: a number, 0 or more");
    row("diff 4x4.png 4x4.png -o heat.svg", 2,
        "heat.svg: \"svg\" is not a format pictures are written in, which are: png, ppm, bmp, jpg, jpeg");
    row("diff 4x4.png 4x4.png -o nowhere/heat.png", 3, "nowhere/heat.png: cannot be written: *");
    row("diff 4x4.png f.npy", 2,
        "rasterlens-cli diff: a picture and an array cannot be compared; two of a kind are expected");
    row("diff f.npy f.npy -o heat.png", 2, "rasterlens-cli diff: -o draws a heat map of pictures; arrays have none");
    row("diff f.npy tall.npy", 3,
        "tall.npy: is <f4 of shape (2, 1), but f.npy is <f4 of shape (1, 2); equal shapes are expected");
    row("diff none.npy none.npy", 3, "none.npy: is of shape (0, 2): no values to compare");
    const QString inUse =
        QStringLiteral(": it is in use as an input and would be overwritten; another name is expected");
    for (const auto& [words, name] : std::initializer_list<std::pair<const char*, const char*>>{
             {"render a.case -o p.png --depth a.case", "a.case"},
             {"render a.case -o p.png --stats ./a.case", "./a.case"},
             {"render textured.obj -o t.png", "t.png"},
             {"render textured.obj -o p.png --ids t.mtl", "t.mtl"},
             {"render a.obj --texture t.png -o t.png", "t.png"},
             {"render session.json -o p.png --stats session.json", "session.json"},
             {"render session.json -o p.png --stats a.case", "a.case"},
             {"steps a.case --json a.case", "a.case"},
             {"why a.case --pixel 1,1 --json a.case", "a.case"},
             {"bench a.case --csv a.case --frames 1", "a.case"},
             {"diff 4x4.png 8x4.png -o 8x4.png", "8x4.png"},
             {"diff f.npy tall.npy --json tall.npy", "tall.npy"}})
        QTest::newRow(words) << 2 << QLatin1String(name) + inUse;
}

void TestCli::badCalls()
{
    QFETCH(int, exitCode);
    QFETCH(QString, message);
    const QString words = QLatin1String(QTest::currentDataTag());
    const QStringList before = entries();
    const Run bad = words.isEmpty() ? run({}, m_folder->path()) : call(words);
    if (message.endsWith(QLatin1Char('*'))) {
        message.chop(1);
        QVERIFY2(bad.err.startsWith(message), qPrintable(bad.err));
    } else {
        QCOMPARE(bad.err, message + QLatin1Char('\n'));
    }
    QCOMPARE(bad.exitCode, exitCode);
    QCOMPARE(bad.out, QByteArray());
    QCOMPARE(entries(), before);
}

void TestCli::allOutputsOrNone()
{
    writeFile(path("old.png"), "old");
    const QStringList before = entries();
    for (const char* words :
         {"render a.case -o new.png --depth nowhere/d.npy", "render a.case -o old.png --depth folder",
          "render a.case -o old.png --ids text.txt/i.npy --stats s.json",
          "render a.case -o nowhere/out.png --coverage c.npy", "render bad.case -o old.png",
          "render a.case -o - --stats nowhere/s.json"}) {
        const Run bad = call(QLatin1String(words));
        QVERIFY2(bad.exitCode == 3, words);
        QCOMPARE(bad.out, QByteArray());
        QCOMPARE(entries(), before);
        QCOMPARE(readFile(path("old.png")), QByteArray("old"));
    }
}

void TestCli::fullDiskIsAnError()
{
    const QString device = QStringLiteral("/dev/full");
    if (!QFile::exists(device))
        QSKIP("this system has no /dev/full");
    const Run full = call(QStringLiteral("render a.case -o out.png --stats ") + device);
    QCOMPARE(full.exitCode, 3);
    QVERIFY2(full.err.startsWith(device + QLatin1String(": cannot be written: ")), qPrintable(full.err));
    QVERIFY(!QFile::exists(path("out.png")));
    QVERIFY2(!QFileInfo(device).isFile(), "the device is still a device");
}

void TestCli::littleMemoryIsAnError_data()
{
    QTest::addColumn<QString>("message");
    const QString memory =
        QStringLiteral("there is not enough memory; a smaller --size or fewer --samples need less\n");
    QTest::newRow("--size 16384x16384") << memory;
    QTest::newRow("--size 16384x16384 --algorithm tiled --threads 1") << memory;
    QTest::newRow("--size 4000x4000 --samples 4x4") << memory;
    QTest::newRow("--algorithm tiled --threads 256") << QStringLiteral("threads cannot be started: ");
}

/// In less address space than the 1 GiB of the largest picture, or 256 stacks of 8 MiB.
void TestCli::littleMemoryIsAnError()
{
    if (RASTERLENS_SANITIZED)
        QSKIP("a sanitizer needs more address space than there is memory");
    QFETCH(QString, message);
    const QStringList before = entries();
    const QString words = QStringLiteral("render builtin:cube ") + QLatin1String(QTest::currentDataTag());
    const QString limited = QStringLiteral("ulimit -S -s 8192; ulimit -v 1000000; exec \"$0\" \"$@\"");
    const Run bad = run(QStringList{"-c", limited, RASTERLENS_CLI} + words.split(QLatin1Char(' ')), m_folder->path(),
                        QStringLiteral("sh"));
    QVERIFY2(bad.err.contains(QStringLiteral("rasterlens-cli: ") + message), qPrintable(bad.err));
    QCOMPARE(bad.exitCode, 2);
    QCOMPARE(bad.out, QByteArray());
    QCOMPARE(entries(), before);
}

void TestCli::pictureGoesToStdout()
{
    const Run stdoutRun = call(QStringLiteral("render a.case -o -"));
    QCOMPARE(stdoutRun.exitCode, 0);
    QCOMPARE(stdoutRun.err, QString());
    QVERIFY(!QFile::exists(path("out.png")));
    const Run fileRun = call(QStringLiteral("render a.case"));
    QCOMPARE(fileRun.exitCode, 0);
    QCOMPARE(fileRun.out, QByteArray());
    QCOMPARE(stdoutRun.out, readFile(path("out.png")));
    for (const char* name : {"b.ppm", "b.bmp", "B.PNG", "b"}) {
        QCOMPARE(call(QStringLiteral("render a.case -o ") + QLatin1String(name)).exitCode, 0);
        QCOMPARE(QImage::fromData(readFile(path(name))).convertToFormat(QImage::Format_RGB32),
                 QImage(path("out.png")).convertToFormat(QImage::Format_RGB32));
    }
}

void TestCli::drawsWithoutAPicture()
{
    const QStringList before = entries();
    QCOMPARE(call(QStringLiteral("render a.case --depth with.npy -o p.png")).exitCode, 0);
    const Run good = call(QStringLiteral("render a.case --depth alone.npy --stats s.json --no-picture"));
    QCOMPARE(good.err, QString());
    QCOMPARE(good.exitCode, 0);
    QCOMPARE(readFile(path("alone.npy")), readFile(path("with.npy")));
    QVERIFY(!QFile::exists(path("out.png")));
    QVERIFY(readFile(path("s.json")).contains("\"shaded\": 0"));
    QCOMPARE(call(QStringLiteral("render a.case --no-picture")).exitCode, 2);
    QCOMPARE(call(QStringLiteral("render a.case --no-picture -o p.png --depth d.npy")).exitCode, 2);
    for (const char* name : {"with.npy", "alone.npy", "s.json", "p.png"})
        QFile::remove(path(name));
    QCOMPARE(entries(), before);
}

void TestCli::arraysHaveTheShapeOfThePicture()
{
    const Run good = call(QStringLiteral("render a.case --depth d.npy --ids i.npy --coverage c.npy -o p.png"));
    QCOMPARE(good.err, QString());
    QCOMPARE(good.exitCode, 0);
    const NpyRead depth = readNpy(readFile(path("d.npy")));
    const NpyRead ids = readNpy(readFile(path("i.npy")));
    const NpyRead coverage = readNpy(readFile(path("c.npy")));
    QVERIFY(depth.array && ids.array && coverage.array);
    QCOMPARE(depth.array->type, QStringLiteral("<f4"));
    QCOMPARE(ids.array->type, QStringLiteral("<i4"));
    QCOMPARE(coverage.array->type, QStringLiteral("<u2"));
    for (const NpyRead* read : {&depth, &ids, &coverage}) {
        QVERIFY(read->array->shape == (std::vector<qint64>{6, 8}));
    }
    const QImage image(path("p.png"));
    QCOMPARE(image.size(), QSize(8, 6));
    const auto valuesOf = [](const NpyRead& read) { return std::get<std::vector<double>>(read.array->values); };
    const std::vector<double> depths = valuesOf(depth);
    const std::vector<double> faces = valuesOf(ids);
    const std::vector<double> counts = valuesOf(coverage);
    for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 8; ++x) {
            const auto i = static_cast<std::size_t>(8 * y + x);
            const bool inside = x < 4;
            QCOMPARE(image.pixel(x, y), inside ? qRgb(255, 0, 0) : qRgb(0, 0, 0));
            QCOMPARE(depths[i], inside ? 0.75 : 1.0);
            QCOMPARE(counts[i], inside ? 1.0 : 0.0);
            QVERIFY(inside ? faces[i] >= 0 : faces[i] == -1);
        }
}

QJsonObject TestCli::statisticsOf(const QString& words) const
{
    const Run good = call(words + QStringLiteral(" -o picture.ppm --stats -"));
    if (good.exitCode != 0)
        qWarning("%s: %s", qPrintable(words), qPrintable(good.err));
    return QJsonDocument::fromJson(good.out).object();
}

void TestCli::sizeComesFromTheSceneUnlessGiven()
{
    const auto size = [this](const char* words) {
        return statisticsOf(QLatin1String(words))["settings"].toObject()["size"].toString();
    };
    QCOMPARE(size("render a.case"), QStringLiteral("8x6"));
    QCOMPARE(size("render a.case --size 3x5"), QStringLiteral("3x5"));
    QCOMPARE(QImage(path("picture.ppm")).size(), QSize(3, 5));
    QCOMPARE(size("render a.obj"), QStringLiteral("1920x1080"));
}

void TestCli::numbersAreReadAsPeopleTypeThem()
{
    const auto why = [this](const QString& size, const QString& pixel, const QString& eye) {
        return run({"why", "a.obj", "--size", size, "--pixel", pixel, "--eye", eye}, m_folder->path());
    };
    const Run plain = why("12x9", "3,4", "0,0,5");
    QCOMPARE(plain.exitCode, 0);
    const std::pair<const char*, const char*> kForms[] = {
        {"12 x 9", "3 4"}, {"12\u00d79", "(3, 4)"}, {"12*9", "3\uff0c4"}, {"12 9", "\uff083\uff0c4\uff09"}};
    for (const auto& [size, pixel] : kForms) {
        const Run run = why(QString::fromUtf8(size), QString::fromUtf8(pixel), QString::fromUtf8("0\uff0c 0 5"));
        QVERIFY2(run.exitCode == 0, qPrintable(run.err));
        QCOMPARE(run.out, plain.out);
    }
    QCOMPARE(why("12x9e", "3,4", "0,0,5").exitCode, 2);
    QCOMPARE(why("12x9", "3,4,5", "0,0,5").exitCode, 2);
}

void TestCli::everyOptionReachesTheSettings()
{
    const auto settingsOf = [this](const QString& words) {
        return settingsFromJson(statisticsOf(words)["settings"].toObject()).settings;
    };
    const Settings base = settingsOf(QStringLiteral("render a.obj --size 8x8"));
    int drawn = 0;
    for (const SettingsField& field : settingsFields())
        for (int value = field.minimum; value <= std::min(field.maximum, field.minimum + 16); ++value) {
            Settings expected = base;
            field.set(expected, value);
            const QString option = QStringLiteral("--%1=%2").arg(QLatin1String(field.id), valueId(field, expected));
            const QString words = QStringLiteral("render a.obj --size 8x8 ") + option;
            const Run made = call(words + QStringLiteral(" -o p.ppm --stats s.json"));
            QVERIFY2(made.exitCode == 0 || made.exitCode == 2, qPrintable(made.err));
            if (made.exitCode == 2)
                continue;
            const QJsonObject json = QJsonDocument::fromJson(readFile(path("s.json"))).object();
            QVERIFY2(settingsFromJson(json["settings"].toObject()).settings == expected, qPrintable(option));
            ++drawn;
        }
    QVERIFY(drawn > 50);

    QVERIFY(settingsOf(QStringLiteral("render --reversed-z a.obj --size 8x8")).reversedZ);
    QVERIFY(!settingsOf(QStringLiteral("render a.obj --reversed-z --reversed-z false --size 8x8")).reversedZ);
    QCOMPARE(settingsOf(QStringLiteral("render a.obj --threads auto --size 8x8")).threads, 0);
    QVERIFY(settingsOf(QStringLiteral("render a.obj --light head --size 8x8")).light.isHead());
    const View orbit = settingsOf(QStringLiteral("render a.obj --size 8x8 --orbit -30,20.5 --fov 60")).view;
    QVERIFY(orbit.fit && orbit.yaw == -30 && orbit.pitch == 20.5 && orbit.fov == 60);
    const View eye =
        settingsOf(QStringLiteral("render a.obj --size 8x8 --eye 1,2,3 --target -1,0,0.5 --up 0,0,1 --near .5 --far 9"))
            .view;
    QVERIFY(!eye.fit && eye.eye == glm::dvec3(1, 2, 3) && eye.target == glm::dvec3(-1, 0, 0.5));
    QVERIFY(eye.up == glm::dvec3(0, 0, 1) && eye.near == 0.5 && eye.far == 9);
}

void TestCli::sessionIsTheBase()
{
    writeFile(path("s.json"), R"({"rasterlens": 1, "scene": "a.case", "settings": {"size": "5x4", "shading": "depth",
                                  "culling": "none", "view": {"yaw": 45}}})");
    const SettingsParse plain = settingsFromJson(statisticsOf(QStringLiteral("render s.json"))["settings"].toObject());
    QCOMPARE(plain.settings.size, QSize(5, 4));
    QCOMPARE(plain.settings.shading, Shading::Depth);
    QCOMPARE(plain.settings.view.yaw, 45.0);
    const SettingsParse changed = settingsFromJson(
        statisticsOf(QStringLiteral("render s.json --shading uv --size 6x6 --view fit"))["settings"].toObject());
    QCOMPARE(changed.settings.size, QSize(6, 6));
    QCOMPARE(changed.settings.shading, Shading::Uv);
    QCOMPARE(changed.settings.culling, Culling::None);
    QCOMPARE(changed.settings.view.yaw, 0.0);

    writeFile(path("folder/s.json"), R"({"rasterlens": 1, "scene": "../a.case", "settings": {}})");
    QVERIFY(call(QStringLiteral("info folder/s.json")).err.contains(QLatin1String("(--allow-outside)")));
    const Run below = call(QStringLiteral("info folder/s.json --allow-outside"));
    QVERIFY2(below.exitCode == 0, qPrintable(below.err));

    writeFile(path("s.json"), R"({"rasterlens": 1, "scene": "a.case", "settings": {"mistakes": ["nonsense"]}})");
    const Run bad = call(QStringLiteral("render s.json"));
    QCOMPARE(bad.exitCode, 3);
    QVERIFY2(bad.err.startsWith(QLatin1String("s.json: there is no mistake \"nonsense\"; ")), qPrintable(bad.err));
}

void TestCli::countersAreConserved_data()
{
    QTest::addColumn<QString>("words");
    for (const BuiltinScene& scene : builtinScenes()) {
        const QString name = QStringLiteral("builtin:") + QLatin1String(scene.name);
        QTest::newRow(scene.name) << name;
        for (const char* options : {"--algorithm edge-walking --clipping guard-band", "--culling front --samples 2x2",
                                    "--clipping any-vertex-inside --visibility painter"})
            QTest::newRow(qPrintable(QLatin1String(scene.name) + QLatin1Char(' ') + QLatin1String(options)))
                << name + QLatin1Char(' ') + QLatin1String(options);
    }
}

void TestCli::countersAreConserved()
{
    QFETCH(QString, words);
    const QJsonObject statistics = statisticsOf(QStringLiteral("render --size 160x120 ") + words);
    QCOMPARE(statistics.keys(),
             QStringList({"faces", "lines", "milliseconds", "pixels", "settings", "simd", "threads"}));
    const auto face = [&](const char* key) { return statistics["faces"][QLatin1String(key)].toInteger(-1); };
    const auto pixel = [&](const char* key) { return statistics["pixels"][QLatin1String(key)].toInteger(-1); };
    QVERIFY(face("submitted") > 0);
    QCOMPARE(face("submitted"), face("rejected") + face("culled_back") + face("culled_front") + face("degenerate") +
                                    face("non_finite") + face("rasterized"));
    QVERIFY(face("clipped") >= 0 && face("clipped") <= face("submitted") && face("created_by_clipping") >= 0);
    QCOMPARE(pixel("covered"), pixel("depth_passed") + pixel("depth_failed"));
    // Lines and points are covered without a test, and neighbours draw the line between them twice.
    if (statistics["settings"].toObject()["fill"] == QLatin1String("solid")) {
        QVERIFY(pixel("covered") <= pixel("tested"));
        QCOMPARE(pixel("covered_twice"), 0);
    }
    QVERIFY(pixel("written") >= 0 && pixel("shaded") >= 0);
    for (const char* key : {"vertex", "geometry", "raster", "total"})
        QVERIFY2(statistics["milliseconds"][QLatin1String(key)].toDouble(-1) >= 0, key);
}

void TestCli::statisticsNameWhatWorked()
{
    const QJsonObject one = statisticsOf(QStringLiteral("render a.case --threads 3"));
    QCOMPARE(one["threads"].toInt(), 1);
    QCOMPARE(one["simd"].toString(), QStringLiteral("scalar"));
    QCOMPARE(one["settings"]["threads"].toInt(), 3);
    const QJsonObject chosen =
        statisticsOf(QStringLiteral("render a.case --algorithm tiled --threads 3 --simd scalar"));
    QCOMPARE(chosen["threads"].toInt(), 3);
    QCOMPARE(chosen["simd"].toString(), QStringLiteral("scalar"));
    const QJsonObject automatic = statisticsOf(QStringLiteral("render a.case --algorithm tiled"));
    QVERIFY(automatic["threads"].toInt() >= 1);
    QCOMPARE(automatic["settings"]["threads"].toInt(-1), 0);
    QCOMPARE(automatic["settings"]["simd"].toString(), QStringLiteral("auto"));
    Settings used;
    QVERIFY(!setFromText(*findSettingsField(QStringLiteral("simd")), automatic["simd"].toString(), used));
    QVERIFY(used.simd != Simd::Auto);
}

void TestCli::missingInstructionsAreNamed()
{
    // No machine has both.
    const Run neon = call(QStringLiteral("render a.case --algorithm tiled --simd neon"));
    const Run avx512 = call(QStringLiteral("render a.case --algorithm tiled --simd avx512"));
    const Run& bad = neon.exitCode != 0 ? neon : avx512;
    QCOMPARE(bad.exitCode, 2);
    QVERIFY2(bad.err.startsWith(QLatin1String("rasterlens-cli render: this machine does not have simd ")),
             qPrintable(bad.err));
    const QString list = bad.err.section(QStringLiteral("; it has "), 1).trimmed();
    QVERIFY(list.startsWith(QLatin1String("scalar")));
    const Run wired = call(QStringLiteral("render a.case --algorithm tiled --simd neon --fill wireframe"));
    QVERIFY2(!wired.err.contains(QLatin1String("it has")), "others would not help either");
    for (const QString& id : list.split(QStringLiteral(", ")))
        QCOMPARE(call(QStringLiteral("render a.case --algorithm tiled --simd ") + id).exitCode, 0);
}

void TestCli::infoAsTextAndJson()
{
    const Run text = call(QStringLiteral("info a.obj"));
    QCOMPARE(text.exitCode, 0);
    for (const char* line : {"faces      1\n", "vertices   3\n", "size       1920x1080\n", "textures   none\n",
                             "box        -1, -1, 0 to 1, 1, 0\n", "closed     no, 3 open sides\n"})
        QVERIFY2(text.out.contains(line), text.out.constData());
    const QJsonObject json = QJsonDocument::fromJson(call(QStringLiteral("info a.obj --json")).out).object();
    QCOMPARE(json["faces"].toInt(), 1);
    QCOMPARE(json["open_sides"].toInt(), 3);
    QCOMPARE(json["sphere"].toObject()["radius"].toDouble(), std::sqrt(2.0));
    QCOMPARE(json["box"].toObject()["max"].toArray(), (QJsonArray{1, 1, 0}));

    writeFile(path("closed.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    QVERIFY(call(QStringLiteral("info closed.obj")).out.contains("closed     yes\n"));
    writeFile(path("turned.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
    QVERIFY(call(QStringLiteral("info turned.obj")).out.contains("closed     no, 6 open sides\n"));
}

QTEST_GUILESS_MAIN(TestCli)
#include "test_cli.moc"
