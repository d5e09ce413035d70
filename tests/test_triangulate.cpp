// Polygons become triangles that cover them exactly.
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
    triangulate(polygon, triangles);
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

QTEST_APPLESS_MAIN(TestTriangulate)
#include "test_triangulate.moc"
