#include "core/scenes/load_scene.h"

// Models far from the origin: the rule of recentring, its exactness, and pictures that do not depend on the place.
#include "core/scene/origin.h"
#include "tests/scene_files.h"
#include "tests/support.h"

#include <QTest>

#include <array>
#include <cmath>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

/// A lattice of tilted quads, 12 x 12 cells of one unit: its corners and its faces, as the lines of an OBJ file.
constexpr int kCells = 12;

glm::dvec3 latticePoint(int column, int row)
{
    constexpr double kWave = 0.25;
    return {double(column), double(row), kWave * ((column * 5 + row * 3) % 8)};
}

QByteArray lattice(const glm::dvec3& move, double scale = 1)
{
    QByteArray text;
    for (int row = 0; row <= kCells; ++row)
        for (int column = 0; column <= kCells; ++column) {
            const glm::dvec3 p = scale * latticePoint(column, row) + move;
            text += "v " + QByteArray::number(p.x, 'g', 17) + ' ' + QByteArray::number(p.y, 'g', 17) + ' ' +
                    QByteArray::number(p.z, 'g', 17) + '\n';
        }
    for (int row = 0; row < kCells; ++row)
        for (int column = 0; column < kCells; ++column) {
            const int first = row * (kCells + 1) + column + 1;
            if ((row + column) % 2 == 0)
                for (const int corner : {first, first + 1, first + kCells + 2, first + kCells + 1})
                    text += (corner == first ? "f " : " ") + QByteArray::number(corner);
            text += '\n';
        }
    return text;
}

BoundingBox boxOf(const glm::dvec3& low, const glm::dvec3& high)
{
    BoundingBox box;
    box.add(low);
    box.add(high);
    return box;
}

Settings pictureSettings()
{
    Settings settings;
    settings.size = {320, 240};
    settings.culling = Culling::None;
    settings.shading = Shading::RandomFlat;
    settings.view.yaw = 20;
    settings.view.pitch = 15;
    return settings;
}

int differingPixels(const Frame& a, const Frame& b)
{
    int count = 0;
    for (int y = 0; y < a.image.height(); ++y)
        for (int x = 0; x < a.image.width(); ++x)
            count += a.image.pixel(x, y) != b.image.pixel(x, y);
    return count;
}

} // namespace

class TestOrigin : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nearModelsKeepTheirPositions();
    void farModelsHaveAnOriginOfTheirOwn();
    void differencesAreExact();
    void remarks();
    void movedByAPowerOfTwoNothingChanges_data();
    void movedByAPowerOfTwoNothingChanges();
    void movedAnywherePicturesAgree_data();
    void movedAnywherePicturesAgree();
    void eyeAndTargetInTheCoordinatesOfTheFile();
    void vertexOutsideTheFacesDoesNotCount();
    void madeScenesHaveNone();

private:
    [[nodiscard]] Scene load(const QByteArray& text) const
    {
        const SceneLoad load = loadScene(m_folder.write(QStringLiteral("lattice.obj"), text));
        if (!load.scene)
            qFatal("%s", qPrintable(textOf(load.diagnostics)));
        return *load.scene;
    }

    Folder m_folder;
};

void TestOrigin::nearModelsKeepTheirPositions()
{
    QVERIFY(originFor({}) == glm::dvec3(0));
    QVERIFY(originFor(boxOf({0, 0, 0}, {0, 0, 0})) == glm::dvec3(0));
    QVERIFY(originFor(boxOf({-1, -1, -1}, {1, 1, 1})) == glm::dvec3(0));
    QVERIFY(originFor(boxOf({7, 0, 0}, {8, 0, 0})) == glm::dvec3(0)); // 1 / 7.5 is above 1/8
    QVERIFY(originFor(boxOf({8, 0, 0}, {9, 0, 0})) != glm::dvec3(0)); // 1 / 8.5 is below
    const Scene near = load(lattice({3.1, -2.7, 0.3}, 0.1));
    QVERIFY(near.mesh.origin == glm::dvec3(0));
    QCOMPARE(near.mesh.vertices[0].position.x, 3.1F);
}

