#pragma once
#include "core/truth/charts.h"

#include <QWidget>

class QCustomPlot;
class QPainter;

namespace rasterlens
{

/// A chart of lines, in the language and the colours in use.
class ChartPlot : public QWidget
{
    Q_OBJECT

public:
    explicit ChartPlot(QWidget* parent = nullptr);

    /// in  info: null shows empty axes
    void setChart(const ChartInfo* info, const Chart& chart);

    /// How many curves there are to be seen.
    [[nodiscard]] int curveCount() const;
    /// Where the value of a curve is, in the widget.
    [[nodiscard]] QPointF placeOf(std::size_t series, std::size_t i) const;

    /// Draws the plot as it is, scaled to a size.
    void paintTo(QPainter& painter, QSize size);

    QSize minimumSizeHint() const override { return {240, 140}; }
    QSize sizeHint() const override { return {560, 260}; }

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void draw();
    void applyColors();
    void setRanges();
    [[nodiscard]] double placeOf(double value) const;

    QCustomPlot* m_plot;
    const ChartInfo* m_info = nullptr;
    Chart m_chart;
    double m_zeroPlace = 0; ///< of a value of 0 on a logarithmic axis
};

} // namespace rasterlens
