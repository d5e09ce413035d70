// Super-sampling laid open: what the samples of a pixel store, how they become one colour, and what two mistakes make
// of that. Means are computed once more from the buffer of samples, and by hand.
#include "core/observe/step_text.h"
#include "core/questions/why.h"
#include "core/render/steps.h"
#include "tests/support.h"

#include <QJsonArray>
#include <QTest>

#include <map>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

Scene samplesScene() { return *makeBuiltinScene(QStringLiteral("samples")).scene; }

Settings with(const Scene& scene, const char* mistake, Samples samples = Samples::Grid2)
{
    Settings settings = scene.defaults;
    settings.samples = samples;
    if (mistake != nullptr)
        settings.mistakes = {QString::fromLatin1(mistake)};
    return settings;
}

std::uint32_t channel(std::uint32_t color, int shift) { return color >> shift & 255U; }

/// The mean of colours, half up, by numbers that are no part of the program's own filter.
std::uint32_t mean(const std::vector<std::uint32_t>& colors)
{
    std::uint32_t out = 0xff000000U;
    for (const int shift : {16, 8, 0}) {
        double sum = 0;
        for (const std::uint32_t color : colors)
            sum += channel(color, shift);
        out |= std::uint32_t(std::floor(sum / double(colors.size()) + 0.5)) << shift;
    }
    return out;
}

/// The face that was written last at each sample, from the record's own writes.
std::map<std::pair<int, int>, std::uint32_t> facesOf(const StepLog& log)
{
    std::map<std::pair<int, int>, std::uint32_t> faces;
    for (const std::uint32_t i : log.eventsOf(StepKind::Write))
        faces[{log.event(i).x, log.event(i).y}] = log.event(i).face;
    return faces;
}

} // namespace

class TestResolveSteps : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void sumsAreWrittenOut();
    void samplesAreThoseOfTheBuffer_data();
    void samplesAreThoseOfTheBuffer();
    void oneSampleNeedsNoMean();
    void blackLinesComeWithTheirStep();
    void sharedDepthsAreStored();
    void whyKnowsAllSamples();
    void whyTellsBeforeAndAfter();
    void backgroundIsToldWhereAsked();
};

void TestResolveSteps::sumsAreWrittenOut()
{
    ResolvedPixel pixel;
    pixel.count = 4;
    pixel.samples[0].color = 0xfff0a455;
    pixel.samples[1].color = 0xfff0a455;
    pixel.samples[2].color = 0xffff0000;
    pixel.samples[3].color = 0xff000003;
    // 240 + 240 + 255 + 0 = 735, 164 + 164 = 328, 85 + 85 + 0 + 3 = 173
    pixel.color = 0xffb8522b;
    QCOMPARE(meanSums(pixel), (QStringList{QStringLiteral("R = (240 + 240 + 255 + 0) / 4 = 183.75 -> 184"),
                                           QStringLiteral("G = (164 + 164 + 0 + 0) / 4 = 82"),
                                           QStringLiteral("B = (85 + 85 + 0 + 3) / 4 = 43.25 -> 43")}));
    pixel.black = 0b0110;
    pixel.color = 0xff3c2916; // 240 / 4, 164 / 4, 88 / 4
    QCOMPARE(meanSums(pixel), (QStringList{QStringLiteral("R = (240 + 0 + 0 + 0) / 4 = 60"),
                                           QStringLiteral("G = (164 + 0 + 0 + 0) / 4 = 41"),
                                           QStringLiteral("B = (85 + 0 + 0 + 3) / 4 = 22")}));
}

void TestResolveSteps::samplesAreThoseOfTheBuffer_data()
{
    QTest::addColumn<int>("samples");
    QTest::newRow("2x2") << int(Samples::Grid2);
    QTest::newRow("3x3") << int(Samples::Grid3);
    QTest::newRow("4x4") << int(Samples::Grid4);
}

