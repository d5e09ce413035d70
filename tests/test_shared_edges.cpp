// The wireframe of a mesh: an edge of several faces is drawn by one of them, and the picture is the one that all of
// them would draw.
#include "core/observe/step_record.h"
#include "core/questions/why.h"
#include "core/render/line_samples.h"
#include "core/render/steps.h"
#include "tests/support.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <set>
#include <utility>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

Settings wireSettings(QSize size, DepthTest test = DepthTest::Less)
{
    Settings settings = plainSettings(size);
    settings.fill = Fill::Wireframe;
    settings.depthTest = test;
    settings.lineTies = LineTies::Canonical;
    return settings;
}

/// A closed mesh: an octahedron whose faces are cut into four `rounds` times.
///
/// in  whether faces that meet have their vertices in common, or each its own
Scene closedMesh(int rounds, bool sharesVertices)
{
    const glm::vec4 ends[6] = {{0.9F, 0.1F, 0, 1},  {-0.9F, -0.1F, 0, 1},   {-0.1F, 0.8F, 0.1F, 1},
                               {0.1F, -0.8F, 0, 1}, {0.05F, 0.1F, 0.7F, 1}, {0, 0.03F, -0.7F, 1}};
    std::vector<std::array<glm::vec4, 3>> faces;
    for (const int x : {0, 1})
        for (const int y : {2, 3})
            for (const int z : {4, 5}) {
                const bool isTurned = (x + y + z) % 2 != 0;
                faces.push_back({ends[x], ends[isTurned ? z : y], ends[isTurned ? y : z]});
            }
    for (int round = 0; round < rounds; ++round) {
        std::vector<std::array<glm::vec4, 3>> parts;
        for (const auto& [a, b, c] : faces) {
            const glm::vec4 ab = 0.5F * (a + b);
            const glm::vec4 bc = 0.5F * (b + c);
            const glm::vec4 ca = 0.5F * (c + a);
            parts.insert(parts.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        faces = std::move(parts);
    }
    std::vector<glm::vec4> positions;
    std::vector<std::uint32_t> indices;
    for (const auto& face : faces)
        for (const glm::vec4& corner : face) {
            const auto known = std::ranges::find(positions, corner);
            indices.push_back(static_cast<std::uint32_t>(known - positions.begin()));
            if (!sharesVertices || known == positions.end()) {
                indices.back() = static_cast<std::uint32_t>(positions.size());
                positions.push_back(corner);
            }
        }
    return clipScene(positions, std::move(indices));
}

/// Faces in a row that share edges, all at one depth, in places where lines have ties.
Scene flatMesh(Random& random, QSize size)
{
    constexpr int kColumns = 6;
    constexpr int kRows = 5;
    std::vector<glm::vec4> positions;
    std::vector<std::uint32_t> indices;
    for (int row = 0; row <= kRows; ++row)
        for (int column = 0; column <= kColumns; ++column)
            positions.push_back(atPixel(10 * column - 4 + 0.5 * integer(random, 0, 8),
                                        9 * row - 3 + 0.5 * integer(random, 0, 8), 0.5, size));
    for (std::uint32_t row = 0; row < kRows; ++row)
        for (std::uint32_t column = 0; column < kColumns; ++column) {
            const std::uint32_t a = row * (kColumns + 1) + column;
            const std::uint32_t below = a + kColumns + 1;
            indices.insert(indices.end(), {a, below, below + 1, a, below + 1, a + 1});
        }
    return clipScene(positions, std::move(indices));
}

Statistics::Lines linesOf(const Scene& scene, const Settings& settings)
{
    Frame frame;
    return renderCounted(scene, settings, frame).lines;
}

/// The picture with edges drawn once, and the one with all of them.
std::pair<Frame, Frame> bothWays(const Scene& scene, Settings settings)
{
    settings.sharedEdges = SharedEdges::Once;
    Frame once = draw(scene, settings);
    settings.sharedEdges = SharedEdges::EachFace;
    return {std::move(once), draw(scene, settings)};
}

} // namespace

class TestSharedEdges : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aClosedMeshHasThreeHalvesOfALineAFace();
    void culledFacesDrawNone();
    void thePictureIsTheSame_data();
    void thePictureIsTheSame();
    void cutMeshesHaveTheSamePicture();
    void overdrawShowsOne();
    void oneFaceGivesTheDirection();
    void biasMakesTwoLines();
    void aFirstPassHasNoLines();
    void recordsAndAnswersAgree();
    void nothingElseDrawsLines();
};

