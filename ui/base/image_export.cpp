#include "ui/base/image_export.h"

#include <QCoreApplication>
#include <QPainter>
#include <QSaveFile>
#include <QSvgGenerator>

namespace rasterlens
{

namespace
{

template <class Write>
std::optional<QString> saveWhole(const QString& path, bool isEmpty, Write&& write)
{
    const auto failed = [&](const QString& why) {
        return QCoreApplication::translate("ImageExport", "%1 could not be written: %2").arg(path, why);
    };
    if (isEmpty)
        return failed(QCoreApplication::translate("ImageExport", "the picture is empty or too large."));
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return failed(file.errorString());
    if (!write(file)) {
        file.cancelWriting();
        return failed(file.errorString());
    }
    if (!file.commit())
        return failed(file.errorString());
    return std::nullopt;
}

} // namespace

std::optional<QString> savePng(const QImage& image, const QString& path)
{
    return saveWhole(path, image.isNull(), [&](QIODevice& file) { return image.save(&file, "PNG"); });
}

std::optional<QString> saveSvg(QSize size, const QString& path, const std::function<void(QPainter&)>& paint)
{
    return saveWhole(path, size.isEmpty(), [&](QIODevice& file) {
        QSvgGenerator drawing;
        drawing.setOutputDevice(&file);
        drawing.setSize(size);
        drawing.setViewBox(QRect(QPoint(0, 0), size));
        drawing.setTitle(QStringLiteral("RasterLens"));
        QPainter painter;
        if (!painter.begin(&drawing))
            return false;
        paint(painter);
        return painter.end();
    });
}

} // namespace rasterlens
