#pragma once
#include "core/truth/experiment.h"

#include <QWidget>

#include <optional>
#include <vector>

class QCPErrorBars;
class QCPGraph;
class QCPItemText;
class QCustomPlot;
class QPainter;

namespace rasterlens
{

/// The y axis of the plot.
enum class SpeedMeasure { NsPerCoveredPixel, MtriPerS };

/// The mark of a row's dot: that of its algorithm, or of a renderer that is not ours.
[[nodiscard]] QPixmap dotMark(const ExperimentRow& row);

/// `Edge walking; Number type: Float, 32 bit`, in the language in use; or what another renderer calls itself.
[[nodiscard]] QString titleOf(const ExperimentRow& row);

/// Error against speed, both on logarithmic axes: a dot a variant, and bars from the tenth to the ninetieth percentile.
/// Dots that no other one beats are filled and, as far as there is room, named; others are rings. Errors of zero have a
/// place of their own at the left border; where all are zero, a sentence takes the place of the dots.
class ExperimentPlot : public QWidget
{
    Q_OBJECT

public:
    explicit ExperimentPlot(QWidget* parent = nullptr);

    /// in  rows of one scene, their frontier marked for the measure
    void setRows(const std::vector<ExperimentRow>& rows, ErrorMeasure error, SpeedMeasure speed);
    /// Rings and names a dot; nothing: none.
    void setChosen(std::optional<int> row);

    /// How many dots there are: rows that have been measured and have this error.
    [[nodiscard]] int dotCount() const { return static_cast<int>(m_dots.size()); }
    /// The names that stand beside dots.
    [[nodiscard]] QStringList labels() const;
    /// The sentence in place of the dots; empty where there are dots.
    [[nodiscard]] QString sentence() const;
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
        std::size_t look;
        bool frontier;
        QString name;
    };

    /// The dots of an algorithm that are beaten, or those that are not.
    struct Series {
        std::size_t look;
        bool frontier;
        QCPGraph* graph;
        QCPErrorBars* bars;
    };

    void takeDots(const std::vector<ExperimentRow>& rows);
    void draw();
    struct LabelPlace {
        QString text;
        Qt::Alignment alignment; ///< of the name, seen from its dot
        QRectF area;
    };

    void drawLabels();
    [[nodiscard]] std::optional<LabelPlace> labelPlace(const Dot& dot, const std::vector<QRectF>& taken) const;
    void applyColors();
    void setRanges();
    [[nodiscard]] std::optional<int> rowAt(QPointF point) const;

    QCustomPlot* m_plot;
    std::vector<Series> m_series; ///< two a look
    QCPGraph* m_ring;
    std::vector<Dot> m_dots;
    std::vector<QCPItemText*> m_labels;
    QCPItemText* m_sentence;
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
