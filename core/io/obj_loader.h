#pragma once
#include "core/scene/scene.h"

namespace rasterlens
{

/// Reads a Wavefront OBJ with its MTL files and textures (PNG, JPEG, TGA).
///
/// out     one vertex per distinct (position, uv, normal, material); polygons triangulated; normals generated where
///         missing (area-weighted per position and smoothing group; flat where smoothing is off); per-vertex colours
///         read; MeshVertex::color = diffuse * vertex colour, diffuse where no Kd is given: 1 with a texture or vertex
///         colours, else (0.8, 0.7, 0.6); faces numbered in the order of the `f` statements, with the line of each
///         triangle's; bounds of the vertices in use
/// covers  one material for faces before any `usemtl`; materials that no face uses are left out; with peerMesh the
///         MTL files are left aside
/// errors  diagnostics with file and line. What is wrong with a line is a warning and the rest is loaded; an error only
///         where the file cannot be read or no face is left
[[nodiscard]] SceneLoad loadObj(const QString& path, const LoadOptions& options = {});

} // namespace rasterlens
