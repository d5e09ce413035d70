#include "core/pipeline/resolve.h"
// Depth: what the formats store, what the comparisons keep, reversed z, painter's order and submission order.
#include "core/pipeline/depth_test.h"
#include "tests/support.h"

#include <QTest>

#include <limits>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr QSize kSize{16, 16};
constexpr std::size_t kMiddle = 8 * 16 + 7; // pixel (7, 8)

/// Full-screen triangles, one behind the other, in this order; all the same size, so that all corners share a depth.
Scene layers(const std::vector<double>& depths)
{
    std::vector<glm::vec4> positions;
    for (const double depth : depths)
        for (const glm::dvec2 corner : {glm::dvec2(0, 0), glm::dvec2(0, 32), glm::dvec2(32, 0)})
            positions.push_back(atPixel(corner.x, corner.y, depth, kSize));
    return soup(positions);
}

Settings layerSettings()
{
    Settings settings = plainSettings(kSize);
    settings.clipping = Clipping::GuardBand;
    return settings;
}

/// The layer seen in the middle, -1 none.
int winner(const Scene& scene, const Settings& settings) { return draw(scene, settings).ids[kMiddle]; }

} // namespace

class TestDepth : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void unormValuesAreDistinctAndInOrder_data();
    void unormValuesAreDistinctAndInOrder();
    void storedDepthIsTheNearest();
    void comparisons();
    void whatIsKept();
    void clearValues();
    void reversedZPrefersNear();
    void depthRanges();
    void paintersOrder();
    void submissionOrder();
    void testingBeforeOrAfterShading();
    void coarseFormatsCannotTellCloseDepthsApart();
};

void TestDepth::unormValuesAreDistinctAndInOrder_data()
{
    QTest::addColumn<int>("format");
    QTest::addColumn<int>("codes");
    QTest::newRow("unorm8") << int(DepthFormat::Unorm8) << (1 << 8);
    QTest::newRow("unorm16") << int(DepthFormat::Unorm16) << (1 << 16);
    QTest::newRow("unorm24") << int(DepthFormat::Unorm24) << (1 << 24);
}

void TestDepth::unormValuesAreDistinctAndInOrder()
{
    QFETCH(int, format);
    QFETCH(int, codes);
    float before = -1;
    for (int code = 0; code < codes; ++code) {
        const double value = double(code) / (codes - 1);
        const float stored = storedDepth(value, DepthFormat(format));
        if (!(stored > before) || stored != static_cast<float>(value))
            QFAIL(qPrintable(QStringLiteral("code %1: %2").arg(code).arg(double(stored), 0, 'g', 9)));
        before = stored;
    }
    QCOMPARE(before, 1.0F);
}

void TestDepth::storedDepthIsTheNearest()
{
    Random random = seededRandom();
    for (int i = 0; i < 20000; ++i) {
        const double depth = uniform(random, 0, 1);
        QCOMPARE(storedDepth(depth, DepthFormat::Float32), static_cast<float>(depth));
        QVERIFY(std::abs(storedDepth(depth, DepthFormat::Unorm16) - depth) <= 0.5 / 0xffff + 0x1p-24);
        QVERIFY(std::abs(storedDepth(depth, DepthFormat::Unorm24) - depth) <= 0.5 / 0xffffff + 0x1p-24);
        const double next = std::min(1.0, depth + uniform(random, 0, 1e-6));
        for (const DepthFormat f : {DepthFormat::Float32, DepthFormat::Unorm24, DepthFormat::Unorm16})
            QVERIFY(storedDepth(depth, f) <= storedDepth(next, f));
    }
    constexpr double kInf = std::numeric_limits<double>::infinity();
    for (const DepthFormat f : {DepthFormat::Float32, DepthFormat::Unorm24, DepthFormat::Unorm16}) {
        QCOMPARE(storedDepth(-0.5, f), 0.0F);
        QCOMPARE(storedDepth(1.5, f), 1.0F);
        QCOMPARE(storedDepth(kInf, f), 1.0F);
        QCOMPARE(storedDepth(-kInf, f), 0.0F);
        QCOMPARE(storedDepth(std::numeric_limits<double>::quiet_NaN(), f), 0.0F);
    }
}

