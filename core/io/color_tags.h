#pragma once
#include "core/base/reason.h"

#include <QByteArray>

#include <optional>

namespace rasterlens
{

/// What the file of a picture says about its colours and this program does not apply: a PNG's gAMA (unless sRGB stands
/// beside it), iCCP or cICP, a JPEG's profile, the gamma of a TGA's extension.
///
/// in      the bytes of a file, of whatever kind
/// out     a sentence without the file name, of the context "Diagnostic"; nothing where the picture says nothing
[[nodiscard]] std::optional<Reason> colorTagRemark(const QByteArray& file);

} // namespace rasterlens
