#pragma once
#include <QString>

#include <cstddef>
#include <optional>
#include <utility>

namespace rasterlens
{

/// Reads a run of steps: `10-60`, the first and the last position in a record.
///
/// errors  nothing for any other text, and where the last lies before the first
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> stepRunFromText(const QString& text);

} // namespace rasterlens
