#pragma once
#include <QObject>

#include <vector>

class QWidget;

namespace rasterlens
{

/// Who has the keys. Tab goes through the window as the eye does, group after group, and the canvas gets the keys back
/// from a field that is left.
class FocusOrder : public QObject
{
    Q_OBJECT

public:
    /// in  the groups from first to last; a widget belongs to the first one that holds it
    FocusOrder(QWidget& window, QWidget& canvas, std::vector<QWidget*> groups);

    /// Moves the focus to the next widget or back.
    ///
    /// out  false where there is none
    bool move(bool forward);
    /// All that Tab comes to at present, in order.
    [[nodiscard]] std::vector<QWidget*> widgets() const;

private:
    [[nodiscard]] std::size_t groupOf(const QWidget* widget) const;
    [[nodiscard]] bool liesBehind(const QWidget& widget) const;

    QWidget& m_window;
    QWidget& m_canvas;
    std::vector<QWidget*> m_groups;
};

} // namespace rasterlens
