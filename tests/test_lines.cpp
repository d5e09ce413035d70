// Lines: the nearest samples in all octants, both ends, DDA beside Bresenham, and the wireframe of clipped triangles.
#include "core/rasterizers/lines.h"
#include "core/render/line_samples.h"
#include "core/truth/exact_line.h"
#include "tests/support.h"

#include <QTest>

#include <array>
#include <map>
#include <set>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

struct Plotted {
    int x;
    int y;
    double t;
};

std::vector<Plotted> line(LineAlgorithm algorithm, GridPoint from, GridPoint to)
{
    std::vector<Plotted> points;
    NullObserver observer;
    const auto plot = [&](int x, int y, double t) { points.push_back({x, y, t}); };
    if (algorithm == LineAlgorithm::Bresenham)
        bresenhamLine(from, to, plot, observer);
    else
        ddaLine(from, to, plot, observer);
    return points;
}

/// The samples on the target that the edges of these triangles go through.
std::set<std::pair<int, int>> edgesOf(const std::vector<ScreenTriangle>& triangles, const Settings& settings)
{
    const int grid = sampleGrid(settings.samples);
    std::set<std::pair<int, int>> samples;
    for (const ScreenTriangle& triangle : triangles)
        for (std::size_t i = 0; i < 3; ++i)
            for (const Plotted& p : line(settings.line, sampleOf(triangle.vertices[i].position),
                                         sampleOf(triangle.vertices[(i + 1) % 3].position)))
                if (triangle.drawsEdge(i) && p.x >= 0 && p.y >= 0 && p.x < settings.size.width() * grid &&
                    p.y < settings.size.height() * grid)
                    samples.insert({p.x, p.y});
    return samples;
}

std::set<std::pair<int, int>> drawn(const Frame& frame)
{
    std::set<std::pair<int, int>> samples;
    for (int y = 0; y < frame.image.height(); ++y)
        for (int x = 0; x < frame.image.width(); ++x)
            if (frame.coverage[std::size_t(y * frame.image.width() + x)] > 0)
                samples.insert({x, y});
    return samples;
}

} // namespace

class TestLines : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void nearestSamplesInAllOctants_data();
    void nearestSamplesInAllOctants();
    void longLines();
    void wireframeHasTheEdgesOfClippedTriangles();
    void pointsAreTheCorners();
    void samplesOffTheTargetAreDropped();
    void attributesRunAlongTheLine();
    void linesAreNotHitsAtAnEdge();
    void diamondExitOfMoltenVK();
    void diamondExitIsItsDefinition();
    void diamondsTellWhatIsDrawn();
    void stripsHaveNoSampleTwice_data();
    void stripsHaveNoSampleTwice();
    void canonicalTiesKnowNoDirection();
    void accuracyOfTheRules();
};

void TestLines::nearestSamplesInAllOctants_data()
{
    QTest::addColumn<int>("algorithm");
    QTest::newRow("bresenham") << int(LineAlgorithm::Bresenham);
    QTest::newRow("dda") << int(LineAlgorithm::Dda);
}

/// Every target within 17 samples of a start: all octants, all slopes, all ties.
void TestLines::nearestSamplesInAllOctants()
{
    QFETCH(int, algorithm);
    const GridPoint from{3, -2};
    for (int dy = -17; dy <= 17; ++dy)
        for (int dx = -17; dx <= 17; ++dx) {
            const GridPoint to{from.x + dx, from.y + dy};
            const std::vector<Plotted> points = line(LineAlgorithm(algorithm), from, to);
            const int steps = std::max(std::abs(dx), std::abs(dy));
            QCOMPARE(points.size(), std::size_t(steps) + 1);
            QCOMPARE(line(LineAlgorithm(algorithm), to, from).size(), points.size());
            QVERIFY(points.front().x == from.x && points.front().y == from.y);
            QVERIFY(points.back().x == to.x && points.back().y == to.y);
            for (int i = 0; i <= steps; ++i) {
                const Plotted& p = points[std::size_t(i)];
                // One sample a step along the longer axis, the nearest one along the other: |2 error| <= steps.
                const int errorX = 2 * ((p.x - from.x) * steps - i * dx);
                const int errorY = 2 * ((p.y - from.y) * steps - i * dy);
                QVERIFY(std::abs(dx) < steps || errorX == 0);
                QVERIFY(std::abs(dy) < steps || errorY == 0);
                QVERIFY(std::abs(errorX) <= steps && std::abs(errorY) <= steps);
                QCOMPARE(p.t, steps > 0 ? double(i) / steps : 0);
            }
        }
}

