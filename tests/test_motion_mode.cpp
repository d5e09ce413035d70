// The turntable and the jitter in the window: the picture moves, says how many pixels that changes, and the document
// stays as it is.
#include "ui/base/action_table.h"
#include "ui/steps/motion_mode.h"
#include "ui/window/figure_export.h"
#include "window_fixture.h"

#include <QAction>
#include <QImageReader>
#include <QSignalSpy>

using namespace rasterlens;
using namespace rasterlens::test;

class TestMotionMode : public WindowFixture
{
    Q_OBJECT

private Q_SLOTS:
    void theTurntableTurnsByItself();
    void escapeStopsIt();
    void whatIsCountedIsWhatIsSeen();
    void theJitterMovesScenesInClipSpace();
    void aSceneInClipSpaceSaysWhyItDoesNotTurn();
    void stepsEndTheMotion();
    void framesAreWrittenAsGif();

private:
    MotionMode& motion() { return m_window->motion(); }
    QAction* action(const char* id) { return m_window->actionTable().action(id); }
};

void TestMotionMode::theTurntableTurnsByItself()
{
    QVERIFY(openSmall(QStringLiteral("builtin:cube")));
    const Settings before = settings();
    const QImage still = picture();
    const bool wasModified = m_window->isWindowModified(); // the scene was made small
    key(Qt::Key_T, Qt::ControlModifier);
    QVERIFY(action("camera.turntable")->isChecked());
    QVERIFY(waitFor([&] { return motion().change().has_value() && motion().change()->colors > 0; }));
    QVERIFY(picture() != still);
    QVERIFY(motion().frame()->settings.view.yaw > before.view.yaw);
    QCOMPARE(settings(), before); // nothing to undo, nothing to save
    QCOMPARE(m_window->isWindowModified(), wasModified);
    // A change is taken up, and not counted as motion.
    Settings next = before;
    next.culling = Culling::None;
    document().setSettings(next);
    QVERIFY(waitFor([&] { return motion().frame() && motion().frame()->settings.culling == Culling::None; }));
    key(Qt::Key_T, Qt::ControlModifier);
    QVERIFY(!motion().motion() && !motion().frame());
    QVERIFY(!action("camera.turntable")->isChecked());
    QVERIFY(complete());
    QCOMPARE(viewport().frame()->settings, next);
}

void TestMotionMode::escapeStopsIt()
{
    QVERIFY(openSmall(QStringLiteral("builtin:cube")));
    const QImage still = picture();
    key(Qt::Key_J, Qt::ControlModifier);
    QVERIFY(action("camera.jitter")->isChecked());
    key(Qt::Key_T, Qt::ControlModifier); // one at a time
    QVERIFY(!action("camera.jitter")->isChecked());
    QVERIFY(motion().motion() == Motion::Turntable);
    QVERIFY(waitFor([&] { return motion().frame() != nullptr; }));
    key(Qt::Key_Escape);
    QVERIFY(!motion().motion());
    QVERIFY(!action("camera.turntable")->isChecked());
    QVERIFY(complete());
    QCOMPARE(picture(), still);
}

void TestMotionMode::whatIsCountedIsWhatIsSeen()
{
    QVERIFY(openSmall(QStringLiteral("builtin:tile-square")));
    motion().showFrame(Motion::Turntable, 7);
    const QImage seventh = picture();
    motion().showFrame(Motion::Turntable, 8);
    const QImage eighth = picture();
    std::size_t differing = 0;
    for (int y = 0; y < eighth.height(); ++y)
        for (int x = 0; x < eighth.width(); ++x)
            differing += seventh.pixel(x, y) != eighth.pixel(x, y) ? 1 : 0;
    QVERIFY(differing > 0);
    QCOMPARE(motion().change()->colors, differing);
    const QStringList words = motion().words();
    QVERIFY2(words[0].contains(QStringLiteral("turned by 8\u00b0")), qPrintable(words[0]));
    QVERIFY2(words[1].contains(QLocale(QLocale::English).toString(qulonglong(differing))), qPrintable(words[1]));
    // The first one asked for is compared with the one before it as well.
    motion().stop();
    motion().showFrame(Motion::Turntable, 8);
    QCOMPARE(motion().change()->colors, differing);
    motion().showFrame(Motion::Turntable, 0);
    QVERIFY(!motion().change());
}

void TestMotionMode::theJitterMovesScenesInClipSpace()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    const QImage still = picture();
    motion().showFrame(Motion::Jitter, 256);
    const QImage moved = picture();
    for (int y = 0; y < still.height(); ++y) // by a whole pixel
        for (int x = 1; x + 1 < still.width(); ++x)
            QCOMPARE(moved.pixel(x + 1, y) != still.pixel(0, 0), still.pixel(x, y) != still.pixel(0, 0));
}

void TestMotionMode::aSceneInClipSpaceSaysWhyItDoesNotTurn()
{
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    key(Qt::Key_T, Qt::ControlModifier);
    QVERIFY(!motion().motion());
    QVERIFY(!action("camera.turntable")->isChecked());
    QVERIFY2(m_window->message().contains(QStringLiteral("clip space")), qPrintable(m_window->message()));
    // A scene that turns is followed by one that does not.
    QVERIFY(openSmall(QStringLiteral("builtin:cube")));
    key(Qt::Key_T, Qt::ControlModifier);
    QVERIFY(waitFor([&] { return motion().frame() != nullptr; }));
    QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
    QVERIFY(waitFor([&] { return !motion().motion(); }));
    QVERIFY(viewport().frame()->scene == document().scene());
}

void TestMotionMode::stepsEndTheMotion()
{
    QVERIFY(openSmall(QStringLiteral("builtin:cube")));
    key(Qt::Key_T, Qt::ControlModifier);
    QVERIFY(waitFor([&] { return motion().frame() != nullptr; }));
    m_window->stepMode().session().open();
    QVERIFY(!motion().motion());
    QVERIFY(settle());
    key(Qt::Key_T, Qt::ControlModifier);
    QVERIFY(!m_window->stepMode().session().isOpen());
    QVERIFY(motion().motion() == Motion::Turntable);
}

void TestMotionMode::framesAreWrittenAsGif()
{
    QVERIFY(openSmall(QStringLiteral("builtin:cube"), {64, 48}));
    const QString path = m_folder.filePath(QStringLiteral("turn.gif"));
    QSignalSpy finished(&m_window->figures(), &FigureExport::finished);
    m_window->figures().exportMotion(path, Motion::Turntable, {10, 14, 40}, m_window.get());
    QVERIFY(waitFor([&] { return finished.count() == 1; }));
    QCOMPARE(finished.front()[1].toString(), QString());
    QImageReader reader(path);
    QCOMPARE(reader.imageCount(), 5);
    const QImage first = reader.read();
    QCOMPARE(reader.nextImageDelay(), 40);
    QVERIFY(first != reader.read());
    QVERIFY(!motion().motion()); // as before
}

QTEST_MAIN(TestMotionMode)
#include "test_motion_mode.moc"
