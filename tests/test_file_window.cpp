// OBJ files in the window: where faces come from, and why nothing is seen.
#include "scene_files.h"
#include "ui/face/pixel_card.h"
#include "window_fixture.h"

using namespace rasterlens;
using namespace rasterlens::test;

class TestFileWindow : public WindowFixture
{
    Q_OBJECT

private Q_SLOTS:
    void emptyPictureSaysWhy();
    void cardsNameTheLine();

private:
    Folder m_files;
};

/// A message while nothing is seen, and none once there is something to see.
void TestFileWindow::emptyPictureSaysWhy()
{
    const QString floor =
        m_files.write(QStringLiteral("floor.obj"), "v -1 0 -1\nv -1 0 1\nv 1 0 1\nv 1 0 -1\nf 1 2 3 4\n");
    QVERIFY(open(floor));
    QVERIFY2(m_window->message().contains(QStringLiteral("2 of 2 faces are seen edge-on")),
             qPrintable(m_window->message()));
    Settings above = settings();
    above.view.pitch = 40;
    document().setSettings(above);
    QVERIFY(complete());
    QVERIFY2(m_window->message().isEmpty(), qPrintable(m_window->message()));
}

void TestFileWindow::cardsNameTheLine()
{
    const QString square =
        m_files.write(QStringLiteral("square.obj"), "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n\n# one\nf 1 2 3 4\n");
    QVERIFY(open(square));
    const QSize size = settings().size;
    const auto readout = viewport().readout(QPoint(size.width() / 2, size.height() / 2));
    QVERIFY(readout.has_value());
    QCOMPARE(readout->line, 7);
    const WhyReport report = why(*document().scene(), settings(), size.width() / 2, size.height() / 2);
    QVERIFY(report.visibleFace.has_value());
    const WhyWords words = whyWords(report, *report.find(*report.visibleFace));
    QCOMPARE(words.name, QStringLiteral("face %1, line 7").arg(*report.visibleFace));
}

QTEST_MAIN(TestFileWindow)
#include "test_file_window.moc"
