// What the command line reads and writes: diff of all kinds of files, sessions, devices and pipes.
#include "cli_support.h"
#include "core/io/npy.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTemporaryDir>

#include <cmath>
#include <limits>
#include <memory>
#include <span>

#ifdef Q_OS_UNIX
#include <sys/stat.h>
#endif

using namespace rasterlens;
using namespace rasterlens::test;

class TestCliFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void init();
    void diffOfPictures();
    void diffOfArrays();
    void diffOfPicturesInOtherFormats();
    void diffWithAlpha();
    void diffKnowsNan();
    void diffAsJson();
    void colorTagsAreNamed();
    void countsOfSamples();
    void devicesAndPipesAreWrittenInto();
    void filesOutsideNeedConsent_data();
    void filesOutsideNeedConsent();
    void sessionThatContradictsItsScene();
    void sessionOfANewerVersion();

private:
    std::unique_ptr<QTemporaryDir> m_folder;

    QString path(const char* name) const { return m_folder->filePath(QLatin1String(name)); }
    Run call(const QString& words) const { return run(words.split(QLatin1Char(' ')), m_folder->path()); }
};

void TestCliFiles::init()
{
    m_folder = std::make_unique<QTemporaryDir>();
    QVERIFY(m_folder->isValid());
    writeFile(path("a.case"), "size 8 6\ntri -1 -1 0.5 1 1 0 0   0 -1 0.5 1 1 0 0   0 1 0.5 1 1 0 0\n");
    QVERIFY(filled(4, 4, qRgb(0, 0, 0)).save(path("4x4.png")));
    const float numbers[] = {0, 1};
    writeFile(path("f.npy"), npyBytes(std::span<const float>(numbers), 1, 2));
    QVERIFY(filled(2, 2, qRgb(9, 9, 9)).save(path("t.png")));
    writeFile(path("t.mtl"), "newmtl m\nmap_Kd t.png\n");
    writeFile(path("textured.obj"), "mtllib t.mtl\nusemtl m\nv -1 -1 0\nv 1 -1 0\nv 0 1 0\nf 1 2 3\n");
}

void TestCliFiles::diffOfPictures()
{
    QImage b = filled(4, 4, qRgb(0, 0, 0));
    b.setPixel(1, 2, qRgb(3, 0, 9));
    QVERIFY(b.save(path("b.png")));
    const Run equal = call(QStringLiteral("diff 4x4.png 4x4.png"));
    QCOMPARE(equal.out, QByteArray("differing 0 of 16 (0 %)\nmax 0\nmean 0\npsnr inf\n"));
    QCOMPARE(equal.exitCode, 0);
    const Run different = call(QStringLiteral("diff 4x4.png b.png -o heat.png"));
    QCOMPARE(different.out, QByteArray("differing 1 of 16 (6.25 %)\nmax 9\nmean 0.25\npsnr 45.4008\n"));
    QCOMPARE(different.exitCode, 1);
    const QImage heat(path("heat.png"));
    QCOMPARE(heat.size(), QSize(4, 4));
    QVERIFY(heat.pixel(1, 2) != heat.pixel(0, 0));
    QCOMPARE(call(QStringLiteral("diff 4x4.png b.png --threshold 8")).exitCode, 1);
    QCOMPARE(call(QStringLiteral("diff 4x4.png b.png --threshold 9")).exitCode, 0);
    const Run heatOut = call(QStringLiteral("diff 4x4.png b.png -o -"));
    QCOMPARE(heatOut.out, readFile(path("heat.png")));
    QCOMPARE(heatOut.exitCode, 1);
}

void TestCliFiles::diffOfArrays()
{
    const float numbers[] = {0, 1.5};
    writeFile(path("g.npy"), npyBytes(std::span<const float>(numbers), 1, 2));
    const Run different = call(QStringLiteral("diff f.npy g.npy"));
    QCOMPARE(different.out, QByteArray("differing 1 of 2 (50 %)\nmax 0.5\nmean 0.25\n"));
    QCOMPARE(different.exitCode, 1);
    QCOMPARE(call(QStringLiteral("diff f.npy g.npy --threshold 0.5")).exitCode, 0);
    QCOMPARE(call(QStringLiteral("diff f.npy f.npy")).exitCode, 0);
}

