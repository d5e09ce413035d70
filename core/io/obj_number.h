#pragma once
// Numbers and indices of an OBJ text, read where they stand. A large file is mostly these.
#include "core/io/text_input.h"

#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <limits>

namespace rasterlens::objtext
{

inline bool isDigit(char c) { return c >= '0' && c <= '9'; }
inline bool isBlank(char c) { return c == ' ' || c == '\t'; }

inline void skipBlanks(const char*& at, const char* end)
{
    while (at != end && isBlank(*at))
        ++at;
}

/// Reads a plain decimal number: at most 19 digits, and small enough in mantissa and exponent that one division or
/// multiplication of two exact doubles gives the nearest double.
///
/// in      `at` stands on the first character
/// out     true: `value`, and `at` behind the number, at a blank or the end. False: nothing is changed; a slower way is
///         to be taken
/// source  Clinger, "How to read floating point numbers accurately", PLDI 1990, section 3
inline bool quickNumber(const char*& at, const char* end, double& value)
{
    constexpr std::array<double, 23> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                                1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    constexpr std::uint64_t kMostExact = std::uint64_t{1} << 53;
    const char* p = at;
    const bool negative = *p == '-';
    if (negative || *p == '+')
        ++p;
    std::uint64_t mantissa = 0;
    int digits = 0;
    int scale = 0;
    for (; p != end && isDigit(*p); ++p, ++digits)
        mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p - '0');
    if (p != end && *p == '.')
        for (++p; p != end && isDigit(*p); ++p, ++digits, --scale)
            mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p - '0');
    if (digits == 0 || digits > 19 || mantissa > kMostExact)
        return false;
    if (p != end && (*p == 'e' || *p == 'E')) {
        int exponent = 0;
        const char* const digitsBegin = p + 1 != end && p[1] == '+' ? p + 2 : p + 1;
        const auto parsed = std::from_chars(digitsBegin, end, exponent);
        if (parsed.ec != std::errc() || exponent < -99 || exponent > 99 ||
            (digitsBegin == p + 2 && *digitsBegin == '-'))
            return false;
        scale += exponent;
        p = parsed.ptr;
    }
    if ((p != end && !isBlank(*p)) || scale < -22 || scale > 22)
        return false;
    const double magnitude = scale < 0 ? static_cast<double>(mantissa) / kPowers[static_cast<std::size_t>(-scale)]
                                       : static_cast<double>(mantissa) * kPowers[static_cast<std::size_t>(scale)];
    value = negative ? -magnitude : magnitude;
    at = p;
    return true;
}

/// The word at the front and what it says. A `#` within ends it and the line, but for `1.#IND` and its kind.
inline std::string_view numberWord(const char*& at, const char*& end)
{
    const char* const begin = at;
    const char* comment = nullptr;
    for (; at != end && !isBlank(*at); ++at)
        if (*at == '#' && comment == nullptr)
            comment = at;
    const std::string_view word(begin, static_cast<std::size_t>(at - begin));
    const auto hash = comment == nullptr ? word.size() : static_cast<std::size_t>(comment - begin);
    const bool isPrintedNan = hash + 1 < word.size() && hash >= 2 && hash <= 3 && word.substr(hash - 2, 2) == "1." &&
                              std::string_view("IQSN").find(word[hash + 1]) != std::string_view::npos;
    if (comment == nullptr || isPrintedNan)
        return word;
    at = end = comment;
    return word.substr(0, hash);
}

/// The float32 nearest to a decimal, of which `nearest` is the nearest double.
///
/// exact   rounding twice is rounding once unless the double lies halfway between two float32: then the text decides
inline float nearestFloat(double nearest, std::string_view word)
{
    constexpr std::uint64_t kDropped = (std::uint64_t{1} << 29) - 1;
    constexpr std::uint64_t kHalf = std::uint64_t{1} << 28;
    const bool isTie = (std::bit_cast<std::uint64_t>(nearest) & kDropped) == kHalf;
    const bool isTiny = nearest > -1e-37 && nearest < 1e-37 && nearest != 0;
    return isTie || isTiny ? decimalFromText(word).value : static_cast<float>(nearest);
}

/// What an index of a corner says: a number from 1 or, backwards, from -1; nothing; or no number.
struct IndexText {
    std::int64_t value = 0; ///< held within int64
    bool absent = false;
    bool good = true;
};

/// Reads an index up to a slash, a blank, a `#` or the end.
inline IndexText indexAt(const char*& at, const char* end)
{
    constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max() / 20;
    const char* const begin = at;
    const bool negative = at != end && *at == '-';
    if (at != end && (negative || *at == '+'))
        ++at;
    IndexText index;
    const char* const digitsBegin = at;
    for (; at != end && isDigit(*at); ++at)
        index.value = index.value > kMost ? kMost : index.value * 10 + (*at - '0');
    index.good = at == end || *at == '/' || *at == '#' || isBlank(*at);
    index.absent = at == begin;
    index.good = index.good && (index.absent || at != digitsBegin);
    if (negative)
        index.value = -index.value;
    return index;
}

} // namespace rasterlens::objtext
