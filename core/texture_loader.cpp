#include "core/texture_loader.h"

#include <QFileInfo>
#include <QImage>
#include <QImageReader>

#include <cstring>

namespace rasterlens
{
namespace
{

constexpr int kMostTexels = 16384;

/// Why an image of that size is not read; empty if it is. The size comes from the file's header.
QString sizeProblem(QSize size)
{
    if (!size.isValid())
        return {};
    if (size.isEmpty())
        return QStringLiteral("the image is empty");
    if (size.width() > kMostTexels || size.height() > kMostTexels)
        return QStringLiteral("the image has %1 x %2 texels; at most %3 x %3 are read")
            .arg(size.width())
            .arg(size.height())
            .arg(kMostTexels);
    const int limitMegabytes = QImageReader::allocationLimit();
    const qint64 megabytes = (qint64{4} * size.width() * size.height()) >> 20;
    if (limitMegabytes > 0 && megabytes >= limitMegabytes)
        return QStringLiteral("the image has %1 x %2 texels and would take %3 MB; at most %4 MB are read")
            .arg(size.width())
            .arg(size.height())
            .arg(megabytes)
            .arg(limitMegabytes);
    return {};
}

QString readProblem(const QImageReader& reader, const QString& path)
{
    const QString suffix = QFileInfo(path).suffix().toLower();
    const bool known = suffix.isEmpty() || QImageReader::supportedImageFormats().contains(suffix.toLatin1());
    QString problem = QStringLiteral("the image cannot be read: %1").arg(reader.errorString());
    if (!known)
        problem += QStringLiteral(" (no Qt plugin for .%1 is installed; see qt6-image-formats-plugins)").arg(suffix);
    return problem;
}

Texture textureOf(const QImage& image, const QString& path)
{
    const QImage rgb = image.convertToFormat(QImage::Format_RGB32);
    Texture texture{QFileInfo(path).fileName(), rgb.width(), rgb.height(), {}};
    const auto width = static_cast<std::size_t>(rgb.width());
    texture.texels.resize(width * static_cast<std::size_t>(rgb.height()));
    for (int y = 0; y < rgb.height(); ++y)
        std::memcpy(texture.texels.data() + width * static_cast<std::size_t>(rgb.height() - 1 - y),
                    rgb.constScanLine(y), width * sizeof(std::uint32_t));
    for (std::uint32_t& texel : texture.texels)
        texel |= 0xff000000U;
    return texture;
}

} // namespace

TextureLoad loadTexture(const QString& path)
{
    const QFileInfo info(path);
    if (!info.exists())
        return {std::nullopt, QStringLiteral("there is no such file")};
    if (info.isDir())
        return {std::nullopt, QStringLiteral("this is a directory; an image is expected")};
    if (info.size() == 0)
        return {std::nullopt, QStringLiteral("the file is empty")};
    QImageReader reader(path);
    if (const QString problem = sizeProblem(reader.size()); !problem.isEmpty())
        return {std::nullopt, problem};
    const QImage image = reader.read();
    if (image.isNull())
        return {std::nullopt, readProblem(reader, path)};
    return {textureOf(image, path), {}};
}

} // namespace rasterlens
