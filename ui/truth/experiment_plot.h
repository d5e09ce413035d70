#pragma once
#include "core/truth/experiment.h"

#include <QWidget>

#include <optional>
#include <vector>

class QCPErrorBars;
class QCPGraph;
class QCustomPlot;
class QPainter;

namespace rasterlens
{

/// The y axis of the plot.
enum class SpeedMeasure { NsPerCoveredPixel, MtriPerS };

/// The mark of the algorithm's dots.
[[nodiscard]] QPixmap algorithmMark(Algorithm algorithm);

/// Error against speed, both on logarithmic axes: a dot a variant, bars from the tenth to the ninetieth percentile, and
/// the Pareto frontier as steps. Errors of zero have a place of their own at the left border.
class ExperimentPlot : public QWidget
{
    Q_OBJECT

public:
    explicit ExperimentPlot(QWidget* parent = nullptr);

    /// in  rows of one scene, their frontier marked for the measure
    void setRows(const std::vector<ExperimentRow>& rows, ErrorMeasure error, SpeedMeasure speed);
    /// Rings a dot; nothing: none.
    void setChosen(std::optional<int> row);

    /// How many dots there are: rows that have been measured and have this error.
    [[nodiscard]] int dotCount() const { return static_cast<int>(m_dots.size()); }
    /// Where the dot of a row is, in the widget; nothing for one without.
    [[nodiscard]] std::optional<QPointF> placeOf(int row) const;

    /// Draws the plot as it is, scaled to a size.
    void paintTo(QPainter& painter, QSize size);

    QSize minimumSizeHint() const override { return {240, 140}; }
    QSize sizeHint() const override { return {460, 260}; }

Q_SIGNALS:
    void rowClicked(int row);
    void rowHovered(int row, QPoint globalPosition); ///< -1: none

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    struct Dot {
        int row;
        double x; ///< plot coordinates
        double y;
        double low; ///< of the spread
        double high;
        Algorithm algorithm;
        bool frontier;
    };

    struct Series {
        Algorithm algorithm;
        QCPGraph* graph;
        QCPErrorBars* bars;
    };

    void takeDots(const std::vector<ExperimentRow>& rows);
    void draw();
    void drawFrontier();
    void applyColors();
    void setRanges();
    [[nodiscard]] std::optional<int> rowAt(QPointF point) const;

    QCustomPlot* m_plot;
    std::vector<Series> m_series; ///< one an algorithm
    QCPGraph* m_frontier;
    QCPGraph* m_ring;
    std::vector<Dot> m_dots;
    double m_zeroPlace = 1; ///< x of an error of zero
    bool m_hasZero = false;
    std::optional<int> m_chosen;
    ErrorMeasure m_error = ErrorMeasure::Coverage;
    SpeedMeasure m_speed = SpeedMeasure::NsPerCoveredPixel;
};

/// The speed of a row and its spread, in the unit of the measure.
struct Speed {
    double median;
    double low;
    double high;
};
[[nodiscard]] Speed speedOf(const ExperimentRow& row, SpeedMeasure measure);
[[nodiscard]] QString speedTitle(SpeedMeasure measure);
[[nodiscard]] QString errorTitle(ErrorMeasure measure);

} // namespace rasterlens
