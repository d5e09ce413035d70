#include "core/derive/figure.h"

#include <cmath>

namespace rasterlens
{
namespace
{

/// x on an axis that is logarithmic from +-1 on; it has no kink there.
double logarithmic(double x) { return std::abs(x) <= 1 ? x : std::copysign(1 + std::log(std::abs(x)), x); }

double fromLogarithmic(double x) { return std::abs(x) <= 1 ? x : std::copysign(std::exp(std::abs(x) - 1), x); }

} // namespace

double DerivationFigure::partOfWidth(double x) const
{
    const auto along = [&](double at) { return logFrom > 0 ? logarithmic(at / logFrom) : at; };
    const double width = along(high.x) - along(low.x);
    return width > 0 ? (along(x) - along(low.x)) / width : 0;
}

double DerivationFigure::xAt(double partOfWidth) const
{
    if (!(logFrom > 0))
        return low.x + partOfWidth * (high.x - low.x);
    const double first = logarithmic(low.x / logFrom);
    return logFrom * fromLogarithmic(first + partOfWidth * (logarithmic(high.x / logFrom) - first));
}

} // namespace rasterlens
