#include "core/page/text_table.h"

#include <QRegularExpression>

#include <algorithm>

namespace rasterlens
{
namespace
{

constexpr QChar kPlace(QChar::ObjectReplacementCharacter);

/// A text with places for its numbers, and the numbers, with blanks between them.
struct Form {
    QString text;
    QString numbers;
};

Form formOf(const QString& text)
{
    static const QRegularExpression number(QStringLiteral("#[0-9a-f]{6}|\\d+(\\.\\d+)?"));
    QStringList numbers;
    for (auto it = number.globalMatch(text); it.hasNext();)
        numbers << it.next().captured();
    return {QString(text).replace(number, QString(kPlace)), numbers.join(QLatin1Char(' '))};
}

} // namespace

int TextTable::add(const TwoTexts& text)
{
    const std::pair key(text.en, text.zh);
    if (const auto found = m_numbers.constFind(key); found != m_numbers.constEnd())
        return *found;
    const Form en = formOf(text.en);
    const Form zh = formOf(text.zh);
    if (en.numbers.isEmpty() || en.numbers != zh.numbers || text.en.contains(kPlace) || text.zh.contains(kPlace))
        return addWhole(text);
    const int form = addWhole({en.text, zh.text});
    const auto number = static_cast<int>(m_texts.size());
    m_numbers.insert(key, number);
    m_texts << QJsonArray{form, en.numbers};
    return number;
}

int TextTable::addWhole(const TwoTexts& text)
{
    const std::pair key(text.en, text.zh);
    if (const auto found = m_numbers.constFind(key); found != m_numbers.constEnd())
        return *found;
    const auto number = static_cast<int>(m_texts.size());
    m_numbers.insert(key, number);
    m_texts << (text.en == text.zh ? QJsonValue(text.en) : QJsonValue(QJsonArray{text.en, text.zh}));
    return number;
}

QJsonArray TextTable::add(const QStringList& english, const QStringList& chinese)
{
    QJsonArray numbers;
    for (qsizetype i = 0; i < std::max(english.size(), chinese.size()); ++i)
        numbers << add({english.value(i), chinese.value(i)});
    return numbers;
}

} // namespace rasterlens
