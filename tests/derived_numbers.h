#pragma once
// Reads the printed form of a derivation's numbers back: a value, and how far the printed digits leave it open.
#include <QString>
#include <QStringView>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace rasterlens::test
{

/// A number that is known to lie within `error` of `value`.
struct Printed {
    double value = 0;
    double error = 0;
    double size = 0; ///< how large the numbers it was computed from are; rounding is a part of this
};

/// Computes with printed formulas: `−3·(2 − 0.5)`, `1001₂ AND 0001₂ = 0`, `(1, 2)`. Written apart from the reader of
/// core/derive, which reads formulas with symbols.
class PrintedFormula
{
public:
    explicit PrintedFormula(const QString& text) : m_text(text) {}

    std::vector<Printed> read()
    {
        std::vector<Printed> values;
        const bool isList = m_text.startsWith(QLatin1Char('(')) && closes(0) == m_text.size() - 1 && hasComma();
        if (isList)
            values = list();
        else
            values.push_back(comparison());
        if (!next().isNull())
            fail();
        return values;
    }

private:
    [[noreturn]] void fail() const
    {
        throw std::runtime_error(QStringLiteral("%1 at %2").arg(m_text).arg(m_at).toStdString());
    }

    [[nodiscard]] qsizetype closes(qsizetype open) const
    {
        int depth = 0;
        for (qsizetype i = open; i < m_text.size(); ++i) {
            depth += m_text[i] == QLatin1Char('(') ? 1 : m_text[i] == QLatin1Char(')') ? -1 : 0;
            if (depth == 0)
                return i;
        }
        return -1;
    }

    [[nodiscard]] bool hasComma() const
    {
        int depth = 0;
        for (const QChar c : m_text) {
            depth += c == QLatin1Char('(') ? 1 : c == QLatin1Char(')') ? -1 : 0;
            if (depth == 1 && c == QLatin1Char(','))
                return true;
        }
        return false;
    }

    QChar next()
    {
        while (m_at < m_text.size() && m_text[m_at] == QLatin1Char(' '))
            ++m_at;
        return m_at < m_text.size() ? m_text[m_at] : QChar();
    }

    bool take(QChar c)
    {
        if (next() != c)
            return false;
        ++m_at;
        return true;
    }

    std::vector<Printed> list()
    {
        std::vector<Printed> values;
        if (!take(QLatin1Char('(')))
            fail();
        do
            values.push_back(sum());
        while (take(QLatin1Char(',')));
        if (!take(QLatin1Char(')')))
            fail();
        return values;
    }

    Printed comparison()
    {
        const Printed left = sum();
        const QChar sign = next();
        if (sign.isNull())
            return left;
        ++m_at;
        const Printed right = sum();
        const double d = left.value - right.value;
        const bool isOpen = std::abs(d) <= left.error + right.error && left.error + right.error > 0;
        const bool holds = sign == QChar(0x2264)      ? d <= 0
                           : sign == QChar(0x2265)    ? d >= 0
                           : sign == QLatin1Char('<') ? d < 0
                           : sign == QLatin1Char('>') ? d > 0
                                                      : d == 0;
        return {holds ? 1.0 : 0.0, isOpen ? 1.0 : 0.0, 1};
    }

    Printed sum()
    {
        Printed a = product();
        for (;;) {
            const bool isPlus = take(QLatin1Char('+'));
            if (!isPlus && !take(QChar(0x2212)))
                return a;
            const Printed b = product();
            a = {isPlus ? a.value + b.value : a.value - b.value, a.error + b.error, std::max(a.size, b.size)};
        }
    }

    Printed product()
    {
        Printed a = factor();
        for (;;) {
            if (take(QChar(0xb7))) {
                const Printed b = factor();
                a = {a.value * b.value, std::abs(a.value) * b.error + std::abs(b.value) * a.error + a.error * b.error,
                     a.size * b.size};
            } else if (take(QLatin1Char('/'))) {
                const Printed b = factor();
                const double least = std::abs(b.value) - b.error;
                a = {a.value / b.value, (a.error + std::abs(a.value / b.value) * b.error) / least,
                     a.size * b.size / (least * least)};
            } else if (QStringView(m_text).sliced(m_at).trimmed().startsWith(QLatin1String("AND"))) {
                m_at = m_text.indexOf(QLatin1String("AND"), m_at) + 3;
                a = {double(int(a.value) & int(factor().value)), 0, 15};
            } else {
                return a;
            }
        }
    }

    Printed factor()
    {
        if (take(QChar(0x2212))) {
            const Printed a = factor();
            return {-a.value, a.error, a.size};
        }
        if (take(QLatin1Char('('))) {
            const Printed a = sum();
            if (!take(QLatin1Char(')')))
                fail();
            return a;
        }
        if (take(QLatin1Char('|'))) {
            const Printed a = sum();
            if (!take(QLatin1Char('|')))
                fail();
            return {std::abs(a.value), a.error, a.size};
        }
        return next().isDigit() ? number() : call();
    }

    Printed number()
    {
        const qsizetype from = m_at;
        const auto isPart = [&](QChar c) {
            const bool isExponent = m_at > from && m_text[m_at - 1] == QLatin1Char('e');
            return c.isDigit() || c == QLatin1Char('.') || c == QLatin1Char('e') ||
                   (isExponent && (c == QLatin1Char('-') || c == QLatin1Char('+')));
        };
        // A subscript 2 is a digit of Unicode, but none of the number.
        while (m_at < m_text.size() && m_text[m_at] != QChar(0x2082) && isPart(m_text[m_at]))
            ++m_at;
        const QString text = m_text.sliced(from, m_at - from);
        if (take(QChar(0x2082)))
            return {double(text.toInt(nullptr, 2)), 0, 15};
        const double value = text.toDouble();
        // Nine digits are printed, without zeros at the end: half a unit of the ninth is at most this part of the
        // value.
        constexpr double kPart = 5e-9;
        const bool isWhole = !text.contains(QLatin1Char('.')) && !text.contains(QLatin1Char('e')) && text.size() < 9;
        return {value, isWhole ? 0 : std::abs(value) * kPart, std::abs(value)};
    }

    Printed call()
    {
        const qsizetype from = m_at;
        while (m_at < m_text.size() && m_text[m_at].isLetter())
            ++m_at;
        const QString name = m_text.sliced(from, m_at - from);
        const std::vector<Printed> of = list();
        const auto less = [](const Printed& a, const Printed& b) { return a.value < b.value; };
        double error = 0;
        double size = 0;
        for (const Printed& a : of) {
            error = std::max(error, a.error);
            size = std::max(size, a.size);
        }
        if (name == QLatin1String("max"))
            return {std::max_element(of.begin(), of.end(), less)->value, error, size};
        if (name == QLatin1String("min"))
            return {std::min_element(of.begin(), of.end(), less)->value, error, size};
        if (name == QLatin1String("sqrt"))
            return {std::sqrt(of[0].value), error / std::sqrt(of[0].value), size};
        if (name == QLatin1String("floor")) {
            const double slack = error + 1e-6 * size;
            return {std::floor(of[0].value), std::floor(of[0].value + slack) - std::floor(of[0].value - slack), size};
        }
        if (name == QLatin1String("ceil")) {
            const double slack = error + 1e-6 * size;
            return {std::ceil(of[0].value), std::ceil(of[0].value + slack) - std::ceil(of[0].value - slack), size};
        }
        if (name == QLatin1String("lerp")) {
            const double way = of[1].value - of[0].value;
            return {of[0].value + of[2].value * way, 3 * error + std::abs(way) * of[2].error,
                    std::max(size, std::abs(way))};
        }
        fail();
    }

    QString m_text;
    qsizetype m_at = 0;
};

} // namespace rasterlens::test