void TestResolveSteps::samplesAreThoseOfTheBuffer()
{
    QFETCH(int, samples);
    const Scene scene = samplesScene();
    const Settings settings = with(scene, nullptr, Samples(samples));
    StepFilter filter;
    filter.kinds = kindBit(StepKind::Resolve);
    StepCursor cursor(renderSteps(scene, settings, filter));
    cursor.moveTo(cursor.log().size());
    const StepLog& log = cursor.log();
    const int grid = log.grid();
    const auto resolves = log.eventsOf(StepKind::Resolve);
    QVERIFY(resolves.size() > 1000);
    std::size_t mixed = 0;
    for (const std::uint32_t i : resolves) {
        const ResolvedPixel& pixel = log.payload<ResolveStep>(log.event(i)).pixel;
        QCOMPARE(pixel.count, grid * grid);
        std::vector<std::uint32_t> colors;
        for (int k = 0; k < pixel.count; ++k) {
            const std::size_t at = std::size_t(pixel.y * grid + k / grid) * std::size_t(log.columns()) +
                                   std::size_t(pixel.x * grid + k % grid);
            QCOMPARE(pixel.samples[std::size_t(k)].color, cursor.sampleColors()[at]);
            QCOMPARE(pixel.samples[std::size_t(k)].depth, cursor.sampleDepths()[at]);
            colors.push_back(pixel.samples[std::size_t(k)].color);
        }
        mixed += std::ranges::adjacent_find(colors, std::not_equal_to()) != colors.end() ? 1 : 0;
        QCOMPARE(pixel.black, 0U);
        QCOMPARE(pixel.color, mean(colors));
        QCOMPARE(cursor.image().pixel(pixel.x, pixel.y), pixel.color);
    }
    QVERIFY(mixed > 50);
}

void TestResolveSteps::oneSampleNeedsNoMean()
{
    const Scene scene = samplesScene();
    QVERIFY(renderSteps(scene, with(scene, nullptr, Samples::One))->eventsOf(StepKind::Resolve).empty());
    QVERIFY(!why(scene, with(scene, nullptr, Samples::One), 30, 30).samples);
}

/// M32: of each pixel only the samples of the face drawn last count. Up to its step a pixel is the mean of all.
void TestResolveSteps::blackLinesComeWithTheirStep()
{
    const Scene scene = samplesScene();
    const auto log = renderSteps(scene, with(scene, "coverage-times-color"));
    const auto faces = facesOf(*log);
    const int grid = log->grid();
    StepCursor cursor(log);
    std::size_t dark = 0;
    for (const std::uint32_t i : log->eventsOf(StepKind::Resolve)) {
        const ResolvedPixel& pixel = log->payload<ResolveStep>(log->event(i)).pixel;
        std::array<int, 4> face{};
        for (int k = 0; k < 4; ++k) {
            const auto at = faces.find({pixel.x * grid + k % grid, pixel.y * grid + k / grid});
            face[std::size_t(k)] = at == faces.end() ? -1 : int(at->second);
        }
        const int last = std::ranges::max(face);
        std::vector<std::uint32_t> counted;
        std::vector<std::uint32_t> stored;
        for (int k = 0; k < 4; ++k) {
            stored.push_back(pixel.samples[std::size_t(k)].color);
            counted.push_back(face[std::size_t(k)] == last ? stored.back() : 0xff000000U);
            QCOMPARE(pixel.counted(k), counted.back());
        }
        QCOMPARE(pixel.color, mean(counted));
        if (counted == stored)
            continue;
        ++dark;
        cursor.moveTo(i);
        QCOMPARE(cursor.image().pixel(pixel.x, pixel.y), mean(stored));
        cursor.moveTo(i + 1);
        QCOMPARE(cursor.image().pixel(pixel.x, pixel.y), mean(counted));
    }
    QVERIFY(dark > 50);
    Frame frame;
    render(scene, with(scene, "coverage-times-color"), frame);
    cursor.moveTo(log->size());
    QVERIFY(cursor.image() == frame.image);
    cursor.moveTo(log->eventsOf(StepKind::Resolve).front());
    render(scene, with(scene, nullptr), frame);
    QVERIFY2(cursor.image() == frame.image, "before the first mean the samples are those of the right picture");
}

