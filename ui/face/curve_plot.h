#pragma once
#include <QPointF>
#include <QRectF>
#include <QString>
#include <QWidget>

#include <vector>

class QCPGraph;
class QCPItemLine;
class QCPItemText;
class QCustomPlot;
class QLabel;

namespace rasterlens
{

/// A curve beside the diagonal that it differs from, both axes with the same ends, and one point of it marked.
struct CurveFigure {
    QString title;
    QString xName;
    QString yName;
    QString diagonalName;
    QString curveName; ///< empty: not in the legend
    double low = 0;    ///< the ends of both axes
    double high = 1;
    std::vector<QPointF> points; ///< of the curve, x ascending
    QPointF mark;
    QString markText;
};

/// Draws a CurveFigure: a title, a legend, axes with numbers at their ends, and dotted lines from the mark to both
/// axes.
class CurvePlot : public QWidget
{
    Q_OBJECT

public:
    explicit CurvePlot(QWidget* parent = nullptr);

    void setFigure(const CurveFigure& figure);

    /// The rectangle between the axes, as last drawn, in pixels of the plot.
    [[nodiscard]] QRectF area() const;
    /// The place of the mark's text, as last drawn, in pixels of the plot.
    [[nodiscard]] QRectF markTextBox() const;

protected:
    void changeEvent(QEvent* event) override;

private:
    void applyTheme();
    void placeMarkText();

    QLabel* m_title;
    QCustomPlot* m_plot;
    QCPGraph* m_diagonal;
    QCPGraph* m_curve;
    QCPItemLine* m_toX;
    QCPItemLine* m_toY;
    QCPGraph* m_mark;
    QCPItemText* m_markText;
};

} // namespace rasterlens
