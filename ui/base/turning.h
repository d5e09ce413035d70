#pragma once
#include <QObject>

#include <functional>
#include <optional>

class QWidget;

namespace rasterlens
{

/// Tells a panel whether its parts have room beside each other or are to lie one below the other. What counts is the
/// width of what holds the panel: the panel itself may be wider and scrolled.
class Turning : public QObject
{
    Q_OBJECT

public:
    /// in  widthBeside: from this width on the parts lie beside each other, in type of the usual size; larger type
    ///     takes as much more. turn: is called with true where they do
    Turning(QWidget* panel, int widthBeside, std::function<void(bool beside)> turn);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void judge();

    QWidget* m_panel;
    int m_widthBeside;
    std::function<void(bool)> m_turn;
    std::optional<bool> m_beside;
};

} // namespace rasterlens
