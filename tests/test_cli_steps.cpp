// The verbs steps and why as scripts see them.
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace
{

struct Run {
    int exitCode = -1;
    QByteArray out;
    QString err;
};

Run call(const QString& words, const QString& folder = QString())
{
    QProcess process;
    process.setWorkingDirectory(folder);
    process.start(QStringLiteral(RASTERLENS_CLI), words.split(QLatin1Char(' ')));
    if (!process.waitForFinished(-1) || process.exitStatus() != QProcess::NormalExit)
        return {-1, {}, process.errorString()};
    return {process.exitCode(), process.readAllStandardOutput(), QString::fromUtf8(process.readAllStandardError())};
}

QList<QByteArray> linesOf(const QByteArray& text) { return text.trimmed().split('\n'); }

} // namespace

class TestCliSteps : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void help();
    void badCalls_data();
    void badCalls();
    void tiesAreToldWithTheirOwners();
    void limitIsSaid();
    void anyStepOfALargeSceneIsTold();
    void jsonHasOneObjectALine();
    void filtersKeepFaceAndPixel();
    void whyNamesTheEdge();
    void whyAsJson();
};

void TestCliSteps::help()
{
    for (const char* words : {"steps --help", "why --help"}) {
        const Run run = call(QLatin1String(words));
        QCOMPARE(run.exitCode, 0);
        QVERIFY(run.out.startsWith("Usage: rasterlens-cli "));
        QVERIFY(run.out.contains("--pixel"));
        QVERIFY(run.out.contains("--tie-rule"));
        for (const QByteArray& line : run.out.split('\n'))
            QVERIFY2(line.size() <= 100, line.constData());
    }
}

void TestCliSteps::badCalls_data()
{
    QTest::addColumn<QString>("message");
    const auto row = [](const char* words, const char* message) {
        QTest::newRow(words) << QString::fromLatin1(message);
    };
    row("steps", "rasterlens-cli steps: SCENE is missing");
    row("steps builtin:triangle --face 1", "--face: \"1\" is not a whole number from 0 to 0");
    row("steps builtin:triangle --face -1", "--face: \"-1\" is not a whole number from 0 to 0");
    row("steps builtin:triangle --limit 0", "--limit: \"0\" is not a whole number from 1");
    row("steps builtin:square-diagonal --pixel 8,0", "--pixel: 8,0 lies outside the picture; expected: 0,0 to 7,7");
    row("steps builtin:square-diagonal --pixel 1", "--pixel: \"1\" is not a pixel; expected: x,y");
    row("why builtin:square-diagonal --pixel 1,b", "--pixel: \"1,b\" is not a pixel; expected: x,y");
    row("why builtin:square-diagonal", "rasterlens-cli why: --pixel x,y is missing");
    row("why builtin:square-diagonal --pixel 0,0 --attribute-path edge-then-span",
        "rasterlens-cli why: attribute-path");
}

void TestCliSteps::badCalls()
{
    QFETCH(QString, message);
    const Run run = call(QString::fromLatin1(QTest::currentDataTag()));
    QCOMPARE(run.exitCode, 2);
    QCOMPARE(run.out, QByteArray());
    QVERIFY2(run.err.startsWith(message), qPrintable(run.err));
}

void TestCliSteps::tiesAreToldWithTheirOwners()
{
    const Run run = call(QStringLiteral("steps builtin:square-diagonal"));
    QCOMPARE(run.exitCode, 0);
    int ours = 0;
    int others = 0;
    for (const QByteArray& line : linesOf(run.out)) {
        ours += line.contains("(left, ours)") && line.endsWith("inside, tie") ? 1 : 0;
        others += line.contains("(neither, not ours)") && line.endsWith("outside, tie") ? 1 : 0;
    }
    QCOMPARE(ours, 8);
    QCOMPARE(others, 8);
    QVERIFY(linesOf(run.out).last().endsWith(" end"));
}

void TestCliSteps::limitIsSaid()
{
    const QList<QByteArray> lines = linesOf(call(QStringLiteral("steps builtin:square-diagonal --limit 5")).out);
    QCOMPARE(lines.size(), 6);
    QCOMPARE(lines.last(), QByteArray("truncated after 5 steps; a larger --limit tells more"));
}

