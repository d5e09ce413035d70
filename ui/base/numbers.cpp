#include "ui/base/numbers.h"

#include <QLocale>

namespace rasterlens
{

QString grouped(std::uint64_t value)
{
    return QLocale(QLocale::English, QLocale::UnitedStates).toString(static_cast<qulonglong>(value));
}

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

} // namespace rasterlens
