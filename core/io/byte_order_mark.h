#pragma once
#include "core/base/reason.h"

#include <QByteArray>

#include <optional>

namespace rasterlens
{

/// Takes off the three bytes that some editors put before UTF-8 text.
///
/// covers  UTF-16 and UTF-32 with their mark, and UTF-16 without: every other byte of its beginning is zero
/// errors  the text is UTF-16 or UTF-32: a sentence without the file name, of the context "Diagnostic"
[[nodiscard]] std::optional<Reason> takeOffByteOrderMark(QByteArray& text);

} // namespace rasterlens
