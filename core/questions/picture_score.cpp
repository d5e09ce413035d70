#include "core/questions/picture_score.h"

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr double kLeastWeight = kWholePixel / 4; ///< of a change: below it, rounding could look like it
/// Noise by flat areas and edges, in whole pixels a pixel: what differs more is another picture.
constexpr std::array<double, 2> kMostNoise{0.05, 0.15};

/// The standard deviation of the sum over `count` pixels, at most: noise of whole pixels deviates most.
double deviation(double count, double typical) { return std::sqrt(count * typical * kWholePixel); }

/// The differences from both pictures that are more than those that are spread all over the picture.
double aboveTypical(const PictureFit& fit, const PictureNoise& noise)
{
    constexpr double kSure = 3; // standard deviations
    double sum = 0;
    for (std::size_t kind = 0; kind < 2; ++kind)
        sum += std::max(0.0, fit.excess[kind] - fit.count[kind] * noise.typical[kind] -
                                 kSure * deviation(fit.count[kind], noise.typical[kind]));
    return sum;
}

} // namespace

PictureNoise PictureNoise::of(const std::vector<PictureFit>& fits)
{
    PictureNoise noise;
    const auto best = std::ranges::min_element(fits, {}, &PictureFit::residual);
    noise.least = best == fits.end() ? 0 : best->residual;
    for (std::size_t kind = 0; kind < 2; ++kind) {
        const auto least =
            std::ranges::min_element(fits, {}, [kind](const PictureFit& fit) { return fit.typical[kind]; });
        noise.typical[kind] =
            least == fits.end() ? 0 : std::clamp(least->typical[kind], 0.0, kMostNoise[kind] * kWholePixel);
    }
    return noise;
}

bool leavesOnlyNoise(const PictureFit& fit, const PictureNoise& noise, int most)
{
    constexpr double kCleanPart = 0.002;
    constexpr double kNoisyPart = 0.005;
    return noise.typical[0] > 0 ? aboveTypical(fit, noise) <= 2 * kWholePixel + kNoisyPart * fit.weight
                                : fit.unlike <= 2 + kCleanPart * most;
}

double leavesOf(const PictureFit& fit)
{
    constexpr double kPrice = 4 * kWholePixel; // a pixel of offset
    return fit.residual / offsetFactor(fit.offset) + kPrice * fit.offset.manhattanLength();
}

double unexplained(const PictureFit& fit, const PictureNoise& noise)
{
    // No more than the best picture leaves is noise.
    return std::max(aboveTypical(fit, noise), fit.residual - noise.least);
}

double scoreOf(const PictureFit& fit, const PictureNoise& noise)
{
    const double whole = fit.weight + unexplained(fit, noise);
    // Where there is noise, some pixels look like anything.
    const double noisy = std::min(1.0, 20 * std::max(noise.typical[0], noise.typical[1]) / kWholePixel);
    const double seen = std::min(1.0, fit.weight / (kLeastWeight + 4 * kWholePixel * noisy));
    return whole > 0 ? std::clamp(offsetFactor(fit.offset) * seen * fit.gain / whole, 0.0, 1.0) : 0;
}

double scoreOfRight(const PictureFit& fit, const PictureNoise& noise, double smallest)
{
    double half = std::min(smallest, 8 * kWholePixel) / 2;
    for (std::size_t kind = 0; kind < 2; ++kind)
        half += deviation(fit.count[kind], noise.typical[kind]) / 2;
    return offsetFactor(fit.offset) * half / (half + unexplained(fit, noise));
}

} // namespace rasterlens
