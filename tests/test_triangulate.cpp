// Polygons become triangles that cover them exactly.
#include "core/scene/orientation.h"
#include "core/scene/triangulate.h"
#include "tests/seed.h"

#include <QTest>

#include <cmath>
#include <random>

using namespace rasterlens;

namespace
{

/// The area of a triangle whose corners lie in z = 0, positive if counter-clockwise.
double signedArea(const std::vector<glm::vec3>& points, const CornerTriple& t)
{
    const glm::dvec2 a(points[t[0]]);
    const glm::dvec2 b(points[t[1]]);
    const glm::dvec2 c(points[t[2]]);
    return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

/// The triangles have the polygon's winding and do not overlap, for their areas add up to the polygon's.
void verifyTriangulation(const std::vector<glm::vec3>& polygon)
{
    std::vector<CornerTriple> triangles;
    QVERIFY(triangulate(polygon, triangles) == Cut::Exact);
    QCOMPARE(triangles.size(), polygon.size() - 2);
    double expected = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 a(polygon[i]);
        const glm::dvec2 b(polygon[(i + 1) % polygon.size()]);
        expected += 0.5 * (a.x * b.y - a.y * b.x);
    }
    double sum = 0;
    for (const CornerTriple& triangle : triangles)
        sum += std::abs(signedArea(polygon, triangle));
    QVERIFY2(std::abs(sum - std::abs(expected)) < 1e-5 * sum, qPrintable(QString::number(sum - std::abs(expected))));
}

} // namespace

class TestTriangulate : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void concavePolygons();
    void randomStars();
    void tiltedPolygon();
    void withoutArea();
    void outlinesOfManyCorners_data();
    void outlinesOfManyCorners();
    void holesByBridges();
    void crossingOutlinesAreTold();
    void orientationIsExact();
};

void TestTriangulate::concavePolygons()
{
    verifyTriangulation({{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, 1, 0}}); // dart
    verifyTriangulation({{2, 1, 0}, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}}); // reflex first
    verifyTriangulation({{4, 4, 0}, {4, 0, 0}, {0, 0, 0}, {2, 1, 0}}); // clockwise
    verifyTriangulation({{0, 0, 0}, {3, 0, 0}, {3, 1, 0}, {1, 1, 0}, {1, 2, 0}, {3, 2, 0}, {3, 3, 0}, {0, 3, 0}}); // C
    verifyTriangulation({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {1, 1, 0}, {0, 1, 0}}); // L, collinear
}

void TestTriangulate::randomStars()
{
    const unsigned seed = test::seedOfRun();
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> radius(0.1F, 1);
    for (int i = 0; i < 300; ++i) { // stars: rays in order, any length
        const int count = 4 + static_cast<int>(random() % 60);
        std::vector<glm::vec3> star;
        for (int k = 0; k < count; ++k) {
            const float angle = 6.2831853F * static_cast<float>(k) / static_cast<float>(count);
            star.push_back(radius(random) * glm::vec3(std::cos(angle), std::sin(angle), 0));
        }
        verifyTriangulation(star);
    }
}

/// A C that lies in no coordinate plane, far from the origin.
void TestTriangulate::tiltedPolygon()
{
    std::vector<glm::vec3> polygon;
    for (const glm::vec2 p : {glm::vec2(0, 0), {3, 0}, {3, 1}, {1, 1}, {1, 2}, {3, 2}, {3, 3}, {0, 3}})
        polygon.emplace_back(100 + p.x, 200 + p.y, 50 - 2 * p.x + p.y);
    std::vector<CornerTriple> triangles;
    triangulate(polygon, triangles);
    QCOMPARE(triangles.size(), std::size_t{6});
    double area = 0;
    for (const CornerTriple& t : triangles) {
        QVERIFY(signedArea(polygon, t) >= 0);
        area += signedArea(polygon, t);
    }
    QCOMPARE(area, 7.0);
}

