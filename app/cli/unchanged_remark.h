#pragma once
#include "core/scene/scene.h"

namespace rasterlens::cli
{

/// Says on stderr which mistakes, and which settings that the scene does not ask for, change nothing in its picture,
/// and why.
///
/// in   settings that can be drawn
void remarkIfUnchanged(const Scene& scene, const Settings& settings);

} // namespace rasterlens::cli
