// Models far from the origin on the command line: file coordinates in and out, and the reference from object space.
#include "tests/scene_files.h"

#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

using namespace rasterlens::test;

namespace
{

struct Run {
    int exitCode;
    QString out;
    QString err;
};

/// Four triangles round a point, a pyramid of 16 x 16 x 8, with decimals that float32 cannot hold there.
QByteArray pyramid(double x, double y, double z)
{
    const auto vertex = [&](double dx, double dy, double dz) {
        return "v " + QByteArray::number(x + dx, 'f', 3) + ' ' + QByteArray::number(y + dy, 'f', 3) + ' ' +
               QByteArray::number(z + dz, 'f', 3) + '\n';
    };
    return vertex(-0.125, -0.25, 0) + vertex(15.875, -0.25, 0) + vertex(15.875, 15.75, 0) + vertex(-0.125, 15.75, 0) +
           vertex(7.875, 7.75, 8) + "f 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
}

} // namespace

class TestCliFar : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase();
    void infoSaysTheCoordinatesOfTheFile();
    void stepsSayThem();
    void eyeIsGivenInThem();
    void sessionsKeepThem();
    void errorsFromObjectSpace();
    void chart();
    void refusals_data();
    void refusals();

private:
    [[nodiscard]] Run call(const QString& words) const
    {
        QProcess process;
        process.setWorkingDirectory(m_folder.path());
        process.start(QStringLiteral(RASTERLENS_CLI), words.split(QLatin1Char(' ')));
        if (!process.waitForFinished(-1) || process.exitStatus() != QProcess::NormalExit)
            return {-1, {}, process.errorString()};
        return {process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
                QString::fromUtf8(process.readAllStandardError())};
    }

    [[nodiscard]] QImage picture(const QString& words) const
    {
        const Run run = call(QStringLiteral("render %1 --size 160x120 --shading random-flat -o out.png").arg(words));
        if (run.exitCode != 0)
            qFatal("%s", qPrintable(run.err));
        return QImage(m_folder.path(QStringLiteral("out.png")));
    }

    Folder m_folder;
};

void TestCliFar::initTestCase()
{
    m_folder.write(QStringLiteral("near.obj"), pyramid(0, 0, 0));
    m_folder.write(QStringLiteral("far.obj"), pyramid(500000, 5000000, 128));
}

void TestCliFar::infoSaysTheCoordinatesOfTheFile()
{
    const Run text = call(QStringLiteral("info far.obj"));
    QCOMPARE(text.exitCode, 0);
    QVERIFY2(text.out.contains(QStringLiteral("box        499999.875, 4999999.75, 128 to 500015.875, 5000015.75, 136")),
             qPrintable(text.out));
    QVERIFY(text.out.contains(QStringLiteral("centre 500007.875, 5000007.75, 132")));
    QVERIFY(text.out.contains(QStringLiteral("origin     500000, 5000000, 128")));
    QVERIFY(text.err.contains(QStringLiteral("far.obj: warning: the model is 16 across")));
    const QJsonObject json = QJsonDocument::fromJson(call(QStringLiteral("info far.obj --json")).out.toUtf8()).object();
    QCOMPARE(json["box"].toObject()["max"].toArray(), (QJsonArray{500015.875, 5000015.75, 136}));
    QCOMPARE(json["origin"].toArray(), (QJsonArray{500000, 5000000, 128}));
    const Run near = call(QStringLiteral("info near.obj"));
    QVERIFY(near.err.isEmpty() && !near.out.contains(QStringLiteral("origin")));
}

void TestCliFar::stepsSayThem()
{
    const Run far = call(QStringLiteral("steps far.obj --face 0 --size 64x48"));
    QVERIFY2(
        far.out.contains(QStringLiteral("vertex 0: world (499999.875, 4999999.75, 128), object (-0.125, -0.25, 0, 1)")),
        qPrintable(far.out.left(400)));
    const Run near = call(QStringLiteral("steps near.obj --face 0 --size 64x48"));
    QVERIFY(near.out.contains(QStringLiteral("vertex 0: object (-0.125, -0.25, 0, 1)")));
    const QString first = call(QStringLiteral("steps far.obj --face 0 --size 64x48 --json -")).out.section('\n', 0, 0);
    QCOMPARE(QJsonDocument::fromJson(first.toUtf8()).object()["world"].toArray(),
             (QJsonArray{499999.875, 4999999.75, 128, 1}));
}

