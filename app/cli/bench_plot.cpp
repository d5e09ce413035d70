#include "app/cli/bench_plot.h"

#include "app/cli/output.h"

#include <QBuffer>
#include <QGuiApplication>
#include <QPainter>
#include <QPainterPath>
#include <QSvgGenerator>

#include <algorithm>
#include <cmath>

namespace rasterlens::cli
{
namespace
{

// pixels
constexpr QSize kPanel(1000, 560);
constexpr QMargins kMargins(88, 48, 196, 64);
constexpr double kZeroBand = 56; ///< where dots without error stand
constexpr double kDot = 4.5;
constexpr int kFontPixels = 13;
constexpr int kLabelHeight = 16;

const QColor kInk(0x22, 0x22, 0x22);
const QColor kGrid(0xdd, 0xdd, 0xdd);

/// Colours that the colour-blind can tell apart, and a shape each.
struct Look {
    const char* name;
    QRgb color;
};
constexpr Look kLooks[] = {
    {"edge equation", 0xff0072b2}, {"edge walking", 0xffd55e00}, {"tiled", 0xff009e73}, {"column fill", 0xffcc79a7}};

constexpr Look kOtherLook{"other renderers", 0xff444444};

const Look& lookOf(const ExperimentRow& row)
{
    return row.other ? kOtherLook : kLooks[static_cast<std::size_t>(row.settings.algorithm)];
}

/// Values from low to high, in 1, 2, 5 steps of decades, onto pixels from begin to end.
class LogAxis
{
public:
    LogAxis(const std::vector<double>& values, double begin, double end) : m_begin(begin), m_end(end)
    {
        const auto [low, high] = std::minmax_element(values.begin(), values.end());
        m_low = values.empty() ? 1 : roundedDown(*low / 1.1);
        const double above = values.empty() ? 10 : 1 / roundedDown(1 / (*high * 1.1));
        m_high = std::max(above, 10 * m_low);
    }

    [[nodiscard]] double at(double value) const
    {
        return std::lerp(m_begin, m_end, std::log(value / m_low) / std::log(m_high / m_low));
    }

    /// Decades, and where there are few of them also 2 and 5.
    [[nodiscard]] std::vector<double> ticks() const
    {
        const int first = static_cast<int>(std::floor(std::log10(m_low)));
        const int last = static_cast<int>(std::ceil(std::log10(m_high)));
        const int decadesApart = 1 + (last - first) / 9;
        std::vector<double> ticks;
        for (int decade = first; decade <= last; decade += decadesApart)
            for (const double step : {1.0, 2.0, 5.0})
                if (const double tick = step * std::pow(10, decade);
                    tick >= m_low * 0.999 && tick <= m_high * 1.001 && (step == 1 || last - first <= 3))
                    ticks.push_back(tick);
        return ticks;
    }

private:
    static double roundedDown(double value)
    {
        const double decade = std::pow(10, std::floor(std::log10(value)));
        const double mantissa = value / decade;
        return decade * (mantissa >= 5 ? 5 : mantissa >= 2 ? 2 : 1);
    }

    double m_begin;
    double m_end;
    double m_low;
    double m_high;
};

struct Dot {
    QPointF at;
    double top;    ///< of the bar, pixels
    double bottom; ///< of the bar, pixels
    const ExperimentRow* row;
};

/// One scene.
class Panel
{
public:
    Panel(QPainter& painter, const QRectF& where, std::span<const ExperimentRow> rows, ErrorMeasure measure)
        : m_painter(painter), m_area(where.marginsRemoved(kMargins)), m_measure(measure)
    {
        std::vector<double> errors;
        std::vector<double> times;
        for (const ExperimentRow& row : rows)
            if (const auto error = errorOf(row, measure); error && row.nsPerCoveredPixel > 0) {
                m_rows.push_back(&row);
                times.insert(times.end(), {ns(row, row.ms.p10), ns(row, row.ms.p90)});
                if (*error > 0)
                    errors.push_back(*error);
            }
        m_hasZero = errors.size() < m_rows.size();
        m_x.emplace(errors, m_area.left() + (m_hasZero ? kZeroBand : 0), m_area.right());
        m_y.emplace(times, m_area.bottom(), m_area.top());
        m_title = rows.empty() ? QString() : rows.front().scene;
    }

    void paint()
    {
        if (m_rows.empty()) {
            text(m_area, Qt::AlignCenter, m_title + QStringLiteral(": this error was not measured"));
            return;
        }
        if (isExactThroughout(rowsShown(), m_measure)) {
            text(m_area, Qt::AlignCenter,
                 QStringLiteral("%1: every variant is exact here, all of these errors are 0").arg(m_title));
            return;
        }
        paintAxes();
        std::vector<Dot> dots;
        for (const ExperimentRow* row : m_rows)
            dots.push_back(dotOf(*row));
        std::stable_partition(dots.begin(), dots.end(), [](const Dot& dot) { return !dot.row->frontier; });
        for (const Dot& dot : dots)
            paintDot(dot);
        paintLabels(dots);
        paintLegend();
    }

private:
    [[nodiscard]] std::vector<ExperimentRow> rowsShown() const
    {
        std::vector<ExperimentRow> rows;
        for (const ExperimentRow* row : m_rows)
            rows.push_back(*row);
        return rows;
    }

