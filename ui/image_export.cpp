#include "ui/image_export.h"

#include <QCoreApplication>
#include <QSaveFile>

namespace rasterlens
{

std::optional<QString> savePng(const QImage& image, const QString& path)
{
    const auto failed = [&](const QString& why) {
        return QCoreApplication::translate("ImageExport", "%1 could not be written: %2").arg(path, why);
    };
    if (image.isNull())
        return failed(QCoreApplication::translate("ImageExport", "the picture is empty or too large."));
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly))
        return failed(file.errorString());
    if (!image.save(&file, "PNG")) {
        file.cancelWriting();
        return failed(file.errorString());
    }
    if (!file.commit())
        return failed(file.errorString());
    return std::nullopt;
}

} // namespace rasterlens
