// Outlines of many corners on the grid of the screen. Their triangles fill them exactly; snapping then moves corners,
// and a thin triangle that is turned over by it lies on its neighbours: a sample there is drawn twice and more.
#include "core/scene/triangulate.h"
#include "tests/support.h"

#include <QTest>

#include <cstdlib>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr int kSide = 512;  // pixels
constexpr int kSteps = 256; // of a pixel
constexpr int kCorners = 3000;

/// A coast in steps of 1/256 pixel, y down, counter-clockwise for the eye. Only odd numbers of steps: no corner lies
/// halfway between two places of a coarser grid.
std::vector<glm::ivec2> coast(Random& random)
{
    const auto odd = [](double steps) { return 2 * static_cast<int>(std::floor(steps / 2)) + 1; };
    std::vector<glm::ivec2> corners;
    for (int i = 0; i < kCorners; ++i) {
        const double angle = 2 * 3.14159265358979 * i / kCorners;
        const double radius = kSteps * (190 + 35 * std::sin(29 * angle) + uniform(random, 0, 2));
        corners.emplace_back(odd(kSteps * kSide / 2 + radius * std::cos(angle)),
                             odd(kSteps * kSide / 2 - radius * std::sin(angle)));
    }
    return corners;
}

std::vector<glm::ivec2> snapped(std::vector<glm::ivec2> corners, int bits)
{
    const int step = kSteps >> bits;
    for (glm::ivec2& corner : corners)
        corner = (corner + step / 2) / step * step;
    return corners;
}

/// How often the outline goes around each sample, in integers. One that lies on it counts as a little further right and
/// down, which is what the rule of left and top edges says.
std::vector<int> windings(const std::vector<glm::ivec2>& corners)
{
    std::vector<int> counts(kSide * kSide, 0);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        glm::ivec2 from = corners[i];
        glm::ivec2 to = corners[(i + 1) % corners.size()];
        const int sign = to.y < from.y ? 1 : -1;
        if (sign > 0)
            std::swap(from, to);
        for (int row = std::max(0, from.y / kSteps - 1); row < std::min(kSide, to.y / kSteps + 1); ++row) {
            const std::int64_t y = kSteps * row + kSteps / 2;
            if (y < from.y || y >= to.y)
                continue;
            const std::int64_t height = to.y - from.y;
            const std::int64_t crossing = (from.x - kSteps / 2) * height + (y - from.y) * (to.x - from.x);
            const std::int64_t columns = (crossing + kSteps * height - 1) / (kSteps * height); // left of the crossing
            for (std::int64_t column = 0; column < columns; ++column)
                counts[static_cast<std::size_t>(row * kSide + column)] += sign;
        }
    }
    return counts;
}

Scene sceneOf(const std::vector<glm::ivec2>& corners)
{
    std::vector<glm::vec4> positionsClip;
    std::vector<glm::vec3> outline;
    for (const glm::ivec2& corner : corners) {
        positionsClip.push_back(atPixel(double(corner.x) / kSteps, double(corner.y) / kSteps, 0.5, {kSide, kSide}));
        outline.emplace_back(corner.x, -corner.y, 0);
    }
    std::vector<CornerTriple> triangles;
    if (triangulate(outline, triangles) != Cut::Exact)
        return {};
    std::vector<std::uint32_t> indices;
    for (const CornerTriple& triangle : triangles)
        indices.insert(indices.end(), triangle.begin(), triangle.end());
    return clipScene(positionsClip, std::move(indices));
}

} // namespace

class TestSnappedOutlines : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void samplesAreDrawnTwiceBySnappingOnly_data();
    void samplesAreDrawnTwiceBySnappingOnly();
};

void TestSnappedOutlines::samplesAreDrawnTwiceBySnappingOnly_data()
{
    QTest::addColumn<int>("bits");
    QTest::addColumn<bool>("turnsOver");
    QTest::newRow("1/256: every corner stays where it is") << 8 << false;
    QTest::newRow("1/16") << 4 << true;
    QTest::newRow("1/4") << 2 << true;
    QTest::newRow("whole pixels") << 0 << true;
}

/// Front faces less back faces over a sample are the turns of the snapped outline around it: no sample is lost and none
/// is drawn twice but where a face was turned over, or the outline now lies on itself.
void TestSnappedOutlines::samplesAreDrawnTwiceBySnappingOnly()
{
    QFETCH(int, bits);
    QFETCH(bool, turnsOver);
    Random random = seededRandom();
    const std::vector<glm::ivec2> corners = coast(random);
    const std::vector<int> turns = windings(snapped(corners, bits));
    const Scene scene = sceneOf(corners);
    QCOMPARE(scene.mesh.faceCount(), std::size_t{kCorners - 2});
    Settings settings = plainSettings({kSide, kSide});
    settings.subpixelBits = bits;
    for (const Algorithm algorithm : algorithmsFor(scene, settings)) {
        settings.algorithm = algorithm;
        settings.culling = Culling::Back;
        const Frame front = draw(scene, settings);
        settings.culling = Culling::Front;
        const Frame back = draw(scene, settings);
        int twice = 0;
        for (std::size_t i = 0; i < turns.size(); ++i) {
            QCOMPARE(int(front.coverage[i]) - int(back.coverage[i]), turns[i]);
            twice += front.coverage[i] + back.coverage[i] > 1 ? 1 : 0;
        }
        QVERIFY2((twice > 0) == turnsOver, qPrintable(QString::number(twice)));
    }
}

QTEST_GUILESS_MAIN(TestSnappedOutlines)
#include "test_snapped_outlines.moc"
