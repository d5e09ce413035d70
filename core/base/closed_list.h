#pragma once
#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace rasterlens
{

/// Whether a value has a name in its enumeration, as the compiler writes it: `StepKind::End`, but `(StepKind)18`.
template <auto kValue>
[[nodiscard]] consteval bool isEnumerator()
{
    std::string_view text = __PRETTY_FUNCTION__; // ends in the value and a bracket
    text.remove_suffix(1);
    const std::size_t digits = text.find_last_not_of("0123456789");
    return text[digits] != ')';
}

/// How many values an enumeration has that counts from 0 without gaps, up to 63.
template <class Enum>
[[nodiscard]] consteval std::size_t enumeratorCount()
{
    return []<std::size_t... kIndex>(std::index_sequence<kIndex...>)
    {
        return (std::size_t(isEnumerator<static_cast<Enum>(kIndex)>()) + ...);
    }
    (std::make_index_sequence<64>());
}

/// Whether a table holds one row for each value of an enumeration, in the order of the values.
///
/// in   the table, and the member of a row that holds its value
template <class Row, std::size_t kCount, class Enum>
[[nodiscard]] consteval bool isClosedList(const std::array<Row, kCount>& rows, Enum Row::*value)
{
    if (kCount != enumeratorCount<Enum>())
        return false;
    for (std::size_t i = 0; i < kCount; ++i)
        if (rows[i].*value != static_cast<Enum>(i))
            return false;
    return true;
}

} // namespace rasterlens
