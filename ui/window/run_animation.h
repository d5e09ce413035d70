#pragma once
#include "core/io/gif_writer.h"
#include "ui/base/image_export.h"

#include <QImage>
#include <QObject>
#include <QTimer>

#include <cstddef>
#include <functional>
#include <memory>

class QProgressDialog;
class QWidget;

namespace rasterlens
{

class StepSession;

/// Writes a run of steps as one animated GIF: the figure of each step, all on a sheet that the largest of them needs.
/// It makes one a turn of the event loop: the window stays alive, shows how far it is and lets the user stop it. The
/// position is put back at the end.
class RunAnimation : public QObject
{
    Q_OBJECT

public:
    static constexpr int kUsualMilliseconds = 250;

    struct Run {
        std::size_t first;
        std::size_t last; ///< included
        int milliseconds = kUsualMilliseconds;
    };

    /// The figure of the present step.
    struct Figure {
        std::function<QSize()> size;
        std::function<QImage(QSize)> on; ///< in the upper left corner of a white sheet of that size
    };

    /// in  a session with a log; first <= last <= its size
    RunAnimation(Figure figure, StepSession& session, Run run, ExportTarget target, QWidget* window);

Q_SIGNALS:
    /// The file is written, the user stopped, or it could not be made: there is no file then. The animation deletes
    /// itself afterwards.
    ///
    /// errors  a sentence, else empty
    void finished(const QString& error, bool stopped);

private:
    void next();
    void measure();
    void draw();
    void write();
    void finish(const QString& error, bool stopped = false);

    Figure m_figure;
    StepSession& m_session;
    Run m_run;
    ExportTarget m_target;
    std::size_t m_next;
    std::size_t m_positionBefore;
    QSize m_size;                     ///< the least that holds all figures measured so far
    std::unique_ptr<GifWriter> m_gif; ///< null while figures are measured
    QTimer m_timer;
    QProgressDialog* m_progress;
};

} // namespace rasterlens
