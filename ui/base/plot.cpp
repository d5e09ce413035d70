#include "ui/base/plot.h"

#include "core/observe/step_text.h"
#include "ui/base/theme.h"

#include <QPainter>
#include <QPainterPath>
#include <QPalette>

#include <algorithm>

namespace rasterlens
{
namespace
{

constexpr double kCurveWidth = 2;
constexpr double kMarkRadius = 4;

class PlotPainter
{
public:
    PlotPainter(QPainter& painter, const QRectF& where, const Plot& plot, const QPalette& palette)
        : m_painter(painter), m_plot(plot), m_palette(palette), m_line(QFontMetricsF(textFont(-1)).lineSpacing())
    {
        m_painter.setFont(textFont(-1));
        const QFontMetricsF metrics(m_painter.font());
        const double left = 6 + std::max(metrics.horizontalAdvance(shortNumber(plot.range.top())),
                                         metrics.horizontalAdvance(shortNumber(plot.range.bottom())));
        m_title = QRectF(where.left(), where.top(), where.width(), m_line + 5);
        m_area = where.adjusted(left, 2 * m_line + 9, -8, -m_line - 4);
    }

    void paint()
    {
        if (m_area.width() < 20 || m_area.height() < 20)
            return;
        paintAxes();
        for (const PlotCurve& curve : m_plot.curves)
            paintCurve(curve);
        for (const PlotMark& mark : m_plot.marks)
            paintMark(mark);
        paintLegend();
    }

private:
    [[nodiscard]] QPointF place(QPointF value) const
    {
        const QRectF& r = m_plot.range;
        const double x = r.width() == 0 ? 0 : (value.x() - r.left()) / r.width();
        const double y = r.height() == 0 ? 0 : (value.y() - r.top()) / r.height();
        return {m_area.left() + x * m_area.width(), m_area.bottom() - y * m_area.height()};
    }

    void paintAxes()
    {
        m_painter.setRenderHint(QPainter::Antialiasing, false);
        m_painter.setPen(m_palette.color(QPalette::Mid));
        m_painter.drawRect(m_area);
        m_painter.setRenderHint(QPainter::Antialiasing);
        m_painter.setPen(m_palette.color(QPalette::Text));
        m_painter.setFont(textFont(0, true));
        m_painter.drawText(m_title, Qt::AlignLeft | Qt::AlignTop, m_plot.title);
        m_painter.setFont(textFont(-1));
        m_painter.setPen(m_palette.color(QPalette::PlaceholderText));
        const QRectF below(m_area.left(), m_area.bottom() + 2, m_area.width(), m_line);
        m_painter.drawText(below, Qt::AlignLeft, shortNumber(m_plot.range.left()));
        m_painter.drawText(below, Qt::AlignRight, shortNumber(m_plot.range.right()));
        m_painter.drawText(below, Qt::AlignHCenter, m_plot.xName);
        const double right = m_area.left() - 4;
        m_painter.drawText(QRectF(0, m_area.bottom() - m_line, right, m_line), Qt::AlignRight | Qt::AlignBottom,
                           shortNumber(m_plot.range.top()));
        m_painter.drawText(QRectF(0, m_area.top(), right, m_line), Qt::AlignRight | Qt::AlignTop,
                           shortNumber(m_plot.range.bottom()));
    }

    void paintCurve(const PlotCurve& curve)
    {
        if (curve.points.empty())
            return;
        QPainterPath path(place(curve.points.front()));
        for (const QPointF& point : curve.points)
            path.lineTo(place(point));
        m_painter.save();
        m_painter.setClipRect(m_area.adjusted(-2, -2, 2, 2));
        m_painter.setBrush(Qt::NoBrush);
        m_painter.setPen(QPen(curve.color, kCurveWidth, curve.style));
        m_painter.drawPath(path);
        m_painter.restore();
    }

    void paintMark(const PlotMark& mark)
    {
        const QPointF at = place(mark.at);
        m_painter.setPen(QPen(mark.color, 1, Qt::DotLine));
        m_painter.drawLine(at, QPointF(at.x(), m_area.bottom()));
        m_painter.drawLine(at, QPointF(m_area.left(), at.y()));
        m_painter.setPen(QPen(mark.color, 1.5));
        m_painter.setBrush(m_palette.color(QPalette::Base));
        m_painter.drawEllipse(at, kMarkRadius, kMarkRadius);
        const QFontMetricsF metrics(m_painter.font());
        const double width = metrics.horizontalAdvance(mark.text) + 2;
        double x = at.x() + 8;
        if (x + width > m_area.right())
            x = at.x() - 8 - width;
        const double y = std::clamp(at.y() + 4, m_area.top(), m_area.bottom() - m_line);
        QColor veil = m_palette.color(QPalette::Base);
        veil.setAlpha(210);
        m_painter.fillRect(QRectF(x - 2, y, width + 4, m_line), veil);
        m_painter.setPen(mark.color);
        m_painter.drawText(QRectF(x, y, width, m_line), Qt::AlignLeft | Qt::AlignVCenter, mark.text);
    }

    void paintLegend()
    {
        double x = m_area.left();
        const double y = m_title.bottom() + m_line / 2;
        const QFontMetricsF metrics(m_painter.font());
        for (const PlotCurve& curve : m_plot.curves) {
            if (curve.name.isEmpty())
                continue;
            m_painter.setPen(QPen(curve.color, kCurveWidth, curve.style));
            m_painter.drawLine(QPointF(x, y), QPointF(x + 18, y));
            m_painter.setPen(m_palette.color(QPalette::PlaceholderText));
            m_painter.drawText(QPointF(x + 22, y + metrics.ascent() / 2 - 1), curve.name);
            x += 34 + metrics.horizontalAdvance(curve.name);
        }
        m_painter.drawText(QRectF(m_area.left(), y - m_line / 2, m_area.width(), m_line),
                           Qt::AlignRight | Qt::AlignVCenter, m_plot.yName);
    }

    QPainter& m_painter;
    const Plot& m_plot;
    const QPalette& m_palette;
    double m_line;
    QRectF m_title;
    QRectF m_area;
};

} // namespace

void paintPlot(QPainter& painter, const QRectF& where, const Plot& plot, const QPalette& palette)
{
    painter.save();
    painter.translate(where.topLeft());
    PlotPainter(painter, QRectF(QPointF(0, 0), where.size()), plot, palette).paint();
    painter.restore();
}

} // namespace rasterlens
