// What is told of multi-sampling: why a pixel is what it is, the scenes of its mistakes, the chart, and what cannot be
// drawn.
#include "core/questions/why.h"
#include "core/settings/mistakes.h"
#include "core/truth/coverage_chart.h"
#include "core/truth/mistake_proof.h"
#include "tests/support.h"

#include <QTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

Settings settingsWith(Samples samples, QSize size)
{
    Settings settings = plainSettings(size);
    settings.samples = samples;
    return settings;
}

/// A rectangle of two triangles that share its diagonal, in pixels, with colours by corner.
Scene rectangle(glm::dvec2 from, glm::dvec2 to, QSize size, double depth = 0.5)
{
    return clipScene({atPixel(from.x, from.y, depth, size), atPixel(from.x, to.y, depth, size),
                      atPixel(to.x, to.y, depth, size), atPixel(to.x, from.y, depth, size)},
                     {0, 1, 2, 2, 3, 0});
}

} // namespace

class TestMultisampleAnswers : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void whyNamesTheMask();
    void scenesShowTheirMistakes();
    void areasAreThoseOfPolygons();
    void refusalsSayWhy_data();
    void refusalsSayWhy();
};

/// A face that covers the third sample of a pixel alone.
void TestMultisampleAnswers::whyNamesTheMask()
{
    const QSize size(4, 4);
    const Scene scene = rectangle({0, 0}, {2.25, 4}, size);
    for (const Algorithm algorithm : {Algorithm::EdgeEquation, Algorithm::EdgeWalking}) {
        Settings settings = settingsWith(Samples::Msaa4, size);
        settings.algorithm = algorithm;
        const WhyReport report = why(scene, settings, 2, 0);
        const WhyFace* face = report.find(1); // the upper right half
        QVERIFY(face != nullptr);
        QCOMPARE(int(face->coveredSamples), 0b0100);
        QCOMPARE(face->verdict, WhyVerdict::OutsideEdge); // the rows are about the first sample
        QVERIFY2(whyText(report, *face).contains(QLatin1String("covers 1 of 4 samples: 3")),
                 qPrintable(whyText(report, *face)));
        QVERIFY(!report.visibleFace);
        QCOMPARE(report.samples->count, 4);
        const WhyReport whole = why(scene, settings, 1, 0);
        QCOMPARE(int(whole.find(1)->coveredSamples), 0b1111);
        QCOMPARE(whole.find(1)->verdict, WhyVerdict::Written);
        QCOMPARE(whole.visibleFace.value(), 1U);
    }
}

void TestMultisampleAnswers::scenesShowTheirMistakes()
{
    const auto pictures = [](const char* id) {
        const MistakeDemo demo = mistakeDemo(*findMistake(QLatin1String(id)));
        return std::pair(draw(demo.scene, demo.right), draw(demo.scene, demo.mistaken));
    };
    const auto count = [](const QImage& image, auto holds) {
        int n = 0;
        for (int y = 0; y < image.height(); ++y)
            for (int x = 0; x < image.width(); ++x)
                n += holds(image.pixel(x, y)) ? 1 : 0;
        return n;
    };
    // magenta has red, which neither the sprite nor the background has
    const auto isMagenta = [](QRgb color) { return qRed(color) > qGreen(color); };
    const auto [sprite, dots] = pictures("centre-outside");
    QCOMPARE(count(sprite.image, isMagenta), 0);
    QVERIFY(count(dots.image, isMagenta) > 60);
    // yellow inside the disc, the background outside, and a mean on the rim alone: some 2 pi 28 pixels
    const auto isMixed = [](QRgb color) { return color != 0xffffff00 && color != 0xff141f40; };
    const auto [disc, seams] = pictures("resolved-by-face");
    QVERIFY2(count(disc.image, isMixed) < 240, qPrintable(QString::number(count(disc.image, isMixed))));
    QVERIFY2(count(seams.image, isMixed) > 2 * count(disc.image, isMixed),
             qPrintable(QString::number(count(seams.image, isMixed))));
    // grey, and a mean with black at the two slanted borders alone
    const auto isUneven = [](QRgb color) { return color != 0xff808080 && color != 0xff000000; };
    const auto [grey, dotted] = pictures("centroid-gradient");
    QVERIFY2(count(grey.image, isUneven) < 200, qPrintable(QString::number(count(grey.image, isUneven))));
    QVERIFY2(count(dotted.image, isUneven) > 1500, qPrintable(QString::number(count(dotted.image, isUneven))));
}

