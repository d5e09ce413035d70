// `bench` and `cases` on the command line: outputs, exit codes and messages.
#include <QDir>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

namespace
{

struct Run {
    int exitCode;
    QString out;
    QString err;
};

Run run(const QStringList& arguments, const QString& folder = QDir::tempPath())
{
    QProcess process;
    process.setWorkingDirectory(folder);
    process.start(QStringLiteral(RASTERLENS_CLI), arguments);
    if (!process.waitForFinished(-1) || process.exitStatus() != QProcess::NormalExit)
        return {-1, {}, process.errorString()};
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

const QStringList kQuick{"bench", "builtin:cube", "--size", "64x48", "--frames", "1"};

} // namespace

class TestCliBench : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void allOutputs();
    void theFrontierIsPartOfAll();
    void severalScenes();
    void chosenVariants();
    void asGiven();
    void otherRenderers();
    void whatIsHeededIsTaken();
    void failsBeforeItMeasures();
    void saysWhatItMeasures();
    void listsVariants();
    void casesThatPass();
    void casesThatFail();
    void listsCases();
    void refusals_data();
    void refusals();
};

void TestCliBench::allOutputs()
{
    QTemporaryDir folder;
    const Run result =
        run(kQuick + QStringList{"--json", "b.json", "--csv", "b.csv", "--plot", "b.png"}, folder.path());
    QVERIFY2(result.exitCode == 0, qPrintable(result.err));
    for (const char* words : {"edge equation takes ", "a blog measured at least 1.36",
                              "noise: frames of a variant vary by ", "ratio: to edge-equation"})
        QVERIFY2(result.out.contains(QLatin1String(words)), words);
    QFile json(folder.filePath(QStringLiteral("b.json")));
    QVERIFY(json.open(QIODevice::ReadOnly));
    const QJsonArray rows = QJsonDocument::fromJson(json.readAll()).array();
    QVERIFY(rows.size() >= 30);
    QFile csv(folder.filePath(QStringLiteral("b.csv")));
    QVERIFY(csv.open(QIODevice::ReadOnly));
    QCOMPARE(csv.readAll().count('\n'), rows.size() + 1);
    const QImage plot(folder.filePath(QStringLiteral("b.png")));
    QVERIFY(!plot.isNull());
    QVERIFY(plot.pixelColor(0, 0) == QColor(Qt::white));
}

void TestCliBench::theFrontierIsPartOfAll()
{
    const Run result = run(kQuick + QStringList{"--variants", "frontier", "--json", "-", "--error", "coverage"});
    QVERIFY2(result.exitCode == 0, qPrintable(result.err));
    const QJsonArray rows = QJsonDocument::fromJson(result.out.toUtf8()).array();
    QVERIFY(!rows.isEmpty() && rows.size() < 30);
    for (const QJsonValue& row : rows)
        QVERIFY(row["frontier"].toBool());
}

void TestCliBench::severalScenes()
{
    const Run result = run(kQuick + QStringList{"builtin:triangle", "--variants", "tiled,edge-walking", "--plot", "-"});
    QVERIFY2(result.exitCode == 0, qPrintable(result.err));
    QVERIFY(result.out.contains(QStringLiteral("<svg")));
    QVERIFY(result.out.contains(QStringLiteral("builtin:cube")) &&
            result.out.contains(QStringLiteral("builtin:triangle")));
}

void TestCliBench::chosenVariants()
{
    const Run result = run(kQuick + QStringList{"--variants", "tiled,edge-equation", "--threads", "2", "--json", "-",
                                                "--reference", "none"});
    QVERIFY2(result.exitCode == 0, qPrintable(result.err));
    const QJsonArray rows = QJsonDocument::fromJson(result.out.toUtf8()).array();
    QCOMPARE(rows.size(), 2);
    QCOMPARE(rows[0]["variant"].toString(), QStringLiteral("tiled"));
    QCOMPARE(rows[0]["threads"].toInt(), 2);
    QCOMPARE(rows[1]["threads"].toInt(), 1);
    QVERIFY(rows[0]["error"]["psnr"].isNull());
}

void TestCliBench::asGiven()
{
    const Run result = run(kQuick + QStringList{"--variants", "as-given,tiled", "--algorithm", "tiled", "--samples",
                                                "3x3", "--depth-format", "unorm16", "--json", "-"});
    QVERIFY2(result.exitCode == 0, qPrintable(result.err));
    const QJsonArray rows = QJsonDocument::fromJson(result.out.toUtf8()).array();
    QCOMPARE(rows.size(), 2);
    QCOMPARE(rows[0]["variant"].toString(), QStringLiteral("as-given"));
    QCOMPARE(rows[0]["settings"]["samples"].toString(), QStringLiteral("3x3"));
    QCOMPARE(rows[0]["settings"]["algorithm"].toString(), QStringLiteral("tiled"));
    QCOMPARE(rows[0]["settings"]["depth-format"].toString(), QStringLiteral("unorm16"));
    QCOMPARE(rows[0]["error"]["missing_pixels"].toInt(-1), 0);
    QVERIFY(rows[0]["error"]["depth_max"].toDouble() > rows[1]["error"]["depth_max"].toDouble());
    QCOMPARE(rows[1]["settings"]["samples"].toString(), QStringLiteral("1"));
}

