#pragma once
#include "core/pipeline/types.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"
#include "core/settings/rules.h"

#include <vector>

namespace rasterlens
{

/// Takes every vertex of the mesh to clip space and computes what the shading interpolates.
///
/// in      object space (or clip space already: Matrices is then the identity)
/// out     clip space, one for each vertex of the mesh, in its order; float32 values
/// covers  `reversedZ` of clip-space scenes, by mirroring z
[[nodiscard]] std::vector<ClipVertex> shadeVertices(const Scene& scene, const Matrices& matrices, const Rules& rules);

/// Takes one vertex to clip space, by its index in the mesh, as shadeVertices() does. The first form writes it where it
/// is kept: a processor waits for what it has just written when it is copied in larger pieces.
void shadeVertexAt(const Scene& scene, const Matrices& matrices, const Rules& rules, std::size_t index,
                   ClipVertex& out);
[[nodiscard]] ClipVertex shadeVertexAt(const Scene& scene, const Matrices& matrices, const Rules& rules,
                                       std::size_t index);

} // namespace rasterlens
