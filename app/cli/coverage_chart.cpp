#include "app/cli/coverage_chart.h"

#include "app/cli/failure.h"
#include "app/cli/figure_bytes.h"
#include "app/cli/output.h"
#include "core/render/render.h"
#include "core/truth/coverage_chart.h"

#include <QPainter>

#include <algorithm>
#include <cmath>

namespace rasterlens::cli
{
namespace
{

QString nameOf(Samples samples)
{
    Settings settings;
    settings.samples = samples;
    return valueId(*findSettingsField(QStringLiteral("samples")), settings);
}

QString tableOf(const Input& input, std::span<const CoverageRow> rows)
{
    QString text =
        QStringLiteral("%1, %2x%3: covered samples against the covered area of %4 pixels that are covered in "
                       "part\n")
            .arg(input.scene.id)
            .arg(input.settings.size.width())
            .arg(input.settings.size.height())
            .arg(rows.empty() ? 0 : rows.front().pixels);
    const auto cells = [](const QStringList& words) {
        constexpr int kWidth = 12;
        QString line;
        for (const QString& word : words)
            line += word.rightJustified(kWidth);
        return line + QLatin1Char('\n');
    };
    text += cells({QStringLiteral("samples"), QStringLiteral("a pixel"), QStringLiteral("rms"), QStringLiteral("mean"),
                   QStringLiteral("largest")});
    const auto number = [](double value) { return QString::number(value, 'f', 4); };
    for (const CoverageRow& row : rows)
        text += cells({nameOf(row.samples), QString::number(samplesPerPixel(row.samples)), number(row.rms),
                       number(row.mean), number(row.largest)});
    return text;
}

// pixels
constexpr QSize kFigure(720, 460);
constexpr QRectF kArea(84, 48, 600, 340);
constexpr double kTextHeight = 22;
const QColor kInk(0x22, 0x22, 0x22);
const QColor kGrid(0xdd, 0xdd, 0xdd);

/// Samples a pixel to the right, the error upwards, both by factors of two.
class CoveragePlot
{
public:
    CoveragePlot(QPainter& painter, std::span<const CoverageRow> rows) : m_painter(painter), m_rows(rows) {}

    void paint(const QString& scene)
    {
        m_painter.fillRect(QRect({0, 0}, kFigure), Qt::white);
        paintAxes();
        text({kArea.left(), 12, kArea.width(), kTextHeight}, Qt::AlignLeft | Qt::AlignVCenter,
             QStringLiteral("%1: covered samples against covered area").arg(scene));
        paintSeries(QColor(0xd5, 0x5e, 0x00), QStringLiteral("grids"), 0,
                    [](Samples samples) { return patternSamples(samples) == 1; });
        paintSeries(QColor(0x00, 0x72, 0xb2), QStringLiteral("patterns of MSAA"), 1,
                    [](Samples samples) { return patternSamples(samples) > 1; });
    }

private:
    static constexpr double kLog2Most = 4;   // samples a pixel
    static constexpr double kLog2Least = -7; // of the error
    static constexpr double kLog2Largest = -1;

    [[nodiscard]] QPointF at(int samples, double error) const
    {
        const double up = (std::log2(std::max(error, 0x1p-7)) - kLog2Least) / (kLog2Largest - kLog2Least);
        return {kArea.left() + kArea.width() * std::log2(samples) / kLog2Most, kArea.bottom() - kArea.height() * up};
    }

    void text(const QRectF& where, int flags, const QString& words)
    {
        m_painter.setPen(kInk);
        m_painter.drawText(where, flags, words);
    }

    void paintAxes()
    {
        for (int samples = 1; samples <= 16; samples *= 2) {
            const double x = at(samples, 0.5).x();
            m_painter.setPen(kGrid);
            m_painter.drawLine(QPointF(x, kArea.top()), QPointF(x, kArea.bottom()));
            text({x - 40, kArea.bottom() + 4, 80, kTextHeight}, Qt::AlignHCenter | Qt::AlignTop,
                 QString::number(samples));
        }
        for (int power = int(kLog2Least); power <= int(kLog2Largest); ++power) {
            const double y = at(1, std::exp2(power)).y();
            m_painter.setPen(kGrid);
            m_painter.drawLine(QPointF(kArea.left(), y), QPointF(kArea.right(), y));
            text({kArea.left() - 74, y - kTextHeight / 2, 66, kTextHeight}, Qt::AlignRight | Qt::AlignVCenter,
                 QString::number(std::exp2(power)));
        }
        text({kArea.left(), kArea.bottom() + 32, kArea.width(), kTextHeight}, Qt::AlignCenter,
             QStringLiteral("samples a pixel; upwards the rms error in pixels' areas"));
    }

    template <class Belongs>
    void paintSeries(const QColor& color, const QString& name, int place, Belongs belongs)
    {
        constexpr double kDot = 3.5;
        QPolygonF points;
        for (const CoverageRow& row : m_rows)
            if (belongs(row.samples))
                points << at(samplesPerPixel(row.samples), row.rms);
        m_painter.setPen(QPen(color, 1.8));
        m_painter.setBrush(Qt::NoBrush);
        m_painter.drawPolyline(points);
        m_painter.setBrush(color);
        for (const QPointF& point : points)
            m_painter.drawEllipse(point, kDot, kDot);
        const QPointF legend(kArea.right() - 180, kArea.top() + 20 + place * kTextHeight);
        m_painter.drawEllipse(legend, kDot, kDot);
        text({legend.x() + 14, legend.y() - kTextHeight / 2, 160, kTextHeight}, Qt::AlignLeft | Qt::AlignVCenter, name);
    }

    QPainter& m_painter;
    std::span<const CoverageRow> m_rows;
};

} // namespace

void printCoverageChart(const Input& input, const Arguments& arguments)
{
    Settings patterns = input.settings;
    patterns.samples = Samples::Msaa16;
    if (const auto reason = unsupported(input.scene, patterns))
        failArguments(QStringLiteral("rasterlens-cli bench: --chart msaa: %1").arg(textOf(*reason)));
    const QString csv = arguments.value(QStringLiteral("--csv")).value_or(QString());
    const QString json = arguments.value(QStringLiteral("--json")).value_or(QString());
    const QString plot = arguments.value(QStringLiteral("--plot")).value_or(QString());
    const std::vector<CoverageRow> rows = coverageChart(input.scene, input.settings);
    if (!QStringList{csv, json, plot}.contains(QStringLiteral("-")))
        printText(tableOf(input, rows));
    OutputFiles files;
    if (!csv.isEmpty())
        files.add(csv, coverageCsv(rows));
    if (!json.isEmpty())
        files.add(json, coverageJson(rows));
    if (!plot.isEmpty())
        files.add(plot, figureBytes(plot.endsWith(QLatin1String(".png"), Qt::CaseInsensitive) ? "png" : "svg", kFigure,
                                    QStringLiteral("Error of coverage"),
                                    [&](QPainter& painter) { CoveragePlot(painter, rows).paint(input.scene.id); }));
    files.write();
}

} // namespace rasterlens::cli
