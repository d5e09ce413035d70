#include "ui/window/panel_places.h"

#include "ui/base/bring_to_front.h"

#include <QAction>
#include <QDockWidget>
#include <QEvent>
#include <QFontInfo>
#include <QLayout>
#include <QMainWindow>
#include <QTimer>

#include <algorithm>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr int kNarrowBelow = 900; ///< width of the window from which on three columns have room
constexpr int kSceneWidth = 298;
constexpr int kStatisticsWidth = 272;
constexpr int kTabWidth = 440;       ///< of a panel beside the canvas
constexpr double kCanvasShare = 0.4; ///< of the window's width that a panel beside the canvas leaves to it
constexpr double kStageShare = 0.52; ///< of a wide stage's
constexpr int kWideStage = 1200;
constexpr int kUsualType = 13;    ///< pixels; larger type takes wider panels
constexpr int kLowestPanel = 130; ///< a lower panel below the canvas shows nothing of use
constexpr int kMost = QWIDGETSIZE_MAX;

/// What the menu and the help call a panel, and the key that opens it with Alt: no menu and no other action has these
/// keys.
struct PanelRow {
    QLatin1String dock; ///< its name as an object
    const char* id;
    const char* title;
    Qt::Key key; ///< a digit, as long as there are digits left
};

constexpr PanelRow kPanels[] = {
    {QLatin1String("pipelineDock"), "panel.scene", QT_TRANSLATE_NOOP("rasterlens::PanelPlaces", "Scene and pipeline"),
     Qt::Key_1},
    {QLatin1String("statisticsDock"), "panel.statistics", QT_TRANSLATE_NOOP("rasterlens::PanelPlaces", "Statistics"),
     Qt::Key_2},
    {QLatin1String("whyDock"), "panel.why", QT_TRANSLATE_NOOP("rasterlens::PanelPlaces", "Pixel card: why this pixel?"),
     Qt::Key_3},
    {QLatin1String("verticesDock"), "panel.vertices", QT_TRANSLATE_NOOP("rasterlens::PanelPlaces", "Vertices"),
     Qt::Key_4},
    {QLatin1String("clipDock"), "panel.clip", QT_TRANSLATE_NOOP("rasterlens::PanelPlaces", "Clip theatre"), Qt::Key_5},
    {QLatin1String("curvesDock"), "panel.curves", QT_TRANSLATE_NOOP("rasterlens::PanelPlaces", "Curves"), Qt::Key_6},
    {QLatin1String("raceDock"), "panel.race", QT_TRANSLATE_NOOP("rasterlens::PanelPlaces", "Algorithm race"),
     Qt::Key_7},
    {QLatin1String("deriveDock"), "panel.derive", QT_TRANSLATE_NOOP("rasterlens::PanelPlaces", "Derivations"),
     Qt::Key_D},
    {QLatin1String("casesDock"), "panel.cases", QT_TRANSLATE_NOOP("rasterlens::PanelPlaces", "Hard cases"), Qt::Key_8},
    {QLatin1String("experimentDock"), "panel.experiment",
     QT_TRANSLATE_NOOP("rasterlens::PanelPlaces", "Speed against error"), Qt::Key_9},
    {QLatin1String("chartsDock"), "panel.charts", QT_TRANSLATE_NOOP("rasterlens::PanelPlaces", "Charts of errors"),
     Qt::Key_G},
    {QLatin1String("identifyDock"), "panel.identify",
     QT_TRANSLATE_NOOP("rasterlens::PanelPlaces", "Which mistake is mine?"), Qt::Key_I},
    {QLatin1String("lessonDock"), "panel.lesson", QT_TRANSLATE_NOOP("rasterlens::PanelPlaces", "Lesson"), Qt::Key_L},
    {QLatin1String("transportDock"), "panel.steps", QT_TRANSLATE_NOOP("rasterlens::PanelPlaces", "Steps"), Qt::Key_0},
};

} // namespace

PanelPlaces::PanelPlaces(QMainWindow& window, QWidget& canvas, const Columns& columns, const QList<QDockWidget*>& tabs)
    : QObject(&window), m_window(window), m_canvas(canvas), m_columns(columns), m_tabs(tabs)
{
    window.installEventFilter(this);
    canvas.installEventFilter(this);
    for (QDockWidget* dock : tabs)
        dock->hide();
    columns.lesson->hide();
    for (QDockWidget* dock :
         QList<QDockWidget*>{columns.scene, columns.lesson, columns.statistics, columns.card} + tabs)
        watch(dock);
    arrange();
}

