// Animated GIF: what is written is what another program reads.
#include "core/io/gif_writer.h"
#include "core/io/palette.h"
#include "tests/seed.h"

#include <QBuffer>
#include <QImageReader>
#include <QTest>

#include <random>
#include <set>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

/// The pictures of an animation, as Qt reads them.
std::vector<QImage> readGif(QByteArray bytes, std::vector<int>* milliseconds = nullptr)
{
    QBuffer buffer(&bytes);
    QImageReader reader(&buffer, "gif");
    std::vector<QImage> pictures;
    while (reader.canRead()) {
        const QImage picture = reader.read();
        if (picture.isNull())
            break;
        pictures.push_back(picture.convertToFormat(QImage::Format_RGB32));
        if (milliseconds)
            milliseconds->push_back(reader.nextImageDelay());
    }
    return pictures;
}

std::set<QRgb> colorsOf(const QImage& picture)
{
    std::set<QRgb> colors;
    for (int y = 0; y < picture.height(); ++y)
        for (int x = 0; x < picture.width(); ++x)
            colors.insert(picture.pixel(x, y));
    return colors;
}

QImage noise(QSize size, int colors, std::mt19937& random)
{
    std::vector<QRgb> palette;
    for (int i = 0; i < colors; ++i)
        palette.push_back(0xff000000U | static_cast<QRgb>(random()));
    QImage picture(size, QImage::Format_RGB32);
    for (int y = 0; y < size.height(); ++y)
        for (int x = 0; x < size.width(); ++x)
            picture.setPixel(x, y, palette[random() % palette.size()]);
    return picture;
}

QImage gradient(QSize size)
{
    QImage picture(size, QImage::Format_RGB32);
    for (int y = 0; y < size.height(); ++y)
        for (int x = 0; x < size.width(); ++x)
            picture.setPixel(x, y, qRgb(255 * x / size.width(), 255 * y / size.height(), 128));
    return picture;
}

int largestError(const QImage& a, const QImage& b)
{
    int error = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x) {
            const QRgb p = a.pixel(x, y);
            const QRgb q = b.pixel(x, y);
            error = std::max(
                {error, std::abs(qRed(p) - qRed(q)), std::abs(qGreen(p) - qGreen(q)), std::abs(qBlue(p) - qBlue(q))});
        }
    return error;
}

} // namespace

class TestGif : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void fewColorsStay()
    {
        std::mt19937 random(seedOfRun());
        for (const int colors : {1, 2, 3, 17, 255, 256}) {
            const QImage picture = noise({61, 47}, colors, random);
            const QImage indexed = withPalette(picture);
            QCOMPARE(indexed.format(), QImage::Format_Indexed8);
            QCOMPARE(indexed.convertToFormat(QImage::Format_RGB32), picture);
        }
    }

    void manyColorsComeNear()
    {
        const QImage picture = gradient({200, 160});
        const QImage indexed = withPalette(picture).convertToFormat(QImage::Format_RGB32);
        QVERIFY(colorsOf(picture).size() > 10000);
        QVERIFY(colorsOf(indexed).size() <= 256);
        QVERIFY(colorsOf(indexed).size() > 200);
        QVERIFY2(largestError(picture, indexed) <= 12, qPrintable(QString::number(largestError(picture, indexed))));
        QCOMPARE(colorsOf(withPalette(picture, 8).convertToFormat(QImage::Format_RGB32)).size(), std::size_t(8));
        QVERIFY(withPalette(QImage()).isNull());
    }

    void picturesComeBack()
    {
        std::mt19937 random(seedOfRun());
        std::vector<QImage> pictures{noise({90, 70}, 200, random)};
        for (int i = 0; i < 12; ++i) { // parts change: one pixel, rows, nothing, all
            QImage next = pictures.back();
            const int width = i % 4 == 3 ? 0 : 1 + static_cast<int>(random() % 90);
            const int height = 1 + static_cast<int>(random() % 70);
            const int left = static_cast<int>(random() % 90);
            const int top = static_cast<int>(random() % 70);
            for (int y = top; y < std::min(70, top + height); ++y)
                for (int x = left; x < std::min(90, left + width); ++x)
                    next.setPixel(x, y, 0xff000000U | (static_cast<QRgb>(random()) & 0xc0c0c0U));
            pictures.push_back(next);
        }
        GifWriter gif({90, 70}, 120);
        for (const QImage& picture : pictures)
            QVERIFY(!gif.add(picture));
        const GifWriter::Finished file = gif.finish();
        QVERIFY(!file.problem);
        std::vector<int> times;
        const std::vector<QImage> read = readGif(file.bytes, &times);
        QCOMPARE(read.size(), pictures.size());
        for (std::size_t i = 0; i < read.size(); ++i) {
            QCOMPARE(read[i], pictures[i]);
            QCOMPARE(times[i], 120);
        }
        QVERIFY(file.bytes.contains("NETSCAPE2.0"));
        QVERIFY(file.bytes.startsWith("GIF89a"));
    }

    void onePixelIsAnAnimation()
    {
        GifWriter gif({1, 1}, 20);
        QImage pixel(1, 1, QImage::Format_RGB32);
        pixel.fill(0x123456);
        QVERIFY(!gif.add(pixel));
        const std::vector<QImage> read = readGif(gif.finish().bytes);
        QCOMPARE(read.size(), std::size_t(1));
        QCOMPARE(read[0].pixel(0, 0), qRgb(0x12, 0x34, 0x56));
    }

    void onlyChangesAreStored()
    {
        std::mt19937 random(seedOfRun());
        QImage picture = noise({300, 300}, 256, random);
        GifWriter once({300, 300}, 100);
        QVERIFY(!once.add(picture));
        const qsizetype one = once.finish().bytes.size();
        GifWriter often({300, 300}, 100);
        for (int i = 0; i < 100; ++i) {
            picture.setPixel(i, i, 0xff000000U | static_cast<QRgb>(i));
            QVERIFY(!often.add(picture));
        }
        QVERIFY(often.finish().bytes.size() < one + 100 * 64);
    }

    void unusablePicturesAreRefused()
    {
        GifWriter gif({4, 4}, 100);
        QVERIFY(gif.add(QImage()));
        QVERIFY(gif.add(QImage(5, 4, QImage::Format_RGB32)));
        QImage wide(GifWriter::kMostSide + 1, 1, QImage::Format_RGB32);
        wide.fill(Qt::red);
        GifWriter large(wide.size(), 100);
        const auto problem = large.add(wide);
        QVERIFY(problem);
        QVERIFY2(textOf(*problem).contains(QStringLiteral("too large")), qPrintable(textOf(*problem)));
    }

    void animationsEnd()
    {
        QImage picture(2, 2, QImage::Format_RGB32);
        picture.fill(Qt::blue);
        GifWriter gif(picture.size(), 20);
        for (int i = 0; i < GifWriter::kMostPictures; ++i)
            QVERIFY(!gif.add(picture));
        const auto problem = gif.add(picture);
        QVERIFY(problem);
        QCOMPARE(textOf(*problem), QStringLiteral("an animation has at most 5000 pictures"));
    }
};

QTEST_GUILESS_MAIN(TestGif)
#include "test_gif.moc"
