#pragma once
#include "core/render/render.h"
#include "core/truth/exact_reference.h"

#include <cstdint>
#include <vector>

namespace rasterlens
{

/// What is wrong with a pixel, the worst first.
enum class PixelVerdict : std::uint8_t {
    Right,
    OtherFace, ///< covered as often as it should be, but another face is seen
    HitLess,   ///< covered, but by fewer faces than it should be
    HitTwice,  ///< covered, and by more faces than it should be
    Extra,     ///< covered, but should not be
    Missing,   ///< not covered, but should be
};

/// A rendered picture against the truth. Depths and colours are compared where both show the same face, depths only if
/// they were tested.
struct CoverageDifference {
    PixelRect window;
    std::vector<PixelVerdict> verdicts; ///< one a pixel of the window, row by row from the top

    std::uint64_t pixels = 0;    ///< compared
    std::uint64_t covered = 0;   ///< covered in truth
    std::uint64_t missing = 0;   ///< Missing
    std::uint64_t extra = 0;     ///< Extra
    std::uint64_t hitTwice = 0;  ///< HitTwice: both faces of a shared edge took the pixel
    std::uint64_t hitLess = 0;   ///< HitLess
    std::uint64_t neverHit = 0;  ///< of the missing: all four neighbours are covered in truth, a crack along an edge
    std::uint64_t otherFace = 0; ///< OtherFace
    std::uint64_t tolerated = 0; ///< differing pixels inside the band along a true edge: counted as right

    std::uint64_t depthsCompared = 0; ///< pixels
    std::uint64_t colorsCompared = 0; ///< pixels

    double depthMax = 0;  ///< depth units
    double depthMean = 0; ///< depth units
    double colorMax = 0;  ///< 8-bit steps away from the exact colour; 0.5 is what rounding alone may do
    double colorMean = 0; ///< 8-bit steps, mean over the channels
    double psnrDb =
        0; ///< of the picture against the truth rounded to 8 bits, ties either way, all pixels; infinite: equal

    [[nodiscard]] std::uint64_t wrong() const { return missing + extra + hitTwice + hitLess + otherFace; }
};

/// Compares pixel by pixel within the window of the truth.
///
/// in      `rendered` with ids, and of the size the truth was computed for; depth and coverage where they are to be
///         compared (without coverage, a pixel counts as covered once where a face is seen). Colours as vertex
///         colours give them (Gouraud) or as the truth holds them (exact_texels.h), over `background`
/// covers  several samples a pixel: coverage, id and depth of the sample nearest the centre, colour of the whole pixel
/// out     with bandPixels > 0 a pixel nearer than that to a true edge is right whatever covers it; the truth then
///         needs edgeDistance
[[nodiscard]] CoverageDifference coverageDifference(const Frame& rendered, const ExactFrame& truth,
                                                    glm::vec3 background, double bandPixels = 0);

/// The difference of a picture from those of two windows that share no pixel. Without verdicts; a crack is one within
/// its window.
[[nodiscard]] CoverageDifference joined(const CoverageDifference& a, const CoverageDifference& b);

/// The band within which a rasterizer that snaps to 1/256 pixel may differ from the unsnapped truth: half the diagonal
/// of the snapping grid, and float32 noise of the viewport transform.
[[nodiscard]] double legalBandPixels(QSize size);

} // namespace rasterlens
