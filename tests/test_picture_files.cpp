// Pictures as files: what a TGA's palette says, and the gamma and profiles that are named and not applied.
#include "core/io/color_tags.h"
#include "core/io/texture_loader.h"
#include "core/io/tga.h"

#include <QBuffer>
#include <QColorSpace>
#include <QTest>
#include <QtEndian>

using namespace rasterlens;

namespace
{

/// A TGA of one row whose pixels are indices of 8 or 16 bits into a palette of 24 bits.
QByteArray paletteTga(int first, const QByteArray& palette, int bits, const QByteArray& indices)
{
    QByteArray file(18, '\0');
    file[1] = 1;
    file[2] = 1;
    file[3] = static_cast<char>(first & 255);
    file[4] = static_cast<char>(first >> 8);
    file[5] = static_cast<char>(palette.size() / 3);
    file[7] = 24;
    file[12] = static_cast<char>(indices.size() * 8 / bits);
    file[14] = 1;
    file[16] = static_cast<char>(bits);
    return file + palette + indices;
}

QByteArray chunk(const QByteArray& type, const QByteArray& data)
{
    QByteArray bytes(4, '\0');
    qToBigEndian(static_cast<quint32>(data.size()), bytes.data());
    return bytes + type + data + QByteArray(4, '\0'); // nothing here reads the check sum
}

/// A PNG with these chunks before its pixels.
QByteArray pngWith(const QByteArray& chunks)
{
    QImage image(1, 1, QImage::Format_RGB32);
    image.fill(Qt::red);
    QByteArray file;
    QBuffer buffer(&file);
    image.save(&buffer, "PNG");
    return file.insert(file.indexOf("IDAT") - 4, chunks);
}

QString wordsOf(const QByteArray& file)
{
    const auto remark = colorTagRemark(file);
    return remark ? textOf(*remark) : QString();
}

} // namespace

class TestPictureFiles : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void paletteOfATgaBeginsAtItsFirstIndex();
    void everyFormatKeepsItsTransparency();
    void gammaOfAPng();
    void profiles();
    void gammaOfATga();
    void brokenFilesHaveNoRemark();
};

void TestPictureFiles::paletteOfATgaBeginsAtItsFirstIndex()
{
    const QByteArray blueRed("\xff\0\0\0\0\xff", 6);
    for (const int first : {0, 1, 3, 250}) {
        QByteArray indices;
        for (const int index : {first, first + 1, first})
            indices.append(static_cast<char>(index));
        const TgaImage tga = readTga(paletteTga(first, blueRed, 8, indices));
        QVERIFY(!tga.problem);
        QCOMPARE(tga.image.pixel(0, 0), qRgb(0, 0, 255));
        QCOMPARE(tga.image.pixel(1, 0), qRgb(255, 0, 0));
        QCOMPARE(tga.image.pixel(2, 0), qRgb(0, 0, 255));
    }
    const TgaImage wide = readTga(paletteTga(1000, blueRed, 16, QByteArray("\xe9\x03\xe8\x03", 4)));
    QCOMPARE(wide.image.pixel(0, 0), qRgb(255, 0, 0));
    QCOMPARE(wide.image.pixel(1, 0), qRgb(0, 0, 255));
    const TgaImage outside = readTga(paletteTga(3, blueRed, 8, QByteArray("\x02\x05\0", 3)));
    for (int x = 0; x < 3; ++x)
        QCOMPARE(outside.image.pixel(x, 0), qRgb(0, 0, 0));
}

void TestPictureFiles::everyFormatKeepsItsTransparency()
{
    QImage image(2, 1, QImage::Format_ARGB32);
    image.setPixel(0, 0, qRgba(1, 2, 3, 0));
    image.setPixel(1, 0, qRgba(4, 5, 6, 7));
    QByteArray file;
    QBuffer buffer(&file);
    QVERIFY(image.save(&buffer, "PNG"));
    const PictureLoad load = pictureFrom(file, QStringLiteral("a.png"));
    QVERIFY(!load.problem && load.image.hasAlphaChannel());
    QCOMPARE(load.image.pixel(0, 0), qRgba(1, 2, 3, 0));
    QVERIFY(pictureFrom("text", QStringLiteral("a.png")).problem);
    QVERIFY(pictureFrom(QByteArray(18, '\0'), QStringLiteral("a.TGA")).problem);
}

