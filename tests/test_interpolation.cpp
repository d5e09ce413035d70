// Interpolation: depth planes that are exact in any order of addition, and weights against rational arithmetic.
#include "core/pipeline/depth_test.h"
#include "core/pipeline/gouraud_batch.h"
#include "core/pipeline/shading.h"
#include "core/rasterizers/edge_walking.h"
#include "tests/support.h"

#include <QTest>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <limits>

using namespace rasterlens;
using namespace rasterlens::test;
using Rational = boost::multiprecision::cpp_rational;

namespace
{

struct Sample {
    int x;
    int y;
};

/// A triangle whose corners lie on the fixed-point grid within and around a target of this size.
ScreenTriangle randomTriangle(Random& random, int size, bool needle)
{
    ScreenTriangle triangle{};
    const auto place = [&](int low, int high) { return integer(random, low * 256, high * 256) / 256.0; };
    for (ScreenVertex& v : triangle.vertices) {
        v.position = {place(-size / 4, size * 5 / 4), place(-size / 4, size * 5 / 4)};
        v.depth = uniform(random, 0, 1);
        v.invW = std::exp2(uniform(random, -6, 6));
        for (std::size_t k = 0; k < 3; ++k)
            v.varyings[k] = static_cast<float>(uniform(random, -1, 1));
    }
    if (needle) {
        const glm::dvec2 along = triangle.vertices[1].position - triangle.vertices[0].position;
        const glm::dvec2 near = triangle.vertices[0].position + uniform(random, 0, 1) * along;
        triangle.vertices[2].position = glm::round(near * 256.0) / 256.0 + glm::dvec2(integer(random, -2, 2)) / 256.0;
    }
    return triangle;
}

double area2Of(const ScreenTriangle& t)
{
    return twiceArea(t.vertices[0].position, t.vertices[1].position, t.vertices[2].position);
}

Rules rulesOf(int size)
{
    Rules rules;
    rules.width = rules.height = size;
    return rules;
}

using ExactWeights = std::array<Rational, 3>;

/// Edge value over area at the centre of a sample.
ExactWeights exactWeights(const ScreenTriangle& t, const Sample& s)
{
    const std::array<Rational, 2> p{Rational(s.x + 0.5), Rational(s.y + 0.5)};
    const auto corner = [&](std::size_t i) {
        return std::array<Rational, 2>{Rational(t.vertices[i].position.x), Rational(t.vertices[i].position.y)};
    };
    const auto twice = [](const auto& a, const auto& b, const auto& c) {
        return Rational((b[1] - a[1]) * (c[0] - a[0]) - (b[0] - a[0]) * (c[1] - a[1]));
    };
    const Rational area = twice(corner(0), corner(1), corner(2));
    ExactWeights w{Rational(twice(corner(1), corner(2), p) / area), Rational(twice(corner(2), corner(0), p) / area),
                   Rational(twice(corner(0), corner(1), p) / area)};
    return w;
}

/// Samples inside the triangle and on the target, found by chance and along its middle lines.
std::vector<Sample> insideSamples(Random& random, const ScreenTriangle& t, int size, int tries)
{
    std::vector<Sample> samples;
    for (int i = 0; i < tries; ++i) {
        double u = uniform(random, 0, 1);
        double v = uniform(random, 0, 1);
        if (u + v > 1) {
            u = 1 - u;
            v = 1 - v;
        }
        const glm::dvec2 p = t.vertices[0].position + u * (t.vertices[1].position - t.vertices[0].position) +
                             v * (t.vertices[2].position - t.vertices[0].position);
        const Sample s{static_cast<int>(std::floor(p.x)), static_cast<int>(std::floor(p.y))};
        const ExactWeights w = exactWeights(t, s);
        if (s.x >= 0 && s.y >= 0 && s.x < size && s.y < size && w[0] >= 0 && w[1] >= 0 && w[2] >= 0)
            samples.push_back(s);
    }
    return samples;
}

int channelDifference(const Frame& a, const Frame& b)
{
    int most = 0;
    for (int y = 0; y < a.image.height(); ++y)
        for (int x = 0; x < a.image.width(); ++x) {
            const QRgb p = a.image.pixel(x, y);
            const QRgb q = b.image.pixel(x, y);
            most = std::max(
                {most, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
        }
    return most;
}

} // namespace

class TestInterpolation : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void depthPlanesAreExactInAnyOrder_data();
    void depthPlanesAreExactInAnyOrder();
    void depthIsTrue_data();
    void depthIsTrue();
    void weightsAndPerspectiveAreTrue();
    void weightsOfEdgeValuesAreTheSame();
    void affineLeavesTheWeights();
    void gradientsAreDerivatives();
    void onlyWhatIsReadIsCarried();
    void fractionOfTheWayInSpace();
    void edgeThenSpanAgreesWithPlanes();
    void sharedDivisionsRunStraightInBetween();
    void batchesAgreeWithSamples();
    void depthIsLinearOnTheScreen();
};

void TestInterpolation::depthPlanesAreExactInAnyOrder_data()
{
    QTest::addColumn<int>("size");
    QTest::addColumn<bool>("needle");
    for (const int size : {16, 640, 16384, 65536})
        for (const bool needle : {false, true})
            QTest::addRow("%d%s", size, needle ? ", needles" : "") << size << needle;
}

void TestInterpolation::depthPlanesAreExactInAnyOrder()
{
    QFETCH(int, size);
    QFETCH(bool, needle);
    Random random = seededRandom();
    int planes = 0;
    for (int i = 0; i < 1000; ++i) {
        const ScreenTriangle t = randomTriangle(random, size, needle);
        if (area2Of(t) == 0)
            continue;
        const DepthPlane plane = depthPlane(t, area2Of(t), rulesOf(size));
        if (plane.byWeights)
            continue;
        ++planes;
        const auto [left, right] =
            std::minmax({t.vertices[0].position.x, t.vertices[1].position.x, t.vertices[2].position.x});
        const auto [top, bottom] =
            std::minmax({t.vertices[0].position.y, t.vertices[1].position.y, t.vertices[2].position.y});
        const auto held = [&](double v) { return static_cast<int>(std::clamp(v, 0.0, size - 1.0)); };
        const Sample first{held(left), held(top)};
        const Sample last{held(right), held(bottom)};
        for (int k = 0; k < 8; ++k) {
            const int x = integer(random, first.x, last.x);
            const int y = integer(random, first.y, last.y);
            const double direct = plane.origin + plane.perX * x + plane.perY * y;
            QCOMPARE(plane.origin + plane.perY * y + plane.perX * x, direct);
            QCOMPARE(plane.origin + (plane.perX * x + plane.perY * y), direct);
            // From the corner of the 8 x 8 block, and back from its other end.
            const double block = plane.origin + plane.perX * (x & ~7) + plane.perY * (y & ~7);
            QCOMPARE(block + (plane.perX * (x & 7) + plane.perY * (y & 7)), direct);
            // Step by step from the start of the row and of the column, over the last 300 samples.
            const int startX = std::max(first.x, x - 300);
            const int startY = std::max(first.y, y - 300);
            double stepped = plane.origin + plane.perX * startX + plane.perY * startY;
            for (int j = startY; j < y; ++j)
                stepped += plane.perY;
            for (int j = startX; j < x; ++j)
                stepped += plane.perX;
            QCOMPARE(stepped, direct);
            const Rational exact = Rational(plane.origin) + Rational(plane.perX) * x + Rational(plane.perY) * y;
            QVERIFY(exact == Rational(direct));
        }
    }
    QVERIFY(needle || planes > 700);
    QVERIFY(planes > 0);
}

void TestInterpolation::depthIsTrue_data() { depthPlanesAreExactInAnyOrder_data(); }

void TestInterpolation::depthIsTrue()
{
    QFETCH(int, size);
    QFETCH(bool, needle);
    Random random = seededRandom();
    double worst = 0;
    int samples = 0;
    for (int i = 0; i < 200; ++i) {
        const ScreenTriangle t = randomTriangle(random, size, needle);
        if (area2Of(t) == 0)
            continue;
        const FaceInterpolation face(t, area2Of(t), rulesOf(size));
        for (const Sample& s : insideSamples(random, t, size, needle ? 30 : 6)) {
            const ExactWeights w = exactWeights(t, s);
            Rational exact = 0;
            for (std::size_t k = 0; k < 3; ++k)
                exact += w[k] * Rational(t.vertices[k].depth);
            const double found = face.depthAt(s.x, s.y, face.weightsAt(s.x, s.y));
            worst = std::max(worst, std::abs(static_cast<double>(Rational(exact - Rational(found)))));
            ++samples;
        }
    }
    qInfo("worst error %g of %d samples", worst, samples);
    QVERIFY(needle || samples > 500); // needles pass between most centres
    QVERIFY(worst < 0x1p-29);
}

void TestInterpolation::weightsAndPerspectiveAreTrue()
{
    Random random = seededRandom();
    for (int i = 0; i < 200; ++i) {
        const ScreenTriangle t = randomTriangle(random, 256, i % 4 == 0);
        if (area2Of(t) == 0)
            continue;
        const FaceInterpolation face(t, area2Of(t), rulesOf(256));
        for (const Sample& s : insideSamples(random, t, 256, 4)) {
            const ExactWeights exact = exactWeights(t, s);
            const Weights screen = face.weightsAt(s.x, s.y);
            const Weights space = face.perspective(screen);
            Rational sum = 0;
            for (std::size_t k = 0; k < 3; ++k)
                sum += exact[k] * Rational(t.vertices[k].invW);
            std::array<Rational, 3> colour;
            for (std::size_t k = 0; k < 3; ++k) {
                const Rational inSpace = exact[k] * Rational(t.vertices[k].invW) / sum;
                QVERIFY(std::abs(static_cast<double>(Rational(exact[k] - Rational(screen[k])))) < 1e-14);
                // 1 / w may differ by a factor 4096, which multiplies what rounding left of a weight of nearly zero.
                QVERIFY(std::abs(static_cast<double>(Rational(inSpace - Rational(space[k])))) < 1e-11);
                for (std::size_t c = 0; c < 3; ++c)
                    colour[c] += inSpace * Rational(t.vertices[k].varyings[c]);
            }
            Varyings varyings{};
            face.varyings(space, varyings);
            for (std::size_t c = 0; c < 3; ++c)
                QVERIFY(std::abs(static_cast<double>(Rational(colour[c] - Rational(varyings[c])))) < 0x1p-23);
        }
    }
}

/// Edge values that an algorithm has at hand give the same weights, also where doubles cannot hold them.
void TestInterpolation::weightsOfEdgeValuesAreTheSame()
{
    Random random = seededRandom();
    int turned = 0;
    for (int i = 0; i < 3000; ++i) {
        const int size = 1 << integer(random, 4, 14);
        ScreenTriangle t = randomTriangle(random, size, i % 4 == 0);
        if (i % 3 == 0) // as far out as unclipped vertices get
            t.vertices[0].position *= 0x1p19 / size;
        const Rules rules = rulesOf(size);
        const auto setup = setupTriangle<std::int64_t>(t, rules);
        if (!setup)
            continue;
        turned += area2Of(t) < 0;
        const FaceInterpolation face(t, area2Of(t), rules);
        for (int k = 0; k < 20; ++k) {
            const PixelRect& box = setup->bounds;
            const int x = integer(random, box.x, box.x + box.width - 1);
            const int y = integer(random, box.y, box.y + box.height - 1);
            const auto centre = TriangleSetup<std::int64_t>::centre(x, y);
            const FaceInterpolation::EdgeIntegers edges{setup->edges[0].at(centre), setup->edges[1].at(centre),
                                                        setup->edges[2].at(centre)};
            QCOMPARE(face.weightsAt(x, y, edges), face.weightsAt(x, y));
        }
    }
    QVERIFY(turned > 500);
}

void TestInterpolation::affineLeavesTheWeights()
{
    Random random = seededRandom();
    Rules rules = rulesOf(64);
    rules.perspectiveCorrect = false;
    const ScreenTriangle t = randomTriangle(random, 64, false);
    const FaceInterpolation face(t, area2Of(t), rules);
    const Weights weights{0.25, 0.5, 0.25};
    QCOMPARE(face.perspective(weights), weights);
}

/// u = U/W with U and W linear on the screen: a step to p changes it by exactly u' times W here over W at p.
void TestInterpolation::gradientsAreDerivatives()
{
    Random random = seededRandom();
    int tried = 0;
    for (int i = 0; i < 3000; ++i) {
        Rules rules = rulesOf(64);
        rules.perspectiveCorrect = i % 4 != 0;
        const ScreenTriangle t = randomTriangle(random, 64, false);
        if (std::abs(area2Of(t)) < 64)
            continue;
        const FaceInterpolation face(t, area2Of(t), rules);
        const auto uvAt = [&](const Weights& weights) {
            glm::dvec2 uv(0);
            for (std::size_t k = 0; k < 3; ++k)
                uv += weights[k] * glm::dvec2(t.vertices[k].varyings[0], t.vertices[k].varyings[1]);
            return uv;
        };
        const auto inverseW = [&](const Weights& screen) {
            double sum = 0;
            for (std::size_t k = 0; k < 3; ++k)
                sum += screen[k] * (rules.perspectiveCorrect ? t.vertices[k].invW : 1);
            return sum;
        };
        const Weights here = face.weightsAt(20, 30);
        if (*std::min_element(here.begin(), here.end()) < 0.05) // the neighbours may be beyond the horizon
            continue;
        ++tried;
        const glm::dvec2 uv = uvAt(face.perspective(here));
        const UvGradient gradient = face.uvGradient(here, face.perspective(here), 0);
        const auto check = [&](const Weights& there, const glm::dvec2& derivative) {
            const glm::dvec2 step = derivative * (inverseW(here) / inverseW(there));
            const glm::dvec2 error = uvAt(face.perspective(there)) - uv - step;
            return glm::length(error) <= 1e-6 * (glm::length(step) + 1e-3);
        };
        QVERIFY(check(face.weightsAt(21, 30), gradient.perX));
        QVERIFY(check(face.weightsAt(20, 31), gradient.perY));
    }
    QVERIFY(tried > 50);
}

void TestInterpolation::onlyWhatIsReadIsCarried()
{
    Random random = seededRandom();
    Rules rules = rulesOf(64);
    rules.varyingCount = 2;
    const ScreenTriangle t = randomTriangle(random, 64, false);
    const FaceInterpolation face(t, area2Of(t), rules);
    Varyings varyings{};
    varyings[2] = 42;
    face.varyings({1, 0, 0}, varyings);
    QCOMPARE(varyings[0], t.vertices[0].varyings[0]);
    QCOMPARE(varyings[1], t.vertices[0].varyings[1]);
    QCOMPARE(varyings[2], 42.0F);
}

void TestInterpolation::fractionOfTheWayInSpace()
{
    Random random = seededRandom();
    QCOMPARE(perspectiveFraction(0, 2, 5), 0.0);
    QCOMPARE(perspectiveFraction(1, 2, 5), 1.0);
    QCOMPARE(perspectiveFraction(0.5, 1, 3), 0.25);
    for (int i = 0; i < 1000; ++i) {
        const double w1 = std::exp2(uniform(random, -5, 5));
        const double w2 = std::exp2(uniform(random, -5, 5));
        const double x1 = uniform(random, -3, 3);
        const double x2 = uniform(random, -3, 3);
        const double m = uniform(random, 0, 1);
        QVERIFY(std::abs(perspectiveFraction(m, w1, w1) - m) < 1e-14);
        // The point that far in space is seen that far along on the screen.
        const double n = perspectiveFraction(m, w1, w2);
        const double seen = (x1 + n * (x2 - x1)) / (w1 + n * (w2 - w1));
        QVERIFY(std::abs(seen - (x1 / w1 + m * (x2 / w2 - x1 / w1))) < 1e-11);
    }
}

void TestInterpolation::edgeThenSpanAgreesWithPlanes()
{
    Random random = seededRandom();
    std::vector<glm::vec4> positions;
    for (int i = 0; i < 3 * 40; ++i) {
        const double w = std::exp2(uniform(random, -2, 3));
        positions.emplace_back(w * uniform(random, -1.5, 1.5), w * uniform(random, -1.5, 1.5),
                               w * uniform(random, -1, 1), w);
    }
    std::vector<Scene> scenes{soup(positions)};
    for (const char* name : {"floor", "tile-square", "teapot", "four-z", "tunnel"})
        scenes.push_back(*makeBuiltinScene(QLatin1String(name)).scene);
    for (const Scene& scene : scenes)
        for (const Interpolation interpolation : {Interpolation::Perspective, Interpolation::Affine}) {
            Settings settings = &scene == &scenes.front() ? plainSettings({200, 150}) : scene.defaults;
            settings.size = {200, 150};
            settings.shading = Shading::Gouraud;
            settings.interpolation = interpolation;
            settings.algorithm = Algorithm::EdgeWalking;
            const Frame planes = draw(scene, settings);
            settings.attributePath = AttributePath::EdgeThenSpan;
            const Frame carried = draw(scene, settings);
            QVERIFY2(planes.ids == carried.ids, qPrintable(scene.id));
            QVERIFY2(channelDifference(planes, carried) <= 1, qPrintable(scene.id));
            for (std::size_t i = 0; i < planes.depth.size(); ++i)
                QVERIFY(std::abs(planes.depth[i] - carried.depth[i]) <= 0x1p-22F);
        }
}

/// A wall whose far end is 16 times as far as its near one: at every 8th or 16th sample of a span, and at its last one,
/// the colour is that of a division at every sample; in between it runs straight. What that leaves out grows with the
/// distance of divisions.
void TestInterpolation::sharedDivisionsRunStraightInBetween()
{
    Scene wall =
        soup({{-1, 1, 0, 1}, {-1, -1, 0, 1}, {16, -16, 0, 16}, {-1, 1, 0, 1}, {16, -16, 0, 16}, {16, 16, 0, 16}});
    for (std::size_t i = 0; i < 6; ++i)
        wall.mesh.vertices[i].color = glm::vec3(wall.mesh.vertices[i].position.x > 0 ? 1.0F : 0.0F);
    Settings settings = plainSettings({203, 40});
    settings.algorithm = Algorithm::EdgeWalking;
    settings.attributePath = AttributePath::EdgeThenSpan;
    const Frame right = draw(wall, settings);
    std::array<int, 2> worst{};
    for (const Interpolation interpolation : {Interpolation::Every8, Interpolation::Every16}) {
        settings.interpolation = interpolation;
        const int every = dividedEvery(interpolation);
        const Frame shared = draw(wall, settings);
        QVERIFY(shared.ids == right.ids);
        for (std::size_t i = 0; i < right.depth.size(); ++i)
            QVERIFY(std::abs(shared.depth[i] - right.depth[i]) <= 0x1p-22F);
        const auto red = [](const Frame& frame, int x, int y) { return qRed(frame.image.pixel(x, y)); };
        for (int y = 0; y < 40; ++y)
            for (int begin = 0; begin < 203;) { // the spans of the two faces of a row
                int end = begin;
                while (end < 203 && right.ids[std::size_t(y * 203 + end)] == right.ids[std::size_t(y * 203 + begin)])
                    ++end;
                for (int x = begin; x < end; ++x) {
                    const int from = begin + (x - begin) / every * every;
                    const int to = std::min(from + every, end - 1);
                    if (x == from || x == to)
                        QCOMPARE(red(shared, x, y), red(right, x, y));
                    else
                        QVERIFY(std::abs(red(shared, x, y) - std::lerp(double(red(right, from, y)),
                                                                       double(red(right, to, y)),
                                                                       double(x - from) / (to - from))) <= 1);
                    int& most = worst[interpolation == Interpolation::Every8 ? 0 : 1];
                    most = std::max(most, std::abs(red(shared, x, y) - red(right, x, y)));
                }
                begin = end;
            }
    }
    QVERIFY2(worst[0] >= 1 && worst[1] > worst[0], qPrintable(QStringLiteral("%1 %2").arg(worst[0]).arg(worst[1])));

    // Elsewhere there are no spans to divide along.
    for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::Tiled}) {
        settings.algorithm = algorithm;
        settings.attributePath = AttributePath::Planes;
        QVERIFY(unsupported(wall, settings));
    }
    settings.algorithm = Algorithm::EdgeWalking;
    QVERIFY(unsupported(wall, settings));
}

