// The panel that says which mistake made a picture.
#include "core/render/render.h"
#include "core/scenes/builtin_scenes.h"
#include "tests/window_fixture.h"
#include "ui/truth/identify_panel.h"
#include "ui/truth/picture_strip.h"
#include "ui/truth/truth_mode.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMimeData>
#include <QPushButton>
#include <QTreeWidget>

using namespace rasterlens;
using namespace rasterlens::test;

class TestIdentifyPanel : public WindowFixture
{
    Q_OBJECT

private:
    IdentifyPanel& panel() { return m_window->truthMode().identifyPanel(); }

    /// Writes what a mistake draws in the square.
    QString wrongPicture(const QString& mistake)
    {
        const Scene scene = *makeBuiltinScene(QStringLiteral("square-diagonal")).scene;
        Settings settings = scene.defaults;
        settings.mistakes = QStringList{mistake};
        Frame frame;
        render(scene, settings, frame);
        const QString path = m_folder.filePath(mistake + QStringLiteral(".png"));
        return frame.image.save(path) ? path : QString();
    }

    void drop(const QString& path)
    {
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(path)});
        const QPoint at = m_window->rect().center();
        QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &enter);
        QDropEvent dropped(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &dropped);
    }

private Q_SLOTS:
    void aDroppedPictureIsIdentified()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        drop(wrongPicture(QStringLiteral("all-exclusive")));
        QVERIFY(complete());
        QCOMPARE(document().scene()->id, QStringLiteral("builtin:square-diagonal"));
        QVERIFY(panel().isVisible());
        QVERIFY(panel().found());
        QCOMPARE(panel().found()->matches.front().mistake, QStringLiteral("all-exclusive"));
        QVERIFY2(panel().answer().contains(QStringLiteral("M2")), qPrintable(panel().answer()));
        QCOMPARE(panel().list().topLevelItemCount(), int(panel().found()->matches.size()));
        QCOMPARE(panel().list().topLevelItem(0)->text(0), QStringLiteral("100.0 %"));
        const auto& pictures = panel().pictures().pictures();
        QCOMPARE(pictures.size(), std::size_t(3));
        QCOMPARE(pictures[0].image, pictures[1].image);
    }

    void aMatchIsSwitchedOnInTheWindow()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        m_window->identifyPicture(wrongPicture(QStringLiteral("all-exclusive")));
        QVERIFY(complete());
        Q_EMIT panel().list().itemActivated(panel().list().topLevelItem(0), 0);
        QVERIFY(complete());
        QCOMPARE(settings().mistakes, QStringList{QStringLiteral("all-exclusive")});
        QCOMPARE(picture(), panel().pictures().pictures()[1].image);
        // Another match is shown beside the picture, and what was found stays.
        panel().choose(1);
        QVERIFY(complete());
        QVERIFY(panel().pictures().pictures()[0].image != panel().pictures().pictures()[1].image);
    }

    /// A picture of colours does not fit where the window shows faces by their number.
    void anotherViewIsSaid()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        const QString student = wrongPicture(QStringLiteral("all-exclusive"));
        QVERIFY(change([](Settings& s) { s.shading = Shading::TriangleId; }));
        m_window->identifyPicture(student);
        QVERIFY(complete());
        QVERIFY2(panel().remark().contains(QStringLiteral("not the view")), qPrintable(panel().remark()));
        QVERIFY(change([](Settings& s) { s.shading = Shading::Gouraud; }));
        QVERIFY2(panel().remark().contains(QStringLiteral("changed")), qPrintable(panel().remark()));
        m_window->identifyPicture(student);
        QVERIFY(complete());
        QCOMPARE(panel().remark(), QString());
        QVERIFY2(panel().answer().contains(QStringLiteral("M2")), qPrintable(panel().answer()));
    }

    void changesOfTheSceneAreTold()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        m_window->identifyPicture(wrongPicture(QStringLiteral("all-exclusive")));
        QVERIFY(complete());
        QVERIFY(change([](Settings& s) { s.size = QSize(9, 9); }));
        Q_EMIT panel().list().itemActivated(panel().list().topLevelItem(0), 0);
        QVERIFY(complete());
        QVERIFY(settings().mistakes.isEmpty()); // what was found is about another picture
    }

    void cancellingLeavesTheWindowAlive()
    {
        QVERIFY(open(QStringLiteral("builtin:torus-knot")));
        m_window->identifyPicture(wrongPicture(QStringLiteral("all-exclusive")));
        QVERIFY(panel().isRunning());
        panel().cancel();
        QVERIFY(!panel().isRunning());
        QVERIFY(!panel().found());
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        m_window->identifyPicture(wrongPicture(QStringLiteral("box-one-short")));
        QVERIFY(complete());
        QCOMPARE(panel().found()->matches.front().mistake, QStringLiteral("box-one-short"));
    }

    void whatIsNoPictureIsSaid()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        const QString path = m_folder.filePath(QStringLiteral("no.png"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("nothing");
        file.close();
        drop(path);
        QVERIFY(complete());
        QVERIFY2(m_window->message().startsWith(path), qPrintable(m_window->message()));
        QVERIFY(!panel().found());
    }

    void languageFollows()
    {
        QVERIFY(open(QStringLiteral("builtin:square-diagonal")));
        m_window->identifyPicture(wrongPicture(QStringLiteral("all-exclusive")));
        QVERIFY(complete());
        const QString english = panel().list().topLevelItem(0)->text(1);
        m_window->setLanguage(LanguageKind::Chinese);
        QTRY_VERIFY(panel().list().topLevelItem(0)->text(1) != english);
    }
};

QTEST_MAIN(TestIdentifyPanel)
#include "test_identify_panel.moc"
