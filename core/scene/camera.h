#pragma once
#include "core/scene/scene.h"
#include "core/settings/rules.h"

#include <glm/glm.hpp>

namespace rasterlens
{

/// The matrices of one frame, named to-From-from.
struct Matrices {
    glm::mat4 clipFromObject{1};        ///< float32, as a vertex buffer's consumer sees it
    glm::dmat4 clipFromObjectDouble{1}; ///< the same before it was rounded: clipFromView * viewFromObject
    glm::dmat4 viewFromObject{1};
    glm::dmat4 clipFromView{1};
    glm::dvec3 eyeObject{0, 0, 0}; ///< object space: the world's axes, the mesh's origin taken off
    /// From what is looked at towards the eye: the camera's backward axis, unit length, the world's axes. For scenes in
    /// clip space the side to which AB x AC of a counter-clockwise face points.
    glm::dvec3 toViewer{0, 0, 1};
    bool orthographic = false;
    double near = 0; ///< the distances in use; orthographic: below 0 where the scene reaches behind the eye
    double far = 0;
};

/// The camera of `settings.view` for this scene and viewport. Identity for clip-space scenes.
///
/// covers  fit: bounding sphere tangent to the frustum's top and bottom, near and far 1.1 radii round the centre;
///         orthographic: what lies at the target's distance has the size of perspective, near and far leave out
///         nothing of the sphere; OpenGL or Direct3D depth range, reversed or not; eye and target are given in world
///         space, the mesh's origin is taken off in double before anything is rounded
/// exact   for the default view, the matrix of the peer harness bit for bit
///
/// in      rules: how the matrices are made; other ones than the default are for mistakes
[[nodiscard]] Matrices cameraMatrices(const Scene& scene, const Settings& settings, const CameraRules& rules = {});

} // namespace rasterlens
