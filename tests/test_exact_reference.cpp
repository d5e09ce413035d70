// Coverage by the exact reference against answers known by hand, against itself, and against the shared results.
#include "core/io/case_file.h"
#include "core/truth/edge_distance.h"
#include "tests/exact_support.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

/// The numbers of a NumPy file of a known type.
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

/// A grid of quads over the viewport, and beyond it by `reach`, with jittered inner corners and random diagonals.
std::vector<ClipTriangle> randomMesh(std::mt19937& random, int cells, double reach, double minW, double maxW)
{
    std::uniform_real_distribution<double> jitter(-0.35, 0.35);
    std::uniform_real_distribution<double> w(minW, maxW);
    const int side = cells + 1;
    std::vector<ClipVertex> corners;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            const bool inner = i > 0 && j > 0 && i < cells && j < cells;
            const auto place = [&](int k) {
                return static_cast<double>(
                    static_cast<float>(reach * (2 * (k + (inner ? jitter(random) : 0)) / cells - 1)));
            };
            const double weight = static_cast<double>(static_cast<float>(w(random)));
            const double x = place(i);
            const double y = place(j);
            corners.push_back(clipVertex({x * weight, y * weight, 0, weight}));
        }
    std::vector<ClipTriangle> triangles;
    const auto add = [&](int a, int b, int c) {
        const auto corner = [&](int i) { return corners[static_cast<std::size_t>(i)]; };
        triangles.push_back({{corner(a), corner(b), corner(c)}, static_cast<std::uint32_t>(triangles.size())});
    };
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            const int a = j * side + i;
            const int b = a + 1;
            const int c = a + side + 1;
            const int d = a + side;
            if (random() % 2 == 0) {
                add(a, b, c);
                add(d, c, a); // the other winding
            } else {
                add(a, b, d);
                add(b, c, d);
            }
        }
    return triangles;
}

} // namespace

class TestExactReference : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void diagonalBelongsToOneFace();
    void quadWithEdgesOnCentres();
    void coverageIsThatOfTheDisplacedSample();
    void halfStepsRoundToEven();
    void fewerSubpixelBitsSnapFurther();
    void zeroAreaDrawsNothing();
    void areaMayVanishOnSnapping();
    void negativeWIsNotMirrored();
    void cornerAtTheEyeIsEdgeOn();
    void nonFiniteFacesAreCounted();
    void cullingFollowsTheSnappedArea();
    void windowIsACut();
    void scalingChangesNothing();
    void meshesPartitionTheViewport();
    void clippedEqualsUnclippedCoverage();
    void edgeDistanceByHand();
    void sharedCases_data();
    void sharedCases();
};

void TestExactReference::diagonalBelongsToOneFace()
{
    Faces faces;
    faces.pixels({0, 0}, {0, 8}, {8, 8}).pixels({0, 0}, {8, 8}, {8, 0});
    for (const bool snap : {true, false}) {
        const ExactFrame frame = faces.draw(snap);
        QVERIFY(everySampleOnce(frame));
        // the diagonal runs through the centres and is a left edge of the upper right face
        QCOMPARE(std::count(frame.id.begin(), frame.id.end(), 1), 36);
        QCOMPARE(frame.id[3 * 8 + 3], 1);
    }
}

void TestExactReference::quadWithEdgesOnCentres()
{
    Faces faces;
    faces.pixels({1.5, 1.5}, {1.5, 6.5}, {6.5, 6.5}).pixels({1.5, 1.5}, {6.5, 6.5}, {6.5, 1.5});
    for (const bool snap : {true, false}) {
        const ExactFrame frame = faces.draw(snap);
        for (std::size_t y = 0; y < 8; ++y)
            for (std::size_t x = 0; x < 8; ++x)
                QCOMPARE(frame.cover[y * 8 + x], x >= 1 && x <= 5 && y >= 1 && y <= 5 ? 1U : 0U);
    }
}

void TestExactReference::coverageIsThatOfTheDisplacedSample()
{
    // corners on all the half pixels there are: every tie rule is exercised, and a displacement too small to meet
    // anything but the ties must not change a thing
    const quint32 seed = 20240611;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    const auto place = [&] { return static_cast<double>(random() % 15 + 1) / 2; };
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec2 a(place(), place());
        const glm::dvec2 b(place(), place());
        const glm::dvec2 c(place(), place());
        const glm::dvec2 shift(-0x1p-10, -0x1p-20);
        const ExactFrame tied = Faces().pixels(a, b, c).draw(true);
        const ExactFrame exact = Faces().pixels(a, b, c).draw(false);
        const ExactFrame shifted = Faces().pixels(a + shift, b + shift, c + shift).draw(false);
        QCOMPARE(tied.cover, exact.cover);
        QCOMPARE(tied.cover, shifted.cover);
    }
}

