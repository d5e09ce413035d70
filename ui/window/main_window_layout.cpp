// Presentation, layout, and the counters that never leave the window.
#include "ui/base/dock.h"
#include "ui/pipeline/pipeline_panel.h"
#include "ui/pipeline/statistics_panel.h"
#include "ui/steps/step_mode.h"
#include "ui/steps/transport_dock.h"
#include "ui/window/main_window.h"
#include "ui/window/panel_places.h"
#include "ui/window/window_placement.h"

#include <QAction>
#include <QLabel>
#include <QLayout>
#include <QMenuBar>

namespace rasterlens
{

void MainWindow::setPresentation(bool on)
{
    if (on == m_look.presentation)
        return;
    constexpr int kGap = 7;
    if (on) {
        m_stateBeforePresentation = saveState(kLayoutVersion);
        m_panels->quietly([this] {
            for (Dock* dock : findChildren<Dock*>()) // before the type grows, and the window with it
                dock->hide();
        });
    }
    m_stepMode->transport().setBrief(on);
    Look look = m_look;
    look.presentation = on;
    setLook(look);
    menuBar()->setVisible(!on);
    centralWidget()->layout()->setContentsMargins(0, on ? kGap : 0, 0, 0);
    m_caption->setVisible(on);
    syncCaption();
    m_presentation->setChecked(on);
    if (on) {
        m_stepMode->transport().setVisible(m_stepMode->session().isOpen());
        m_placement->setFullScreen(true);
        m_viewport->setFocus();
    } else {
        m_panels->quietly([this] { restoreState(m_stateBeforePresentation, kLayoutVersion); });
        if (!m_fullScreen->isChecked())
            m_placement->setFullScreen(false);
    }
    syncCounters();
}

void MainWindow::resetLayout()
{
    setPresentation(false);
    m_panels->quietly([this] { restoreState(m_defaultState, kLayoutVersion); });
    m_panels->setArranged(false);
    m_panels->setTabsAtBottom(false);
    m_viewport->fit(m_document.scene()->window);
}

void MainWindow::syncCounters()
{
    m_counters->setVisible(!m_panels->isInSight(m_statisticsDock));
    if (!m_counters->isHidden())
        m_counters->setText(m_statisticsPanel->brief());
}

} // namespace rasterlens
