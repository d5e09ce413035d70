// Clipping: every mode, the same cut for neighbours, scaling, convexity, and the region against rational arithmetic.
#include "core/pipeline/clipping.h"
#include "tests/support.h"

#include <QTest>
#include <boost/multiprecision/cpp_int.hpp>

#include <set>
#include <tuple>

using namespace rasterlens;
using namespace rasterlens::test;
using Rational = boost::multiprecision::cpp_rational;

namespace
{

constexpr std::array kCutting{Clipping::Frustum, Clipping::FrustumW, Clipping::GuardBand, Clipping::CohenSutherland};

Rules rulesOf(Clipping mode, ClipZ clipZ = ClipZ::Gl)
{
    Rules rules;
    rules.clipping = mode;
    rules.clipZ = clipZ;
    rules.width = 256;
    rules.height = 128;
    rules.varyingCount = 3;
    return rules;
}

ClipTriangle triangleOf(const std::array<glm::dvec4, 3>& positions)
{
    ClipTriangle triangle{};
    for (std::size_t i = 0; i < 3; ++i) {
        triangle.vertices[i].positionClip = positions[i];
        triangle.vertices[i].varyings[i] = 1;
    }
    return triangle;
}

/// What geometry does with a face, up to the divide.
ClipPolygon clipped(const ClipTriangle& triangle, const Rules& rules)
{
    const ClipVolume volume = clipVolume(rules);
    std::array<Outcode, 3> codes{};
    for (std::size_t i = 0; i < 3; ++i)
        codes[i] = outcode(triangle.vertices[i].positionClip, volume);
    Clipper clipper(triangle, volume, codes[0].cut | codes[1].cut | codes[2].cut, rules);
    NullObserver observer;
    switch (clipVerdict(rules.clipping, codes[0], codes[1], codes[2])) {
    case ClipVerdict::Reject: return {.vertices = {}, .corners = {}, .distances = {}, .count = 0};
    case ClipVerdict::Keep: break;
    case ClipVerdict::Cut: clipper.clip(observer); break;
    }
    return clipper.polygon();
}

glm::dvec4 randomPosition(Random& random)
{
    const double w = uniform(random, -0.5, 2);
    const auto coordinate = [&] { return double(static_cast<float>(uniform(random, -2.5, 2.5))); };
    return {coordinate(), coordinate(), coordinate(), double(static_cast<float>(w))};
}

std::array<glm::dvec4, 3> randomPositions(Random& random)
{
    return {randomPosition(random), randomPosition(random), randomPosition(random)};
}

double crossAt(const ClipPolygon& polygon, std::size_t i)
{
    const std::size_t n = static_cast<std::size_t>(polygon.count);
    const auto ndc = [&](std::size_t k) {
        const glm::dvec4& p = polygon.vertices[k % n].positionClip;
        return glm::dvec2(p) / p.w;
    };
    const glm::dvec2 u = ndc(i + 1) - ndc(i);
    const glm::dvec2 v = ndc(i + 2) - ndc(i + 1);
    return u.x * v.y - u.y * v.x;
}

double areaOf(const ClipPolygon& polygon)
{
    double area = 0;
    const auto ndc = [&](int k) {
        const glm::dvec4& p = polygon.vertices[static_cast<std::size_t>(k % polygon.count)].positionClip;
        return glm::dvec2(p) / p.w;
    };
    for (int i = 0; i < polygon.count; ++i)
        area += (ndc(i).x * ndc(i + 1).y - ndc(i).y * ndc(i + 1).x) / 2;
    return area;
}

using Exact = std::array<Rational, 4>;

/// Sutherland-Hodgman in rational numbers with inside = sum of normal times position >= 0; then the area in NDC.
double exactArea(const std::array<glm::dvec4, 3>& positions, const std::vector<glm::dvec4>& planes)
{
    std::vector<Exact> polygon;
    for (const glm::dvec4& p : positions)
        polygon.push_back({Rational(p.x), Rational(p.y), Rational(p.z), Rational(p.w)});
    for (const glm::dvec4& plane : planes) {
        const auto distance = [&](const Exact& p) {
            Rational sum = 0;
            for (int k = 0; k < 4; ++k)
                sum += Rational(plane[k]) * p[static_cast<std::size_t>(k)];
            return sum;
        };
        std::vector<Exact> next;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const Exact& a = polygon[i];
            const Exact& b = polygon[(i + 1) % polygon.size()];
            const Rational da = distance(a);
            const Rational db = distance(b);
            if (da >= 0)
                next.push_back(a);
            if ((da >= 0) != (db >= 0)) {
                Exact cut;
                for (std::size_t k = 0; k < 4; ++k)
                    cut[k] = Rational((a[k] * db - b[k] * da) / (db - da));
                next.push_back(cut);
            }
        }
        polygon = next;
    }
    Rational area = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Exact& a = polygon[i];
        const Exact& b = polygon[(i + 1) % polygon.size()];
        if (a[3] <= 0 || b[3] <= 0)
            return 0;
        area += (a[0] * b[1] - a[1] * b[0]) / (a[3] * b[3]) / 2;
    }
    return static_cast<double>(area);
}

