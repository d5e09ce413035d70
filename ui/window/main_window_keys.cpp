// Where the keys go: Tab, Escape, the help, and the field for a pixel.
#include "core/base/typed_numbers.h"
#include "ui/base/dock.h"
#include "ui/base/message_bar.h"
#include "ui/base/typed_field.h"
#include "ui/face/cards.h"
#include "ui/lessons/lesson_mode.h"
#include "ui/pipeline/stage_strip.h"
#include "ui/steps/motion_mode.h"
#include "ui/steps/step_mode.h"
#include "ui/steps/transport_dock.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/focus_order.h"
#include "ui/window/help_overlay.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QLineEdit>
#include <QShortcut>
#include <QToolButton>

namespace rasterlens
{

void MainWindow::buildFocus()
{
    std::vector<QWidget*> groups{m_pipelineDock, &m_lessons->dock(), m_stageStrip, m_viewport, centralWidget()};
    for (const auto& docks : {m_cards->docks(), m_truth->docks()})
        groups.insert(groups.end(), docks.begin(), docks.end());
    groups.push_back(m_statisticsDock);
    groups.push_back(&m_stepMode->transport());
    m_focusOrder = new FocusOrder(*this, *m_viewport, std::move(groups));
    auto* escape = new QShortcut(Qt::Key_Escape, this);
    connect(escape, &QShortcut::activated, this, &MainWindow::leaveInnermost);
    connect(escape, &QShortcut::activatedAmbiguously, this, &MainWindow::leaveInnermost);
    connect(&m_actions, &ActionTable::changed, this, &MainWindow::syncHelp);
}

bool MainWindow::focusNextPrevChild(bool next) { return m_focusOrder->move(next); }

/// One press leaves one thing: what has the keys, the help, the presentation, the motion, the steps, the comparison,
/// the pixel.
void MainWindow::leaveInnermost()
{
    QWidget* focused = focusWidget();
    if (focused && focused != m_viewport && focused->hasFocus())
        m_viewport->setFocus(Qt::OtherFocusReason);
    else if (m_help->isVisible())
        m_help->hide();
    else if (m_look.presentation)
        setPresentation(false);
    else if (m_motion->motion())
        m_motion->stop();
    else if (m_stepMode->session().isOpen())
        m_stepMode->session().close();
    else if (m_truth->comparison().view() != CompareView::Off)
        m_truth->comparison().setView(CompareView::Off);
    else
        m_viewport->selectPixel(std::nullopt);
}

void MainWindow::toggleHelp()
{
    if (m_help->isVisible() && m_help->turnPage())
        return;
    m_help->setVisible(!m_help->isVisible());
    syncHelp();
}

/// The help shows the present states of the table's actions.
void MainWindow::syncHelp()
{
    if (m_help->isVisible())
        m_help->setSections(m_actions.sections(QKeySequence::NativeText));
}

void MainWindow::toggleGoToPixel() { showGoToPixel(m_goToEdit->isHidden()); }

void MainWindow::showGoToPixel(bool on)
{
    m_goToEdit->setVisible(on);
    m_goToButton->setVisible(!on && !m_look.presentation);
    if (!on) {
        m_viewport->setFocus();
        return;
    }
    m_goToEdit->selectAll();
    m_goToEdit->setFocus(Qt::ShortcutFocusReason);
}

/// in   go: not only judge the text, but show that pixel
/// out  why the text is no pixel; nothing where it is one
std::optional<QString> MainWindow::goToTyped(const QString& text, bool go)
{
    const auto pixel = typedPoint(text);
    const QSize size = m_document.settings().size;
    if (!pixel || !QRect(QPoint(0, 0), size).contains(*pixel))
        return tr("\"%1\" is no pixel of the picture. Write x, y with 0 to %2 and 0 to %3.")
            .arg(text)
            .arg(size.width() - 1)
            .arg(size.height() - 1);
    if (go) {
        m_goToField->setValue(text);
        m_viewport->goToPixel(*pixel);
    }
    return std::nullopt;
}

} // namespace rasterlens