void TestSharedEdges::aClosedMeshHasThreeHalvesOfALineAFace()
{
    for (const bool sharesVertices : {true, false})
        for (int rounds = 0; rounds < 4; ++rounds) {
            const Scene scene = closedMesh(rounds, sharesVertices);
            const std::uint64_t faces = scene.mesh.faceCount();
            QCOMPARE(faces, std::uint64_t(8) << (2 * rounds));
            Settings settings = wireSettings({256, 256});
            Statistics::Lines lines = linesOf(scene, settings);
            QCOMPARE(lines.drawn, 3 * faces / 2);
            QCOMPARE(lines.shared, 3 * faces / 2);
            settings.sharedEdges = SharedEdges::EachFace;
            lines = linesOf(scene, settings);
            QCOMPARE(lines.drawn, 3 * faces);
            QCOMPARE(lines.shared, std::uint64_t(0));
        }
    // An OBJ file keeps vertices once a normal.
    const Scene cube = *makeBuiltinScene(QStringLiteral("cube")).scene;
    Settings settings = cube.defaults;
    settings.fill = Fill::Wireframe;
    settings.culling = Culling::None;
    const Statistics::Lines lines = linesOf(cube, settings);
    QCOMPARE(2 * lines.drawn, 3 * std::uint64_t(cube.mesh.faceCount()));
}

void TestSharedEdges::culledFacesDrawNone()
{
    const Scene scene = closedMesh(2, true);
    Settings settings = wireSettings({200, 150});
    settings.culling = Culling::Back;
    Frame frame;
    const Statistics statistics = renderCounted(scene, settings, frame);
    QVERIFY(statistics.faces.culledBack > 20 && statistics.faces.rasterized > 20);
    QCOMPARE(statistics.lines.drawn + statistics.lines.shared, 3 * statistics.faces.rasterized);
    // What is seen of a closed mesh has a rim, whose edges belong to one face each.
    QVERIFY(statistics.lines.drawn > statistics.lines.shared && statistics.lines.shared > 0);
    const auto [once, each] = bothWays(scene, settings);
    for (std::size_t i = 0; i < once.coverage.size(); ++i)
        QCOMPARE(once.coverage[i] > 0, each.coverage[i] > 0);
}

void TestSharedEdges::thePictureIsTheSame_data()
{
    QTest::addColumn<int>("test");
    QTest::addColumn<int>("visibility");
    for (const auto& [name, test] : std::map<const char*, DepthTest>{{"less", DepthTest::Less},
                                                                     {"lequal", DepthTest::LessEqual},
                                                                     {"greater", DepthTest::Greater},
                                                                     {"gequal", DepthTest::GreaterEqual},
                                                                     {"notequal", DepthTest::NotEqual},
                                                                     {"always", DepthTest::Always},
                                                                     {"none", DepthTest::None}})
        QTest::newRow(name) << int(test) << int(Visibility::ZBuffer);
    QTest::newRow("painter") << int(DepthTest::Less) << int(Visibility::Painter);
    QTest::newRow("submission order") << int(DepthTest::Less) << int(Visibility::SubmissionOrder);
}

/// All depths are equal, so that every rule about them decides which of two faces is seen.
void TestSharedEdges::thePictureIsTheSame()
{
    QFETCH(int, test);
    QFETCH(int, visibility);
    Random random = seededRandom();
    int lost = 0;
    for (int round = 0; round < 20; ++round) {
        const QSize size(64, 48);
        const Scene scene = flatMesh(random, size);
        Settings settings = wireSettings(size, DepthTest(test));
        settings.visibility = Visibility(visibility);
        settings.shading = Shading::TriangleId;
        settings.lineRule = round % 2 == 0 ? LineRule::Inclusive : LineRule::DiamondExit;
        settings.clipping = round % 3 == 0 ? Clipping::GuardBand : Clipping::None;
        const auto [once, each] = bothWays(scene, settings);
        if (settings.lineRule == LineRule::Inclusive) {
            QCOMPARE(once.ids, each.ids);
            QVERIFY(once.image == each.image);
            QVERIFY(std::ranges::equal(once.depth, each.depth));
        }
        for (std::size_t i = 0; i < once.coverage.size(); ++i) {
            QVERIFY(once.coverage[i] <= each.coverage[i]);
            lost += once.coverage[i] < each.coverage[i] ? 1 : 0;
        }
    }
    QVERIFY(lost > 1000);
}

