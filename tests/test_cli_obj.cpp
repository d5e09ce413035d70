// OBJ files on the command line: where faces come from, remarks, and why nothing is seen.
#include "scene_files.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cstring>

using namespace rasterlens::test;

namespace
{

struct Run {
    int exitCode = -1;
    QString out;
    QString err;
};

Run call(const QStringList& words)
{
    QProcess process;
    process.start(QStringLiteral(RASTERLENS_CLI), words);
    if (!process.waitForFinished(-1) || process.exitStatus() != QProcess::NormalExit)
        return {-1, {}, process.errorString()};
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

/// The int32 values of an array of shape (height, width).
std::vector<std::int32_t> arrayOf(const QString& path, std::size_t count)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QByteArray bytes = file.readAll();
    std::vector<std::int32_t> values(count);
    const auto size = static_cast<qsizetype>(4 * count);
    if (bytes.size() < size)
        return {};
    std::memcpy(values.data(), bytes.constData() + bytes.size() - size, static_cast<std::size_t>(size));
    return values;
}

const QByteArray kSquares = "v -1 -1 0\nv 0 -1 0\nv 1 -1 0\nv -1 1 0\nv 0 1 0\nv 1 1 0\n# two squares\n"
                            "f 1 2 5 4\n\nf 2 3 6 5\n";
const QByteArray kFloor = "v -1 0 -1\nv -1 0 1\nv 1 0 1\nv 1 0 -1\nf 1 2 3 4\n";

} // namespace

class TestCliObj : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void faceLines();
    void whyAndStepsNameTheLine();
    void emptyPictureSaysWhy_data();
    void emptyPictureSaysWhy();
    void notesAreForInfo();
    void badLinesAreCounted();
};

void TestCliObj::faceLines()
{
    const Folder folder;
    const QString scene = folder.write(QStringLiteral("a.obj"), kSquares);
    const Run run = call({QStringLiteral("render"), scene, QStringLiteral("--size"), QStringLiteral("8x8"),
                          QStringLiteral("--no-picture"), QStringLiteral("--ids"), folder.path(QStringLiteral("i.npy")),
                          QStringLiteral("--face-lines"), folder.path(QStringLiteral("l.npy"))});
    QVERIFY2(run.exitCode == 0 && run.err.isEmpty(), qPrintable(run.err));
    const auto ids = arrayOf(folder.path(QStringLiteral("i.npy")), 64);
    const auto lines = arrayOf(folder.path(QStringLiteral("l.npy")), 64);
    QCOMPARE(lines.size(), std::size_t{64});
    constexpr std::array kLines = {8, 8, 10, 10};
    for (std::size_t i = 0; i < 64; ++i)
        QCOMPARE(lines[i], ids[i] < 0 ? -1 : kLines.at(static_cast<std::size_t>(ids[i])));
    QCOMPARE(std::ranges::count(lines, 8), std::ranges::count(lines, 10));
    QVERIFY(std::ranges::count(lines, 8) > 0);
}

void TestCliObj::whyAndStepsNameTheLine()
{
    const Folder folder;
    const QString scene = folder.write(QStringLiteral("a.obj"), kSquares);
    const QStringList at{QStringLiteral("--size"), QStringLiteral("8x8"), QStringLiteral("--pixel"),
                         QStringLiteral("5,4")};
    const Run why = call(QStringList{QStringLiteral("why"), scene} + at);
    QVERIFY2(why.out.contains(QRegularExpression(QStringLiteral("pixel 5,4: #[0-9a-f]+, face [23] \\(line 10\\), "))),
             qPrintable(why.out));
    QVERIFY2(why.out.contains(QStringLiteral("(line 10): written")), qPrintable(why.out));
    const Run steps =
        call(QStringList{QStringLiteral("steps"), scene, QStringLiteral("--face"), QStringLiteral("0")} + at.first(2));
    QVERIFY2(steps.out.contains(QStringLiteral(" vertex face 0 (line 8): ")), qPrintable(steps.out.left(300)));
    const Run json = call(QStringList{QStringLiteral("steps"), scene, QStringLiteral("--json"), QStringLiteral("-"),
                                      QStringLiteral("--face"), QStringLiteral("3")} +
                          at.first(2));
    const QByteArray first = json.out.section(QLatin1Char('\n'), 1, 1).toUtf8();
    QCOMPARE(QJsonDocument::fromJson(first).object().value(QStringLiteral("line")).toInt(), 10);
    const Run builtin = call({QStringLiteral("why"), QStringLiteral("builtin:triangle"), QStringLiteral("--pixel"),
                              QStringLiteral("400,300")});
    QVERIFY2(builtin.exitCode == 0 && !builtin.out.contains(QStringLiteral("line")), qPrintable(builtin.out));
}

