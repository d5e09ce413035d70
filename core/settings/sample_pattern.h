#pragma once
#include "core/settings/rules.h"

#include <cstdint>
#include <span>

namespace rasterlens
{

/// Samples of a pixel, one bit each, in the order of the pattern.
using SampleMask = std::uint16_t;

/// Where a sample lies, seen from its pixel's centre: sixteenths of a pixel, x right, y down, -8..7.
struct SampleOffset {
    std::int8_t x;
    std::int8_t y;

    /// Pixels.
    ///
    /// exact  a multiple of 1/16, which fixed point holds whatever the subpixel bits
    [[nodiscard]] glm::dvec2 pixels() const { return glm::dvec2(x, y) / 16.0; }
};

/// The standard pattern of so many samples, in its order; of one sample, the centre.
///
/// in      1, 2, 4, 8 or 16
/// source  D3D11_STANDARD_MULTISAMPLE_QUALITY_LEVELS (Direct3D 11.3 functional specification, section 19.2.4), and
///         the standard sample locations of the Vulkan specification, which are the same
[[nodiscard]] std::span<const SampleOffset> samplePattern(int samples);

/// Where a sample of the rules' pattern is tested. Under the mistake that truncates samples all are tested where the
/// pixel is.
[[nodiscard]] inline SampleOffset testedOffset(const Rules& rules, int sample)
{
    if (rules.samplesTruncated)
        return {0, 0};
    return samplePattern(rules.patternSamples)[static_cast<std::size_t>(sample)];
}

/// From the centre of a pixel to where a face that covers these samples of it is shaded.
///
/// in      rules with a pattern; samples that are shaded together: with AttributeAt::Sample one
/// source  Direct3D 11.3 functional specification, section 3.5.5: the centroid of a pixel that is covered whole is its
///         centre, of another its first covered sample
[[nodiscard]] glm::dvec2 shadingOffset(const Rules& rules, SampleMask covered);

} // namespace rasterlens
