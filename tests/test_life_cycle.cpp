// The questions before changes are given up, files that change on the disk, and recent files.
#include "tests/remembering_fixture.h"
#include "ui/base/message_bar.h"
#include "ui/face/vertex_panel.h"
#include "ui/lessons/lesson_mode.h"
#include "ui/steps/step_session.h"
#include "ui/window/life_cycle.h"
#include "ui/window/recent_labels.h"

#include <QAbstractButton>
#include <QFileDialog>
#include <QImage>
#include <QMenu>
#include <QMimeData>
#include <QSet>

#include <filesystem>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr auto kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

} // namespace

class TestLifeCycle : public RememberingFixture
{
    Q_OBJECT

private:
    /// What the bar about files on the disk says; empty when there is none.
    QString bar()
    {
        for (const MessageBar* bar : m_window->findChildren<MessageBar*>())
            if (bar->isVisible() && bar->text().contains(QStringLiteral("disk")))
                return bar->text();
        return {};
    }

private Q_SLOTS:
    void unchangedClosesWithoutQuestion()
    {
        QVERIFY(!m_window->isWindowModified());
        QVERIFY(m_window->close());
        QVERIFY(!question());
    }

    void cancelKeepsTheWindow()
    {
        makeDirty();
        QVERIFY(m_window->isWindowModified());
        QVERIFY(!m_window->close());
        QVERIFY(answer(QMessageBox::Cancel));
        QVERIFY(m_window->isVisible());
        QCOMPARE(settings().size.width(), 77);
    }

    void discardCloses()
    {
        makeDirty();
        QVERIFY(!m_window->close());
        QVERIFY(answer(QMessageBox::Discard));
        QVERIFY(waitFor([this] { return !m_window->isVisible(); }));
        m_window.reset();
        QVERIFY(keptFolders().isEmpty());
    }

    void saveClosesWithTheSessionWritten()
    {
        const QString path = m_files.path(QStringLiteral("s.json"));
        QVERIFY(document().saveSession(path));
        makeDirty(33);
        QVERIFY(!m_window->close());
        QVERIFY(answer(QMessageBox::Save));
        QVERIFY(waitFor([this] { return !m_window->isVisible(); }));
        QCOMPARE(settingsOf(*loadSession(path).session, {}).settings.size.width(), 33);
    }

    void aSessionNeverSavedIsProposedBesideTheScene()
    {
        QCOMPARE(m_window->lifeCycle().proposedPath(), m_files.path(QStringLiteral("scene.rasterlens.json")));
        makeDirty(34);
        QVERIFY(!m_window->close());
        QVERIFY(answer(QMessageBox::Save));
        auto* dialog = m_window->findChild<QFileDialog*>(QStringLiteral("saveSession"));
        QVERIFY(dialog);
        QCOMPARE(dialog->selectedFiles(), QStringList{m_files.path(QStringLiteral("scene.rasterlens.json"))});
        dialog->reject(); // no name is no answer: the window stays
        QVERIFY(m_window->isVisible());
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(!m_window->close());
        QVERIFY(answer(QMessageBox::Save));
        dialog = m_window->findChild<QFileDialog*>(QStringLiteral("saveSession"));
        QMetaObject::invokeMethod(dialog, "accept");
        QVERIFY(waitFor([this] { return !m_window->isVisible(); }));
        QVERIFY(QFileInfo::exists(m_files.path(QStringLiteral("scene.rasterlens.json"))));
        QCOMPARE(m_window->lifeCycle().proposedPath(), m_files.path(QStringLiteral("scene-2.rasterlens.json")));
        QFile::remove(m_files.path(QStringLiteral("scene.rasterlens.json")));
    }

