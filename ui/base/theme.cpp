#include "ui/base/theme.h"

#include <QApplication>
#include <QFontDatabase>
#include <QPalette>
#include <QStyleFactory>

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

QPalette paletteOf(const ThemeColors& colors)
{
    QPalette palette;
    palette.setColor(QPalette::Window, colors.window);
    palette.setColor(QPalette::WindowText, colors.text);
    palette.setColor(QPalette::Base, colors.card);
    palette.setColor(QPalette::AlternateBase, colors.accentSoft);
    palette.setColor(QPalette::Text, colors.text);
    palette.setColor(QPalette::Button, colors.card);
    palette.setColor(QPalette::ButtonText, colors.text);
    palette.setColor(QPalette::BrightText, colors.text);
    palette.setColor(QPalette::Highlight, colors.accent);
    palette.setColor(QPalette::HighlightedText, colors.onAccent);
    palette.setColor(QPalette::Link, colors.accent);
    palette.setColor(QPalette::LinkVisited, colors.accent);
    palette.setColor(QPalette::Mid, colors.border);
    palette.setColor(QPalette::Midlight, colors.border);
    palette.setColor(QPalette::Light, colors.card);
    palette.setColor(QPalette::Dark, colors.border);
    palette.setColor(QPalette::PlaceholderText, colors.muted);
    palette.setColor(QPalette::ToolTipBase, colors.card);
    palette.setColor(QPalette::ToolTipText, colors.text);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        QColor faded = colors.muted;
        faded.setAlphaF(0.6F);
        palette.setColor(QPalette::Disabled, role, faded);
    }
    return palette;
}

QString styleSheetOf(const ThemeColors& colors)
{
    QString sheet = QStringLiteral(R"(
QMainWindow, QMainWindow::separator { background: @window; }
QMainWindow::separator { width: 7px; height: 7px; }
QMainWindow::separator:hover { background: @border; }
QMenuBar { background: @window; color: @text; padding: 2px 0; }
QMenuBar::item { padding: 5px 10px; border-radius: 5px; background: transparent; }
QMenuBar::item:selected { background: @accentSoft; }
QMenu { background: @card; color: @text; border: 1px solid @border; padding: 4px; }
QMenu::item { padding: 5px 26px 5px 24px; border-radius: 4px; }
QMenu::item:selected { background: @accentSoft; }
QMenu::item:disabled { color: @muted; }
QMenu::separator { height: 1px; background: @border; margin: 4px 8px; }
QToolTip { background: @card; color: @text; border: 1px solid @border; padding: 5px; }
QStatusBar { background: @window; color: @text; }
QStatusBar::item { border: none; }
QFrame#card { background: @card; border: 1px solid @border; border-radius: 8px; }
QWidget#dockTitle { background: @card; border: 1px solid @border; border-bottom: none;
                    border-top-left-radius: 8px; border-top-right-radius: 8px; }
QFrame#dockBody { background: @card; border: 1px solid @border; border-top: none;
                  border-bottom-left-radius: 8px; border-bottom-right-radius: 8px; }
QFrame#transportTitle { background: @card; border: 1px solid @border; border-bottom: none;
                        border-top-left-radius: 8px; border-top-right-radius: 8px; }
QFrame#stepListing { background: @card; border-top: 1px solid @border; border-bottom-left-radius: 8px;
                     border-bottom-right-radius: 8px; }
QLabel#stepNotice { background: @accentSoft; color: @text; border-radius: 4px; padding: 1px 6px; }
QLabel#heading, QLabel#groupHeading { font-weight: bold; }
QLabel#title { font-weight: bold; font-size: @ptTitle; }
QLabel#muted, QLabel#keyHint, QLabel#mutedSmall { color: @muted; }
QLabel#keyHint, QLabel#mutedSmall { font-size: @ptSmall; }
QLabel#fps { font-weight: bold; font-size: @ptHuge; }
QLabel#counter { font-family: "@mono"; font-weight: bold; }
QLabel#counter:disabled, QLabel#fps:disabled { color: @muted; }
QLabel#readout { font-family: "@mono"; }
QLabel#numbers { font-family: "@mono"; color: @muted; font-size: @ptSmall; }
QLabel#pill { background: @accentSoft; color: @text; border: 1px solid @border; border-radius: 9px; padding: 1px 7px;
              font-weight: bold; font-size: @ptSmall; }
QFrame#whyRow { border: 1px solid transparent; border-radius: 6px; }
QFrame#whyRow:hover { background: @window; border-color: @border; }
QFrame#whyRow:focus { border-color: @accent; }
QToolButton#fold { background: transparent; color: @text; border: 1px solid transparent; border-radius: 4px;
                   font-weight: bold; padding: 1px 2px; }
