#pragma once
#include "ui/document/render_worker.h"

#include <QElapsedTimer>
#include <QLabel>
#include <QTimer>
#include <QWidget>

#include <deque>
#include <memory>
#include <optional>
#include <vector>

class QHBoxLayout;
class QScrollArea;

namespace rasterlens
{

/// Frames a second, stage times and every counter of the last counted frame, always shown in full.
class StatisticsPanel : public QWidget
{
    Q_OBJECT

public:
    explicit StatisticsPanel(QWidget* parent = nullptr);

    /// Counters that stay behind the picture, as while the camera moves, are dimmed until they are counted.
    void setFrame(const FramePtr& frame);
    void setStale(bool stale);
    /// in   the step of a record after which the frame is; nothing: it is the finished one
    void setMoment(const std::optional<std::size_t>& step);
    /// Frames a second, or the time of a frame that takes less than a millisecond, nothing where it was not timed;
    /// clipped and culled faces, in one line.
    [[nodiscard]] QString brief() const;
    [[nodiscard]] const QLabel* counter(const QString& id) const;
    [[nodiscard]] bool isStale() const { return m_stale; }
    /// The frame is on the screen.
    void setShown(const FramePtr& frame);
    /// Milliseconds from a camera move to its picture on the screen, the median of the last ones; 0 before the first.
    [[nodiscard]] double latency() const;

    /// The last counted frame as the statistics document of the command line, and flattened to one row.
    [[nodiscard]] QString asJson() const;
    [[nodiscard]] QString asCsv() const;
    /// The text shown for a counter, by its JSON name: `submitted`, `covered`.
    [[nodiscard]] QString shown(const QString& counter) const;

    QSize sizeHint() const override;        ///< with every row in sight
    QSize minimumSizeHint() const override; ///< rate, clipped and culled faces are in sight

Q_SIGNALS:
    void changed(); ///< brief()

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Counter {
        const char* id;
        QString (*text)(const Settings&, const Statistics&);
        QLabel* value = nullptr;
    };
    /// One or two counters on a line; none: a heading.
    struct Row {
        const char* title;
        const char* help;
        std::vector<Counter> counters;
        const char* ofSamples = nullptr; ///< the title where pixels have several samples
        QLabel* name = nullptr;
    };
    [[nodiscard]] static std::vector<Row> faceRows();
    [[nodiscard]] static std::vector<Row> pixelRows();
    QHBoxLayout* buildRate();
    QWidget* buildCounters();
    static QHBoxLayout* counterLine(std::vector<Counter>& counters);
    void showCounters(const FramePtr& frame);
    void showHeadings();
    void noteFinished(const FramePtr& frame);
    /// in   a counted frame
    [[nodiscard]] QJsonObject statisticsDocument() const;
    [[nodiscard]] std::optional<double> countedRate() const;
    [[nodiscard]] double framesPerSecond() const;
    void retranslate();
    void explainRate();
    void showTimes();
    void keepWideEnough();

    std::vector<Row> m_rows;
    QScrollArea* m_scroll = nullptr;
    QLabel* m_fps = nullptr;
    QLabel* m_fpsUnit = nullptr;
    QLabel* m_frameTime = nullptr;
    QLabel* m_stageTimes = nullptr;
    /// What is kept of the last counted frame: its picture goes with the window's.
    struct Counted {
        std::shared_ptr<const Scene> scene;
        Settings settings;
        Statistics statistics;
    };
    std::optional<Counted> m_counted;
    std::optional<std::size_t> m_step; ///< see setMoment()
    StageTimes m_times;
    bool m_fast = false; ///< m_times are those of the tiled algorithm, while the camera moves
    std::deque<double> m_latencies;
    QElapsedTimer m_clock;
    std::deque<qint64> m_finished; ///< when the last frames were completed, milliseconds
    QTimer m_settle;               ///< shows the rate again once frames stop coming
    QTimer m_lag;                  ///< runs while the counters are not those of the picture
    bool m_stale = false;
    bool m_timesLag = false; ///< the last picture was not timed
};

} // namespace rasterlens
