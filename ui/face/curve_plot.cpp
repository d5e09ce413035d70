#include "ui/face/curve_plot.h"

#include "core/observe/names.h"
#include "ui/base/inks.h"
#include "ui/base/plot_theme.h"
#include "ui/base/theme.h"

#include <QEvent>
#include <QLabel>
#include <QVBoxLayout>

#include <algorithm>

namespace rasterlens
{
namespace
{

constexpr double kCurveWidth = 2;
constexpr double kMarkSize = 8;
constexpr double kBeyondEnds = 0.01; ///< of the range: a curve along an end of it keeps its width

/// An axis of which both ends have their numbers, and nothing between them.
void setEnds(QCPAxis& axis, double low, double high)
{
    const QSharedPointer<QCPAxisTickerText> ticker(new QCPAxisTickerText);
    ticker->addTick(low, shortNumber(low));
    ticker->addTick(high, shortNumber(high));
    axis.setTicker(ticker);
    const double beyond = kBeyondEnds * (high - low);
    axis.setRange(low - beyond, high + beyond);
}

} // namespace

CurvePlot::CurvePlot(QWidget* parent) : QWidget(parent), m_title(new QLabel), m_plot(new QCustomPlot)
{
    m_title->setObjectName(QStringLiteral("heading"));
    m_title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    m_plot->setMinimumSize(1, 1);                                 // of legend and axes as much as there is room for
    m_plot->setAttribute(Qt::WA_TransparentForMouseEvents, true); // the wheel scrolls the panel
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(m_title);
    column->addWidget(m_plot, 1);

    m_plot->axisRect()->setupFullAxesBox();
    for (QCPAxis* axis : {m_plot->xAxis2, m_plot->yAxis2})
        axis->setTicks(false);
    for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis})
        axis->grid()->setVisible(false);
    putLegendAbove(*m_plot);
    m_diagonal = m_plot->addGraph();
    m_curve = m_plot->addGraph();
    m_toX = new QCPItemLine(m_plot);
    m_toX->end->setTypeY(QCPItemPosition::ptAxisRectRatio);
    m_toY = new QCPItemLine(m_plot);
    m_toY->end->setTypeX(QCPItemPosition::ptAxisRectRatio);
    m_mark = m_plot->addGraph();
    m_mark->setLineStyle(QCPGraph::lsNone);
    m_mark->removeFromLegend();
    m_markText = new QCPItemText(m_plot);
    m_markText->position->setType(QCPItemPosition::ptAbsolute);
    m_markText->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_markText->setPadding(QMargins(2, 0, 2, 0));
    connect(m_plot, &QCustomPlot::afterLayout, this, &CurvePlot::placeMarkText);
    applyTheme();
}

void CurvePlot::setFigure(const CurveFigure& figure)
{
    m_title->setText(figure.title);
    m_plot->xAxis->setLabel(figure.xName);
    m_plot->yAxis->setLabel(figure.yName);
    setEnds(*m_plot->xAxis, figure.low, figure.high);
    setEnds(*m_plot->yAxis, figure.low, figure.high);
    // The numbers at the ends are centred on them: half of each lies beyond.
    const QFontMetrics metrics(m_plot->xAxis->tickLabelFont());
    m_plot->axisRect()->setMinimumMargins(
        QMargins(0, metrics.height() / 2, metrics.horizontalAdvance(shortNumber(figure.high)) / 2 + 2, 0));

    m_diagonal->setName(figure.diagonalName);
    m_diagonal->setData({figure.low, figure.high}, {figure.low, figure.high}, true);
    m_curve->data()->clear();
    for (const QPointF& point : figure.points)
        m_curve->addData(point.x(), point.y());
    m_curve->setName(figure.curveName);
    if (figure.curveName.isEmpty())
        m_curve->removeFromLegend();
    else
        m_curve->addToLegend();

    m_mark->setData({figure.mark.x()}, {figure.mark.y()}, true);
    for (const QCPItemLine* line : {m_toX, m_toY})
        line->start->setCoords(figure.mark);
    m_toX->end->setCoords(figure.mark.x(), 1);
    m_toY->end->setCoords(0, figure.mark.y());
    m_markText->setText(figure.markText);
    m_plot->replot(QCustomPlot::rpQueuedRefresh); // at once: a picture of the window may be taken before the next event
}

/// Right of the mark and a little below it or, where the plot ends before, left of it; in two lines where the plot is
/// narrower than the text.
void CurvePlot::placeMarkText()
{
    constexpr double kAside = 6;
    const QCPGraphDataContainer& mark = *m_mark->data();
    if (mark.isEmpty())
        return;
    const QPointF at = m_mark->coordsToPixels(mark.constBegin()->key, mark.constBegin()->value);
    const QRectF room = area();
    if (const auto gap = m_markText->text().lastIndexOf(QLatin1Char(' '));
        markTextBox().width() > room.width() && gap > 0)
        m_markText->setText(m_markText->text().replace(gap, 1, QLatin1Char('\n')));
    const QSizeF size = markTextBox().size();
    const bool fits = at.x() + kAside + size.width() <= room.right();
    const double left = fits ? at.x() + kAside : at.x() - kAside - size.width();
    const double top = std::min(at.y() + kMarkSize / 2, room.bottom() - size.height());
    m_markText->position->setCoords(std::max(left, room.left()), std::max(top, room.top()));
}

QRectF CurvePlot::area() const { return m_plot->axisRect()->rect(); }

QRectF CurvePlot::markTextBox() const
{
    return {m_markText->topLeft->pixelPosition(), m_markText->bottomRight->pixelPosition()};
}

void CurvePlot::applyTheme()
{
    applyPlotTheme(*m_plot, palette());
    const Inks inks = inksFor(palette());
    const QColor text = palette().color(QPalette::Text);
    const QColor base = palette().color(QPalette::Base);
    m_diagonal->setPen(QPen(inks.minus, kCurveWidth, Qt::DashLine));
    m_curve->setPen(QPen(inks.plus, kCurveWidth));
    for (QCPItemLine* line : {m_toX, m_toY})
        line->setPen(QPen(text, 1, Qt::DotLine));
    m_mark->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(text, 1.5), QBrush(base), kMarkSize));
    constexpr int kVeil = 210; ///< of 255: the curve below the text is seen, and does not disturb
    QColor veil = base;
    veil.setAlpha(kVeil);
    m_markText->setFont(textFont(-1));
    m_markText->setColor(text);
    m_markText->setBrush(veil);
    m_markText->setPen(Qt::NoPen);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void CurvePlot::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    const QEvent::Type type = event->type();
    if (type == QEvent::PaletteChange || type == QEvent::FontChange || type == QEvent::StyleChange)
        applyTheme();
}

} // namespace rasterlens
