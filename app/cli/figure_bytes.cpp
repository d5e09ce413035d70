#include "app/cli/figure_bytes.h"

#include "app/cli/output.h"

#include <QBuffer>
#include <QGuiApplication>
#include <QSvgGenerator>

namespace rasterlens::cli
{

QByteArray figureBytes(const QByteArray& format, QSize size, const QString& title,
                       const std::function<void(QPainter&)>& paint)
{
    char program[] = "rasterlens-cli";
    char option[] = "-platform";
    char platform[] = "offscreen";
    char* words[] = {program, option, platform, nullptr};
    int count = 3;
    const QGuiApplication application(count, words);

    const auto paintOn = [&](QPaintDevice& device) {
        constexpr int kFontPixels = 13;
        QPainter painter(&device);
        QFont font = QGuiApplication::font();
        font.setPixelSize(kFontPixels);
        painter.setFont(font);
        painter.setRenderHint(QPainter::Antialiasing);
        paint(painter);
    };
    if (format == "svg") {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        QSvgGenerator svg;
        svg.setOutputDevice(&buffer);
        svg.setSize(size);
        svg.setViewBox(QRect({0, 0}, size));
        svg.setTitle(title);
        paintOn(svg);
        return bytes;
    }
    QImage image(size, QImage::Format_RGB32);
    paintOn(image);
    return imageBytes(image, format);
}

} // namespace rasterlens::cli
