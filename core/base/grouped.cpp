#include "core/base/grouped.h"

#include <QLocale>

namespace rasterlens
{

QString grouped(std::uint64_t value)
{
    return QLocale(QLocale::English, QLocale::UnitedStates).toString(static_cast<qulonglong>(value));
}

} // namespace rasterlens
