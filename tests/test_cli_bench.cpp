// `bench` on the command line: outputs, exit codes and messages.
#include <QDir>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace
{

struct Run {
    int exitCode;
    QString out;
    QString err;
};

Run bench(const QStringList& arguments, const QString& folder = QDir::tempPath())
{
    QProcess process;
    process.setWorkingDirectory(folder);
    process.start(QStringLiteral(RASTERLENS_CLI), QStringList{QStringLiteral("bench")} + arguments);
    if (!process.waitForFinished(-1) || process.exitStatus() != QProcess::NormalExit)
        return {-1, {}, process.errorString()};
    return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
            QString::fromUtf8(process.readAllStandardError())};
}

const QStringList kQuick{"builtin:cube", "--size", "64x48", "--frames", "1"};

} // namespace

class TestCliBench : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void allOutputs();
    void theFrontierIsPartOfAll();
    void severalScenes();
    void chosenVariants();
    void listsVariants();
    void refusals_data();
    void refusals();
};

void TestCliBench::allOutputs()
{
    QTemporaryDir folder;
    const Run run = bench(kQuick + QStringList{"--json", "b.json", "--csv", "b.csv", "--plot", "b.png"}, folder.path());
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    QVERIFY(run.out.contains(QStringLiteral("edge equation / edge walking: ")));
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
    const Run run = bench(kQuick + QStringList{"--variants", "frontier", "--json", "-", "--error", "coverage"});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    const QJsonArray rows = QJsonDocument::fromJson(run.out.toUtf8()).array();
    QVERIFY(!rows.isEmpty() && rows.size() < 30);
    for (const QJsonValue& row : rows)
        QVERIFY(row["frontier"].toBool());
}

void TestCliBench::severalScenes()
{
    const Run run = bench(kQuick + QStringList{"builtin:triangle", "--variants", "tiled,edge-walking", "--plot", "-"});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    QVERIFY(run.out.contains(QStringLiteral("<svg")));
    QVERIFY(run.out.contains(QStringLiteral("builtin:cube")) && run.out.contains(QStringLiteral("builtin:triangle")));
}

void TestCliBench::chosenVariants()
{
    const Run run = bench(kQuick + QStringList{"--variants", "tiled,edge-equation", "--threads", "2", "--json", "-",
                                               "--reference", "none"});
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    const QJsonArray rows = QJsonDocument::fromJson(run.out.toUtf8()).array();
    QCOMPARE(rows.size(), 2);
    QCOMPARE(rows[0]["variant"].toString(), QStringLiteral("tiled"));
    QCOMPARE(rows[0]["threads"].toInt(), 2);
    QCOMPARE(rows[1]["threads"].toInt(), 1);
    QVERIFY(rows[0]["error"]["psnr"].isNull());
}

void TestCliBench::listsVariants()
{
    const Run run = bench({"--list-variants"});
    QCOMPARE(run.exitCode, 0);
    QVERIFY(run.out.count(QLatin1Char('\n')) >= 30);
    QVERIFY(run.out.startsWith(QStringLiteral("edge-equation ")));
}

void TestCliBench::refusals_data()
{
    QTest::addColumn<QStringList>("arguments");
    QTest::addColumn<int>("exitCode");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const QStringList& arguments, int exitCode, const char* message) {
        QTest::newRow(name) << kQuick + arguments << exitCode << QString::fromLatin1(message);
    };
    row("variant", {"--variants", "edge-eqation"}, 2, "did you mean edge-equation?");
    row("unsupported", {"--variants", "tiled", "--fill", "wireframe"}, 2, "tiled: algorithm tiled needs fill solid");
    row("frames", {"--frames", "0"}, 2, "--frames");
    row("reference", {"--reference", "some"}, 2, "exact, none");
    row("error", {"--error", "speed"}, 2, "coverage, depth, color");
    row("plot", {"--plot", "b.gif"}, 2, ".svg or .png");
    row("frontier", {"--variants", "frontier", "--reference", "none"}, 2, "needs --reference exact");
    row("same name", {"--csv", "a", "--json", "a"}, 2, "two outputs");
    row("scene", {"no-such.obj"}, 3, "no-such.obj");
}

void TestCliBench::refusals()
{
    QFETCH(QStringList, arguments);
    QFETCH(int, exitCode);
    QFETCH(QString, message);
    const Run run = bench(arguments);
    QCOMPARE(run.exitCode, exitCode);
    QVERIFY2(run.err.contains(message), qPrintable(run.err));
    QVERIFY(run.out.isEmpty());
}

QTEST_APPLESS_MAIN(TestCliBench)
#include "test_cli_bench.moc"
