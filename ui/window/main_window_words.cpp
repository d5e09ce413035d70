// What the window says in words: the title, the caption of the presentation, the line above the canvas and the
// read-out.
#include "core/settings/mistakes.h"
#include "core/settings/numbers_field.h"
#include "ui/base/applicability.h"
#include "ui/base/step_words.h"
#include "ui/lessons/lesson_mode.h"
#include "ui/pipeline/scene_words.h"
#include "ui/steps/step_mode.h"
#include "ui/steps/step_sentence.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/main_window.h"
#include "ui/window/readout_bar.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QLabel>

#include <utility>

namespace rasterlens
{
namespace
{

QString zoomText(double zoom)
{
    return zoom >= 1 ? QStringLiteral("%1\u00d7").arg(zoom) : QStringLiteral("%1 %").arg(zoom * 100, 0, 'f', 0);
}

} // namespace

/// However often a change asks for it, the words are made once, before the window is painted.
void MainWindow::syncSoon(Words which)
{
    const bool isUnderWay = m_wordsAreOld.any();
    m_wordsAreOld.set(static_cast<std::size_t>(which));
    if (!isUnderWay) // what is queued comes before painting, which has a lower priority
        QMetaObject::invokeMethod(this, &MainWindow::syncWords, Qt::QueuedConnection);
}

void MainWindow::syncWords()
{
    const auto old = std::exchange(m_wordsAreOld, {});
    if (old.test(static_cast<std::size_t>(Words::OfPixel)))
        syncReadout();
    if (old.test(static_cast<std::size_t>(Words::OfDocument))) {
        syncTitle();
        syncCaption();
    }
}

void MainWindow::syncCanvasHeader()
{
    QStringList parts{zoomText(m_viewport->transform().zoom)};
    if (const auto pixel = m_viewport->selectedPixel())
        parts << tr("pixel (%1, %2)").arg(pixel->x()).arg(pixel->y());
    m_canvasTitle->setText(parts.join(QStringLiteral("  \u00b7  ")));
}

void MainWindow::syncReadout()
{
    syncCanvasHeader();
    const auto at = m_viewport->hoveredPixel() ? m_viewport->hoveredPixel() : m_viewport->selectedPixel();
    if (at && (m_viewport->isAnswering() || at == m_lessons->player().askedPixel())) {
        m_readout->showPlace(*at);
        return;
    }
    const auto moment = m_stepMode->moment();
    m_readout->show(at ? m_viewport->readout(*at) : std::nullopt,
                    at && !moment ? m_truth->comparison().at(*at) : std::nullopt, moment);
}

/// What was changed about the scene, or else what there is to see.
QString MainWindow::sceneWords() const
{
    QStringList changes;
    for (const SettingsField& field : settingsFields())
        if (field.get(m_document.settings()) != field.get(m_document.defaults()))
            changes << QStringLiteral("%1: %2").arg(QCoreApplication::translate("Settings", field.title),
                                                    valueTitle(field, m_document.settings()));
    for (const NumbersField& field : numbersFields())
        if (!isEqual(field, m_document.settings(), m_document.defaults()))
            changes << QStringLiteral("%1: %2").arg(QCoreApplication::translate("Settings", field.title),
                                                    valueText(field, m_document.settings()));
    if (m_document.settings().light != m_document.defaults().light)
        changes << tr("towards the light: %1").arg(lightText(m_document.settings().light));
    std::vector<const Mistake*> mistakes;
    for (const QString& id : m_document.settings().mistakes)
        mistakes.push_back(findMistake(id));
    if (!mistakes.empty())
        changes << becauseWords(mistakes);
    return changes.isEmpty() ? sceneNote(*m_document.scene()) : changes.join(QStringLiteral(" \u00b7 "));
}

/// The caption of the presentation: one sentence about the step, or else about the scene and what was changed about it.
void MainWindow::syncCaption()
{
    if (!m_caption->isHidden())
        m_caption->setText(stageText());
}

QString MainWindow::stageText() const
{
    const StepSession& session = m_stepMode->session();
    if (session.log() && session.position() > 0)
        return stepSentence(*session.log(), session.positionInLog() - 1).toHtmlEscaped();
    return QStringLiteral("<b>%1</b> &nbsp; %2")
        .arg(sceneTitle(*m_document.scene()).toHtmlEscaped(), sceneWords().toHtmlEscaped());
}

void MainWindow::syncTitle()
{
    QString title = sceneTitle(*m_document.scene());
    if (!m_document.sessionPath().isEmpty())
        title += QStringLiteral(" \u2013 ") + QFileInfo(m_document.sessionPath()).fileName();
    setWindowTitle(
        QStringLiteral("%1[*] \u2013 RasterLens").arg(title.replace(QLatin1String("[*]"), QLatin1String("[*][*]"))));
}

} // namespace rasterlens
