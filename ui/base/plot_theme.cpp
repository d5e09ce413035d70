#include "ui/base/plot_theme.h"

#include "ui/base/theme.h"

namespace rasterlens
{

void applyPlotTheme(QCustomPlot& plot, const QPalette& palette)
{
    const QColor text = palette.color(QPalette::Text);
    const QPen line(palette.color(QPalette::PlaceholderText));
    QColor grid = palette.color(QPalette::Mid);
    grid.setAlpha(110);
    plot.setBackground(QBrush(palette.color(QPalette::Base)));
    for (QCPAxis* axis : plot.axisRect()->axes()) {
        axis->setBasePen(line);
        axis->setTickPen(line);
        axis->setSubTickPen(line);
        axis->setLabelColor(text);
        axis->setTickLabelColor(text);
        axis->setLabelFont(textFont(-1));
        axis->setTickLabelFont(textFont(-1));
        axis->setLabelPadding(2);
        axis->grid()->setPen(QPen(grid, 1, Qt::DotLine));
    }
    plot.legend->setFont(textFont(-1.5));
    plot.legend->setTextColor(text);
    plot.legend->setBrush(Qt::NoBrush);
    plot.legend->setBorderPen(Qt::NoPen);
    plot.legend->setIconSize(16, QFontMetrics(textFont(-1)).height());
}

void putLegendAbove(QCustomPlot& plot)
{
    plot.legend->setVisible(true);
    plot.legend->setFillOrder(QCPLegend::foColumnsFirst);
    plot.legend->setColumnSpacing(4);
    plot.legend->setIconTextPadding(3);
    plot.legend->setMargins(QMargins(2, 1, 2, 5));
    plot.plotLayout()->insertRow(0);
    plot.plotLayout()->addElement(0, 0, plot.legend);
    plot.plotLayout()->setRowStretchFactor(0, 0.001);
}

} // namespace rasterlens