    void openingAndDroppingAsk()
    {
        const QString other = m_files.write(QStringLiteral("other.case"), kTriangleCase);
        const QString former = document().scene()->id;
        makeDirty();
        document().open(other);
        QVERIFY(answer(QMessageBox::Cancel));
        QCOMPARE(document().scene()->id, former);
        QVERIFY(document().canUndo());

        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(other)});
        QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &enter);
        QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(m_window.get(), &drop);
        QVERIFY(answer(QMessageBox::Discard));
        QVERIFY(waitFor([&] { return document().scene()->id == other; }));
        QVERIFY(!document().isDirty());
    }

    void movedVerticesCountAsAChange()
    {
        document().editScene(withVertex(*document().scene(), 0, {0.5F, 0.5F, 0, 1}));
        QVERIFY(m_window->isWindowModified());
        document().openMistake(QStringLiteral("all-inclusive"));
        QVERIFY(answer(QMessageBox::Cancel));
        QVERIFY(m_window->isWindowModified());
        document().undo();
        QVERIFY(!m_window->isWindowModified());
    }

    void changesMadeWhileAFileIsReadAreAskedAbout()
    {
        document().open(m_files.write(QStringLiteral("late.case"), kTriangleCase));
        makeDirty(); // before the event loop hears that the file is read
        QVERIFY(answer(QMessageBox::Cancel));
        QCOMPARE(document().scene()->id, m_files.path(QStringLiteral("scene.case")));
        QCOMPARE(settings().size.width(), 77);
    }

    void titleFollowsTheLanguage()
    {
        QVERIFY(openFile(QStringLiteral("builtin:square-diagonal")));
        QCoreApplication::processEvents(); // titles follow before the next picture
        const QString english = m_window->windowTitle();
        m_window->setLanguage(LanguageKind::Chinese);
        QCoreApplication::processEvents();
        const QString chinese = m_window->windowTitle();
        m_window->setLanguage(LanguageKind::English);
        QCoreApplication::processEvents();
        QVERIFY(english.startsWith(QStringLiteral("Square cut by its diagonal")));
        QVERIFY2(!chinese.contains(QStringLiteral("Square")), qPrintable(chinese));
        QCOMPARE(m_window->windowTitle(), english);
    }

    void changedFilesAreOffered_data()
    {
        QTest::addColumn<QString>("how");
        QTest::newRow("written in place") << QStringLiteral("write");
        QTest::newRow("renamed over") << QStringLiteral("rename");
        QTest::newRow("deleted and made again") << QStringLiteral("delete");
        QTest::newRow("twice by renaming") << QStringLiteral("twice");
    }

    void changedFilesAreOffered()
    {
        QFETCH(QString, how);
        const QString obj = m_files.write(QStringLiteral("edited.obj"), kTriangle);
        QVERIFY(openFile(obj));
        const QByteArray moved = QByteArray(kTriangle).replace("0 1 0", "0 2 0") + "# longer\n";
        const auto rename = [&](const QByteArray& text) {
            std::filesystem::rename(m_files.write(QStringLiteral("edited.new"), text).toStdString(), obj.toStdString());
        };
        if (how == QLatin1String("write"))
            m_files.write(QStringLiteral("edited.obj"), moved);
        else if (how == QLatin1String("delete")) {
            QFile::remove(obj);
            QVERIFY(waitFor([this] { return bar().contains(QStringLiteral("No longer")); }));
            QVERIFY(!offered("reload"));
            m_files.write(QStringLiteral("edited.obj"), moved);
        } else
            rename(how == QLatin1String("twice") ? QByteArray(kTriangle) + "# longer" : moved);
        if (how == QLatin1String("twice")) {
            QVERIFY(press("reload"));
            QVERIFY(waitFor([this] { return !offered("reload"); }));
            rename(moved);
        }
        QVERIFY(press("reload"));
        QVERIFY(waitFor([this] { return document().scene()->mesh.vertices[2].position.y == 2; }));
        QVERIFY(waitFor([this] { return !offered("reload"); }));
    }

    void materialsAndTexturesAreWatched()
    {
        m_files.write(QStringLiteral("m.mtl"), "newmtl a\nKd 1 0 0\nmap_Kd none.png\n");
        QVERIFY(openFile(m_files.write(QStringLiteral("m.obj"),
                                       QByteArray("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n"))));
        m_files.write(QStringLiteral("m.mtl"), "newmtl a\nKd 0 0 1 \nmap_Kd none.png\n");
        QVERIFY(waitFor([this] { return bar().contains(QStringLiteral("m.mtl")); }));
        QVERIFY(press("reload"));
        QVERIFY(waitFor([this] { return document().scene()->materials[0].diffuse == glm::vec3(0, 0, 1); }));
        QImage image(2, 2, QImage::Format_RGB32); // was missing when the scene was read
        image.fill(Qt::red);
        QVERIFY(image.save(m_files.path(QStringLiteral("none.png"))));
        QVERIFY(waitFor([this] { return bar().contains(QStringLiteral("none.png")); }));
        QVERIFY(press("reload"));
        QVERIFY(waitFor([this] { return document().scene()->textures.size() == 1; }));
    }

    void reloadKeepsSettingsVerticesStepAndUndo()
    {
        const QString path = m_files.write(QStringLiteral("kept.case"), kTriangleCase);
        QVERIFY(openFile(path));
        makeDirty(12);
        document().editScene(withVertex(*document().scene(), 0, {0.5F, 0.25F, 0, 1}));
        m_window->stepMode().showStep(QStringLiteral("5"));
        QVERIFY(complete());
        QCOMPARE(m_window->stepMode().session().position(), std::size_t(5));
        m_files.write(QStringLiteral("kept.case"),
                      QByteArray(kTriangleCase).replace("0 1 0 1 0 0 1", "0 0.75 0 1 0 0 1"));
        QTest::keyClick(m_window.get(), Qt::Key_F5);
        const auto y = [this](std::size_t vertex) { return document().scene()->mesh.vertices[vertex].position.y; };
        QVERIFY(waitFor([&] { return y(2) == 0.75F; }));
        QCOMPARE(y(0), 0.25F);
        QCOMPARE(settings().size.width(), 12);
        QVERIFY(complete());
        QCOMPARE(m_window->stepMode().session().position(), std::size_t(5));
        document().undo(); // of the vertex: the file's new content stays
        QCOMPARE(y(0), 0.0F);
        QCOMPARE(y(2), 0.75F);
        document().undo();
        QCOMPARE(settings().size.width(), 8);
        QVERIFY(!document().isDirty());
    }

    void verticesThatDoNotFitAreTold()
    {
        const QString path = m_files.write(QStringLiteral("fewer.case"), kTriangleCase);
        QVERIFY(openFile(path));
        document().editScene(withVertex(*document().scene(), 0, {0.5F, 0.25F, 0, 1}));
        m_files.write(QStringLiteral("fewer.case"), QByteArray(kTriangleCase) + QByteArray(kTriangleCase).mid(9));
        document().reload();
        QVERIFY(waitFor([this] { return document().scene()->mesh.vertices.size() == 6; }));
        QVERIFY(m_window->message().contains(QStringLiteral("6 vertices instead of 3")));
    }

    void aReloadThatFailsKeepsTheScene()
    {
        const QString path = m_files.write(QStringLiteral("broken.case"), kTriangleCase);
        QVERIFY(openFile(path));
        const auto former = document().scene();
        m_files.write(QStringLiteral("broken.case"), "size 8 8\ntri 0 0 zero\n");
        QVERIFY(press("reload"));
        QVERIFY(waitFor([&] { return m_window->message().contains(path + QStringLiteral(":2: ")); }));
        QCOMPARE(document().scene(), former);
        QVERIFY(waitFor([this] { return !offered("reload"); }));
        m_files.write(QStringLiteral("broken.case"), QByteArray(kTriangleCase) + "note mended\n");
        QVERIFY(press("reload"));
        QVERIFY(waitFor([this] { return document().scene()->note == QLatin1String("mended"); }));
    }

    void aSessionChangedByAnotherProgramIsOffered()
    {
        const QString path = m_files.path(QStringLiteral("shared.json"));
        QVERIFY(document().saveSession(path));
        QTest::qWait(1000); // its own writing is no change
        QVERIFY(!offered("reload"));
        Session session = document().session();
        Settings other = settings();
        other.size.setWidth(23);
        session.settings = toJson(other);
        QVERIFY(!saveSession(session, path));
        QVERIFY(press("reload"));
        QVERIFY(waitFor([this] { return settings().size.width() == 23; }));
    }

    void recentFilesCanBeToldApart()
    {
        const QStringList paths{QStringLiteral("/a/left/cube.obj"), QStringLiteral("/a/right/cube.obj"),
                                QStringLiteral("/x/") + QString(60, QLatin1Char('p')) + QStringLiteral("/end/cube.obj"),
                                QStringLiteral("/y/") + QString(60, QLatin1Char('p')) + QStringLiteral("/end/cube.obj"),
                                QDir::homePath() + QStringLiteral("/cube.obj")};
        const QStringList labels = recentLabels(paths);
        QCOMPARE(QSet<QString>(labels.begin(), labels.end()).size(), 5);
        QCOMPARE(labels[0], QStringLiteral("cube.obj  \u2013  /a/left"));
        QVERIFY(labels[2].startsWith(QStringLiteral("cube.obj  \u2013  /x/p")));
        QCOMPARE(labels[4], QStringLiteral("cube.obj  \u2013  ~"));
        const QStringList one = recentLabels({paths[2]});
        QCOMPARE(one, QStringList{QStringLiteral("cube.obj  \u2013  \u2026/end")});
    }

    /// A model that was sent with a path to somewhere else: nothing of it is read before the user agrees, and what was
    /// agreed to is remembered.
    void filesOutsideAreReadWhenTheUserAgrees()
    {
        QVERIFY(QDir(m_files.path()).mkpath(QStringLiteral("sent")));
        m_files.write(QStringLiteral("m.mtl"), "newmtl a\nKd 0 0 1\n");
        const QString model =
            m_files.write(QStringLiteral("sent/m.obj"), QByteArray("mtllib ../m.mtl\nusemtl a\n") + kTriangle);
        const auto isRead = [this] { return document().scene()->materials[0].diffuse == glm::vec3(0, 0, 1); };
        QVERIFY(openFile(model));
        QVERIFY(!isRead());
        auto* question = m_window->findChild<QMessageBox*>(QStringLiteral("outsideQuestion"));
        QVERIFY(question && question->informativeText() == m_files.path(QStringLiteral("m.mtl")));
        question->defaultButton()->click(); // no
        QVERIFY(!isRead());
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(openFile(model));
        question = m_window->findChild<QMessageBox*>(QStringLiteral("outsideQuestion"));
        QVERIFY(question);
        makeDirty(12);
        for (QAbstractButton* button : question->buttons())
            if (question->buttonRole(button) == QMessageBox::AcceptRole)
                button->click();
        QVERIFY(waitFor(isRead));
        QCOMPARE(settings().size.width(), 12); // the model is read again, nothing is given up
        document().undo();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(openFile(model));
        QVERIFY(isRead() && !m_window->findChild<QMessageBox*>(QStringLiteral("outsideQuestion")));
    }

    void sessionsNameModelsOutsideWhenTheUserAgrees()
    {
        QVERIFY(QDir(m_files.path()).mkpath(QStringLiteral("sent")));
        const QString session =
            m_files.write(QStringLiteral("sent/s.json"),
                          R"({"rasterlens": 1, "scene": "../scene.case", "settings": {"size": "9x9"}})");
        document().open(session);
        QMessageBox* question = nullptr;
        QVERIFY(waitFor([&] {
            question = m_window->findChild<QMessageBox*>(QStringLiteral("outsideQuestion"));
            return question != nullptr;
        }));
        QCOMPARE(settings().size.width(), 8);
        for (QAbstractButton* button : question->buttons())
            if (question->buttonRole(button) == QMessageBox::AcceptRole)
                button->click();
        QVERIFY(waitFor([this] { return settings().size.width() == 9; }));
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);

        // The window knows the sessions that it has written itself.
        QVERIFY(document().saveSession(m_files.path(QStringLiteral("sent/own.json"))));
        QVERIFY(openFile(m_files.path(QStringLiteral("sent/own.json"))));
        QVERIFY(!m_window->findChild<QMessageBox*>(QStringLiteral("outsideQuestion")));
    }

    void lessonsNameScenesOutsideWhenTheUserAgrees()
    {
        QVERIFY(QDir(m_files.path()).mkpath(QStringLiteral("sent")));
        const QString lesson =
            m_files.write(QStringLiteral("sent/l.json"),
                          R"({"rasterlens-lesson": 1, "id": "a", "title": {"en": "A", "zh": "甲"}, "steps": [
                              {"scene": "../scene.case", "caption": {"en": "One.", "zh": "一。"}}]})");
        m_window->open(lesson);
        QVERIFY(!m_window->lessons().player().isOpen());
        QMessageBox* question = nullptr;
        QVERIFY(waitFor([&] {
            question = m_window->findChild<QMessageBox*>(QStringLiteral("outsideQuestion"));
            return question != nullptr;
        }));
        QCOMPARE(question->informativeText(), m_files.path(QStringLiteral("scene.case")));
        for (QAbstractButton* button : question->buttons())
            if (question->buttonRole(button) == QMessageBox::AcceptRole)
                button->click();
        QVERIFY(waitFor([this] { return m_window->lessons().player().isOpen(); }));
    }

    void vanishedRecentFilesSaySo()
    {
        document().clearRecentFiles();
        const QString path = m_files.write(QStringLiteral("short&lived.case"), kTriangleCase);
        QVERIFY(openFile(path));
        QFile::remove(path);
        QMenu* recent = nullptr;
        for (QMenu* menu : m_window->findChildren<QMenu*>())
            if (menu->title() == QStringLiteral("Open &recent"))
                recent = menu;
        QVERIFY(recent);
        Q_EMIT recent->aboutToShow();
        QVERIFY(recent->actions().front()->text().startsWith(QStringLiteral("short&&lived.case")));
        QVERIFY(recent->actions().front()->text().endsWith(QStringLiteral("(not found)")));
        QVERIFY(!recent->actions().front()->isEnabled());
        recent->actions().back()->trigger();
        QVERIFY(document().recentFiles().isEmpty());
    }
};

QTEST_MAIN(TestLifeCycle)
#include "test_life_cycle.moc"
