#pragma once
#include "core/render/render.h"

namespace rasterlens::cli
{

/// Says on stderr why a picture shows nothing, if it does.
///
/// in   the outputs that were asked for, and the frame with them
void remarkIfEmpty(const Scene& scene, const Settings& settings, const Frame& frame, const Outputs& outputs);

} // namespace rasterlens::cli
