#pragma once
// QCustomPlot's header is written with Qt's keywords, which the project does without. Sources that draw plots include
// this header in its place.
#define signals Q_SIGNALS
#define slots Q_SLOTS
#define foreach Q_FOREACH
#include <qcustomplot.h>
#undef signals
#undef slots
#undef foreach

namespace rasterlens
{

/// Gives axes, grid, legend and background the colours of a palette and the fonts of the window. A widget that holds a
/// plot calls this function at the start and when its palette, font or style changes; then it colours its own graphs
/// and replots.
void applyPlotTheme(QCustomPlot& plot, const QPalette& palette);

/// Shows the legend in a row above the axes, where it covers no curve.
void putLegendAbove(QCustomPlot& plot);

} // namespace rasterlens
