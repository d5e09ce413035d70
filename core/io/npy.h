#pragma once
#include <QByteArray>
#include <QString>
#include <QtEndian>

#include <cassert>
#include <concepts>
#include <cstdint>
#include <optional>
#include <span>
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
[[nodiscard]] QByteArray npyHeader(const char* type, int rows, int columns);

/// A NumPy file of shape (rows, columns).
///
/// in      rows * columns numbers, row by row
template <NpyNumber T>
[[nodiscard]] QByteArray npyBytes(std::span<const T> values, int rows, int columns)
{
    assert(values.size() == static_cast<std::size_t>(rows) * static_cast<std::size_t>(columns));
    QByteArray bytes = npyHeader(npyType<T>(), rows, columns);
    const qsizetype headerSize = bytes.size();
    bytes.resize(headerSize + static_cast<qsizetype>(values.size_bytes()));
    qToLittleEndian<T>(values.data(), static_cast<qsizetype>(values.size()), bytes.data() + headerSize);
    return bytes;
}

/// The array of a NumPy file.
struct NpyArray {
    QString type; ///< `<f4`, `<i4` or `<u2`
    int rows = 0;
    int columns = 0;
    std::vector<double> values; ///< rows * columns; a double holds each of the three types exactly
};

struct NpyRead {
    std::optional<NpyArray> array;
    QString error; ///< a sentence, where there is no array
};

/// Reads what npyBytes writes.
///
/// errors  not NumPy, other versions, types or orders, another number of dimensions than two, bytes missing or left
/// over
[[nodiscard]] NpyRead readNpy(const QByteArray& bytes);

} // namespace rasterlens
