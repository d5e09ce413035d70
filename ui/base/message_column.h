#pragma once
#include <QWidget>

#include <vector>

namespace rasterlens
{

class MessageBar;

/// Messages that lie over the lower edge of another widget, one below the other, so that no message moves anything.
/// The column is as wide as its longest text where there is room, and lets the mouse through beside it.
class MessageColumn : public QWidget
{
    Q_OBJECT

public:
    /// in  the widget to lie over, which becomes the parent
    explicit MessageColumn(QWidget* under);

    /// A new bar below the others, hidden until it shows a message.
    MessageBar* addBar();

protected:
    bool event(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void place();

    std::vector<MessageBar*> m_bars;
};

} // namespace rasterlens
