#pragma once
#include "core/base/reason.h"
#include "core/pipeline/frame.h"
#include "core/pipeline/resolve.h"
#include "core/pipeline/statistics.h"

#include <optional>
#include <stop_token>

namespace rasterlens
{

// The functions of render.h for callers of core that have resolved the settings already: `resolved` is what the
// settings resolve to for the scene.

[[nodiscard]] std::optional<Reason> unsupported(const Scene& scene, const Settings& settings, const Resolved& resolved);

[[nodiscard]] Statistics renderCounted(const Scene& scene, const Settings& settings, const Resolved& resolved,
                                       Frame& frame, Outputs outputs, std::stop_token stop);

} // namespace rasterlens
