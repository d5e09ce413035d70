#pragma once
#include "ui/base/action_table.h"

#include <QFrame>

#include <vector>

class QLabel;

namespace rasterlens
{

/// A card over the window that lists the keys with the state each of them changes, in columns; on several pages where
/// the type would be too small on one.
class HelpOverlay : public QFrame
{
    Q_OBJECT

public:
    explicit HelpOverlay(QWidget* parent);

    void setSections(std::vector<KeySection> sections);
    /// Shows the page after the present one.
    ///
    /// out  false: it was the last
    bool turnPage();
    [[nodiscard]] std::size_t pages() const { return m_pages.size(); }

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    using Page = std::vector<QString>; ///< a text for each column

    /// How the sections are spread.
    struct Spread {
        std::size_t columns = 0; ///< 0: the card was never laid out
        std::size_t rows = 0;    ///< of a column; 0: all of them on one page
    };

    [[nodiscard]] std::vector<Page> spreadOnOne(std::size_t columns) const;
    [[nodiscard]] std::vector<Page> spreadOnSeveral(const Spread& spread) const;
    [[nodiscard]] bool fits(const Spread& spread);
    void setType(qreal points);
    [[nodiscard]] std::size_t rowsWithRoom() const;
    void choose();
    void showPage(std::size_t page);
    void place();

    std::vector<KeySection> m_sections;
    std::vector<QLabel*> m_columns;
    QLabel* m_footer;
    Spread m_spread;
    std::vector<Page> m_pages;
    std::size_t m_page = 0;
};

} // namespace rasterlens
