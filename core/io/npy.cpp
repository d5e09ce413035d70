#include "core/io/npy.h"

#include <QRegularExpression>

#include <limits>

namespace rasterlens
{
namespace
{

constexpr char kMagic[] = "\x93NUMPY\x01";
constexpr qsizetype kMagicSize = 8;     // with the minor version, 0
constexpr qsizetype kPreambleSize = 10; // and the length of the dictionary, 16 bits
constexpr qsizetype kAlignment = 64;

NpyRead failure(const char* error) { return {std::nullopt, QString::fromLatin1(error)}; }

template <NpyNumber T>
std::vector<double> toDoubles(const char* data, std::size_t count)
{
    std::vector<T> values(count);
    qFromLittleEndian<T>(data, static_cast<qsizetype>(count), values.data());
    return {values.begin(), values.end()};
}

} // namespace

QByteArray npyHeader(const char* type, int rows, int columns)
{
    QByteArray dictionary = QByteArray("{'descr': '") + type + "', 'fortran_order': False, 'shape': (" +
                            QByteArray::number(rows) + ", " + QByteArray::number(columns) + "), }";
    const qsizetype unpadded = kPreambleSize + dictionary.size() + 1;
    dictionary.append((kAlignment - unpadded % kAlignment) % kAlignment, ' ');
    dictionary.append('\n');

    QByteArray header(kMagic, kMagicSize);
    header.append(static_cast<char>(dictionary.size() & 0xff));
    header.append(static_cast<char>(dictionary.size() >> 8));
    return header + dictionary;
}

NpyRead readNpy(const QByteArray& bytes)
{
    if (bytes.size() < kPreambleSize || !bytes.startsWith(QByteArray(kMagic, kMagicSize)))
        return failure("is not a NumPy file of format version 1.0");
    const qsizetype dictionarySize = qFromLittleEndian<quint16>(bytes.constData() + kMagicSize);
    const qsizetype dataBegin = kPreambleSize + dictionarySize;
    if (bytes.size() < dataBegin)
        return failure("ends within its header");

    static const QRegularExpression pattern(QStringLiteral(
        R"(^\{'descr': '(<f4|<i4|<u2)', 'fortran_order': False, 'shape': \(([0-9]{1,9}), ([0-9]{1,9})\), \} *\n$)"));
    const auto match = pattern.match(QString::fromLatin1(bytes.mid(kPreambleSize, dictionarySize)));
    if (!match.hasMatch())
        return failure("holds another array than one of two dimensions, row by row, of <f4, <i4 or <u2");

    NpyArray array{match.captured(1), match.captured(2).toInt(), match.captured(3).toInt(), {}};
    const qsizetype count = static_cast<qsizetype>(array.rows) * array.columns;
    const qsizetype valueSize = array.type == QLatin1String("<u2") ? 2 : 4;
    const qsizetype dataSize = bytes.size() - dataBegin;
    if (dataSize / valueSize != count || dataSize % valueSize != 0)
        return failure("holds another number of values than its shape says");

    const char* data = bytes.constData() + dataBegin;
    const auto size = static_cast<std::size_t>(count);
    if (array.type == QLatin1String("<f4"))
        array.values = toDoubles<float>(data, size);
    else if (array.type == QLatin1String("<i4"))
        array.values = toDoubles<std::int32_t>(data, size);
    else
        array.values = toDoubles<std::uint16_t>(data, size);
    return {array, {}};
}

} // namespace rasterlens