/// A rectangle's area in a pixel is the product of what it has of each axis; an edge at x.25 leaves a quarter.
void TestMultisampleAnswers::areasAreThoseOfPolygons()
{
    const QSize size(16, 8);
    const Scene scene = rectangle({2.25, 1.5}, {12.75, 6}, size);
    const std::vector<double> areas = coveredAreas(scene, plainSettings(size));
    const auto part = [](double low, double high, int i) {
        return std::max(0.0, std::min(high, i + 1.0) - std::max(low, double(i)));
    };
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 16; ++x)
            QVERIFY(std::abs(areas[std::size_t(16 * y + x)] - part(2.25, 12.75, x) * part(1.5, 6, y)) < 1e-12);
    // One sample at the centre against 9 half pixels above, 4 of 3/4 at either side and 2 of 3/8 in the corners.
    const std::vector<CoverageRow> rows = coverageChart(scene, plainSettings(size));
    QCOMPARE(rows.size(), std::size_t(8));
    QCOMPARE(rows[0].samples, Samples::One);
    QCOMPARE(rows[0].pixels, std::uint64_t(9 + 2 * 4 + 2));
    QVERIFY(std::abs(rows[0].largest - 0.625) < 1e-12);
    // A grid of 4 x 4 tells quarters and halves exactly.
    QCOMPARE(rows[3].samples, Samples::Grid4);
    QVERIFY(rows[3].largest < 1e-12);
    QVERIFY(rows[7].rms < rows[5].rms && rows[5].rms < rows[4].rms && rows[4].rms < rows[0].rms);
}

void TestMultisampleAnswers::refusalsSayWhy_data()
{
    QTest::addColumn<QString>("field");
    QTest::addColumn<QString>("value");
    QTest::addColumn<QString>("word");
    QTest::newRow("lines") << "fill"
                           << "wireframe"
                           << "fill solid";
    QTest::newRow("points") << "fill"
                            << "points"
                            << "fill solid";
    QTest::newRow("columns") << "algorithm"
                             << "column-fill"
                             << "column-fill";
    QTest::newRow("masks of tiled") << "attribute-at"
                                    << "centroid"
                                    << "attribute-at centre";
    QTest::newRow("spans") << "attribute-path"
                           << "edge-then-span"
                           << "attribute-path planes";
}

void TestMultisampleAnswers::refusalsSayWhy()
{
    QFETCH(QString, field);
    QFETCH(QString, value);
    QFETCH(QString, word);
    const Scene scene = rectangle({0, 0}, {2, 2}, QSize(64, 48));
    Settings settings = settingsWith(Samples::Msaa8, QSize(64, 48));
    if (field == QLatin1String("attribute-path"))
        settings.algorithm = Algorithm::EdgeWalking;
    if (field == QLatin1String("attribute-at"))
        settings.algorithm = Algorithm::Tiled;
    QVERIFY(!setFromText(*findSettingsField(field), value, settings));
    const auto reason = unsupported(scene, settings);
    QVERIFY(reason);
    QVERIFY2(textOf(*reason).contains(word), qPrintable(textOf(*reason)));
    settings.samples = Samples::Grid2;
    QVERIFY(!unsupported(scene, settings));
}

QTEST_APPLESS_MAIN(TestMultisampleAnswers)
#include "test_multisample_answers.moc"
