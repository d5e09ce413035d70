#include "core/settings/number_budget.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace rasterlens
{

NumberBudget numberBudget(const Settings& settings)
{
    const int grid = sampleGrid(settings.samples);
    const auto columns = static_cast<std::uint64_t>(settings.size.width() * grid);
    const auto rows = static_cast<std::uint64_t>(settings.size.height() * grid);
    const int areaBits = static_cast<int>(std::bit_width(columns * rows));
    if (settings.numberType == NumberType::Fixed) {
        constexpr int kPatternBits = 4; // sixteenths of a pixel
        const bool hasPattern = patternSamples(settings.samples) > 1;
        const int bits = hasPattern ? std::max(settings.subpixelBits, kPatternBits) : settings.subpixelBits;
        return {-bits, areaBits + bits + std::max(bits, 1), 63};
    }
    const int significand = settings.numberType == NumberType::Float32 ? 24 : 53;
    // What the largest coordinate leaves for the bits after the point.
    const int fraction = significand - static_cast<int>(std::bit_width(std::max(columns, rows)));
    return {-fraction, areaBits + 2 * fraction, significand};
}

} // namespace rasterlens
