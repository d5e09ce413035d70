#include "core/truth/coverage_chart.h"

#include "core/pipeline/geometry.h"
#include "core/pipeline/observer.h"
#include "core/pipeline/pixel_area.h"
#include "core/pipeline/resolve.h"
#include "core/render/render.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include <algorithm>
#include <array>
#include <cmath>

namespace rasterlens
{
namespace
{

CoverageRow rowOf(const Scene& scene, const Settings& settings, const std::vector<double>& areas,
                  const std::stop_token& stop)
{
    Frame frame;
    render(scene, settings, frame, {.picture = false, .sampleCoverage = true}, stop);
    const int count = samplesPerPixel(settings.samples);
    CoverageRow row;
    row.samples = settings.samples;
    constexpr double kWhole = 1e-9; // covered whole, so many times, or not at all
    for (std::size_t i = 0; i < areas.size() && !stop.stop_requested(); ++i) {
        if (std::abs(areas[i] - std::round(areas[i])) < kWhole)
            continue;
        std::uint64_t covered = 0;
        for (std::size_t at = i; at < frame.sampleCoverage.size(); at += areas.size())
            covered += frame.sampleCoverage[at];
        const double error = static_cast<double>(covered) / count - areas[i];
        ++row.pixels;
        row.rms += error * error;
        row.mean += std::abs(error);
        row.largest = std::max(row.largest, std::abs(error));
    }
    const double pixels = static_cast<double>(std::max<std::uint64_t>(row.pixels, 1));
    row.rms = std::sqrt(row.rms / pixels);
    row.mean /= pixels;
    return row;
}

QString samplesId(Samples samples)
{
    Settings settings;
    settings.samples = samples;
    return valueId(*findSettingsField(QStringLiteral("samples")), settings);
}

} // namespace

std::vector<double> coveredAreas(const Scene& scene, const Settings& settings)
{
    Settings single = settings;
    single.samples = Samples::One;
    const Resolved resolved = resolve(single, scene);
    const Geometry geometry(scene, resolved.matrices, resolved.rules);
    std::vector<double> areas(static_cast<std::size_t>(settings.size.width()) *
                              static_cast<std::size_t>(settings.size.height()));
    std::vector<ScreenTriangle> triangles;
    NullObserver nobody;
    for (std::uint32_t face = 0; face < scene.mesh.faceCount(); ++face) {
        triangles.clear();
        geometry.process(face, triangles, nobody);
        for (const ScreenTriangle& triangle : triangles)
            addAreas(triangle, settings.size, areas);
    }
    return areas;
}

std::vector<CoverageRow> coverageChart(const Scene& scene, const Settings& settings, const std::stop_token& stop)
{
    const std::vector<double> areas = coveredAreas(scene, settings);
    std::vector<CoverageRow> rows;
    Settings one = settings;
    for (int samples = 0; samples <= static_cast<int>(Samples::Msaa16) && !stop.stop_requested(); ++samples) {
        one.samples = static_cast<Samples>(samples);
        rows.push_back(rowOf(scene, one, areas, stop));
    }
    return rows;
}

QByteArray coverageCsv(std::span<const CoverageRow> rows)
{
    QByteArray text = "samples,samples_per_pixel,pixels,rms,mean,largest\n";
    for (const CoverageRow& row : rows)
        text += QStringLiteral("%1,%2,%3,%4,%5,%6\n")
                    .arg(samplesId(row.samples))
                    .arg(samplesPerPixel(row.samples))
                    .arg(row.pixels)
                    .arg(row.rms)
                    .arg(row.mean)
                    .arg(row.largest)
                    .toUtf8();
    return text;
}

QByteArray coverageJson(std::span<const CoverageRow> rows)
{
    QJsonArray array;
    for (const CoverageRow& row : rows)
        array << QJsonObject{{"samples", samplesId(row.samples)},
                             {"samples_per_pixel", samplesPerPixel(row.samples)},
                             {"pixels", static_cast<qint64>(row.pixels)},
                             {"rms", row.rms},
                             {"mean", row.mean},
                             {"largest", row.largest}};
    return QJsonDocument(array).toJson();
}

} // namespace rasterlens