std::vector<glm::dvec4> planesOf(double gx, double gy, ClipZ clipZ)
{
    return {{-1, 0, 0, gx}, {1, 0, 0, gx}, {0, -1, 0, gy}, {0, 1, 0, gy}, {0, 0, 1, clipZ == ClipZ::Gl ? 1.0 : 0.0},
            {0, 0, -1, 1}};
}

using Bits = std::tuple<double, double, double, double>;

/// The vertices on the edge AB.
std::set<Bits> onFirstEdge(const ClipPolygon& polygon)
{
    std::set<Bits> points;
    for (std::size_t i = 0; i < static_cast<std::size_t>(polygon.count); ++i) {
        const glm::dvec4& p = polygon.vertices[i].positionClip;
        if (polygon.corners[i].arriving == kEdgeAB || polygon.corners[i].leaving == kEdgeAB)
            points.insert({p.x, p.y, p.z, p.w});
    }
    return points;
}

/// Coordinates from 0, small multiples of 1/4 and the largest floats.
glm::dvec4 hardPosition(Random& random)
{
    const double largest = double(static_cast<float>(std::pow(10, integer(random, 0, 38))));
    glm::dvec4 p;
    for (int k = 0; k < 4; ++k) {
        const double small = integer(random, 0, 16) / 4.0;
        p[k] = (integer(random, 0, 3) == 0 ? largest : small) * (integer(random, 0, 1) == 0 ? 1 : -1);
    }
    return p;
}

} // namespace

class TestClipping : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void insideComesBackBitForBit();
    void pointsOnThePlanesAreInside();
    void modesThatRejectWholeFaces();
    void neighboursGetTheSameCut();
    void scalingChangesNothing();
    void polygonsAreConvexAndKeepTheirWinding();
    void theRegionIsTheExactOne_data();
    void theRegionIsTheExactOne();
    void nineVertices();
    void nothingBehindTheEyeIsSeen();
    void cornerAtTheEyeDrawsNothing();
    void guardBandKeepsVerticesNear();
    void rowsOfPointsOnPlanesStayBounded();
    void longEdgesAreCutExactly();
};

void TestClipping::insideComesBackBitForBit()
{
    Random random = seededRandom();
    for (const Clipping mode : {Clipping::Frustum, Clipping::FrustumW, Clipping::GuardBand, Clipping::AnyVertexInside,
                                Clipping::NearFarReject, Clipping::CohenSutherland, Clipping::None})
        for (int i = 0; i < 200; ++i) {
            std::array<glm::dvec4, 3> p;
            for (glm::dvec4& v : p) {
                const double w = uniform(random, 0.01, 10);
                v = {uniform(random, -w, w), uniform(random, -w, w), uniform(random, -w, w), w};
            }
            const ClipPolygon polygon = clipped(triangleOf(p), rulesOf(mode));
            QCOMPARE(polygon.count, 3);
            for (std::size_t k = 0; k < 3; ++k)
                QVERIFY(polygon.vertices[k].positionClip == p[k]);
        }
}

void TestClipping::pointsOnThePlanesAreInside()
{
    const std::array<glm::dvec4, 3> corners{glm::dvec4(-2, -2, -2, 2), glm::dvec4(3, -3, 3, 3), glm::dvec4(0, 5, 5, 5)};
    for (const Clipping mode : kCutting) {
        const ClipVolume volume = clipVolume(rulesOf(mode));
        for (const glm::dvec4& p : corners) {
            QCOMPARE(outcode(p, volume).view, 0U);
            QCOMPARE(outcode(p, volume).cut, 0U);
        }
        QCOMPARE(clipped(triangleOf(corners), rulesOf(mode)).count, 3);
    }
    const ClipVolume d3d = clipVolume(rulesOf(Clipping::Frustum, ClipZ::D3d));
    QCOMPARE(outcode({0, 0, 0, 1}, d3d).view, 0U);
    QCOMPARE(outcode({0, 0, -0x1p-140, 1}, d3d).view, planeBit(ClipPlane::Near));
    const ClipVolume w = clipVolume(rulesOf(Clipping::FrustumW));
    QCOMPARE(outcode({0, 0, 0, 1e-5}, w).view, 0U);
    QCOMPARE(outcode({0, 0, 0, 0.99e-5}, w).view, planeBit(ClipPlane::W));
}

