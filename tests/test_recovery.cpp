// What is left of unsaved changes when a program ends or is killed. Programs are killed for true: this executable
// starts itself as a child.
#include "core/io/reach.h"
#include "tests/remembering_fixture.h"
#include "tests/seed.h"
#include "ui/document/recovery.h"
#include "ui/window/end_signals.h"
#include "ui/window/life_cycle.h"

#include <QApplication>
#include <QDockWidget>
#include <QProcess>
#include <QSocketNotifier>

#include <csignal>
#include <cstdio>
#include <random>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

constexpr auto kChild = "--child";

/// A window that remembers, in a process of its own: `test_recovery --child FOLDER SCENE`. It says "ready", then it
/// takes commands, a line each: `width N` changes the picture's width; `dock` closes the statistics.
int runChild(QApplication& application, const QStringList& arguments)
{
    rememberIn(arguments.value(2));
    const EndSignals endSignals;
    MainWindow window(MainWindow::Memory::Remember);
    QObject::connect(&endSignals, &EndSignals::received, &window, [&window](int signal) {
        window.keepAll();
        QApplication::exit(signal);
    });
    const auto say = [](const QString& text) {
        std::printf("%s\n", qPrintable(text));
        std::fflush(stdout);
    };
    QObject::connect(&window.document(), &Document::opened, &window, [&] { say(QStringLiteral("ready")); });
    QFile input;
    if (!input.open(stdin, QIODevice::ReadOnly | QIODevice::Unbuffered))
        return 1;
    QSocketNotifier notifier(0, QSocketNotifier::Read);
    QObject::connect(&notifier, &QSocketNotifier::activated, &window, [&] {
        const QList<QByteArray> words = input.readLine().trimmed().split(' ');
        if (words[0] == "width") {
            Settings settings = window.document().settings();
            settings.size.setWidth(words.value(1).toInt());
            window.document().setSettings(settings);
        } else if (words[0] == "dock") {
            window.findChild<QDockWidget*>(QStringLiteral("statisticsDock"))->hide();
        }
        say(QString::fromUtf8(words[0]));
    });
    window.show();
    window.document().open(arguments.value(3));
    return application.exec();
}

} // namespace

class TestRecovery : public RememberingFixture
{
    Q_OBJECT

private:
    static int keptWidth(const QString& folder)
    {
        const Consent consent(Outside::Allow); // the program wrote it, far from its model
        const SessionLoad load = loadSession(folder + QStringLiteral("/session.json"));
        return load.session ? settingsOf(*load.session, {}).settings.size.width() : -1;
    }

    /// Leaves a folder as a program that was killed does: no process holds its lock.
    QString leaveBehind(const QString& name, const QString& scene, int width, const QString& origin = {})
    {
        const QString folder = Recovery::folder() + QLatin1Char('/') + name;
        QDir().mkpath(folder);
        Settings settings;
        settings.size.setWidth(width);
        QFile file(folder + QStringLiteral("/origin"));
        if (saveSession({scene, toJson(settings), {}}, folder + QStringLiteral("/session.json")) ||
            !file.open(QIODevice::WriteOnly))
            qFatal("cannot write to %s", qPrintable(folder));
        file.write(origin.toUtf8());
        return folder;
    }

    struct Child {
        QProcess process;

        bool say(const QByteArray& line)
        {
            process.write(line + '\n');
            return hear(line.split(' ').first());
        }
        bool hear(const QByteArray& word)
        {
            const auto heard = [&] { return process.canReadLine() || process.waitForReadyRead(kPatienceMs); };
            while (heard())
                if (process.readLine().trimmed() == word)
                    return true;
            return false;
        }
    };

    bool start(Child& child, const QString& scene)
    {
        child.process.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        child.process.start(QCoreApplication::applicationFilePath(), {QLatin1String(kChild), m_folder.path(), scene});
        return child.hear("ready");
    }

private Q_SLOTS:
    void changesAreKeptAndTakenAwayAgain()
    {
        QVERIFY(keptFolders().isEmpty());
        makeDirty(41);
        QVERIFY(waitFor([] { return keptFolders().size() == 1; }));
        QCOMPARE(keptWidth(keptFolders().front()), 41);
        makeDirty(42);
        QVERIFY(waitFor([] { return keptWidth(keptFolders().value(0)) == 42; }));
        QVERIFY(document().saveSession(m_files.path(QStringLiteral("kept.json"))));
        QVERIFY(keptFolders().isEmpty());
    }

    void aWindowThatForgetsKeepsNothing()
    {
        closeWindow();
        openWindow();
        makeDirty();
        m_window->keepAll();
        QVERIFY(m_window->close());
        QVERIFY(!question());
        QVERIFY(keptFolders().isEmpty());
    }

