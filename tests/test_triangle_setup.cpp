#include "core/pipeline/resolve.h"
// Triangle set-up: edge functions against wide integers, ownership, thresholds, bounds, and the largest triangles.
#include "core/pipeline/triangle_setup.h"
#include "core/rasterizers/edge_equation.h"
#include "core/rasterizers/edge_walking.h"
#include "tests/support.h"

#include <QTest>
#include <boost/multiprecision/cpp_int.hpp>

using namespace rasterlens;
using namespace rasterlens::test;
using boost::multiprecision::int128_t;
using Fixed = std::int64_t;

namespace
{

ScreenTriangle triangleOf(const std::array<glm::dvec2, 3>& samples)
{
    ScreenTriangle triangle{};
    for (std::size_t i = 0; i < 3; ++i)
        triangle.vertices[i] = {samples[i], 0.5, 1, {}};
    return triangle;
}

/// Twice the area of a, b, p in 1/256 samples squared; counter-clockwise with y up is positive.
int128_t edgeExactly(const Point<Fixed>& a, const Point<Fixed>& b, const Point<Fixed>& p)
{
    return int128_t(b.y - a.y) * (p.x - a.x) - int128_t(b.x - a.x) * (p.y - a.y);
}

std::array<glm::dvec2, 3> randomCorners(Random& random, int reach)
{
    std::array<glm::dvec2, 3> corners;
    for (glm::dvec2& c : corners)
        c = glm::dvec2(integer(random, -reach, reach), integer(random, -reach, reach)) / 256.0;
    return corners;
}

} // namespace

class TestTriangleSetup : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void edgeValuesAreExact();
    void topAndLeftEdgesOwnTheirPoints();
    void thresholdsFollowTheTieRule();
    void boundsHoldTheCentresOfTheExtent();
    void zeroAreaGivesNothing();
    void theLargestTrianglesStayWithin64Bits();
};

void TestTriangleSetup::edgeValuesAreExact()
{
    Random random = seededRandom();
    Rules rules;
    rules.width = rules.height = 512;
    for (int i = 0; i < 5000; ++i) {
        const ScreenTriangle triangle = triangleOf(randomCorners(random, i % 2 == 0 ? 512 * 256 : 1 << 27));
        const auto setup = setupTriangle<Fixed>(triangle, rules);
        if (!setup)
            continue;
        const auto& v = setup->vertices;
        QVERIFY(edgeExactly(v[0], v[1], v[2]) > 0);
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::dvec2 source = triangle.vertices[setup->source[k]].position;
            QCOMPARE(double(v[k].x), source.x * 256);
            QCOMPARE(double(v[k].y), source.y * 256);
            const auto centre = TriangleSetup<Fixed>::centre(integer(random, 0, 511), integer(random, 0, 511));
            QVERIFY(int128_t(setup->edges[k].at(centre)) == edgeExactly(v[k], v[(k + 1) % 3], centre));
        }
    }
}

void TestTriangleSetup::topAndLeftEdgesOwnTheirPoints()
{
    Random random = seededRandom();
    Rules rules;
    rules.width = rules.height = 16;
    int horizontal = 0;
    for (int i = 0; i < 20000; ++i) {
        auto corners = randomCorners(random, 8);
        for (glm::dvec2& c : corners)
            c *= 128; // so few values that many edges are horizontal
        const auto coarse = setupTriangle<Fixed>(triangleOf(corners), rules);
        const auto fine = setupTriangle<Fixed>(triangleOf(randomCorners(random, 2048)), rules);
        for (const auto& s : {coarse, fine}) {
            if (!s)
                continue;
            for (std::size_t k = 0; k < 3; ++k) {
                const Point<Fixed>& a = s->vertices[k];
                const Point<Fixed>& b = s->vertices[(k + 1) % 3];
                const Point<Fixed>& c = s->vertices[(k + 2) % 3];
                horizontal += a.y == b.y;
                // A left edge has the third corner to its right, a top edge below it. y runs down.
                const bool top = a.y == b.y && c.y > a.y;
                const bool left =
                    a.y != b.y && double(c.x) > double(a.x) + double(b.x - a.x) * double(c.y - a.y) / double(b.y - a.y);
                QCOMPARE(s->edges[k].owner(), top || left);
            }
        }
    }
    QVERIFY(horizontal > 100);
}

