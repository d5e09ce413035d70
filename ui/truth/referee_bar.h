#pragma once
#include "ui/truth/referee.h"

#include <QFrame>

class QLabel;
class QToolButton;

namespace rasterlens
{

/// The line above the canvas that says what the referee found, with the signs it uses on the canvas.
class RefereeBar : public QFrame
{
    Q_OBJECT

public:
    explicit RefereeBar(Referee& referee, QWidget* parent = nullptr);

    /// Says where the truth starts, and changes it.
    [[nodiscard]] QToolButton& spaceButton() { return *m_space; }
    /// Without the second line.
    void setBrief(bool brief);

Q_SIGNALS:
    void nextRequested(); ///< the next wrong pixel is to be shown

protected:
    void changeEvent(QEvent* event) override;

private:
    void sync();
    void syncSpace();
    [[nodiscard]] QString richText() const;

    Referee& m_referee;
    bool m_brief = false;
    QLabel* m_title;
    QLabel* m_text;
    QToolButton* m_space;
    QToolButton* m_next;
    QToolButton* m_close;
    QLabel* m_detail;
};

} // namespace rasterlens
