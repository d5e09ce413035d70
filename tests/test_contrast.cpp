// Texts, signs and lines are told from what lies behind them: contrasts by WCAG 2.1, of the palettes that are used. The
// stage and the usual window have the same colours, so all have the contrast of the stage.
#include "core/truth/difference.h"
#include "ui/base/inks.h"
#include "ui/base/text_on.h"
#include "ui/base/theme.h"
#include "ui/canvas/overlay_inks.h"
#include "ui/steps/lens_glyphs.h"
#include "ui/steps/scrubber.h"
#include "ui/truth/referee.h"

#include <QApplication>
#include <QPalette>
#include <QRegularExpression>
#include <QtTest>

#include <cmath>

using namespace rasterlens;

namespace
{

double luminance(const QColor& color)
{
    const auto linear = [](double channel) {
        return channel <= 0.03928 ? channel / 12.92 : std::pow((channel + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}

double contrast(const QColor& a, const QColor& b)
{
    const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
    return (light + 0.05) / (dark + 0.05);
}

/// A colour that lets some of another shine through.
QColor over(const QColor& above, const QColor& below)
{
    const auto mixed = [&](float a, float b) { return a * above.alphaF() + b * (1 - above.alphaF()); };
    return QColor::fromRgbF(mixed(above.redF(), below.redF()), mixed(above.greenF(), below.greenF()),
                            mixed(above.blueF(), below.blueF()));
}

constexpr double kStage = 7;   ///< of everything that a presentation shows
constexpr double kUsual = 4.5; ///< elsewhere

} // namespace

class TestContrast : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void theMeasureIsThatOfTheStandard();
    void textsOfTheStage_data();
    void textsOfTheStage();
    void rulesOfTheSheet_data() { textsOfTheStage_data(); }
    void rulesOfTheSheet();
    void signsOfTheLens_data() { textsOfTheStage_data(); }
    void signsOfTheLens();
    void numbersOfTheLens_data() { textsOfTheStage_data(); }
    void numbersOfTheLens();
    void inksOnCards_data() { textsOfTheStage_data(); }
    void inksOnCards();
    void inksOnTheCanvas();
    void textOnAnyColor();

private:
    static void check(const QString& what, const QColor& a, const QColor& b, double least = kStage)
    {
        QVERIFY2(contrast(a, b) >= least,
                 qPrintable(QStringLiteral("%1: %2 on %3 is %4").arg(what, a.name(), b.name()).arg(contrast(a, b))));
    }
};

void TestContrast::theMeasureIsThatOfTheStandard()
{
    QCOMPARE(contrast(Qt::white, Qt::black), 21.0);
    QVERIFY(std::abs(contrast(QColor(0x777777), Qt::white) - 4.48) < 0.01);
}

void TestContrast::textsOfTheStage_data()
{
    QTest::addColumn<ThemeKind>("kind");
    QTest::newRow("light") << ThemeKind::Light;
    QTest::newRow("dark") << ThemeKind::Dark;
}

void TestContrast::textsOfTheStage()
{
    QFETCH(ThemeKind, kind);
    applyLook(*qApp, {kind, true});
    const QPalette palette = QApplication::palette();
    struct Pair {
        const char* what;
        QPalette::ColorRole text;
        QPalette::ColorRole behind;
    };
    const Pair pairs[] = {
        {"text on a card", QPalette::Text, QPalette::Base},
        {"text on the window", QPalette::Text, QPalette::Window},
        {"text on the soft accent", QPalette::Text, QPalette::AlternateBase},
        {"secondary text and waiting icons on a card", QPalette::PlaceholderText, QPalette::Base},
        {"secondary text on the window", QPalette::PlaceholderText, QPalette::Window},
        {"secondary text on the soft accent", QPalette::PlaceholderText, QPalette::AlternateBase},
        {"a link on a card", QPalette::Link, QPalette::Base},
        {"a formula on a card", QPalette::Link, QPalette::Base},
        {"text on the accent", QPalette::HighlightedText, QPalette::Highlight},
    };
    for (const Pair& pair : pairs)
        check(QLatin1String(pair.what), palette.color(pair.text), palette.color(pair.behind));
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        for (const auto behind : {QPalette::Base, QPalette::Window})
            check(QStringLiteral("what cannot be used now"), palette.color(QPalette::Disabled, role),
                  palette.color(behind));
}

/// Where a rule sets the colour of text alone, a card or the window lies behind; links stand on messages as well.
void TestContrast::rulesOfTheSheet()
{
    QFETCH(ThemeKind, kind);
    applyLook(*qApp, {kind, true});
    const QPalette palette = QApplication::palette();
    const QColor link = palette.color(QPalette::Link);
    const QString sheet = styleSheetOf({kind, true}).text;
    const QRegularExpression rule(QStringLiteral("([^{}]+)\\{([^{}]*)\\}"));
    const QRegularExpression text(QStringLiteral("(?:^|[;\\s])color: (#[0-9a-f]{6})"));
    const QRegularExpression fill(QStringLiteral("(?:^|[;\\s])background: (#[0-9a-f]{6})"));
    int checked = 0;
    for (auto rules = rule.globalMatch(sheet); rules.hasNext();) {
        const QRegularExpressionMatch found = rules.next();
        const QString name = found.captured(1).trimmed();
        const QString color = text.match(found.captured(2)).captured(1);
        const QString behind = fill.match(found.captured(2)).captured(1);
        if (name.startsWith(QStringLiteral("QFrame#messageBar")) && !behind.isEmpty()) {
            check(name + QStringLiteral(", a link"), link, QColor(behind));
            check(name, palette.color(QPalette::Text), QColor(behind));
        }
        if (color.isEmpty())
            continue;
        ++checked;
        if (!behind.isEmpty())
            check(name, QColor(color), QColor(behind));
        else if (!name.contains(QLatin1Char(':')))
            for (const auto role : {QPalette::Base, QPalette::Window})
                check(name, QColor(color), palette.color(role));
    }
    QVERIFY2(checked > 30, qPrintable(QString::number(checked)));
}

void TestContrast::signsOfTheLens()
{
    QFETCH(ThemeKind, kind);
    applyLook(*qApp, {kind, true});
    for (const EdgeSign sign : {EdgeSign::Plus, EdgeSign::Minus, EdgeSign::Zero, EdgeSign::NotANumber})
        for (const bool isHollow : {false, true}) {
            const GlyphColors colors = glyphColors(sign, isHollow);
            check(isHollow ? QStringLiteral("a waiting sign") : QStringLiteral("a sign"), colors.sign, colors.disc);
        }
}

/// On the veil, whatever the picture below it.
void TestContrast::numbersOfTheLens()
{
    QFETCH(ThemeKind, kind);
    applyLook(*qApp, {kind, true});
    const QColor paper = QApplication::palette().color(QPalette::Base);
    for (const auto state : {LensCell::State::Waiting, LensCell::State::Rejected, LensCell::State::Covered})
        for (const EdgeSign sign : {EdgeSign::Plus, EdgeSign::Minus})
            for (const QColor& picture : {QColor(Qt::black), QColor(Qt::white), QColor(0xf0e442)}) {
                LensCell cell;
                cell.state = state;
                cell.hasValues = true;
                cell.signs.fill(sign);
                const QColor veil = over(lensVeil(cell, paper), picture);
                check(QStringLiteral("a number of the lens"), over(lensNumberColor(state), veil), veil);
            }
}

void TestContrast::inksOnCards()
{
    QFETCH(ThemeKind, kind);
    applyLook(*qApp, {kind, true});
    const QPalette palette = QApplication::palette();
    const QColor card = palette.color(QPalette::Base);
    const Inks inks = inksFor(palette);
    for (const QColor& ink : {inks.plus, inks.minus, inks.third})
        check(QStringLiteral("an ink on a card, or a card's colour on it"), ink, card);
    for (const QColor& ink : edgeInksFor(palette))
        check(QStringLiteral("an edge in a formula"), ink, card);
    for (const PipKind pip :
         {PipKind::Sample, PipKind::Outside, PipKind::Cull, PipKind::Clip, PipKind::DepthFail, PipKind::Tie})
        check(QStringLiteral("a word of the scrubber's legend"), pipColor(pip, palette), card);
}

/// Lines and signs lie above a wider line or a plate, light or dark, whatever the picture.
void TestContrast::inksOnTheCanvas()
{
    for (const EdgeLook& look : kEdgeLooks)
        check(QStringLiteral("an edge"), QColor(look.color), Qt::white);
    for (const QRgb ink : {kCanvasPlus, kCanvasMinus, kCanvasLongEdge, kCanvasBrokenEdge})
        check(QStringLiteral("a line above a light one"), QColor(ink), Qt::white);
    for (const QRgb ink :
         {kWireInk, kOutlineInk, kBoxInk, kTileInk, kMidLineInk, kWeightInks[0], kWeightInks[1], kWeightInks[2]})
        check(QStringLiteral("a line above a dark one"), QColor(ink), QColor(kCanvasInk));
    for (const PixelVerdict verdict : kVerdicts)
        check(QStringLiteral("the sign of a verdict"), QColor(verdictColor(verdict)), QColor(kCanvasInk));
    check(QStringLiteral("letters on a plate"), Qt::white, QColor(kCanvasInk));
}

/// Numbers in pixels and samples, and on the colours of the difference: the ink alone is read, and a seam makes it the
/// stage's contrast.
void TestContrast::textOnAnyColor()
{
    const auto checkOn = [](QRgb color) {
        const InkOn inks = inkOn(color);
        check(QStringLiteral("text on a colour"), inks.ink, QColor(color), inks.seam.isValid() ? kUsual : kStage);
        if (inks.seam.isValid())
            check(QStringLiteral("text on its seam"), inks.ink, inks.seam);
    };
    constexpr int kStep = 15;
    for (int red = 0; red < 256; red += kStep)
        for (int green = 0; green < 256; green += kStep)
            for (int blue = 0; blue < 256; blue += kStep)
                checkOn(qRgb(red, green, blue));
    for (const HeatClass& heat : heatScale())
        checkOn(heat.color);
}

QTEST_MAIN(TestContrast)
#include "test_contrast.moc"
