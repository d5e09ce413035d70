// Lines: the nearest samples in all octants, both ends, DDA beside Bresenham, and the wireframe of clipped triangles.
#include "core/rasterizers/lines.h"
#include "tests/support.h"

#include <QTest>

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
                if (p.x >= 0 && p.y >= 0 && p.x < settings.size.width() * grid && p.y < settings.size.height() * grid)
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
        settings.clipping = static_cast<Clipping>(round % 7);
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

QTEST_APPLESS_MAIN(TestLines)
#include "test_lines.moc"