void TestClipping::modesThatRejectWholeFaces()
{
    const ClipTriangle covering =
        triangleOf({glm::dvec4(-9, -9, 0, 1), glm::dvec4(9, -9, 0, 1), glm::dvec4(0, 9, 0, 1)});
    const ClipTriangle oneIn = triangleOf({glm::dvec4(0, 0, 0, 1), glm::dvec4(9, 0, 0, 1), glm::dvec4(0, 9, 0, 1)});
    const ClipTriangle oneTooNear =
        triangleOf({glm::dvec4(0, 0, -2, 1), glm::dvec4(0.5, 0, 0, 1), glm::dvec4(0, 0.5, 0, 1)});
    QCOMPARE(clipped(covering, rulesOf(Clipping::AnyVertexInside)).count, 0);
    QCOMPARE(clipped(oneIn, rulesOf(Clipping::AnyVertexInside)).count, 3);
    QCOMPARE(clipped(covering, rulesOf(Clipping::NearFarReject)).count, 3);
    QCOMPARE(clipped(oneTooNear, rulesOf(Clipping::NearFarReject)).count, 0);
    QCOMPARE(clipped(oneTooNear, rulesOf(Clipping::None)).count, 3);
    QCOMPARE(clipped(covering, rulesOf(Clipping::Frustum)).count, 4);
    QCOMPARE(clipped(covering, rulesOf(Clipping::CohenSutherland)).count, 4);
    QCOMPARE(clipped(covering, rulesOf(Clipping::GuardBand)).count, 3);
    // All outside one plane: nothing is left, whatever is done to find out.
    const ClipTriangle left = triangleOf({glm::dvec4(-2, 0, 0, 1), glm::dvec4(-3, 9, 0, 1), glm::dvec4(-2, -9, 0, 1)});
    for (const Clipping mode : kCutting)
        QCOMPARE(clipped(left, rulesOf(mode)).count, 0);
}

void TestClipping::neighboursGetTheSameCut()
{
    Random random = seededRandom();
    int cut = 0;
    for (int i = 0; i < 20000; ++i) {
        const auto position = [&] { return i % 2 == 0 ? randomPosition(random) : hardPosition(random); };
        const glm::dvec4 a = position();
        const glm::dvec4 b = position();
        const ClipTriangle one = triangleOf({a, b, position()});
        const ClipTriangle other = triangleOf({b, a, position()});
        for (const Clipping mode : {Clipping::Frustum, Clipping::FrustumW, Clipping::GuardBand}) {
            const ClipPolygon p = clipped(one, rulesOf(mode));
            const ClipPolygon q = clipped(other, rulesOf(mode));
            if (p.count == 0 || q.count == 0)
                continue;
            QVERIFY(onFirstEdge(p) == onFirstEdge(q));
            cut += onFirstEdge(p).size() == 2 && p.count + q.count > 6;
        }
    }
    QVERIFY(cut > 3000);
}

void TestClipping::scalingChangesNothing()
{
    Random random = seededRandom();
    for (int i = 0; i < 5000; ++i) {
        const auto positions = randomPositions(random);
        const double factor = std::ldexp(1, integer(random, -100, 100));
        auto scaled = positions;
        for (glm::dvec4& p : scaled)
            p *= factor;
        for (const Clipping mode : {Clipping::Frustum, Clipping::GuardBand, Clipping::CohenSutherland}) {
            const ClipPolygon p = clipped(triangleOf(positions), rulesOf(mode));
            const ClipPolygon q = clipped(triangleOf(scaled), rulesOf(mode));
            QCOMPARE(q.count, p.count);
            for (std::size_t k = 0; k < static_cast<std::size_t>(p.count); ++k) {
                QVERIFY2(q.vertices[k].positionClip == p.vertices[k].positionClip * factor,
                         qPrintable(QStringLiteral("mode %1, vertex %2").arg(int(mode)).arg(k)));
                for (std::size_t v = 0; v < 3; ++v)
                    QCOMPARE(q.vertices[k].varyings[v], p.vertices[k].varyings[v]);
            }
        }
    }
}

