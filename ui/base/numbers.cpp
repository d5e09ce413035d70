#include "ui/base/numbers.h"

#include <QRegularExpression>

namespace rasterlens
{

QString shortened(std::uint64_t value)
{
    constexpr std::uint64_t kShownWhole = 10000;
    if (value < kShownWhole)
        return QString::number(value);
    double rest = static_cast<double>(value);
    int unit = -1;
    constexpr char kUnits[] = "kMGTPE";
    do {
        rest /= 1000;
        ++unit;
    } while (rest >= 999.5);
    return QString::number(rest, 'g', 3) + QLatin1Char(kUnits[unit]);
}

QString channelChanges(QRgb from, QRgb to)
{
    const auto signedText = [](int value) {
        return (value > 0 ? QStringLiteral("+") : QString()) + printedSigns(QString::number(value));
    };
    return QStringLiteral("%1 %2 %3")
        .arg(signedText(qRed(to) - qRed(from)), signedText(qGreen(to) - qGreen(from)),
             signedText(qBlue(to) - qBlue(from)));
}

QString printedSigns(QString text)
{
    static const QRegularExpression negative(QStringLiteral("(?<!\\w)-(?=[\\di.])"));
    return text.replace(QStringLiteral("->"), QChar(0x2192))
        .replace(QStringLiteral("<="), QChar(0x2264))
        .replace(QStringLiteral(">="), QChar(0x2265))
        .replace(negative, QChar(0x2212));
}

} // namespace rasterlens
