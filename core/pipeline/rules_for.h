#pragma once
#include "core/scene/scene.h"
#include "core/settings/rules.h"

namespace rasterlens
{

/// Resolves the settings for a scene. The mistakes of the settings are applied last.
[[nodiscard]] Rules rulesFor(const Scene& scene, const Settings& settings);

} // namespace rasterlens