void TestExactReference::halfStepsRoundToEven()
{
    // a quad whose left edge is `units` 512ths of a pixel right of the centre of column 2
    const auto covered = [](double units) {
        const double x = 2.5 + units / 512;
        return Faces().pixels({x, 0}, {x, 8}, {6, 8}).pixels({x, 0}, {6, 8}, {6, 0}).draw().cover[2] == 1;
    };
    QVERIFY(covered(-1)); // rounds up to the centre
    QVERIFY(covered(0));
    QVERIFY(covered(1)); // rounds down to the centre
    QVERIFY(!covered(2));
    QVERIFY(!covered(3)); // rounds up to the second unit
}

void TestExactReference::fewerSubpixelBitsSnapFurther()
{
    Faces faces;
    faces.pixels({1.5, 1.5}, {1.5, 6.5}, {6.5, 6.5}).pixels({1.5, 1.5}, {6.5, 6.5}, {6.5, 1.5});
    ExactOptions options = faces.options();
    options.subpixelBits = 0; // 1.5 rounds to 2, 6.5 to 6
    const ExactFrame frame = exactReference(faces.list(), options);
    QCOMPARE(totalCover(frame), 16U);
    QCOMPARE(frame.cover[2 * 8 + 2], 1U);
    QCOMPARE(frame.cover[1 * 8 + 1], 0U);
    options.subpixelBits = 1;
    QCOMPARE(totalCover(exactReference(faces.list(), options)), 25U);
}

void TestExactReference::zeroAreaDrawsNothing()
{
    Faces faces;
    faces.pixels({0.5, 0.5}, {3.5, 3.5}, {7.5, 7.5}).pixels({2.5, 2.5}, {2.5, 2.5}, {6.5, 2.5});
    for (const bool snap : {true, false}) {
        const ExactFrame frame = faces.draw(snap);
        QCOMPARE(totalCover(frame), 0U);
        QCOMPARE(frame.degenerate, 2);
    }
}

void TestExactReference::areaMayVanishOnSnapping()
{
    const double d = 1.0 / 1024;
    Faces faces;
    faces.pixels({4.5 - d, 4.5 - d}, {4.5 - d, 4.5 + d}, {4.5 + 2 * d, 4.5});
    QCOMPARE(totalCover(faces.draw(true)), 0U);
    QCOMPARE(faces.draw(true).degenerate, 1);
    QCOMPARE(totalCover(faces.draw(false)), 1U);
}

void TestExactReference::negativeWIsNotMirrored()
{
    Faces faces;
    faces.clip({-0.5, -0.5, 0.25, 1}, {0.5, -0.5, 0.25, 1}, {0, 1.5, 0.25, -1});
    const ExactFrame snapped = faces.draw(true);
    const ExactFrame exact = faces.draw(false);
    QCOMPARE(snapped.cover, exact.cover);
    // the face opens upwards from its visible edge; the divide alone would put the third corner below it
    QCOMPARE(snapped.cover[2 * 8 + 4], 1U);
    QCOMPARE(snapped.cover[7 * 8 + 4], 0U);

    Faces behind;
    behind.clip({-0.5, -0.5, 0, -1}, {0.5, -0.5, 0, -1}, {0, 0.5, 0, -1});
    QCOMPARE(totalCover(behind.draw(true)), 0U);
    QCOMPARE(totalCover(behind.draw(false)), 0U);
}

void TestExactReference::cornerAtTheEyeIsEdgeOn()
{
    Faces faces;
    faces.clip({0, 0, 0, 0}, {0.5, -0.5, 0, 1}, {0, 0.5, 0, 1});
    for (const bool snap : {true, false}) {
        QCOMPARE(totalCover(faces.draw(snap)), 0U);
        QCOMPARE(faces.draw(snap).degenerate, 1);
    }
}

