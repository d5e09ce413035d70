#include "core/truth/array_difference.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <concepts>
#include <type_traits>
#include <utility>

namespace rasterlens
{
namespace
{

template <typename T>
bool isNan(T value)
{
    if constexpr (std::floating_point<T>)
        return std::isnan(value);
    else
        return false;
}

/// The distance of two numbers, 0 only for equal ones; those of integers are taken before anything is rounded.
template <typename A, typename B>
double distance(A a, B b)
{
    if constexpr (std::integral<A> && std::integral<B>) {
        if (std::cmp_less(a, b))
            return distance(b, a);
        // a is the larger one: the difference of the two as unsigned numbers is right even where signed ones overflow.
        return static_cast<double>(static_cast<std::uint64_t>(a) - static_cast<std::uint64_t>(b));
    } else if constexpr (std::floating_point<A> && std::floating_point<B>) {
        return a == b ? 0 : std::abs(a - b); // equal infinities have no difference of their own
    } else {
        const auto wideA = static_cast<long double>(a);
        const auto wideB = static_cast<long double>(b);
        return wideA == wideB ? 0 : static_cast<double>(std::abs(wideA - wideB));
    }
}

template <typename A, typename B>
ArrayDifference compare(const std::vector<A>& a, const std::vector<B>& b)
{
    ArrayDifference result;
    result.values = a.size();
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        const bool nanA = isNan(a[i]);
        const bool nanB = isNan(b[i]);
        result.nanInBoth += nanA && nanB ? 1U : 0U;
        result.nanOnlyInA += nanA && !nanB ? 1U : 0U;
        result.nanOnlyInB += nanB && !nanA ? 1U : 0U;
        if (nanA || nanB)
            continue;
        const double step = distance(a[i], b[i]);
        result.differing += step > 0 ? 1U : 0U;
        result.max = std::max(result.max, step);
        sum += step;
    }
    const std::uint64_t oneSided = result.nanOnlyInA + result.nanOnlyInB;
    const std::uint64_t numbers = result.values - oneSided - result.nanInBoth;
    result.differing += oneSided;
    result.mean = numbers == 0 ? 0 : sum / static_cast<double>(numbers);
    return result;
}

} // namespace

ArrayDifference difference(const NpyArray& a, const NpyArray& b)
{
    assert(a.size() == b.size());
    return std::visit([](const auto& left, const auto& right) { return compare(left, right); }, a.values, b.values);
}

} // namespace rasterlens
