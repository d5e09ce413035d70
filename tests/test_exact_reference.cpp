// The exact reference against answers known by hand, against itself, and against the shared results.
#include "core/case_file.h"
#include "core/truth/exact_reference.h"

#include <QDir>
#include <QElapsedTimer>
#include <QTest>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

using namespace rasterlens;

namespace
{

/// The numbers of a NumPy file. in: 4- and 8-byte little-endian types
template <typename T>
std::vector<T> npyValues(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QByteArray bytes = file.readAll();
    const qsizetype header = 10 + static_cast<unsigned char>(bytes[8]) + 256 * static_cast<unsigned char>(bytes[9]);
    std::vector<T> values(static_cast<std::size_t>(bytes.size() - header) / sizeof(T));
    std::memcpy(values.data(), bytes.constData() + header, values.size() * sizeof(T));
    return values;
}

} // namespace

class TestExactReference : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sharedCases_data();
    void sharedCases();
};

void TestExactReference::sharedCases_data()
{
    QTest::addColumn<QString>("name");
    const QDir folder(QStringLiteral(RASTERLENS_SHARED "/cases"));
    for (const QString& file : folder.entryList({QStringLiteral("*.case")}))
        QTest::newRow(qPrintable(file)) << QFileInfo(file).completeBaseName();
    if (folder.entryList({QStringLiteral("*.case")}).isEmpty())
        QTest::newRow("none") << QString();
}

void TestExactReference::sharedCases()
{
    QFETCH(QString, name);
    if (name.isEmpty())
        QSKIP("the shared cases are not there");
    const QString folder = QStringLiteral(RASTERLENS_SHARED "/cases/");
    const std::optional<Scene> scene = loadCase(folder + name + QStringLiteral(".case")).scene;
    QVERIFY(scene);
    const std::vector<ClipTriangle> triangles = exactTriangles(*scene, scene->defaults);
    for (const bool snap : {true, false}) {
        const QString prefix =
            folder + QStringLiteral("expected/") + name + (snap ? QString() : QStringLiteral(".exact"));
        const auto cover = npyValues<std::uint32_t>(prefix + ".cover.npy");
        if (cover.empty()) {
            qDebug("no arrays: %s", qPrintable(prefix));
            continue;
        }
        ExactOptions options = exactOptions(*scene, scene->defaults);
        options.snap = snap && !scene->exact;
        options.edgeDistance = true;
        QElapsedTimer timer;
        timer.start();
        const ExactFrame frame = exactReference(triangles, options);
        const qint64 ms = timer.elapsed();
        const auto id = npyValues<std::int32_t>(prefix + ".id.npy");
        const auto depth = npyValues<double>(prefix + ".depth.npy");
        const auto color = npyValues<double>(prefix + ".color.npy");
        const auto edge = npyValues<float>(prefix + ".edge.npy");
        QCOMPARE(cover.size(), frame.cover.size());
        int badCover = 0, badId = 0;
        double depthError = 0, colorError = 0, edgeError = 0;
        for (std::size_t i = 0; i < cover.size(); ++i) {
            badCover += cover[i] != frame.cover[i];
            badId += id[i] != frame.id[i];
            depthError = std::max(depthError, std::abs(depth[i] - frame.depth[i]));
            for (int k = 0; k < 3; ++k)
                colorError = std::max(colorError, std::abs(color[3 * i + std::size_t(k)] - frame.color[i][k]));
            if (std::min(edge[i], frame.edgeDistance[i]) < 1.5 && std::abs(edge[i] - frame.edgeDistance[i]) > 1e-4)
                qDebug("%d: want %g have %g", int(i), double(edge[i]), double(frame.edgeDistance[i]));
            if (std::min(edge[i], frame.edgeDistance[i]) < 1.5)
                edgeError = std::max(edgeError, double(std::abs(edge[i] - frame.edgeDistance[i])));
        }
        qDebug("%s snap %d: cover %d id %d depth %g color %g edge %g  %lld ms", qPrintable(name), snap, badCover, badId,
               depthError, colorError, edgeError, ms);
    }
}

QTEST_APPLESS_MAIN(TestExactReference)
#include "test_exact_reference.moc"
