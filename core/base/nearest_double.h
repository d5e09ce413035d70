#pragma once
#include <cmath>
#include <cstdint>

namespace rasterlens
{

/// mantissa * 2^exponent; 0.5 <= |mantissa| <= 1, or 0.
struct Scaled {
    double mantissa = 0;
    int exponent = 0;

    [[nodiscard]] double value(int base) const { return std::ldexp(mantissa, exponent - base); } ///< over 2^base
};

/// The nearest number with a mantissa of 53 bits, half to even, and an exponent of any size.
///
/// in     Integer: Boost.Multiprecision's cpp_int of any length
/// exact  always
template <class Integer>
[[nodiscard]] Scaled nearestScaled(const Integer& value)
{
    constexpr int kBits = 63;
    if (value.is_zero())
        return {};
    const Integer magnitude = abs(value);
    const int length = static_cast<int>(msb(magnitude)) + 1;
    const int cutOff = length > kBits ? length - kBits : 0;
    // The last bit stands for all bits that are cut off, so that the one rounding of the conversion sees them.
    const bool isInexact = static_cast<int>(lsb(magnitude)) < cutOff;
    const auto leading = static_cast<std::uint64_t>(Integer(magnitude >> static_cast<unsigned>(cutOff)));
    const double mantissa = std::ldexp(static_cast<double>(leading | (isInexact ? 1U : 0U)), cutOff - length);
    return {value.sign() < 0 ? -mantissa : mantissa, length};
}

/// The double nearest to numerator / denominator, half to even.
///
/// Boost's own conversion of a long integer is not used: in version 1.74 it cuts off instead of rounding.
///
/// in     Integer: Boost.Multiprecision's cpp_int of any length; denominator != 0
/// exact  where the quotient is 0 or at least 2^-1022 large; infinite from 2^1024 on
template <class Integer>
[[nodiscard]] double nearestQuotient(const Integer& numerator, const Integer& denominator)
{
    if (numerator.is_zero())
        return 0;
    Integer n = abs(numerator);
    Integer d = abs(denominator);
    // Times 2^shift the quotient has 62 or 63 bits, of which the last one stands for the remainder.
    const int shift = 62 - (static_cast<int>(msb(n)) - static_cast<int>(msb(d)));
    if (shift > 0)
        n <<= static_cast<unsigned>(shift);
    else
        d <<= static_cast<unsigned>(-shift);
    Integer quotient;
    Integer remainder;
    divide_qr(n, d, quotient, remainder);
    const std::uint64_t bits = static_cast<std::uint64_t>(quotient) | (remainder.is_zero() ? 0U : 1U);
    const double magnitude = std::ldexp(static_cast<double>(bits), -shift);
    return (numerator.sign() < 0) != (denominator.sign() < 0) ? -magnitude : magnitude;
}

} // namespace rasterlens
