#pragma once
#include <QByteArray>
#include <QString>

#include <optional>
#include <string_view>

namespace rasterlens
{

constexpr char kChineseEncoding[] = "GB18030"; ///< holds all of GBK and GB2312

/// The text of bytes in an encoding, or nothing where they are not of that encoding or Qt was built without it.
[[nodiscard]] std::optional<QString> asUtf8(const QByteArray& bytes);
[[nodiscard]] std::optional<QString> asChinese(const QByteArray& bytes);

/// File names are bytes. As a QString such a name is its UTF-8 text; one that is not UTF-8 has each byte from 0x80 on
/// as a lone surrogate, U+DC80 to U+DCFF, so that nothing is lost.
[[nodiscard]] QString pathFromBytes(const QByteArray& bytes);
[[nodiscard]] QByteArray bytesOfPath(const QString& path);

/// A name for people, read as UTF-8, else as GB18030, else as Latin-1.
[[nodiscard]] QString readableName(std::string_view bytes);

/// A path of pathFromBytes() for people.
[[nodiscard]] QString readablePath(const QString& path);

} // namespace rasterlens
