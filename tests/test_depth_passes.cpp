// Depth bias, depth range, depth clamp and two passes: by hand, against the exact reference.
#include "core/pipeline/depth_bias.h"
#include "core/questions/without_effect.h"
#include "core/settings/numbers_field.h"
#include "core/truth/coverage_difference.h"
#include "core/truth/exact_reference.h"
#include "tests/support.h"

#include <QJsonArray>
#include <QTest>

#include <array>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr QSize kSize{64, 64};

/// Random triangles around the view volume; `reach` 1 keeps all corners within near and far.
Scene randomScene(Random& random, int faces, double reach)
{
    std::vector<glm::vec4> positions;
    for (int i = 0; i < 3 * faces; ++i) {
        const double w = uniform(random, 0.3, 3);
        positions.emplace_back(uniform(random, -1.3, 1.3) * w, uniform(random, -1.3, 1.3) * w,
                               uniform(random, -reach, reach) * w, w);
    }
    return soup(positions);
}

/// Draws with every algorithm that knows all of these settings, and compares coverage, faces and depth with the truth.
void compareWithTruth(const Scene& scene, Settings settings, double tolerance = 0x1p-23)
{
    const ExactFrame truth = exactReference(scene, settings);
    for (const Algorithm algorithm : algorithmsFor(scene, settings)) {
        settings.algorithm = algorithm;
        const Frame frame = draw(scene, settings);
        const CoverageDifference difference = coverageDifference(frame, truth, scene.background);
        QCOMPARE(difference.missing + difference.extra + difference.hitTwice + difference.hitLess, std::uint64_t(0));
        std::uint64_t otherFace = 0;
        double depthMax = 0;
        for (std::size_t i = 0; i < truth.id.size(); ++i) {
            const double off = std::abs(static_cast<double>(frame.depth[i]) - truth.depth[i]);
            if (frame.ids[i] == truth.id[i])
                depthMax = std::max(depthMax, off);
            else
                otherFace += off > 2 * tolerance ? 1 : 0;
        }
        QCOMPARE(otherFace, std::uint64_t(0));
        QVERIFY2(depthMax < tolerance, qPrintable(QString::number(depthMax)));
    }
}

Rules rulesWith(DepthBias bias, DepthFormat format = DepthFormat::Float32)
{
    Rules rules;
    rules.depthBias = bias;
    rules.depthFormat = format;
    return rules;
}

ScreenVertex screenVertex(double x, double y, double depth)
{
    ScreenVertex vertex{};
    vertex.position = {x, y};
    vertex.depth = depth;
    return vertex;
}

} // namespace

class TestDepthPasses : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void unitsOfTheFormats();
    void slopeAndClamp();
    void biasAgainstTruth();
    void rangeAgainstTruth();
    void clampAgainstTruth();
    void whatLiesBehindTheEyeIsCutAllTheSame();
    void orderOfCornersChangesNoDepth();
    void twoPasses();
    void linesOverASurface();
    void clearedToAnyDepth();
    void lockstep();
    void textsOfTheNumbers();
    void passesAndRangesOfPatterns();
};

void TestDepthPasses::unitsOfTheFormats()
{
    const std::array flat{screenVertex(0, 0, 0.3), screenVertex(0, 8, 0.3), screenVertex(8, 0, 0.3)};
    const auto one = [&](DepthFormat format) { return depthBias(flat, rulesWith({.constant = 1}, format)); };
    QCOMPARE(one(DepthFormat::Unorm8), 1 / 255.0);
    QCOMPARE(one(DepthFormat::Unorm16), 1 / 65535.0);
    QCOMPARE(one(DepthFormat::Unorm24), 1 / 16777215.0);
    QCOMPARE(one(DepthFormat::Float32), 0x1p-25); // 0.3 is 1.2 * 2^-2
    // The largest depth of the face decides, and no unit is left of one that is 0 everywhere.
    const std::array tilted{screenVertex(0, 0, 0.3), screenVertex(0, 8, 0.3), screenVertex(8, 0, 0.5)};
    QCOMPARE(depthBias(tilted, rulesWith({.constant = 3})), 3 * 0x1p-24);
    const std::array zero{screenVertex(0, 0, 0), screenVertex(0, 8, 0), screenVertex(8, 0, 0)};
    QCOMPARE(depthBias(zero, rulesWith({.constant = 3})), 0.0);
    // As many units as asked for are as many neighbours of the depth.
    float next = 0.3F;
    for (int i = 0; i < 5; ++i)
        next = std::nextafter(next, 1.0F);
    QCOMPARE(static_cast<float>(static_cast<double>(0.3F) + depthBias(flat, rulesWith({.constant = 5}))), next);
}

