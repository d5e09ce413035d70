#pragma once
#include <QString>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace rasterlens
{

/// A rational number in lowest terms.
struct Ratio {
    std::int64_t numerator = 0;
    std::int64_t denominator = 1; ///< > 0
};

/// A number as a program computes it, and what it is without rounding where that is known.
struct Quantity {
    double value = 0;
    std::optional<Ratio> exact; ///< empty: irrational, or too long for 64 bits
};

/// The rational number a double stands for, if it is a multiple of 1/65536 of at most 40 bits; fixed-point positions
/// and edge values are.
[[nodiscard]] std::optional<Ratio> ratioOf(double value);

/// `3`, `-1/2`
[[nodiscard]] QString ratioText(const Ratio& ratio);

/// Finds the value of a symbol by its id.
using SymbolValue = std::function<Quantity(const QString& id)>;

/// The value of a formula, in double precision and, as far as 64 bits reach, exactly.
///
/// in      numbers, symbols in braces (`{E_AB}`), + - * / & ( ), |absolute value|, and the functions min, max, floor,
///         ceil, sqrt, lerp(a, b, t) = a + t (b - a); a list in brackets `(x, y, z)` has a value for each entry;
///         comparisons < <= > >= == have the value 1 or 0; & is the AND of the bits of two whole numbers
/// errors  throws std::logic_error where the text is no formula: formulas are written by programmers
[[nodiscard]] std::vector<Quantity> evaluate(const QString& formula, const SymbolValue& symbol);

} // namespace rasterlens