void TestDepth::comparisons()
{
    const auto results = [](DepthCompare compare) {
        return std::array{depthPasses(0.25F, 0.5F, compare), depthPasses(0.5F, 0.5F, compare),
                          depthPasses(0.75F, 0.5F, compare)};
    };
    QCOMPARE(results(DepthCompare::Less), (std::array{true, false, false}));
    QCOMPARE(results(DepthCompare::LessEqual), (std::array{true, true, false}));
    QCOMPARE(results(DepthCompare::Greater), (std::array{false, false, true}));
    QCOMPARE(results(DepthCompare::GreaterEqual), (std::array{false, true, true}));
    QCOMPARE(results(DepthCompare::Equal), (std::array{false, true, false}));
    QCOMPARE(results(DepthCompare::NotEqual), (std::array{true, false, true}));
    QCOMPARE(results(DepthCompare::Always), (std::array{true, true, true}));
}

void TestDepth::whatIsKept()
{
    const Scene scene = layers({0.5, 0.25, 0.75, 0.25});
    Settings settings = layerSettings();
    const auto kept = [&](DepthTest test) {
        settings.depthTest = test;
        return winner(scene, settings);
    };
    QCOMPARE(kept(DepthTest::Less), 1);
    QCOMPARE(kept(DepthTest::LessEqual), 3);
    QCOMPARE(kept(DepthTest::Equal), -1);
    QCOMPARE(kept(DepthTest::NotEqual), 3);
    QCOMPARE(kept(DepthTest::GreaterEqual), 2);
    QCOMPARE(kept(DepthTest::Greater), 2);
    QCOMPARE(kept(DepthTest::Always), 3);
    QCOMPARE(kept(DepthTest::None), 3);
}

void TestDepth::clearValues()
{
    const Scene nothing = layers({});
    for (const bool reversed : {false, true})
        for (const DepthTest test : {DepthTest::Less, DepthTest::LessEqual, DepthTest::GreaterEqual, DepthTest::Greater,
                                     DepthTest::NotEqual, DepthTest::Always, DepthTest::None}) {
            Settings settings = layerSettings();
            settings.depthTest = test;
            settings.reversedZ = reversed;
            const bool nearIsLarger = test == DepthTest::Greater || test == DepthTest::GreaterEqual;
            const float expected = nearIsLarger != reversed ? 0 : 1;
            const Frame frame = draw(nothing, settings);
            QVERIFY(std::ranges::all_of(frame.depth, [&](float d) { return d == expected; }));
            QVERIFY(std::ranges::all_of(frame.ids, [](std::int32_t id) { return id == -1; }));
            // Whatever is drawn first is seen.
            QCOMPARE(winner(layers({0.5}), settings), 0);
        }
}

void TestDepth::reversedZPrefersNear()
{
    Scene scene = layers({0.75, 0.25, 0.5});
    Settings settings = layerSettings();
    settings.reversedZ = true;
    Frame frame = draw(scene, settings);
    QCOMPARE(frame.ids[kMiddle], 1);
    QCOMPARE(frame.depth[kMiddle], 0.75F);
    settings.depthTest = DepthTest::Greater;
    QCOMPARE(winner(scene, settings), 0);
    settings.visibility = Visibility::Painter;
    QCOMPARE(winner(scene, settings), 1);
    // The camera's way: same picture, same faces.
    scene = *makeBuiltinScene(QStringLiteral("torus-knot")).scene;
    Settings camera = scene.defaults;
    camera.size = {120, 90};
    const Frame forward = draw(scene, camera);
    camera.reversedZ = true;
    const Frame reversed = draw(scene, camera);
    int different = 0;
    for (std::size_t i = 0; i < forward.ids.size(); ++i) {
        different += forward.ids[i] != reversed.ids[i];
        if (forward.ids[i] == reversed.ids[i])
            QVERIFY(std::abs(forward.depth[i] + reversed.depth[i] - 1) < 1e-5F);
    }
    QCOMPARE(different, 0);
}