void PanelPlaces::watch(QDockWidget* dock)
{
    connect(dock, &QDockWidget::visibilityChanged, this, [this, dock] { visibilityChanged(dock); });
    connect(dock, &QDockWidget::dockLocationChanged, this, [this] { limit(); });
    connect(dock, &QDockWidget::topLevelChanged, this, [this, dock] {
        m_arranged = m_arranged || !m_quiet;
        dock->setMaximumHeight(kMost);
        limit();
    });
}

void PanelPlaces::buildMenu(ActionMenu menu)
{
    const auto words = [this](const char* english) { return ActionWords{metaObject()->className(), english}; };
    QList<QDockWidget*> docks{m_columns.scene, m_columns.lesson, m_columns.statistics, m_columns.card};
    docks += m_tabs;
    for (const PanelRow& row : kPanels) {
        const QList<QKeySequence> keys{Qt::ALT | row.key};
        if (row.dock == m_columns.transport->objectName()) {
            menu.take(row.id, words(row.title), keys, m_columns.transport->toggleViewAction());
            continue;
        }
        const auto dock =
            std::ranges::find_if(docks, [&](const QDockWidget* d) { return d->objectName() == row.dock; });
        Q_ASSERT(dock != docks.end());
        QAction* action = menu.add(row.id, words(row.title), keys, [this, dock = *dock] { toggle(dock); });
        action->setCheckable(true);
        m_actions.emplace_back(action, *dock);
    }
    Q_ASSERT(m_actions.size() == static_cast<std::size_t>(docks.size())); // each panel has a row
    menu.addSeparator();
    m_bottom = menu.add("panel.tabs-below", words(QT_TR_NOOP("Tabs &below the canvas")), {},
                        [this](bool on) { setTabsAtBottom(on); });
    m_bottom->setCheckable(true);
    syncActions();
}

bool PanelPlaces::isNarrow() const { return m_window.width() < kNarrowBelow; }

void PanelPlaces::arrange()
{
    quietly([this] {
        // The layout is asked once all docks have their places: on the way some lie one below the other, and the window
        // would grow for them.
        m_window.layout()->setEnabled(false);
        noteOpen();
        m_narrow = isNarrow();
        m_window.addDockWidget(Qt::LeftDockWidgetArea, m_columns.scene);
        m_window.tabifyDockWidget(m_columns.scene, m_columns.lesson);
        if (m_narrow) {
            m_window.addDockWidget(Qt::LeftDockWidgetArea, m_columns.statistics);
            m_window.tabifyDockWidget(m_columns.lesson, m_columns.statistics);
            m_window.tabifyDockWidget(m_columns.statistics, m_columns.card);
        } else {
            m_window.addDockWidget(Qt::RightDockWidgetArea, m_columns.card);
            m_window.addDockWidget(Qt::RightDockWidgetArea, m_columns.statistics);
            m_window.splitDockWidget(m_columns.card, m_columns.statistics, Qt::Vertical);
        }
        placeTabs();
        QDockWidget* front = m_columns.lesson->isHidden() ? m_columns.scene : m_columns.lesson;
        for (QDockWidget* dock : std::as_const(m_tabs))
            if (m_open.contains(dock))
                front = dock;
        front->raise();
        m_window.layout()->setEnabled(true);
        m_window.layout()->activate();
    });
}

void PanelPlaces::placeTabs()
{
    QDockWidget* former = m_columns.card;
    for (QDockWidget* dock : std::as_const(m_tabs)) {
        dock->setMaximumHeight(kMost);
        if (m_atBottom) {
            m_window.addDockWidget(Qt::BottomDockWidgetArea, dock);
            if (former == m_columns.card)
                m_window.splitDockWidget(dock, m_columns.transport, Qt::Vertical);
            else
                m_window.tabifyDockWidget(former, dock);
        } else {
            m_window.tabifyDockWidget(former, dock);
        }
        former = dock;
    }
}

void PanelPlaces::follow()
{
    if (m_arranged)
        return;
    noteOpen();
    const QDockWidget* tab = openTab();
    if (m_narrow != isNarrow() || (areStatisticsTab() && (!tab || hasRoomForStatistics(tab))))
        arrange();
    sizeColumns();
}

/// The panel that is open beside the pixel card; null: none.
QDockWidget* PanelPlaces::openTab() const
{
    const auto isOpen = [this](const QDockWidget* dock) { return m_open.contains(dock) && !dock->isFloating(); };
    const auto tab = std::ranges::find_if(m_tabs, isOpen);
    return m_atBottom || tab == m_tabs.end() ? nullptr : *tab;
}

