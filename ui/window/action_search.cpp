#include "ui/window/action_search.h"

#include "ui/base/action_table.h"

#include <QAbstractTableModel>
#include <QApplication>
#include <QFocusEvent>
#include <QGraphicsDropShadowEffect>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <numeric>

namespace rasterlens
{

/// The actions of the table: name with its menus, state, keys.
class ActionModel : public QAbstractTableModel
{
public:
    enum Column { Name, State, Keys, kColumns };
    enum Role { SearchText = Qt::UserRole, OwnText };

    ActionModel(const ActionTable& table, QObject* parent) : QAbstractTableModel(parent), m_table(table) {}

    /// Takes over which actions there are.
    void reload()
    {
        beginResetModel();
        m_rows.clear();
        for (const ActionRow& row : m_table.rows())
            if (row.action && row.action->isVisible())
                m_rows.push_back(&row);
        endResetModel();
    }
    /// Asks for texts and states anew.
    void refresh()
    {
        if (!m_rows.empty())
            Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, kColumns - 1));
    }

    [[nodiscard]] QAction* action(const QModelIndex& index) const { return rowAt(index).action; }

    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override
    {
        return parent.isValid() ? 0 : static_cast<int>(m_rows.size());
    }
    [[nodiscard]] int columnCount(const QModelIndex& = {}) const override { return kColumns; }
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override
    {
        const Qt::ItemFlags flags = QAbstractTableModel::flags(index);
        return rowAt(index).action->isEnabled() ? flags : flags & ~Qt::ItemIsEnabled;
    }
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override
    {
        const ActionRow& row = rowAt(index);
        switch (role) {
        case SearchText: return QString(ActionTable::pathOf(row) + QLatin1Char('\n') + m_table.pathInOther(row));
        case OwnText: return withoutMnemonic(row.words.text());
        case Qt::DisplayRole:
        case Qt::ToolTipRole: return text(row, index.column());
        case Qt::TextAlignmentRole:
            return int(Qt::AlignVCenter | (index.column() == Name ? Qt::AlignLeft : Qt::AlignRight));
        default: return {};
        }
    }

private:
    [[nodiscard]] const ActionRow& rowAt(const QModelIndex& index) const
    {
        return *m_rows[static_cast<std::size_t>(index.row())];
    }
    [[nodiscard]] QString text(const ActionRow& row, int column) const
    {
        if (column == Name)
            return ActionTable::pathOf(row);
        return column == State ? m_table.stateOf(row) : ActionTable::keysOf(row, QKeySequence::NativeText);
    }

    const ActionTable& m_table;
    std::vector<const ActionRow*> m_rows; ///< the table does not grow once the window stands
};

/// Shows the actions whose texts have all typed words; first the actions whose own name begins with what is typed.
class ActionFilter : public QSortFilterProxyModel
{
public:
    explicit ActionFilter(QObject* parent) : QSortFilterProxyModel(parent) { setDynamicSortFilter(true); }

    void setTyped(const QString& typed)
    {
        m_typed = typed.simplified();
        invalidate();
        sort(0);
    }

protected:
    [[nodiscard]] bool filterAcceptsRow(int row, const QModelIndex& parent) const override
    {
        const QString text = sourceModel()->index(row, 0, parent).data(ActionModel::SearchText).toString();
        return std::ranges::all_of(m_typed.split(QLatin1Char(' '), Qt::SkipEmptyParts),
                                   [&text](const QString& word) { return text.contains(word, Qt::CaseInsensitive); });
    }
    [[nodiscard]] bool lessThan(const QModelIndex& left, const QModelIndex& right) const override
    {
        const bool first = beginsAsTyped(left);
        return first == beginsAsTyped(right) ? left.row() < right.row() : first;
    }

private:
    [[nodiscard]] bool beginsAsTyped(const QModelIndex& index) const
    {
        return index.data(ActionModel::OwnText).toString().startsWith(m_typed, Qt::CaseInsensitive);
    }

    QString m_typed;
};