/// M33: the samples of a pixel that a face writes to share its depth.
void TestResolveSteps::sharedDepthsAreStored()
{
    const Scene scene = samplesScene();
    StepFilter filter;
    filter.kinds = kindBit(StepKind::Resolve);
    const auto log = renderSteps(scene, with(scene, "one-depth-per-pixel"), filter);
    QVERIFY(!log->eventsOf(StepKind::Resolve).empty());
    for (const std::uint32_t i : log->eventsOf(StepKind::Resolve)) {
        const ResolvedPixel& pixel = log->payload<ResolveStep>(log->event(i)).pixel;
        for (int k = 1; k < pixel.count; ++k)
            QCOMPARE(pixel.samples[std::size_t(k)].depth, pixel.samples[0].depth);
    }
}

void TestResolveSteps::whyKnowsAllSamples()
{
    const Scene scene = samplesScene();
    const Settings settings = with(scene, nullptr);
    const auto log = renderSteps(scene, settings);
    std::size_t asked = 0;
    for (const std::uint32_t i : log->eventsOf(StepKind::Resolve)) {
        const ResolvedPixel& pixel = log->payload<ResolveStep>(log->event(i)).pixel;
        if (asked >= 12 || pixel.samples[0].color == pixel.samples[3].color)
            continue;
        ++asked;
        const WhyReport report = why(scene, settings, pixel.x, pixel.y);
        QVERIFY(report.samples && *report.samples == pixel);
        QVERIFY(report.without.empty());
        QCOMPARE(report.color, pixel.color);
        QCOMPARE(whySamples(report).size(), 1);
        const QJsonObject json = toJson(report);
        const QJsonArray samples = json.value("samples").toArray();
        QCOMPARE(samples.size(), 4);
        for (int k = 0; k < 4; ++k)
            QCOMPARE(samples[k].toObject().value("color").toString(), colorText(pixel.samples[std::size_t(k)].color));
    }
    QCOMPARE(asked, std::size_t(12));
}

void TestResolveSteps::whyTellsBeforeAndAfter()
{
    const Scene scene = samplesScene();
    for (const char* mistake : {"coverage-times-color", "one-depth-per-pixel"}) {
        Frame wrong;
        Frame right;
        render(scene, with(scene, mistake), wrong);
        render(scene, with(scene, nullptr), right);
        int asked = 0;
        for (int y = 0; y < wrong.image.height() && asked < 6; ++y)
            for (int x = 0; x < wrong.image.width() && asked < 6; ++x) {
                if (wrong.image.pixel(x, y) == right.image.pixel(x, y))
                    continue;
                ++asked;
                const WhyReport report = why(scene, with(scene, mistake), x, y);
                QVERIFY(report.samples);
                QCOMPARE(report.samples->color, wrong.image.pixel(x, y));
                QCOMPARE(report.without.size(), std::size_t(1));
                QCOMPARE(report.without[0].samples.color, right.image.pixel(x, y));
                QCOMPARE(whySamples(report).size(), 2);
            }
        QCOMPARE(asked, 6);
    }
}

void TestResolveSteps::backgroundIsToldWhereAsked()
{
    const Scene scene = samplesScene();
    const Settings settings = with(scene, nullptr);
    const WhyReport report = why(scene, settings, 0, 0);
    QVERIFY(!report.visibleFace);
    QVERIFY(report.samples);
    for (int k = 0; k < 4; ++k)
        QCOMPARE(report.samples->samples[std::size_t(k)].color, report.background);
}

QTEST_GUILESS_MAIN(TestResolveSteps)
#include "test_resolve_steps.moc"
