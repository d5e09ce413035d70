#include "core/truth/coverage_difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace rasterlens
{
namespace
{

PixelVerdict verdictOf(std::uint32_t hits, std::uint32_t trueHits, std::int32_t face, std::int32_t trueFace)
{
    if (hits == 0 && trueHits > 0)
        return PixelVerdict::Missing;
    if (hits > 0 && trueHits == 0)
        return PixelVerdict::Extra;
    if (hits != trueHits)
        return hits > trueHits ? PixelVerdict::HitTwice : PixelVerdict::HitLess;
    return face == trueFace ? PixelVerdict::Right : PixelVerdict::OtherFace;
}

/// Whether the truth covers the four neighbours of a pixel; those beyond the window count as covered.
bool insideCoverage(const ExactFrame& truth, int x, int y)
{
    constexpr int kNeighbours[4][2] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    return std::all_of(std::begin(kNeighbours), std::end(kNeighbours), [&](const auto& step) {
        const int nx = x + step[0];
        const int ny = y + step[1];
        if (nx < 0 || ny < 0 || nx >= truth.window.width || ny >= truth.window.height)
            return true;
        return truth.cover[truth.sampleNearestCentre(nx, ny)] > 0;
    });
}

/// Largest, mean and mean square of a series of errors.
struct ErrorSum {
    double max = 0;
    double sum = 0;
    double squares = 0;
    std::uint64_t count = 0;

    void add(double error)
    {
        max = std::max(max, error);
        sum += error;
        squares += error * error;
        ++count;
    }
    [[nodiscard]] double mean() const { return count > 0 ? sum / static_cast<double>(count) : 0; }
    [[nodiscard]] double meanSquare() const { return count > 0 ? squares / static_cast<double>(count) : 0; }
};

constexpr double kPeak = 255;

double psnrFromMeanSquare(double meanSquare)
{
    return meanSquare == 0 ? std::numeric_limits<double>::infinity() : 10 * std::log10(kPeak * kPeak / meanSquare);
}

double meanSquareFromPsnr(double psnrDb) { return kPeak * kPeak * std::pow(10, -psnrDb / 10); }

/// The mean of two means over so many values.
double joinedMean(double a, std::uint64_t countA, double b, std::uint64_t countB)
{
    const auto weightA = static_cast<double>(countA);
    const auto weightB = static_cast<double>(countB);
    return countA + countB == 0 ? 0 : (a * weightA + b * weightB) / (weightA + weightB);
}

/// How far a channel is from the exact one rounded to 8 bits; where that lies half way between two values, and a
/// float32 product decides, both are right.
double roundedError(double shown, double exact)
{
    constexpr double kTie = 0x1p-14;
    return std::abs(shown - exact) <= 0.5 + kTie ? 0 : shown - std::floor(exact + 0.5);
}

void count(CoverageDifference& result, PixelVerdict verdict)
{
    switch (verdict) {
    case PixelVerdict::Right: break;
    case PixelVerdict::OtherFace: ++result.otherFace; break;
    case PixelVerdict::HitLess: ++result.hitLess; break;
    case PixelVerdict::HitTwice: ++result.hitTwice; break;
    case PixelVerdict::Extra: ++result.extra; break;
    case PixelVerdict::Missing: ++result.missing; break;
    }
}

} // namespace

CoverageDifference coverageDifference(const Frame& rendered, const ExactFrame& truth, glm::vec3 background,
                                      double bandPixels)
{
    const PixelRect& window = truth.window;
    const int width = rendered.image.width();
    assert(window.x + window.width <= width && window.y + window.height <= rendered.image.height());
    assert(bandPixels <= 0 || !truth.edgeDistance.empty());

    CoverageDifference result;
    result.window = window;
    ErrorSum depth;
    ErrorSum color;
    ErrorSum picture;
    for (int y = 0; y < window.height; ++y) {
        const QRgb* line = reinterpret_cast<const QRgb*>(rendered.image.constScanLine(window.y + y)) + window.x;
        for (int x = 0; x < window.width; ++x) {
            const std::size_t pixel = static_cast<std::size_t>(window.y + y) * static_cast<std::size_t>(width) +
                                      static_cast<std::size_t>(window.x + x);
            const std::size_t sample = truth.sampleNearestCentre(x, y);
            const std::int32_t face = rendered.ids[pixel];
            const std::uint32_t trueHits = truth.cover[sample];
            const std::uint32_t hits = rendered.coverage.empty() ? (face >= 0               ? std::max(1U, trueHits)
                                                                    : truth.id[sample] >= 0 ? 0
                                                                                            : trueHits)
                                                                 : rendered.coverage[pixel];
            PixelVerdict verdict = verdictOf(hits, trueHits, face, truth.id[sample]);
            if (verdict != PixelVerdict::Right && bandPixels > 0 &&
                static_cast<double>(truth.edgeDistance[sample]) < bandPixels) {
                ++result.tolerated;
                verdict = PixelVerdict::Right;
            }
            result.verdicts.push_back(verdict);
            count(result, verdict);
            result.covered += trueHits > 0;
            result.neverHit += verdict == PixelVerdict::Missing && insideCoverage(truth, x, y);

            const bool sameFace = face >= 0 && face == truth.id[sample];
            if (sameFace && truth.depthTested && !rendered.depth.empty())
                depth.add(std::abs(static_cast<double>(rendered.depth[pixel]) - truth.depth[sample]));
            const glm::dvec3 shown(qRed(line[x]), qGreen(line[x]), qBlue(line[x]));
            const glm::dvec3 exact = 255.0 * truth.pixelColor(x, y, background);
            for (int channel = 0; channel < 3; ++channel) {
                picture.add(roundedError(shown[channel], exact[channel]));
                if (sameFace)
                    color.add(std::abs(shown[channel] - exact[channel]));
            }
        }
    }
    result.pixels = result.verdicts.size();
    result.depthsCompared = depth.count;
    result.colorsCompared = color.count / 3;
    result.depthMax = depth.max;
    result.depthMean = depth.mean();
    result.colorMax = color.max;
    result.colorMean = color.mean();
    result.psnrDb = psnrFromMeanSquare(picture.meanSquare());
    return result;
}

CoverageDifference joined(const CoverageDifference& a, const CoverageDifference& b)
{
    CoverageDifference sum;
    for (const auto member :
         {&CoverageDifference::pixels, &CoverageDifference::covered, &CoverageDifference::missing,
          &CoverageDifference::extra, &CoverageDifference::hitTwice, &CoverageDifference::hitLess,
          &CoverageDifference::neverHit, &CoverageDifference::otherFace, &CoverageDifference::tolerated,
          &CoverageDifference::depthsCompared, &CoverageDifference::colorsCompared})
        sum.*member = a.*member + b.*member;
    sum.depthMax = std::max(a.depthMax, b.depthMax);
    sum.depthMean = joinedMean(a.depthMean, a.depthsCompared, b.depthMean, b.depthsCompared);
    sum.colorMax = std::max(a.colorMax, b.colorMax);
    sum.colorMean = joinedMean(a.colorMean, a.colorsCompared, b.colorMean, b.colorsCompared);
    sum.psnrDb =
        psnrFromMeanSquare(joinedMean(meanSquareFromPsnr(a.psnrDb), a.pixels, meanSquareFromPsnr(b.psnrDb), b.pixels));
    return sum;
}

double legalBandPixels(QSize size)
{
    return std::numbers::sqrt2 / 512 + std::max(size.width(), size.height()) * 0x1p-22;
}

} // namespace rasterlens
