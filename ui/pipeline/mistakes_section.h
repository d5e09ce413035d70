#pragma once
#include "core/settings/mistakes.h"
#include "ui/base/action_table.h"
#include "ui/base/language.h"
#include "ui/document/document.h"

#include <QWidget>

#include <span>
#include <vector>

class QCheckBox;
class QLabel;
class QScrollArea;
class QToolButton;

namespace rasterlens
{

/// Switches one mistake on or off.
[[nodiscard]] Settings withMistake(const Settings& settings, const QString& id, bool on);
/// `M1 All edges are inclusive`, translated.
[[nodiscard]] QString mistakeTitle(const Mistake& mistake);
/// What is wrong, what one sees, why people write it; as rich text, the title in both languages.
[[nodiscard]] QString mistakeToolTip(const Mistake& mistake, const Language& language);

/// The section of the pipeline panel that lists all mistakes; folded until asked for.
class MistakesSection : public QWidget
{
    Q_OBJECT

public:
    MistakesSection(Document& document, const Language& language, QWidget* parent = nullptr);

    void setOpen(bool open);
    [[nodiscard]] bool isOpen() const;
    void setKeyHint(const QString& key);
    /// The switch of a mistake; makes the list if it was never opened.
    [[nodiscard]] QCheckBox* box(const QString& id);
    [[nodiscard]] QString heading() const;

Q_SIGNALS:
    void opened(bool open);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        const Mistake* mistake;
        QCheckBox* box;
        QLabel* title;
        QToolButton* show;
    };

    void makeRows();
    void sync();
    void retranslate();

    Document& m_document;
    const Language& m_language;
    QToolButton* m_heading = nullptr;
    QToolButton* m_clear = nullptr;
    QLabel* m_key = nullptr;
    QScrollArea* m_list = nullptr;
    std::vector<Row> m_rows;
};

/// Fills a menu with all mistakes, ten a submenu, and keeps their check marks.
class MistakesMenu : public QObject
{
    Q_OBJECT

public:
    MistakesMenu(Document& document, const Language& language, ActionMenu menu);

    void retranslate();

private:
    struct Entry {
        const Mistake* mistake;
        QAction* action;
    };

    void addRange(std::span<const Mistake> range, ActionMenu switches, ActionMenu demos);
    void sync();

    Document& m_document;
    const Language& m_language;
    QAction* m_none = nullptr;
    std::vector<Entry> m_switches;
    std::vector<Entry> m_demos;
};

} // namespace rasterlens