void TestPictureFiles::gammaOfAPng()
{
    const QString stored = QStringLiteral(", which is not applied: its colours are taken as they are stored");
    QCOMPARE(wordsOf(pngWith({})), QString());
    QCOMPARE(wordsOf(pngWith(chunk("gAMA", QByteArray("\0\1\x86\xa0", 4)))),
             QStringLiteral("the picture carries a gamma of 1") + stored);
    QCOMPARE(wordsOf(pngWith(chunk("gAMA", QByteArray("\0\0\xb1\x8f", 4)))),
             QStringLiteral("the picture carries a gamma of 0.45455") + stored);
    // sRGB says what the colours are taken for anyway, and has the last word about gAMA.
    QCOMPARE(wordsOf(pngWith(chunk("sRGB", QByteArray(1, '\0')) + chunk("gAMA", QByteArray("\0\0\xb1\x8f", 4)))),
             QString());
    QCOMPARE(wordsOf(pngWith(chunk("gAMA", QByteArray("\0\0\xb1\x8f", 4)) + chunk("sRGB", QByteArray(1, '\0')))),
             QString());
    QCOMPARE(wordsOf(pngWith(chunk("tEXt", "gAMA"))), QString());
}

void TestPictureFiles::profiles()
{
    QVERIFY(wordsOf(pngWith(chunk("gAMA", QByteArray("\0\0\xb1\x8f", 4)) + chunk("iCCP", QByteArray("Wide\0\0x", 7))))
                .startsWith(QLatin1String("the picture carries the colour profile \"Wide\"")));
    QImage image(1, 1, QImage::Format_RGB32);
    image.fill(Qt::red);
    for (const bool tagged : {false, true}) {
        if (tagged)
            image.setColorSpace(QColorSpace(QColorSpace::AdobeRgb));
        QByteArray file;
        QBuffer buffer(&file);
        QVERIFY(image.save(&buffer, "JPEG"));
        QVERIFY2(wordsOf(file).startsWith(QLatin1String("the picture carries the colour profile \"")) == tagged,
                 qPrintable(wordsOf(file)));
    }
}

void TestPictureFiles::gammaOfATga()
{
    QByteArray file(18, '\0');
    file[2] = 3;
    file[12] = 1;
    file[14] = 1;
    file[16] = 8;
    file += '\x7f';
    const auto at = static_cast<char>(file.size());
    QByteArray extension(495, '\0');
    const QByteArray footer = QByteArray(1, at) + QByteArray(7, '\0') + QByteArray("TRUEVISION-XFILE.\0", 18);
    QCOMPARE(wordsOf(file + extension + footer), QString());
    extension[478] = 22;
    extension[480] = 10;
    QVERIFY(wordsOf(file + extension + footer).startsWith(QLatin1String("the picture carries a gamma of 2.2,")));
    extension[478] = 10;
    QCOMPARE(wordsOf(file + extension + footer), QString());
    QVERIFY(!pictureFrom(file + extension + footer, QStringLiteral("a.tga")).problem);
}

void TestPictureFiles::brokenFilesHaveNoRemark()
{
    QCOMPARE(wordsOf({}), QString());
    QCOMPARE(wordsOf("\x89PNG\r\n\x1a\n"), QString());
    QCOMPARE(wordsOf(QByteArray("\x89PNG\r\n\x1a\n\xff\xff\xff\xffgAMA\0\0\0\0", 20)), QString());
    QCOMPARE(wordsOf("\xff\xd8"), QString());
    QCOMPARE(wordsOf(QByteArray("\xff\xd8\xff\xe2\0\0ICC", 9)), QString());
    QCOMPARE(wordsOf(QByteArray("\xff\xff\xff\xff\0\0\0\0TRUEVISION-XFILE.\0", 26) + QByteArray(40, '\0')), QString());
    QCOMPARE(wordsOf(QByteArray(40, '\0') + QByteArray("\xff\xff\xff\xff\0\0\0\0TRUEVISION-XFILE.\0", 26)), QString());
}

QTEST_GUILESS_MAIN(TestPictureFiles)
#include "test_picture_files.moc"
