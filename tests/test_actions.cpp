// The table of actions: what is in it, the check for keys that two actions have, help, README's list and the search.
#include "tests/window_fixture.h"
#include "ui/base/action_table.h"
#include "ui/pipeline/pipeline_panel.h"
#include "ui/window/action_search.h"
#include "ui/window/help_overlay.h"

#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QSet>
#include <QTreeView>

#include <algorithm>

using namespace rasterlens;
using namespace rasterlens::test;

namespace
{

/// All actions of a menu and its submenus that can be triggered.
void collect(const QMenu& menu, QList<const QAction*>& found)
{
    for (const QAction* action : menu.actions())
        if (action->menu())
            collect(*action->menu(), found);
        else if (!action->isSeparator())
            found << action;
}

} // namespace

class TestActions : public WindowFixture
{
    Q_OBJECT

private Q_SLOTS:
    void everyMenuEntryIsARow();
    void windowHasNoConflicts();
    void plantedConflictsAreFound();
    void textsWithoutMnemonics();
    void helpHasEveryKey_data();
    void helpHasEveryKey();
    void helpOpensByBothKeys();
    void keysInMarkdown();
    void searchRunsByKeys();
    void searchShowsWholeNames();
    void searchFindsBothLanguages();
    void searchDimsWhatCannotRun();
    void searchLeaves();

private:
    const ActionTable& table() { return m_window->actionTable(); }
    ActionSearch& search() { return m_window->actionSearch(); }
    QString typed(const QString& text)
    {
        search().edit().clear();
        QTest::keyClicks(&search().edit(), text);
        return search().view().currentIndex().data().toString();
    }
    bool openSearch()
    {
        key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        return search().isVisible() && search().edit().hasFocus();
    }
    /// The texts of all pages, in type that is not much smaller than elsewhere; the first page is shown, then the last.
    QString help()
    {
        HelpOverlay& overlay = m_window->helpOverlay();
        QString all;
        do {
            for (const QLabel* label : overlay.findChildren<QLabel*>()) {
                all += label->text();
                if (label->font().pointSizeF() < 0.7 * QApplication::font().pointSizeF())
                    all += QStringLiteral("small type");
            }
            if (!m_window->rect().contains(overlay.geometry()))
                all += QStringLiteral("larger than the window");
        } while (overlay.turnPage());
        return all;
    }
};

void TestActions::everyMenuEntryIsARow()
{
    document().clearRecentFiles();
    QSet<const QAction*> known;
    for (const ActionRow& row : table().rows())
        known << row.action;
    QList<const QAction*> entries;
    for (const QAction* top : m_window->menuBar()->actions())
        collect(*top->menu(), entries);
    QVERIFY(entries.size() > 200);
    for (const QAction* entry : std::as_const(entries))
        QVERIFY2(known.contains(entry), qPrintable(entry->text()));
    for (const QAction* action : m_window->findChildren<QAction*>())
        if (!action->shortcut().isEmpty())
            QVERIFY2(known.contains(action), qPrintable(action->text()));
}

void TestActions::windowHasNoConflicts()
{
    QCOMPARE(table().conflicts(), QStringList());
    for (const ActionRow& row : table().rows()) {
        QVERIFY2(!row.words.text().isEmpty(), qPrintable(row.id));
        QCOMPARE(row.action, table().action(row.id));
    }
    QVERIFY(!table().action("view.fitt"));
}

void TestActions::plantedConflictsAreFound()
{
    QWidget window;
    const Language language;
    ActionTable planted(window, language);
    QMenu menu;
    const auto add = [&](const char* id, const QList<QKeySequence>& keys) {
        return planted.add(&menu, {id, ActionSection::Window, {.name = QLatin1String(id)}}, keys);
    };
    add("a", {Qt::Key_F, Qt::CTRL | Qt::Key_F});
    add("b", {Qt::Key_G});
    QCOMPARE(planted.conflicts(), QStringList());
    add("a", {});
    QCOMPARE(planted.conflicts(), QStringList{QStringLiteral("two rows are called a")});
    add("c", {Qt::SHIFT | Qt::Key_F, Qt::CTRL | Qt::Key_F});
    QCOMPARE(planted.conflicts().size(), 2);
    QCOMPARE(planted.conflicts().last(), QStringLiteral("a and c have the key Ctrl+F"));

    // A key of one widget is free in another, but not beside a key of the whole window.
    ActionTable scoped(window, language);
    QMenu left;
    QMenu right;
    QAction* narrow = scoped.add(&left, {"left", ActionSection::Window, {.name = QStringLiteral("left")}}, {Qt::Key_F});
    narrow->setShortcutContext(Qt::WidgetShortcut);
    window.removeAction(narrow);
    QAction* other =
        scoped.add(&right, {"right", ActionSection::Window, {.name = QStringLiteral("right")}}, {Qt::Key_F});
    QCOMPARE(scoped.conflicts(), QStringList{QStringLiteral("left and right have the key F")});
    other->setShortcutContext(Qt::WidgetShortcut);
    window.removeAction(other);
    QCOMPARE(scoped.conflicts(), QStringList());
    left.addAction(other);
    QCOMPARE(scoped.conflicts().size(), 1);
}