/// Neighbours are cut at the same points, so what is left of their edge is shared, and so are the lines between the
/// pieces of one face; those along the planes are not.
void TestSharedEdges::cutMeshesHaveTheSamePicture()
{
    Random random = seededRandom();
    std::uint64_t shared = 0;
    for (int round = 0; round < 24; ++round) {
        Scene scene = closedMesh(1, round % 2 == 0);
        const glm::vec4 way(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1), 0);
        for (MeshVertex& vertex : scene.mesh.vertices) {
            vertex.position += way;
            vertex.color = {1, 1, 1};
        }
        Settings settings = wireSettings({90, 70}, DepthTest::None);
        settings.clipping = static_cast<Clipping>(round % 8);
        Frame frame;
        const Statistics counted = renderCounted(scene, settings, frame);
        shared += counted.lines.shared;
        const auto [once, each] = bothWays(scene, settings);
        QVERIFY(once.image == each.image);
        for (std::size_t i = 0; i < once.coverage.size(); ++i)
            QCOMPARE(once.coverage[i] > 0, each.coverage[i] > 0);
    }
    QVERIFY(shared > 200);
}

/// The square that its diagonal cuts: the diagonal alone is drawn by both faces.
void TestSharedEdges::overdrawShowsOne()
{
    const Scene scene = *makeBuiltinScene(QStringLiteral("square-diagonal")).scene;
    Settings settings = scene.defaults;
    settings.fill = Fill::Wireframe;
    settings.lineRule = LineRule::HalfOpen;
    const Statistics::Lines lines = linesOf(scene, settings);
    QCOMPARE(lines.drawn, std::uint64_t(5));
    QCOMPARE(lines.shared, std::uint64_t(1));
    const auto [once, each] = bothWays(scene, settings);
    int twice = 0;
    for (std::size_t i = 0; i < once.coverage.size(); ++i)
        twice += each.coverage[i] > once.coverage[i] ? 1 : 0;
    QVERIFY(twice >= 6);
    settings.shading = Shading::Overdraw;
    const auto [thin, thick] = bothWays(scene, settings);
    QVERIFY(thin.image != thick.image);
}

/// Where a line passes half-way between two pixels its direction decides: it is that of the face that draws it.
void TestSharedEdges::oneFaceGivesTheDirection()
{
    const QSize size(64, 32);
    const glm::vec4 a = atPixel(2.5, 2.5, 0.5, size);
    const glm::vec4 b = atPixel(34.5, 18.5, 0.5, size);
    const Scene scene = soup({a, atPixel(4.5, 30.5, 0.5, size), b, a, b, atPixel(60.5, 4.5, 0.5, size)});
    for (const bool firstDraws : {true, false}) {
        Settings settings = wireSettings(size, firstDraws ? DepthTest::Less : DepthTest::LessEqual);
        settings.lineTies = LineTies::ByDirection;
        const Resolved resolved = resolve(settings, scene);
        // The first face goes from B to A, the second from A to B.
        const glm::dvec2 atA(2.5, 2.5);
        const glm::dvec2 atB(34.5, 18.5);
        const auto wanted = firstDraws ? lineSamples(atB, atA, resolved.rules) : lineSamples(atA, atB, resolved.rules);
        const auto other = firstDraws ? lineSamples(atA, atB, resolved.rules) : lineSamples(atB, atA, resolved.rules);
        const Frame frame = draw(scene, settings);
        int ties = 0;
        for (const glm::ivec2& sample : wanted)
            QVERIFY(frame.coverage[std::size_t(sample.y * size.width() + sample.x)] > 0);
        for (const glm::ivec2& sample : other)
            if (sample.x > 4 && sample.x < 32 && std::ranges::find(wanted, sample) == wanted.end()) {
                ++ties;
                QCOMPARE(frame.coverage[std::size_t(sample.y * size.width() + sample.x)], std::uint16_t(0));
            }
        QVERIFY(ties >= 12);
    }
}

