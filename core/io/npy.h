#pragma once
#include <QByteArray>
#include <QString>
#include <QtEndian>

#include <array>
#include <cassert>
#include <concepts>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace rasterlens
{

/// The numbers a frame's arrays are made of.
template <typename T>
concept NpyNumber = std::same_as<T, float> || std::same_as<T, std::int32_t> || std::same_as<T, std::uint16_t>;

/// How NumPy names the type: little-endian `<f4`, `<i4`, `<u2`.
template <NpyNumber T>
[[nodiscard]] constexpr const char* npyType()
{
    if constexpr (std::same_as<T, float>)
        return "<f4";
    else if constexpr (std::same_as<T, std::int32_t>)
        return "<i4";
    else
        return "<u2";
}

/// What stands before the numbers of a NumPy file, format version 1.0, row by row from the top.
///
/// exact   a multiple of 64 bytes long, ends in a newline
[[nodiscard]] QByteArray npyHeader(const char* type, std::span<const int> shape);
[[nodiscard]] inline QByteArray npyHeader(const char* type, int rows, int columns)
{
    return npyHeader(type, std::array{rows, columns});
}

/// A NumPy file of this shape.
///
/// in      as many numbers as the shape has, the last dimension running fastest
template <NpyNumber T>
[[nodiscard]] QByteArray npyBytes(std::span<const T> values, std::span<const int> shape)
{
    assert(values.size() == std::accumulate(shape.begin(), shape.end(), std::size_t(1), [](std::size_t n, int length) {
               return n * static_cast<std::size_t>(length);
           }));
    QByteArray bytes = npyHeader(npyType<T>(), shape);
    const qsizetype headerSize = bytes.size();
    bytes.resize(headerSize + static_cast<qsizetype>(values.size_bytes()));
    if (!values.empty()) // an empty span may have no address, and memcpy asks for one
        qToLittleEndian<T>(values.data(), static_cast<qsizetype>(values.size()), bytes.data() + headerSize);
    return bytes;
}

/// A NumPy file of shape (rows, columns).
template <NpyNumber T>
[[nodiscard]] QByteArray npyBytes(std::span<const T> values, int rows, int columns)
{
    return npyBytes(values, std::array{rows, columns});
}

/// The array of a NumPy file.
struct NpyArray {
    QString type;              ///< as the file names it: `<f4`, `>i8`, `|b1` ..
    std::vector<qint64> shape; ///< without a last dimension of length 1 behind two others
    /// Row by row, also where the file has them column by column. Integers beyond the 53 bits of a double keep their
    /// type, so that every value is exact.
    std::variant<std::vector<double>, std::vector<std::int64_t>, std::vector<std::uint64_t>> values;

    [[nodiscard]] std::size_t size() const
    {
        return std::visit([](const auto& all) { return all.size(); }, values);
    }
};

struct NpyRead {
    std::optional<NpyArray> array;
    QString error; ///< a sentence, where there is no array
};

/// Whether these are the first bytes of a NumPy file.
[[nodiscard]] bool isNpy(const QByteArray& bytes);

/// Reads an array of real numbers.
///
/// covers  format versions 1 to 3; booleans, integers of 1 to 8 bytes, floats of 2, 4 and 8; both byte orders; both
///         orders of the values; any number of dimensions
/// errors  not NumPy; complex, structured and other types; bytes missing or left over
[[nodiscard]] NpyRead readNpy(const QByteArray& bytes);

/// `(2, 3)` as Python writes it.
[[nodiscard]] QString shapeText(const std::vector<qint64>& shape);

} // namespace rasterlens
