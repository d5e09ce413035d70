// The exact reference from object space: exact products with the matrix, and what it finds in the vertex stage.
#include "core/truth/distance_chart.h"
#include "core/truth/exact_geometry.h"
#include "core/truth/experiment.h"
#include "core/truth/judgement.h"
#include "tests/support.h"

#include <QTest>
#include <boost/multiprecision/cpp_int.hpp>

#include <array>

using namespace rasterlens;
using namespace rasterlens::test;
using Rational = boost::multiprecision::cpp_rational;

namespace
{

ClipTriangle triangleOf(const std::array<glm::dvec4, 3>& positions, std::uint32_t face = 0)
{
    ClipTriangle triangle{};
    triangle.face = face;
    for (std::size_t i = 0; i < 3; ++i) {
        triangle.vertices[i].positionClip = positions[i];
        triangle.vertices[i].varyings[i] = 1;
    }
    return triangle;
}

/// A number of any size that a double or a float holds.
double anyNumber(Random& random)
{
    if (integer(random, 0, 7) == 0)
        return 0;
    return std::ldexp(uniform(random, -1, 1), integer(random, -60, 60));
}

bool sameTruth(const ExactFrame& a, const ExactFrame& b)
{
    return a.cover == b.cover && a.id == b.id && a.depth == b.depth && a.color == b.color;
}

} // namespace

class TestObjectReference : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void productsAreThoseOfRationals();
    void productsThatDoubleHoldsAreTheSame();
    void aTieThatFloat32Loses();
    void identityChangesNothing();
    void scenesWithACameraHaveAChoice();
    void mistakesOfTheVertexStageAreFound();
    void brokenCamerasDropFaces();
    void chartStaysLevelOnlyWhereRecentred();
};

void TestObjectReference::productsAreThoseOfRationals()
{
    Random random = seededRandom();
    for (int i = 0; i < casesOfBuild(2000); ++i) {
        glm::dmat4 matrix;
        std::array<glm::dvec4, 3> positions{};
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                matrix[column][row] = anyNumber(random);
        for (glm::dvec4& position : positions)
            position = {anyNumber(random), anyNumber(random), anyNumber(random), 1};
        const std::array<exact::Corner, 3> corners = exact::integerTriangle(triangleOf(positions), 0, matrix).corners;
        // The integers are the rationals times one power of two, which all coordinates have in common.
        std::optional<Rational> factor;
        for (std::size_t v = 0; v < 3; ++v)
            for (int row = 0; row < 4; ++row) {
                Rational sum = 0;
                for (int column = 0; column < 4; ++column)
                    sum += Rational(matrix[column][row]) * Rational(positions[v][column]);
                const Rational integer(
                    boost::multiprecision::cpp_int(corners[v].position[static_cast<std::size_t>(row)]));
                if (sum == 0) {
                    QVERIFY(integer == 0);
                    continue;
                }
                if (!factor)
                    factor = integer / sum;
                QVERIFY(*factor > 0 && integer == *factor * sum);
            }
    }
}

/// With few bits each, products and sums are exact in double: both ways into the reference are then one.
void TestObjectReference::productsThatDoubleHoldsAreTheSame()
{
    Random random = seededRandom();
    for (int i = 0; i < casesOfBuild(60); ++i) {
        ExactOptions options;
        options.size = {64, 48};
        options.snap = i % 2 == 0;
        glm::dmat4 matrix;
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                matrix[column][row] = integer(random, -4096, 4096) / 256.0;
        matrix[3][3] += 8;
        std::vector<ClipTriangle> object;
        std::vector<ClipTriangle> clip;
        for (std::uint32_t face = 0; face < 12; ++face) {
            std::array<glm::dvec4, 3> positions{};
            std::array<glm::dvec4, 3> products{};
            for (std::size_t v = 0; v < 3; ++v) {
                positions[v] = {integer(random, -512, 512) / 512.0, integer(random, -512, 512) / 512.0,
                                integer(random, -512, 512) / 512.0, 1};
                products[v] = matrix * positions[v];
            }
            object.push_back(triangleOf(positions, face));
            clip.push_back(triangleOf(products, face));
        }
        const ExactFrame expected = exactReference(clip, options);
        options.clipFromObject = matrix;
        QVERIFY(sameTruth(exactReference(object, options), expected));
    }
}

/// By hand: in a picture of 2 x 2 pixels x_screen = x_clip + 1, so the left edge of a square at x = -255/512 lies at
/// 257/512 pixel, half-way between 128/256 and 129/256. The tie goes to 128/256, the centre of the first column, which
/// a left edge owns. A scale above 1 moves the edge left of the tie, and it still goes to 128; a scale below 1, by
/// however little, moves it right of the tie, and it goes to 129.
void TestObjectReference::aTieThatFloat32Loses()
{
    const auto firstColumnCovered = [](double scale) {
        ExactOptions options;
        options.size = {2, 2};
        options.clipFromObject = glm::dmat4(1);
        (*options.clipFromObject)[0][0] = scale;
        const glm::dvec4 a(-255.0 / 512, -1, 0, 1);
        const glm::dvec4 b(1, -1, 0, 1);
        const glm::dvec4 c(1, 1, 0, 1);
        const glm::dvec4 d(-255.0 / 512, 1, 0, 1);
        const std::vector<ClipTriangle> square{triangleOf({a, b, c}, 0), triangleOf({a, c, d}, 1)};
        const ExactFrame frame = exactReference(square, options);
        return frame.cover[0] + frame.cover[2] == 2;
    };
    QVERIFY(firstColumnCovered(1)); // the tie itself
    QVERIFY(firstColumnCovered(1 + 0x1p-23));
    QVERIFY(firstColumnCovered(1 + 0x1p-52));
    QVERIFY(!firstColumnCovered(1 - 0x1p-23));
    QVERIFY(!firstColumnCovered(1 - 0x1p-53)); // what float32, 1, would draw otherwise
}

