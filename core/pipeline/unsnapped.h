#pragma once
#include "core/settings/rules.h"

#include <glm/glm.hpp>

namespace rasterlens
{

/// Where the viewport puts a vertex before it snaps it and holds it near the screen, in samples, y down.
///
/// in  clip space
[[nodiscard]] glm::dvec2 unsnappedPosition(const glm::dvec4& positionClip, const Rules& rules);

/// Depth as the mistake of rules.depthIsDistance has it: linear in the distance from the eye.
[[nodiscard]] constexpr double depthOfDistance(double w, double near, double far) { return (w - near) / (far - near); }

} // namespace rasterlens
