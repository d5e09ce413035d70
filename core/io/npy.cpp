#include "core/io/npy.h"

#include <QByteArrayList>
#include <QFloat16>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <array>
#include <bit>

namespace rasterlens
{
namespace
{

constexpr char kMagic[] = "\x93NUMPY\x01";
constexpr qsizetype kMagicSize = 8;     // with the minor version, 0
constexpr qsizetype kPreambleSize = 10; // and the length of the dictionary, 16 bits
constexpr qsizetype kAlignment = 64;

NpyRead failure(QString error) { return {std::nullopt, std::move(error)}; }

/// What the header says.
struct Header {
    QString type;
    bool columnsFirst = false; ///< Fortran's order
    std::vector<qint64> shape;
    qsizetype dataBegin = 0;
};

/// Where the dictionary lies: versions 2 and 3 have 32 bits for its length.
std::optional<std::pair<qsizetype, qsizetype>> dictionaryOf(const QByteArray& bytes)
{
    const bool isShort = bytes[6] == 1;
    const qsizetype begin = isShort ? kPreambleSize : kPreambleSize + 2;
    if (bytes.size() < begin)
        return std::nullopt;
    const char* length = bytes.constData() + kMagicSize;
    const qsizetype size =
        isShort ? qsizetype{qFromLittleEndian<quint16>(length)} : qsizetype{qFromLittleEndian<quint32>(length)};
    if (bytes.size() - begin < size)
        return std::nullopt;
    return std::pair(begin, size);
}

std::optional<std::vector<qint64>> shapeOf(const QString& text)
{
    std::vector<qint64> shape;
    for (const QString& part : text.split(QLatin1Char(','), Qt::SkipEmptyParts)) {
        QString word = part.trimmed();
        if (word.isEmpty())
            continue;
        if (word.endsWith(QLatin1Char('L'))) // Python 2's long integers
            word.chop(1);
        bool good = false;
        shape.push_back(word.toLongLong(&good));
        if (!good || shape.back() < 0)
            return std::nullopt;
    }
    return shape;
}

/// The dictionary is Python text: the order of its keys, its quotes and its blanks may differ.
///
/// out     false: `error` says why
bool readHeader(const QByteArray& bytes, Header& header, QString& error)
{
    const auto place = dictionaryOf(bytes);
    if (!place) {
        error = QStringLiteral("ends within its header");
        return false;
    }
    header.dataBegin = place->first + place->second;
    const QString text = QString::fromUtf8(bytes.mid(place->first, place->second));
    static const QRegularExpression type(QStringLiteral(R"(['"]descr['"]\s*:\s*(?:['"]([^'"]*)['"]|(\[)))"));
    static const QRegularExpression order(QStringLiteral(R"(['"]fortran_order['"]\s*:\s*(True|False))"));
    static const QRegularExpression shape(QStringLiteral(R"(['"]shape['"]\s*:\s*\(([^)]*)\))"));
    const auto typeMatch = type.match(text);
    const auto orderMatch = order.match(text);
    const auto shapeMatch = shape.match(text);
    const auto lengths = shapeOf(shapeMatch.captured(1));
    if (!typeMatch.hasMatch() || !orderMatch.hasMatch() || !shapeMatch.hasMatch() || !lengths) {
        error = QStringLiteral("has a header without descr, fortran_order and shape");
        return false;
    }
    if (!typeMatch.captured(2).isEmpty()) {
        error = QStringLiteral("holds records; an array of real numbers is expected");
        return false;
    }
    header.type = typeMatch.captured(1);
    header.columnsFirst = orderMatch.captured(1) == QLatin1String("True");
    header.shape = *lengths;
    return true;
}

/// The numbers of a type, row by row in the order of `places`: empty for the order of the file.
template <typename Stored, typename Value>
std::vector<Value> valuesOf(const char* data, std::size_t count, bool bigEndian, const std::vector<std::size_t>& places)
{
    std::vector<Value> values(count);
    for (std::size_t i = 0; i < count; ++i) {
        const char* at = data + (places.empty() ? i : places[i]) * sizeof(Stored);
        std::array<char, sizeof(Stored)> bytes{};
        std::copy_n(at, bytes.size(), bytes.begin());
        if (bigEndian != (std::endian::native == std::endian::big))
            std::reverse(bytes.begin(), bytes.end());
        values[i] = static_cast<Value>(std::bit_cast<Stored>(bytes));
    }
    return values;
}

using Values = decltype(NpyArray::values);
using MakeValues = Values (*)(const char* data, std::size_t count, bool bigEndian,
                              const std::vector<std::size_t>& places);

template <typename Stored, typename Value = double>
Values make(const char* data, std::size_t count, bool bigEndian, const std::vector<std::size_t>& places)
{
    return valuesOf<Stored, Value>(data, count, bigEndian, places);
}

/// One type of numbers.
struct Type {
    const char* name; ///< without the byte order
    int bytes;
    MakeValues make;
};

constexpr Type kTypes[] = {
    {"b1", 1, make<quint8>},
    {"i1", 1, make<qint8>},
    {"i2", 2, make<qint16>},
    {"i4", 4, make<qint32>},
    {"i8", 8, make<qint64, std::int64_t>},
    {"u1", 1, make<quint8>},
    {"u2", 2, make<quint16>},
    {"u4", 4, make<quint32>},
    {"u8", 8, make<quint64, std::uint64_t>},
    {"f2", 2, make<qfloat16>},
    {"f4", 4, make<float>},
    {"f8", 8, make<double>},
};

const Type* typeNamed(const QString& name)
{
    const bool hasOrder = !name.isEmpty() && QStringLiteral("<>|=").contains(name[0]);
    for (const Type& type : kTypes)
        if (name.mid(hasOrder ? 1 : 0) == QLatin1String(type.name))
            return &type;
    return nullptr;
}

QString unknownType(const QString& name)
{
    QStringList names;
    for (const Type& type : kTypes)
        names << QLatin1String(type.name);
    return QStringLiteral("holds numbers of type \"%1\"; those that are compared are %2")
        .arg(name, names.join(QStringLiteral(", ")));
}

/// How many values there are, or nothing beyond 2^48.
std::optional<std::size_t> countOf(const std::vector<qint64>& shape)
{
    constexpr double kMost = 281474976710656.0;
    double count = 1;
    for (const qint64 length : shape)
        count *= static_cast<double>(length);
    return count <= kMost ? std::optional(static_cast<std::size_t>(count)) : std::nullopt;
}

/// Where the file has the values that come one after the other, row by row.
std::vector<std::size_t> placesColumnsFirst(const std::vector<qint64>& shape, std::size_t count)
{
    std::vector<std::size_t> strides(shape.size(), 1);
    for (std::size_t d = 1; d < shape.size(); ++d)
        strides[d] = strides[d - 1] * static_cast<std::size_t>(shape[d - 1]);
    std::vector<std::size_t> places(count, 0);
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t rest = i;
        for (std::size_t d = shape.size(); d-- > 0;) {
            const auto length = static_cast<std::size_t>(shape[d]);
            places[i] += rest % length * strides[d];
            rest /= length;
        }
    }
    return places;
}

} // namespace

QByteArray npyHeader(const char* type, std::span<const int> shape)
{
    QByteArrayList lengths;
    for (const int length : shape)
        lengths << QByteArray::number(length);
    QByteArray dictionary =
        QByteArray("{'descr': '") + type + "', 'fortran_order': False, 'shape': (" + lengths.join(", ") + "), }";
    const qsizetype unpadded = kPreambleSize + dictionary.size() + 1;
    dictionary.append((kAlignment - unpadded % kAlignment) % kAlignment, ' ');
    dictionary.append('\n');

    QByteArray header(kMagic, kMagicSize);
    header.append(static_cast<char>(dictionary.size() & 0xff));
    header.append(static_cast<char>(dictionary.size() >> 8));
    return header + dictionary;
}

bool isNpy(const QByteArray& bytes) { return bytes.startsWith(QByteArray(kMagic, kMagicSize - 2)); }

NpyRead readNpy(const QByteArray& bytes)
{
    if (bytes.size() < kPreambleSize || !isNpy(bytes) || bytes[6] < 1 || bytes[6] > 3)
        return failure(QStringLiteral("is not a NumPy file of format version 1, 2 or 3"));
    Header header;
    QString error;
    if (!readHeader(bytes, header, error))
        return failure(error);
    const Type* type = typeNamed(header.type);
    if (type == nullptr)
        return failure(unknownType(header.type));
    const auto count = countOf(header.shape);
    const auto dataSize = static_cast<std::size_t>(bytes.size() - header.dataBegin);
    const auto valueSize = static_cast<std::size_t>(type->bytes);
    if (!count || dataSize / valueSize != *count || dataSize % valueSize != 0)
        return failure(QStringLiteral("holds another number of values than its shape says"));

    const bool turned = header.columnsFirst && header.shape.size() > 1;
    const std::vector<std::size_t> places =
        turned ? placesColumnsFirst(header.shape, *count) : std::vector<std::size_t>();
    NpyArray array{
        header.type, header.shape,
        type->make(bytes.constData() + header.dataBegin, *count, header.type.startsWith(QLatin1Char('>')), places)};
    if (array.shape.size() > 2 && array.shape.back() == 1)
        array.shape.pop_back();
    return {std::move(array), {}};
}

QString shapeText(const std::vector<qint64>& shape)
{
    QStringList lengths;
    for (const qint64 length : shape)
        lengths << QString::number(length);
    return QStringLiteral("(%1%2)").arg(lengths.join(QStringLiteral(", ")),
                                        lengths.size() == 1 ? QStringLiteral(",") : QString());
}

} // namespace rasterlens
