#pragma once
#include <QImage>
#include <QString>

#include <functional>
#include <optional>

class QPainter;

namespace rasterlens
{

/// Writes a PNG whole or not at all.
///
/// errors  a sentence in the language in use
[[nodiscard]] std::optional<QString> savePng(const QImage& image, const QString& path);

/// Writes what `paint` draws as an SVG drawing, whole or not at all.
///
/// errors  a sentence in the language in use
[[nodiscard]] std::optional<QString> saveSvg(QSize size, const QString& path,
                                             const std::function<void(QPainter&)>& paint);

} // namespace rasterlens
