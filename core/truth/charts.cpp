#include "core/truth/charts.h"

#include "core/pipeline/resolve.h"
#include "core/render/render.h"
#include "core/truth/chart_list.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr ChartInfo kCharts[] = {
    {"snapping", QT_TRANSLATE_NOOP("Chart", "What snapping does to faces"),
     QT_TRANSLATE_NOOP("Chart",
                       "Corners snap to 1/2^bits of a pixel: a corner may pass to the other side of the opposite "
                       "edge, and its face then looks the other way."),
     QT_TRANSLATE_NOOP("Chart", "subpixel bits"), QT_TRANSLATE_NOOP("Chart", "% of the faces"), false, true, true,
     snappingChart},
    {"depth-step", QT_TRANSLATE_NOOP("Chart", "How near is too near for the depth buffer"),
     QT_TRANSLATE_NOOP("Chart", "The farther away, the coarser: so far two surfaces have to be apart to be stored as "
                                "different depths."),
     QT_TRANSLATE_NOOP("Chart", "distance from the eye"), QT_TRANSLATE_NOOP("Chart", "step of depth, as a distance"),
     true, true, true, depthStepChart},
    {"edge-functions", QT_TRANSLATE_NOOP("Chart", "Edge functions in floating point"),
     QT_TRANSLATE_NOOP("Chart", "Samples near an edge that come out on the wrong side, against exact integers."),
     QT_TRANSLATE_NOOP("Chart", "largest coordinate, pixels"), QT_TRANSLATE_NOOP("Chart", "wrong samples in a million"),
     true, true, false, edgeFunctionChart},
    {"lines", QT_TRANSLATE_NOOP("Chart", "Line rules against the true line"),
     QT_TRANSLATE_NOOP("Chart",
                       "Pixels that a rule has and the diamonds of the true line do not give, or the other way "
                       "round."),
     QT_TRANSLATE_NOOP("Chart", "angle, degrees"), QT_TRANSLATE_NOOP("Chart", "% of the line's pixels"), false, false,
     false, lineChart},
    {"attributes", QT_TRANSLATE_NOOP("Chart", "What it costs not to divide"),
     QT_TRANSLATE_NOOP("Chart", "A colour from 0 to 1 along 256 pixels whose ends are not equally far away; dividing "
                                "every 8 or 16 pixels was the trade of early games."),
     QT_TRANSLATE_NOOP("Chart", "ratio of the distances"), QT_TRANSLATE_NOOP("Chart", "largest error, 8-bit steps"),
     true, true, false, attributeChart},
    {"msaa", QT_TRANSLATE_NOOP("Chart", "Samples against the covered area"),
     QT_TRANSLATE_NOOP("Chart", "How well the samples of grids and patterns tell what part of a pixel is covered."),
     QT_TRANSLATE_NOOP("Chart", "samples a pixel"), QT_TRANSLATE_NOOP("Chart", "rms error, areas of a pixel"), true,
     true, true, samplesChart},
    {"distance", QT_TRANSLATE_NOOP("Chart", "The scene far from the origin"),
     QT_TRANSLATE_NOOP("Chart", "Wrong pixels as the scene is moved away from 0, with positions held as files are read "
                                "and as float32 from 0."),
     QT_TRANSLATE_NOOP("Chart", "distance from 0"), QT_TRANSLATE_NOOP("Chart", "wrong pixels"), true, true, true,
     farChart},
};

QString number(double value) { return QString::number(value, 'g', QLocale::FloatingPointShortest); }

QJsonValue jsonOf(double value) { return std::isfinite(value) ? QJsonValue(value) : QJsonValue(); }

QJsonArray jsonOf(const std::vector<double>& values)
{
    QJsonArray array;
    for (const double value : values)
        array.append(jsonOf(value));
    return array;
}

} // namespace

std::span<const ChartInfo> chartInfos() { return kCharts; }

const ChartInfo* findChart(const QString& id)
{
    const auto found =
        std::ranges::find_if(kCharts, [&](const ChartInfo& info) { return QLatin1String(info.id) == id; });
    return found == std::end(kCharts) ? nullptr : found;
}

std::optional<Reason> whyNoChart(const ChartInfo& info, const Scene& scene, const Settings& settings)
{
    if (!info.aboutScene)
        return std::nullopt;
    if (info.make == farChart && scene.space != SceneSpace::Object)
        return Reason{QT_TRANSLATE_NOOP("Chart",
                                        "%1 is given in clip space and has no camera; a scene in object space is "
                                        "expected"),
                      {scene.id}};
    Settings drawn = settings;
    if (info.make == samplesChart)
        drawn.samples = Samples::Msaa16;
    return unsupported(scene, drawn);
}

QByteArray chartCsv(const Chart& chart)
{
    QStringList head{QStringLiteral("x")};
    for (const ChartSeries& series : chart.series)
        head << QString::fromUtf8(series.name).replace(QLatin1Char(','), QLatin1Char(';'));
    QString csv = head.join(QLatin1Char(',')) + QLatin1Char('\n');
    for (std::size_t i = 0; i < chart.x.size(); ++i) {
        QStringList line{number(chart.x[i])};
        for (const ChartSeries& series : chart.series)
            line << (std::isfinite(series.y[i]) ? number(series.y[i]) : QString());
        csv += line.join(QLatin1Char(',')) + QLatin1Char('\n');
    }
    return csv.toUtf8();
}

QByteArray chartJson(const ChartInfo& info, const Chart& chart)
{
    QJsonArray series;
    for (const ChartSeries& one : chart.series)
        series.append(
            QJsonObject{{"name", QString::fromUtf8(one.name)}, {"measured", one.measured}, {"y", jsonOf(one.y)}});
    QJsonArray notes;
    for (const Reason& note : chart.notes)
        notes.append(textOf(note));
    return QJsonDocument(QJsonObject{{"chart", QLatin1String(info.id)},
                                     {"x_title", QLatin1String(info.xTitle)},
                                     {"y_title", QLatin1String(info.yTitle)},
                                     {"x", jsonOf(chart.x)},
                                     {"series", series},
                                     {"notes", notes}})
        .toJson();
}

} // namespace rasterlens
