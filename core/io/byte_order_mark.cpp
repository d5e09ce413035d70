#include "core/io/byte_order_mark.h"

#include <algorithm>

namespace rasterlens
{
namespace
{

/// Whether every other byte of the beginning, from `first` on, is zero and no byte between them is.
bool hasZerosFrom(const QByteArray& text, qsizetype first)
{
    constexpr qsizetype kLooked = 64;
    const qsizetype end = std::min(text.size() / 2 * 2, kLooked);
    for (qsizetype i = 0; i < end; ++i)
        if ((text[i] == '\0') != (i % 2 == first))
            return false;
    return end >= 4;
}

const char* encodingOf(const QByteArray& text)
{
    if (text.startsWith(QByteArray("\xff\xfe\0\0", 4)) || text.startsWith(QByteArray("\0\0\xfe\xff", 4)))
        return "UTF-32";
    if (text.startsWith("\xff\xfe") || text.startsWith("\xfe\xff") || hasZerosFrom(text, 0) || hasZerosFrom(text, 1))
        return "UTF-16";
    return nullptr;
}

} // namespace

std::optional<Reason> takeOffByteOrderMark(QByteArray& text)
{
    if (const char* encoding = encodingOf(text))
        return Reason(QT_TRANSLATE_NOOP("Diagnostic", "the text is %1; UTF-8 or ASCII is expected"),
                      {QString::fromLatin1(encoding)});
    if (text.startsWith("\xef\xbb\xbf"))
        text.remove(0, 3);
    return std::nullopt;
}

} // namespace rasterlens