/// Each has a row with what was found out about it, or the message says why there is none and nothing is measured.
void TestCliBench::otherRenderers()
{
    const Run result = run(kQuick + QStringList{"--variants", "tiled", "--with-opengl", "--json", "-"});
    if (result.exitCode == 2) {
        QVERIFY2(result.err.startsWith(QStringLiteral("rasterlens-cli bench: --with-opengl: ")),
                 qPrintable(result.err));
        QSKIP(qPrintable(result.err));
    }
    QVERIFY2(result.exitCode == 0, qPrintable(result.err));
    const QJsonArray rows = QJsonDocument::fromJson(result.out.toUtf8()).array();
    QVERIFY(rows.size() >= 2);
    QVERIFY(rows[0]["renderer"]["subpixel_bits"].isNull() && rows[0]["ratio"]["median"].isNull());
    const QJsonValue other = rows[1];
    QVERIFY(other["variant"].toString().startsWith(QStringLiteral("opengl-")));
    QVERIFY(other["renderer"]["subpixel_bits"].toInt() >= 4 && !other["renderer"]["tie_rule"].toString().isEmpty());
    QCOMPARE(other["ratio"]["to"].toString(), QStringLiteral("tiled"));
    QVERIFY(!other["error"]["missing_pixels"].isNull() && !other["error"]["depth_max"].isNull());

    // What it does not draw is said.
    const Run refused = run(kQuick + QStringList{"--variants", "edge-equation", "--with-opengl", "--shading", "phong"});
    QVERIFY2(refused.exitCode == 0, qPrintable(refused.err));
    QVERIFY2(
        refused.err.contains(QStringLiteral("is not measured: OpenGL is asked for shading gouraud and texture only")),
        qPrintable(refused.err));
}

void TestCliBench::whatIsHeededIsTaken()
{
    // What all variants agree with, and what one of them leaves open.
    for (const QStringList& words : {QStringList{"--variants", "tiled,tiled-2x2", "--algorithm", "tiled"},
                                     QStringList{"--variants", "edge-equation-4x4", "--samples", "4x4"},
                                     QStringList{"--variants", "tiled,tiled-1-thread", "--threads", "2"}}) {
        const Run result = run(kQuick + words);
        QVERIFY2(result.exitCode == 0, qPrintable(result.err));
        QVERIFY2(!result.err.contains(QStringLiteral("as-given")), qPrintable(result.err));
    }
    // These two move the truth, which is worth a warning.
    const Run result = run(kQuick + QStringList{"--variants", "edge-equation-float64", "--subpixel-bits", "0"});
    QVERIFY2(result.exitCode == 0, qPrintable(result.err));
    QVERIFY2(result.err.startsWith(
                 QStringLiteral("--subpixel-bits 0: every variant measured has its own subpixel-bits, only the exact")),
             qPrintable(result.err));
}

void TestCliBench::failsBeforeItMeasures()
{
    QTemporaryDir folder;
    QFile old(folder.filePath(QStringLiteral("old.csv")));
    QVERIFY(old.open(QIODevice::WriteOnly) && old.write("old") == 3);
    old.close();
    for (const QStringList& outputs : {QStringList{"--csv", "old.csv", "--json", "nowhere/b.json"},
                                       QStringList{"--csv", "old.csv", "--plot", "old.csv/b.svg"}}) {
        const Run result = run(kQuick + outputs, folder.path());
        QCOMPARE(result.exitCode, 3);
        QVERIFY2(result.err.startsWith(outputs.last() + QStringLiteral(": cannot be written")), qPrintable(result.err));
        QVERIFY(old.open(QIODevice::ReadOnly));
        QCOMPARE(old.readAll(), QByteArray("old"));
        old.close();
        QCOMPARE(QDir(folder.path()).entryList(QDir::AllEntries | QDir::NoDotAndDotDot), QStringList{"old.csv"});
    }
}

void TestCliBench::saysWhatItMeasures()
{
    const Run result = run(kQuick + QStringList{"builtin:triangle", "--variants", "tiled,edge-walking"});
    QCOMPARE(result.exitCode, 0);
    const QStringList lines = result.err.split(QLatin1Char('\n')); // between them a line every few seconds
    QVERIFY2(lines.contains(QStringLiteral("builtin:cube: variants to measure: 2")), qPrintable(result.err));
    QVERIFY2(lines.contains(QStringLiteral("builtin:triangle: variants to measure: 2")), qPrintable(result.err));
}

