#include "app/cli/chart_figure.h"

#include "app/cli/figure_bytes.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rasterlens::cli
{
namespace
{

// pixels
constexpr QSize kFigure(900, 600);
constexpr QMargins kMargins(96, 48, 40, 176);
constexpr double kTextHeight = 22;
constexpr double kLegendWidth = 380;

const QColor kInk(0x22, 0x22, 0x22);
const QColor kGrid(0xdd, 0xdd, 0xdd);
// Colours that the colour-blind can tell apart.
const std::array kColors{QColor(0x00, 0x72, 0xb2), QColor(0xd5, 0x5e, 0x00), QColor(0x00, 0x9e, 0x73),
                         QColor(0xcc, 0x79, 0xa7), QColor(0x55, 0x55, 0x55), QColor(0xb0, 0x80, 0x00)};

/// Values onto pixels, by their logarithm to base 10 or as they are, with a tick a decade or a round number.
struct Axis {
    bool logarithmic;
    double low; ///< a power where logarithmic
    double high;
    double step;
    double begin; ///< pixels
    double end;

    [[nodiscard]] double at(double value) const
    {
        const double place = !logarithmic ? value : value > 0 ? std::log10(value) : low;
        return std::lerp(begin, end, (std::clamp(place, low, high) - low) / (high - low));
    }
    [[nodiscard]] double valueOf(double tick) const { return logarithmic ? std::pow(10, tick) : tick; }
};

/// 1, 2 or 5 times a power of ten that divides a length into at most eight parts.
double roundStep(double length)
{
    constexpr int kMostParts = 8;
    const double power = std::pow(10, std::floor(std::log10(length / kMostParts)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (length / (factor * power) <= kMostParts)
            return factor * power;
    return 10 * power;
}

Axis axisOf(const std::vector<double>& values, bool logarithmic, double begin, double end)
{
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const double value : values)
        if (std::isfinite(value) && (!logarithmic || value > 0)) {
            low = std::min(low, logarithmic ? std::log10(value) : value);
            high = std::max(high, logarithmic ? std::log10(value) : value);
        }
    if (low > high)
        low = high = 0;
    if (logarithmic) {
        low = std::floor(low);
        high = std::max(low + 1, std::ceil(high));
        return {true, low, high, std::max(1.0, std::ceil((high - low) / 8)), begin, end};
    }
    low = std::min(low, 0.0);
    high = std::max(high, low + 1);
    const double step = roundStep(high - low);
    return {false, low, std::ceil(high / step) * step, step, begin, end};
}

std::vector<double> allOf(const Chart& chart)
{
    std::vector<double> values;
    for (const ChartSeries& series : chart.series)
        values.insert(values.end(), series.y.begin(), series.y.end());
    return values;
}

class ChartPainter
{
public:
    ChartPainter(QPainter& painter, const ChartInfo& info, const Chart& chart)
        : m_painter(painter), m_info(info), m_chart(chart),
          m_area(QRectF(QPointF(0, 0), kFigure).marginsRemoved(kMargins)),
          m_x(axisOf(chart.x, info.xLogarithmic, m_area.left(), m_area.right())),
          m_y(axisOf(allOf(chart), info.yLogarithmic, m_area.bottom(), m_area.top()))
    {
    }

    void paint(const QString& title)
    {
        m_painter.fillRect(QRect({0, 0}, kFigure), Qt::white);
        text({m_area.left(), 12, m_area.width(), kTextHeight}, Qt::AlignLeft | Qt::AlignVCenter, title);
        paintAxes();
        for (std::size_t i = 0; i < m_chart.series.size(); ++i)
            paintSeries(m_chart.series[i], i);
    }

private:
    void text(const QRectF& where, int flags, const QString& words)
    {
        m_painter.setPen(kInk);
        m_painter.drawText(where, flags, words);
    }

    void paintAxes()
    {
        const QRectF& a = m_area;
        const auto numberOf = [](double value) { return QString::number(value, 'g', 3); };
        constexpr double kRounding = 1e-9;
        for (double tick = m_x.low; tick <= m_x.high + kRounding; tick += m_x.step) {
            const double x = m_x.at(m_x.valueOf(tick));
            m_painter.setPen(kGrid);
            m_painter.drawLine(QPointF(x, a.top()), QPointF(x, a.bottom()));
            text({x - 40, a.bottom() + 4, 80, kTextHeight}, Qt::AlignHCenter | Qt::AlignTop,
                 numberOf(m_x.valueOf(tick)));
        }
        const bool hasZero = m_y.logarithmic && std::ranges::any_of(allOf(m_chart), [](double v) { return v == 0; });
        for (double tick = m_y.low; tick <= m_y.high + kRounding; tick += m_y.step) {
            const double y = m_y.at(m_y.valueOf(tick));
            m_painter.setPen(kGrid);
            m_painter.drawLine(QPointF(a.left(), y), QPointF(a.right(), y));
            text({a.left() - 86, y - kTextHeight / 2, 80, kTextHeight}, Qt::AlignRight | Qt::AlignVCenter,
                 hasZero && tick == m_y.low ? QStringLiteral("0") : numberOf(m_y.valueOf(tick)));
        }
        m_painter.setPen(kInk);
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawRect(a);
        text({a.left(), a.bottom() + 26, a.width(), kTextHeight}, Qt::AlignCenter, QLatin1String(m_info.xTitle));
        m_painter.save();
        m_painter.translate(20, a.center().y());
        m_painter.rotate(-90);
        text({-200, -kTextHeight / 2, 400, kTextHeight}, Qt::AlignCenter, QLatin1String(m_info.yTitle));
        m_painter.restore();
    }

    void paintSeries(const ChartSeries& series, std::size_t place)
    {
        constexpr double kDot = 3.5;
        const QColor color = kColors[place % kColors.size()];
        QPolygonF points;
        for (std::size_t i = 0; i < m_chart.x.size(); ++i)
            if (std::isfinite(series.y[i]))
                points << QPointF(m_x.at(m_chart.x[i]), m_y.at(series.y[i]));
        const QPen pen(color, series.measured ? 1.8 : 1.2, series.measured ? Qt::SolidLine : Qt::DashLine);
        m_painter.setPen(pen);
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawPolyline(points);
        const QPointF legend(m_area.left() + static_cast<double>(place % 2) * kLegendWidth,
                             m_area.bottom() + 68 + static_cast<double>(place / 2) * kTextHeight);
        m_painter.drawLine(legend, legend + QPointF(24, 0));
        text({legend.x() + 32, legend.y() - kTextHeight / 2, kLegendWidth - 32, kTextHeight},
             Qt::AlignLeft | Qt::AlignVCenter, QString::fromUtf8(series.name));
        if (!series.measured)
            return;
        m_painter.setPen(pen);
        m_painter.setBrush(color);
        for (const QPointF& point : points)
            m_painter.drawEllipse(point, kDot, kDot);
    }

    QPainter& m_painter;
    const ChartInfo& m_info;
    const Chart& m_chart;
    QRectF m_area;
    Axis m_x;
    Axis m_y;
};

} // namespace

QByteArray chartFigure(const ChartInfo& info, const Chart& chart, const QString& scene, const QByteArray& format)
{
    const QString title = QLatin1String(info.title);
    return figureBytes(format, kFigure, title, [&](QPainter& painter) {
        ChartPainter(painter, info, chart).paint(scene.isEmpty() ? title : QStringLiteral("%1: %2").arg(scene, title));
    });
}

} // namespace rasterlens::cli
