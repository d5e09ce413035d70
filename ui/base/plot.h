#pragma once
#include <QColor>
#include <QPointF>
#include <QRectF>
#include <QString>

#include <optional>
#include <vector>

class QPainter;
class QPalette;

namespace rasterlens
{

struct PlotCurve {
    std::vector<QPointF> points;
    QColor color;
    Qt::PenStyle style = Qt::SolidLine;
    QString name; ///< in the legend; may be empty
};

/// A point with lines to both axes and its numbers beside it.
struct PlotMark {
    QPointF at;
    QString text;
    QColor color;
};

struct Plot {
    QString title;
    QString xName;
    QString yName;
    QRectF range; ///< of the values, y up: top is the smallest y
    std::vector<PlotCurve> curves;
    std::vector<PlotMark> marks;
};

/// Draws axes with their end values, the curves, the marks and a legend into a rectangle.
void paintPlot(QPainter& painter, const QRectF& where, const Plot& plot, const QPalette& palette);

} // namespace rasterlens