/// The four-z board: half-way between distance 1 and 10, near 0.1 and far 50, z/w is 0.8938.
void TestInterpolation::depthIsLinearOnTheScreen()
{
    const double n = 0.1;
    const double f = 50;
    const auto depth = [&](double distance) { return ((f + n) / (f - n) - 2 * f * n / ((f - n) * distance) + 1) / 2; };
    ScreenTriangle t{};
    t.vertices[0] = {{0, 0}, depth(1), 1, {}};
    t.vertices[1] = {{0, 64}, depth(1), 1, {}};
    t.vertices[2] = {{127, 32}, depth(10), 0.1, {}};
    const FaceInterpolation face(t, area2Of(t), rulesOf(128));
    const double middle = 2 * face.depthAt(63, 31, face.weightsAt(63, 31)) - 1;
    QCOMPARE(std::round(middle * 1e4), 8938.0);
}

/// Depths and colours of a batch are those of its samples one by one, bit for bit, however many they are.
void TestInterpolation::batchesAgreeWithSamples()
{
    Random random = seededRandom();
    GouraudBatch batch;
    for (int i = 0; i < 2000; ++i) {
        ScreenTriangle t = randomTriangle(random, 64, false);
        for (ScreenVertex& v : t.vertices) // colours beyond 0 and 1, and none at all
            for (std::size_t k = 0; k < 3; ++k)
                v.varyings[k] = i % 50 == 0 ? std::numeric_limits<float>::quiet_NaN()
                                            : static_cast<float>(uniform(random, -0.5, 1.5));
        Rules rules = rulesOf(64);
        rules.varyingCount = 3;
        rules.perspectiveCorrect = i % 3 != 0;
        if (area2Of(t) == 0)
            continue;
        const FaceInterpolation face(t, area2Of(t), rules);
        batch.count = std::size_t(integer(random, 0, int(GouraudBatch::kMost)));
        for (std::size_t k = 0; k < batch.count; ++k) {
            batch.x[k] = int(integer(random, 0, 63));
            batch.y[k] = int(integer(random, 0, 63));
        }
        computeDepths(face, batch);
        computeColors(face, batch);
        for (std::size_t k = 0; k < batch.count; ++k) {
            const Weights screen = face.weightsAt(batch.x[k], batch.y[k]);
            const Weights weights = face.perspective(screen);
            QCOMPARE(batch.color[k],
                     packColor({face.varying(0, weights), face.varying(1, weights), face.varying(2, weights)}));
            if (!face.planeOfDepth().byWeights)
                QCOMPARE(std::bit_cast<std::uint32_t>(batch.depth[k]),
                         std::bit_cast<std::uint32_t>(
                             storedDepth(face.depthAt(batch.x[k], batch.y[k], screen), DepthFormat::Float32)));
        }
    }
}

QTEST_APPLESS_MAIN(TestInterpolation)
#include "test_interpolation.moc"