void TestTriangulate::withoutArea()
{
    const std::vector<glm::vec3> shapes[] = {{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}},
                                             {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 0, 0}},
                                             {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}}};
    for (const std::vector<glm::vec3>& shape : shapes) {
        std::vector<CornerTriple> triangles;
        triangulate(shape, triangles);
        QCOMPARE(triangles.size(), shape.size() - 2);
    }
}

void TestTriangulate::outlinesOfManyCorners_data()
{
    QTest::addColumn<int>("shape");
    QTest::newRow("coast") << 0;
    QTest::newRow("star") << 1;
    QTest::newRow("comb") << 2;
    QTest::newRow("spiral") << 3;
}

/// A hundred thousand corners: no overlap, nothing given up.
void TestTriangulate::outlinesOfManyCorners()
{
    QFETCH(int, shape);
    constexpr int kCorners = 100'000;
    constexpr float kTurn = 6.2831853F;
    std::mt19937 random(test::seedOfRun());
    std::uniform_real_distribution<float> jitter(0.97F, 1);
    std::vector<glm::vec3> outline;
    const auto polar = [&](float radius, float angle) {
        outline.push_back(radius * glm::vec3(std::cos(angle), std::sin(angle), 0));
    };
    for (int i = 0; i < kCorners; ++i) {
        const float part = static_cast<float>(i) / kCorners;
        const float half = static_cast<float>(i % (kCorners / 2)) / (kCorners / 2);
        switch (shape) {
        case 0: polar((1 + 0.3F * std::sin(29 * part * kTurn)) * jitter(random), part * kTurn); break;
        case 1: polar(i % 2 == 0 ? 1.0F : 0.7F, part * kTurn); break;
        case 2: outline.emplace_back(static_cast<float>(-i), i % 2 == 0 ? 0.0F : 40'000 * jitter(random), 0.0F); break;
        default: {
            const float inwards = i < kCorners / 2 ? half : 1 - half;
            polar(0.5F + 6 * inwards - (i < kCorners / 2 ? 0 : 0.3F), 6 * kTurn * inwards);
        }
        }
    }
    if (shape == 2) {
        outline.emplace_back(-kCorners, -5.0F, 0.0F);
        outline.emplace_back(0.0F, -5.0F, 0.0F);
    }
    verifyTriangulation(outline);
}

void TestTriangulate::holesByBridges()
{
    verifyTriangulation(
        {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}});
    verifyTriangulation(
        {{0, 0, 0}, {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}});
}

void TestTriangulate::crossingOutlinesAreTold()
{
    const std::vector<glm::vec3> shapes[] = {
        {{0, 0, 0}, {2, 2, 0}, {2, 0, 0}, {0, 2, 0}},                         // bow tie
        {{0, 3, 0}, {2, -3, 0}, {-3, 1, 0}, {3, 1, 0}, {-2, -3, 0}},          // pentagram
        {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {2, -1, 0}, {1, 5, 0}, {0, 4, 0}}}; // a spike through the bottom
    for (const std::vector<glm::vec3>& shape : shapes) {
        std::vector<CornerTriple> triangles;
        QVERIFY(triangulate(shape, triangles) == Cut::Overlaps);
        QCOMPARE(triangles.size(), shape.size() - 2);
    }
}

/// Points on a line at places where the plain formula rounds to the wrong side.
void TestTriangulate::orientationIsExact()
{
    constexpr double kStep = 1.0 / (1LL << 53);
    const glm::dvec2 b(12, 12);
    const glm::dvec2 c(24, 24);
    for (int i = 0; i < 64; ++i)
        for (int k = 0; k < 64; ++k) {
            const glm::dvec2 a(0.5 + i * kStep, 0.5 + k * kStep);
            const double area = orientation(a, b, c);
            QVERIFY2(a.x == a.y ? area == 0 : (area > 0) == (a.x < a.y),
                     qPrintable(QStringLiteral("%1 %2").arg(i).arg(k)));
        }
}

QTEST_APPLESS_MAIN(TestTriangulate)
#include "test_triangulate.moc"
