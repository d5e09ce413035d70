#include "ui/steps/run_export.h"

#include "ui/base/image_export.h"
#include "ui/steps/step_session.h"

#include <QDir>
#include <QPainter>
#include <QProgressDialog>

namespace rasterlens
{

RunExport::RunExport(StepSession& session, ViewportWidget& viewport, const QString& folder, Run run, QWidget* window)
    : QObject(window), m_session(session), m_viewport(viewport), m_folder(folder), m_run(run),
      m_part(m_viewport.figurePart(run.zoom)), m_next(run.first), m_positionBefore(session.position()),
      m_progress(
          new QProgressDialog(tr("Writing the pictures\u2026"), tr("Stop"), 0, int(run.last - run.first + 1), window))
{
    m_progress->setWindowModality(Qt::WindowModal);
    m_progress->setWindowTitle(tr("Export a run of steps"));
    m_progress->setMinimumDuration(300);
    m_progress->setAutoClose(false);
    connect(m_progress, &QProgressDialog::canceled, this, [this] { finish({}); });
    connect(&m_timer, &QTimer::timeout, this, &RunExport::writeNext);
    m_timer.start(0);
}

QImage RunExport::picture() const
{
    if (!m_part)
        return {};
    QImage image(m_part->size, QImage::Format_RGB32);
    if (image.isNull())
        return {};
    QPainter painter(&image);
    m_viewport.paintFigure(painter, *m_part);
    return image;
}

void RunExport::writeNext()
{
    const int digits = int(QString::number(m_run.last).size());
    const QString name = QStringLiteral("step-%1.png").arg(m_next, digits, 10, QLatin1Char('0'));
    m_session.moveTo(m_next);
    if (const auto error = savePicture(picture(), {QDir(m_folder).filePath(name), m_session.document().inputFiles()})) {
        finish(*error);
        return;
    }
    ++m_next;
    m_progress->setValue(int(m_next - m_run.first));
    if (m_next > m_run.last)
        finish({});
}

void RunExport::finish(const QString& error)
{
    m_timer.stop();
    m_progress->disconnect(this);
    m_progress->deleteLater();
    m_session.moveTo(m_positionBefore);
    Q_EMIT finished(error);
    deleteLater();
}

} // namespace rasterlens
