#pragma once
#include "core/base/grouped.h"

#include <QColor>
#include <QString>

#include <cstdint>

namespace rasterlens
{

/// At most five characters: 999, 12.3k, 4.56M
[[nodiscard]] QString shortened(std::uint64_t value);

/// How far the channels of one colour are from those of another: `+3 0 −12`.
[[nodiscard]] QString channelChanges(QRgb from, QRgb to);

/// Signs as books print them: the long minus before numbers, one sign for <= and >=, an arrow for ->.
[[nodiscard]] QString printedSigns(QString text);

} // namespace rasterlens