/// In a wide window, whose statistics have a place of their own.
bool PanelPlaces::areStatisticsTab() const
{
    return !m_narrow && m_window.tabifiedDockWidgets(m_columns.card).contains(m_columns.statistics);
}

/// Whether the column is so high that a panel has the height it asks for and the statistics what they need.
bool PanelPlaces::hasRoomForStatistics(const QDockWidget* dock) const
{
    return m_canvas.height() >= dock->sizeHint().height() + m_columns.statistics->minimumSizeHint().height();
}

/// A tab behind another one, as the scene behind a lesson, keeps the width that it had before.
int PanelPlaces::widthOfSceneColumn() const
{
    if (!m_arranged)
        return std::min(kSceneWidth, m_window.width() / 4);
    for (const QDockWidget* tab : m_window.tabifiedDockWidgets(m_columns.scene))
        if (isInSight(tab))
            return tab->width();
    return m_columns.scene->width();
}

void PanelPlaces::sizeColumns()
{
    const int scene = std::min(kSceneWidth, m_window.width() / 4);
    if (QDockWidget* tab = openTab()) {
        if (!m_narrow)
            m_window.resizeDocks({m_columns.scene}, {scene}, Qt::Horizontal);
        makeRoom(tab);
        return;
    }
    if (m_narrow) {
        m_window.resizeDocks({m_columns.scene}, {kStatisticsWidth}, Qt::Horizontal);
        return;
    }
    m_window.resizeDocks({m_columns.scene, m_columns.statistics}, {scene, kStatisticsWidth}, Qt::Horizontal);
    const int column = m_columns.card->height() + m_columns.statistics->height();
    const int statistics = m_columns.statistics->sizeHint().height();
    m_window.resizeDocks({m_columns.card, m_columns.statistics}, {std::max(column - statistics, 1), statistics},
                         Qt::Vertical);
}

void PanelPlaces::restore(bool arranged, bool atBottom)
{
    m_arranged = arranged;
    m_narrow = isNarrow();
    if (!arranged) {
        setTabsAtBottom(atBottom);
        return;
    }
    m_atBottom = atBottom;
    m_bottom->setChecked(atBottom);
}

void PanelPlaces::setTabsAtBottom(bool bottom)
{
    m_atBottom = bottom;
    if (m_bottom)
        m_bottom->setChecked(bottom);
    arrange();
    sizeColumns();
    limit();
}

bool PanelPlaces::isInSight(const QDockWidget* dock) const
{
    if (!dock->isVisible())
        return false;
    return dock->isFloating() || m_window.rect().intersects(dock->geometry()); // a tab behind another lies outside
}

bool PanelPlaces::hasPanelBeside() const
{
    return std::ranges::any_of(m_actions, [this](const auto& row) {
        QDockWidget* dock = row.second;
        return !dock->isHidden() && !dock->isFloating() && m_window.dockWidgetArea(dock) != Qt::BottomDockWidgetArea;
    });
}

void PanelPlaces::toggle(QDockWidget* dock)
{
    if (isInSight(dock)) {
        dock->hide();
        return;
    }
    if (dock == m_columns.scene) {
        showScene();
        return;
    }
    bringToFront(*dock);
}

void PanelPlaces::revealCard()
{
    const bool isBehind = m_columns.card->isVisible() && !isInSight(m_columns.card);
    if (isBehind && (isInSight(m_columns.scene) || isInSight(m_columns.statistics)) && m_narrow)
        bringToFront(*m_columns.card);
}

void PanelPlaces::quietly(const std::function<void()>& change)
{
    const bool former = std::exchange(m_quiet, true);
    change();
    m_quiet = former;
    noteOpen();
    syncActions();
}

void PanelPlaces::noteOpen()
{
    m_open.clear();
    for (const QDockWidget* dock : std::as_const(m_tabs))
        if (!dock->isHidden())
            m_open.insert(dock);
}

void PanelPlaces::visibilityChanged(QDockWidget* dock)
{
    QTimer::singleShot(0, this, &PanelPlaces::syncActions); // once the layout knows
    if (m_isStage && dock == m_columns.card && !m_quiet && !dock->isHidden())
        QTimer::singleShot(0, dock, [this, dock] { makeRoom(dock); });
    if (m_quiet || !m_tabs.contains(dock) || !m_window.isVisible())
        return;
    const bool isOpen = !dock->isHidden();
    if (isOpen == m_open.contains(dock))
        return;
    noteOpen();
    QTimer::singleShot(0, dock, [this, dock, isOpen] {
        if (isOpen) {
            m_growing = dock;
            makeRoom(dock);
        } else if (m_open.isEmpty()) {
            follow();
        }
        limit();
    });
}