void TestExactReference::nonFiniteFacesAreCounted()
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    Faces faces;
    faces.clip({nan, 0, 0, 1}, {1, 0, 0, 1}, {0, 1, 0, 1}).clip({0, 0, 0, inf}, {1, 0, 0, 1}, {0, 1, 0, 1});
    faces.pixels({0, 0}, {0, 8}, {8, 8});
    const ExactFrame frame = faces.draw();
    QCOMPARE(frame.nonFinite, 2);
    QCOMPARE(totalCover(frame), 28U);
    QCOMPARE(frame.id[7 * 8], 2);
}

void TestExactReference::cullingFollowsTheSnappedArea()
{
    Faces faces; // y up: the first runs counter-clockwise
    faces.pixels({0, 0}, {0, 8}, {8, 8}).pixels({0, 0}, {8, 0}, {8, 8});
    for (const bool snap : {true, false}) {
        ExactOptions options = faces.options(snap);
        options.culling = Culling::Back;
        ExactFrame frame = exactReference(faces.list(), options);
        QCOMPARE(frame.culled, 1);
        QCOMPARE(std::count(frame.id.begin(), frame.id.end(), 0), 28);
        QCOMPARE(std::count(frame.id.begin(), frame.id.end(), 1), 0);
        options.winding = Winding::Clockwise;
        frame = exactReference(faces.list(), options);
        QCOMPARE(std::count(frame.id.begin(), frame.id.end(), 1), 36);
    }
    // 1/1024 px to one side before snapping, 1/256 px to the other after it
    Faces thin;
    thin.pixels({0.5, 3.5}, {7.5, 3.5}, {4, 3.5 + 1.0 / 1024});
    QCOMPARE(thin.draw(true).degenerate, 1);
    QCOMPARE(thin.draw(false).degenerate, 0);
}

void TestExactReference::windowIsACut()
{
    const quint32 seed = 7;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    const std::vector<ClipTriangle> mesh = randomMesh(random, 6, 1.5, 0.5, 4);
    for (const bool snap : {true, false}) {
        ExactOptions options = Faces(64).options(snap);
        const ExactFrame whole = exactReference(mesh, options);
        options.window = PixelRect{17, 23, 30, 11};
        const ExactFrame cut = exactReference(mesh, options);
        for (std::size_t y = 0; y < 11; ++y)
            for (std::size_t x = 0; x < 30; ++x) {
                const std::size_t i = (y + 23) * 64 + x + 17;
                QCOMPARE(cut.cover[y * 30 + x], whole.cover[i]);
                QCOMPARE(cut.id[y * 30 + x], whole.id[i]);
                QVERIFY(std::abs(cut.depth[y * 30 + x] - whole.depth[i]) < 1e-15);
            }
    }
}

void TestExactReference::scalingChangesNothing()
{
    const auto scaled = [](double s) {
        const glm::dvec4 a(-0.75, -0.5, 0.25, 1);
        const glm::dvec4 b(1.5, -1, 0.5, 2);
        const glm::dvec4 c(0.25, 0.875, -0.5, 1);
        return Faces(32).clip(s * a, s * b, s * c);
    };
    for (const bool snap : {true, false}) {
        const ExactFrame one = scaled(1).draw(snap);
        QVERIFY(totalCover(one) > 100);
        for (const double s : {0x1p-126, 0x1p100, 0x1p-1000, 0x1p900}) {
            const ExactFrame other = scaled(s).draw(snap);
            QCOMPARE(other.cover, one.cover);
            QCOMPARE(other.depth, one.depth);
        }
    }
}

void TestExactReference::meshesPartitionTheViewport()
{
    const quint32 seed = 4711;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    for (int round = 0; round < 20; ++round)
        for (const double reach : {1.0, 2.5, 1e4}) {
            const std::vector<ClipTriangle> mesh = randomMesh(random, 9, reach, 0.25, 4);
            ExactOptions options = Faces(61).options(round % 2 == 0);
            options.subpixelBits = round % 9;
            options.sampleGrid = round % 4 + 1;
            const ExactFrame frame = exactReference(mesh, options);
            // a coarse grid may fold a mesh over, but never tear it
            QVERIFY(std::all_of(frame.cover.begin(), frame.cover.end(), [](std::uint32_t n) { return n >= 1; }));
            if (!options.snap || (options.subpixelBits > 4 && reach < 10))
                QVERIFY(everySampleOnce(frame));
        }
}