void TestObjectReference::identityChangesNothing()
{
    Random random = seededRandom();
    ExactOptions options;
    options.size = {40, 30};
    std::vector<ClipTriangle> triangles;
    for (std::uint32_t face = 0; face < 60; ++face) {
        std::array<glm::dvec4, 3> positions{};
        for (glm::dvec4& p : positions)
            p = {uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, -0.5, 2)};
        triangles.push_back(triangleOf(positions, face));
    }
    const ExactFrame expected = exactReference(triangles, options);
    options.clipFromObject = glm::dmat4(1);
    QVERIFY(sameTruth(exactReference(triangles, options), expected));
}

void TestObjectReference::scenesWithACameraHaveAChoice()
{
    const Scene clip = *makeBuiltinScene(QStringLiteral("square-diagonal")).scene;
    const Scene object = *makeBuiltinScene(QStringLiteral("cube")).scene;
    QVERIFY(referenceSpace(clip, ReferenceSpace::Object) == ReferenceSpace::Clip);
    QVERIFY(referenceSpace(object, ReferenceSpace::Object) == ReferenceSpace::Object);
    QVERIFY(referenceSpace(object, ReferenceSpace::Clip) == ReferenceSpace::Clip);
    Settings settings = object.defaults;
    settings.size = {160, 120};
    QVERIFY(judge(object, settings, {}, {}, ReferenceSpace::Object).space == ReferenceSpace::Object);
    QVERIFY(judge(object, settings).space == ReferenceSpace::Clip);
    QVERIFY(judge(clip, clip.defaults, {}, {}, ReferenceSpace::Object).space == ReferenceSpace::Clip);

    const Variant* const variant = findVariant(QStringLiteral("edge-equation"));
    ExperimentOptions options;
    options.frames = 1;
    options.space = ReferenceSpace::Object;
    const auto rows = runExperiment(object, settings, std::span(&variant, 1), options);
    QVERIFY(rows.front().reference == ReferenceSpace::Object);
    options.reference = false;
    QVERIFY(!runExperiment(object, settings, std::span(&variant, 1), options).front().reference);
}

/// A model that float32 cannot hold: from clip space all is well, from object space it is not.
void TestObjectReference::mistakesOfTheVertexStageAreFound()
{
    Scene scene = *makeBuiltinScene(QStringLiteral("sphere")).scene;
    Settings settings = scene.defaults;
    settings.size = {160, 120};
    settings.culling = Culling::None;
    QCOMPARE(judge(scene, settings).difference.wrong(), std::uint64_t{0});
    const Judgement near = judge(scene, settings, {}, {}, ReferenceSpace::Object);
    QVERIFY2(near.difference.wrong() <= 5, qPrintable(QString::number(near.difference.wrong())));

    // The camera 10^6 radii away from 0, and the model with it: the matrix rounded to float32 loses it.
    const glm::dvec3 move(0x1p20, -0x1p20, 0x1p20);
    for (MeshVertex& vertex : scene.mesh.vertices)
        vertex.position = glm::vec4(glm::dvec3(vertex.position) + move, 1);
    scene.bounds.center += move;
    QCOMPARE(judge(scene, settings).difference.wrong(), std::uint64_t{0});
    QVERIFY(judge(scene, settings, {}, {}, ReferenceSpace::Object).difference.wrong() > 1000);
}

void TestObjectReference::brokenCamerasDropFaces()
{
    ExactOptions options;
    options.clipFromObject = glm::dmat4(1);
    (*options.clipFromObject)[2][1] = std::numeric_limits<double>::infinity();
    const std::vector<ClipTriangle> triangles{triangleOf({glm::dvec4(-1, -1, 0, 1), {1, -1, 0, 1}, {0, 1, 0, 1}})};
    const ExactFrame frame = exactReference(triangles, options);
    QCOMPARE(frame.nonFinite, 1);
}

void TestObjectReference::chartStaysLevelOnlyWhereRecentred()
{
    const Scene scene = *makeBuiltinScene(QStringLiteral("torus-knot")).scene;
    Settings settings = scene.defaults;
    settings.size = {320, 240};
    constexpr std::array kLog2Sides = {0, 4, 12, 20, 24};
    std::size_t told = 0;
    const std::vector<DistanceRow> rows =
        distanceChart(scene, settings, kLog2Sides, [&](std::size_t done) { told = done; });
    QCOMPARE(rows.size(), kLog2Sides.size());
    QCOMPARE(told, kLog2Sides.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const DistanceRow& row = rows[i];
        QVERIFY(row.covered > 5000);
        QVERIFY2(row.recentred.corner < 1.0 / 512, qPrintable(QString::number(row.recentred.corner)));
        QVERIFY2(row.recentred.wrong < row.covered / 500, qPrintable(QString::number(row.recentred.wrong)));
        if (i > 0)
            QVERIFY(row.float32.corner > rows[i - 1].float32.corner && row.relativeSize < rows[i - 1].relativeSize);
    }
    QVERIFY(rows.back().float32.corner > 1);
    QVERIFY(rows.back().float32.wrong > rows.back().covered / 10);
    QCOMPARE(distanceCsv(rows).count('\n'), int(rows.size()) + 1);
    QVERIFY(distanceJson(rows).contains("\"relative_size\""));
}

QTEST_GUILESS_MAIN(TestObjectReference)
#include "test_object_reference.moc"