void TestActions::textsWithoutMnemonics()
{
    QCOMPARE(withoutMnemonic(QStringLiteral("&Open\u2026")), QStringLiteral("Open\u2026"));
    QCOMPARE(withoutMnemonic(QStringLiteral("\u6253\u5f00(&O)\u2026")), QStringLiteral("\u6253\u5f00\u2026"));
    QCOMPARE(withoutMnemonic(QStringLiteral("A && B")), QStringLiteral("A & B"));
}

void TestActions::helpHasEveryKey_data()
{
    QTest::addColumn<bool>("onStage");
    QTest::newRow("window") << false;
    QTest::newRow("stage") << true;
}

/// Every key of every action is in the help, in both languages, also in a window of 1024 x 768; and on the stage in the
/// type of the stage.
void TestActions::helpHasEveryKey()
{
    QFETCH(const bool, onStage);
    QVERIFY(openSmall(QStringLiteral("builtin:cube")));
    m_window->setPresentation(onStage);
    m_window->showNormal();
    m_window->resize(1024, 768);
    std::vector<const QAction*> together;
    for (const ActionRow& row : table().rows())
        together.insert(together.end(), row.listedWith.begin(), row.listedWith.end());
    for (const LanguageKind kind : {LanguageKind::English, LanguageKind::Chinese}) {
        m_window->setLanguage(kind);
        QCoreApplication::processEvents();
        key(Qt::Key_H);
        const QString shown = help();
        QVERIFY2(!shown.contains(QStringLiteral("small type")), "it is not read from afar");
        QVERIFY2(!shown.contains(QStringLiteral("larger than")), "it is larger than the window");
        QCOMPARE(m_window->helpOverlay().pages() > 1, onStage);
        int lines = 0;
        for (const ActionRow& row : table().rows()) {
            const QString keys = ActionTable::keysOf(row, QKeySequence::NativeText);
            if (keys.isEmpty())
                continue;
            if (!row.isListed) {
                QVERIFY2(std::ranges::find(together, row.action) != together.end(), qPrintable(row.id));
                continue;
            }
            ++lines;
            const QString line = QStringLiteral("'>%1").arg(keys.toHtmlEscaped());
            QVERIFY2(shown.contains(line + QStringLiteral("</span>")) || shown.contains(line + QStringLiteral(" /")),
                     qPrintable(row.id));
        }
        QVERIFY(lines > 50);
        key(Qt::Key_H);
        QVERIFY(!m_window->helpOverlay().isVisible());
    }
}

void TestActions::helpOpensByBothKeys()
{
    for (const Qt::Key pressed : {Qt::Key_H, Qt::Key_F1}) {
        key(pressed);
        QVERIFY(m_window->helpOverlay().isVisible());
        key(Qt::Key_Escape);
        QVERIFY(!m_window->helpOverlay().isVisible());
    }
}

void TestActions::keysInMarkdown()
{
    const QStringList lines = table().markdown().split(QLatin1Char('\n'), Qt::SkipEmptyParts);
    QCOMPARE(lines[0], QStringLiteral("| section | key | what |"));
    QVERIFY(lines.contains(QStringLiteral("| Canvas | F | Fit |")));
    QVERIFY(lines.contains(QStringLiteral("| Steps | Shift+Left / Right | One row |")));
    QVERIFY(lines.contains(QStringLiteral("| Edit | Ctrl+Shift+Z / Ctrl+Y | Redo |")));
    QVERIFY(lines.contains(QStringLiteral("| Panels | Alt+4 | Vertices |")));
    QVERIFY(lines.contains(QStringLiteral("| Canvas | Wheel | Zoom at the cursor |")));
}

