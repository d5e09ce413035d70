#pragma once
#include "core/base/reason.h"
#include "core/pipeline/frame.h"
#include "core/pipeline/statistics.h"
#include "core/scene/scene.h"
#include "core/settings/settings.h"

#include <optional>
#include <stop_token>

namespace rasterlens
{

/// Why these settings cannot be drawn, or nothing; a text of the context "Unsupported".
[[nodiscard]] std::optional<Reason> unsupported(const Scene& scene, const Settings& settings);

/// Why these outputs cannot be had of the settings, or nothing; a text of the context "Unsupported".
[[nodiscard]] std::optional<Reason> unsupportedOutputs(const Settings& settings, Outputs outputs);

/// The settings with what `auto` stands for on this machine: threads and vector instructions.
[[nodiscard]] Settings withoutAuto(const Settings& settings);

/// The settings with which the tiled algorithm draws the same picture, colours at most one step off, faster; nothing
/// where the algorithm is part of the picture (mistakes, number types, lines, edge-then-span) or is tiled already.
[[nodiscard]] std::optional<Settings> fastSettings(const Scene& scene, const Settings& settings);

/// The settings with the threads and vector instructions that this machine draws them with: never 0, never Auto; one
/// thread and Scalar where the algorithm has neither.
///
/// in      settings for which unsupported() is empty
[[nodiscard]] Settings withWorkers(Settings settings);

/// Draws one frame at full speed.
///
/// in      settings for which unsupported() is empty; `frame` may hold an earlier picture, whose memory is used again
/// cost    linear in faces and covered samples
/// errors  throws std::bad_alloc, and std::system_error where threads cannot be started; `stop` ends the work early and
///         leaves an unfinished picture
void render(const Scene& scene, const Settings& settings, Frame& frame, Outputs outputs = {},
            std::stop_token stop = {});

/// Draws one frame as render() does, bit for bit, and counts what was done for it.
[[nodiscard]] Statistics renderCounted(const Scene& scene, const Settings& settings, Frame& frame, Outputs outputs = {},
                                       std::stop_token stop = {});

} // namespace rasterlens