/// A PNG and a TGA of 24 bits hold the same colours, though a TGA's rows go up and its blue comes first.
void TestCliFiles::diffOfPicturesInOtherFormats()
{
    QByteArray tga(18, '\0');
    tga[2] = 2;
    tga[12] = 2;
    tga[14] = 2;
    tga[16] = 24;
    writeFile(path("c.tga"), tga + QByteArray("\x01\x02\x03\x04\x05\x06\x07\x08\x09\x0a\x0b\x0c", 12));
    QImage image(2, 2, QImage::Format_RGB32);
    image.setPixel(0, 1, qRgb(3, 2, 1));
    image.setPixel(1, 1, qRgb(6, 5, 4));
    image.setPixel(0, 0, qRgb(9, 8, 7));
    image.setPixel(1, 0, qRgb(12, 11, 10));
    for (const char* name : {"c.png", "c.bmp", "c.ppm"})
        QVERIFY(image.save(path(name)));
    for (const char* words : {"diff c.tga c.png", "diff c.png c.tga", "diff c.bmp c.tga", "diff c.ppm c.tga"}) {
        const Run equal = call(QLatin1String(words));
        QCOMPARE(equal.out, QByteArray("differing 0 of 4 (0 %)\nmax 0\nmean 0\npsnr inf\n"));
        QCOMPARE(equal.exitCode, 0);
    }
}

void TestCliFiles::diffWithAlpha()
{
    QImage clear(2, 1, QImage::Format_ARGB32);
    clear.fill(qRgba(10, 20, 30, 0));
    QImage half = clear;
    half.setPixel(1, 0, qRgba(10, 20, 30, 128));
    QVERIFY(clear.save(path("clear.png")) && half.save(path("half.png")));
    QVERIFY(filled(2, 1, qRgb(10, 20, 30)).save(path("opaque.png")));
    const Run different = call(QStringLiteral("diff clear.png half.png"));
    QVERIFY2(different.out.startsWith("differing 1 of 2 (50 %)\nmax 128\nmean 16\n"), different.out.constData());
    QCOMPARE(different.exitCode, 1);
    const Run one = call(QStringLiteral("diff half.png opaque.png"));
    QCOMPARE(one.exitCode, 0);
    QCOMPARE(one.err, QStringLiteral("half.png: has an alpha channel, which is not compared: opaque.png has none\n"));
}

void TestCliFiles::diffKnowsNan()
{
    const float nan = std::nanf("");
    const float a[] = {0, nan, nan, 1};
    const float b[] = {0, nan, 2, nan};
    writeFile(path("a.npy"), npyBytes(std::span<const float>(a), 2, 2));
    writeFile(path("b.npy"), npyBytes(std::span<const float>(b), 2, 2));
    const Run different = call(QStringLiteral("diff a.npy b.npy --threshold 100"));
    QCOMPARE(different.out,
             QByteArray("differing 2 of 4 (50 %)\nmax 0\nmean 0\nnan 1 only in A, 1 only in B, 1 in both\n"));
    QCOMPARE(different.exitCode, 1);
    const Run equal = call(QStringLiteral("diff a.npy a.npy"));
    QCOMPARE(equal.out, QByteArray("differing 0 of 4 (0 %)\nmax 0\nmean 0\nnan 0 only in A, 0 only in B, 2 in both\n"));
    QCOMPARE(equal.exitCode, 0);
}

