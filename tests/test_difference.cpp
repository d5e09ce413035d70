// The distance of two pictures, on pictures small enough to work it out by hand.
#include "core/truth/difference.h"

#include <QTest>

#include <cmath>
#include <limits>

using namespace rasterlens;

class TestDifference : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void equalPictures();
    void handMadePictures();
    void orderDoesNotMatter();
    void formatAndAlphaDoNotMatter();
    void heatScaleGrowsLighter();
    void heatMapShowsTheClassOfEachPixel();
};

namespace
{

QImage filled(int width, int height, QRgb color)
{
    QImage image(width, height, QImage::Format_RGB32);
    image.fill(color);
    return image;
}

} // namespace

void TestDifference::equalPictures()
{
    const QImage image = filled(5, 3, qRgb(10, 20, 30));
    const Difference none = difference(image, image);
    QVERIFY(none == (Difference{15, 0, 0, 0, std::numeric_limits<double>::infinity()}));
}

void TestDifference::handMadePictures()
{
    const QImage a = filled(2, 2, qRgb(100, 100, 100));
    QImage b = a;
    b.setPixel(0, 0, qRgb(101, 100, 98));
    b.setPixel(1, 1, qRgb(100, 109, 100));
    const Difference found = difference(a, b);
    QCOMPARE(found.pixels, 4U);
    QCOMPARE(found.differing, 2U);
    QCOMPARE(found.max, 9);
    QCOMPARE(found.mean, 1.0); // (1 + 2 + 9) / 12 channels
    QCOMPARE(found.psnrDb, 10 * std::log10(65025.0 * 12 / (1 + 4 + 81)));

    const Difference opposite = difference(filled(1, 1, qRgb(0, 0, 0)), filled(1, 1, qRgb(255, 255, 255)));
    QVERIFY(opposite == (Difference{1, 1, 255, 255, 0}));
}

void TestDifference::orderDoesNotMatter()
{
    const QImage a = filled(2, 1, qRgb(7, 0, 0));
    const QImage b = filled(2, 1, qRgb(0, 200, 3));
    QVERIFY(difference(a, b) == difference(b, a));
}

void TestDifference::formatAndAlphaDoNotMatter()
{
    QImage transparent(2, 2, QImage::Format_ARGB32);
    transparent.fill(qRgba(10, 20, 30, 0));
    QCOMPARE(difference(transparent, filled(2, 2, qRgb(10, 20, 30))).differing, 0U);
    const QImage grey = filled(2, 2, qRgb(9, 9, 9)).convertToFormat(QImage::Format_Grayscale8);
    QCOMPARE(difference(grey, filled(2, 2, qRgb(9, 9, 9))).differing, 0U);
}

void TestDifference::heatScaleGrowsLighter()
{
    QCOMPARE(heatScale().front().steps, 1);
    for (std::size_t i = 1; i < heatScale().size(); ++i) {
        QCOMPARE(heatScale()[i].steps, 2 * heatScale()[i - 1].steps);
        QVERIFY(qGray(heatScale()[i].color) > qGray(heatScale()[i - 1].color));
    }
    QVERIFY2(qGray(heatScale().front().color) > 255 / 4,
             "the smallest difference stands out from the grey of equal pixels");
}

void TestDifference::heatMapShowsTheClassOfEachPixel()
{
    const QImage a = filled(256, 1, qRgb(0, 0, 0));
    QImage b = a;
    for (int x = 0; x < 256; ++x)
        b.setPixel(x, 0, qRgb(0, x, x / 2));
    const QImage heat = heatMap(a, b);
    QCOMPARE(heat.format(), QImage::Format_RGB32);
    QCOMPARE(heat.pixel(0, 0), qRgb(0, 0, 0));
    for (const HeatClass& heatClass : heatScale()) {
        QCOMPARE(heat.pixel(heatClass.steps, 0), heatClass.color);
        QCOMPARE(heat.pixel(2 * heatClass.steps - 1, 0), heatClass.color);
    }
    QCOMPARE(heatMap(filled(1, 1, qRgb(255, 255, 255)), filled(1, 1, qRgb(255, 255, 255))).pixel(0, 0),
             qRgb(63, 63, 63));
}

QTEST_APPLESS_MAIN(TestDifference)
#include "test_difference.moc"
