#include "app/cli/distance_plot.h"

#include "app/cli/figure_bytes.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace rasterlens::cli
{
namespace
{

// pixels
constexpr QSize kFigure(900, 520);
constexpr QMargins kMargins(96, 56, 40, 72);
constexpr double kTextHeight = 22;

const QColor kInk(0x22, 0x22, 0x22);
const QColor kGrid(0xdd, 0xdd, 0xdd);
// Colours that the colour-blind can tell apart.
const QColor kFloat32(0xd5, 0x5e, 0x00);
const QColor kRecentred(0x00, 0x72, 0xb2);

/// Whole decades onto pixels.
struct DecadeAxis {
    int first;
    int last;
    double begin;
    double end;

    [[nodiscard]] double at(double value) const
    {
        return std::lerp(begin, end, (std::log10(value) - first) / (last - first));
    }
};

DecadeAxis decades(const std::vector<double>& values, double begin, double end)
{
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const int first = static_cast<int>(std::floor(std::log10(*low)));
    return {first, std::max(first + 1, static_cast<int>(std::ceil(std::log10(*high)))), begin, end};
}

class DistancePlot
{
public:
    DistancePlot(QPainter& painter, std::span<const DistanceRow> rows, double stepPixels)
        : m_painter(painter), m_area(QRectF(QPointF(0, 0), kFigure).marginsRemoved(kMargins)), m_rows(rows),
          m_step(stepPixels), m_x(decades(distances(), m_area.left(), m_area.right())),
          m_y(decades(errors(), m_area.bottom(), m_area.top()))
    {
    }

    void paint(const QString& scene)
    {
        paintAxes();
        text({m_area.left(), m_area.top() - 40, m_area.width(), kTextHeight}, Qt::AlignLeft | Qt::AlignVCenter,
             QStringLiteral("%1, moved away from 0").arg(scene));
        const double step = m_y.at(m_step);
        line(QPen(kInk, 1, Qt::DashLine), {m_area.left(), step}, {m_area.right(), step});
        text({m_area.left() + 8, step - kTextHeight, m_area.width(), kTextHeight}, Qt::AlignLeft | Qt::AlignVCenter,
             QStringLiteral("one step of snapping, %1 px").arg(m_step));
        paintSeries(&DistanceRow::float32, kFloat32, QStringLiteral("positions as float32 from 0"), 0);
        paintSeries(&DistanceRow::recentred, kRecentred, QStringLiteral("recentred in double, then float32"), 1);
    }

private:
    [[nodiscard]] std::vector<double> distances() const
    {
        std::vector<double> values;
        for (const DistanceRow& row : m_rows)
            values.push_back(1 / row.relativeSize);
        return values;
    }

    [[nodiscard]] std::vector<double> errors() const
    {
        std::vector<double> values{m_step};
        for (const DistanceRow& row : m_rows)
            for (const double error : {row.recentred.corner, row.float32.corner})
                if (error > 0)
                    values.push_back(error);
        return values;
    }

    void line(const QPen& pen, const QPointF& from, const QPointF& to)
    {
        m_painter.setPen(pen);
        m_painter.drawLine(from, to);
    }

    void text(const QRectF& where, int flags, const QString& words)
    {
        m_painter.setPen(kInk);
        m_painter.drawText(where, flags, words);
    }

    void paintAxes()
    {
        const QRectF& a = m_area;
        const auto power = [](int decade) { return QString::number(std::pow(10, decade), 'g', 1); };
        for (int decade = m_x.first; decade <= m_x.last; ++decade) {
            const double x = m_x.at(std::pow(10, decade));
            line(kGrid, {x, a.top()}, {x, a.bottom()});
            text({x - 40, a.bottom() + 4, 80, kTextHeight}, Qt::AlignHCenter | Qt::AlignTop, power(decade));
        }
        for (int decade = m_y.first; decade <= m_y.last; ++decade) {
            const double y = m_y.at(std::pow(10, decade));
            line(kGrid, {a.left(), y}, {a.right(), y});
            text({a.left() - 66, y - kTextHeight / 2, 60, kTextHeight}, Qt::AlignRight | Qt::AlignVCenter,
                 power(decade));
        }
        m_painter.setPen(kInk);
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawRect(a);
        text({a.left(), a.bottom() + 34, a.width(), kTextHeight}, Qt::AlignCenter,
             QStringLiteral("distance from 0, in sizes of the model"));
        m_painter.save();
        m_painter.translate(a.left() - 78, a.center().y());
        m_painter.rotate(-90);
        text({-200, -kTextHeight / 2, 400, kTextHeight}, Qt::AlignCenter,
             QStringLiteral("largest error of a corner, pixels"));
        m_painter.restore();
    }

    void paintSeries(DistanceError DistanceRow::*series, const QColor& color, const QString& name, int place)
    {
        constexpr double kDot = 3.5;
        QPolygonF points;
        for (const DistanceRow& row : m_rows)
            if (const double error = (row.*series).corner; error > 0)
                points << QPointF(m_x.at(1 / row.relativeSize), m_y.at(error));
        m_painter.setPen(QPen(color, 1.8));
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawPolyline(points);
        m_painter.setBrush(color);
        for (const QPointF& point : points)
            m_painter.drawEllipse(point, kDot, kDot);
        const QPointF legend(m_area.left() + 20, m_area.top() + 20 + place * kTextHeight);
        m_painter.drawEllipse(legend, kDot, kDot);
        text({legend.x() + 14, legend.y() - kTextHeight / 2, 400, kTextHeight}, Qt::AlignLeft | Qt::AlignVCenter, name);
    }

    QPainter& m_painter;
    QRectF m_area;
    std::span<const DistanceRow> m_rows;
    double m_step;
    DecadeAxis m_x;
    DecadeAxis m_y;
};

void paintFigure(QPainter& painter, std::span<const DistanceRow> rows, const QString& scene, double stepPixels)
{
    painter.fillRect(QRect({0, 0}, kFigure), Qt::white);
    DistancePlot(painter, rows, stepPixels).paint(scene);
}

} // namespace

QByteArray distanceFigure(std::span<const DistanceRow> rows, const QString& scene, double stepPixels,
                          const QByteArray& format)
{
    return figureBytes(format, kFigure, QStringLiteral("Error against distance from the origin"),
                       [&](QPainter& painter) { paintFigure(painter, rows, scene, stepPixels); });
}

} // namespace rasterlens::cli
