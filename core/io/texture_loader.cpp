#include "core/io/texture_loader.h"

#include "core/io/text_input.h"
#include "core/io/tga.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImage>
#include <QImageReader>

#include <cstring>

namespace rasterlens
{
namespace
{

constexpr int kMostTexels = 16384;

/// Why an image of that size is not read, or nothing. The size comes from the file's header.
std::optional<Reason> sizeProblem(QSize size)
{
    if (!size.isValid())
        return {};
    if (size.isEmpty())
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "the image is empty"));
    if (size.width() > kMostTexels || size.height() > kMostTexels)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "the image has %1 x %2 texels; at most %3 x %3 are read"),
                      {size.width(), size.height(), kMostTexels});
    const int limitMegabytes = QImageReader::allocationLimit();
    const qint64 megabytes = (qint64{4} * size.width() * size.height()) >> 20;
    if (limitMegabytes > 0 && megabytes >= limitMegabytes)
        return Reason(QT_TRANSLATE_NOOP("Diagnostic",
                                        "the image has %1 x %2 texels and would take %3 MB; at most %4 MB are read"),
                      {size.width(), size.height(), megabytes, limitMegabytes});
    return {};
}

bool isTga(const QString& path) { return path.endsWith(QLatin1String(".tga"), Qt::CaseInsensitive); }

struct ImageLoad {
    QImage image;
    std::optional<Reason> problem;
};

Reason unreadable(Reason why)
{
    return {QT_TRANSLATE_NOOP("Diagnostic", "the image cannot be read: %1"), {std::move(why)}};
}

ImageLoad loadTga(const QByteArray& bytes)
{
    if (const auto problem = sizeProblem(tgaSize(bytes).value_or(QSize())))
        return {{}, problem};
    const TgaImage tga = readTga(bytes);
    if (tga.problem)
        return {{}, unreadable(*tga.problem)};
    return {tga.image, {}};
}

ImageLoad loadWithQt(QByteArray& bytes)
{
    QBuffer buffer(&bytes);
    QImageReader reader(&buffer);
    if (const auto problem = sizeProblem(reader.size()))
        return {{}, problem};
    ImageLoad load{reader.read(), {}};
    if (load.image.isNull())
        load.problem = unreadable(reader.errorString());
    return load;
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
    InputBytes input = readInput(path);
    if (input.problem)
        return {std::nullopt, input.problem};
    const ImageLoad load = isTga(path) ? loadTga(input.bytes) : loadWithQt(input.bytes);
    if (load.problem)
        return {std::nullopt, load.problem};
    return {textureOf(load.image, path), {}};
}

} // namespace rasterlens