    /// A time as ns per covered pixel, scaled as the median is.
    static double ns(const ExperimentRow& row, double ms) { return row.nsPerCoveredPixel * ms / row.ms.median; }

    Dot dotOf(const ExperimentRow& row) const
    {
        const double error = *errorOf(row, m_measure);
        const double x = error > 0 ? m_x->at(error) : m_area.left() + kZeroBand / 2;
        return {{x, m_y->at(row.nsPerCoveredPixel)}, m_y->at(ns(row, row.ms.p90)), m_y->at(ns(row, row.ms.p10)), &row};
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
        constexpr double kTickText = 22;
        const QRectF& a = m_area;
        for (const double tick : m_x->ticks()) {
            const double x = m_x->at(tick);
            line(kGrid, {x, a.top()}, {x, a.bottom()});
            text({x - 40, a.bottom() + 4, 80, kTickText}, Qt::AlignHCenter | Qt::AlignTop, QString::number(tick));
        }
        for (const double tick : m_y->ticks()) {
            const double y = m_y->at(tick);
            line(kGrid, {a.left(), y}, {a.right(), y});
            text({a.left() - 66, y - kTickText / 2, 60, kTickText}, Qt::AlignRight | Qt::AlignVCenter,
                 QString::number(tick));
        }
        if (m_hasZero) {
            line(QPen(kInk, 1, Qt::DashLine), {a.left() + kZeroBand, a.top()}, {a.left() + kZeroBand, a.bottom()});
            text({a.left(), a.bottom() + 4, kZeroBand - 10, kTickText}, Qt::AlignHCenter | Qt::AlignTop,
                 QStringLiteral("0"));
        }
        m_painter.setPen(kInk);
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawRect(a);
        text({a.left(), a.bottom() + 30, a.width(), kTickText}, Qt::AlignCenter,
             QString::fromUtf8(infoOf(m_measure).title));
        text({a.left(), a.top() - 34, a.width(), kTickText}, Qt::AlignLeft | Qt::AlignVCenter, m_title);
        m_painter.save();
        m_painter.translate(a.left() - 72, a.center().y());
        m_painter.rotate(-90);
        text({-200, -kTickText / 2, 400, kTickText}, Qt::AlignCenter, QStringLiteral("ns per covered pixel"));
        m_painter.restore();
    }

    void paintDot(const Dot& dot)
    {
        const QColor color = QColor::fromRgb(lookOf(*dot.row).color);
        line(QPen(color, 1.2), {dot.at.x(), dot.top}, {dot.at.x(), dot.bottom});
        paintMark(dot.at, *dot.row, dot.row->frontier);
    }

