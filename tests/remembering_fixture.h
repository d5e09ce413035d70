#pragma once
// A main window as a user has it: it asks, keeps unsaved changes and remembers, all in a folder of the test's own.
#include "core/io/session.h"
#include "tests/scene_files.h"
#include "tests/window_fixture.h"
#include "ui/document/recovery.h"

#include <QDir>
#include <QMessageBox>
#include <QPushButton>
#include <QSignalSpy>

namespace rasterlens::test
{

constexpr auto kTriangleCase = "size 8 8\ntri 0 0 0 1 1 0 0   1 0 0 1 0 1 0   0 1 0 1 0 0 1\n";

/// Settings and unsaved changes lie in this folder from now on.
inline void rememberIn(const QString& folder)
{
    qputenv("XDG_DATA_HOME", QFile::encodeName(folder));
    QCoreApplication::setOrganizationName(QStringLiteral("RasterLensTest"));
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder);
}

class RememberingFixture : public WindowFixture
{
    Q_OBJECT

protected:
    Folder m_files;

    /// A window that asks, keeps and remembers, as a user has it.
    void openRemembering()
    {
        m_window = std::make_unique<MainWindow>(MainWindow::Memory::Remember);
        m_window->setLanguage(LanguageKind::English);
        m_window->resize(1000, 700);
        m_window->show();
        QVERIFY(QTest::qWaitForWindowExposed(m_window.get()));
        m_window->activateWindow();
        viewport().setFocus();
    }

    void makeDirty(int width = 77)
    {
        Settings next = settings();
        next.size.setWidth(width);
        document().setSettings(next);
    }

    bool openFile(const QString& path)
    {
        QSignalSpy opened(&document(), &Document::opened);
        document().open(path);
        return waitFor([&] { return opened.size() == 1; });
    }

    QMessageBox* question() { return m_window->findChild<QMessageBox*>(QStringLiteral("leaveQuestion")); }

    bool answer(QMessageBox::StandardButton button)
    {
        if (!waitFor([this] { return question() != nullptr; }))
            return false;
        question()->button(button)->click();
        return true;
    }

    QPushButton* offered(const char* id)
    {
        auto* button = m_window->findChild<QPushButton*>(QLatin1String(id));
        return button && button->isVisible() ? button : nullptr;
    }

    bool press(const char* id)
    {
        if (!waitFor([&] { return offered(id) != nullptr; }))
            return false;
        offered(id)->click();
        return true;
    }

    /// The folders in which programs keep unsaved changes.
    static QStringList keptFolders()
    {
        QStringList folders;
        for (const QString& name : QDir(Recovery::folder()).entryList(QDir::Dirs | QDir::NoDotAndDotDot))
            if (QFileInfo::exists(Recovery::folder() + QLatin1Char('/') + name + QStringLiteral("/session.json")))
                folders << Recovery::folder() + QLatin1Char('/') + name;
        return folders;
    }

protected Q_SLOTS:
    void initTestCase() { rememberIn(m_folder.path()); }
    void init()
    {
        QDir(m_folder.path()).removeRecursively();
        QDir().mkpath(m_folder.path());
        QSettings().clear();
        openRemembering();
        QVERIFY(openFile(m_files.write(QStringLiteral("scene.case"), kTriangleCase)));
    }
};

} // namespace rasterlens::test
