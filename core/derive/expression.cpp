#include "core/derive/expression.h"

#include <QStringView>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace rasterlens
{
namespace
{

std::optional<Ratio> reduced(std::int64_t numerator, std::int64_t denominator)
{
    constexpr std::int64_t kMost = std::int64_t(1) << 62;
    if (denominator == 0 || std::abs(numerator) > kMost || std::abs(denominator) > kMost)
        return std::nullopt;
    const std::int64_t divisor = std::gcd(numerator, denominator) * (denominator < 0 ? -1 : 1);
    return Ratio{numerator / divisor, denominator / divisor};
}

std::optional<Ratio> sum(const Ratio& a, const Ratio& b, std::int64_t sign)
{
    std::int64_t left = 0;
    std::int64_t right = 0;
    std::int64_t numerator = 0;
    std::int64_t denominator = 0;
    if (__builtin_mul_overflow(a.numerator, b.denominator, &left) ||
        __builtin_mul_overflow(sign * b.numerator, a.denominator, &right) ||
        __builtin_add_overflow(left, right, &numerator) ||
        __builtin_mul_overflow(a.denominator, b.denominator, &denominator))
        return std::nullopt;
    return reduced(numerator, denominator);
}

std::optional<Ratio> product(const Ratio& a, const Ratio& b)
{
    std::int64_t numerator = 0;
    std::int64_t denominator = 0;
    if (__builtin_mul_overflow(a.numerator, b.numerator, &numerator) ||
        __builtin_mul_overflow(a.denominator, b.denominator, &denominator))
        return std::nullopt;
    return reduced(numerator, denominator);
}

std::optional<Ratio> quotient(const Ratio& a, const Ratio& b)
{
    return b.numerator == 0 ? std::nullopt : product(a, Ratio{b.denominator, b.numerator});
}

template <class Operation>
std::optional<Ratio> both(const Quantity& a, const Quantity& b, Operation&& operation)
{
    return a.exact && b.exact ? operation(*a.exact, *b.exact) : std::nullopt;
}

Quantity operator+(const Quantity& a, const Quantity& b)
{
    return {a.value + b.value, both(a, b, [](auto& p, auto& q) { return sum(p, q, 1); })};
}

Quantity operator-(const Quantity& a, const Quantity& b)
{
    return {a.value - b.value, both(a, b, [](auto& p, auto& q) { return sum(p, q, -1); })};
}

Quantity operator*(const Quantity& a, const Quantity& b) { return {a.value * b.value, both(a, b, product)}; }
Quantity operator/(const Quantity& a, const Quantity& b) { return {a.value / b.value, both(a, b, quotient)}; }

Quantity whole(double value) { return {value, ratioOf(value)}; }

/// -1, 0 or 1 as the first is less than, equal to or greater than the second.
int compare(const Quantity& a, const Quantity& b)
{
    if (const auto difference = both(a, b, [](auto& p, auto& q) { return sum(p, q, -1); }))
        return difference->numerator < 0 ? -1 : difference->numerator > 0 ? 1 : 0;
    return a.value < b.value ? -1 : a.value > b.value ? 1 : 0;
}

Quantity absolute(const Quantity& a) { return a.value < 0 ? Quantity{0, Ratio{}} - a : a; }

/// Reads a formula from left to right by the rules of precedence.
class FormulaReader
{
public:
    FormulaReader(const QString& formula, const SymbolValue& symbol) : m_text(formula), m_symbol(symbol) {}

    std::vector<Quantity> read()
    {
        std::vector<Quantity> values = isList() ? list() : std::vector<Quantity>{comparison()};
        if (!peek().isNull())
            fail();
        return values;
    }

private:
    [[noreturn]] void fail() const
    {
        throw std::logic_error("not a formula: " + m_text.toStdString() + " at " + std::to_string(m_at));
    }

    /// The next character that is no blank; null at the end.
    QChar peek()
    {
        while (m_at < m_text.size() && m_text[m_at].isSpace())
            ++m_at;
        return m_at < m_text.size() ? m_text[m_at] : QChar();
    }

    bool take(const char* text)
    {
        peek();
        const QLatin1String wanted(text);
        if (QStringView(m_text).sliced(m_at).startsWith(wanted)) {
            m_at += wanted.size();
            return true;
        }
        return false;
    }

    void expect(const char* text)
    {
        if (!take(text))
            fail();
    }

    /// Whether the formula is a list: one bracket around all of it, with a comma that is in no other.
    [[nodiscard]] bool isList() const
    {
        const QString text = m_text.trimmed();
        if (!text.startsWith(QLatin1Char('(')))
            return false;
        int depth = 0;
        bool hasComma = false;
        for (qsizetype i = 0; i < text.size(); ++i) {
            depth += text[i] == QLatin1Char('(') ? 1 : text[i] == QLatin1Char(')') ? -1 : 0;
            hasComma = hasComma || (depth == 1 && text[i] == QLatin1Char(','));
            if (depth == 0)
                return hasComma && i + 1 == text.size();
        }
        return false;
    }

    std::vector<Quantity> list()
    {
        std::vector<Quantity> values;
        expect("(");
        do
            values.push_back(addition());
        while (take(","));
        expect(")");
        return values;
    }

    Quantity comparison()
    {
        const Quantity left = addition();
        if (take("<="))
            return whole(compare(left, addition()) <= 0 ? 1 : 0);
        if (take(">="))
            return whole(compare(left, addition()) >= 0 ? 1 : 0);
        if (take("=="))
            return whole(compare(left, addition()) == 0 ? 1 : 0);
        if (take("<"))
            return whole(compare(left, addition()) < 0 ? 1 : 0);
        if (take(">"))
            return whole(compare(left, addition()) > 0 ? 1 : 0);
        return left;
    }

    Quantity addition()
    {
        Quantity value = multiplication();
        for (;;) {
            if (take("+"))
                value = value + multiplication();
            else if (take("-"))
                value = value - multiplication();
            else
                return value;
        }
    }

    Quantity multiplication()
    {
        Quantity value = factor();
        for (;;) {
            if (take("*"))
                value = value * factor();
            else if (take("/"))
                value = value / factor();
            else if (take("&"))
                value = whole(double(std::int64_t(value.value) & std::int64_t(factor().value)));
            else
                return value;
        }
    }

    Quantity factor()
    {
        if (take("-"))
            return Quantity{0, Ratio{}} - factor();
        if (take("{"))
            return symbol();
        if (take("(")) {
            const Quantity value = addition();
            expect(")");
            return value;
        }
        if (take("|")) {
            const Quantity value = absolute(addition());
            expect("|");
            return value;
        }
        return peek().isDigit() ? number() : call();
    }

    Quantity symbol()
    {
        const qsizetype end = m_text.indexOf(QLatin1Char('}'), m_at);
        if (end < 0)
            fail();
        const QString id = m_text.sliced(m_at, end - m_at);
        m_at = end + 1;
        return m_symbol(id);
    }

    Quantity number()
    {
        const qsizetype from = m_at;
        while (m_at < m_text.size() && (m_text[m_at].isDigit() || m_text[m_at] == QLatin1Char('.')))
            ++m_at;
        return whole(QStringView(m_text).sliced(from, m_at - from).toDouble());
    }

    Quantity call()
    {
        const qsizetype from = m_at;
        while (m_at < m_text.size() && m_text[m_at].isLetter())
            ++m_at;
        const QString name = m_text.sliced(from, m_at - from);
        const std::vector<Quantity> values = list();
        const auto isLess = [](const Quantity& a, const Quantity& b) { return compare(a, b) < 0; };
        if (name == QLatin1String("max"))
            return *std::ranges::max_element(values, isLess);
        if (name == QLatin1String("min"))
            return *std::ranges::min_element(values, isLess);
        if (name == QLatin1String("floor"))
            return whole(std::floor(values.front().value));
        if (name == QLatin1String("ceil"))
            return whole(std::ceil(values.front().value));
        if (name == QLatin1String("sqrt"))
            return {std::sqrt(values.front().value), std::nullopt};
        if (name == QLatin1String("lerp") && values.size() == 3)
            return values[0] + values[2] * (values[1] - values[0]);
        fail();
    }

    const QString& m_text;
    const SymbolValue& m_symbol;
    qsizetype m_at = 0;
};

} // namespace

std::optional<Ratio> ratioOf(double value)
{
    constexpr double kUnits = 65536;
    constexpr double kMost = 0x1p40;
    const double scaled = value * kUnits;
    if (!(std::abs(scaled) < kMost) || scaled != std::floor(scaled))
        return std::nullopt;
    return reduced(static_cast<std::int64_t>(scaled), static_cast<std::int64_t>(kUnits));
}

QString ratioText(const Ratio& ratio)
{
    const QString numerator = QString::number(ratio.numerator);
    return ratio.denominator == 1 ? numerator : QStringLiteral("%1/%2").arg(numerator).arg(ratio.denominator);
}

std::vector<Quantity> evaluate(const QString& formula, const SymbolValue& symbol)
{
    return FormulaReader(formula, symbol).read();
}

} // namespace rasterlens
