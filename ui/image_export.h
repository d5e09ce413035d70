#pragma once
#include <QImage>
#include <QString>

#include <optional>

namespace rasterlens
{

/// Writes a PNG whole or not at all.
///
/// errors  a sentence in the language in use
[[nodiscard]] std::optional<QString> savePng(const QImage& image, const QString& path);

} // namespace rasterlens