void TestOrigin::farModelsHaveAnOriginOfTheirOwn()
{
    // Side 12: multiples of 16. The centre of 1006..1018 is 1012, 63.25 of them.
    QVERIFY(originFor(boxOf({1006, 0, 0}, {1018, 0, 0})) == glm::dvec3(1008, 0, 0));
    // A side that is a power of two is its own step; 520 = 32.5 steps goes to the even multiple.
    QVERIFY(originFor(boxOf({512, -3, 5}, {528, 3, 6})) == glm::dvec3(512, 0, 0));
    QVERIFY(originFor(boxOf({500000.1, 5000000.2, 3}, {500000.1, 5000000.2, 3})) ==
            glm::dvec3(500000.1, 5000000.2, 3)); // one point
    const Scene far = load(lattice({500000.5, 5000000.25, 100}));
    QVERIFY(far.mesh.origin == glm::dvec3(500000, 5000000, 96)); // 500006.5, 5000006.25 and 100.875 by 16
    QVERIFY(far.mesh.vertices[0].position == glm::vec4(0.5F, 0.25F, 4, 1));
    QVERIFY(worldPosition(far.mesh, 0) == glm::dvec4(500000.5, 5000000.25, 100, 1));
}

void TestOrigin::differencesAreExact()
{
    Random random = seededRandom();
    for (int i = 0; i < casesOfBuild(20000); ++i) {
        const double side = std::exp2(uniform(random, -20, 20));
        const glm::dvec3 corner = std::exp2(uniform(random, 4, 30)) * side *
                                  glm::dvec3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
        BoundingBox box;
        std::array<glm::dvec3, 4> points{};
        for (glm::dvec3& point : points) {
            point = corner + side * glm::dvec3(uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1));
            box.add(point);
        }
        const glm::dvec3 origin = originFor(box);
        if (origin == glm::dvec3(0))
            continue;
        for (const glm::dvec3& point : points)
            for (int k = 0; k < 3; ++k) {
                const double difference = point[k] - origin[k];
                // An exact difference gives both numbers back.
                QCOMPARE(difference + origin[k], point[k]);
                QCOMPARE(point[k] - difference, origin[k]);
                QVERIFY(std::abs(difference) <= 1.5 * box.longestSide());
            }
    }
}

void TestOrigin::remarks()
{
    QVERIFY(!remarkOnDistance(boxOf({9999, 0, 0}, {10000, 0, 0})));
    QVERIFY(!remarkOnDistance({}));
    const auto remark = remarkOnDistance(boxOf({8388608, 8388608, 0}, {8388624, 8388624, 0}));
    QVERIFY(remark);
    QCOMPARE(textOf(*remark),
             QStringLiteral("the model is 16 across and 1.18633e+07 from 0, where float32 keeps only steps of 1; "
                            "positions are read in double and drawn about the origin (8388608, 8388608, 0)"));
    const auto hopeless = remarkOnDistance(boxOf({1e15, 0, 0}, {1e15 + 8, 8, 8}));
    QVERIFY(hopeless);
    QVERIFY(textOf(*hopeless).contains(QStringLiteral("even double keeps only steps of 0.125")));
    const QString path = m_folder.write(QStringLiteral("far.obj"), lattice({5e5, 5e6, 0}));
    verifyRemark(loadScene(path).diagnostics, path + QStringLiteral(": "),
                 QStringLiteral("about the origin (500000, 5000000, 0)"));
    QVERIFY(loadScene(m_folder.write(QStringLiteral("near.obj"), lattice({1000, 0, 0}))).diagnostics.empty());
}

void TestOrigin::movedByAPowerOfTwoNothingChanges_data()
{
    QTest::addColumn<double>("distance");
    for (const int exponent : {8, 12, 20, 23, 30, 40, 48})
        QTest::addRow("2^%d", exponent) << std::ldexp(1.0, exponent);
}

/// The positions are the same float32 values, and so the picture is the same to the last bit.
void TestOrigin::movedByAPowerOfTwoNothingChanges()
{
    QFETCH(double, distance);
    const Scene here = load(lattice(glm::dvec3(0)));
    const Scene there = load(lattice({distance, -distance, 2 * distance}));
    QVERIFY(here.mesh.origin == glm::dvec3(0));
    QVERIFY(there.mesh.origin == glm::dvec3(distance, -distance, 2 * distance));
    for (std::size_t i = 0; i < here.mesh.vertices.size(); ++i)
        QVERIFY(there.mesh.vertices[i].position == here.mesh.vertices[i].position);
    for (const Shading shading : {Shading::RandomFlat, Shading::Phong, Shading::Texture}) {
        Settings settings = pictureSettings();
        settings.shading = shading;
        for (const Algorithm algorithm : algorithmsFor(here, settings)) {
            settings.algorithm = algorithm;
            QCOMPARE(difference(draw(here, settings), draw(there, settings)), QString());
        }
    }
}

