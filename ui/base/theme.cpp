#include "ui/base/theme.h"

#include "core/base/closed_list.h"

#include <QApplication>
#include <QFile>
#include <QFontDatabase>
#include <QMap>
#include <QPalette>
#include <QStyleFactory>

#include <array>

namespace rasterlens
{
namespace
{

constexpr qreal kPointSize = 9.5;
constexpr qreal kPresentationPointSize = 18;

/// A compact face where there is one: panels are narrow. Otherwise the system's.
QString textFamily()
{
    const QStringList installed = QFontDatabase::families();
    for (const char* family : {"Inter", "Noto Sans", "Segoe UI", "Noto Sans CJK SC"})
        if (installed.contains(QLatin1String(family)))
            return QLatin1String(family);
    return QFontDatabase::systemFont(QFontDatabase::GeneralFont).family();
}

/// Families with the forms of characters that mainland China uses. Without a Chinese locale, fontconfig alone would
/// take the Japanese ones.
QStringList chineseFamilies()
{
    return {QStringLiteral("Noto Sans CJK SC"), QStringLiteral("PingFang SC"), QStringLiteral("Microsoft YaHei")};
}

QStringList numberFamilies()
{
    return QStringList{QFontDatabase::systemFont(QFontDatabase::FixedFont).family(),
                       QStringLiteral("Noto Sans Mono CJK SC")} +
           chineseFamilies();
}

enum class ThemeColor {
    Window, ///< behind the cards
    Card,
    Border,
    Text,
    Muted, ///< secondary text
    Accent,
    OnAccent,
    AccentSoft,
    InfoFill,
    WarningFill,
    ErrorFill,
    ErrorText,
};

struct ThemeColorRow {
    ThemeColor color;
    const char* name; ///< in resources/style.qss
    QRgb light;
    QRgb dark;
};

constexpr auto kThemeColors = std::to_array<ThemeColorRow>({
    {ThemeColor::Window, "window", 0xf4f5f8, 0x15181c},
    {ThemeColor::Card, "card", 0xffffff, 0x1e2227},
    {ThemeColor::Border, "border", 0xd5dce6, 0x3a424c},
    {ThemeColor::Text, "text", 0x1b1f24, 0xe8ebef},
    {ThemeColor::Muted, "muted", 0x49515a, 0xbec7d1},
    {ThemeColor::Accent, "accent", 0x1a46ad, 0xa6c3ff},
    {ThemeColor::OnAccent, "onAccent", 0xffffff, 0x0d1420},
    {ThemeColor::AccentSoft, "accentSoft", 0xeaf0fc, 0x28344c},
    {ThemeColor::InfoFill, "infoFill", 0xeaf0fc, 0x28344c},
    {ThemeColor::WarningFill, "warningFill", 0xfff4df, 0x3c3118},
    {ThemeColor::ErrorFill, "errorFill", 0xfdeae7, 0x4a2622},
    {ThemeColor::ErrorText, "errorText", 0x861f14, 0xffb4a8},
});
static_assert(isClosedList(kThemeColors, &ThemeColorRow::color));

QColor colorOf(const ThemeColorRow& row, ThemeKind kind) { return kind == ThemeKind::Light ? row.light : row.dark; }

QPalette paletteOf(ThemeKind kind)
{
    const auto color = [kind](ThemeColor which) {
        return colorOf(kThemeColors[static_cast<std::size_t>(which)], kind);
    };
    QPalette palette;
    palette.setColor(QPalette::Window, color(ThemeColor::Window));
    palette.setColor(QPalette::WindowText, color(ThemeColor::Text));
    palette.setColor(QPalette::Base, color(ThemeColor::Card));
    palette.setColor(QPalette::AlternateBase, color(ThemeColor::AccentSoft));
    palette.setColor(QPalette::Text, color(ThemeColor::Text));
    palette.setColor(QPalette::Button, color(ThemeColor::Card));
    palette.setColor(QPalette::ButtonText, color(ThemeColor::Text));
    palette.setColor(QPalette::BrightText, color(ThemeColor::Text));
    palette.setColor(QPalette::Highlight, color(ThemeColor::Accent));
    palette.setColor(QPalette::HighlightedText, color(ThemeColor::OnAccent));
    palette.setColor(QPalette::Link, color(ThemeColor::Accent));
    palette.setColor(QPalette::LinkVisited, color(ThemeColor::Accent));
    palette.setColor(QPalette::Mid, color(ThemeColor::Border));
    palette.setColor(QPalette::Midlight, color(ThemeColor::Border));
    palette.setColor(QPalette::Light, color(ThemeColor::Card));
    palette.setColor(QPalette::Dark, color(ThemeColor::Border));
    palette.setColor(QPalette::PlaceholderText, color(ThemeColor::Muted));
    palette.setColor(QPalette::ToolTipBase, color(ThemeColor::Card));
    palette.setColor(QPalette::ToolTipText, color(ThemeColor::Text));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        palette.setColor(QPalette::Disabled, role, color(ThemeColor::Muted));
    return palette;
}

qreal pointSizeOf(const Look& look) { return look.presentation ? kPresentationPointSize : kPointSize; }

} // namespace

QColor canvasColor(ThemeKind kind) { return kind == ThemeKind::Light ? QRgb(0xebedf1) : QRgb(0x101215); }

StyleSheet styleSheetOf(const Look& look)
{
    QFile file(QStringLiteral(":/rasterlens/style.qss"));
    if (!file.open(QIODevice::ReadOnly))
        qFatal("the style sheet is missing in the resources of this program");
    const auto points = [&](qreal delta) { return QStringLiteral("%1pt").arg(pointSizeOf(look) + delta); };
    QMap<QString, QString> values{
        {QStringLiteral("ptText"), points(0)},
        {QStringLiteral("ptTitle"), points(1)},
        {QStringLiteral("ptSmall"), points(-1)},
        {QStringLiteral("ptHuge"), points(7)},
        {QStringLiteral("mono"), numberFamilies().join(QStringLiteral("\", \""))},
        {QStringLiteral("kind"), look.kind == ThemeKind::Light ? QStringLiteral("light") : QStringLiteral("dark")}};
    for (const ThemeColorRow& row : kThemeColors)
        values.insert(QLatin1String(row.name), colorOf(row, look.kind).name());
    return fillPlaceholders(QString::fromUtf8(file.readAll()), values);
}

void applyPlainLook(QApplication& application, const Look& look)
{
    application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QFont font;
    font.setFamilies(QStringList{textFamily()} + chineseFamilies());
    font.setPointSizeF(pointSizeOf(look));
    application.setFont(font);
    application.setPalette(paletteOf(look.kind));
}

void applyStyleSheet(QApplication& application, const Look& look)
{
    application.setStyleSheet(styleSheetOf(look).text);
}

void applyLook(QApplication& application, const Look& look)
{
    applyPlainLook(application, look);
    applyStyleSheet(application, look);
}

QFont numberFont(qreal pointDelta)
{
    QFont font(numberFamilies());
    font.setStyleHint(QFont::Monospace);
    font.setPointSizeF(QApplication::font().pointSizeF() + pointDelta);
    return font;
}

QFont textFont(qreal pointDelta, bool bold)
{
    QFont font = QApplication::font();
    font.setPointSizeF(font.pointSizeF() + pointDelta);
    font.setBold(bold);
    return font;
}

} // namespace rasterlens