void TestActions::searchRunsByKeys()
{
    QVERIFY(openSmall(QStringLiteral("builtin:cube")));
    QVERIFY(openSearch());
    QCOMPARE(typed(QStringLiteral("dark th")), QStringLiteral("View \u203a Dark theme"));
    QTest::keyClick(&search().edit(), Qt::Key_Return);
    QVERIFY(!search().isVisible());
    QVERIFY(viewport().hasFocus());
    QCOMPARE(m_window->look().kind, ThemeKind::Dark);

    QVERIFY(openSearch());
    QVERIFY(search().edit().text().isEmpty());
    QCOMPARE(typed(QStringLiteral("theme pqrst")), QString()); // no action has both words
    QTest::keyClick(&search().edit(), Qt::Key_Return);
    QVERIFY(search().isVisible());
    const QString first = typed(QStringLiteral("A and B"));
    QTest::keyClick(&search().edit(), Qt::Key_Down);
    const QString second = search().view().currentIndex().data().toString();
    QVERIFY(!second.isEmpty() && second != first);
    QTest::keyClick(&search().edit(), Qt::Key_Up);
    QCOMPARE(search().view().currentIndex().data().toString(), first);

    QCOMPARE(typed(QStringLiteral("go to pixel")), QStringLiteral("View \u203a Go to pixel"));
    QTest::keyClick(&search().edit(), Qt::Key_Return);
    QVERIFY2(m_window->findChild<QLineEdit*>(QStringLiteral("goToPixel"))->hasFocus(),
             "the action's field has the keys");
}

void TestActions::searchShowsWholeNames()
{
    QVERIFY(openSmall(QStringLiteral("builtin:cube")));
    for (const LanguageKind kind : {LanguageKind::English, LanguageKind::Chinese}) {
        m_window->setLanguage(kind);
        QVERIFY(openSearch());
        const QTreeView& view = search().view();
        const QAbstractItemModel& model = *view.model();
        QVERIFY(model.rowCount() > 200);
        for (int row = 0; row < model.rowCount(); ++row) {
            const QString name = model.index(row, 0).data().toString();
            QVERIFY2(view.fontMetrics().horizontalAdvance(name) < view.columnWidth(0), qPrintable(name));
        }
        key(Qt::Key_Escape);
    }
}

void TestActions::searchFindsBothLanguages()
{
    QVERIFY(openSmall(QStringLiteral("builtin:cube")));
    QVERIFY(openSearch());
    search().edit().setText(QStringLiteral("\u6df1\u8272")); // an input method writes it at once
    QCOMPARE(search().view().currentIndex().data().toString(), QStringLiteral("View \u203a Dark theme"));
    m_window->setLanguage(LanguageKind::Chinese);
    QCoreApplication::processEvents();
    const QString chinese = typed(QStringLiteral("dark theme"));
    QVERIFY2(chinese.endsWith(QStringLiteral("\u6df1\u8272\u4e3b\u9898")), qPrintable(chinese));
    const QModelIndex keys = search().view().currentIndex().siblingAtColumn(2);
    QCOMPARE(keys.data().toString(), table().action("view.dark")->shortcut().toString(QKeySequence::NativeText));
}

void TestActions::searchDimsWhatCannotRun()
{
    QVERIFY(openSmall(QStringLiteral("builtin:cube")));
    QVERIFY(!table().action("step.until-tie")->isEnabled());
    QVERIFY(openSearch());
    QCOMPARE(typed(QStringLiteral("run until tie")), QString()); // shown, but nothing is chosen
    const QAbstractItemModel& shown = *search().view().model();
    QCOMPARE(shown.rowCount(), 1);
    QVERIFY(!(shown.index(0, 0).flags() & Qt::ItemIsEnabled));
    QTest::keyClick(&search().edit(), Qt::Key_Down);
    QTest::keyClick(&search().edit(), Qt::Key_Return);
    QTest::mouseClick(search().view().viewport(), Qt::LeftButton, {},
                      search().view().visualRect(shown.index(0, 0)).center());
    QVERIFY(search().isVisible());
    QVERIFY(!m_window->stepMode().session().isOpen());
}

void TestActions::searchLeaves()
{
    QVERIFY(openSearch());
    QTest::keyClick(&search().edit(), Qt::Key_Escape);
    QVERIFY(!search().isVisible());
    QVERIFY(viewport().hasFocus());
    QVERIFY(openSearch());
    QTest::keyClick(&search().edit(), Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(!search().isVisible());
    QVERIFY(viewport().hasFocus());
    QVERIFY(openSearch());
    m_window->pipelinePanel().setFocus();
    viewport().setFocus();
    QVERIFY2(!search().isVisible(), "what is clicked elsewhere gets the keys");
    bool found = false;
    for (const QAction* top : m_window->menuBar()->actions())
        found |= top->menu()->actions().contains(table().action("help.search"));
    QVERIFY(found);
}

QTEST_MAIN(TestActions)
#include "test_actions.moc"