void TestDepth::depthRanges()
{
    const Scene scene = soup({{0, 0, 0.5F, 1}, {0, 1, 0.5F, 1}, {-1, 0, 0.5F, 1}});
    Settings settings = plainSettings(kSize);
    const std::size_t inside = 7 * 16 + 7;
    QCOMPARE(draw(scene, settings).depth[inside], 0.75F);
    settings.clipZ = ClipZ::D3d;
    QCOMPARE(draw(scene, settings).depth[inside], 0.5F);
    const Scene before = soup({{0, 0, -0.5F, 1}, {0, 1, -0.5F, 1}, {-1, 0, -0.5F, 1}});
    QCOMPARE(draw(before, settings).ids[inside], -1);
    settings.clipZ = ClipZ::Gl;
    QCOMPARE(draw(before, settings).depth[inside], 0.25F);
}

void TestDepth::paintersOrder()
{
    const std::vector<double> depths{0.5, 0.25, 0.75, 0.25, 0.9};
    const Scene scene = layers(depths);
    Settings settings = layerSettings();
    settings.visibility = Visibility::Painter;
    const auto geometryOf = [&settings](const Scene& of) {
        const Resolved resolved = resolve(settings, of);
        return Geometry(of, resolved.matrices, resolved.rules);
    };
    const std::vector<std::uint32_t> order = geometryOf(scene).order();
    QVERIFY((order == std::vector<std::uint32_t>{4, 2, 0, 1, 3}));
    const Frame frame = draw(scene, settings);
    QCOMPARE(frame.ids[kMiddle], 3);
    QCOMPARE(frame.depth[kMiddle], 0.25F);
    // By camera distance for a scene in the world.
    Scene world = soup({{0, 0, -1, 1}, {1, 0, -1, 1}, {0, 1, -1, 1}, {0, 0, 1, 1}, {1, 0, 1, 1}, {0, 1, 1, 1}});
    world.space = SceneSpace::Object;
    world.bounds = boundingSphere(world.mesh);
    QVERIFY((geometryOf(world).order() == std::vector<std::uint32_t>{0, 1}));
    settings.view.yaw = 180;
    QVERIFY((geometryOf(world).order() == std::vector<std::uint32_t>{1, 0}));
}

void TestDepth::submissionOrder()
{
    const Scene scene = layers({0.25, 0.75, 0.5});
    Settings settings = layerSettings();
    settings.visibility = Visibility::SubmissionOrder;
    QCOMPARE(winner(scene, settings), 2);
    Frame frame;
    const Statistics s = renderCounted(scene, settings, frame);
    QCOMPARE(s.pixels.depthPassed, s.pixels.covered);
}

void TestDepth::testingBeforeOrAfterShading()
{
    for (const char* name : {"torus-knot", "head", "piercing"}) {
        const Scene scene = *makeBuiltinScene(QLatin1String(name)).scene;
        Settings settings = scene.defaults;
        settings.size = {160, 120};
        settings.culling = Culling::None;
        Frame before;
        Frame after;
        const Statistics early = renderCounted(scene, settings, before, kAllOutputs);
        settings.depthOrder = DepthOrder::AfterShading;
        const Statistics late = renderCounted(scene, settings, after, kAllOutputs);
        QCOMPARE(difference(before, after), QString());
        QCOMPARE(early.pixels.shaded, early.pixels.depthPassed);
        QCOMPARE(late.pixels.shaded, late.pixels.covered);
        QVERIFY(late.pixels.shaded > early.pixels.shaded);
        QCOMPARE(late.pixels.written, early.pixels.written);
    }
}

void TestDepth::coarseFormatsCannotTellCloseDepthsApart()
{
    const Scene scene = layers({0.4, 0.4 - 0x1p-18, 0.4 - 0x1p-10}); // 0.4 is the value of code 26214
    Settings settings = layerSettings();
    const auto seen = [&](DepthFormat format, std::size_t faces) {
        settings.depthFormat = format;
        Scene part = scene;
        part.mesh.indices.resize(3 * faces);
        return winner(part, settings);
    };
    QCOMPARE(seen(DepthFormat::Float32, 2), 1);
    QCOMPARE(seen(DepthFormat::Unorm24, 2), 1);
    QCOMPARE(seen(DepthFormat::Unorm16, 2), 0);
    QCOMPARE(seen(DepthFormat::Unorm16, 3), 2);
}

QTEST_APPLESS_MAIN(TestDepth)
#include "test_depth.moc"
