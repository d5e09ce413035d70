#pragma once
#include "core/base/reason.h"
#include "core/scene/scene.h"
#include "core/settings/settings.h"
#include "core/truth/chart.h"

#include <QByteArray>
#include <QString>

#include <optional>
#include <span>
#include <stop_token>

namespace rasterlens
{

/// A chart that `bench --chart` and the panel of charts can make.
struct ChartInfo {
    const char* id;
    const char* title;
    const char* explains; ///< one sentence
    const char* xTitle;
    const char* yTitle;
    bool xLogarithmic;
    bool yLogarithmic; ///< 0 is drawn at the lower border
    bool aboutScene;   ///< false: the same whatever the scene
    /// in   a scene and settings for which whyNoChart() is empty
    /// out  nothing of use where `stop` ended the work
    Chart (*make)(const Scene& scene, const Settings& settings, const std::stop_token& stop);
};

/// The charts, in the order of the panel.
[[nodiscard]] std::span<const ChartInfo> chartInfos();
[[nodiscard]] const ChartInfo* findChart(const QString& id);

/// Why there is no such chart of the scene under these settings.
[[nodiscard]] std::optional<Reason> whyNoChart(const ChartInfo& info, const Scene& scene, const Settings& settings);

/// A column `x` and one a series, a line a value; empty where there is none.
[[nodiscard]] QByteArray chartCsv(const Chart& chart);
/// `{"chart", "x_title", "y_title", "x": [..], "series": [{"name", "measured", "y": [..]}], "notes": [..]}`; null where
/// there is no value.
[[nodiscard]] QByteArray chartJson(const ChartInfo& info, const Chart& chart);

} // namespace rasterlens
