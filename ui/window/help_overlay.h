#pragma once
#include "ui/base/action_table.h"

#include <QFrame>

#include <vector>

class QLabel;

namespace rasterlens
{

/// A card over the window that lists the keys with the state each of them changes, in two columns or, where the window
/// is low, in three.
class HelpOverlay : public QFrame
{
    Q_OBJECT

public:
    explicit HelpOverlay(QWidget* parent);

    void setSections(std::vector<KeySection> sections);
    void place();

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void fill(std::size_t columns);
    [[nodiscard]] bool fits(std::size_t columns);

    std::vector<KeySection> m_sections;
    std::vector<QLabel*> m_columns;
    std::size_t m_usedColumns = 0; ///< 0: the card was never laid out
};

} // namespace rasterlens
