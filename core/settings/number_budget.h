#pragma once
#include "core/settings/settings.h"

namespace rasterlens
{

/// What a number type can tell apart on a viewport, and whether its edge values are exact.
struct NumberBudget {
    int unitLog2 = 0;  ///< the smallest step of a coordinate is 2^unitLog2 pixels (floats: at the far border)
    int needed = 0;    ///< bits of the largest edge value of vertices within the viewport, without the sign
    int available = 0; ///< 63 of a 64-bit integer, 24 of a float's significand, 53 of a double's

    /// Below 0: so many bits are rounded away.
    [[nodiscard]] int left() const { return available - needed; }
};

/// An edge value is the product of two coordinate differences: it has the bits of width times height and twice the bits
/// after the point. Pixel centres have at least one of those.
///
/// in   settings: size, samples, numberType and subpixelBits count
[[nodiscard]] NumberBudget numberBudget(const Settings& settings);

} // namespace rasterlens
