// Files that the window opens, keeps and writes, and the names of those in its title.
#include "core/io/picture_file.h"
#include "core/io/picture_input.h"
#include "ui/base/dock.h"
#include "ui/base/image_export.h"
#include "ui/base/message_bar.h"
#include "ui/steps/step_mode.h"
#include "ui/truth/identify_panel.h"
#include "ui/truth/truth_mode.h"
#include "ui/window/dragged_file.h"
#include "ui/window/figure_export.h"
#include "ui/window/life_cycle.h"
#include "ui/window/main_window.h"
#include "ui/window/recent_labels.h"

#include <QAction>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QPainter>
#include <QUrl>

namespace rasterlens
{

void MainWindow::fillRecentMenu()
{
    m_recentMenu->clear();
    const QStringList files = m_document.recentFiles();
    const QStringList labels = recentLabels(files);
    for (qsizetype i = 0; i < files.size(); ++i) {
        const QString& path = files[i];
        const bool isThere = QFileInfo::exists(path);
        QString label = labels[i];
        label.replace(QLatin1Char('&'), QLatin1String("&&"));
        QAction* action = m_recentMenu->addAction(isThere ? label : tr("%1 (not found)").arg(label));
        action->setToolTip(path);
        action->setStatusTip(path);
        action->setEnabled(isThere);
        connect(action, &QAction::triggered, this, [this, path] { open(path); });
    }
    m_recentMenu->setToolTipsVisible(true);
    m_clearRecent->setEnabled(!files.isEmpty());
    if (!files.isEmpty()) {
        m_recentMenu->addSeparator();
        m_recentMenu->addAction(m_clearRecent);
    }
    m_recentMenu->menuAction()->setEnabled(!files.isEmpty());
}

void MainWindow::chooseFileToOpen()
{
    auto* dialog = new QFileDialog(this, tr("Open"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Scenes, cases, sessions and lessons (*.obj *.case *.json)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::open);
    dialog->open();
}

void MainWindow::chooseFileToIdentify()
{
    auto* dialog = new QFileDialog(this, tr("Which mistake is mine?"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters(
        {tr("Pictures and arrays (%1)").arg(QStringLiteral("*.") + pictureInputSuffixes().join(QStringLiteral(" *."))),
         tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, this, &MainWindow::identifyPicture);
    dialog->open();
}

void MainWindow::identifyPicture(const QString& path)
{
    m_truth->showPanel(QStringLiteral("identify"));
    m_truth->identifyPanel().identifyFile(path);
}

void MainWindow::keepAll()
{
    if (m_memory != Memory::Remember)
        return;
    m_lifeCycle->keepForNextStart();
    saveMemory();
}

void MainWindow::closeEvent(QCloseEvent* event)
{
    if (!m_lifeCycle->mayClose()) {
        event->ignore();
        return;
    }
    if (m_memory == Memory::Remember)
        saveMemory();
    m_worker.setContinuous(false);
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event)
{
    if (!draggedFile(*event->mimeData()).isEmpty())
        acceptAsCopy(*event);
}

void MainWindow::dropEvent(QDropEvent* event)
{
    const QString file = draggedFile(*event->mimeData());
    if (file.isEmpty()) {
        m_message->show(MessageKind::Warning,
                        tr("The name of the dropped file did not arrive. Open it from the menu."));
        return;
    }
    if (!acceptAsCopy(*event))
        return;
    if (event->mimeData()->urls().size() > 1 &&
        !isPictureName(file)) // said once the scene is there, which takes former messages away
        connect(
            &m_document, &Document::opened, this,
            [this](const QString& name) {
                m_message->show(MessageKind::Info,
                                tr("One file at a time: %1 is opened.").arg(QFileInfo(name).fileName()));
            },
            Qt::SingleShotConnection);
    if (isPictureName(file))
        identifyPicture(file);
    else
        open(file);
}

void MainWindow::chooseFileToExport(const QString& title, const QString& suggestion, bool asDrawing,
                                    std::function<void(const QString&)> save)
{
    const QStringList formats = asDrawing ? FigureExport::formats() : pictureSuffixes();
    QFileDialog* dialog = newExportDialog(this, title, suggestion, formats);
    connect(dialog, &QFileDialog::fileSelected, this, std::move(save));
    dialog->open();
}

void MainWindow::chooseRunToAnimate()
{
    m_stepMode->chooseRun(tr("Export a run as GIF"), [this](std::size_t first, std::size_t last) {
        QFileDialog* dialog =
            newExportDialog(this, tr("Export a run as GIF"), QStringLiteral("run.gif"), {QStringLiteral("gif")});
        connect(dialog, &QFileDialog::fileSelected, this, [=, this](const QString& path) {
            m_figures->exportRun(path, {first, last}, this);
        });
        dialog->open();
    });
}

QImage MainWindow::picture()
{
    QPixmap picture = grab();
    QPainter painter(&picture);
    for (Dock* dock : findChildren<Dock*>())
        if (dock->isVisible() && dock->isFloating())
            painter.drawPixmap(mapFromGlobal(dock->mapToGlobal(QPoint(0, 0))), dock->grab());
    painter.end();
    return picture.toImage();
}

bool MainWindow::exportFigure(const QString& path)
{
    const auto error = m_figures->exportTo(path);
    reportSaved(error, path);
    return !error;
}

bool MainWindow::exportFramebuffer(const QString& path)
{
    const auto error = savePicture(m_lastFrame ? m_lastFrame->frame.image : QImage(), {path, m_document.inputFiles()});
    reportSaved(error, path);
    return !error;
}

bool MainWindow::exportWindow(const QString& path)
{
    const auto error = savePicture(picture(), {path, m_document.inputFiles()});
    reportSaved(error, path);
    return !error;
}

void MainWindow::reportSaved(const std::optional<QString>& error, const QString& path)
{
    m_message->show(error ? MessageKind::Error : MessageKind::Info, error ? *error : tr("Written: %1").arg(path));
}

} // namespace rasterlens
