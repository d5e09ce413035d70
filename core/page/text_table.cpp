#include "core/page/text_table.h"

#include <algorithm>

namespace rasterlens
{

int TextTable::add(const TwoTexts& text)
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
