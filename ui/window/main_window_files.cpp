#include "ui/base/message_bar.h"
#include "ui/window/dragged_file.h"
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
        connect(action, &QAction::triggered, this, [this, path] { m_document.open(path); });
    }
    m_recentMenu->setToolTipsVisible(true);
    if (!files.isEmpty()) {
        m_recentMenu->addSeparator();
        connect(m_recentMenu->addAction(tr("Clear")), &QAction::triggered, this,
                [this] { m_document.clearRecentFiles(); });
    }
    m_recentMenu->menuAction()->setEnabled(!files.isEmpty());
}

void MainWindow::chooseFileToOpen()
{
    auto* dialog = new QFileDialog(this, tr("Open"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters({tr("Scenes, cases and sessions (*.obj *.case *.json)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, &m_document, &Document::open);
    dialog->open();
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
    if (event->mimeData()->urls().size() > 1) // said once the scene is there, which takes former messages away
        connect(
            &m_document, &Document::opened, this,
            [this](const QString& name) {
                m_message->show(MessageKind::Info,
                                tr("One file at a time: %1 is opened.").arg(QFileInfo(name).fileName()));
            },
            Qt::SingleShotConnection);
    m_document.open(file);
}

} // namespace rasterlens
