#include "core/pipeline/statistics.h"

#include "core/settings/settings.h"

namespace rasterlens
{
namespace
{

/// JSON numbers are doubles: exact up to 2^53, more than any frame counts.
QJsonValue count(std::uint64_t value) { return static_cast<qint64>(value); }

QJsonObject facesToJson(const Statistics::Faces& faces)
{
    return {{"submitted", count(faces.submitted)},    {"rejected", count(faces.rejected)},
            {"culled_back", count(faces.culledBack)}, {"culled_front", count(faces.culledFront)},
            {"degenerate", count(faces.degenerate)},  {"non_finite", count(faces.nonFinite)},
            {"clipped", count(faces.clipped)},        {"created_by_clipping", count(faces.createdByClipping)},
            {"rasterized", count(faces.rasterized)}};
}

QJsonObject pixelsToJson(const Statistics::Pixels& pixels)
{
    return {{"tested", count(pixels.tested)},
            {"covered", count(pixels.covered)},
            {"depth_passed", count(pixels.depthPassed)},
            {"depth_failed", count(pixels.depthFailed)},
            {"shaded", count(pixels.shaded)},
            {"written", count(pixels.written)},
            {"covered_twice", count(pixels.coveredTwice)}};
}

} // namespace

QJsonObject toJson(const Statistics& statistics, const StageTimes& times, const Settings& settings,
                   const Settings& drawnWith)
{
    const QJsonObject milliseconds{
        {"vertex", times.vertex}, {"geometry", times.geometry}, {"raster", times.raster}, {"total", times.total}};
    return {
        {"faces", facesToJson(statistics.faces)},
        {"pixels", pixelsToJson(statistics.pixels)},
        {"lines", QJsonObject{{"drawn", count(statistics.lines.drawn)}, {"shared", count(statistics.lines.shared)}}},
        {"milliseconds", milliseconds},
        {"settings", toJson(settings)},
        {"threads", drawnWith.threads},
        {"simd", valueId(*findSettingsField(QStringLiteral("simd")), drawnWith)}};
}

} // namespace rasterlens