    void killedAtAnyMomentLosesLittle()
    {
        // How long a kill may come after a change is the property: what was said kDelayMs before is on the disk.
        closeWindow();
        std::mt19937 random(seedOfRun());
        const int rounds =
            qEnvironmentVariableIsSet("RASTERLENS_KILLS") ? qEnvironmentVariableIntValue("RASTERLENS_KILLS") : 3;
        for (int round = 0; round < rounds; ++round) {
            Child child;
            QVERIFY(start(child, QStringLiteral("builtin:square-diagonal")));
            QVERIFY(child.say("width 101"));
            QVERIFY(waitFor([] { return keptWidth(keptFolders().value(0)) == 101; }));
            int width = 102;
            for (auto changes = random() % 20; changes > 0; --changes)
                QVERIFY(child.say("width " + QByteArray::number(++width)));
            child.process.kill();
            QVERIFY(child.process.waitForFinished(kPatienceMs));
            openRemembering();
            QVERIFY(press("restore"));
            QVERIFY(waitFor([this] { return document().scene()->id == QLatin1String("builtin:square-diagonal"); }));
            QVERIFY(settings().size.width() >= 101 && settings().size.width() <= width);
            QVERIFY(document().isDirty());
            QVERIFY(waitFor([this] { return !offered("restore"); }));
            QCOMPARE(keptFolders().size(), 1); // its own; the other program's is gone
            QVERIFY(!m_window->close());
            QVERIFY(answer(QMessageBox::Discard));
            closeWindow();
            QVERIFY(keptFolders().isEmpty());
        }
    }

    void aRunningProgramIsNotRobbed()
    {
        closeWindow();
        Child child;
        QVERIFY(start(child, QStringLiteral("builtin:square-diagonal")));
        QVERIFY(child.say("width 55"));
        QVERIFY(waitFor([] { return keptFolders().size() == 1; }));
        openRemembering();
        QVERIFY(!offered("restore"));
        makeDirty(56);
        QVERIFY(waitFor([] { return keptFolders().size() == 2; })); // each its own
        child.process.kill();
        QVERIFY(child.process.waitForFinished(kPatienceMs));
        m_window->lifeCycle().keepForNextStart();
        closeWindow();
        QCOMPARE(keptFolders().size(), 2);
        openRemembering(); // both are offered, one after the other
        QVERIFY(press("discardFound"));
        QVERIFY(press("discardFound"));
        QVERIFY(!offered("restore"));
        QVERIFY(keptFolders().isEmpty());
    }

    void restoredChangesBelongToTheirSession()
    {
        const QString path = m_files.path(QStringLiteral("own.json"));
        QVERIFY(document().saveSession(path));
        closeWindow();
        leaveBehind(QStringLiteral("a"), m_files.path(QStringLiteral("scene.case")), 19, path);
        openRemembering();
        QVERIFY(press("restore"));
        QVERIFY(waitFor([this] { return settings().size.width() == 19; }));
        QCOMPARE(document().sessionPath(), path);
        for (const InputFile& input : document().inputs()) // the file of the other run is none of the scene's
            QVERIFY2(!input.path.startsWith(Recovery::folder()), qPrintable(input.path));
        QCOMPARE(document().inputs().size(), std::size_t(2));
        QVERIFY(document().isDirty());
        QVERIFY(document().saveSession(path));
        QVERIFY(!document().isDirty());
    }

    void whatIsNotDecidedIsOfferedAgain()
    {
        closeWindow();
        leaveBehind(QStringLiteral("a"), QStringLiteral("builtin:square-diagonal"), 20);
        openRemembering();
        QVERIFY(offered("restore"));
        auto second = std::make_unique<MainWindow>(MainWindow::Memory::Remember);
        auto* twice = second->findChild<QPushButton*>(QStringLiteral("restore"));
        QVERIFY(!twice); // the first window holds it
        second.reset();
        closeWindow();
        openRemembering();
        QVERIFY(offered("restore"));
    }

    void lostSceneKeepsTheOffer()
    {
        closeWindow();
        leaveBehind(QStringLiteral("a"), m_files.path(QStringLiteral("gone.case")), 20);
        openRemembering();
        QVERIFY(press("restore"));
        QVERIFY(waitFor([this] { return !document().isLoading(); }));
        QVERIFY(offered("restore"));
        QCOMPARE(keptFolders().size(), 1);
    }

    void endSignalsKeepLayoutAndChanges_data()
    {
        QTest::addColumn<int>("signal");
        QTest::newRow("SIGTERM") << SIGTERM;
        QTest::newRow("SIGINT") << SIGINT;
        QTest::newRow("SIGHUP") << SIGHUP;
    }

    void endSignalsKeepLayoutAndChanges()
    {
        QFETCH(int, signal);
        closeWindow();
        Child child;
        QVERIFY(start(child, QStringLiteral("builtin:square-diagonal")));
        QVERIFY(child.say("width 31"));
        QVERIFY(child.say("dock"));
        ::kill(static_cast<pid_t>(child.process.processId()), signal);
        QVERIFY(child.process.waitForFinished(kPatienceMs));
        QCOMPARE(child.process.exitStatus(), QProcess::NormalExit);
        QCOMPARE(child.process.exitCode(), signal);
        QCOMPARE(keptWidth(keptFolders().value(0)), 31);
        openRemembering();
        QVERIFY(m_window->findChild<QDockWidget*>(QStringLiteral("statisticsDock"))->isHidden());
        QVERIFY(offered("restore"));
    }
};

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    const QStringList arguments = QCoreApplication::arguments();
    if (arguments.value(1) == QLatin1String(kChild))
        return runChild(application, arguments);
    TestRecovery test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_recovery.moc"