void TestDepthPasses::slopeAndClamp()
{
    // z = 0.1 + 0.01 x - 0.02 y
    const std::array face{screenVertex(0, 0, 0.1), screenVertex(0, 4, 0.02), screenVertex(10, 0, 0.2)};
    const auto bias = [&](DepthBias asked, int grid = 1) {
        Rules rules = rulesWith(asked, DepthFormat::Unorm16);
        rules.sampleGrid = grid;
        return depthBias(face, rules);
    };
    QVERIFY(std::abs(bias({.slope = 1}) - 0.02) < 1e-15);
    QVERIFY(std::abs(bias({.slope = -3}) + 0.06) < 1e-15);
    QVERIFY(std::abs(bias({.slope = 1}, 4) - 0.08) < 1e-15); // the positions are in samples, the slope is a pixel's
    QVERIFY(std::abs(bias({.constant = 2, .slope = 1}) - (0.02 + 2 / 65535.0)) < 1e-15);
    QCOMPARE(bias({.slope = 1, .clamp = 0.015}), 0.015);
    QVERIFY(std::abs(bias({.slope = 1, .clamp = 0.5}) - 0.02) < 1e-15);
    QVERIFY(std::abs(bias({.slope = -1, .clamp = 0.015}) + 0.02) < 1e-15);
    QCOMPARE(bias({.slope = -1, .clamp = -0.015}), -0.015);
    QVERIFY(std::abs(bias({.slope = 1, .clamp = -0.015}) - 0.02) < 1e-15);
    // Edge-on in no pixel: the mean plane of a polygon is that of its pieces.
    const std::array square{screenVertex(0, 0, 0.1), screenVertex(0, 4, 0.02), screenVertex(10, 4, 0.12),
                            screenVertex(10, 0, 0.2)};
    QVERIFY(std::abs(depthBias(square, rulesWith({.slope = 1})) - 0.02) < 1e-15);
}

void TestDepthPasses::biasAgainstTruth()
{
    Random random = seededRandom();
    for (int round = 0; round < casesOfBuild(40); ++round) {
        const Scene scene = randomScene(random, 8, 1.2);
        Settings settings = plainSettings(kSize);
        settings.depthBias = {uniform(random, -40, 40), uniform(random, -2, 2),
                              round % 3 == 0 ? uniform(random, -0.1, 0.1) : 0};
        settings.depthTest = round % 2 == 0 ? DepthTest::Less : DepthTest::GreaterEqual;
        settings.samples = round % 4 == 3 ? Samples::Grid2 : Samples::One;
        if (settings.samples == Samples::One)
            compareWithTruth(scene, settings);
        // The bias is one number a face: coverage knows nothing of it.
        Settings without = settings;
        without.depthBias = {};
        QVERIFY(draw(scene, settings).coverage == draw(scene, without).coverage);
    }
}

void TestDepthPasses::rangeAgainstTruth()
{
    Random random = seededRandom();
    for (const DepthRange range :
         {DepthRange{0.25, 0.75}, DepthRange{0.75, 0.25}, DepthRange{0.5, 0.5}, DepthRange{1, 0}, DepthRange{0, 0.1}})
        for (int round = 0; round < casesOfBuild(8); ++round) {
            const Scene scene = randomScene(random, 8, 1.2);
            Settings settings = plainSettings(kSize);
            settings.depthRange = range;
            settings.clipping = round % 2 == 0 ? Clipping::Frustum : Clipping::DepthClamp;
            settings.depthTest = range.near <= range.far ? DepthTest::Less : DepthTest::Greater;
            compareWithTruth(scene, settings);
            const Frame frame = draw(scene, settings);
            for (std::size_t i = 0; i < frame.ids.size(); ++i)
                if (frame.ids[i] >= 0) {
                    QVERIFY(frame.depth[i] >= static_cast<float>(std::min(range.near, range.far)));
                    QVERIFY(frame.depth[i] <= static_cast<float>(std::max(range.near, range.far)));
                }
        }
}