QToolButton#fold:hover { background: @accentSoft; }
QToolButton#fold:focus { border-color: @accent; }
QToolButton#flat:checked { background: @accent; color: @onAccent; border-color: @accent; }
QToolButton#flat:disabled { background: transparent; color: @muted; }
QToolButton#flat:hover:enabled { border-color: @accent; }
QToolButton#flat:focus { border: 2px solid @accent; }
QLineEdit[refused="true"], QComboBox[refused="true"], QLineEdit[refused="true"]:focus, QSpinBox[refused="true"],
QSpinBox[refused="true"]:focus, QComboBox[refused="true"]:focus { border: 2px solid @errorText; padding: 1px 5px; }
QTabBar { background: @window; }
QTabBar::tab { background: transparent; color: @muted; padding: 4px 12px; margin-right: 2px; border-radius: 6px; }
QTabBar::tab:selected { background: @card; color: @text; border: 1px solid @border; font-weight: bold; }
QTabBar::tab:hover:!selected { background: @accentSoft; }
QTableView { background: @card; alternate-background-color: @window; color: @text; border: none;
             selection-background-color: @accentSoft; selection-color: @text; }
QTableView::item { padding: 1px 6px; }
QHeaderView, QTableCornerButton::section { background: @card; border: none; }
QHeaderView::section { background: @card; color: @muted; border: none; padding: 2px 8px; }
QHeaderView::section:vertical { padding: 0 8px; }
QHeaderView::section:horizontal { color: @text; font-weight: bold; }
QHeaderView::up-arrow, QHeaderView::down-arrow { width: 8px; height: 8px; }
QHeaderView::up-arrow { image: url(:/rasterlens/icons/chevron-up-@kind.png); }
QHeaderView::down-arrow { image: url(:/rasterlens/icons/chevron-@kind.png); }
QScrollBar:horizontal { background: transparent; height: 9px; margin: 0; }
QScrollBar::handle:horizontal { background: @border; border-radius: 4px; min-width: 24px; }
QScrollBar::handle:horizontal:hover { background: @muted; }
QSlider::groove:horizontal { background: @border; height: 4px; border-radius: 2px; }
QSlider::sub-page:horizontal { background: @accent; border-radius: 2px; }
QSlider::handle:horizontal { background: @accent; width: 14px; height: 14px; margin: -5px 0; border-radius: 7px; }
QSlider::handle:horizontal:disabled, QSlider::sub-page:horizontal:disabled { background: @muted; }
QLabel#caption { background: @card; color: @text; border-top: 1px solid @border; }
QScrollArea, QScrollArea > QWidget > QWidget#panelContent { background: transparent; border: none; }
QScrollBar:vertical { background: transparent; width: 9px; margin: 0; }
QScrollBar::handle:vertical { background: @border; border-radius: 4px; min-height: 24px; }
QScrollBar::handle:vertical:hover { background: @muted; }
QScrollBar::add-line, QScrollBar::sub-line, QScrollBar::add-page, QScrollBar::sub-page { height: 0; background: none; }
QComboBox, QSpinBox, QLineEdit { background: @card; color: @text; border: 1px solid @border; border-radius: 5px;
                                 padding: 2px 6px; selection-background-color: @accent; selection-color: @onAccent; }
QComboBox:hover, QSpinBox:hover, QLineEdit:hover { border-color: @accent; }
QComboBox:focus, QSpinBox:focus, QLineEdit:focus { border: 2px solid @accent; padding: 1px 5px; }
QComboBox:disabled, QSpinBox:disabled { color: @muted; background: @window; }
QComboBox { combobox-popup: 0; }
QComboBox::drop-down { border: none; width: 14px; }
QComboBox QAbstractItemView::item { min-height: 1.7em; padding: 0 6px; }
QComboBox QAbstractItemView::item:disabled { color: @muted; }
QComboBox::down-arrow { image: url(:/rasterlens/icons/chevron-@kind.png); width: 9px; height: 9px; }
QComboBox::down-arrow:disabled { image: none; }
QComboBox QAbstractItemView { background: @card; color: @text; border: 1px solid @border; outline: none;
                              selection-background-color: @accentSoft; selection-color: @text; }
QSpinBox::up-button, QSpinBox::down-button { border: none; background: transparent; width: 16px;
                                             subcontrol-origin: border; }