/// A bias that grows with the slope lifts two faces by different heights, and their edges with them.
void TestSharedEdges::biasMakesTwoLines()
{
    const QSize size(64, 64);
    const glm::vec4 a = atPixel(10, 10, 0.25, size);
    const glm::vec4 b = atPixel(50, 50, 0.75, size);
    const Scene scene = soup({a, atPixel(10, 50, 0.9, size), b, a, b, atPixel(50, 10, 0.3, size)});
    Settings settings = wireSettings(size);
    QCOMPARE(linesOf(scene, settings).shared, std::uint64_t(1));
    settings.depthBias.constant = -4;
    QCOMPARE(linesOf(scene, settings).shared, std::uint64_t(1));
    settings.depthBias.slope = -1;
    QCOMPARE(linesOf(scene, settings).shared, std::uint64_t(0));
    QCOMPARE(linesOf(scene, settings).drawn, std::uint64_t(6));
}

void TestSharedEdges::aFirstPassHasNoLines()
{
    Scene scene = closedMesh(1, true);
    scene.secondPassFrom = 12;
    Settings settings = wireSettings({128, 128}, DepthTest::LessEqual);
    Frame frame;
    const Statistics statistics = renderCounted(scene, settings, frame);
    QCOMPARE(statistics.faces.rasterized, std::uint64_t(32));
    QCOMPARE(statistics.lines.drawn + statistics.lines.shared, std::uint64_t(3 * 20));
    // Edges with a face of the first pass are drawn: that one fills, and draws none.
    QVERIFY(statistics.lines.drawn > 30 && statistics.lines.shared > 10);
}

/// A record that is stepped from any place, and the answer about a pixel, know the same lines as the picture.
void TestSharedEdges::recordsAndAnswersAgree()
{
    const auto scene = std::make_shared<const Scene>(closedMesh(1, true));
    const Settings settings = wireSettings({48, 40});
    Frame frame;
    const Statistics counted = renderCounted(*scene, settings, frame, kAllOutputs);
    const auto log = renderSteps(*scene, settings);
    QVERIFY(log->countersAt(log->size()) == counted);
    const auto record = recordSteps(scene, settings);
    FramePlanes planes;
    std::set<std::pair<std::uint32_t, std::uint8_t>> drawnEdges;
    for (std::size_t first = 0; first < record->size(); first += 97) {
        const auto window = record->window(first, 97, planes);
        for (const std::uint32_t i : window->eventsOf(StepKind::Triangle)) {
            const ScreenTriangle& triangle = window->triangle(window->event(i))->screen;
            drawnEdges.insert({triangle.face, triangle.sharedEdges});
        }
    }
    std::uint64_t shared = 0;
    for (const auto& [face, edges] : drawnEdges)
        shared += static_cast<std::uint64_t>(std::popcount(edges));
    QCOMPARE(shared, counted.lines.shared);
    for (const QPoint& pixel : {QPoint(10, 20), QPoint(24, 20), QPoint(20, 12), QPoint(30, 25)}) {
        const WhyReport report = why(*scene, settings, pixel.x(), pixel.y());
        const std::int32_t face = frame.ids[std::size_t(pixel.y() * 48 + pixel.x())];
        QCOMPARE(report.visibleFace.has_value() ? std::int32_t(*report.visibleFace) : -1, face);
    }
}

void TestSharedEdges::nothingElseDrawsLines()
{
    const Scene scene = closedMesh(1, true);
    for (const Fill fill : {Fill::Solid, Fill::Points}) {
        Settings settings = wireSettings({64, 64});
        settings.fill = fill;
        const Statistics::Lines lines = linesOf(scene, settings);
        QVERIFY(lines == Statistics::Lines());
    }
}

QTEST_APPLESS_MAIN(TestSharedEdges)
#include "test_shared_edges.moc"
