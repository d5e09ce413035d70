#pragma once
#include <QStringList>

namespace rasterlens
{

/// Finds a text in another language; the context is the caller's.
using Translate = QString (*)(const char* text);

/// Why something is as it is: a text with %1, %2 .. and what stands in their place.
struct Reason {
    const char* text;
    QStringList arguments = {};
};

/// The reason in words, in English without `translate`.
[[nodiscard]] QString textOf(const Reason& reason, Translate translate = nullptr);

} // namespace rasterlens