void TestCliBench::listsVariants()
{
    const Run result = run({"bench", "--list-variants"});
    QCOMPARE(result.exitCode, 0);
    QVERIFY(result.out.count(QLatin1Char('\n')) >= 30);
    QVERIFY(result.out.startsWith(QStringLiteral("edge-equation ")));
    QVERIFY(result.out.contains(QStringLiteral("\nas-given ")));
}

void TestCliBench::casesThatPass()
{
    const Run result = run({"cases", "--filter", "drift_float32"});
    QCOMPARE(result.exitCode, 0);
    QVERIFY(result.out.contains(QStringLiteral("176_drift_float32_extra                     + + + +")));
    QVERIFY(result.out.contains(QRegularExpression(QStringLiteral("tiled +2 pass, 0 fail, 0 not drawn"))));
}

void TestCliBench::casesThatFail()
{
    const QStringList words{"cases", "--filter", "17?_DRIFT*", "--variants", "tiled,edge-equation-float32"};
    const Run result = run(words);
    QCOMPARE(result.exitCode, 1);
    QVERIFY(result.out.contains(QStringLiteral("+ + x")));
    QVERIFY(result.out.contains(
        QStringLiteral("175_drift_float32_missing: edge-equation-float32: 10 missing, first at (16382, 0)")));
    const Run json = run(words + QStringList{"--json", "-"});
    QCOMPARE(json.exitCode, 1);
    const QJsonArray matrix = QJsonDocument::fromJson(json.out.toUtf8()).array();
    QCOMPARE(matrix.size(), 6);
    QCOMPARE(matrix[0]["variant"].toString(), QStringLiteral("reference"));
    QVERIFY(matrix[1]["pass"].toBool() && matrix[1]["reason"].toString().isEmpty());
    QVERIFY(matrix[2]["pass"].isBool() && !matrix[2]["pass"].toBool() && !matrix[2]["reason"].toString().isEmpty());
}

void TestCliBench::listsCases()
{
    const Run all = run({"cases", "--list"});
    QCOMPARE(all.exitCode, 0);
    QVERIFY(all.out.count(QLatin1Char('\n')) >= 100);
    const Run some = run({"cases", "--list", "--filter", "needle"});
    QCOMPARE(some.out.count(QLatin1Char('\n')), 4);
}

void TestCliBench::refusals_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const QStringList& arguments, int exitCode, const char* message) {
        QTest::newRow(name) << (arguments.first() == QLatin1String("cases") ? arguments : kQuick + arguments)
                            << exitCode << QString::fromLatin1(message);
    };
    row("variant", {"--variants", "edge-eqation"}, 2, "did you mean edge-equation?");
    row("unsupported", {"--variants", "tiled", "--fill", "wireframe"}, 2, "tiled: algorithm tiled needs fill solid");
    row("frames", {"--frames", "0"}, 2, "--frames");
    row("reference", {"--reference", "some"}, 2, "exact, exact-object, none");
    row("error", {"--error", "speed"}, 2, "coverage, depth, color");
    row("plot", {"--plot", "b.gif"}, 2, ".svg or .png");
    row("frontier", {"--variants", "frontier", "--reference", "none"}, 2, "needs --reference exact");
    row("same name", {"--csv", "a", "--json", "a"}, 2, "two outputs");
    row("comma", {"--variants", "tiled,"}, 2, "--variants: \"tiled,\" has a comma too many");
    row("output", {"--csv", "nowhere/x.csv"}, 3, "nowhere/x.csv: cannot be written: ");
    row("output of cases", {"cases", "--json", "nowhere/x.json"}, 3, "nowhere/x.json: cannot be written: ");
    row("not heeded", {"--variants", "tiled", "--samples", "4x4"}, 2,
        "--samples 4x4: every variant measured has its own samples; --variants as-given measures");
    row("not heeded by all", {"--depth-format", "unorm16"}, 2, "--depth-format unorm16: every variant");
    row("not heeded by the frontier", {"--variants", "frontier", "--stepping", "direct"}, 2, "--stepping direct");
    row("threads not heeded", {"--variants", "tiled-1-thread", "--threads", "2"}, 2, "--threads 2: every variant");
    row("truth not wanted", {"--variants", "tiled", "--subpixel-bits", "4", "--reference", "none"}, 2,
        "--subpixel-bits 4: every variant");
    row("no case", {"cases", "--filter", "no-such-case"}, 2, "no case matches");
    row("case variant", {"cases", "--variants", "tild"}, 2, "did you mean tiled?");
    row("case operand", {"cases", "001"}, 2, "one argument too many");
    row("scene", {"no-such.obj"}, 3, "no-such.obj");
}

void TestCliBench::refusals()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, exitCode);
    QFETCH(QString, message);
    const Run result = run(arguments);
    QCOMPARE(result.exitCode, exitCode);
    QVERIFY2(result.err.contains(message), qPrintable(result.err));
    QVERIFY(result.out.isEmpty());
}

QTEST_APPLESS_MAIN(TestCliBench)
#include "test_cli_bench.moc"
