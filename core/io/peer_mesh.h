#pragma once
#include "core/io/obj_text.h"
#include "core/scene/scene.h"

namespace rasterlens
{

inline constexpr glm::vec3 kPeerColor{0.8F, 0.7F, 0.6F};

struct PeerMesh {
    Mesh mesh;
    BoundingSphere bounds; ///< of every `v` of the file, used or not
};

/// Makes the mesh that the peer harness makes of an OBJ, so that times and pictures compare.
///
/// in      a text read with ObjPositions::Float32
/// out     polygons as fans; one vertex per distinct (v, vt); normals summed in float32, area-weighted per `v`, `vn`
///         left aside; uv = vt, or planar from x and y within the bounding sphere; colour (0.8, 0.7, 0.6)
/// exact   positions, normals, uv and their order are those of the harness bit for bit
[[nodiscard]] PeerMesh peerMesh(const ObjText& text);

} // namespace rasterlens
