#include "core/io/texture_loader.h"

#include "core/io/text_input.h"
#include "core/io/tga.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImage>
#include <QImageReader>

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <utility>

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

Reason unreadable(Reason why)
{
    return {QT_TRANSLATE_NOOP("Diagnostic", "the image cannot be read: %1"), {std::move(why)}};
}

PictureLoad loadTga(const QByteArray& bytes)
{
    if (const auto problem = sizeProblem(tgaSize(bytes).value_or(QSize())))
        return {{}, problem};
    const TgaImage tga = readTga(bytes);
    if (tga.problem)
        return {{}, unreadable(*tga.problem)};
    return {tga.image, {}};
}

PictureLoad loadWithQt(QByteArray& bytes)
{
    QBuffer buffer(&bytes);
    QImageReader reader(&buffer);
    if (const auto problem = sizeProblem(reader.size()))
        return {{}, problem};
    PictureLoad load{reader.read(), {}};
    if (load.image.isNull())
        load.problem = unreadable(reader.errorString());
    return load;
}

/// Makes a texture whose texels are those of the image, through a function, the bottom row first.
template <class TexelOf>
Texture textureOf(const QImage& image, const QString& name, TexelOf texelOf)
{
    Texture texture{name, image.width(), image.height(), {}};
    texture.texels.reserve(static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height()));
    for (int y = image.height() - 1; y >= 0; --y) {
        const auto* row = reinterpret_cast<const QRgb*>(image.constScanLine(y));
        std::transform(row, row + image.width(), std::back_inserter(texture.texels), texelOf);
    }
    return texture;
}

std::uint32_t grey(std::uint32_t value) { return 0xff000000U | value * 0x10101U; }

bool isOpaque(const Texture& opacity)
{
    return std::ranges::all_of(opacity.texels, [](std::uint32_t texel) { return texel == 0xffffffffU; });
}

TextureLoad splitAlpha(const QImage& image, const QString& name)
{
    const bool hasAlpha = image.hasAlphaChannel();
    const QImage pixels = image.convertToFormat(hasAlpha ? QImage::Format_ARGB32 : QImage::Format_RGB32);
    TextureLoad load{textureOf(pixels, name, [](QRgb pixel) { return pixel | 0xff000000U; }), {}, {}};
    if (!hasAlpha)
        return load;
    Texture opacity = textureOf(pixels, name, [](QRgb pixel) { return grey(pixel >> 24); });
    if (!isOpaque(opacity))
        load.opacity = std::move(opacity);
    return load;
}

} // namespace

PictureLoad pictureFrom(QByteArray bytes, const QString& name)
{
    return isTga(name) ? loadTga(bytes) : loadWithQt(bytes);
}

TextureLoad loadTexture(const QString& path)
{
    InputBytes input = readInput(path);
    if (input.problem)
        return {{}, {}, input.problem};
    const PictureLoad load = pictureFrom(std::move(input.bytes), path);
    if (load.problem)
        return {{}, {}, load.problem};
    return splitAlpha(load.image, QFileInfo(path).fileName());
}

Texture maskOf(TextureLoad image, char channel)
{
    if (image.opacity && (channel == 'm' || channel == 0))
        return std::move(*image.opacity);
    const auto value = [channel](std::uint32_t texel) {
        const std::uint32_t red = texel >> 16 & 255U;
        const std::uint32_t green = texel >> 8 & 255U;
        const std::uint32_t blue = texel & 255U;
        switch (channel) {
        case 'r': return red;
        case 'g': return green;
        case 'b': return blue;
        case 'm': return 255U; // an image without transparency is opaque
        default: return (77 * red + 150 * green + 29 * blue + 128) >> 8;
        }
    };
    Texture mask = std::move(*image.texture);
    for (std::uint32_t& texel : mask.texels)
        texel = grey(value(texel));
    return mask;
}

void spread(Texture& texture, float base, float gain)
{
    std::array<std::uint32_t, 256> spreadValue{};
    for (std::size_t t = 0; t < spreadValue.size(); ++t)
        spreadValue[t] =
            static_cast<std::uint32_t>(std::clamp(255 * base + gain * static_cast<float>(t), 0.0F, 255.0F) + 0.5F);
    for (std::uint32_t& texel : texture.texels)
        texel = 0xff000000U | spreadValue[texel >> 16 & 255U] << 16 | spreadValue[texel >> 8 & 255U] << 8 |
                spreadValue[texel & 255U];
}

} // namespace rasterlens
