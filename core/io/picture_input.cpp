#include "core/io/picture_input.h"

#include "core/io/npy.h"
#include "core/io/text_input.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kMostPixels = 16384; ///< a side

Reason shapeProblem(const NpyArray& array)
{
    return {QT_TRANSLATE_NOOP("Diagnostic",
                              "an array of shape %1 is no picture; (H, W), (H, W, 3) or (H, W, 4) is expected, "
                              "at most %2 pixels a side"),
            {shapeText(array.shape), kMostPixels}};
}

/// Every value as a channel, or why not.
struct Channels {
    std::vector<int> values;
    std::optional<Reason> problem;
};

Channels channelsOf(const NpyArray& array)
{
    const bool isFlag = array.type.contains(QLatin1Char('b'));
    const bool isFloat = array.type.contains(QLatin1Char('f'));
    return std::visit(
        [&](const auto& numbers) {
            const bool isPart =
                isFlag || (isFloat && std::ranges::none_of(numbers, [](auto number) { return number > 1; }));
            Channels channels;
            channels.values.reserve(numbers.size());
            for (const auto number : numbers) {
                const double value = static_cast<double>(number) * (isPart ? 255 : 1);
                if (value < 0 || value > 255) {
                    channels.problem = Reason{QT_TRANSLATE_NOOP("Diagnostic", "%1 is no colour; 0 to 255, or 0 to 1 in "
                                                                              "floating point, is expected"),
                                              {QString::number(static_cast<double>(number))}};
                    return channels;
                }
                channels.values.push_back(std::isnan(value) ? 0 : static_cast<int>(std::lround(value)));
            }
            return channels;
        },
        array.values);
}

PictureLoad pictureOf(const NpyArray& array)
{
    const std::size_t dimensions = array.shape.size();
    const qint64 depth = dimensions == 3 ? array.shape[2] : 1;
    if (dimensions < 2 || dimensions > 3 || (depth != 1 && depth != 3 && depth != 4) || array.size() == 0 ||
        std::max(array.shape[0], array.shape[1]) > kMostPixels)
        return {{}, shapeProblem(array)};
    Channels channels = channelsOf(array);
    if (channels.problem)
        return {{}, std::move(channels.problem)};
    QImage image(static_cast<int>(array.shape[1]), static_cast<int>(array.shape[0]),
                 depth == 4 ? QImage::Format_ARGB32 : QImage::Format_RGB32);
    const int* next = channels.values.data();
    for (int y = 0; y < image.height(); ++y) {
        auto* row = reinterpret_cast<QRgb*>(image.scanLine(y));
        for (int x = 0; x < image.width(); ++x, next += depth)
            row[x] = depth == 1 ? qRgb(next[0], next[0], next[0])
                                : qRgba(next[0], next[1], next[2], depth == 4 ? next[3] : 255);
    }
    return {std::move(image), {}};
}

} // namespace

const QStringList& pictureInputSuffixes()
{
    static const QStringList suffixes{QStringLiteral("png"), QStringLiteral("jpg"), QStringLiteral("jpeg"),
                                      QStringLiteral("bmp"), QStringLiteral("ppm"), QStringLiteral("tga"),
                                      QStringLiteral("npy")};
    return suffixes;
}

bool isPictureName(const QString& path)
{
    return std::ranges::any_of(pictureInputSuffixes(), [&path](const QString& suffix) {
        return path.endsWith(QLatin1Char('.') + suffix, Qt::CaseInsensitive);
    });
}

PictureLoad loadPicture(const QString& path)
{
    InputBytes input = readInput(path);
    if (input.problem)
        return {{}, input.problem};
    if (!isNpy(input.bytes) && !path.endsWith(QLatin1String(".npy"), Qt::CaseInsensitive))
        return pictureFrom(std::move(input.bytes), path);
    NpyRead read = readNpy(input.bytes);
    if (!read.array)
        return {{}, Reason(read.error)};
    return pictureOf(*read.array);
}

} // namespace rasterlens
