// The window in Chinese: the forms of characters that mainland China uses, wherever they are written, and names.
#include "tests/window_fixture.h"
#include "ui/base/case_note.h"
#include "ui/base/plot_theme.h"
#include "ui/base/theme.h"
#include "ui/face/cards.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/figure_export.h"
#include "ui/window/guide_view.h"
#include "ui/window/guide_window.h"

#include <QFontDatabase>
#include <QGlyphRun>
#include <QRawFont>
#include <QTextBlock>
#include <QTextLayout>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

/// Characters whose forms differ between China and Japan.
const QString kTelling = QStringLiteral("\u76f4\u9aa8\u89d2"); // straight, bone, corner

/// The families that a font draws them with.
QStringList familiesOf(const QFont& font)
{
    QTextLayout layout(kTelling, font);
    layout.beginLayout();
    layout.createLine();
    layout.endLayout();
    QStringList families;
    for (const QGlyphRun& run : layout.glyphRuns())
        families << run.rawFont().familyName();
    families.removeDuplicates();
    return families;
}

bool isChinese(const QFont& font)
{
    const QStringList families = familiesOf(font);
    return !families.isEmpty() && std::ranges::all_of(families, [](const QString& family) {
        return family.startsWith(QLatin1String("Noto Sans")) && family.endsWith(QLatin1String(" SC"));
    });
}

QString nameOf(const QObject* object, const QFont& font)
{
    return QStringLiteral("%1 \"%2\": %3 draws with %4")
        .arg(QLatin1String(object->metaObject()->className()), object->objectName(), font.families().join(", "),
             familiesOf(font).join(", "));
}

} // namespace

class TestChinese : public WindowFixture
{
    Q_OBJECT

private:
    void speakChinese()
    {
        m_window->setLanguage(LanguageKind::Chinese);
        QCoreApplication::sendPostedEvents();
    }
    void openEverything()
    {
        for (const QString& panel : Cards::names())
            QVERIFY(m_window->cards().show(panel));
        for (const QString& panel : TruthMode::panelNames())
            QVERIFY(m_window->truthMode().showPanel(panel));
        m_window->guide().open();
        QCoreApplication::sendPostedEvents();
    }

private Q_SLOTS:
    void everyWidgetHasChineseForms()
    {
        if (!QFontDatabase::families().contains(QStringLiteral("Noto Sans CJK SC")))
            QSKIP("Noto Sans CJK SC is not installed");
        QVERIFY(!isChinese(QFont(QStringLiteral("Noto Sans CJK JP")))); // so the test can tell
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        speakChinese();
        openEverything();
        for (const double points : {-1.5, 0.0, 3.0})
            QVERIFY(isChinese(textFont(points)) && isChinese(textFont(points, true)) && isChinese(numberFont(points)));
        int widgets = 0;
        for (const QWidget* widget : m_window->findChildren<QWidget*>()) {
            QVERIFY2(isChinese(widget->font()), qPrintable(nameOf(widget, widget->font())));
            ++widgets;
        }
        QVERIFY(widgets > 300);
    }

    void plotsHaveChineseForms()
    {
        if (!QFontDatabase::families().contains(QStringLiteral("Noto Sans CJK SC")))
            QSKIP("Noto Sans CJK SC is not installed");
        speakChinese();
        openEverything();
        int plots = 0;
        for (const QCustomPlot* plot : m_window->findChildren<QCustomPlot*>()) {
            std::vector<QFont> fonts{plot->legend->font()};
            for (const QCPAxis* axis : plot->axisRect()->axes()) {
                fonts.push_back(axis->labelFont());
                fonts.push_back(axis->tickLabelFont());
            }
            for (int i = 0; i < plot->legend->itemCount(); ++i)
                fonts.push_back(plot->legend->item(i)->font());
            for (int i = 0; i < plot->itemCount(); ++i)
                if (const auto* text = qobject_cast<const QCPItemText*>(plot->item(i)))
                    fonts.push_back(text->font());
            for (const QFont& font : fonts)
                QVERIFY2(isChinese(font), qPrintable(nameOf(plot, font)));
            ++plots;
        }
        QVERIFY(plots >= 2);
    }

    void guideHasChineseForms()
    {
        if (!QFontDatabase::families().contains(QStringLiteral("Noto Sans CJK SC")))
            QSKIP("Noto Sans CJK SC is not installed");
        speakChinese();
        m_window->guide().open();
        const QTextDocument& document = *m_window->guide().view().document();
        for (QTextBlock block = document.begin(); block.isValid(); block = block.next())
            for (auto part = block.begin(); !part.atEnd(); ++part)
                if (!part.fragment().charFormat().isImageFormat()) {
                    const QFont font = part.fragment().charFormat().font().resolve(document.defaultFont());
                    QVERIFY2(isChinese(font), qPrintable(nameOf(&document, font)));
                }
    }

    /// A drawing names its fonts, and a viewer takes the first that it has.
    void drawingsNameChineseFonts()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        speakChinese();
        const QString path = m_folder.filePath(QStringLiteral("zh.svg"));
        QCOMPARE(m_window->figures().exportTo(path), std::nullopt);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray svg = file.readAll();
        const auto texts = svg.count("font-family=");
        QVERIFY(texts > 3);
        for (qsizetype at = svg.indexOf("font-family="); at >= 0; at = svg.indexOf("font-family=", at + 1)) {
            const QByteArray family = svg.mid(at, svg.indexOf('"', at + 13) - at);
            QVERIFY2(family.contains("Noto Sans CJK SC"), family.constData());
        }
    }

    void titlesAreTranslated()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        QVERIFY(m_window->windowTitle().startsWith(QStringLiteral("Square cut by its diagonal")));
        speakChinese();
        const QString square = QStringLiteral("\u88ab\u5bf9\u89d2\u7ebf\u5207\u5f00\u7684\u6b63\u65b9\u5f62");
        QVERIFY2(m_window->windowTitle().startsWith(square), qPrintable(m_window->windowTitle()));
        document().open(QStringLiteral(":/rasterlens/cases/001_edges_four_quarters.case"));
        QVERIFY(complete());
        const QString four = QStringLiteral("001 \u8fb9\uff1a\u56db\u7b49\u5206");
        QVERIFY2(m_window->windowTitle().startsWith(four), qPrintable(m_window->windowTitle()));
        m_window->setLanguage(LanguageKind::English);
        QCoreApplication::sendPostedEvents();
        QVERIFY(m_window->windowTitle().startsWith(QStringLiteral("001 edges four quarters")));
    }

    void onlyCasesOfTheCatalogueAreTranslated()
    {
        QCOMPARE(caseTitle(QStringLiteral("my_case")), QStringLiteral("my_case"));
        QCOMPARE(caseTitle(QStringLiteral("12_edges")), QStringLiteral("12_edges"));
        QCOMPARE(caseTitle(QStringLiteral("001_edges_four_quarters")), QStringLiteral("001 edges four quarters"));
    }
};

QTEST_MAIN(TestChinese)
#include "test_chinese.moc"