void TestCliSteps::anyStepOfALargeSceneIsTold()
{
    // Steps that are made anew in the middle are those that are counted from the beginning.
    const QList<QByteArray> all = linesOf(call(QStringLiteral("steps builtin:square-diagonal")).out);
    QCOMPARE(linesOf(call(QStringLiteral("steps builtin:square-diagonal --from 100 --limit 7")).out).mid(0, 7),
             all.mid(100, 7));
    QCOMPARE(linesOf(call(QStringLiteral("steps builtin:square-diagonal --from %1").arg(all.size() - 1)).out),
             all.mid(all.size() - 1));

    const Run run = call(QStringLiteral("steps builtin:cube --from 2000000 --limit 3"));
    QCOMPARE(run.exitCode, 0);
    const QList<QByteArray> lines = linesOf(run.out);
    QCOMPARE(lines.size(), 4);
    QVERIFY2(lines.first().startsWith("2000000 "), lines.first().constData());
    QVERIFY2(lines.first().contains(" face "), lines.first().constData());
    QVERIFY(lines.last().startsWith("truncated after 3 steps"));
}

void TestCliSteps::jsonHasOneObjectALine()
{
    const QTemporaryDir folder;
    const Run run = call(QStringLiteral("steps builtin:square-diagonal --json s.jsonl"), folder.path());
    QCOMPARE(run.exitCode, 0);
    QCOMPARE(run.out, QByteArray());
    QFile file(folder.filePath(QStringLiteral("s.jsonl")));
    QVERIFY(file.open(QIODevice::ReadOnly));
    int step = 0;
    for (const QByteArray& line : linesOf(file.readAll())) {
        const QJsonObject object = QJsonDocument::fromJson(line).object();
        QCOMPARE(object[QStringLiteral("step")].toInt(-1), step++);
        QVERIFY(!object[QStringLiteral("event")].toString().isEmpty());
    }
    QVERIFY(step > 300);
}

void TestCliSteps::filtersKeepFaceAndPixel()
{
    const Run run = call(QStringLiteral("steps builtin:square-diagonal --face 1 --pixel 7,7 --json -"));
    QList<QString> events;
    for (const QByteArray& line : linesOf(run.out)) {
        const QJsonObject object = QJsonDocument::fromJson(line).object();
        events << object[QStringLiteral("event")].toString();
        QVERIFY(events.last() == QStringLiteral("end") || object[QStringLiteral("face")].toInt() == 1);
        QVERIFY(!object.contains(QStringLiteral("x")) || object[QStringLiteral("x")].toInt() == 7);
    }
    QCOMPARE(events.join(QLatin1Char(' ')),
             QStringLiteral("vertex vertex vertex viewport viewport viewport facing fate "
                            "triangle setup sample fragment shade write end"));
}

void TestCliSteps::whyNamesTheEdge()
{
    const Run run = call(QStringLiteral("why builtin:square-diagonal --pixel 3,3"));
    QCOMPARE(run.exitCode, 0);
    QCOMPARE(run.out, QByteArray("pixel 3,3: #8f8f00, face 0, depth 0.5\n"
                                 "face 0: written #8f8f00 over #000000, depth 0.5 over 1; seen\n"
                                 "face 1: outside edge AB (-8)\n"));
    QVERIFY(call(QStringLiteral("why builtin:square-diagonal --pixel 3,4"))
                .out.contains("face 0: lost the tie on edge BC (0): neither a left nor a top edge, so not ours; "
                              "50.0 % of the pixel's area\n"));
}

void TestCliSteps::whyAsJson()
{
    const Run run = call(QStringLiteral("why builtin:square-diagonal --pixel 3,4 --json -"));
    const QJsonObject json = QJsonDocument::fromJson(run.out).object();
    QCOMPARE(json[QStringLiteral("visible_face")].toInt(-1), 1);
    QCOMPARE(json[QStringLiteral("faces")].toArray().size(), 2);
}

QTEST_APPLESS_MAIN(TestCliSteps)
#include "test_cli_steps.moc"