void TestDepthPasses::clampAgainstTruth()
{
    Random random = seededRandom();
    int cutOtherwise = 0;
    for (int round = 0; round < casesOfBuild(60); ++round) {
        const Scene scene = randomScene(random, 8, 3);
        Settings settings = plainSettings(kSize);
        settings.clipping = Clipping::DepthClamp;
        settings.clipZ = round % 2 == 0 ? ClipZ::Gl : ClipZ::D3d;
        compareWithTruth(scene, settings);
        Settings frustum = settings;
        frustum.clipping = Clipping::Frustum;
        cutOtherwise += draw(scene, settings).coverage != draw(scene, frustum).coverage ? 1 : 0;
    }
    QVERIFY(cutOtherwise > 0);
}

void TestDepthPasses::whatLiesBehindTheEyeIsCutAllTheSame()
{
    Random random = seededRandom();
    for (int round = 0; round < casesOfBuild(40); ++round) {
        std::vector<glm::vec4> positions;
        for (int i = 0; i < 24; ++i)
            positions.emplace_back(uniform(random, -2, 2), uniform(random, -2, 2), uniform(random, -3, 3),
                                   uniform(random, -1, 2));
        Settings settings = plainSettings(kSize);
        settings.clipping = Clipping::DepthClamp;
        // Corners cut at w = 1e-5 have depths of up to 1e5, of which doubles keep less behind the point.
        compareWithTruth(soup(positions), settings, 1e-4);
    }
}

/// A triangle and the same one with its corners named in another order, drawn where depths are equal. llvmpipe of Mesa
/// 22.3.6 loses 42 % of the pixels so, SwiftShader of Chromium 156 14 %.
void TestDepthPasses::orderOfCornersChangesNoDepth()
{
    Random random = seededRandom();
    std::uint64_t samples = 0;
    std::uint64_t lost = 0;
    for (int round = 0; round < casesOfBuild(400); ++round) {
        std::array<glm::vec4, 3> corners;
        for (glm::vec4& corner : corners) {
            const double w = uniform(random, 0.3, 3);
            corner = {uniform(random, -1, 1) * w, uniform(random, -1, 1) * w, uniform(random, -1, 1) * w, w};
        }
        std::array<std::size_t, 3> order{0, 1, 2};
        while (std::ranges::next_permutation(order).found) {
            Scene scene =
                soup({corners[0], corners[1], corners[2], corners[order[0]], corners[order[1]], corners[order[2]]});
            scene.secondPassFrom = 1;
            Settings settings = plainSettings(kSize);
            settings.depthTest = DepthTest::Equal;
            const Frame frame = draw(scene, settings);
            for (std::size_t i = 0; i < frame.ids.size(); ++i) {
                samples += frame.coverage[i] == 2 ? 1 : 0;
                lost += frame.coverage[i] == 2 && frame.ids[i] != 1 ? 1 : 0;
            }
        }
    }
    qInfo("%llu samples, %llu lost", static_cast<unsigned long long>(samples), static_cast<unsigned long long>(lost));
    QVERIFY(samples > 0);
    QCOMPARE(lost, std::uint64_t(0));
}

void TestDepthPasses::twoPasses()
{
    // A wall, a patch on it, and one that lies behind: only what passes the second pass's test is seen.
    const auto quad = [](double depth) {
        return std::array{atPixel(0, 0, depth, kSize), atPixel(0, 128, depth, kSize), atPixel(128, 0, depth, kSize)};
    };
    std::vector<glm::vec4> positions;
    for (const double depth : {0.5, 0.7, 0.5, 0.6})
        for (const glm::vec4& corner : quad(depth))
            positions.push_back(corner);
    Scene scene = soup(positions);
    scene.secondPassFrom = 2;
    Settings settings = plainSettings(kSize);
    const auto seen = [&] {
        compareWithTruth(scene, settings);
        return draw(scene, settings).ids[64 * 20 + 20];
    };
    settings.depthTest = DepthTest::Less;
    QCOMPARE(seen(), 0);
    settings.depthTest = DepthTest::Equal;
    QCOMPARE(seen(), 2);
    settings.depthTest = DepthTest::Greater;
    QCOMPARE(seen(), 3);
    settings.depthTest = DepthTest::NotEqual;
    QCOMPARE(seen(), 3);
    settings.depthTest = DepthTest::None;
    QCOMPARE(seen(), 3);
    // The bias moves the second pass only.
    settings.depthTest = DepthTest::Less;
    settings.depthBias = {.constant = -1};
    QCOMPARE(seen(), 2);
    settings.visibility = Visibility::SubmissionOrder;
    QCOMPARE(draw(scene, settings).ids[64 * 20 + 20], 3);
    // The painter sorts each pass by itself.
    settings.visibility = Visibility::Painter;
    QCOMPARE(draw(scene, settings).ids[64 * 20 + 20], 2);
}

