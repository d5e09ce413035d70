#include "core/io/path_bytes.h"

#include <QStringConverter>

namespace rasterlens
{
namespace
{

constexpr char16_t kEscapesBegin = 0xDC00; ///< the escape of a byte is this plus the byte

bool isEscape(QChar c) { return c.unicode() >= kEscapesBegin + 0x80 && c.unicode() <= kEscapesBegin + 0xFF; }

/// The text of bytes in an encoding, or nothing where they are not of that encoding or Qt was built without it.
std::optional<QString> decoded(const QByteArray& bytes, QStringDecoder decoder)
{
    if (!decoder.isValid())
        return std::nullopt;
    QString text = decoder.decode(bytes);
    if (decoder.hasError() || text.contains(QChar::ReplacementCharacter))
        return std::nullopt;
    return text;
}

} // namespace

std::optional<QString> asUtf8(const QByteArray& bytes) { return decoded(bytes, QStringDecoder(QStringDecoder::Utf8)); }

std::optional<QString> asChinese(const QByteArray& bytes) { return decoded(bytes, QStringDecoder(kChineseEncoding)); }

QString pathFromBytes(const QByteArray& bytes)
{
    if (const auto text = asUtf8(bytes))
        return *text;
    QString path;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        path += QChar(static_cast<char16_t>(byte < 0x80 ? byte : kEscapesBegin + byte));
    }
    return path;
}

QByteArray bytesOfPath(const QString& path)
{
    QByteArray bytes;
    qsizetype plainBegin = 0;
    for (qsizetype i = 0; i < path.size(); ++i) {
        const bool pairs = i > 0 && path[i - 1].isHighSurrogate();
        if (!isEscape(path[i]) || pairs)
            continue;
        bytes += path.mid(plainBegin, i - plainBegin).toUtf8();
        bytes += static_cast<char>(path[i].unicode() - kEscapesBegin);
        plainBegin = i + 1;
    }
    return bytes + path.mid(plainBegin).toUtf8();
}

QString readableName(std::string_view name)
{
    const QByteArray bytes(name.data(), static_cast<qsizetype>(name.size()));
    if (const auto utf8 = asUtf8(bytes))
        return *utf8;
    return asChinese(bytes).value_or(QString::fromLatin1(bytes));
}

QString readablePath(const QString& path)
{
    const QByteArray bytes = bytesOfPath(path);
    return readableName({bytes.data(), static_cast<std::size_t>(bytes.size())});
}

} // namespace rasterlens
