#pragma once
#include "core/scene.h"

namespace rasterlens
{

/// Reads a Wavefront OBJ with its MTL files and textures (PNG, JPEG, TGA).
///
/// out     one vertex per distinct (position, uv, normal, material); polygons triangulated; normals generated where
///         missing (area-weighted per position); per-vertex colours read; MeshVertex::color = diffuse * vertex colour,
///         diffuse (0.8, 0.7, 0.6) where there is no material
/// errors  diagnostics with file and line: unreadable or empty file, indices out of range, non-finite numbers, faces of
///         fewer than three corners; a missing MTL or texture is a warning and the rest is loaded
[[nodiscard]] SceneLoad loadObj(const QString& path, const LoadOptions& options = {});

} // namespace rasterlens
