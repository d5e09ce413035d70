// The guide says what is true of the program, and the program shows it without a network.
#include "tests/guide_check.h"
#include "tests/window_fixture.h"
#include "ui/window/guide_window.h"

#include <QListWidget>
#include <QScrollBar>
#include <QTextBlock>
#include <QToolButton>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

const QString kRoot = QStringLiteral(RASTERLENS_ROOT);

QString guideText(const char* name) { return QString::fromUtf8(readFile(kRoot + QStringLiteral("/docs/") + name)); }

} // namespace

class TestGuide : public WindowFixture
{
    Q_OBJECT

private:
    GuideWindow& guide() { return m_window->guide(); }
    GuideView& view() { return guide().view(); }
    GuideTruth truth(LanguageKind language)
    {
        m_window->setLanguage(language);
        QCoreApplication::sendPostedEvents();
        return {m_window->actionTable(), kRoot, QStringLiteral(RASTERLENS), QStringLiteral(RASTERLENS_CLI), language};
    }
    void openGuide()
    {
        key(Qt::Key_F1, Qt::ShiftModifier);
        QVERIFY(QTest::qWaitForWindowExposed(&guide()));
    }

private Q_SLOTS:
    void guidesAreTrue()
    {
        QCOMPARE(truth(LanguageKind::English).problems(guideText("GUIDE.md")), QStringList());
        QCOMPARE(truth(LanguageKind::Chinese).problems(guideText("GUIDE.zh.md")), QStringList());
    }

    void guidesAreTwins()
    {
        const QStringList parts = GuideTruth::skeleton(guideText("GUIDE.md"));
        QVERIFY(parts.size() > 30);
        QCOMPARE(GuideTruth::skeleton(guideText("GUIDE.zh.md")), parts);
    }

    void picturesAreSmall()
    {
        qint64 bytes = 0;
        const QString text = guideText("GUIDE.md") + guideText("GUIDE.zh.md");
        for (const QFileInfo& file : QDir(kRoot + QStringLiteral("/docs/images/guide")).entryInfoList(QDir::Files)) {
            bytes += file.size();
            QVERIFY2(text.contains(file.fileName()), qPrintable(file.fileName() + QStringLiteral(" is in no guide")));
        }
        QVERIFY(bytes < 1'500'000);
    }

    void faultsAreFound_data()
    {
        QTest::addColumn<QString>("before");
        QTest::addColumn<QString>("after");
        QTest::addColumn<QString>("problem");
        const auto plant = [](const char* before, const char* after, const char* problem) {
            QTest::newRow(problem) << QString::fromUtf8(before) << QString::fromUtf8(after)
                                   << QString::fromUtf8(problem);
        };
        plant("guide/lens.png", "guide/lense.png", "no picture: images/guide/lense.png");
        plant("![The lens", "![](images/guide/lens.png)![The lens", "a picture without words: images/guide/lens.png");
        plant("(LESSONS.md)", "(LESSON.md)", "no page in the program: LESSON.md");
        plant("## Keys", "[x](#no-such-part)\n\n## Keys", "no heading: no-such-part");
        plant("| File | Ctrl+O |", "| File | Ctrl+P |", "another list of keys than: rasterlens --keys");
        plant("**Ctrl+Shift+P**", "**Ctrl+Alt+P**", "no key: Ctrl+Alt+P");
        plant("*Help > Guide*", "*Help > Book*", "no menu: Help > Book");
        plant("*Try it yourself*", "*Try it at once*", "no text of the window: Try it at once");
        plant("rasterlens-cli why builtin", "rasterlens-cli because builtin", "no command: rasterlens-cli because");
        plant("--samples 4x4", "--sample 4x4", "no option: --sample");
        plant("--presentation --screenshot", "--stage --screenshot", "no option: --stage");
        plant("builtin:torus-knot", "builtin:torus", "no scene: builtin:torus");
    }

    void faultsAreFound()
    {
        QFETCH(QString, before);
        QFETCH(QString, after);
        QFETCH(QString, problem);
        QString text = guideText("GUIDE.md");
        const auto at = text.indexOf(before);
        QVERIFY2(at >= 0, qPrintable(before));
        QCOMPARE(truth(LanguageKind::English).problems(text.replace(at, before.size(), after)), QStringList(problem));
    }

