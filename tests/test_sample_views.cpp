// The samples of a pixel as the window shows them: on the canvas until they are one colour, and on the pixel card.
#include "core/observe/names.h"
#include "core/questions/why.h"
#include "core/render/render.h"
#include "core/render/steps.h"
#include "core/scenes/builtin_scenes.h"
#include "ui/face/pixel_card.h"
#include "ui/steps/sample_lens.h"
#include "ui/steps/step_formula.h"

#include <QPainter>
#include <QTest>

using namespace rasterlens;

namespace
{

constexpr QRgb kUntouched = 0xffff00ff;

Scene samplesScene() { return *makeBuiltinScene(QStringLiteral("samples")).scene; }

Settings smallSettings(const Scene& scene, const char* mistake = nullptr)
{
    Settings settings = scene.defaults;
    settings.size = {40, 30};
    if (mistake != nullptr)
        settings.mistakes = {QString::fromLatin1(mistake)};
    return settings;
}

/// The canvas at a zoom as the lens leaves it.
QImage painted(const SampleLens& lens, QSize picture, int zoom)
{
    QImage canvas(picture * zoom, QImage::Format_RGB32);
    canvas.fill(kUntouched);
    QPainter painter(&canvas);
    OverlayOptions options;
    options.grid = false;
    lens.paint(painter, canvas.rect(), CanvasTransform{double(zoom), {0, 0}}, options);
    return canvas;
}

} // namespace

class TestSampleViews : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void samplesAreSeenUntilTheirMean();
    void blackSamplesAreCrossedOut();
    void theStepHasItsSum();
    void theCardKnowsAllSamples();
    void theCardTellsBeforeAndAfter();
};

void TestSampleViews::samplesAreSeenUntilTheirMean()
{
    const Scene scene = samplesScene();
    StepCursor cursor(renderSteps(scene, smallSettings(scene)));
    const StepLog& log = cursor.log();
    SampleLens lens;
    lens.setCursor(&cursor);
    const auto resolves = log.eventsOf(StepKind::Resolve);
    constexpr int kZoom = 16;
    constexpr int kCell = kZoom / 2;
    const QSize picture = cursor.image().size();

    cursor.moveTo(resolves.front());
    QVERIFY(lens.hidesNumbers());
    const QImage before = painted(lens, picture, kZoom);
    for (int y = 0; y < log.rows(); ++y)
        for (int x = 0; x < log.columns(); ++x)
            QCOMPARE(before.pixel(x * kCell + kCell / 2, y * kCell + kCell / 2),
                     cursor.sampleColors()[std::size_t(y) * std::size_t(log.columns()) + std::size_t(x)]);

    const std::uint32_t half = resolves[resolves.size() / 2];
    cursor.moveTo(half + 1);
    const ResolvedPixel& pixel = log.payload<ResolveStep>(log.event(half)).pixel;
    QCOMPARE(log.resolvedPixels(half + 1), std::size_t(pixel.y * picture.width() + pixel.x + 1));
    const QImage midway = painted(lens, picture, kZoom);
    for (int x = 0; x < picture.width(); ++x)
        for (int y = 0; y + 1 < pixel.y - 12; ++y) // the plate lies within a few rows
            QCOMPARE(midway.pixel(x * kZoom + kZoom / 2, y * kZoom + kZoom / 2), kUntouched);

    cursor.moveTo(log.size());
    QVERIFY(!lens.hidesNumbers());
    const QImage after = painted(lens, picture, kZoom);
    QImage untouched = after;
    untouched.fill(kUntouched);
    QVERIFY(after == untouched);
}

void TestSampleViews::blackSamplesAreCrossedOut()
{
    const Scene scene = samplesScene();
    StepCursor cursor(renderSteps(scene, smallSettings(scene, "coverage-times-color")));
    const StepLog& log = cursor.log();
    SampleLens lens;
    lens.setCursor(&cursor);
    int crossed = 0;
    for (const std::uint32_t i : log.eventsOf(StepKind::Resolve)) {
        const ResolvedPixel& pixel = log.payload<ResolveStep>(log.event(i)).pixel;
        if (pixel.counted(0) == pixel.samples[0].color || crossed >= 4)
            continue;
        ++crossed;
        cursor.moveTo(i + 1);
        constexpr int kZoom = 64;
        const QImage canvas = painted(lens, cursor.image().size(), kZoom);
        // A quarter of the way down the diagonals of the first sample, clear of its number and of the frame.
        for (const int x : {10, 22})
            QVERIFY(canvas.pixel(pixel.x * kZoom + x, pixel.y * kZoom + 10) != pixel.samples[0].color);
        QCOMPARE(canvas.pixel(pixel.x * kZoom + 16, pixel.y * kZoom + 6), pixel.samples[0].color);
    }
    QCOMPARE(crossed, 4);
}