void TestClipping::polygonsAreConvexAndKeepTheirWinding()
{
    Random random = seededRandom();
    for (int i = 0; i < 20000; ++i) {
        const auto positions = randomPositions(random);
        const auto xyw = [&](std::size_t k) { return glm::dvec3(positions[k].x, positions[k].y, positions[k].w); };
        const double facing = glm::dot(xyw(0), glm::cross(xyw(1), xyw(2)));
        for (const Clipping mode : kCutting) {
            const ClipPolygon polygon = clipped(triangleOf(positions), rulesOf(mode));
            if (polygon.count == 0 || std::abs(areaOf(polygon)) < 1e-9)
                continue;
            QVERIFY(polygon.count >= 3 && polygon.count <= 10);
            QVERIFY2((areaOf(polygon) > 0) == (facing > 0),
                     qPrintable(QStringLiteral("mode %1: %2, %3").arg(int(mode)).arg(areaOf(polygon)).arg(facing)));
            for (std::size_t k = 0; k < static_cast<std::size_t>(polygon.count); ++k) {
                QVERIFY(polygon.vertices[k].positionClip.w > 0);
                // The guard band is some 500 units wide: rounding grows with the square of that.
                const double rounding = mode == Clipping::GuardBand ? 1e-8 : 1e-12;
                QVERIFY(crossAt(polygon, k) * (facing > 0 ? 1 : -1) > -rounding);
            }
        }
    }
}

void TestClipping::theRegionIsTheExactOne_data()
{
    QTest::addColumn<int>("mode");
    QTest::addColumn<int>("clipZ");
    for (const Clipping mode : {Clipping::Frustum, Clipping::GuardBand, Clipping::CohenSutherland})
        for (const int clipZ : {0, 1})
            QTest::addRow("mode %d, z range %d", int(mode), clipZ) << int(mode) << clipZ;
}

void TestClipping::theRegionIsTheExactOne()
{
    QFETCH(int, mode);
    QFETCH(int, clipZ);
    Random random = seededRandom();
    const Rules rules = rulesOf(Clipping(mode), ClipZ(clipZ));
    const bool guardBand = rules.clipping == Clipping::GuardBand;
    const double gx = guardBand ? 2 * 32768.0 / rules.width - 1 : 1;
    const double gy = guardBand ? 2 * 32768.0 / rules.height - 1 : 1;
    int drawn = 0;
    for (int i = 0; i < 150; ++i) {
        std::array<glm::dvec4, 3> positions;
        for (glm::dvec4& p : positions)
            p = glm::dvec4(integer(random, -24, 24), integer(random, -24, 24), integer(random, -24, 24),
                           integer(random, -2, 16)) /
                8.0;
        const ClipPolygon polygon = clipped(triangleOf(positions), rules);
        // A face outside the view is dropped also where the guard band would keep it.
        if (guardBand && polygon.count == 0) {
            QVERIFY(std::abs(exactArea(positions, planesOf(1, 1, rules.clipZ))) < 1e-12);
            continue;
        }
        const double expected = exactArea(positions, planesOf(gx, gy, rules.clipZ));
        const double found = polygon.count > 0 && expected != 0 ? areaOf(polygon) : 0;
        drawn += expected != 0;
        QVERIFY2(std::abs(found - expected) <= 1e-12 * std::max(1.0, gx * gy),
                 qPrintable(QStringLiteral("%1: %2, not %3").arg(i).arg(found).arg(expected)));
    }
    QVERIFY(drawn > 20);
}

/// The plane x + y + z = 0 cuts a hexagon out of the cube; the triangle cuts off every other corner of that.
void TestClipping::nineVertices()
{
    const glm::dvec3 u = glm::normalize(glm::dvec3(1, -1, 0));
    const glm::dvec3 v = glm::normalize(glm::dvec3(1, 1, -2));
    std::array<glm::dvec4, 3> positions;
    for (std::size_t k = 0; k < 3; ++k) {
        const double angle = (60 + 120 * double(k)) * M_PI / 180;
        positions[k] = glm::dvec4(2.6 * (std::cos(angle) * u + std::sin(angle) * v), 1);
    }
    for (const Clipping mode : {Clipping::Frustum, Clipping::FrustumW})
        QCOMPARE(clipped(triangleOf(positions), rulesOf(mode)).count, 9);
    QCOMPARE(clipped(triangleOf(positions), rulesOf(Clipping::CohenSutherland)).count, 9);
}

void TestClipping::nothingBehindTheEyeIsSeen()
{
    Random random = seededRandom();
    for (int i = 0; i < 2000; ++i) {
        auto positions = randomPositions(random);
        for (glm::dvec4& p : positions)
            p.w = i % 2 == 0 ? 0 : -std::abs(p.w);
        const Scene scene = soup({glm::vec4(positions[0]), glm::vec4(positions[1]), glm::vec4(positions[2])});
        for (const Clipping mode : kCutting) {
            Settings settings = plainSettings({256, 128});
            settings.clipping = mode;
            QVERIFY(process(scene, settings).triangles.empty());
        }
    }
}

