#include "ui/window/run_animation.h"

#include <QProgressDialog>

#include <utility>

namespace rasterlens
{

RunAnimation::RunAnimation(Figure figure, Moments moments, Run run, ExportTarget target, QWidget* window)
    : QObject(window), m_figure(std::move(figure)), m_moments(std::move(moments)), m_run(run),
      m_target(std::move(target)), m_next(run.first),
      m_progress(new QProgressDialog(tr("Drawing the steps\u2026"), tr("Stop"), 0, int(2 * (run.last - run.first + 1)),
                                     window))
{
    constexpr int kShownAfterMs = 300;
    m_progress->setWindowModality(Qt::WindowModal);
    m_progress->setWindowTitle(tr("Export a run as GIF"));
    m_progress->setMinimumDuration(kShownAfterMs);
    m_progress->setAutoClose(false);
    connect(m_progress, &QProgressDialog::canceled, this, [this] { finish({}, true); });
    connect(&m_timer, &QTimer::timeout, this, &RunAnimation::next);
    m_timer.start(0);
}

/// Once through the run to find the size, and once more to draw.
void RunAnimation::next()
{
    m_moments.goTo(m_next);
    m_gif ? draw() : measure();
}

void RunAnimation::measure()
{
    m_size = m_size.expandedTo(m_figure.size());
    m_progress->setValue(int(m_next - m_run.first));
    if (m_next++ < m_run.last)
        return;
    m_next = m_run.first;
    m_gif = std::make_unique<GifWriter>(m_size, m_run.milliseconds);
}

void RunAnimation::draw()
{
    if (const auto problem = m_gif->add(m_figure.on(m_size))) {
        finish(notWritten(m_target.path, *problem));
        return;
    }
    m_progress->setValue(int(m_run.last - m_run.first + 1 + m_next - m_run.first));
    if (m_next++ == m_run.last)
        write();
}

void RunAnimation::write()
{
    const GifWriter::Finished file = m_gif->finish();
    if (file.problem)
        finish(notWritten(m_target.path, *file.problem));
    else
        finish(saveBytes(file.bytes, m_target).value_or(QString()));
}

void RunAnimation::finish(const QString& error, bool stopped)
{
    m_timer.stop();
    m_progress->disconnect(this);
    m_progress->deleteLater();
    m_moments.goBack();
    Q_EMIT finished(error, stopped);
    deleteLater();
}

} // namespace rasterlens
