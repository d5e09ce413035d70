// The style sheet of the window and the table of its colours agree, and properties choose among its rules.
#include "ui/base/inks.h"
#include "ui/base/message_bar.h"
#include "ui/base/theme.h"

#include <QApplication>
#include <QtTest>

#include <cstdlib>

using namespace rasterlens;

class TestTheme : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void namesAreThoseOfTheSheet_data();
    void namesAreThoseOfTheSheet();
    void placeholdersAreFilled();
    void wrongNamesAreFound_data();
    void wrongNamesAreFound();
    void messagesHaveTheColorOfTheirKind();
    void edgesOfWalkingDiffer();
};

void TestTheme::namesAreThoseOfTheSheet_data()
{
    QTest::addColumn<Look>("look");
    QTest::newRow("light") << Look{ThemeKind::Light, false};
    QTest::newRow("dark") << Look{ThemeKind::Dark, false};
    QTest::newRow("light, presentation") << Look{ThemeKind::Light, true};
}

void TestTheme::namesAreThoseOfTheSheet()
{
    QFETCH(Look, look);
    const StyleSheet sheet = styleSheetOf(look);
    QCOMPARE(sheet.unknown, QStringList());
    QCOMPARE(sheet.unused, QStringList());
    QVERIFY(sheet.text.contains(QStringLiteral("QMainWindow")));
    QVERIFY(!sheet.text.contains(QLatin1Char('@')));
}

void TestTheme::placeholdersAreFilled()
{
    const StyleSheet sheet = fillPlaceholders(QStringLiteral("a { color: @ink@; border: 1px solid @inkSoft@; }@ink@"),
                                              {{"ink", "#111111"}, {"inkSoft", "#222222"}});
    QCOMPARE(sheet.text, QStringLiteral("a { color: #111111; border: 1px solid #222222; }#111111"));
    QCOMPARE(sheet.unknown, QStringList());
    QCOMPARE(sheet.unused, QStringList());
}

void TestTheme::wrongNamesAreFound_data()
{
    QTest::addColumn<QString>("text");
    QTest::addColumn<QStringList>("unknown");
    QTest::addColumn<QStringList>("unused");
    QTest::newRow("right") << "color: @ink@;" << QStringList() << QStringList();
    QTest::newRow("unknown") << "color: @inc@; background: @ink@;" << QStringList{"@inc@"} << QStringList();
    QTest::newRow("unused") << "color: red;" << QStringList() << QStringList{"ink"};
    QTest::newRow("not closed") << "color: @ink; background: @ink@;" << QStringList{"@ink"} << QStringList();
    QTest::newRow("alone") << "color: @ink@; @" << QStringList{"@"} << QStringList();
}

void TestTheme::wrongNamesAreFound()
{
    QFETCH(QString, text);
    QFETCH(QStringList, unknown);
    QFETCH(QStringList, unused);
    const StyleSheet sheet = fillPlaceholders(text, {{"ink", "#111111"}});
    QCOMPARE(sheet.unknown, unknown);
    QCOMPARE(sheet.unused, unused);
}

void TestTheme::messagesHaveTheColorOfTheirKind()
{
    applyLook(*qApp, {});
    MessageBar bar;
    const auto fill = [&bar](MessageKind kind) {
        bar.show(kind, QStringLiteral("words"));
        const QImage picture = bar.grab().toImage();
        return picture.pixelColor(picture.width() / 2, 3).name();
    };
    const QString info = fill(MessageKind::Info);
    const QString warning = fill(MessageKind::Warning);
    const QString error = fill(MessageKind::Error);
    QVERIFY2(info != warning && warning != error && error != info, qPrintable(info + warning + error));
    QCOMPARE(fill(MessageKind::Info), info);
    applyLook(*qApp, {ThemeKind::Dark, false});
    QVERIFY(fill(MessageKind::Error) != error);
}

/// The two edges of edge walking have a light rim on the canvas, and differ by more than their style.
void TestTheme::edgesOfWalkingDiffer()
{
    QVERIFY(std::abs(qRed(kCanvasLongEdge) - qRed(kCanvasBrokenEdge)) > 100);
    QVERIFY(std::abs(qBlue(kCanvasLongEdge) - qBlue(kCanvasBrokenEdge)) > 60); // also without red and green
}

QTEST_MAIN(TestTheme)
#include "test_theme.moc"