void TestCliFiles::diffAsJson()
{
    const auto objectOf = [](const QByteArray& text) { return QJsonDocument::fromJson(text).object(); };
    QImage b = filled(4, 4, qRgb(0, 0, 0));
    b.setPixel(1, 2, qRgb(3, 0, 9));
    QVERIFY(b.save(path("b.png")));
    const Run pictures = call(QStringLiteral("diff 4x4.png b.png --threshold 9 --json -"));
    QCOMPARE(pictures.exitCode, 0);
    const QJsonObject found = objectOf(pictures.out);
    QCOMPARE(found["kind"].toString(), QStringLiteral("picture"));
    QCOMPARE(found["a"].toString(), QStringLiteral("4x4.png"));
    QCOMPARE(found["total"].toInt(), 16);
    QCOMPARE(found["differing"].toInt(), 1);
    QCOMPARE(found["max"].toInt(), 9);
    QCOMPARE(found["mean"].toDouble(), 0.25);
    QCOMPARE(found["threshold"].toDouble(), 9.0);
    QCOMPARE(found["above"], QJsonValue(false));
    QCOMPARE(objectOf(call(QStringLiteral("diff 4x4.png 4x4.png --json -")).out)["psnr"].toDouble(), 999.0);

    const float numbers[] = {0, std::numeric_limits<float>::infinity()};
    writeFile(path("g.npy"), npyBytes(std::span<const float>(numbers), 1, 2));
    const Run arrays = call(QStringLiteral("diff f.npy g.npy --json d.json"));
    QCOMPARE(arrays.exitCode, 1);
    QCOMPARE(arrays.out, QByteArray("differing 1 of 2 (50 %)\nmax inf\nmean inf\n"));
    const QJsonObject infinite = objectOf(readFile(path("d.json")));
    QCOMPARE(infinite["kind"].toString(), QStringLiteral("array"));
    QVERIFY(infinite["max"].isNull() && infinite["above"].toBool());
    QCOMPARE(infinite["nan"].toObject()["both"].toInt(-1), 0);
}

/// A PNG with a gAMA chunk behind its header.
void TestCliFiles::colorTagsAreNamed()
{
    QByteArray png = readFile(path("t.png"));
    constexpr qsizetype kBehindHeader = 33;
    png.insert(kBehindHeader, QByteArray("\0\0\0\x04gAMA\0\x01\x86\xa0\x31\xe8\x96\x5f", 16)); // 1.0
    writeFile(path("t.png"), png);
    const Run info = call(QStringLiteral("info textured.obj"));
    QCOMPARE(info.exitCode, 0);
    const QString said = QStringLiteral("the picture carries a gamma of 1, which is not applied: its colours are taken "
                                        "as they are stored\n");
    QVERIFY2(info.err.endsWith(QLatin1String("t.png: warning: ") + said), qPrintable(info.err));
    QCOMPARE(call(QStringLiteral("diff t.png t.png")).err, QString(QLatin1String("t.png: ") + said).repeated(2));
    QCOMPARE(call(QStringLiteral("render textured.obj --size 4x4")).err, QString());
}