void TestLines::longLines()
{
    Random random = seededRandom();
    for (int i = 0; i < 20; ++i) {
        const auto place = [&] { return integer(random, -(1 << 20), 1 << 20); };
        const GridPoint from{place(), place()};
        const GridPoint to{place(), place()};
        const double steps = std::max(std::abs(to.x - from.x), std::abs(to.y - from.y));
        for (const LineAlgorithm algorithm : {LineAlgorithm::Bresenham, LineAlgorithm::Dda}) {
            const std::vector<Plotted> points = line(algorithm, from, to);
            QVERIFY(points.back().x == to.x && points.back().y == to.y);
            double farthest = 0;
            for (std::size_t k = 0; k < points.size(); ++k)
                farthest = std::max({farthest, std::abs(points[k].x - (from.x + double(k) * (to.x - from.x) / steps)),
                                     std::abs(points[k].y - (from.y + double(k) * (to.y - from.y) / steps))});
            QVERIFY(farthest <= (algorithm == LineAlgorithm::Bresenham ? 0.5 : 0.501)); // DDA adds up rounding
        }
    }
}

void TestLines::wireframeHasTheEdgesOfClippedTriangles()
{
    Random random = seededRandom();
    int clipped = 0;
    for (int round = 0; round < 60; ++round) {
        std::vector<glm::vec4> positions;
        for (int i = 0; i < 3 * 8; ++i)
            positions.emplace_back(uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, -1, 1),
                                   uniform(random, -0.2, 2));
        const Scene scene = soup(positions);
        Settings settings = plainSettings({80, 60});
        settings.fill = Fill::Wireframe;
        settings.line = static_cast<LineAlgorithm>(round % 2);
        settings.clipping = static_cast<Clipping>(round % 8);
        settings.depthTest = DepthTest::None;
        const Processed processed = process(scene, settings);
        QVERIFY(drawn(draw(scene, settings)) == edgesOf(processed.triangles, settings));
        Frame frame;
        clipped += int(renderCounted(scene, settings, frame).faces.clipped);
    }
    QVERIFY(clipped > 50);
}

void TestLines::pointsAreTheCorners()
{
    const QSize size(32, 32);
    const Scene scene = soup({atPixel(3.5, 4.25, 0.5, size), atPixel(20, 4, 0.5, size), atPixel(9.9, 28.1, 0.5, size)});
    Settings settings = plainSettings(size);
    settings.fill = Fill::Points;
    const Frame frame = draw(scene, settings);
    QVERIFY((drawn(frame) == std::set<std::pair<int, int>>{{3, 4}, {20, 4}, {9, 28}}));
    QCOMPARE(frame.image.pixel(3, 4), qRgb(255, 0, 0));
    QCOMPARE(frame.image.pixel(20, 4), qRgb(0, 255, 0));
    QCOMPARE(frame.image.pixel(9, 28), qRgb(0, 0, 255));
}

void TestLines::samplesOffTheTargetAreDropped()
{
    const QSize size(16, 16);
    const Scene scene = soup({atPixel(-8, 2.5, 0.5, size), atPixel(24, 2.5, 0.5, size), atPixel(24, 40.5, 0.5, size)});
    Settings settings = plainSettings(size);
    settings.clipping = Clipping::None;
    settings.fill = Fill::Wireframe;
    Frame frame;
    const Statistics s = renderCounted(scene, settings, frame, kAllOutputs);
    QCOMPARE(s.pixels.tested, std::uint64_t(33 + 39 + 39));
    QVERIFY(s.pixels.covered < s.pixels.tested);
    for (int x = 0; x < 16; ++x)
        QVERIFY(frame.coverage[std::size_t(2 * 16 + x)] > 0);
}

void TestLines::attributesRunAlongTheLine()
{
    const QSize size(16, 16);
    const Scene scene =
        soup({atPixel(0.5, 1.5, 0.25, size), atPixel(10.5, 1.5, 0.75, size), atPixel(0.5, 11.5, 1, size)});
    Settings settings = plainSettings(size);
    settings.fill = Fill::Wireframe;
    settings.depthTest = DepthTest::None;
    const Frame frame = draw(scene, settings);
    for (int x = 1; x < 10; ++x) {
        const QRgb pixel = frame.image.pixel(x, 1);
        QVERIFY(std::abs(qRed(pixel) - 255 * (10 - x) / 10.0) <= 0.51);
        QVERIFY(std::abs(qGreen(pixel) - 255 * x / 10.0) <= 0.51);
        QCOMPARE(frame.depth[std::size_t(16 + x)], static_cast<float>(0.25 + 0.05 * x));
    }
}

/// Both faces draw the line between them; no tie rule is about that.
void TestLines::linesAreNotHitsAtAnEdge()
{
    const Scene scene = *makeBuiltinScene(QStringLiteral("square-diagonal")).scene;
    for (const Fill fill : {Fill::Wireframe, Fill::Points}) {
        Settings settings = scene.defaults;
        settings.fill = fill;
        Frame frame;
        QCOMPARE(renderCounted(scene, settings, frame).pixels.coveredTwice, std::uint64_t(0));
    }
}

