#include "core/io/picture_file.h"

#include "core/io/file_writer.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImageWriter>

namespace rasterlens
{

const QStringList& pictureSuffixes()
{
    static const QStringList suffixes{QStringLiteral("png"), QStringLiteral("ppm"), QStringLiteral("bmp"),
                                      QStringLiteral("jpg"), QStringLiteral("jpeg")};
    return suffixes;
}

QString formatOf(const QString& path, const QString& fallback)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    return suffix.isEmpty() || isStream(path) ? fallback : suffix;
}

std::optional<Reason> whyNotFormat(const QString& path, const QStringList& formats)
{
    const QString format = formatOf(path, formats.first());
    if (formats.contains(format))
        return std::nullopt;
    return Reason(QT_TRANSLATE_NOOP("Diagnostic", "\"%1\" is not a format pictures are written in, which are: %2"),
                  {format, formats.join(QStringLiteral(", "))});
}

PictureBytes pictureBytes(const QImage& image, const QString& format)
{
    constexpr int kJpegQuality = 95;
    if (image.isNull())
        return {{}, QT_TRANSLATE_NOOP("Diagnostic", "the picture is empty or too large")};
    PictureBytes picture;
    QBuffer buffer(&picture.bytes);
    QImageWriter writer(&buffer, format.toLatin1());
    if (format.startsWith(QLatin1String("jp")))
        writer.setQuality(kJpegQuality);
    if (!writer.write(image))
        picture.problem = Reason(QT_TRANSLATE_NOOP("Diagnostic", "the picture cannot be made a %1: %2"),
                                 {format, writer.errorString()});
    return picture;
}

} // namespace rasterlens
