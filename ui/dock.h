#pragma once
#include <QDockWidget>

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace rasterlens
{

/// A dock that looks like a card: a bold title with links at its right, and the panel below. Drag the title to move it,
/// double-click it to float it.
class Dock : public QDockWidget
{
    Q_OBJECT

public:
    Dock(const QString& id, QWidget* panel, QWidget* parent);

    void setTitle(const QString& title);
    QToolButton* addLink();

private:
    QLabel* m_title = nullptr;
    QHBoxLayout* m_titleRow = nullptr;
};

} // namespace rasterlens
