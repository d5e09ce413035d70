#include "ui/truth/chart_plot.h"

#include "ui/base/inks.h"
#include "ui/base/plot_theme.h"

#include <QCoreApplication>
#include <QEvent>
#include <QPainter>
#include <QPicture>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr double kDotSize = 6;
/// Curves differ by their marks as well as by their colours.
constexpr std::array kMarks{QCPScatterStyle::ssDisc,    QCPScatterStyle::ssSquare, QCPScatterStyle::ssTriangle,
                            QCPScatterStyle::ssDiamond, QCPScatterStyle::ssCross,  QCPScatterStyle::ssPlus};

QString translated(const char* text) { return QCoreApplication::translate("Chart", text); }

/// Powers of ten, and 0 for the lowest of them where the axis begins with zero.
class PowerTicker : public QCPAxisTickerLog
{
public:
    explicit PowerTicker(double zero) : m_zero(zero) {}

protected:
    QString getTickLabel(double tick, const QLocale& locale, QChar format, int precision) override
    {
        if (m_zero > 0 && tick < m_zero * 1.001)
            return QStringLiteral("0");
        return QCPAxisTickerLog::getTickLabel(tick, locale, format, precision);
    }

private:
    double m_zero;
};

void setScale(QCPAxis& axis, bool logarithmic, double zero = 0)
{
    axis.setScaleType(logarithmic ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    axis.setTicker(logarithmic ? QSharedPointer<QCPAxisTicker>(new PowerTicker(zero))
                               : QSharedPointer<QCPAxisTicker>(new QCPAxisTicker));
    axis.setNumberFormat(logarithmic ? QStringLiteral("gb") : QStringLiteral("g"));
    axis.setNumberPrecision(logarithmic ? 2 : 4);
}

} // namespace

ChartPlot::ChartPlot(QWidget* parent) : QWidget(parent), m_plot(new QCustomPlot)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_plot);
    putLegendAbove(*m_plot);
    applyColors();
}

void ChartPlot::setChart(const ChartInfo* info, const Chart& chart)
{
    m_info = info;
    m_chart = chart;
    draw();
}

int ChartPlot::curveCount() const
{
    return static_cast<int>(std::ranges::count_if(m_chart.series, [](const ChartSeries& series) {
        return std::ranges::any_of(series.y, [](double y) { return std::isfinite(y); });
    }));
}

double ChartPlot::placeOf(double value) const { return value == 0 && m_zeroPlace > 0 ? m_zeroPlace : value; }

QPointF ChartPlot::placeOf(std::size_t series, std::size_t i) const
{
    return {m_plot->xAxis->coordToPixel(m_chart.x[i]),
            m_plot->yAxis->coordToPixel(placeOf(m_chart.series[series].y[i]))};
}

void ChartPlot::setRanges()
{
    double left = std::numeric_limits<double>::infinity();
    double right = -left;
    double least = left; // above 0
    double most = 0;
    bool hasZero = false;
    for (const double x : m_chart.x) {
        left = std::min(left, x);
        right = std::max(right, x);
    }
    for (const ChartSeries& series : m_chart.series)
        for (const double y : series.y) {
            hasZero |= y == 0;
            if (y > 0)
                least = std::min(least, y);
            if (std::isfinite(y))
                most = std::max(most, y);
        }
    if (most == 0) {
        least = 0.1;
        most = 1;
    }
    if (left > right) {
        left = 1;
        right = 10;
    }
    const double decade = std::pow(10, std::floor(std::log10(least)));
    m_zeroPlace = m_info != nullptr && m_info->yLogarithmic && hasZero ? decade / 10 : 0;
    setScale(*m_plot->xAxis, m_info != nullptr && m_info->xLogarithmic);
    setScale(*m_plot->yAxis, m_info != nullptr && m_info->yLogarithmic, m_zeroPlace);
    constexpr double kRoom = 1.2;
    if (m_info != nullptr && m_info->xLogarithmic)
        m_plot->xAxis->setRange(left / kRoom, right * kRoom);
    else
        m_plot->xAxis->setRange(left - (right - left) / 40, right + (right - left) / 40);
    if (m_info != nullptr && m_info->yLogarithmic)
        m_plot->yAxis->setRange((m_zeroPlace > 0 ? m_zeroPlace : least) / kRoom, most * 1.5);
    else
        m_plot->yAxis->setRange(-most / 40, most * 1.08);
}

void ChartPlot::draw()
{
    m_plot->clearGraphs();
    setRanges();
    for (const ChartSeries& series : m_chart.series) {
        QCPGraph* graph = m_plot->addGraph();
        graph->setName(translated(series.name));
        for (std::size_t i = 0; i < m_chart.x.size(); ++i)
            graph->addData(m_chart.x[i], std::isfinite(series.y[i]) ? placeOf(series.y[i]) : series.y[i]);
    }
    m_plot->xAxis->setLabel(m_info != nullptr ? translated(m_info->xTitle) : QString());
    m_plot->yAxis->setLabel(m_info != nullptr ? translated(m_info->yTitle) : QString());
    applyColors();
}

void ChartPlot::applyColors()
{
    applyPlotTheme(*m_plot, palette());
    const Inks inks = inksFor(palette());
    const std::array colors{inks.plus, inks.minus, inks.third, palette().color(QPalette::Text),
                            palette().color(QPalette::PlaceholderText)};
    for (int i = 0; i < m_plot->graphCount(); ++i) {
        const auto place = static_cast<std::size_t>(i);
        const QColor color = colors[place % colors.size()];
        const bool measured = m_chart.series[place].measured;
        m_plot->graph(i)->setPen(QPen(color, 1.6, measured ? Qt::SolidLine : Qt::DashLine));
        m_plot->graph(i)->setScatterStyle(
            measured ? QCPScatterStyle(kMarks[place % kMarks.size()], color, color, kDotSize) : QCPScatterStyle());
    }
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void ChartPlot::paintTo(QPainter& painter, QSize size)
{
    QPicture picture; // QCustomPlot draws with a painter of its own kind
    QCPPainter recorder(&picture);
    m_plot->toPainter(&recorder, size.width(), size.height());
    recorder.end();
    painter.fillRect(QRect(QPoint(0, 0), size), palette().color(QPalette::Base));
    painter.drawPicture(0, 0, picture);
}

void ChartPlot::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void ChartPlot::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    switch (event->type()) {
    case QEvent::PaletteChange:
    case QEvent::FontChange:
    case QEvent::StyleChange: applyColors(); break;
    case QEvent::LanguageChange: draw(); break;
    default: break;
    }
}

} // namespace rasterlens
