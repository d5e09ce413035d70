// The frame buffer: box filter, the sample nearest the centre, clearing, and only the outputs that were asked for.
#include "core/pipeline/framebuffer.h"
#include "core/pipeline/shading.h"
#include "tests/support.h"

#include <QTest>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

Rules rulesOf(int width, int height, int grid)
{
    Rules rules;
    rules.width = width;
    rules.height = height;
    rules.sampleGrid = grid;
    return rules;
}

} // namespace

class TestFramebuffer : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void resolveAveragesTheSamples();
    void otherOutputsTakeTheSampleNearestTheCentre();
    void onlyWhatWasAskedFor();
    void framesAreUsedAgain();
    void copiesOfThePictureStay();
    void superSamplingAveragesAnEdge();
    void overdrawCountsFaces();
};

void TestFramebuffer::resolveAveragesTheSamples()
{
    Random random = seededRandom();
    for (int grid = 1; grid <= 4; ++grid) {
        Frame frame;
        const Rules rules = rulesOf(5, 3, grid);
        Framebuffer buffer(frame, rules, {}, 0xff102030);
        const SampleBuffer& samples = buffer.samples();
        QCOMPARE(samples.columns, 5 * grid);
        QCOMPARE(samples.rows, 3 * grid);
        for (int i = 0; i < samples.columns * samples.rows; ++i)
            QCOMPARE(samples.color[i], 0xff102030U);
        std::vector<std::uint32_t> colors(std::size_t(samples.columns * samples.rows));
        for (std::size_t i = 0; i < colors.size(); ++i)
            samples.color[i] = colors[i] = 0xff000000U | static_cast<std::uint32_t>(random() & 0xffffffU);
        buffer.resolve();
        QCOMPARE(frame.image.format(), QImage::Format_RGB32);
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 5; ++x) {
                std::array<int, 3> sums{};
                for (int j = 0; j < grid; ++j)
                    for (int i = 0; i < grid; ++i) {
                        const QRgb c = colors[samples.index(x * grid + i, y * grid + j)];
                        sums[0] += qRed(c);
                        sums[1] += qGreen(c);
                        sums[2] += qBlue(c);
                    }
                const auto mean = [&](int sum) { return int(std::floor(double(sum) / (grid * grid) + 0.5)); };
                QCOMPARE(frame.image.pixel(x, y), qRgb(mean(sums[0]), mean(sums[1]), mean(sums[2])));
            }
    }
}

void TestFramebuffer::otherOutputsTakeTheSampleNearestTheCentre()
{
    for (int grid = 1; grid <= 4; ++grid) {
        Frame frame;
        Framebuffer buffer(frame, rulesOf(4, 2, grid), kAllOutputs, 0);
        const SampleBuffer& samples = buffer.samples();
        for (int y = 0; y < samples.rows; ++y)
            for (int x = 0; x < samples.columns; ++x) {
                const std::size_t at = samples.index(x, y);
                QCOMPARE(samples.depth[at], 1.0F);
                QCOMPARE(samples.ids[at], -1);
                QCOMPARE(samples.coverage[at], std::uint16_t(0));
                samples.depth[at] = static_cast<float>(at);
                samples.ids[at] = static_cast<std::int32_t>(at);
                samples.coverage[at] = static_cast<std::uint16_t>(at);
            }
        buffer.resolve();
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 4; ++x) {
                // Odd grids have a sample at the centre; of an even one it is the lower right of the middle four.
                const std::size_t expected = samples.index(x * grid + grid / 2, y * grid + grid / 2);
                const std::size_t at = std::size_t(y * 4 + x);
                QCOMPARE(frame.ids[at], std::int32_t(expected));
                QCOMPARE(frame.depth[at], float(expected));
                QCOMPARE(frame.coverage[at], std::uint16_t(expected));
            }
    }
}