void TestCliObj::emptyPictureSaysWhy_data()
{
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QStringList>("options");
    QTest::addColumn<QString>("phrase"); // empty: something is seen
    const auto row = [](const char* name, const QByteArray& text, const char* options, const char* phrase) {
        QTest::newRow(name) << text << QString::fromLatin1(options).split(QLatin1Char(' '), Qt::SkipEmptyParts)
                            << QString::fromLatin1(phrase);
    };
    row("a floor seen edge-on", kFloor, "", "nothing is seen: 2 of 2 faces are seen edge-on or have no area; orbit");
    row("a floor from above", kFloor, "--orbit 0,40", "");
    row("squares from in front", kSquares, "", "");
    row("squares from behind", kSquares, "--culling front", "4 of 4 faces show their front and are culled");
    row("a square that faces away", "v 0 0 0\nv 0 1 0\nv 1 0 0\nf 1 2 3\n", "", "1 of 1 faces show their back");
    row("looked past", kSquares, "--eye 0,0,5 --target 0,0,9", "4 of 4 faces lie outside the view");
    row("between the centres", kSquares, "--size 1x1 --eye 50.5,0,300 --target 50.5,0,0 --near 1 --far 999",
        "reach the screen, but each lies between the centres");
}

void TestCliObj::emptyPictureSaysWhy()
{
    QFETCH(QByteArray, text);
    QFETCH(QStringList, options);
    QFETCH(QString, phrase);
    const Folder folder;
    const QString scene = folder.write(QStringLiteral("a.obj"), text);
    const Run render =
        call(QStringList{QStringLiteral("render"), scene, QStringLiteral("--size"), QStringLiteral("64x64"),
                         QStringLiteral("-o"), folder.path(QStringLiteral("a.png"))} +
             options);
    QVERIFY2(render.exitCode == 0, qPrintable(render.err));
    if (phrase.isEmpty())
        QVERIFY2(render.err.isEmpty(), qPrintable(render.err));
    else
        QVERIFY2(render.err.startsWith(scene + QStringLiteral(": warning: ")) && render.err.contains(phrase),
                 qPrintable(render.err));
}

void TestCliObj::notesAreForInfo()
{
    const Folder folder;
    folder.write(QStringLiteral("a.mtl"), "newmtl m\nKa 1 1 1\nKd 1 0 0\n");
    const QString scene = folder.write(QStringLiteral("a.obj"), "mtllib a.mtl\nusemtl m\n" + kFloor + "f 1 3 2\n");
    const Run info = call({QStringLiteral("info"), scene});
    QVERIFY2(info.err.contains(QStringLiteral("a.mtl:2: note: read, but no part of the lighting here: Ka")),
             qPrintable(info.err));
    QVERIFY2(info.out.contains(QStringLiteral("hint       nothing is seen: 3 of 3 faces are seen edge-on")),
             qPrintable(info.out));
    const Run render =
        call({QStringLiteral("render"), scene, QStringLiteral("--size"), QStringLiteral("9x9"), QStringLiteral("-o"),
              folder.path(QStringLiteral("a.png")), QStringLiteral("--orbit"), QStringLiteral("0,30")});
    QVERIFY2(render.exitCode == 0 && render.err.isEmpty(), qPrintable(render.err));
}

void TestCliObj::badLinesAreCounted()
{
    const Folder folder;
    const QString scene = folder.write(QStringLiteral("a.obj"), kSquares + QByteArray("f 1 2\n").repeated(2000));
    const Run run = call({QStringLiteral("info"), scene});
    QCOMPARE(run.exitCode, 0);
    QCOMPARE(run.err.count(QStringLiteral("corners; at least 3 expected")), 5);
    QVERIFY2(run.err.contains(QStringLiteral("and 1995 more remarks like that on line 11")), qPrintable(run.err));
    QVERIFY2(run.out.contains(QStringLiteral("faces      4")), qPrintable(run.out));
}

QTEST_GUILESS_MAIN(TestCliObj)
#include "test_cli_obj.moc"
