#pragma once
// A main window that remembers nothing, opened anew for each test, and what tests do with it.
#include "core/io/case_file.h"
#include "ui/steps/step_mode.h"
#include "ui/window/main_window.h"

#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QtTest>

#include <memory>

namespace rasterlens::test
{

class WindowFixture : public QObject
{
    Q_OBJECT

protected:
    static constexpr int kPatienceMs = RASTERLENS_SANITIZED ? 240000 : 60000;

    QTemporaryDir m_folder;
    std::unique_ptr<MainWindow> m_window;

    Document& document() { return m_window->document(); }
    const Settings& settings() { return document().settings(); }
    ViewportWidget& viewport() { return m_window->viewport(); }
    QImage picture() { return viewport().frame()->frame.image.copy(); }

    /// However busy the machine is.
    template <class Condition>
    static bool waitFor(Condition&& condition)
    {
        return QTest::qWaitFor(condition, kPatienceMs);
    }

    /// Waits for the picture and its counters.
    bool settle()
    {
        return waitFor([this] { return m_window->isSettled(); });
    }

    /// Waits for the panels about the picture as well.
    bool complete()
    {
        return waitFor([this] { return m_window->isComplete(); });
    }

    bool open(const QString& name)
    {
        document().open(name);
        return complete() && document().scene()->id == name;
    }

    /// Opens a scene in a picture small enough for many tests.
    bool openSmall(const QString& name, QSize most = {320, 240})
    {
        document().open(name);
        if (!waitFor([this] { return !document().isLoading(); }))
            return false;
        return change([most](Settings& s) { s.size = s.size.scaled(most.boundedTo(s.size), Qt::KeepAspectRatio); }) &&
               document().scene()->id == name;
    }

    bool openText(const char* caseText)
    {
        const auto parsed = parseCase(caseText, QStringLiteral("text.case"));
        if (!parsed.scene)
            return false;
        document().setScene(std::make_shared<const Scene>(*parsed.scene));
        return complete();
    }

    template <class Change>
    bool change(Change&& change)
    {
        Settings next = settings();
        change(next);
        document().setSettings(next);
        return complete();
    }

    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier)
    {
        QTest::keyClick(&viewport(), key, modifiers);
    }

    void openWindow()
    {
        m_window = std::make_unique<MainWindow>(MainWindow::Memory::Forget);
        m_window->resize(1280, 800);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->activateWindow();
        viewport().setFocus();
    }

    void closeWindow()
    {
        if (m_window)
            m_window->setLanguage(LanguageKind::English);
        m_window.reset();
    }

protected Q_SLOTS:
    void initTestCase()
    {
        QStandardPaths::setTestModeEnabled(true);
        QCoreApplication::setOrganizationName(QStringLiteral("RasterLensTest"));
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.filePath(QStringLiteral("config")));
    }
    void init() { openWindow(); }
    void cleanup() { closeWindow(); }
};

} // namespace rasterlens::test
