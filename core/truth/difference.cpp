#include "core/truth/difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>

namespace rasterlens
{
namespace
{

constexpr HeatClass kHeatScale[] = {
    {1, qRgb(74, 95, 208)},   {2, qRgb(61, 143, 217)},  {4, qRgb(47, 181, 176)},   {8, qRgb(87, 201, 106)},
    {16, qRgb(169, 217, 60)}, {32, qRgb(240, 224, 58)}, {64, qRgb(255, 240, 160)}, {128, qRgb(255, 255, 255)},
};

const QRgb* row(const QImage& image, int y) { return reinterpret_cast<const QRgb*>(image.constScanLine(y)); }

struct ChannelSteps {
    int red;
    int green;
    int blue;
    int alpha; ///< 0 for opaque pictures
    [[nodiscard]] int max() const { return std::max({red, green, blue, alpha}); }
    [[nodiscard]] int sum() const { return red + green + blue + alpha; }
    [[nodiscard]] int sumOfSquares() const { return red * red + green * green + blue * blue + alpha * alpha; }
};

ChannelSteps steps(QRgb a, QRgb b)
{
    return {std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)), std::abs(qBlue(a) - qBlue(b)),
            std::abs(qAlpha(a) - qAlpha(b))};
}

double psnrDb(std::uint64_t sumOfSquares, std::uint64_t channels)
{
    if (sumOfSquares == 0)
        return std::numeric_limits<double>::infinity();
    return 10 * std::log10(255.0 * 255.0 * static_cast<double>(channels) / static_cast<double>(sumOfSquares));
}

QRgb heatColor(int maxSteps, QRgb background)
{
    if (maxSteps == 0) {
        const int grey = qGray(background) / 4;
        return qRgb(grey, grey, grey);
    }
    const auto above = std::upper_bound(std::begin(kHeatScale), std::end(kHeatScale), maxSteps,
                                        [](int value, const HeatClass& heat) { return value < heat.steps; });
    return std::prev(above)->color;
}

/// Qt makes a null picture where there is no memory for one.
QImage checked(QImage image)
{
    if (image.isNull())
        throw std::bad_alloc();
    return image;
}

/// Four bytes a pixel; opaque where alpha is not asked for.
QImage comparable(const QImage& image, Channels channels)
{
    return checked(image.convertToFormat(channels == Channels::Rgba ? QImage::Format_ARGB32 : QImage::Format_RGB32));
}

} // namespace

Difference difference(const QImage& a, const QImage& b, Channels channels)
{
    assert(a.size() == b.size());
    const QImage left = comparable(a, channels);
    const QImage right = comparable(b, channels);
    Difference result;
    std::uint64_t sum = 0;
    std::uint64_t sumOfSquares = 0;
    for (int y = 0; y < left.height(); ++y)
        for (int x = 0; x < left.width(); ++x) {
            const ChannelSteps pixel = steps(row(left, y)[x], row(right, y)[x]);
            result.differing += pixel.max() > 0 ? 1U : 0U;
            result.max = std::max(result.max, pixel.max());
            sum += static_cast<std::uint64_t>(pixel.sum());
            sumOfSquares += static_cast<std::uint64_t>(pixel.sumOfSquares());
        }
    result.pixels = static_cast<std::uint64_t>(left.width()) * static_cast<std::uint64_t>(left.height());
    const std::uint64_t count = (channels == Channels::Rgba ? 4 : 3) * result.pixels;
    result.mean = count == 0 ? 0 : static_cast<double>(sum) / static_cast<double>(count);
    result.psnrDb = psnrDb(sumOfSquares, count);
    return result;
}

std::span<const HeatClass> heatScale() { return kHeatScale; }

QImage heatMap(const QImage& a, const QImage& b, int amplification, Channels channels)
{
    assert(a.size() == b.size());
    const QImage left = comparable(a, channels);
    const QImage right = comparable(b, channels);
    QImage heat = checked(QImage(left.size(), QImage::Format_RGB32));
    for (int y = 0; y < heat.height(); ++y) {
        auto* out = reinterpret_cast<QRgb*>(heat.scanLine(y));
        for (int x = 0; x < heat.width(); ++x)
            out[x] = heatColor(amplification * steps(row(left, y)[x], row(right, y)[x]).max(), row(left, y)[x]);
    }
    return heat;
}

} // namespace rasterlens