/// The end points of MoltenVK #1123, in pixels from the centre of a row.
void TestLines::diamondExitOfMoltenVK()
{
    const auto columns = [](glm::dvec2 from, glm::dvec2 to) {
        std::set<int> drawn;
        diamondExitLine(LinePoint::of(from), LinePoint::of(to), [&](int x, int y, double) {
            if (y == 0)
                drawn.insert(x);
        });
        return drawn;
    };
    const glm::dvec2 end(4.99, 0.5);
    QVERIFY(columns({0.99, 0.5}, end).contains(0));
    QVERIFY(!columns({0.99, 0.49}, {4.99, 0.49}).contains(0));
    QVERIFY(!columns({0.7, 0.19}, {4.99, 0.19}).contains(0));
    QVERIFY(!columns({0.5, 0.5}, end).contains(4));
    QVERIFY(columns({0.5, 0.35}, {4.99, 0.35}).contains(4));
    QCOMPARE(columns({0.5, 0.5}, end), (std::set<int>{0, 1, 2, 3}));
}

void TestLines::diamondExitIsItsDefinition()
{
    Random random = seededRandom();
    for (int round = 0; round < 4000; ++round) {
        const int grid = round % 2 == 0 ? 1 : 64; // half of the lines have many ties
        const auto place = [&] { return std::int64_t(grid) * integer(random, -2 * 256 / grid, 8 * 256 / grid); };
        const LinePoint from{place(), place()};
        const LinePoint to{place(), place()};
        std::set<std::pair<int, int>> drawn;
        diamondExitLine(from, to, [&](int x, int y, double t) {
            QVERIFY(t >= 0 && t <= 1);
            QVERIFY2(drawn.insert({x, y}).second, "a sample twice");
        });
        for (int y = -4; y < 11; ++y)
            for (int x = -4; x < 11; ++x)
                if (leavesDiamond({from.x, from.y}, {to.x, to.y}, x, y) != drawn.contains({x, y}))
                    QFAIL(qPrintable(QStringLiteral("(%1, %2) to (%3, %4) at (%5, %6): drawn %7")
                                         .arg(from.x)
                                         .arg(from.y)
                                         .arg(to.x)
                                         .arg(to.y)
                                         .arg(x)
                                         .arg(y)
                                         .arg(drawn.contains({x, y}))));
    }
}

/// What the lens tells of diamonds: all that are left are there as drawn, and a line that leaves one was within it.
void TestLines::diamondsTellWhatIsDrawn()
{
    Random random = seededRandom();
    const PixelRect part{1, 2, 5, 4};
    int kinds[2] = {0, 0};
    for (int round = 0; round < 2000; ++round) {
        const int grid = round % 2 == 0 ? 1 : 64;
        const auto place = [&] { return double(grid) * integer(random, -2 * 256 / grid, 8 * 256 / grid) / 256; };
        const glm::dvec2 from(place(), place());
        const glm::dvec2 to(place(), place());
        std::set<std::pair<int, int>> plotted;
        diamondExitLine(LinePoint::of(from), LinePoint::of(to), [&](int x, int y, double) {
            if (x >= 1 && y >= 2 && x < 6 && y < 6)
                plotted.insert({x, y});
        });
        std::set<std::pair<int, int>> told;
        for (const MetDiamond& met : diamondsOf(from, to, part)) {
            QVERIFY(met.column >= 1 && met.row >= 2 && met.column < 6 && met.row < 6);
            ++kinds[met.drawn ? 1 : 0];
            if (met.drawn)
                told.insert({met.column, met.row});
            QVERIFY(met.enters >= 0 && met.leaves <= 1 && met.enters <= met.leaves);
            // half-way between entry and exit the line is within, or on the corner that belongs to the diamond
            const glm::dvec2 middle = from + (met.enters + met.leaves) / 2 * (to - from);
            const glm::dvec2 off = glm::abs(middle - glm::dvec2(met.column + 0.5, met.row + 0.5));
            QVERIFY(off.x + off.y < 0.5 + 1e-9);
            // what is met and not drawn ends there, at the border at the latest
            if (!met.drawn && met.leaves < 1 - 1e-9) {
                const glm::dvec2 end = glm::abs(to - glm::dvec2(met.column + 0.5, met.row + 0.5));
                QVERIFY(end.x + end.y <= 0.5 + 1e-9);
            }
        }
        QVERIFY(told == plotted);
    }
    QVERIFY(kinds[0] > 100 && kinds[1] > 1000);
}

void TestLines::stripsHaveNoSampleTwice_data()
{
    QTest::addColumn<int>("rule");
    QTest::newRow("half-open") << int(LineRule::HalfOpen);
    QTest::newRow("diamond-exit") << int(LineRule::DiamondExit);
}

