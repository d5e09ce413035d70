#pragma once
// Pictures as they come from elsewhere: with noise, with a border, moved, on another background; and as bytes of files
// that Qt does not write.
#include <QByteArray>
#include <QImage>
#include <QString>

#include <random>

namespace rasterlens::test
{

/// Two pixels of a hundred have any colour.
inline QImage withNoise(QImage image)
{
    std::mt19937 random(7);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if (random() % 100 < 2)
                image.setPixel(x, y, 0xff000000U | (random() & 0xffffffU));
    return image;
}

/// In the middle of an area twice as wide and high.
inline QImage withBorder(const QImage& image)
{
    QImage large(image.size() * 2, QImage::Format_RGB32);
    large.fill(qRgb(200, 210, 220));
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            large.setPixel(x + image.width() / 2, y + image.height() / 2, image.pixel(x, y));
    return large;
}

/// At half the size, in the middle of an area of the full size.
inline QImage halfWithBorder(const QImage& image)
{
    QImage large(image.size(), QImage::Format_RGB32);
    large.fill(qRgb(250, 250, 250));
    const QImage half = image.scaled(image.size() / 2, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    for (int y = 0; y < half.height(); ++y)
        for (int x = 0; x < half.width(); ++x)
            large.setPixel(x + (large.width() - half.width()) / 2, y + (large.height() - half.height()) / 2,
                           half.pixel(x, y));
    return large;
}

inline QImage oneRowDown(const QImage& image, QRgb background)
{
    QImage moved(image.size(), QImage::Format_RGB32);
    moved.fill(background);
    for (int y = 1; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            moved.setPixel(x, y, image.pixel(x, y - 1));
    return moved;
}

inline QImage onWhite(QImage image, QRgb background)
{
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            if ((image.pixel(x, y) & 0xffffffU) == (background & 0xffffffU))
                image.setPixel(x, y, qRgb(255, 255, 255));
    return image;
}

inline QByteArray tgaBytes(const QImage& image)
{
    QByteArray bytes(18, '\0');
    bytes[2] = 2; // colours as they are
    bytes[12] = char(image.width() & 255);
    bytes[13] = char(image.width() >> 8);
    bytes[14] = char(image.height() & 255);
    bytes[15] = char(image.height() >> 8);
    bytes[16] = 24;
    bytes[17] = 0x20; // the top row first
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            const QRgb pixel = image.pixel(x, y);
            for (const int channel : {qBlue(pixel), qGreen(pixel), qRed(pixel)})
                bytes.append(char(channel));
        }
    return bytes;
}

inline QByteArray npyOf(const QImage& image)
{
    QByteArray header = QStringLiteral("{'descr': '|u1', 'fortran_order': False, 'shape': (%1, %2, 3), }")
                            .arg(image.height())
                            .arg(image.width())
                            .toLatin1();
    header.append(QByteArray(63 - (10 + header.size()) % 64, ' ')).append('\n');
    QByteArray bytes("\x93NUMPY\x01\x00", 8);
    bytes.append(char(header.size() & 255)).append(char(header.size() >> 8)).append(header);
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            for (const int channel : {qRed(image.pixel(x, y)), qGreen(image.pixel(x, y)), qBlue(image.pixel(x, y))})
                bytes.append(char(channel));
    return bytes;
}

} // namespace rasterlens::test
