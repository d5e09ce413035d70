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

/// Writes a run of moments as one animated GIF, of steps or of the frames of a motion: the figure of each, all on a
/// sheet that the largest of them needs. It makes one a turn of the event loop: the window stays alive, shows how far
/// it is and lets the user stop it.
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

    /// Goes to a moment; and back to what was shown before.
    struct Moments {
        std::function<void(std::size_t)> goTo;
        std::function<void()> goBack;
    };

    /// The figure of the present moment.
    struct Figure {
        std::function<QSize()> size;
        std::function<QImage(QSize)> on; ///< in the upper left corner of a white sheet of that size
    };

    /// in  first <= last, and all between them are moments
    RunAnimation(Figure figure, Moments moments, Run run, ExportTarget target, QWidget* window);

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
    Moments m_moments;
    Run m_run;
    ExportTarget m_target;
    std::size_t m_next;
    QSize m_size;                     ///< the least that holds all figures measured so far
    std::unique_ptr<GifWriter> m_gif; ///< null while figures are measured
    QTimer m_timer;
    QProgressDialog* m_progress;
};

} // namespace rasterlens