QSpinBox::up-button { subcontrol-position: top right; margin-top: 2px; }
QSpinBox::down-button { subcontrol-position: bottom right; margin-bottom: 2px; }
QSpinBox::up-arrow { image: url(:/rasterlens/icons/chevron-up-@kind.png); width: 8px; height: 8px; }
QSpinBox::down-arrow { image: url(:/rasterlens/icons/chevron-@kind.png); width: 8px; height: 8px; }
QCheckBox { color: @text; spacing: 6px; padding: 2px 0; }
QCheckBox::indicator { width: 14px; height: 14px; border: 1px solid @muted; border-radius: 4px; background: @card; }
QCheckBox::indicator:hover, QCheckBox::indicator:focus { border-color: @accent; }
QCheckBox::indicator:checked { background: @accent; border-color: @accent;
                               image: url(:/rasterlens/icons/check-@kind.png); }
QCheckBox::indicator:disabled { border-color: @border; }
QPushButton, QToolButton#flat { background: @accentSoft; color: @text; border: 1px solid @border; border-radius: 5px;
                                padding: 3px 10px; }
QPushButton:hover { border-color: @accent; }
QToolButton#link { background: transparent; color: @accent; border: 1px solid transparent; border-radius: 4px;
                   padding: 1px 3px; }
QToolButton#link:hover { background: @accentSoft; }
QToolButton#link:focus { border-color: @accent; }
QToolButton#link:disabled { color: @muted; }
QToolButton#link:checked { background: @accent; color: @onAccent; }
)");
    const std::pair<QLatin1String, QColor> colorsByName[] = {
        {QLatin1String("@window"), colors.window},      {QLatin1String("@card"), colors.card},
        {QLatin1String("@border"), colors.border},      {QLatin1String("@text"), colors.text},
        {QLatin1String("@muted"), colors.muted},        {QLatin1String("@accentSoft"), colors.accentSoft},
        {QLatin1String("@onAccent"), colors.onAccent},  {QLatin1String("@accent"), colors.accent},
        {QLatin1String("@errorText"), colors.errorText}};
    for (const auto& [name, color] : colorsByName)
        sheet.replace(name, color.name());
    return sheet;
}

} // namespace

const ThemeColors& themeColors(ThemeKind kind)
{
    static const ThemeColors light{.window = QColor(0xf4f5f8),
                                   .card = QColor(0xffffff),
                                   .border = QColor(0xd5dce6),
                                   .text = QColor(0x1b1f24),
                                   .muted = QColor(0x57606a),
                                   .accent = QColor(0x2b5fdb),
                                   .onAccent = QColor(0xffffff),
                                   .accentSoft = QColor(0xeaf0fc),
                                   .canvas = QColor(0xebedf1),
                                   .infoFill = QColor(0xeaf0fc),
                                   .warningFill = QColor(0xfff4df),
                                   .errorFill = QColor(0xfdeae7),
                                   .errorText = QColor(0x9a2a1b)};
    static const ThemeColors dark{.window = QColor(0x15181c),
                                  .card = QColor(0x1e2227),
                                  .border = QColor(0x3a424c),
                                  .text = QColor(0xe8ebef),
                                  .muted = QColor(0x9da7b3),
                                  .accent = QColor(0x7aa5ff),
                                  .onAccent = QColor(0x0d1420),
                                  .accentSoft = QColor(0x28344c),
                                  .canvas = QColor(0x101215),
                                  .infoFill = QColor(0x28344c),
                                  .warningFill = QColor(0x46391c),
                                  .errorFill = QColor(0x4a2622),
                                  .errorText = QColor(0xffb4a8)};
    return kind == ThemeKind::Light ? light : dark;
}

void applyLook(QApplication& application, const Look& look)
{
    const ThemeColors& colors = themeColors(look.kind);
    application.setStyle(QStyleFactory::create(QStringLiteral("Fusion")));
    QFont font;
    font.setFamilies(QStringList{textFamily()} + chineseFamilies());
    font.setPointSizeF(look.presentation ? kPresentationPointSize : kPointSize);
    application.setFont(font);
    application.setPalette(paletteOf(colors));
    QString sheet = styleSheetOf(colors);
    const auto points = [&](qreal delta) { return QStringLiteral("%1pt").arg(font.pointSizeF() + delta); };
    sheet.replace(QLatin1String("@ptTitle"), points(1));
    sheet.replace(QLatin1String("@ptSmall"), points(-1));
    sheet.replace(QLatin1String("@ptHuge"), points(7));
    sheet.replace(QLatin1String("@mono"), numberFamilies().join(QStringLiteral("\", \"")));
    sheet.replace(QLatin1String("@kind"),
                  look.kind == ThemeKind::Light ? QLatin1String("light") : QLatin1String("dark"));
    application.setStyleSheet(sheet);
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
