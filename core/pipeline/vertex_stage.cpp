#include "core/pipeline/vertex_stage.h"

#include "core/pipeline/shading.h"

namespace rasterlens
{
namespace
{

/// float32, products summed in pairs: the order every implementation of this stage keeps.
glm::vec4 transform(const glm::mat4& m, const glm::vec4& p)
{
    return (m[0] * p.x + m[1] * p.y) + (m[2] * p.z + m[3] * p.w);
}

} // namespace

ClipVertex shadeVertexAt(const Scene& scene, const Matrices& matrices, const Rules& rules, std::size_t index)
{
    const MeshVertex& vertex = scene.mesh.vertices[index];
    glm::vec4 positionClip = vertex.position;
    if (scene.space == SceneSpace::Object)
        positionClip = transform(matrices.clipFromObject, vertex.position);
    else if (rules.mirrorClipZ)
        positionClip.z = rules.clipZ == ClipZ::Gl ? -positionClip.z : positionClip.w - positionClip.z;
    ClipVertex out;
    out.positionClip = positionClip;
    shadeVertex(scene, vertex, rules.shading, out.varyings);
    return out;
}

std::vector<ClipVertex> shadeVertices(const Scene& scene, const Matrices& matrices, const Rules& rules)
{
    std::vector<ClipVertex> out(scene.mesh.vertices.size());
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] = shadeVertexAt(scene, matrices, rules, i);
    return out;
}

} // namespace rasterlens
