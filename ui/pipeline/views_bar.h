#pragma once
#include <QWidget>

#include <cstddef>
#include <vector>

class QAction;
class QMenu;
class QToolButton;

namespace rasterlens
{

class CanvasViews;

/// The views and overlays of the canvas on one line. With less room the overlays fold into a menu, then one view after
/// the other into a second menu, and at last both menus into one: what is folded depends on the width alone, so that
/// nothing moves while it is used.
class ViewsBar : public QWidget
{
    Q_OBJECT

public:
    /// What stands on the line.
    struct Form {
        bool overlaysOpen = false;
        bool oneMenu = false;
        std::size_t openViews = 0; ///< the others are in a menu

        friend bool operator==(const Form&, const Form&) = default;
    };

    /// in  `difference`: the action that shows how two pictures differ, which is a view as well
    ViewsBar(CanvasViews& views, QAction* difference, QWidget* parent = nullptr);

    [[nodiscard]] Form form() const { return m_form; }
    void retranslate();

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    [[nodiscard]] std::vector<Form> forms() const;
    [[nodiscard]] int widthOf(const Form& form) const;
    [[nodiscard]] int widthOf(const QToolButton* button) const;
    [[nodiscard]] std::vector<QToolButton*> buttonsOf(const Form& form) const;
    void sync();
    void arrange();

    CanvasViews& m_views;
    QAction* m_difference;
    std::vector<QToolButton*> m_viewButtons;
    std::vector<QToolButton*> m_overlayButtons;
    QMenu* m_viewMenu;
    QMenu* m_overlayMenu;
    QMenu* m_allMenu;
    QToolButton* m_viewFold;
    QToolButton* m_overlayFold;
    QToolButton* m_allFold;
    Form m_form;
};

} // namespace rasterlens
