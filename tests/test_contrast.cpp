// Texts, signs and lines are told from what lies behind them: contrasts by WCAG 2.1, of the palettes that are used.
#include "ui/base/inks.h"
#include "ui/base/theme.h"
#include "ui/steps/lens_glyphs.h"
#include "ui/steps/scrubber.h"

#include <QApplication>
#include <QPalette>
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
    void signsOfTheLens_data() { textsOfTheStage_data(); }
    void signsOfTheLens();
    void linesAndPips_data() { textsOfTheStage_data(); }
    void linesAndPips();

private:
    static void check(const char* what, const QColor& a, const QColor& b, double least)
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
        {"secondary text on a card", QPalette::PlaceholderText, QPalette::Base},
        {"secondary text on the window", QPalette::PlaceholderText, QPalette::Window},
        {"secondary text on the soft accent", QPalette::PlaceholderText, QPalette::AlternateBase},
        {"a link on a card", QPalette::Link, QPalette::Base},
        {"a formula on a card", QPalette::Link, QPalette::Base},
        {"text on the accent", QPalette::HighlightedText, QPalette::Highlight},
    };
    for (const Pair& pair : pairs)
        check(pair.what, palette.color(pair.text), palette.color(pair.behind), kStage);
}

void TestContrast::signsOfTheLens()
{
    QFETCH(ThemeKind, kind);
    applyLook(*qApp, {kind, true});
    for (const EdgeSign sign : {EdgeSign::Plus, EdgeSign::Minus, EdgeSign::Zero, EdgeSign::NotANumber})
        for (const bool isHollow : {false, true}) {
            const GlyphColors colors = glyphColors(sign, isHollow);
            check(isHollow ? "a waiting sign" : "a sign", colors.sign, colors.disc, kStage);
        }
    const Inks inks = inksFor(QApplication::palette());
    for (const QColor& ink : {inks.plus, inks.minus, inks.third})
        check("an ink on a card", ink, QApplication::palette().color(QPalette::Base), kStage);
}

void TestContrast::linesAndPips()
{
    QFETCH(ThemeKind, kind);
    applyLook(*qApp, {kind, false});
    const QColor card = QApplication::palette().color(QPalette::Base);
    for (const PipKind pip :
         {PipKind::Sample, PipKind::Outside, PipKind::Cull, PipKind::Clip, PipKind::DepthFail, PipKind::Tie})
        check("a word of the scrubber's legend", pipColor(pip, QApplication::palette()), card, kUsual);
    for (const EdgeLook& look : kEdgeLooks) // over a light rim in both themes
        check("an edge", QColor(look.color), Qt::white, kStage);
}

QTEST_MAIN(TestContrast)
#include "test_contrast.moc"
