#pragma once
#include "core/pipeline/types.h"
#include "core/settings/rules.h"

#include <cstdint>

namespace rasterlens
{

/// The nearest multiple of 1/2^bits of the screen coordinate (p/w * 0.5 + 0.5) * size, half to even.
///
/// in      p and w in clip space, w != 0; size in pixels; bits 0..8
/// out     in units of 1/2^bits pixel, held within +-2^19 pixels (only unclipped vertices get there); NaN gives 0
/// exact   for float32 p and w: the rounding of the true quotient, ties included
[[nodiscard]] double snapToGrid(double p, double w, int size, int bits);

/// Divides by w, maps to the viewport and snaps.
///
/// in      clip space; w <= 0 gives a wrong picture, never undefined behaviour
/// out     samples (pixels times rules.sampleGrid), y down, |coordinate| <= 2^19 pixels
[[nodiscard]] ScreenVertex toScreen(const ClipVertex& vertex, const Rules& rules);

/// A vertex whose screen position is known.
///
/// in   snapped: in units of 1/2^subpixelBits pixel
[[nodiscard]] ScreenVertex toScreen(const ClipVertex& vertex, const glm::dvec2& snapped, const Rules& rules);

} // namespace rasterlens
