#include "ui/base/inks.h"

#include <QPalette>

namespace rasterlens
{

bool isDark(const QPalette& palette)
{
    constexpr int kHalf = 128;
    return palette.color(QPalette::Base).lightness() < kHalf;
}

Inks inksFor(const QPalette& palette)
{
    if (isDark(palette))
        return {QColor(0x62bbee), QColor(0xf59a55), QColor(0x5fd3b3)};
    return {QColor(0x005a8c), QColor(0x8f3c00), QColor(0x005f48)};
}

std::array<QColor, 3> edgeInksFor(const QPalette& palette)
{
    std::array<QColor, 3> inks;
    for (std::size_t i = 0; i < inks.size(); ++i)
        inks[i] = QColor(kEdgeLooks[i].color);
    if (isDark(palette))
        inks = {QColor(0xc5a3e8), QColor(0x4fc3b0), QColor(0xd9a441)};
    return inks;
}

} // namespace rasterlens