/// x = y = z = w = 0 satisfies every plane but is nowhere on the screen; det[x y w] is 0 then.
void TestClipping::cornerAtTheEyeDrawsNothing()
{
    const Scene scene = soup({{0, 0, 0, 0}, {0.9F, 0.1F, 0, 1}, {0.1F, 0.9F, 0, 1}});
    const Scene crossing = soup({{0, 0, 0, 0}, {5, 0.1F, 0, 1}, {0.1F, 5, 0, 1}});
    for (const Clipping mode : kCutting) {
        Settings settings = plainSettings({32, 32});
        settings.clipping = mode;
        for (const Scene* s : {&scene, &crossing}) {
            const Processed processed = process(*s, settings);
            QCOMPARE(processed.triangles.size(), std::size_t(0));
        }
    }
}

void TestClipping::guardBandKeepsVerticesNear()
{
    Random random = seededRandom();
    double farthest = 0;
    for (int i = 0; i < 300; ++i) {
        std::vector<glm::vec4> positions;
        for (int k = 0; k < 30; ++k) {
            const float reach = std::exp2(static_cast<float>(uniform(random, 0, 40)));
            positions.emplace_back(uniform(random, -1, 1) * reach, uniform(random, -1, 1) * reach,
                                   uniform(random, -1, 1), uniform(random, -1, 2));
        }
        const Scene scene = soup(positions);
        Settings settings = plainSettings({integer(random, 1, kMaxViewport), integer(random, 1, kMaxViewport)});
        settings.clipping = Clipping::GuardBand;
        for (const ScreenTriangle& triangle : process(scene, settings).triangles)
            for (const ScreenVertex& v : triangle.vertices)
                farthest = std::max({farthest, std::abs(v.position.x), std::abs(v.position.y)});
    }
    QVERIFY(farthest <= 32768);
    QVERIFY(farthest > 32000);
}

/// Corners and edges that lie on planes or a rounding beside them must not make the polygon grow without end.
void TestClipping::rowsOfPointsOnPlanesStayBounded()
{
    Random random = seededRandom();
    const std::array<double, 10> values{-2, -1, -1 - 0x1p-23, -1 + 0x1p-24, -0.0, 0, 1 - 0x1p-24, 1, 1 + 0x1p-23, 2};
    const auto value = [&] { return values[static_cast<std::size_t>(integer(random, 0, 9))]; };
    for (int i = 0; i < 10000; ++i) {
        std::array<glm::dvec4, 3> positions;
        for (glm::dvec4& p : positions)
            p = {value(), value(), value(), value()};
        for (const Clipping mode : {Clipping::Frustum, Clipping::FrustumW, Clipping::GuardBand}) {
            const ClipPolygon polygon = clipped(triangleOf(positions), rulesOf(mode));
            QVERIFY(polygon.count == 0 || (polygon.count >= 3 && polygon.count <= 10));
            for (const ClipVertex& v : polygon.span())
                QVERIFY(v.positionClip.w >= 0);
        }
    }
}

void TestClipping::longEdgesAreCutExactly()
{
    Random random = seededRandom();
    for (int i = 0; i < 300; ++i) {
        const double reach = std::exp2(uniform(random, 1, 125));
        const auto anywhere = [&] { return double(static_cast<float>(uniform(random, -1, 1))); };
        const glm::dvec4 inside(anywhere(), anywhere(), anywhere(), 1);
        const glm::dvec4 outside(double(static_cast<float>(reach)), anywhere() * reach, anywhere() * reach, 1);
        const ClipTriangle triangle = triangleOf({inside, outside, inside});
        const Rules rules = rulesOf(Clipping::Frustum);
        const ClipVolume volume = clipVolume(rules);
        Clipper clipper(triangle, volume, planeBit(ClipPlane::Right), rules);
        NullObserver observer;
        clipper.clip(observer);
        QCOMPARE(clipper.polygon().count, 4);
        const Rational t = (1 - Rational(inside.x)) / (Rational(outside.x) - Rational(inside.x));
        for (int k = 0; k < 4; ++k) {
            const double expected =
                static_cast<double>(Rational(Rational(inside[k]) + t * (Rational(outside[k]) - Rational(inside[k]))));
            QVERIFY(std::abs(clipper.polygon().vertices[1].positionClip[k] - expected) <= 0x1p-31);
        }
    }
}

QTEST_APPLESS_MAIN(TestClipping)
#include "test_clipping.moc"
