#pragma once
#include <QPoint>
#include <QSize>
#include <QString>

#include <optional>
#include <vector>

namespace rasterlens
{

/// The numbers in a text that a person typed, in a field or on the command line.
///
/// in      numbers with commas, semicolons or blanks between them, in brackets or not: `3,4`, `3 4`, `(3, 4)`;
///         also with the commas, brackets, digits and signs of East Asian keyboards
/// errors  nothing where any part is no finite number, where a part is missing, or where a bracket is left open
[[nodiscard]] std::optional<std::vector<double>> typedNumbers(const QString& text);

/// The two whole numbers in a text that a person typed, read as typedNumbers() reads; nothing for any other text.
[[nodiscard]] std::optional<QPoint> typedPoint(const QString& text);

/// A width and a height: `12x9`, `12 x 9`, `12×9`, `12*9`, and whatever typedPoint() reads.
///
/// errors  nothing where one of them lies outside 1 to `most`
[[nodiscard]] std::optional<QSize> typedSize(const QString& text, int most);

} // namespace rasterlens
