#pragma once
#include <QString>

#include <concepts>
#include <utility>
#include <vector>

namespace rasterlens
{

/// Finds a text in another language; the context is the caller's.
using Translate = QString (*)(const char* text);

/// Why something is as it is: a text with %1, %2 .. and what stands in their place, each a name, a number or a reason
/// of its own.
struct Reason {
    /// in   a literal, marked by QT_TRANSLATE_NOOP
    Reason(const char* text, std::vector<Reason> arguments = {}) : text(text), arguments(std::move(arguments)) {}
    /// What is the same in all languages.
    Reason(QString name) : name(std::move(name)) {}
    Reason(std::integral auto number) : name(QString::number(number)) {}

    const char* text = nullptr; ///< none: `name` stands for itself
    QString name;
    std::vector<Reason> arguments;
};

/// The reason in words, in English without `translate`.
[[nodiscard]] QString textOf(const Reason& reason, Translate translate = nullptr);

} // namespace rasterlens
