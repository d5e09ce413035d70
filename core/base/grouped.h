#pragma once
#include <QString>

#include <cstdint>

namespace rasterlens
{

/// A number in groups of three digits, in both languages: `1,234,567`.
[[nodiscard]] QString grouped(std::uint64_t value);

} // namespace rasterlens
