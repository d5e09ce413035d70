#pragma once
#include <QDockWidget>

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace rasterlens
{

/// A dock that looks like a card: a bold title with links at its right, and the panel below. Drag the title to move it,
/// double-click it to float it, close it with the cross.
class Dock : public QDockWidget
{
    Q_OBJECT

public:
    enum class Fit { Shrinks, Scrolls }; ///< a panel where it has not the room it needs

    Dock(const QString& id, QWidget* panel, QWidget* parent, Fit fit = Fit::Shrinks);

    void setTitle(const QString& title);
    /// A link between title and cross.
    QToolButton* addLink();
    /// Open, and not a tab behind another: what it shows can be seen.
    [[nodiscard]] bool isInSight() const;

Q_SIGNALS:
    void sightChanged(bool inSight);

protected:
    bool event(QEvent* event) override;

private:
    QToolButton* insertLink(int index);

    QLabel* m_title = nullptr;
    QHBoxLayout* m_titleRow = nullptr;
    QToolButton* m_close = nullptr;
    bool m_wasInSight = false; ///< as sightChanged() told
};

} // namespace rasterlens