/// The triangle of a.case is the right half of (0, 6), (4, 6), (4, 0): every sample as its three edges have it.
void TestCliFiles::countsOfSamples()
{
    const Run run = call(QStringLiteral("render a.case --samples msaa4 --no-picture --sample-coverage s.npy"));
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    const NpyRead read = readNpy(readFile(path("s.npy")));
    QVERIFY2(read.array, qPrintable(read.error));
    QCOMPARE(read.array->type, QStringLiteral("<u2"));
    QCOMPARE(read.array->shape, (std::vector<qint64>{4, 6, 8}));
    const auto& counts = std::get<std::vector<double>>(read.array->values);
    constexpr int kOffsets[4][2] = {{-2, -6}, {6, -2}, {-6, 2}, {2, 6}};
    for (int sample = 0; sample < 4; ++sample)
        for (int y = 0; y < 6; ++y)
            for (int x = 0; x < 8; ++x) {
                const double px = x + 0.5 + kOffsets[sample][0] / 16.0;
                const double py = y + 0.5 + kOffsets[sample][1] / 16.0;
                const bool inside = px < 4 && 6 * px + 4 * py > 24; // no sample lies on an edge
                QCOMPARE(counts[std::size_t((sample * 6 + y) * 8 + x)], inside ? 1.0 : 0.0);
            }
    writeFile(path("m.case"), readFile(path("a.case")) + "samples msaa16\n");
    QCOMPARE(call(QStringLiteral("render m.case --no-picture --sample-coverage m.npy")).exitCode, 0);
    QCOMPARE(readNpy(readFile(path("m.npy"))).array->shape, (std::vector<qint64>{16, 6, 8}));
    const Run tiled = call(QStringLiteral("render a.case --algorithm tiled --samples 2x2 --sample-coverage t.npy"));
    QCOMPARE(tiled.exitCode, 2);
    QVERIFY2(tiled.err.contains(QLatin1String("--sample-coverage: algorithm tiled")), qPrintable(tiled.err));
    QVERIFY(!QFileInfo::exists(path("t.npy")));
    QCOMPARE(call(QStringLiteral("render m.case --algorithm tiled --no-picture --sample-coverage t.npy")).exitCode, 0);
    QCOMPARE(readFile(path("t.npy")), readFile(path("m.npy")));
    const Run centroid = call(QStringLiteral("render m.case --algorithm tiled --attribute-at centroid"));
    QCOMPARE(centroid.exitCode, 2);
    QVERIFY2(centroid.err.contains(QLatin1String("needs attribute-at centre")), qPrintable(centroid.err));
}

void TestCliFiles::devicesAndPipesAreWrittenInto()
{
#ifdef Q_OS_UNIX
    const QByteArray file = call(QStringLiteral("render a.case -o -")).out;
    QCOMPARE(call(QStringLiteral("render a.case -o /dev/stdout")).out, file);
    QCOMPARE(call(QStringLiteral("render a.case -o /dev/fd/1")).out, file);
    QCOMPARE(::mkfifo(QFile::encodeName(path("pipe.png")).constData(), 0600), 0);
    const Run piped =
        run({QStringLiteral("-c"), QStringLiteral("cat pipe.png & \"$0\" render a.case -o pipe.png && wait"),
             QStringLiteral(RASTERLENS_CLI)},
            m_folder->path(), QStringLiteral("sh"));
    QCOMPARE(piped.out, file);
    QVERIFY2(!QFileInfo(path("pipe.png")).isFile(), "the pipe is still a pipe");
    const Run format = call(QStringLiteral("render a.case -o p.jpeg"));
    QCOMPARE(format.exitCode, 0);
    QVERIFY(readFile(path("p.jpeg")).startsWith("\xff\xd8"));
#else
    QSKIP("no named pipes on this system");
#endif
}

/// The scene brings a far plane that the session knows nothing of.
void TestCliFiles::filesOutsideNeedConsent_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<int>("exitCode"); // without consent
    QTest::addColumn<QString>("place");
    QTest::addColumn<QString>("phrase");
    const auto row = [](const char* words, int exitCode, const char* place, const char* phrase) {
        QTest::newRow(words) << QString::fromLatin1(words) << exitCode << QString::fromLatin1(place)
                             << QString::fromLatin1(phrase);
    };
    const char* const model = "lies outside the model's folder";
    const char* const session = "lies outside the session's folder";
    const char* const lesson = "lies outside the lesson's folder";
    row("info own/m.obj", 0, "own/m.obj:1: warning: mtllib %1/t.mtl: it ", model);
    row("render own/t.obj -o o.png", 0, "%1/own/in.mtl:2: warning: map_Kd %1/t.png: it ", model);
    row("why own/t.case --pixel 2,3", 3, "own/t.case:2: texture: it ", model);
    row("info own/s.json", 3, "own/s.json: the scene %1/a.case ", session);
    row("figure own/s.json -o f.png", 3, "own/s.json: the scene %1/a.case ", session);
    row("lesson check own/l.json", 3, "own/l.json:1: the scene ../a.case ", lesson);
    row("render --lesson own/l.json --step 1 -o o.png", 3, "own/l.json:1: the scene ../a.case ", lesson);
    row("page --lesson own/l.json -o o.html", 3, "own/l.json:1: the scene ../a.case ", lesson);
    row("lesson handout own/l.json -o h.md", 3, "own/l.json:1: the scene ../a.case ", lesson);
}

