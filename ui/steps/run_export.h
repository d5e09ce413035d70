#pragma once
#include "ui/canvas/viewport_widget.h"

#include <QObject>
#include <QTimer>

#include <optional>

class QProgressDialog;
class QWidget;

namespace rasterlens
{

class StepSession;

/// Writes a run of steps as numbered pictures, one a turn of the event loop: the window stays alive, shows how far it
/// is and lets the user stop it. The position is put back at the end.
class RunExport : public QObject
{
    Q_OBJECT

public:
    struct Run {
        std::size_t first;
        std::size_t last; ///< included
        std::optional<int> zoom;
    };

    /// in  a session with a log; first <= last <= its size
    RunExport(StepSession& session, ViewportWidget& viewport, const QString& folder, Run run, QWidget* window);

Q_SIGNALS:
    /// The last picture is written, the user stopped it, or one could not be written; the files before it stay. The
    /// export deletes itself afterwards.
    ///
    /// errors  a sentence, else empty
    void finished(const QString& error);

private:
    void writeNext();
    [[nodiscard]] QImage picture() const;
    void finish(const QString& error);

    StepSession& m_session;
    ViewportWidget& m_viewport;
    QString m_folder;
    Run m_run;
    std::optional<ViewportWidget::FigurePart> m_part; ///< one for all pictures, which so have one size
    std::size_t m_next;
    std::size_t m_positionBefore;
    QTimer m_timer;
    QProgressDialog* m_progress;
};

} // namespace rasterlens