void TestCliFar::eyeIsGivenInThem()
{
    const QImage near = picture(QStringLiteral("near.obj --eye 4,5,40 --target 8,8,0"));
    const QImage far = picture(QStringLiteral("far.obj --eye 500004,5000005,168 --target 500008,5000008,128"));
    QCOMPARE(far, near);
    QVERIFY(picture(QStringLiteral("far.obj")) == picture(QStringLiteral("near.obj")));
}

/// A vertex that a session moves is named by the coordinates of the file.
void TestCliFar::sessionsKeepThem()
{
    m_folder.write(QStringLiteral("near.json"),
                   R"({"rasterlens": 1, "scene": "near.obj", "vertices": {"2": [12.5, 3.0625, 8, 1]}})");
    m_folder.write(QStringLiteral("far.json"),
                   R"({"rasterlens": 1, "scene": "far.obj", "vertices": {"2": [500012.5, 5000003.0625, 136, 1]}})");
    const QImage moved = picture(QStringLiteral("far.json"));
    QVERIFY(moved == picture(QStringLiteral("near.json")));
    QVERIFY(moved != picture(QStringLiteral("far.obj")));
}

void TestCliFar::errorsFromObjectSpace()
{
    const QString words =
        QStringLiteral("bench far.obj builtin:square-diagonal --size 96x72 --frames 1 --variants tiled");
    const QJsonArray object =
        QJsonDocument::fromJson(call(words + QStringLiteral(" --reference exact-object --json -")).out.toUtf8())
            .array();
    QCOMPARE(object.size(), 2);
    QCOMPARE(object[0]["reference"].toString(), QStringLiteral("exact-object"));
    QCOMPARE(object[1]["reference"].toString(), QStringLiteral("exact")); // a scene in clip space
    const Run text = call(words + QStringLiteral(" --reference exact-object"));
    QVERIFY(text.out.contains(QStringLiteral("judged from object space")) &&
            text.out.contains(QStringLiteral("judged from clip space")));
    const Run none = call(words + QStringLiteral(" --reference none --csv -"));
    QVERIFY2(none.out.section('\n', 0, 0).contains(QStringLiteral(",reference,")), qPrintable(none.out));
}

void TestCliFar::chart()
{
    const Run run =
        call(QStringLiteral("bench near.obj --chart distance --size 96x72 --csv c.csv --json c.json --plot c.svg"));
    QVERIFY2(run.exitCode == 0, qPrintable(run.err));
    QVERIFY(run.out.contains(QStringLiteral("size/distance")));
    QFile json(m_folder.path(QStringLiteral("c.json")));
    QVERIFY(json.open(QIODevice::ReadOnly));
    const QJsonArray rows = QJsonDocument::fromJson(json.readAll()).array();
    QVERIFY(rows.size() > 10);
    QVERIFY(rows.last()["float32"]["corner_px"].toDouble() > 1);
    QVERIFY(rows.last()["relative_size"].toDouble() < 1e-4);
    QFile csv(m_folder.path(QStringLiteral("c.csv")));
    QVERIFY(csv.open(QIODevice::ReadOnly));
    QCOMPARE(csv.readAll().count('\n'), rows.size() + 1);
    QFile svg(m_folder.path(QStringLiteral("c.svg")));
    QVERIFY(svg.open(QIODevice::ReadOnly) && svg.readAll().contains("sizes of the model"));
}

void TestCliFar::refusals_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("phrase");
    QTest::newRow("chart") << "bench near.obj --chart speed"
                           << "--chart: \"speed\" is not a value of chart, which takes: snapping, "
                              "depth-step, edge-functions, lines, attributes, msaa, distance";
    QTest::newRow("clip space") << "bench builtin:square-diagonal --chart distance"
                                << "a scene in object space is expected";
    QTest::newRow("two scenes") << "bench near.obj far.obj --chart distance"
                                << "takes one scene";
    QTest::newRow("measurement") << "bench near.obj --chart distance --frames 3"
                                 << "--frames: cannot be combined";
    QTest::newRow("reference") << "bench near.obj --reference object"
                               << "exact, exact-object, none";
}

void TestCliFar::refusals()
{
    QFETCH(QString, words);
    QFETCH(QString, phrase);
    const Run run = call(words);
    QCOMPARE(run.exitCode, 2);
    QVERIFY2(run.err.contains(phrase), qPrintable(run.err));
    QVERIFY(run.out.isEmpty());
}

QTEST_GUILESS_MAIN(TestCliFar)
#include "test_cli_far.moc"
