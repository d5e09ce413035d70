#pragma once
#include "core/base/reason.h"

#include <optional>

namespace rasterlens
{

/// Why nothing can be drawn between a near and a far plane: a text of the context "Diagnostic", or nothing where it
/// can.
///
/// in      distances from the eye; empty: the camera's own choice, which is good
/// source  z' = n + f - nf/z and x' = nx/z: the matrix that squeezes the frustum into a box
[[nodiscard]] std::optional<Reason> whyNotPlanes(std::optional<double> near, std::optional<double> far);

} // namespace rasterlens
