#pragma once
#include "core/scene/scene.h"

#include <QString>

namespace rasterlens
{

/// What a scene is called, in the language in use: the title of a built-in one, else of the file.
[[nodiscard]] QString sceneTitle(const Scene& scene);
/// What to look at in it, in the language in use; may be empty.
[[nodiscard]] QString sceneNote(const Scene& scene);

} // namespace rasterlens
