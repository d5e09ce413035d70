#include "app/cli/chart.h"

#include "app/cli/chart_figure.h"
#include "app/cli/failure.h"
#include "app/cli/output.h"

#include <cmath>

namespace rasterlens::cli
{
namespace
{

QString tableOf(const ChartInfo& info, const Chart& chart, const Input& input)
{
    constexpr int kFirst = 12;
    constexpr int kWidth = 10;
    QString text = QLatin1String(info.title) + QLatin1String(": ") + QLatin1String(info.yTitle) +
                   QLatin1String(" over ") + QLatin1String(info.xTitle) + QLatin1Char('\n');
    if (info.aboutScene)
        text += QStringLiteral("%1, %2x%3\n")
                    .arg(input.scene.id)
                    .arg(input.settings.size.width())
                    .arg(input.settings.size.height());
    for (std::size_t k = 0; k < chart.series.size(); ++k)
        text += QStringLiteral("  %1: %2\n").arg(k + 1).arg(QString::fromUtf8(chart.series[k].name));
    const auto number = [](double value) {
        return std::isfinite(value) ? QString::number(value, 'g', 4) : QStringLiteral("-");
    };
    text += QString(kFirst, QLatin1Char(' '));
    for (std::size_t k = 0; k < chart.series.size(); ++k)
        text += QString::number(k + 1).rightJustified(kWidth);
    text += QLatin1Char('\n');
    for (std::size_t i = 0; i < chart.x.size(); ++i) {
        text += number(chart.x[i]).rightJustified(kFirst);
        for (const ChartSeries& series : chart.series)
            text += number(series.y[i]).rightJustified(kWidth);
        text += QLatin1Char('\n');
    }
    for (const Reason& note : chart.notes)
        text += textOf(note) + QLatin1Char('\n');
    return text;
}

} // namespace

void printChart(const ChartInfo& info, const Input& input, const Arguments& arguments)
{
    if (const auto reason = whyNoChart(info, input.scene, input.settings))
        failArguments(
            QStringLiteral("rasterlens-cli bench: --chart %1: %2").arg(QLatin1String(info.id), textOf(*reason)));
    const QString csv = arguments.value(QStringLiteral("--csv")).value_or(QString());
    const QString json = arguments.value(QStringLiteral("--json")).value_or(QString());
    const QString plot = arguments.value(QStringLiteral("--plot")).value_or(QString());
    const Chart chart = info.make(input.scene, input.settings, {});
    if (!QStringList{csv, json, plot}.contains(QStringLiteral("-")))
        printText(tableOf(info, chart, input));
    OutputFiles files;
    if (!csv.isEmpty())
        files.add(csv, chartCsv(chart));
    if (!json.isEmpty())
        files.add(json, chartJson(info, chart));
    if (!plot.isEmpty())
        files.add(plot, chartFigure(info, chart, info.aboutScene ? input.scene.id : QString(),
                                    plot.endsWith(QLatin1String(".png"), Qt::CaseInsensitive) ? "png" : "svg"));
    files.write();
}

} // namespace rasterlens::cli