    void lessOfOneGuideIsFound()
    {
        const QString text = guideText("GUIDE.zh.md");
        const QStringList parts = GuideTruth::skeleton(text);
        QVERIFY(GuideTruth::skeleton(
                    QString(text).replace(QStringLiteral("why.zh.png"), QStringLiteral("lens.zh.png"))) != parts);
        QVERIFY(GuideTruth::skeleton(QString(text).replace(QStringLiteral("\n## "), QStringLiteral("\n### "))) !=
                parts);
    }

    void helpOpensIt()
    {
        openGuide();
        QCOMPARE(view().page(), QStringLiteral("GUIDE.md"));
        QVERIFY(view().headings().size() > 15);
        QCOMPARE(guide().contents().count(), int(view().headings().size()));
        QTest::keyClick(&view(), Qt::Key_Escape);
        QVERIFY(!guide().isVisible());
    }

    void contentsLeadToSections()
    {
        openGuide();
        const int row = 8;
        QListWidget& contents = guide().contents();
        QVERIFY(!guide().canGoBack());
        QTest::mouseClick(contents.viewport(), Qt::LeftButton, {},
                          contents.visualItemRect(contents.item(row)).center());
        QCOMPARE(view().headingInSight(), std::optional<std::size_t>(row));
        QVERIFY(view().verticalScrollBar()->value() > 0);
        guide().goBack();
        QCOMPARE(view().verticalScrollBar()->value(), 0);
    }

    void linksLeadToPagesAndBack()
    {
        openGuide();
        view().showHeading(3);
        const int place = view().verticalScrollBar()->value();
        guide().follow(QUrl(QStringLiteral("LESSONS.md#numbers-are-computed")));
        QCOMPARE(view().page(), QStringLiteral("LESSONS.md"));
        QCOMPARE(view().headings()[view().headingInSight().value()].text, QStringLiteral("Numbers are computed"));
        guide().follow(QUrl(QStringLiteral("../nowhere.md")));
        QCOMPARE(view().page(), QStringLiteral("LESSONS.md"));
        QTest::keySequence(&view(), QKeySequence::Back);
        QCOMPARE(view().page(), QStringLiteral("GUIDE.md"));
        QCOMPARE(view().verticalScrollBar()->value(), place);
    }

    void languageKeepsTheSection()
    {
        openGuide();
        view().showHeading(5);
        const QString english = view().headings()[5].text;
        m_window->setLanguage(LanguageKind::Chinese);
        QCoreApplication::sendPostedEvents();
        QCOMPARE(view().page(), QStringLiteral("GUIDE.zh.md"));
        QCOMPARE(view().headingInSight(), std::optional<std::size_t>(5));
        QVERIFY(view().headings()[5].text != english);
        QVERIFY(guide().windowTitle() != QStringLiteral("Guide to RasterLens"));
    }

    void lettersFollowThePresentation()
    {
        openGuide();
        const auto height = [this] { return QFontMetricsF(view().document()->defaultFont()).height(); };
        const double usual = height();
        m_window->setPresentation(true);
        QVERIFY(waitFor([&] { return height() > 1.5 * usual; }));
        m_window->setPresentation(false);
        QVERIFY(waitFor([&] { return height() == usual; }));
    }

    /// A picture is never enlarged: its pixels would blur.
    void picturesFitTheColumn()
    {
        openGuide();
        const QImage picture(kRoot + QStringLiteral("/docs/images/guide/first-minute.png"));
        QVERIFY(picture.width() > 1500);
        QCOMPARE(view().fitted(picture, 700).deviceIndependentSize().width(), 700.0);
        QCOMPARE(view().fitted(picture, 5000).deviceIndependentSize().width(), 1040.0);
        for (const QSize size : {QSize(700, 500), QSize(1300, 700)}) {
            guide().resize(size);
            QCoreApplication::sendPostedEvents();
            int pictures = 0;
            for (QTextBlock block = view().document()->begin(); block.isValid(); block = block.next())
                for (auto part = block.begin(); !part.atEnd(); ++part) {
                    const QTextCharFormat format = part.fragment().charFormat();
                    if (!format.isImageFormat())
                        continue;
                    const auto image = view()
                                           .document()
                                           ->resource(QTextDocument::ImageResource, QUrl(format.toImageFormat().name()))
                                           .value<QImage>();
                    QVERIFY(!image.isNull());
                    QVERIFY(image.deviceIndependentSize().width() <= view().viewport()->width());
                    ++pictures;
                }
            QVERIFY(pictures > 15);
        }
    }
};

QTEST_MAIN(TestGuide)
#include "test_guide.moc"