/// What the commands read lies in a folder, and names what lies above it.
void TestCliFiles::filesOutsideNeedConsent()
{
    QFETCH(QString, words);
    QFETCH(int, exitCode);
    QFETCH(QString, place);
    QFETCH(QString, phrase);
    QVERIFY(QDir(m_folder->path()).mkdir(QStringLiteral("own")));
    const QByteArray faces = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvt 0 0\nusemtl m\nf 1/1 2/1 3/1\n";
    writeFile(path("own/m.obj"), "mtllib ../t.mtl\n" + faces);
    writeFile(path("own/t.obj"), "mtllib in.mtl\n" + faces);
    writeFile(path("own/in.mtl"), "newmtl m\nmap_Kd ../t.png\n");
    writeFile(path("own/t.case"), readFile(path("a.case")).replace("tri", "texture ../t.png\ntri"));
    writeFile(path("own/s.json"), R"({"rasterlens": 1, "scene": "../a.case"})");
    writeFile(path("own/l.json"), R"({"rasterlens-lesson": 1, "id": "a", "title": {"en": "A", "zh": "A"}, "steps":)"
                                  R"([{"scene": "../a.case", "caption": {"en": "One.", "zh": "One."}}]})");
    const Run refused = call(words);
    QCOMPARE(refused.exitCode, exitCode);
    place.replace(QLatin1String("%1"), m_folder->path());
    QVERIFY2(refused.err.contains(place + phrase), qPrintable(refused.err));
    QVERIFY2(refused.err.contains(QLatin1String("(--allow-outside)")), qPrintable(refused.err));
    const Run agreed = call(words + QStringLiteral(" --allow-outside"));
    QVERIFY2(agreed.exitCode == 0, qPrintable(agreed.err));
    QVERIFY2(!agreed.err.contains(QLatin1String("outside")), qPrintable(agreed.err));
}

void TestCliFiles::sessionThatContradictsItsScene()
{
    const Run far = call(QStringLiteral("render builtin:tunnel --size 8x8 --near 150 -o p.png"));
    QCOMPARE(far.exitCode, 2);
    writeFile(path("s.json"),
              R"({"rasterlens": 1, "scene": "builtin:tunnel", "settings": {"size": "8x8", "view": {"near": 150}}})");
    const Run bad = call(QStringLiteral("render s.json -o p.png"));
    QCOMPARE(bad.exitCode, 3);
    QVERIFY2(bad.err.startsWith(
                 QLatin1String("s.json: the far plane is at 100, but must lie beyond the near plane at 150: ")),
             qPrintable(bad.err));
    QVERIFY(!QFile::exists(path("p.png")));
}

void TestCliFiles::sessionOfANewerVersion()
{
    writeFile(path("s.txt"), R"({"rasterlens": 2, "scene": "a.case", "mood": "calm", "settings": {"size": "5x4",
                                 "culling": "sideways", "gloss": 1, "view": {"yaw": 45, "roll": 3}}})");
    const Run newer = call(QStringLiteral("render s.txt -o p.png"));
    QCOMPARE(newer.exitCode, 0);
    for (const char* named : {"s.txt: warning: made by a newer version (2); this one reads 1", "\"mood\"",
                              "\"sideways\"", "\"gloss\"", "\"roll\""})
        QVERIFY2(newer.err.contains(QLatin1String(named)), qPrintable(newer.err));
    QCOMPARE(QImage(path("p.png")).size(), QSize(5, 4));
}

QTEST_GUILESS_MAIN(TestCliFiles)
#include "test_cli_files.moc"
