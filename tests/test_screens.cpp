// The window on screens of every usual size: it fits, and what a lesson needs is in sight. Each screen is a child
// process, since a platform knows its screens from its start on.
#include "ui/pipeline/stage_strip.h"
#include "ui/pipeline/statistics_panel.h"
#include "ui/steps/step_mode.h"
#include "ui/steps/transport_dock.h"
#include "ui/window/main_window.h"
#include "ui/window/panel_places.h"
#include "ui/window/window_placement.h"

#include <QAbstractButton>
#include <QApplication>
#include <QDockWidget>
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QProcess>
#include <QScreen>
#include <QSettings>
#include <QStandardPaths>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QtTest>

#include <cstdio>
#include <functional>

using namespace rasterlens;

namespace
{

constexpr int kPatienceMs = RASTERLENS_SANITIZED ? 240000 : 60000;

/// Checks in the child process; the first that fails says why and ends it.
class Child
{
public:
    int run(LanguageKind language)
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName(QStringLiteral("RasterLensTest"));
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
        m_free = QGuiApplication::primaryScreen()->availableGeometry();
        firstStart(language);
        returnFromPresentation();
        maximizedStaysMaximized();
        panels();
        remembered();
        return m_failures;
    }

private:
    void check(bool good, const QString& what)
    {
        if (good)
            return;
        ++m_failures;
        std::fprintf(stderr, "%s\n", qPrintable(what));
    }

    static QString text(const QRect& r)
    {
        return QStringLiteral("%1x%2 at %3,%4").arg(r.width()).arg(r.height()).arg(r.x()).arg(r.y());
    }

    bool settle()
    {
        const bool settled = QTest::qWaitFor([this] { return m_window->isComplete(); }, kPatienceMs);
        QTest::qWait(20); // the layout follows the counters
        return settled;
    }

    void checkFits(const QString& when)
    {
        check(m_free.contains(m_window->frameGeometry()),
              QStringLiteral("%1: the window, %2, is larger than the screen's %3")
                  .arg(when, text(m_window->frameGeometry()), text(m_free)));
    }

    /// Whether all of a widget is in sight.
    void checkInSight(const QWidget& widget, const QString& what)
    {
        const QRect place(widget.mapTo(m_window.get(), QPoint(0, 0)), widget.size());
        const QRegion seen = widget.visibleRegion();
        check(
            widget.isVisible() && m_window->rect().contains(place) && seen.boundingRect().contains(widget.rect()),
            QStringLiteral("%1 is out of sight: %2 in a window of %3").arg(what, text(place), text(m_window->rect())));
        if (const auto* label = qobject_cast<const QLabel*>(&widget); label && !label->wordWrap())
            check(label->width() >= label->minimumSizeHint().width(), QStringLiteral("%1 is cut off").arg(what));
    }

    void checkEssentials(const QString& when)
    {
        const auto* statistics = m_window->findChild<QDockWidget*>(QStringLiteral("statisticsDock"));
        if (m_window->panels().isInSight(statistics)) {
            for (const QLabel* label : m_window->statisticsPanel().findChildren<QLabel*>())
                if (label->objectName() == QLatin1String("fps"))
                    checkInSight(*label, when + QStringLiteral(": FPS"));
            for (const char* id : {"clipped", "created_by_clipping", "culled_back", "culled_front"})
                checkInSight(*m_window->statisticsPanel().counter(QLatin1String(id)),
                             when + QStringLiteral(": ") + QLatin1String(id));
        } else {
            const auto* line = m_window->findChild<QLabel*>(QStringLiteral("counters"));
            checkInSight(*line, when + QStringLiteral(": counters in the status bar"));
            check(line->text() == m_window->statisticsPanel().brief(), when + QStringLiteral(": counters' text"));
        }
        checkInSight(m_window->stepMode().transport(), when + QStringLiteral(": transport"));
        for (const QAbstractButton* button : m_window->stepMode().transport().findChildren<QAbstractButton*>())
            if (!button->isHidden())
                checkInSight(*button, when + QStringLiteral(": ") + button->accessibleName() + button->text());
        checkInSight(*m_window->statusBar(), when + QStringLiteral(": status bar"));
        checkInSight(m_window->stageStrip(), when + QStringLiteral(": stages"));
        checkInSight(m_window->viewport(), when + QStringLiteral(": canvas"));
    }