ActionSearch::ActionSearch(const ActionTable& table, QWidget& window)
    : QFrame(&window), m_edit(new QLineEdit), m_view(new QTreeView), m_model(new ActionModel(table, this)),
      m_filter(new ActionFilter(this))
{
    setObjectName(QStringLiteral("card"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 10, 10, 10);
    column->addWidget(m_edit);
    column->addWidget(m_view);
    m_edit->setObjectName(QStringLiteral("actionSearch"));
    m_edit->setClearButtonEnabled(true);
    m_edit->installEventFilter(this);
    m_filter->setSourceModel(m_model);
    m_view->setModel(m_filter);
    m_view->setRootIsDecorated(false);
    m_view->setHeaderHidden(true);
    m_view->setUniformRowHeights(true);
    m_view->setFrameShape(NoFrame);
    m_view->setTextElideMode(Qt::ElideLeft); // in a narrow window the name stays, of its menus the last
    m_view->setFocusPolicy(Qt::NoFocus);     // the field keeps the keys
    m_view->setAllColumnsShowFocus(true);
    m_view->header()->setStretchLastSection(false);
    m_view->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_view->header()->setSectionResizeMode(ActionModel::Name, QHeaderView::Stretch);
    auto* shadow = new QGraphicsDropShadowEffect(this);
    shadow->setBlurRadius(32);
    shadow->setOffset(0, 6);
    shadow->setColor(QColor(0, 0, 0, 110));
    setGraphicsEffect(shadow);
    window.installEventFilter(this);
    connect(m_edit, &QLineEdit::textChanged, this, [this](const QString& text) {
        m_filter->setTyped(text);
        chooseFirst();
    });
    connect(m_view, &QTreeView::clicked, this, &ActionSearch::run);
    connect(&table, &ActionTable::changed, this, [this] {
        if (isVisible())
            m_model->refresh();
    });
    hide();
}

void ActionSearch::toggle()
{
    if (isVisible())
        leave();
    else
        open();
}

void ActionSearch::open()
{
    m_former = QApplication::focusWidget();
    m_edit->setPlaceholderText(tr("Search for an action, in English or Chinese"));
    m_edit->setAccessibleName(m_edit->placeholderText());
    m_model->reload();
    m_edit->clear();
    m_filter->setTyped({});
    place();
    show();
    raise();
    m_edit->setFocus(Qt::ShortcutFocusReason);
    chooseFirst();
}

/// Gives the keys back to what had them.
void ActionSearch::leave()
{
    if (m_edit->hasFocus() && m_former)
        m_former->setFocus(Qt::OtherFocusReason);
    hide();
}

/// The width in which no name, state or key is cut.
int ActionSearch::widthOfTexts() const
{
    constexpr int kAround = 80; // margins of the cells, scroll bar, margins of the card
    std::array<int, ActionModel::kColumns> widths{};
    for (int row = 0; row < m_model->rowCount(); ++row)
        for (int column = 0; column < ActionModel::kColumns; ++column) {
            const QString text = m_model->index(row, column).data().toString();
            int& width = widths[static_cast<std::size_t>(column)];
            width = std::max(width, m_view->fontMetrics().horizontalAdvance(text));
        }
    return std::accumulate(widths.begin(), widths.end(), kAround);
}

void ActionSearch::place()
{
    constexpr int kLines = 20;
    constexpr int kEdge = 24; // to the edges of the window
    const QSize wanted(widthOfTexts(), kLines * fontMetrics().lineSpacing() * 5 / 4);
    resize(wanted.boundedTo(parentWidget()->size() - QSize(2 * kEdge, 2 * kEdge)));
    move((parentWidget()->width() - width()) / 2, (parentWidget()->height() - height()) / 4);
}

/// The first action that can be run.
void ActionSearch::chooseFirst()
{
    m_view->setCurrentIndex({});
    for (int row = 0; row < m_filter->rowCount(); ++row)
        if (const QModelIndex index = m_filter->index(row, 0); index.flags() & Qt::ItemIsEnabled) {
            m_view->setCurrentIndex(index);
            break;
        }
    m_view->scrollToTop();
}

void ActionSearch::run(const QModelIndex& index)
{
    if (!index.isValid() || !(index.flags() & Qt::ItemIsEnabled))
        return;
    QAction* action = m_model->action(m_filter->mapToSource(index));
    leave(); // the action may give the keys to a field
    action->trigger();
}

bool ActionSearch::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize && isVisible())
        place();
    if (watched != m_edit)
        return QFrame::eventFilter(watched, event);
    if (event->type() == QEvent::FocusOut && static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason)
        hide();
    if (event->type() != QEvent::KeyPress)
        return QFrame::eventFilter(watched, event);
    switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Up:
    case Qt::Key_Down:
    case Qt::Key_PageUp:
    case Qt::Key_PageDown: QCoreApplication::sendEvent(m_view, event); return true;
    case Qt::Key_Return:
    case Qt::Key_Enter: run(m_view->currentIndex()); return true;
    default: return QFrame::eventFilter(watched, event);
    }
}

} // namespace rasterlens
