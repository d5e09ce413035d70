#include "core/base/typed_numbers.h"

#include <QRegularExpression>
#include <QStringList>

#include <cmath>

namespace rasterlens
{
namespace
{

/// With the signs of ASCII, without the brackets around all of it.
///
/// errors  nothing where a bracket has no partner
std::optional<QString> withoutBrackets(const QString& typed)
{
    // The compatibility form turns full-width signs into those of ASCII.
    QString text = typed.normalized(QString::NormalizationForm_KC).trimmed();
    text.replace(QChar(0x2212), QLatin1Char('-')).replace(QChar(0x3001), QLatin1Char(','));
    constexpr std::pair<char, char> kBrackets[] = {{'(', ')'}, {'[', ']'}};
    for (const auto& [open, close] : kBrackets) {
        if (text.startsWith(QLatin1Char(open)) != text.endsWith(QLatin1Char(close)))
            return std::nullopt;
        if (text.size() > 1 && text.startsWith(QLatin1Char(open)))
            return text.mid(1, text.size() - 2).trimmed();
    }
    return text;
}

std::optional<QPoint> wholePair(const QStringList& parts)
{
    bool goodX = false;
    bool goodY = false;
    const QPoint point(parts.value(0).toInt(&goodX), parts.value(1).toInt(&goodY));
    return goodX && goodY && parts.size() == 2 ? std::optional(point) : std::nullopt;
}

const QRegularExpression& between()
{
    static const QRegularExpression pattern(QStringLiteral("\\s*[,;]\\s*|\\s+"));
    return pattern;
}

} // namespace

std::optional<std::vector<double>> typedNumbers(const QString& text)
{
    const auto inner = withoutBrackets(text);
    if (!inner)
        return std::nullopt;
    std::vector<double> numbers;
    const QStringList parts = inner->split(between());
    for (const QString& part : parts) {
        bool good = false;
        numbers.push_back(part.toDouble(&good));
        if (!good || !std::isfinite(numbers.back()))
            return std::nullopt;
    }
    return numbers;
}

std::optional<QPoint> typedPoint(const QString& text)
{
    const auto inner = withoutBrackets(text);
    return inner ? wholePair(inner->split(between())) : std::nullopt;
}

std::optional<QSize> typedSize(const QString& text, int most)
{
    static const QRegularExpression times(QStringLiteral("\\s*[,;xX*\\x{d7}]\\s*|\\s+"));
    const auto inner = withoutBrackets(text);
    const auto pair = inner ? wholePair(inner->split(times)) : std::nullopt;
    const auto inRange = [most](int value) { return value >= 1 && value <= most; };
    if (!pair || !inRange(pair->x()) || !inRange(pair->y()))
        return std::nullopt;
    return QSize(pair->x(), pair->y());
}

} // namespace rasterlens
