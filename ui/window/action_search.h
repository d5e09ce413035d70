#pragma once
#include <QFrame>
#include <QPointer>

class QLineEdit;
class QModelIndex;
class QTreeView;

namespace rasterlens
{

class ActionFilter;
class ActionModel;
class ActionTable;

/// A card over the window that finds actions by words of their names or menus, in either language, and runs one. Up and
/// Down choose, Enter runs and Escape leaves.
class ActionSearch : public QFrame
{
    Q_OBJECT

public:
    ActionSearch(const ActionTable& table, QWidget& window);

    /// Opens the card with an empty field, or puts it away.
    void toggle();

    [[nodiscard]] QLineEdit& edit() { return *m_edit; }
    [[nodiscard]] QTreeView& view() { return *m_view; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void open();
    void leave();
    [[nodiscard]] int widthOfTexts() const;
    void place();
    void chooseFirst();
    void run(const QModelIndex& index);

    QLineEdit* m_edit;
    QTreeView* m_view;
    ActionModel* m_model;
    ActionFilter* m_filter;
    QPointer<QWidget> m_former; ///< had the keys before
};

} // namespace rasterlens
