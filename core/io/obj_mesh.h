#pragma once
#include "core/io/obj_text.h"
#include "core/scene/scene.h"

namespace rasterlens
{

/// Makes the mesh of an OBJ.
///
/// in      for each face an index into `materials`
/// out     positions told from an origin where they lie far away (see origin.h); one vertex per distinct (position, uv,
/// normal, material); polygons triangulated; normals generated where
///         missing: within a smoothing group the area-weighted mean at the position, in a flat face its own; texture
///         coordinates where missing planar, from x and y across the bounding sphere
/// cost    linear, but for concave polygons: see triangulate()
/// errors  a warning about polygons whose outline crosses itself, and about great distance from 0
[[nodiscard]] Mesh makeObjMesh(const ObjText& text, const std::vector<std::uint32_t>& materialOfFace,
                               const std::vector<Material>& materials, DiagnosticSink& diagnostics);

} // namespace rasterlens
