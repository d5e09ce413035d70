#pragma once
#include "core/scene/scene.h"

namespace rasterlens
{

/// Opens whatever a user may name: an `.obj`, a `.case`, `builtin:NAME`, `stress:NAME`.
/// (A session `.json` holds a scene name and settings: see session.h.)
///
/// errors  in the diagnostics, with file and line; never throws
[[nodiscard]] SceneLoad loadScene(const QString& name, const LoadOptions& options = {});

} // namespace rasterlens
