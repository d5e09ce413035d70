#pragma once
#include <QByteArray>
#include <QPainter>
#include <QSize>
#include <QString>

#include <functional>

namespace rasterlens::cli
{

/// A figure as a file. Fonts need an application, which this makes: one that asks for no display.
///
/// in  format  svg, or one that imageBytes() knows
[[nodiscard]] QByteArray figureBytes(const QByteArray& format, QSize size, const QString& title,
                                     const std::function<void(QPainter&)>& paint);

} // namespace rasterlens::cli