void TestOrigin::movedAnywherePicturesAgree_data()
{
    QTest::addColumn<glm::dvec3>("move");
    QTest::addColumn<double>("scale");
    QTest::newRow("UTM") << glm::dvec3(500000.37, 5000000.91, 123.4) << 1.0;
    QTest::newRow("UTM, a kilometre") << glm::dvec3(499123.37, 5123000.91, 123.4) << 100.0;
    QTest::newRow("1e9") << glm::dvec3(1e9, -1e9, 1e9) << 1.0;
    QTest::newRow("1e15, as coarse as double is there") << glm::dvec3(1e15, 1e15, -1e15) << 1024.0;
    QTest::newRow("mixed") << glm::dvec3(1e9, 0, -3e5) << 0.01;
    QTest::newRow("just far enough") << glm::dvec3(100, 0, 0) << 1.0;
}

/// Corners may snap to the neighbouring step: a sample changes only where an edge passes within 1/128 pixel of it.
void TestOrigin::movedAnywherePicturesAgree()
{
    QFETCH(glm::dvec3, move);
    QFETCH(double, scale);
    const Scene here = load(lattice(glm::dvec3(0), scale));
    const Scene there = load(lattice(move, scale));
    QVERIFY(there.mesh.origin != glm::dvec3(0));
    const Settings settings = pictureSettings();
    const int differing = differingPixels(draw(here, settings), draw(there, settings));
    // 288 edges of some 16 pixels, each moved by at most a step of 1/256 pixel, pass over 40 centres at the very worst.
    QVERIFY2(differing <= 40, qPrintable(QString::number(differing)));
    const Processed a = process(here, settings);
    const Processed b = process(there, settings);
    QCOMPARE(a.triangles.size(), b.triangles.size());
    constexpr double kStep = 1.0 / 256;
    for (std::size_t i = 0; i < a.triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2 away = a.triangles[i].vertices[k].position - b.triangles[i].vertices[k].position;
            QVERIFY(std::abs(away.x) <= kStep && std::abs(away.y) <= kStep);
        }
}

void TestOrigin::eyeAndTargetInTheCoordinatesOfTheFile()
{
    const glm::dvec3 move(500000, 5000000, 100);
    const Scene here = load(lattice({0.0, 0.0, 4.0})); // the file below, its origin taken off
    const Scene there = load(lattice(move));
    Settings settings = pictureSettings();
    settings.view.fit = false;
    settings.view.eye = {4, 3, 30};
    settings.view.target = {6, 6, 4};
    const Frame expected = draw(here, settings);
    settings.view.eye += there.mesh.origin;
    settings.view.target += there.mesh.origin;
    QCOMPARE(difference(draw(there, settings), expected), QString());
    const Matrices m = cameraMatrices(there, settings);
    QVERIFY(m.eyeObject == glm::dvec3(4, 3, 30));
}

void TestOrigin::vertexOutsideTheFacesDoesNotCount()
{
    const Scene far = load("v 0 0 0\nv 1000000 0 0\nv 1000001 0 0\nv 1000000 1 0\nf 2 3 4\n");
    QVERIFY(far.mesh.origin == glm::dvec3(1000000, 0, 0));
    // One face near 0 and one far away: the box is as large as the distance, and nothing is gained by moving it.
    const Scene both = load("v 0 0 0\nv 1000000 0 0\nv 1000001 0 0\nv 1000000 1 0\nf 2 3 4\nf 1 2 4\n");
    QVERIFY(both.mesh.origin == glm::dvec3(0));
}

void TestOrigin::madeScenesHaveNone()
{
    for (const BuiltinScene& scene : builtinScenes())
        QVERIFY(loadScene(QStringLiteral("builtin:") + QLatin1String(scene.name)).scene->mesh.origin == glm::dvec3(0));
    LoadOptions peer;
    peer.peerMesh = true;
    const QString path = m_folder.write(QStringLiteral("peer.obj"), lattice({5e5, 5e6, 0}));
    const SceneLoad load = loadScene(path, peer);
    QVERIFY(load.scene && load.scene->mesh.origin == glm::dvec3(0));
    QCOMPARE(load.scene->mesh.vertices[0].position.x, 5e5F);
}

QTEST_GUILESS_MAIN(TestOrigin)
#include "test_origin.moc"