void TestSampleViews::theStepHasItsSum()
{
    const Scene scene = samplesScene();
    const auto log = renderSteps(scene, smallSettings(scene, "coverage-times-color"));
    int told = 0;
    for (const std::uint32_t i : log->eventsOf(StepKind::Resolve)) {
        const ResolvedPixel& pixel = log->payload<ResolveStep>(log->event(i)).pixel;
        const StepExplanation explanation = explainStep(*log, i);
        QVERIFY(
            explanation.listing[std::size_t(explanation.line)].code.contains(QStringLiteral("pixel = color * inside")));
        int sum = 0;
        for (int k = 0; k < 4; ++k)
            sum += qRed(pixel.counted(k));
        QVERIFY(explanation.formula.contains(QStringLiteral(" / 4 = %1").arg(sum / 4.0)));
        const bool says = explanation.formula.contains(QStringLiteral("of 4 samples count as black"));
        QCOMPARE(says, pixel.black != 0);
        QCOMPARE(explanation.formula.contains(QStringLiteral("because of M32")), pixel.black != 0);
        told += says ? 1 : 0;
    }
    QVERIFY(told > 4);
}

void TestSampleViews::theCardKnowsAllSamples()
{
    const Scene scene = samplesScene();
    const Settings settings = smallSettings(scene);
    PixelCard card;
    const auto report = std::make_shared<WhyReport>(why(scene, settings, 20, 15));
    QVERIFY(report->samples);
    card.setReport(report);
    const QString text = card.asText();
    QVERIFY(text.contains(QStringLiteral("Its samples and their mean")));
    for (int k = 0; k < 4; ++k) {
        const Pixel& sample = report->samples->samples[std::size_t(k)];
        const QColor color{QRgb(sample.color)};
        QVERIFY(text.contains(QStringLiteral("%1: (%2, %3, %4)  z %5")
                                  .arg(k + 1)
                                  .arg(color.red())
                                  .arg(color.green())
                                  .arg(color.blue())
                                  .arg(depthNumber(sample.depth))));
    }
    Settings one = settings;
    one.samples = Samples::One;
    card.setReport(std::make_shared<WhyReport>(why(scene, one, 20, 15)));
    QVERIFY(!card.asText().contains(QStringLiteral("Its samples")));
}

void TestSampleViews::theCardTellsBeforeAndAfter()
{
    const Scene scene = samplesScene();
    for (const auto& [id, number] :
         {std::pair{"coverage-times-color", "M32"}, std::pair{"one-depth-per-pixel", "M33"}}) {
        const Settings settings = smallSettings(scene, id);
        Frame wrong;
        Frame right;
        render(scene, settings, wrong);
        render(scene, smallSettings(scene), right);
        bool found = false;
        for (int y = 0; y < 30 && !found; ++y)
            for (int x = 0; x < 40 && !found; ++x) {
                if (wrong.image.pixel(x, y) == right.image.pixel(x, y))
                    continue;
                found = true;
                PixelCard card;
                card.setReport(std::make_shared<WhyReport>(why(scene, settings, x, y)));
                const QStringList parts = card.asText().split(QStringLiteral("Without %1").arg(QLatin1String(number)));
                QCOMPARE(parts.size(), 2);
                const auto mean = [](QRgb color) { return QString::number(qRed(color)); };
                const auto red = [](const QString& part) {
                    const QString line =
                        part.mid(part.indexOf(QStringLiteral("R = "))).section(QLatin1Char('\n'), 0, 0);
                    return line.section(QLatin1Char(' '), -1);
                };
                QCOMPARE(red(parts[0]), mean(wrong.image.pixel(x, y)));
                QCOMPARE(red(parts[1]), mean(right.image.pixel(x, y)));
            }
        QVERIFY(found);
    }
}

QTEST_MAIN(TestSampleViews)
#include "test_sample_views.moc"
