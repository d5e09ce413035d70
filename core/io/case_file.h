#pragma once
#include "core/scene/scene.h"

namespace rasterlens
{

/// Reads a `.case` file: clip-space triangles and the few settings a hard case needs (docs/CONVENTIONS.md).
///
/// out     positions as float32; settings in Scene::defaults (culling none, gouraud, size); background black
/// errors  diagnostics with file and line for any directive or number that is not of the format
[[nodiscard]] SceneLoad loadCase(const QString& path);

/// Reads the text of a `.case` file; diagnostics name the file `name`.
[[nodiscard]] SceneLoad parseCase(const QByteArray& text, const QString& name);

} // namespace rasterlens