    /// Filled on the frontier, hollow elsewhere.
    void paintMark(const QPointF& at, const ExperimentRow& row, bool filled)
    {
        const QColor color = QColor::fromRgb(lookOf(row).color);
        m_painter.setPen(QPen(color, 1.5));
        m_painter.setBrush(filled ? color : QColor(Qt::white));
        const auto polygon = [&](std::initializer_list<QPointF> corners) {
            QPolygonF moved;
            for (const QPointF& corner : corners)
                moved << at + kDot * corner;
            m_painter.drawPolygon(moved);
        };
        if (row.other) {
            polygon({{-1, -1.2}, {0, -0.4}, {1, -1.2}, {1, 1.2}, {0, 0.4}, {-1, 1.2}});
            return;
        }
        switch (row.settings.algorithm) {
        case Algorithm::EdgeEquation: m_painter.drawEllipse(at, kDot, kDot); break;
        case Algorithm::EdgeWalking: polygon({{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}); break;
        case Algorithm::Tiled: polygon({{0, -1.3}, {1.2, 1}, {-1.2, 1}}); break;
        case Algorithm::ColumnFill: polygon({{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}}); break;
        }
    }

    /// Whether the dot is to have a name: those that none beats, what each algorithm does by default, other renderers.
    static bool isNamed(const ExperimentRow& row)
    {
        const auto is = [&](const char* id) { return row.variant == QLatin1String(id); };
        return row.frontier || row.other || is("edge-equation") || is("edge-walking") || is("tiled");
    }

    /// Names beside, above or below their dots, as far as there is room; those on the frontier first.
    void paintLabels(const std::vector<Dot>& dots)
    {
        constexpr double kGap = 7;
        const QFontMetricsF metrics(m_painter.font());
        std::vector<QRectF> taken;
        for (const Dot& dot : dots)
            if (isNamed(*dot.row))
                taken.emplace_back(dot.at - QPointF(kDot, kDot), QSizeF(2 * kDot, 2 * kDot));
        for (auto dot = dots.rbegin(); dot != dots.rend(); ++dot) { // the frontier comes last
            if (!isNamed(*dot->row))
                continue;
            const QSizeF size(metrics.horizontalAdvance(dot->row->variant), kLabelHeight);
            for (const QPointF& way :
                 {QPointF(kGap, -size.height() / 2), QPointF(-kGap - size.width(), -size.height() / 2),
                  QPointF(kGap, -size.height() - kGap), QPointF(-kGap - size.width(), -size.height() - kGap),
                  QPointF(kGap, kGap), QPointF(-kGap - size.width(), kGap)}) {
                const QRectF place(dot->at + way, size);
                if (!m_area.contains(place) ||
                    std::ranges::any_of(taken, [&](const QRectF& other) { return other.intersects(place); }))
                    continue;
                taken.push_back(place);
                label({place.left(), place.bottom() - metrics.descent()}, dot->row->variant);
                break;
            }
        }
    }

    /// Readable on lines and dots.
    void label(const QPointF& at, const QString& words)
    {
        QPainterPath path;
        path.addText(at, m_painter.font(), words);
        m_painter.strokePath(path, QPen(Qt::white, 3));
        m_painter.setPen(kInk);
        m_painter.drawText(at, words);
    }

    void paintLegend()
    {
        double y = m_area.top() + 8;
        const double x = m_area.right() + 20;
        std::vector<ExperimentRow> kinds(3);
        kinds[1].settings.algorithm = Algorithm::EdgeWalking;
        kinds[2].settings.algorithm = Algorithm::Tiled;
        if (const auto other =
                std::ranges::find_if(m_rows, [](const ExperimentRow* row) { return row->other.has_value(); });
            other != m_rows.end())
            kinds.push_back(**other);
        for (const ExperimentRow& kind : kinds) {
            paintMark({x, y}, kind, true);
            text({x + 14, y - 11, 160, 22}, Qt::AlignVCenter | Qt::AlignLeft, QLatin1String(lookOf(kind).name));
            y += 24;
        }
        for (const char* words : {"filled: none as exact was", "faster in 9 of 10 rounds", "bars: p10 to p90"}) {
            text({x - 6, y - 11, 186, 22}, Qt::AlignVCenter | Qt::AlignLeft, QLatin1String(words));
            y += 24;
        }
    }

    QPainter& m_painter;
    QRectF m_area;
    ErrorMeasure m_measure;
    QString m_title;
    std::vector<const ExperimentRow*> m_rows;
    bool m_hasZero = false;
    std::optional<LogAxis> m_x;
    std::optional<LogAxis> m_y;
};

/// The rows scene by scene.
std::vector<std::span<const ExperimentRow>> scenesOf(std::span<const ExperimentRow> rows)
{
    std::vector<std::span<const ExperimentRow>> scenes;
    for (auto begin = rows.begin(); begin != rows.end();) {
        const auto end =
            std::find_if(begin, rows.end(), [&](const ExperimentRow& r) { return r.scene != begin->scene; });
        scenes.emplace_back(begin, end);
        begin = end;
    }
    return scenes;
}

void paintFigure(QPainter& painter, const std::vector<std::span<const ExperimentRow>>& scenes, ErrorMeasure measure)
{
    QFont font = QGuiApplication::font();
    font.setPixelSize(kFontPixels);
    painter.setFont(font);
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = 0; i < scenes.size(); ++i)
        Panel(painter, QRectF(QPointF(0, kPanel.height() * static_cast<double>(i)), kPanel), scenes[i], measure)
            .paint();
}

QByteArray svgOf(QSize size, const std::vector<std::span<const ExperimentRow>>& scenes, ErrorMeasure measure)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator svg;
    svg.setOutputDevice(&buffer);
    svg.setSize(size);
    svg.setViewBox(QRect({0, 0}, size));
    svg.setTitle(QStringLiteral("Speed against error"));
    QPainter painter(&svg);
    painter.fillRect(QRect({0, 0}, size), Qt::white);
    paintFigure(painter, scenes, measure);
    painter.end();
    return bytes;
}

} // namespace

QByteArray experimentFigure(std::span<const ExperimentRow> rows, ErrorMeasure measure, const QString& format)
{
    // Fonts need an application; this one asks for no display.
    char program[] = "rasterlens-cli";
    char option[] = "-platform";
    char platform[] = "offscreen";
    char* words[] = {program, option, platform, nullptr};
    int count = 3;
    const QGuiApplication application(count, words);

    const auto scenes = scenesOf(rows);
    const QSize size(kPanel.width(), kPanel.height() * std::max(1, static_cast<int>(scenes.size())));
    if (format == QLatin1String("svg"))
        return svgOf(size, scenes, measure);
    QImage image(size, QImage::Format_RGB32);
    image.fill(Qt::white);
    QPainter painter(&image);
    paintFigure(painter, scenes, measure);
    painter.end();
    return imageBytes(image, format);
}

} // namespace rasterlens::cli
