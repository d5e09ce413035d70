#include "core/io/palette.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace rasterlens
{
namespace
{

struct CountedColor {
    std::array<int, 3> channels; ///< red, green, blue
    std::int64_t pixels;
};

CountedColor counted(QRgb color, std::int64_t pixels) { return {{qRed(color), qGreen(color), qBlue(color)}, pixels}; }

QRgb rgbOf(const CountedColor& color) { return qRgb(color.channels[0], color.channels[1], color.channels[2]); }

/// Some colours that are to become one.
struct Box {
    std::span<CountedColor> colors;
    std::size_t axis = 0; ///< the channel in which they differ most
    int side = 0;         ///< by how much

    explicit Box(std::span<CountedColor> in) : colors(in)
    {
        for (std::size_t i = 0; i < 3; ++i) {
            const auto [least, most] =
                std::ranges::minmax(colors, {}, [i](const CountedColor& color) { return color.channels[i]; });
            if (const int length = most.channels[i] - least.channels[i]; length > side) {
                side = length;
                axis = i;
            }
        }
    }

    [[nodiscard]] std::pair<Box, Box> halves() const
    {
        const auto channel = [this](const CountedColor& color) { return color.channels[axis]; };
        std::ranges::stable_sort(colors, {}, channel);
        std::int64_t all = 0;
        for (const CountedColor& color : colors)
            all += color.pixels;
        std::size_t cut = 1;
        for (std::int64_t seen = colors[0].pixels; cut + 1 < colors.size() && 2 * seen < all; ++cut)
            seen += colors[cut].pixels;
        return {Box(colors.first(cut)), Box(colors.subspan(cut))};
    }

    [[nodiscard]] QRgb mean() const
    {
        std::array<std::int64_t, 3> sums{};
        std::int64_t pixels = 0;
        for (const CountedColor& color : colors) {
            for (std::size_t i = 0; i < 3; ++i)
                sums[i] += color.channels[i] * color.pixels;
            pixels += color.pixels;
        }
        const auto rounded = [pixels](std::int64_t sum) { return static_cast<int>((sum + pixels / 2) / pixels); };
        return qRgb(rounded(sums[0]), rounded(sums[1]), rounded(sums[2]));
    }
};

std::vector<Box> boxesOf(std::vector<CountedColor>& colors, std::size_t most)
{
    std::vector<Box> boxes{Box(colors)};
    while (boxes.size() < most) {
        const auto longest = std::ranges::max_element(boxes, {}, &Box::side);
        if (longest->side == 0)
            break;
        const auto [first, second] = longest->halves();
        *longest = first;
        boxes.push_back(second);
    }
    return boxes;
}

} // namespace

QImage withPalette(const QImage& picture, int most)
{
    const QImage rgb = picture.convertToFormat(QImage::Format_RGB32);
    QImage image(rgb.size(), QImage::Format_Indexed8);
    if (rgb.isNull() || image.isNull())
        return {};
    std::unordered_map<QRgb, std::int64_t> pixels;
    const auto row = [&rgb](int y) {
        return std::span(reinterpret_cast<const QRgb*>(rgb.constScanLine(y)), static_cast<std::size_t>(rgb.width()));
    };
    for (int y = 0; y < rgb.height(); ++y)
        for (const QRgb color : row(y))
            ++pixels[color | 0xff000000U];
    std::vector<CountedColor> colors;
    for (const auto& [color, count] : pixels)
        colors.push_back(counted(color, count));
    std::ranges::sort(colors, {}, &rgbOf); // a hash has an order of its own
    QList<QRgb> table;
    std::unordered_map<QRgb, uchar> indices;
    for (const Box& box : boxesOf(colors, static_cast<std::size_t>(most))) {
        for (const CountedColor& color : box.colors)
            indices[rgbOf(color)] = static_cast<uchar>(table.size());
        table << box.mean();
    }
    image.setColorTable(table);
    for (int y = 0; y < rgb.height(); ++y)
        std::ranges::transform(row(y), image.scanLine(y), [&](QRgb color) { return indices.at(color | 0xff000000U); });
    return image;
}

} // namespace rasterlens