/// A strip that goes on to the right: each sample once, the joints as well.
void TestLines::stripsHaveNoSampleTwice()
{
    QFETCH(int, rule);
    Random random = seededRandom();
    Rules rules;
    rules.lineRule = LineRule(rule);
    NullObserver observer;
    std::map<std::pair<int, int>, int> hits;
    glm::dvec2 from(0.5, 50.5);
    for (int i = 0; i < 200; ++i) {
        const double dx = uniform(random, 2, 9);
        const glm::dvec2 to = from + glm::dvec2(dx, uniform(random, -dx, dx));
        drawLine(
            from, to, rules,
            [&](int x, int y, double) {
                ++hits[{x, y}];
            },
            observer);
        from = to;
    }
    for (const auto& [sample, count] : hits)
        QCOMPARE(count, 1);
}

void TestLines::canonicalTiesKnowNoDirection()
{
    NullObserver observer;
    int thick = 0;
    for (const bool byDirection : {true, false})
        for (const LineAlgorithm algorithm : {LineAlgorithm::Bresenham, LineAlgorithm::Dda})
            for (int dy = -17; dy <= 17; ++dy)
                for (int dx = -17; dx <= 17; ++dx) {
                    Rules rules;
                    rules.line = algorithm;
                    rules.lineTiesByDirection = byDirection;
                    const auto samples = [&](glm::dvec2 from, glm::dvec2 to) {
                        std::set<std::pair<int, int>> drawn;
                        drawLine(
                            from, to, rules,
                            [&](int x, int y, double) {
                                drawn.insert({x, y});
                            },
                            observer);
                        return drawn;
                    };
                    const glm::dvec2 a(20.5, 20.5);
                    const glm::dvec2 b = a + glm::dvec2(dx, dy);
                    if (byDirection)
                        thick += samples(a, b) != samples(b, a);
                    else
                        QCOMPARE(samples(a, b), samples(b, a));
                }
    QVERIFY(thick > 0);
}

/// 64,000 random lines of up to 90 pixels, ends on the grid of 1/256: the pixels of each rule against those that the
/// diamonds of the true line give (exact_line.h). Prints the table of
/// docs/ACCURACY.md.
void TestLines::accuracyOfTheRules()
{
    constexpr int kSide = 64;
    struct Row {
        const char* name;
        LineRule rule;
        LineAlgorithm algorithm;
        std::uint64_t missing = 0;
        std::uint64_t extra = 0;
    };
    std::array rows{Row{"inclusive, bresenham", LineRule::Inclusive, LineAlgorithm::Bresenham},
                    Row{"inclusive, dda", LineRule::Inclusive, LineAlgorithm::Dda},
                    Row{"half-open, bresenham", LineRule::HalfOpen, LineAlgorithm::Bresenham},
                    Row{"half-open, dda", LineRule::HalfOpen, LineAlgorithm::Dda},
                    Row{"diamond-exit", LineRule::DiamondExit, LineAlgorithm::Bresenham}};
    Random random = seededRandom();
    NullObserver observer;
    std::uint64_t pixels = 0;
    for (int n = 0; n < casesOfBuild(64'000); ++n) {
        const auto place = [&] { return std::int64_t(integer(random, 0, kSide * 256)); };
        const LinePoint from{place(), place()};
        const LinePoint to{place(), place()};
        const auto inSamples = [](LinePoint p) { return glm::dvec2(double(p.x), double(p.y)) / 256.0; };
        const glm::dvec2 a = inSamples(from);
        const glm::dvec2 b = inSamples(to);
        std::set<std::pair<int, int>> truth;
        for (const glm::ivec2& sample : exactLine({from.x, from.y}, {to.x, to.y}))
            truth.insert({sample.x, sample.y});
        pixels += truth.size();
        for (Row& row : rows) {
            Rules rules;
            rules.lineRule = row.rule;
            rules.line = row.algorithm;
            std::set<std::pair<int, int>> drawn;
            drawLine(
                a, b, rules,
                [&](int x, int y, double) {
                    drawn.insert({x, y});
                },
                observer);
            for (const auto& pixel : truth)
                row.missing += drawn.contains(pixel) ? 0 : 1;
            for (const auto& pixel : drawn)
                row.extra += truth.contains(pixel) ? 0 : 1;
        }
    }
    for (const Row& row : rows)
        qInfo("%-22s of %llu pixels: %llu missing, %llu extra", row.name, static_cast<unsigned long long>(pixels),
              static_cast<unsigned long long>(row.missing), static_cast<unsigned long long>(row.extra));
    QCOMPARE(rows.back().missing + rows.back().extra, std::uint64_t(0));
    QVERIFY(rows.front().missing + rows.front().extra > 0);
}

QTEST_APPLESS_MAIN(TestLines)
#include "test_lines.moc"