void PanelPlaces::showScene()
{
    bringToFront(*m_columns.scene);
    if (!m_isStage || m_columns.scene->isFloating())
        return;
    QTimer::singleShot(0, this, [this] { // once the layout knows
        const int most = static_cast<int>(m_window.width() * kCanvasShare);
        const int wanted = std::min(std::max(kSceneWidth, m_columns.scene->sizeHint().width()), most);
        if (m_columns.scene->width() < wanted)
            m_window.resizeDocks({m_columns.scene}, {wanted}, Qt::Horizontal);
    });
}

/// A panel that opens beside the canvas gets the width it needs, and no more than the canvas can spare.
void PanelPlaces::makeRoom(QDockWidget* dock)
{
    if (dock->isFloating() || dock->isHidden() || m_window.dockWidgetArea(dock) == Qt::BottomDockWidgetArea)
        return;
    const bool sharesColumn = m_window.dockWidgetArea(dock) == m_window.dockWidgetArea(m_columns.scene);
    const int other = sharesColumn || m_columns.scene->isHidden() ? 0 : widthOfSceneColumn();
    const double share = m_isStage && m_window.width() >= kWideStage ? kStageShare : kCanvasShare;
    const int spare = m_window.width() - other - static_cast<int>(m_window.width() * share);
    const int least = std::min(kTabWidth * QFontInfo(m_window.font()).pixelSize() / kUsualType, spare);
    const int width = std::clamp(dock->width(), least, std::max(least, spare));
    m_window.resizeDocks({dock}, {width}, Qt::Horizontal);
    if (m_narrow || m_columns.statistics->isHidden() || areStatisticsTab())
        return;
    if (m_arranged || hasRoomForStatistics(dock)) {
        m_window.resizeDocks({dock, m_columns.statistics}, {m_window.height(), 1}, Qt::Vertical);
        return;
    }
    const QList<QDockWidget*> beside = m_window.tabifiedDockWidgets(dock); // another may have come to the front since
    const auto front = std::ranges::find_if(beside, [this](const QDockWidget* one) { return isInSight(one); });
    quietly([this, dock = front == beside.end() ? dock : *front] {
        m_window.tabifyDockWidget(m_columns.card, m_columns.statistics);
        dock->raise();
    });
}

/// Panels below the canvas leave it half of the window's height; where that is not enough for them, they go beside it.
void PanelPlaces::limit()
{
    if (std::exchange(m_limitPending, true))
        return;
    QTimer::singleShot(0, this, [this] {
        m_limitPending = false;
        QList<QDockWidget*> below;
        int used = 0;
        QSet<int> rows;
        for (QDockWidget* dock : m_window.findChildren<QDockWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
            const bool isBelow = m_window.dockWidgetArea(dock) == Qt::BottomDockWidgetArea && !dock->isFloating();
            if (!isBelow || !isInSight(dock) || dock == m_columns.transport)
                continue;
            below << dock;
            if (!rows.contains(dock->y()))
                used += dock->height();
            rows << dock->y();
        }
        if (below.isEmpty() || !m_window.isVisible())
            return;
        const int least = (m_window.height() + 1) / 2;
        const int most = (m_canvas.height() + used - least) / static_cast<int>(rows.size());
        for (QDockWidget* dock : std::as_const(below)) {
            if (most >= kLowestPanel) {
                dock->setMaximumHeight(most);
                if (dock == m_growing)
                    m_window.resizeDocks({dock}, {std::min(most, dock->sizeHint().height())}, Qt::Vertical);
                continue;
            }
            quietly([this, dock] {
                dock->setMaximumHeight(kMost);
                m_window.tabifyDockWidget(m_columns.card, dock);
                dock->raise();
            });
            makeRoom(dock);
        }
        m_growing = nullptr;
    });
}

void PanelPlaces::syncActions()
{
    for (const auto& [action, dock] : m_actions)
        action->setChecked(isInSight(dock));
    Q_EMIT changed();
}

bool PanelPlaces::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::Resize)
        limit();
    return QObject::eventFilter(watched, event);
}

} // namespace rasterlens
