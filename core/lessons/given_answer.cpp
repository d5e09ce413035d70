#include "core/lessons/given_answer.h"

#include "core/base/typed_numbers.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rasterlens
{
namespace
{

bool contains(const std::vector<QPoint>& pixels, QPoint pixel)
{
    return std::ranges::find(pixels, pixel) != pixels.end();
}

/// The one number that was typed, be it in groups of three digits.
std::optional<double> typedNumber(const QString& given)
{
    static const QRegularExpression groups(QStringLiteral("^\\s*\\d{1,3}(,\\d{3})+\\s*$"));
    const bool isGrouped = groups.match(given).hasMatch();
    const auto numbers = typedNumbers(isGrouped ? QString(given).remove(QLatin1Char(',')) : given);
    return numbers && numbers->size() == 1 ? std::optional(numbers->front()) : std::nullopt;
}

bool isWhole(double value) { return value == std::round(value); }

bool isTyped(const QString& given, const FactValue& value)
{
    if (const auto* text = std::get_if<QString>(&value))
        return given.simplified().compare(*text, Qt::CaseInsensitive) == 0;
    const auto* right = std::get_if<double>(&value);
    const auto typed = typedNumber(given);
    if (!right || !typed)
        return false;
    constexpr double kNear = 0.01;
    return isWhole(*right) ? *typed == *right : std::abs(*typed - *right) <= kNear * std::abs(*right);
}

QString choiceText(const Question& question, std::size_t index)
{
    if (index >= question.choices.size())
        return {};
    const QuestionChoice& choice = question.choices[index];
    return choice.mistake.isEmpty() ? choice.text.en : choice.mistake;
}

/// A field of a line of CSV (RFC 4180). Numbers have the minus sign that programs read.
QString quoted(QString text)
{
    text.replace(QChar(0x2212), QLatin1Char('-'));
    const bool needs =
        text.contains(QLatin1Char(',')) || text.contains(QLatin1Char('"')) || text.contains(QLatin1Char('\n'));
    return needs ? QLatin1Char('"') + text.replace(QLatin1Char('"'), QLatin1String("\"\"")) + QLatin1Char('"') : text;
}

} // namespace

bool isRight(const GivenAnswer& given, const Answer& answer)
{
    if (const auto* pixels = std::get_if<std::vector<QPoint>>(&given)) {
        const auto* right = std::get_if<std::vector<QPoint>>(&answer.value);
        if (!right)
            return false;
        const PixelScore score = scoreOf(*pixels, *right);
        return score.found == score.wanted && score.extra == 0;
    }
    if (const auto* choice = std::get_if<std::size_t>(&given))
        return answer.choice == *choice;
    return isTyped(std::get<QString>(given), answer.value);
}

bool hasTooFewDigits(const GivenAnswer& given, const Answer& answer)
{
    constexpr int kDigits = 3; // are right to a hundredth, whatever they are
    const auto* text = std::get_if<QString>(&given);
    const auto* right = std::get_if<double>(&answer.value);
    const auto typed = text ? typedNumber(*text) : std::nullopt;
    if (!right || !typed || isWhole(*right) || isRight(given, answer))
        return false;
    for (int digits = 1; digits < kDigits; ++digits)
        if (QString::number(*right, 'g', digits).toDouble() == *typed)
            return true;
    return false;
}

PixelScore scoreOf(const std::vector<QPoint>& given, const std::vector<QPoint>& right)
{
    PixelScore score;
    score.wanted = right.size();
    for (const QPoint pixel : given)
        ++(contains(right, pixel) ? score.found : score.extra);
    return score;
}

QString textOf(const Question& question, const GivenAnswer& given)
{
    if (const auto* pixels = std::get_if<std::vector<QPoint>>(&given))
        return textOf(FactValue(*pixels));
    if (const auto* choice = std::get_if<std::size_t>(&given))
        return choiceText(question, *choice);
    return std::get<QString>(given);
}

QString textOf(const Question& question, const Answer& answer)
{
    return answer.choice ? choiceText(question, *answer.choice) : textOf(answer.value);
}

QByteArray answersAsCsv(std::span<const AnswerRow> rows)
{
    QString text = QStringLiteral("lesson,slide,kind,given,right,is_right\n");
    for (const AnswerRow& row : rows)
        text += QStringList{quoted(row.lesson), QString::number(row.slide),
                            row.kind,           quoted(row.given),
                            quoted(row.right),  row.isRight ? QStringLiteral("1") : QStringLiteral("0")}
                    .join(QLatin1Char(',')) +
                QLatin1Char('\n');
    return text.toUtf8();
}

} // namespace rasterlens
