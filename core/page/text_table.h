#pragma once
#include "core/lessons/moment.h"
#include "core/page/page_words.h"

#include <QHash>
#include <QJsonArray>

#include <utility>

namespace rasterlens
{

/// The texts of a page in both languages, each once: what refers to a text has its number.
class TextTable
{
public:
    [[nodiscard]] int add(const TwoTexts& text);
    /// Pairs of lines; a list that is longer in one language is filled up with empty lines.
    [[nodiscard]] QJsonArray add(const QStringList& english, const QStringList& chinese);

    /// `"text"` where both languages are the same, else `["text", "文字"]`; or `[7, "8 #ff0000"]`: text 7, in whose
    /// both languages these numbers and colours take the places of U+FFFC. Texts of steps differ by their numbers
    /// alone.
    [[nodiscard]] const QJsonArray& json() const { return m_texts; }

private:
    [[nodiscard]] int addWhole(const TwoTexts& text);

    QJsonArray m_texts;
    QHash<std::pair<QString, QString>, int> m_numbers;
};

/// Calls make() once in each language.
template <class Make>
[[nodiscard]] auto inBothLanguages(PageWords& words, Make&& make)
{
    words.use(PageLanguage::English);
    auto english = make();
    words.use(PageLanguage::Chinese);
    auto chinese = make();
    return std::pair(std::move(english), std::move(chinese));
}

/// One text in both languages.
template <class Make>
[[nodiscard]] TwoTexts textInBoth(PageWords& words, Make&& make)
{
    auto [english, chinese] = inBothLanguages(words, std::forward<Make>(make));
    return {std::move(english), std::move(chinese)};
}

} // namespace rasterlens
