#pragma once
#include <QImage>

#include <cstdint>
#include <span>

namespace rasterlens
{

/// What of two pictures is compared.
enum class Channels { Rgb, Rgba };

/// How far two pictures are from each other. A channel is red, green, blue, or alpha where it is asked for, in 8-bit
/// steps.
struct Difference {
    std::uint64_t pixels = 0;    ///< compared
    std::uint64_t differing = 0; ///< pixels of which at least one channel differs
    int max = 0;                 ///< largest difference of a channel, 0..255
    double mean = 0;             ///< mean difference of a channel, over all pixels
    double psnrDb = 0;           ///< 10 log10(255^2 / mean squared difference); infinite for equal pictures

    friend bool operator==(const Difference&, const Difference&) = default;
};

/// in      pictures of one size, any format
/// exact   counts and max; the sums behind mean and psnrDb are integers
/// errors  throws std::bad_alloc
[[nodiscard]] Difference difference(const QImage& a, const QImage& b, Channels channels = Channels::Rgb);

/// One class of the heat map: pixels whose largest channel difference is at least `steps`.
struct HeatClass {
    int steps;
    QRgb color;
};

/// The colours of the heat map from small to large: 1, 2, 4 .. 128 steps, the lighter the further apart.
[[nodiscard]] std::span<const HeatClass> heatScale();

/// Where two pictures differ: a pixel that differs has the colour of its class, so that a single step is as easy to
/// find as a wrong pixel; all others show `a` as a dark grey.
///
/// in      pictures of one size, any format; `amplification`, at least 1, multiplies the steps before they are classed
/// out     Format_RGB32
/// errors  throws std::bad_alloc
[[nodiscard]] QImage heatMap(const QImage& a, const QImage& b, int amplification = 1,
                             Channels channels = Channels::Rgb);

} // namespace rasterlens
