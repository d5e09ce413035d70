#include "ui/base/action_table.h"

#include "core/base/closed_list.h"

#include <QCoreApplication>
#include <QHash>
#include <QMenu>
#include <QRegularExpression>
#include <QWidget>

#include <algorithm>
#include <array>

namespace rasterlens
{
namespace
{

struct SectionRow {
    ActionSection section;
    const char* title;
};

constexpr auto kSections = std::to_array<SectionRow>({
    {ActionSection::File, QT_TRANSLATE_NOOP("rasterlens::ActionTable", "File")},
    {ActionSection::Edit, QT_TRANSLATE_NOOP("rasterlens::ActionTable", "Edit")},
    {ActionSection::Pipeline, QT_TRANSLATE_NOOP("rasterlens::ActionTable", "Pipeline")},
    {ActionSection::Canvas, QT_TRANSLATE_NOOP("rasterlens::ActionTable", "Canvas")},
    {ActionSection::Camera, QT_TRANSLATE_NOOP("rasterlens::ActionTable", "Camera")},
    {ActionSection::Window, QT_TRANSLATE_NOOP("rasterlens::ActionTable", "Window")},
    {ActionSection::Steps, QT_TRANSLATE_NOOP("rasterlens::ActionTable", "Steps")},
    {ActionSection::Compare, QT_TRANSLATE_NOOP("rasterlens::ActionTable", "Compare")},
    {ActionSection::Panels, QT_TRANSLATE_NOOP("rasterlens::ActionTable", "Panels")},
    {ActionSection::Lessons, QT_TRANSLATE_NOOP("rasterlens::ActionTable", "Lessons")},
});
static_assert(isClosedList(kSections, &SectionRow::section));

/// `Shift+Left / Right`: a key with the modifiers of the one before it is named without them.
QString joined(const QList<QKeySequence>& keys, QKeySequence::SequenceFormat format)
{
    QStringList parts;
    Qt::KeyboardModifiers former;
    for (const QKeySequence& key : keys) {
        const Qt::KeyboardModifiers modifiers = key[0].keyboardModifiers();
        const bool repeats = !parts.isEmpty() && modifiers == former;
        parts << (repeats ? QKeySequence(key[0].key()) : key).toString(format);
        former = modifiers;
    }
    return parts.join(QStringLiteral(" / "));
}

/// Whether a key of theirs would reach both.
bool hearTheSameKeys(const QAction& a, const QAction& b)
{
    const auto inWholeWindow = [](const QAction& action) {
        return action.shortcutContext() == Qt::WindowShortcut || action.shortcutContext() == Qt::ApplicationShortcut;
    };
    if (inWholeWindow(a) || inWholeWindow(b))
        return true;
    const QList<QObject*> around = b.associatedObjects();
    return std::ranges::any_of(a.associatedObjects(), [&](QObject* object) { return around.contains(object); });
}

QString pathText(QStringList parts)
{
    for (QString& part : parts)
        part = withoutMnemonic(part);
    return parts.join(QStringLiteral(" \u203a "));
}

/// The name of something that no translation file knows.
QString nameIn(LanguageKind kind, const ActionWords& words)
{
    return kind == LanguageKind::Chinese && !words.chinese.isEmpty() ? words.chinese : words.name;
}

/// For a cell of a table in Markdown.
QString escaped(QString text) { return text.replace(QLatin1Char('|'), QLatin1String("\\|")); }

} // namespace

QString ActionWords::text() const
{
    if (!context)
        return nameIn(Language::inUse(), *this);
    const QString translated = QCoreApplication::translate(context, english);
    return name.isEmpty() ? translated : name + QLatin1Char(' ') + translated;
}

QString ActionWords::inOther(const Language& language) const
{
    if (!context)
        return nameIn(language.kind() == LanguageKind::Chinese ? LanguageKind::English : LanguageKind::Chinese, *this);
    const QString other = language.inOther(context, english);
    return name.isEmpty() ? other : name + QLatin1Char(' ') + other;
}

QString withoutMnemonic(const QString& text)
{
    static const QRegularExpression behind(QStringLiteral(R"(\(&.\))"));
    static const QRegularExpression within(QStringLiteral("&(.)"));
    return QString(text).remove(behind).replace(within, QStringLiteral("\\1"));
}

ActionTable::ActionTable(QWidget& window, const Language& language) : m_window(window), m_language(language)
{
    m_changedSoon.setSingleShot(true);
    m_changedSoon.setInterval(0);
    connect(&m_changedSoon, &QTimer::timeout, this, &ActionTable::changed);
}

QAction* ActionTable::add(QMenu* menu, ActionRow row, const QList<QKeySequence>& keys)
{
    if (!row.action)
        row.action = new QAction(&m_window);
    QAction* action = row.action;
    action->setShortcuts(keys);
    menu->addAction(action);
    if (!keys.isEmpty())
        m_window.addAction(action); // its keys work also while the menu bar is hidden
    setText(row);
    connect(action, &QAction::changed, &m_changedSoon, qOverload<>(&QTimer::start));
    m_rows.push_back(std::move(row));
    return action;
}

void ActionTable::addMenu(QMenu* menu, const ActionWords& title)
{
    menu->setTitle(title.text());
    m_menus.emplace_back(menu, title);
}

void ActionTable::addHint(QAnyStringView id, ActionSection section, const ActionWords& keys, const ActionWords& what)
{
    ActionRow row{id.toString(), section, what};
    row.keyWords = keys;
    m_rows.push_back(std::move(row));
}

ActionRow& ActionTable::rowOf(const QAction* action)
{
    const auto row = std::ranges::find(m_rows, action, &ActionRow::action);
    Q_ASSERT(row != m_rows.end());
    return *row;
}

void ActionTable::listTogether(const ActionWords& words, std::initializer_list<QAction*> actions)
{
    ActionRow& first = rowOf(*actions.begin());
    first.listedWords = words;
    for (const QAction* action : actions) {
        if (action == first.action)
            continue;
        first.listedWith.push_back(action);
        rowOf(action).isListed = false;
    }
}

void ActionTable::listWithoutKey(const QAction* action, const ActionWords& keyWords)
{
    rowOf(action).keyWords = keyWords;
}

void ActionTable::setToolTip(const QAction* action, const ActionWords& tip)
{
    ActionRow& row = rowOf(action);
    row.toolTip = tip;
    setText(row);
}

void ActionTable::setState(const QAction* action, std::function<QString()> state, bool inMenu)
{
    ActionRow& row = rowOf(action);
    row.state = std::move(state);
    row.showsStateInMenu = inMenu;
    setText(row);
}

QAction* ActionTable::action(QAnyStringView id) const
{
    const auto row = std::ranges::find_if(m_rows, [id](const ActionRow& r) { return QAnyStringView(r.id) == id; });
    return row == m_rows.end() ? nullptr : row->action;
}

QString ActionTable::stateOf(const ActionRow& row) const
{
    if (row.state)
        return row.state();
    if (!row.action || !row.action->isCheckable())
        return {};
    return row.action->isChecked() ? tr("on") : tr("off");
}

QString ActionTable::pathOf(const ActionRow& row)
{
    QStringList parts;
    for (const ActionWords& menu : row.path)
        parts << menu.text();
    return pathText(parts << row.words.text());
}

QString ActionTable::pathInOther(const ActionRow& row) const
{
    QStringList parts;
    for (const ActionWords& menu : row.path)
        parts << menu.inOther(m_language);
    return pathText(parts << row.words.inOther(m_language));
}

QString ActionTable::keysOf(const ActionRow& row, QKeySequence::SequenceFormat format)
{
    return row.action ? joined(row.action->shortcuts(), format) : QString();
}

std::vector<KeySection> ActionTable::sections(QKeySequence::SequenceFormat format) const
{
    std::vector<KeySection> sections;
    for (const SectionRow& row : kSections)
        sections.push_back({tr(row.title), {}});
    for (const ActionRow& row : m_rows) {
        QList<QKeySequence> keys = row.action ? row.action->shortcuts() : QList<QKeySequence>();
        for (const QAction* other : row.listedWith)
            keys += other->shortcuts();
        const QString shown = row.keyWords.isEmpty() ? joined(keys, format) : row.keyWords.text();
        if (!row.isListed || shown.isEmpty())
            continue;
        QString what = withoutMnemonic((row.listedWords.isEmpty() ? row.words : row.listedWords).text());
        what.remove(QChar(0x2026)); // the dots of a menu announce a dialog
        sections[static_cast<std::size_t>(row.section)].lines.push_back({shown, what, stateOf(row)});
    }
    return sections;
}

QString ActionTable::markdown() const
{
    QString text = QStringLiteral("| %1 | %2 | %3 |\n|---|---|---|\n").arg(tr("section"), tr("key"), tr("what"));
    for (const KeySection& section : sections(QKeySequence::PortableText))
        for (const KeyLine& line : section.lines)
            text += QStringLiteral("| %1 | %2 | %3 |\n")
                        .arg(escaped(section.title), escaped(line.keys), escaped(line.what));
    return text;
}

QStringList ActionTable::conflicts() const
{
    QStringList found;
    QHash<QString, int> ids;
    QHash<QKeySequence, std::vector<const ActionRow*>> users;
    for (const ActionRow& row : m_rows) {
        if (ids[row.id]++ == 1)
            found << QStringLiteral("two rows are called %1").arg(row.id);
        if (!row.action)
            continue;
        for (const QKeySequence& key : row.action->shortcuts()) {
            for (const ActionRow* other : users[key])
                if (hearTheSameKeys(*row.action, *other->action))
                    found << QStringLiteral("%1 and %2 have the key %3").arg(other->id, row.id, key.toString());
            users[key].push_back(&row);
        }
    }
    return found;
}

void ActionTable::setText(const ActionRow& row)
{
    if (!row.action)
        return;
    const QString text = row.words.text();
    row.action->setText(row.showsStateInMenu ? QStringLiteral("%1: %2").arg(text, row.state()) : text);
    if (!row.toolTip.isEmpty())
        row.action->setToolTip(row.toolTip.text());
}

void ActionTable::retranslate()
{
    for (const auto& [menu, title] : m_menus)
        menu->setTitle(title.text());
    for (const ActionRow& row : m_rows)
        setText(row);
}

void ActionTable::syncStates()
{
    for (const ActionRow& row : m_rows)
        if (row.showsStateInMenu)
            setText(row);
}

ActionMenu::ActionMenu(ActionTable& table, QMenu* menu, QObject& owner, ActionSection section, const char* title)
    : m_table(&table), m_menu(menu), m_owner(&owner), m_section(section), m_path{words(title)}
{
    table.addMenu(menu, m_path.front());
}

void ActionMenu::take(QAnyStringView id, const ActionWords& words, const QList<QKeySequence>& keys, QAction* action)
{
    m_table->add(m_menu, {id.toString(), m_section, words, m_path, action}, keys);
}

ActionMenu ActionMenu::addMenu(const ActionWords& title)
{
    ActionMenu inner = *this;
    inner.m_menu = m_menu->addMenu(QString());
    inner.m_path.push_back(title);
    m_table->addMenu(inner.m_menu, title);
    return inner;
}

void ActionMenu::addSeparator() { m_menu->addSeparator(); }

ActionMenu ActionMenu::in(ActionSection section) const
{
    ActionMenu other = *this;
    other.m_section = section;
    return other;
}

} // namespace rasterlens