void TestFramebuffer::onlyWhatWasAskedFor()
{
    const Scene scene = *makeBuiltinScene(QStringLiteral("cube")).scene;
    Settings settings = scene.defaults;
    settings.size = {40, 30};
    for (const Samples samples : {Samples::One, Samples::Grid2}) {
        settings.samples = samples;
        const Frame all = draw(scene, settings);
        QCOMPARE(all.depth.size(), std::size_t(1200));
        for (const Outputs outputs :
             {Outputs{}, Outputs{.depth = true}, Outputs{.ids = true}, Outputs{.coverage = true},
              Outputs{.depth = true, .coverage = true}, Outputs{.depth = true, .picture = false}}) {
            Frame frame = all; // what an earlier picture left must not stay
            render(scene, settings, frame, outputs);
            QVERIFY(frame.image == (outputs.picture ? all.image : QImage()));
            QVERIFY(frame.depth == (outputs.depth ? all.depth : DepthBuffer()));
            QVERIFY(frame.ids == (outputs.ids ? all.ids : std::vector<std::int32_t>()));
            QVERIFY(frame.coverage == (outputs.coverage ? all.coverage : std::vector<std::uint16_t>()));
        }
    }
    // Depth without a depth test is kept only for those who ask.
    Frame unused;
    Rules rules = rulesOf(8, 8, 1);
    rules.depthTested = false;
    QVERIFY(Framebuffer(unused, rules, {}, 0).samples().depth == nullptr);
    QVERIFY(Framebuffer(unused, rules, {.depth = true}, 0).samples().depth != nullptr);
    QVERIFY(Framebuffer(unused, rules, {}, 0).samples().coverage == nullptr);
    settings.visibility = Visibility::SubmissionOrder;
    const Frame painted = draw(scene, settings);
    QVERIFY(std::ranges::any_of(painted.depth, [](float d) { return d < 1; }));
}

void TestFramebuffer::framesAreUsedAgain()
{
    const Scene scene = *makeBuiltinScene(QStringLiteral("letter-f")).scene;
    Frame frame;
    for (const QSize size : {QSize(50, 40), QSize(31, 77), QSize(1, 1), QSize(50, 40)})
        for (const Samples samples : {Samples::One, Samples::Grid3}) {
            Settings settings = scene.defaults;
            settings.size = size;
            settings.samples = samples;
            render(scene, settings, frame, kAllOutputs);
            QCOMPARE(difference(frame, draw(scene, settings)), QString());
        }
    const uchar* memory = frame.image.constBits();
    Settings settings = scene.defaults;
    settings.size = {50, 40};
    render(scene, settings, frame, kAllOutputs);
    QCOMPARE(frame.image.constBits(), memory);
}

/// A picture that was handed on is not painted over by the next frame.
void TestFramebuffer::copiesOfThePictureStay()
{
    Settings settings = plainSettings({8, 8});
    Frame frame;
    render(*makeBuiltinScene(QStringLiteral("square-diagonal")).scene, settings, frame);
    const QImage handedOn = frame.image;
    const QImage deep = handedOn.copy();
    render(soup({}), settings, frame);
    QVERIFY(handedOn == deep);
    QVERIFY(frame.image != deep);
}

/// A white half plane whose border runs through the middle of a pixel column.
void TestFramebuffer::superSamplingAveragesAnEdge()
{
    const QSize size(8, 8);
    Scene scene = soup({atPixel(0, 0, 0.5, size), atPixel(0, 8, 0.5, size), atPixel(3.5, 8, 0.5, size),
                        atPixel(0, 0, 0.5, size), atPixel(3.5, 8, 0.5, size), atPixel(3.5, 0, 0.5, size)});
    for (MeshVertex& v : scene.mesh.vertices)
        v.color = {1, 1, 1};
    Settings settings = plainSettings(size);
    // With 1, 2, 3, 4 columns of samples, the columns left of the middle are white. A column at the middle lies on a
    // right edge and is not.
    const std::array<int, 4> expected{0, 128, 85, 128};
    for (int i = 0; i < 4; ++i) {
        settings.samples = static_cast<Samples>(i);
        const QImage image = draw(scene, settings).image;
        for (int y = 0; y < 8; ++y) {
            QCOMPARE(qRed(image.pixel(2, y)), 255);
            QCOMPARE(qRed(image.pixel(3, y)), expected[std::size_t(i)]);
            QCOMPARE(qRed(image.pixel(4, y)), 0);
        }
    }
}

void TestFramebuffer::overdrawCountsFaces()
{
    const QSize size(8, 8);
    std::vector<glm::vec4> positions;
    for (int i = 0; i < 3; ++i)
        for (const glm::dvec2 p : {glm::dvec2(0, 0), glm::dvec2(0, 8), glm::dvec2(8, 0)})
            positions.push_back(atPixel(p.x, p.y, 0.5, size));
    Settings settings = plainSettings(size);
    settings.shading = Shading::Overdraw;
    Frame frame;
    render(soup(positions), settings, frame);
    QCOMPARE(frame.image.pixel(1, 1), overdrawColor(3)); // faces that fail the depth test count too
    QCOMPARE(frame.image.pixel(7, 7), overdrawColor(0));
    QVERIFY(frame.coverage.empty());
    for (std::uint32_t a = 0; a < 9; ++a)
        for (std::uint32_t b = 0; b < a; ++b)
            QVERIFY(overdrawColor(a) != overdrawColor(b));
    QCOMPARE(overdrawColor(500), overdrawColor(8));
}

QTEST_APPLESS_MAIN(TestFramebuffer)
#include "test_framebuffer.moc"