    void firstStart(LanguageKind language)
    {
        m_window = std::make_unique<MainWindow>(MainWindow::Memory::Remember);
        m_window->setLanguage(language);
        m_window->openDefaultScene();
        m_window->show();
        check(settle(), QStringLiteral("no picture"));
        checkFits(QStringLiteral("first start"));
        checkEssentials(QStringLiteral("first start"));
        check(m_window->minimumSizeHint().width() <= 784 && m_window->minimumWidth() <= 784,
              QStringLiteral("the least width is %1").arg(m_window->minimumSizeHint().width()));
        m_window->document().open(QStringLiteral("stress:tiny"));
        check(settle(), QStringLiteral("no large scene"));
        checkFits(QStringLiteral("large numbers"));
        checkEssentials(QStringLiteral("large numbers"));
        m_window->document().open(QStringLiteral("builtin:square-diagonal"));
        check(settle(), QStringLiteral("no square"));
        m_window->stepMode().showStep(QStringLiteral("tie"));
        check(settle(), QStringLiteral("no steps"));
        checkFits(QStringLiteral("steps"));
        checkEssentials(QStringLiteral("steps"));
        m_window->stepMode().session().close();
        check(settle(), QStringLiteral("no way back"));
    }

    void returnFromPresentation()
    {
        const QRect before = m_window->geometry();
        m_window->setPresentation(true);
        QTest::qWait(50);
        m_window->setPresentation(false);
        QTest::qWait(400);
        checkFits(QStringLiteral("back from presentation"));
        check(
            m_window->geometry() == before,
            QStringLiteral("back from presentation: %1 in place of %2").arg(text(m_window->geometry()), text(before)));
        checkEssentials(QStringLiteral("back from presentation"));
    }

    void maximizedStaysMaximized()
    {
        m_window->showMaximized();
        QTest::qWait(20);
        m_window->setPresentation(true);
        QTest::qWait(20);
        m_window->setPresentation(false);
        QTest::qWait(400);
        check(m_window->isMaximized(), QStringLiteral("no longer maximised"));
        checkEssentials(QStringLiteral("maximised"));
        m_window->showNormal();
        QTest::qWait(400);
        checkFits(QStringLiteral("no longer maximised"));
    }

    /// Beside the canvas or below it, which keeps half of the window's height where a panel lies below.
    void panels()
    {
        for (const bool below : {false, true}) {
            m_window->panels().setTabsAtBottom(below);
            for (const auto& [action, dock] : m_window->panels().actions()) {
                if (!dock->isHidden())
                    continue;
                m_window->panels().toggle(dock);
                check(settle(), QStringLiteral("no panel"));
                QTest::qWait(20);
                const QString when = dock->windowTitle();
                check(m_window->panels().isInSight(dock), when + QStringLiteral(" is out of sight"));
                checkFits(when);
                checkInSight(m_window->stepMode().transport(), when + QStringLiteral(": transport"));
                checkInSight(*m_window->statusBar(), when + QStringLiteral(": status bar"));
                checkInSight(m_window->viewport(), when + QStringLiteral(": canvas"));
                const bool isBelow = m_window->dockWidgetArea(dock) == Qt::BottomDockWidgetArea;
                check(!isBelow || 2 * m_window->viewport().height() >= m_window->height(),
                      QStringLiteral("%1: the canvas has %2 of %3 rows")
                          .arg(when)
                          .arg(m_window->viewport().height())
                          .arg(m_window->height()));
                m_window->panels().toggle(dock);
                QTest::qWait(20);
            }
        }
    }

