#pragma once
#include <QString>

#include <cstdint>

namespace rasterlens
{

/// 1,234,567
[[nodiscard]] QString grouped(std::uint64_t value);

/// At most five characters: 999, 12.3k, 4.56M
[[nodiscard]] QString shortened(std::uint64_t value);

} // namespace rasterlens