void TestTriangleSetup::thresholdsFollowTheTieRule()
{
    const ScreenTriangle triangle = triangleOf({glm::dvec2(1, 1), glm::dvec2(1, 9), glm::dvec2(9, 1)});
    Scene scene;
    const auto thresholds = [&](TieRule tie) {
        Settings settings;
        settings.size = {16, 16};
        settings.tieRule = tie;
        const auto setup = setupTriangle<Fixed>(triangle, resolve(settings, scene).rules);
        std::array<Fixed, 3> result{};
        for (std::size_t k = 0; k < 3; ++k)
            result[k] = setup->edges[k].threshold;
        return result;
    };
    // AB is the left edge, BC the slanted right one, CA the top one.
    QCOMPARE(thresholds(TieRule::TopLeft), (std::array<Fixed, 3>{0, 1, 0}));
    QCOMPARE(thresholds(TieRule::Inclusive), (std::array<Fixed, 3>{0, 0, 0}));
    QCOMPARE(thresholds(TieRule::Exclusive), (std::array<Fixed, 3>{1, 1, 1}));
}

void TestTriangleSetup::boundsHoldTheCentresOfTheExtent()
{
    Random random = seededRandom();
    Rules rules;
    for (int i = 0; i < 3000; ++i) {
        rules.width = integer(random, 1, 24);
        rules.height = integer(random, 1, 24);
        const auto corners = randomCorners(random, 40 * 256);
        const auto setup = setupTriangle<Fixed>(triangleOf(corners), rules);
        const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
        const auto [top, bottom] = std::minmax({corners[0].y, corners[1].y, corners[2].y});
        for (int y = 0; y < rules.height; ++y)
            for (int x = 0; x < rules.width; ++x) {
                const bool inExtent = x + 0.5 >= left && x + 0.5 <= right && y + 0.5 >= top && y + 0.5 <= bottom;
                const PixelRect box = setup ? setup->bounds : PixelRect{};
                const bool inBounds = x >= box.x && x < box.x + box.width && y >= box.y && y < box.y + box.height;
                QVERIFY(setup ? inBounds == inExtent : !inExtent || twiceArea(corners[0], corners[1], corners[2]) == 0);
            }
    }
}

void TestTriangleSetup::zeroAreaGivesNothing()
{
    Rules rules;
    rules.width = rules.height = 16;
    const ScreenTriangle line = triangleOf({glm::dvec2(1, 1), glm::dvec2(3, 3), glm::dvec2(9, 9)});
    const ScreenTriangle point = triangleOf({glm::dvec2(1.5, 1.5), glm::dvec2(1.5, 1.5), glm::dvec2(1.5, 1.5)});
    for (const ScreenTriangle& triangle : {line, point}) {
        QVERIFY(!setupTriangle<Fixed>(triangle, rules));
        QVERIFY(!setupTriangle<float>(triangle, rules));
        QVERIFY(!setupTriangle<double>(triangle, rules));
    }
}

/// Vertices held at 2^19 pixels with 4 x 4 samples: the sanitizer would report an overflow.
void TestTriangleSetup::theLargestTrianglesStayWithin64Bits()
{
    const double far = double(1 << 19) * 4;
    Rules rules;
    rules.width = rules.height = kMaxViewport;
    rules.sampleGrid = 4;
    for (const auto& corners :
         {std::array{glm::dvec2(-far, -far), glm::dvec2(-far, far), glm::dvec2(far, far)},
          std::array{glm::dvec2(far, -far), glm::dvec2(-far, far - 1 / 256.0), glm::dvec2(far, far)},
          std::array{glm::dvec2(-far, far), glm::dvec2(far, -far), glm::dvec2(-far, -far)}}) {
        const ScreenTriangle triangle = triangleOf(corners);
        auto setup = setupTriangle<Fixed>(triangle, rules);
        QVERIFY(setup);
        const auto& v = setup->vertices;
        for (const int y : {0, rules.rows() - 1})
            for (const int x : {0, rules.columns() - 1})
                for (std::size_t k = 0; k < 3; ++k) {
                    const auto centre = TriangleSetup<Fixed>::centre(x, y);
                    QVERIFY(int128_t(setup->edges[k].at(centre)) == edgeExactly(v[k], v[(k + 1) % 3], centre));
                }
        // The last rows of the target, by all algorithms.
        setup->bounds = {rules.columns() - 8, rules.rows() - 8, 8, 8};
        NullObserver observer;
        std::array<int, 4> counts{};
        std::size_t way = 0;
        for (const Stepping stepping : {Stepping::Direct, Stepping::Incremental}) {
            rules.stepping = stepping;
            auto count = [&](auto... sample) { counts[way] += sizeof...(sample) > 0; };
            EdgeEquation::cover(*setup, triangle, rules, count, observer);
            ++way;
            EdgeWalking::cover(*setup, triangle, rules, count, observer);
            ++way;
        }
        QCOMPARE(counts, (std::array{counts[0], counts[0], counts[0], counts[0]}));
    }
}

QTEST_APPLESS_MAIN(TestTriangleSetup)
#include "test_triangle_setup.moc"
