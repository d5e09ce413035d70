// Presentation, layout, and the counters that never leave the window.
#include "ui/base/dock.h"
#include "ui/lessons/lesson_mode.h"
#include "ui/lessons/lesson_panel.h"
#include "ui/pipeline/pipeline_panel.h"
#include "ui/pipeline/stage_strip.h"
#include "ui/pipeline/statistics_panel.h"
#include "ui/steps/step_listing.h"
#include "ui/steps/step_mode.h"
#include "ui/steps/transport_dock.h"
#include "ui/truth/compare_bar.h"
#include "ui/truth/referee_bar.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/main_window.h"
#include "ui/window/panel_places.h"
#include "ui/window/window_placement.h"

#include <QAction>
#include <QBoxLayout>
#include <QLabel>
#include <QLayout>
#include <QMenuBar>
#include <QStatusBar>
#include <QToolButton>

#include <algorithm>

namespace rasterlens
{

namespace
{

constexpr int kCardGap = 7;  ///< between strip and canvas, outside of a presentation
constexpr int kCardEdge = 4; ///< above and below the line over the canvas

} // namespace

void MainWindow::setPresentation(bool on)
{
    if (on == m_look.presentation)
        return;
    constexpr int kGap = 3;
    m_counters->setMinimumWidth(0);
    m_counters->hide();
    m_counters->setEnabled(false); // until it is known whether there is room
    if (on) {
        m_stateBeforePresentation = saveState(kLayoutVersion);
        m_panels->quietly([this] {
            for (Dock* dock : findChildren<Dock*>()) // before the type grows, and the window with it
                dock->hide();
        });
    }
    m_panels->setStage(on);
    m_stepMode->transport().setBrief(on);
    m_stageStrip->setBrief(on);
    m_canvasTitle->setVisible(!on); // the views stay, the links are keys
    for (auto* link : m_canvasHeader->findChildren<QToolButton*>(Qt::FindDirectChildrenOnly))
        link->setVisible(!on);
    m_stageMenu->setVisible(on);
    statusBar()->setVisible(!on);
    if (on) // the status bar is out of sight, and so is the panel
        m_canvasHeader->layout()->addWidget(m_counters);
    else
        statusBar()->addPermanentWidget(m_counters);
    Look look = m_look;
    look.presentation = on;
    setLook(look);
    menuBar()->setVisible(!on);
    centralWidget()->layout()->setContentsMargins(0, on ? kGap : 0, 0, 0);
    centralWidget()->layout()->setSpacing(on ? kGap : kCardGap);
    QLayout* card = m_canvasHeader->parentWidget()->layout();
    card->setContentsMargins(1, on ? 1 : kCardEdge, 1, 1);
    card->setSpacing(on ? 1 : kCardEdge);
    m_lessons->setBar(on ? m_caption->parentWidget()->layout() : nullptr);
    syncStage();
    m_presentation->setChecked(on);
    if (on) {
        m_stepMode->transport().setVisible(m_stepMode->session().isOpen());
        syncTransport();
        m_placement->setFullScreen(true);
        m_viewport->setFocus();
    } else {
        m_panels->quietly([this] { restoreState(m_stateBeforePresentation, kLayoutVersion); });
        m_lessons->showDock();
        if (!m_fullScreen->isChecked())
            m_placement->setFullScreen(false);
    }
    m_counters->setEnabled(true);
    syncCounters();
}

/// The stage for a lecture: the picture first, one caption, and the step's formula where there is room for it.
void MainWindow::syncStage()
{
    if (!m_lessons || !m_caption) // while the window is being made
        return;
    constexpr double kWide = 1.5;        // width to height
    constexpr int kWideFrom = 1200;      // pixels
    constexpr double kBesideShare = 0.4; // of the width
    const bool isStage = m_look.presentation;
    const bool isWide = isStage && width() >= kWideFrom && width() >= kWide * height() && !m_panels->hasPanelBeside();
    StepListing& listing = m_stepMode->listing();
    const auto direction = isWide ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom;
    if (m_picture->direction() != direction)
        m_picture->setDirection(direction);
    listing.setMinimumWidth(isWide ? static_cast<int>(width() * kBesideShare) : 0);
    listing.setPlace(isWide    ? StepListing::Place::Beside
                     : isStage ? StepListing::Place::Line
                               : StepListing::Place::Below);
    const bool hasLesson = m_lessons->player().isOpen();
    listing.setVisible(m_stepMode->session().isOpen() && (isWide || !isStage || !hasLesson)); // the slide says it
    syncCompareBar();
    m_caption->setVisible(isStage && !hasLesson);
    if (isStage)
        m_lessons->panel().setVisible(hasLesson);
    // Two lines, whatever is said: the picture above is not to move from step to step.
    constexpr int kLines = 2;
    const QMargins around = m_caption->contentsMargins();
    m_caption->setMinimumHeight(kLines * m_caption->fontMetrics().lineSpacing() + around.top() + around.bottom());
    syncCaption();
}

/// On the stage the bar of the steps is shown in lessons that have steps, at all of their slides, since the buttons are
/// to stay where the mouse is, and while steps are recorded.
void MainWindow::syncTransport()
{
    const LessonPlayer& player = m_lessons->player();
    if (!m_look.presentation || !player.isOpen())
        return;
    const bool hasSteps = std::ranges::any_of(player.lesson().slides, [](const Slide& slide) {
        return slide.moment.step || (slide.before && slide.before->step);
    });
    m_stepMode->transport().setVisible(hasSteps || m_stepMode->session().isOpen());
}

/// The slide says what differs. On the stage the bars of comparison and referee take the place of the views, which stay
/// in the menu: the picture is not to move when an answer shows them.
void MainWindow::syncCompareBar()
{
    using enum CompareBar::Extent;
    CompareBar& bar = m_truth->compareBar();
    const bool hasLesson = m_lessons->player().isOpen();
    const bool isAlone = m_look.presentation && hasLesson;
    // The line of the referee takes its place; the menu has what it holds.
    bar.setExtent(isAlone && m_truth->referee().isOn() ? None
                  : isAlone                            ? Line
                  : m_look.presentation || hasLesson   ? Brief
                                                       : Full);
    const bool hasBar = m_truth->comparison().view() != CompareView::Off || m_truth->referee().isOn();
    m_canvasHeader->setVisible(!isAlone || !hasBar);
    RefereeBar& referee = m_truth->refereeBar();
    const int line = m_truth->referee().isOn() ? referee.sizeHint().height() : bar.sizeHint().height();
    const int height = isAlone ? std::max(line, m_canvasHeader->sizeHint().height()) : 0;
    for (QWidget* row : {static_cast<QWidget*>(&bar), static_cast<QWidget*>(&referee), m_canvasHeader})
        row->setMinimumHeight(height);
}

void MainWindow::resetLayout()
{
    setPresentation(false);
    m_panels->quietly([this] { restoreState(m_defaultState, kLayoutVersion); });
    m_panels->setArranged(false);
    m_panels->setTabsAtBottom(false);
    m_viewport->fit(m_document.scene()->window);
}

/// On the stage the counters stand in the row of the views, where no panel beside the canvas is to get narrower for
/// them.
void MainWindow::syncCounters()
{
    if (!m_counters->isEnabled()) // the stage is being set up, or left
        return;
    m_counters->setText(m_statisticsPanel->brief());
    const int wanted = m_counters->sizeHint().width();
    bool isInSight = !m_panels->isInSight(m_statisticsDock);
    if (m_look.presentation) {
        const int others = m_canvasHeader->layout()->minimumSize().width() - m_counters->minimumWidth();
        isInSight = isInSight && m_canvasHeader->width() >= others + wanted &&
                    std::ranges::none_of(m_panels->actions(),
                                         [this](const auto& panel) { return m_panels->isInSight(panel.second); });
    }
    m_counters->setVisible(isInSight);
    // The views are not to move with every digit.
    const bool keepsWidth = m_look.presentation && isInSight;
    m_counters->setMinimumWidth(keepsWidth ? std::max(m_counters->minimumWidth(), wanted) : 0);
}

} // namespace rasterlens