/// The first pass is filled where the second one is a wireframe.
void TestDepthPasses::linesOverASurface()
{
    Scene scene = *makeBuiltinScene(QStringLiteral("wire-over-fill")).scene;
    Settings filled = scene.defaults;
    filled.fill = Fill::Solid;
    Frame lines;
    const Statistics statistics = renderCounted(scene, scene.defaults, lines, kAllOutputs);
    const Frame whole = draw(scene, filled);
    std::uint64_t surface = 0;
    std::uint64_t wire = 0;
    for (std::size_t i = 0; i < lines.ids.size(); ++i) {
        surface += lines.ids[i] >= 0 && static_cast<std::uint32_t>(lines.ids[i]) < scene.secondPassFrom ? 1 : 0;
        wire += lines.ids[i] >= 0 && static_cast<std::uint32_t>(lines.ids[i]) >= scene.secondPassFrom ? 1 : 0;
        QVERIFY(whole.ids[i] < 0 || lines.ids[i] >= 0);
    }
    QVERIFY(surface > wire && wire > 500);
    QCOMPARE(statistics.faces.submitted, std::uint64_t(scene.mesh.faceCount()));
}

void TestDepthPasses::clearedToAnyDepth()
{
    Scene scene = soup({atPixel(0, 0, 0.35, kSize), atPixel(0, 128, 0.35, kSize), atPixel(128, 0, 0.35, kSize)});
    scene.depthClear = 0.35;
    Settings settings = plainSettings(kSize);
    settings.depthTest = DepthTest::Equal;
    for (const DepthFormat format : {DepthFormat::Unorm8, DepthFormat::Unorm16, DepthFormat::Unorm24}) {
        settings.depthFormat = format;
        compareWithTruth(scene, settings);
        QCOMPARE(draw(scene, settings).ids[0], 0);
    }
    scene.depthClear = 0.34;
    QCOMPARE(draw(scene, settings).ids[0], -1);
}

/// The second face of each pair is tested against what was there before the first.
void TestDepthPasses::lockstep()
{
    const Scene scene = *makeBuiltinScene(QStringLiteral("lockstep")).scene;
    Settings settings = scene.defaults;
    settings.mistakes = {QStringLiteral("lost-race")};
    for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking}) {
        settings.algorithm = algorithm;
        const Frame frame = draw(scene, settings);
        // Each pair by itself, its second face without a test against its first.
        std::vector<float> depth(frame.ids.size(), 1);
        std::vector<std::int32_t> ids(frame.ids.size(), -1);
        for (std::uint32_t pair = 0; pair < scene.mesh.faceCount() / 2; ++pair) {
            const std::vector<float> before = depth;
            for (const std::uint32_t face : {2 * pair, 2 * pair + 1}) {
                Scene alone = scene;
                alone.mesh.indices.assign(scene.mesh.indices.begin() + 3 * face,
                                          scene.mesh.indices.begin() + 3 * face + 3);
                const Frame one = draw(alone, scene.defaults);
                for (std::size_t i = 0; i < ids.size(); ++i)
                    if (one.ids[i] == 0 && one.depth[i] < before[i]) {
                        depth[i] = one.depth[i];
                        ids[i] = static_cast<std::int32_t>(face);
                    }
            }
        }
        QVERIFY(frame.ids == ids);
        QVERIFY(std::ranges::equal(frame.depth, depth));
    }
}