    /// A window left on a larger screen opens within the present one.
    void remembered()
    {
        m_window->close();
        m_window = std::make_unique<MainWindow>(MainWindow::Memory::Remember);
        m_window->resize(m_free.width() + 400, m_free.height() + 300);
        m_window->show();
        QTest::qWait(20);
        m_window->close();
        m_window = std::make_unique<MainWindow>(MainWindow::Memory::Remember);
        m_window->openDefaultScene();
        m_window->show();
        check(settle(), QStringLiteral("no picture after a restart"));
        QTest::qWait(400);
        checkFits(QStringLiteral("restart"));
        checkEssentials(QStringLiteral("restart"));
        m_window.reset();
    }

    QTemporaryDir m_folder;
    QRect m_free;
    std::unique_ptr<MainWindow> m_window;
    int m_failures = 0;
};

} // namespace

class TestScreens : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void windowFits_data()
    {
        QTest::addColumn<QSize>("screen");
        QTest::addColumn<QString>("scale");
        QTest::addColumn<QString>("language");
        const auto row = [](QSize screen, const char* scale) {
            for (const char* language : {"en", "zh"})
                QTest::addRow("%dx%d at %s, %s", screen.width(), screen.height(), scale, language)
                    << screen << QString::fromLatin1(scale) << QString::fromLatin1(language);
        };
        if (RASTERLENS_SANITIZED != 0) { // each row starts a window with every panel, which takes minutes then
            row({800, 600}, "1");
            return;
        }
        row({1366, 768}, "1");
        row({1280, 800}, "1");
        row({1024, 768}, "1");
        row({800, 600}, "1");
        row({1920, 1080}, "1.5");
        row({1920, 1080}, "2");
    }

    void windowFits()
    {
        QFETCH(QSize, screen);
        QFETCH(QString, scale);
        QFETCH(QString, language);
        const QTemporaryDir folder;
        QFile file(folder.filePath(QStringLiteral("screens.json")));
        QVERIFY(file.open(QIODevice::WriteOnly));
        const QJsonObject one{{"name", "one"},
                              {"x", 0},
                              {"y", 0},
                              {"width", screen.width()},
                              {"height", screen.height()},
                              {"logicalDpi", 96},
                              {"logicalBaseDpi", 96},
                              {"dpr", 1}};
        file.write(QJsonDocument(QJsonObject{{"synchronousWindowSystemEvents", false},
                                             {"windowFrameMargins", true},
                                             {"screens", QJsonArray{one}}})
                       .toJson());
        file.close();
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(QStringLiteral("QT_QPA_PLATFORM"),
                           QStringLiteral("offscreen:configfile=") + file.fileName());
        environment.insert(QStringLiteral("QT_SCALE_FACTOR"), scale);
        QProcess child;
        child.setProcessEnvironment(environment);
        child.setProcessChannelMode(QProcess::MergedChannels);
        child.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--child"), language});
        QVERIFY2(child.waitForFinished(10 * kPatienceMs), "the child does not end");
        const QByteArray said = child.readAll().replace("This plugin does not support propagateSizeHints()\n", "");
        QVERIFY2(child.exitStatus() == QProcess::NormalExit && child.exitCode() == 0, said.constData());
    }

    void placesWithinTheFreeArea()
    {
        const QRect free(0, 27, 1024, 741); // below a bar of the desktop
        const QMargins frame(1, 30, 1, 1);
        const auto outer = [&](const QRect& wanted) { return placeWithin(wanted, frame, free).marginsAdded(frame); };
        QCOMPARE(placeWithin({100, 100, 500, 400}, frame, free), QRect(100, 100, 500, 400));
        QCOMPARE(outer({-300, -300, 1440, 900}), free);
        QCOMPARE(outer({900, 700, 500, 400}).bottomRight(), free.bottomRight());
        QCOMPARE(outer({-50, 0, 500, 400}).topLeft(), free.topLeft());
    }
};

int main(int argc, char** argv)
{
    if (argc == 3 && QLatin1String(argv[1]) == QLatin1String("--child")) {
        QApplication application(argc, argv);
        return Child().run(QLatin1String(argv[2]) == QLatin1String("zh") ? LanguageKind::Chinese
                                                                         : LanguageKind::English);
    }
    QCoreApplication application(argc, argv);
    TestScreens test;
    return QTest::qExec(&test, argc, argv);
}

#include "test_screens.moc"