void TestExactReference::clippedEqualsUnclippedCoverage()
{
    // two methods that share no line: with snapping a face is clipped, without it is not. They may differ only where
    // the snap moved an edge.
    const quint32 seed = 815;
    qInfo("seed %u", seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-3, 3);
    std::uniform_real_distribution<double> depth(-1.5, 1.5);
    std::uniform_real_distribution<double> weight(-1, 2);
    int compared = 0;
    for (int i = 0; i < 1000; ++i) {
        Faces faces(64);
        const auto corner = [&] { return glm::dvec4(place(random), place(random), depth(random), weight(random)); };
        faces.clip(corner(), corner(), corner());
        ExactOptions options = faces.options(true);
        options.edgeDistance = true;
        const ExactFrame snapped = exactReference(faces.list(), options);
        const ExactFrame exact = faces.draw(false);
        for (std::size_t k = 0; k < exact.cover.size(); ++k)
            if (snapped.edgeDistance[k] > 0.005F) {
                QCOMPARE(snapped.cover[k], exact.cover[k]);
                compared += exact.cover[k] > 0;
            }
    }
    QVERIFY2(compared > 10000, qPrintable(QString::number(compared)));
}

void TestExactReference::edgeDistanceByHand()
{
    Faces faces;
    faces.pixels({2, 2}, {2, 6}, {6, 2});
    ExactOptions options = faces.options();
    options.edgeDistance = true;
    const ExactFrame frame = exactReference(faces.list(), options);
    const auto at = [&](std::size_t x, std::size_t y) { return static_cast<double>(frame.edgeDistance[y * 8 + x]); };
    QCOMPARE(at(2, 3), 0.5);
    QVERIFY(std::abs(at(1, 1) - std::sqrt(0.5)) < 1e-6);
    QVERIFY(std::abs(at(4, 4) - std::sqrt(0.5)) < 1e-6);
    QCOMPARE(frame.edgeDistance[63], kFarFromEdges);
}

void TestExactReference::sharedCases_data()
{
    QTest::addColumn<QString>("name");
    const QDir folder(QStringLiteral(RASTERLENS_SHARED "/cases"));
    const QStringList files = folder.entryList({QStringLiteral("*.case")});
    for (const QString& file : files)
        QTest::newRow(qPrintable(file)) << QFileInfo(file).completeBaseName();
    if (files.isEmpty())
        QTest::newRow("none") << QString();
}

void TestExactReference::sharedCases()
{
    QFETCH(QString, name);
    if (name.isEmpty())
        QSKIP("the shared cases are not there");
    const QString folder = QStringLiteral(RASTERLENS_SHARED "/cases/");
    const SceneLoad load = loadCase(folder + name + QStringLiteral(".case"));
    QVERIFY(load.scene);
    const Scene& scene = *load.scene;
    int compared = 0;
    for (const bool snap : {true, false}) {
        const QString prefix =
            folder + QStringLiteral("expected/") + name + (snap ? QString() : QStringLiteral(".exact"));
        const auto cover = npyValues<std::uint32_t>(prefix + QStringLiteral(".cover.npy"));
        if (cover.empty())
            continue;
        ExactOptions options = exactOptions(scene, scene.defaults);
        options.snap = snap && !scene.exact;
        options.edgeDistance = true;
        const ExactFrame frame = exactReference(exactTriangles(scene, scene.defaults), options);
        const auto depth = npyValues<double>(prefix + QStringLiteral(".depth.npy"));
        const auto color = npyValues<double>(prefix + QStringLiteral(".color.npy"));
        const auto edge = npyValues<float>(prefix + QStringLiteral(".edge.npy"));
        QCOMPARE(frame.cover, cover);
        QCOMPARE(frame.id, npyValues<std::int32_t>(prefix + QStringLiteral(".id.npy")));
        for (std::size_t i = 0; i < cover.size(); ++i) {
            QVERIFY(std::abs(depth[i] - frame.depth[i]) <= 1e-12);
            for (int k = 0; k < 3; ++k)
                QVERIFY(std::abs(color[3 * i + static_cast<std::size_t>(k)] - frame.color[i][k]) <= 1e-12);
            if (std::min(edge[i], frame.edgeDistance[i]) < static_cast<float>(kEdgeBandPixels))
                QVERIFY(std::abs(edge[i] - frame.edgeDistance[i]) < 1e-6F);
        }
        ++compared;
    }
    if (compared == 0)
        QSKIP("no expected arrays for this case");
}

QTEST_APPLESS_MAIN(TestExactReference)
#include "test_exact_reference.moc"
