#pragma once
#include "ui/base/language.h"

#include <QAction>
#include <QAnyStringView>
#include <QKeySequence>
#include <QList>
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>

#include <functional>
#include <initializer_list>
#include <utility>
#include <vector>

class QMenu;
class QWidget;

namespace rasterlens
{

/// The headings of the help and of README's list of keys, in the order in which they stand there.
enum class ActionSection { File, Edit, Pipeline, Canvas, Camera, Window, Steps, Compare, Panels, Lessons };

/// A text in every language of the window.
struct ActionWords {
    const char* context = nullptr; ///< under which the translation stands; null: there is only a name
    const char* english = nullptr;
    QString name = {};    ///< what no language changes, as the number of a mistake; it stands first
    QString chinese = {}; ///< the name in Chinese, where it has one and there is no context

    [[nodiscard]] bool isEmpty() const { return !context && name.isEmpty(); }
    /// In the language in use.
    [[nodiscard]] QString text() const;
    /// In the language that is not in use.
    [[nodiscard]] QString inOther(const Language& language) const;
};

/// A text of a menu without the mark of its mnemonic: `Open…` of `&Open…` and of `Open(&O)…`.
[[nodiscard]] QString withoutMnemonic(const QString& text);

/// One thing that the user can do.
struct ActionRow {
    QString id; ///< never changes: `view.fit`
    ActionSection section = ActionSection::File;
    ActionWords words = {};
    std::vector<ActionWords> path = {};          ///< the menus in which it lies, that of the menu bar first
    QAction* action = nullptr;                   ///< null: a hint about the mouse or a key that a widget reads itself
    ActionWords keyWords = {};                   ///< what the lists show in place of the action's keys: "Wheel"
    ActionWords toolTip = {};                    ///< empty: that of Qt, which is the text
    ActionWords listedWords = {};                ///< what the lists say where they say something else than the menu
    std::vector<const QAction*> listedWith = {}; ///< more actions that the line in the lists stands for
    bool isListed = true;                        ///< false: the line of another row stands for it
    std::function<QString()> state = nullptr;    ///< null: on or off where the action can be checked
    bool showsStateInMenu = false;               ///< behind a colon
};

/// A line and a section of the help.
struct KeyLine {
    QString keys;
    QString what;
    QString state; ///< may be empty

    friend bool operator==(const KeyLine&, const KeyLine&) = default;
};
struct KeySection {
    QString title;
    std::vector<KeyLine> lines;

    friend bool operator==(const KeySection&, const KeySection&) = default;
};

/// Everything that the window can do: each part registers its actions here, under ids that never change. Menus, keys,
/// the help, the search for actions and README's list of keys are made from the rows. Files that were opened lately are
/// data of a menu and no rows.
class ActionTable : public QObject
{
    Q_OBJECT

public:
    /// in  the window in which the keys work, also while its menu bar is hidden
    ActionTable(QWidget& window, const Language& language);

    /// Adds an action to a menu and to the table.
    ///
    /// in   row: id, section, words and path; an action where there is one already
    /// out  lives as long as the window
    QAction* add(QMenu* menu, ActionRow row, const QList<QKeySequence>& keys);
    /// Keeps the title of a menu in the language in use.
    void addMenu(QMenu* menu, const ActionWords& title);
    /// Adds a line about something that is no action.
    void addHint(QAnyStringView id, ActionSection section, const ActionWords& keys, const ActionWords& what);

    /// One line of the lists stands for several actions, at the place of the first.
    void listTogether(const ActionWords& words, std::initializer_list<QAction*> actions);
    /// Lists an action that has no key, with these words in place of the key.
    void listWithoutKey(const QAction* action, const ActionWords& keyWords);
    /// Keeps the tip of an action in the language in use.
    void setToolTip(const QAction* action, const ActionWords& tip);
    /// What the help shows beside an action, and on request the menu too.
    void setState(const QAction* action, std::function<QString()> state, bool inMenu = false);

    [[nodiscard]] const std::vector<ActionRow>& rows() const { return m_rows; }
    /// Null if no row has the id.
    [[nodiscard]] QAction* action(QAnyStringView id) const;
    [[nodiscard]] QString stateOf(const ActionRow& row) const;
    /// `Step › Run until › Tie`, in the language in use.
    [[nodiscard]] static QString pathOf(const ActionRow& row);
    /// pathOf() in the language that is not in use.
    [[nodiscard]] QString pathInOther(const ActionRow& row) const;
    [[nodiscard]] static QString keysOf(const ActionRow& row, QKeySequence::SequenceFormat format);

    /// The lines of all rows that have keys.
    [[nodiscard]] std::vector<KeySection> sections(QKeySequence::SequenceFormat format) const;
    /// sections() as a table of Markdown: section, key, what.
    [[nodiscard]] QString markdown() const;

    /// Ids that two rows have, and keys that two actions have that hear it at the same time; one text each.
    [[nodiscard]] QStringList conflicts() const;

    void retranslate();
    /// Menus show the present states.
    void syncStates();

Q_SIGNALS:
    void changed(); ///< once for many changes of actions at a time

private:
    [[nodiscard]] ActionRow& rowOf(const QAction* action);
    void setText(const ActionRow& row);

    QWidget& m_window;
    const Language& m_language;
    std::vector<ActionRow> m_rows;
    std::vector<std::pair<QMenu*, ActionWords>> m_menus;
    QTimer m_changedSoon;
};

/// A menu of the window while it is filled, with what its entries have in common.
class ActionMenu
{
public:
    /// in  owner: its class is the context of the texts; entries do nothing once it is gone
    ActionMenu(ActionTable& table, QMenu* menu, QObject& owner, ActionSection section, const char* title);

    /// in  run: called without arguments, or with whether the action is checked now
    template <class Run>
    QAction* add(QAnyStringView id, const ActionWords& words, const QList<QKeySequence>& keys, Run run)
    {
        QAction* action = m_table->add(m_menu, {id.toString(), m_section, words, m_path}, keys);
        QObject::connect(action, &QAction::triggered, m_owner, std::move(run));
        return action;
    }
    template <class Run>
    QAction* add(QAnyStringView id, const char* english, const QList<QKeySequence>& keys, Run run)
    {
        return add(id, words(english), keys, std::move(run));
    }
    template <class Run>
    QAction* addToggle(QAnyStringView id, const char* english, const QList<QKeySequence>& keys, bool on, Run run)
    {
        QAction* action = add(id, words(english), keys, std::move(run));
        action->setCheckable(true);
        action->setChecked(on);
        return action;
    }
    /// Takes in an action that exists.
    void take(QAnyStringView id, const ActionWords& words, const QList<QKeySequence>& keys, QAction* action);
    ActionMenu addMenu(const ActionWords& title);
    ActionMenu addMenu(const char* english) { return addMenu(words(english)); }
    void addSeparator();

    /// This menu; its next entries belong to another section.
    [[nodiscard]] ActionMenu in(ActionSection section) const;
    [[nodiscard]] ActionWords words(const char* english) const { return {m_owner->metaObject()->className(), english}; }
    [[nodiscard]] QMenu* menu() const { return m_menu; }
    [[nodiscard]] ActionTable& table() const { return *m_table; }

private:
    ActionTable* m_table;
    QMenu* m_menu;
    QObject* m_owner;
    ActionSection m_section;
    std::vector<ActionWords> m_path;
};

} // namespace rasterlens