void TestDepthPasses::textsOfTheNumbers()
{
    const NumbersField& bias = *findNumbersField(QStringLiteral("depth-bias"));
    const NumbersField& range = *findNumbersField(QStringLiteral("depth-range"));
    Settings settings;
    QCOMPARE(valueText(bias, settings), QStringLiteral("0,0"));
    QCOMPARE(valueText(range, settings), QStringLiteral("0,1"));
    QVERIFY(!setFromText(bias, QStringLiteral("-1,-1.5"), settings));
    QVERIFY((settings.depthBias == DepthBias{-1, -1.5, 0}));
    QVERIFY(!setFromText(bias, QStringLiteral("4 0.25 0.001"), settings));
    QCOMPARE(valueText(bias, settings), QStringLiteral("4,0.25,0.001"));
    QVERIFY(!setFromText(range, QStringLiteral("0.75,0.25"), settings));
    for (const char* wrong : {"", "1", "1,2,3,4", "nan,0", "1e10,0", "a,b"})
        QVERIFY2(setFromText(bias, QLatin1String(wrong), settings), wrong);
    for (const char* wrong : {"", "0", "0,1,2", "-0.1,1", "0,1.1"})
        QVERIFY2(setFromText(range, QLatin1String(wrong), settings), wrong);
    QVERIFY((settings.depthBias == DepthBias{4, 0.25, 0.001}));
    const SettingsParse parsed = settingsFromJson(toJson(settings));
    QVERIFY(parsed.errors.empty());
    QVERIFY(parsed.settings == settings);
    const auto faulty = [](const char* key, const QJsonValue& value) {
        return settingsFromJson({{QLatin1String(key), value}}).errors.size();
    };
    QCOMPARE(faulty("depth-bias", QJsonArray{1}), std::size_t(1));
    QCOMPARE(faulty("depth-bias", QStringLiteral("1,2")), std::size_t(1));
    QCOMPARE(faulty("depth-range", QJsonArray{0, 2}), std::size_t(1));
    settings.visibility = Visibility::Painter;
    QVERIFY(whyWithoutEffect(bias, settings) && whyWithoutEffect(range, settings));
}

/// Multi-sampling: the first sample of every pixel against the truth, with two passes, in a depth range, by every
/// algorithm.
void TestDepthPasses::passesAndRangesOfPatterns()
{
    constexpr double kTolerance = 0x1p-23;
    Random random = seededRandom();
    std::size_t secondPassSeen = 0;
    for (int round = 0; round < casesOfBuild(20); ++round) {
        Scene scene = randomScene(random, 6, 2);
        const std::vector<std::uint32_t> indices = scene.mesh.indices;
        scene.secondPassFrom = static_cast<std::uint32_t>(scene.mesh.faceCount());
        scene.mesh.indices.insert(scene.mesh.indices.end(), indices.begin(), indices.end());
        Settings settings = plainSettings(kSize);
        settings.samples = round % 2 == 0 ? Samples::Msaa4 : Samples::Msaa8;
        settings.depthTest = round % 3 == 0 ? DepthTest::Equal : DepthTest::LessEqual;
        settings.clipping = round % 4 < 2 ? Clipping::DepthClamp : Clipping::Frustum;
        if (settings.depthTest == DepthTest::LessEqual)
            settings.depthBias = {.constant = round % 2 == 0 ? -8.0 : 8.0};
        settings.depthRange = {0.25, 0.75};
        const ExactFrame truth = exactReference(scene, settings);
        const std::vector<Algorithm> algorithms = algorithmsFor(scene, settings);
        QCOMPARE(algorithms.size(), std::size_t(3));
        for (const Algorithm algorithm : algorithms) {
            settings.algorithm = algorithm;
            const Frame frame = draw(scene, settings);
            for (std::size_t i = 0; i < frame.ids.size(); ++i) {
                const double off = std::abs(static_cast<double>(frame.depth[i]) - truth.depth[i]);
                QVERIFY(off < 2 * kTolerance);
                // Two faces may lie so close that float32 cannot tell them apart; the two passes of one do not.
                const auto faces = static_cast<std::int32_t>(scene.secondPassFrom);
                QVERIFY(frame.ids[i] == truth.id[i] || frame.ids[i] % faces != truth.id[i] % faces);
                secondPassSeen += frame.ids[i] >= faces ? 1 : 0;
            }
        }
    }
    QVERIFY(secondPassSeen > 0);
}

QTEST_GUILESS_MAIN(TestDepthPasses)
#include "test_depth_passes.moc"
