#pragma once
#include "core/io/npy.h"

#include <cstdint>

namespace rasterlens
{

/// How far two arrays of numbers are from each other, in their own unit.
struct ArrayDifference {
    std::uint64_t values = 0;     ///< compared
    std::uint64_t differing = 0;  ///< also those where one of the two is not a number
    std::uint64_t nanOnlyInA = 0; ///< not a number in one, a number in the other: they differ
    std::uint64_t nanOnlyInB = 0;
    std::uint64_t nanInBoth = 0; ///< they are equal
    double max = 0;              ///< largest difference of two numbers, infinite between different infinities
    double mean = 0;             ///< of all pairs of numbers

    friend bool operator==(const ArrayDifference&, const ArrayDifference&) = default;
};

/// in      arrays of one shape; their types may differ
/// exact   counts; the differences of two floats, and of integers up to 8 bytes before they are rounded to double
[[nodiscard]] ArrayDifference difference(const NpyArray& a, const NpyArray& b);

} // namespace rasterlens
