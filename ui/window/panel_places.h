#pragma once
#include "ui/base/action_table.h"

#include <QList>
#include <QObject>
#include <QSet>
#include <QString>

#include <functional>
#include <vector>

class QDockWidget;
class QMainWindow;

namespace rasterlens
{

/// Where the panels lie and which keys open them. Three have their columns: the scene, the statistics and the pixel
/// card. The others are tabs beside the pixel card, or below the canvas where the user wants them there, and then never
/// so high that the canvas has less than half of the window's height. The statistics lie below the card and its tabs,
/// or are one of the tabs while a panel is open that needs the height.
class PanelPlaces : public QObject
{
    Q_OBJECT

public:
    struct Columns {
        QDockWidget* scene;
        QDockWidget* lesson; ///< a tab beside the scene
        QDockWidget* statistics;
        QDockWidget* card;
        QDockWidget* transport; ///< always below everything
    };

    /// in  the tabs: the panels that share a place
    PanelPlaces(QMainWindow& window, QWidget& canvas, const Columns& columns, const QList<QDockWidget*>& tabs);

    /// Fills the menu.
    void buildMenu(ActionMenu menu);

    /// Puts every panel to its usual place: three columns, or one with tabs where the window is narrow.
    void arrange();
    /// The usual widths and heights of the columns.
    void sizeColumns();
    /// arrange() where the window has become narrow, or wide again; then sizeColumns().
    void follow();
    [[nodiscard]] bool isNarrow() const;

    /// After a restart: what areArranged() and areTabsAtBottom() said, once the window's state is restored.
    void restore(bool arranged, bool atBottom);
    void setTabsAtBottom(bool bottom);
    [[nodiscard]] bool areTabsAtBottom() const { return m_atBottom; }
    /// Whether the user has moved something.
    [[nodiscard]] bool areArranged() const { return m_arranged; }
    void setArranged(bool arranged) { m_arranged = arranged; }

    /// Opens a panel, or closes it where it is in sight.
    void toggle(QDockWidget* dock);
    /// Brings settings and mistakes to the front: on a stage, whose type is large, as wide as they need to be read.
    void showScene();
    /// Whether the window is a presentation.
    void setStage(bool on) { m_isStage = on; }
    /// Shows the pixel card where one of the other columns lies over it.
    void revealCard();
    [[nodiscard]] bool isInSight(const QDockWidget* dock) const;
    /// Whether a panel takes a part of the window's width from the canvas.
    [[nodiscard]] bool hasPanelBeside() const;
    /// Runs something that shows and hides panels without any of them being given new room.
    void quietly(const std::function<void()>& change);
    /// What opens a panel, with its key.
    [[nodiscard]] const std::vector<std::pair<QAction*, QDockWidget*>>& actions() const { return m_actions; }

Q_SIGNALS:
    void changed(); ///< perhaps: which panels are in sight

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void watch(QDockWidget* dock);
    void placeTabs();
    void noteOpen();
    void visibilityChanged(QDockWidget* dock);
    [[nodiscard]] int widthOfSceneColumn() const;
    void makeRoom(QDockWidget* dock);
    [[nodiscard]] QDockWidget* openTab() const;
    [[nodiscard]] bool areStatisticsTab() const;
    [[nodiscard]] bool hasRoomForStatistics(const QDockWidget* dock) const;
    void limit();
    void syncActions();

    QMainWindow& m_window;
    QWidget& m_canvas;
    Columns m_columns;
    QList<QDockWidget*> m_tabs;
    std::vector<std::pair<QAction*, QDockWidget*>> m_actions;
    QAction* m_bottom = nullptr;
    QSet<const QDockWidget*> m_open;
    const QDockWidget* m_growing = nullptr; ///< just opened below the canvas: gets the height it asks for
    bool m_isStage = false;
    bool m_narrow = false;
    bool m_atBottom = false;
    bool m_arranged = false;
    bool m_quiet = false;
    bool m_limitPending = false;
};

} // namespace rasterlens
