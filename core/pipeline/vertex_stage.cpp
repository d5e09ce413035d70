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

void shadeOne(const Scene& scene, const Matrices& matrices, const Rules& rules, std::size_t index, ClipVertex& out)
{
    const MeshVertex& vertex = scene.mesh.vertices[index];
    glm::vec4 positionClip = vertex.position;
    if (scene.space == SceneSpace::Object)
        positionClip = transform(matrices.clipFromObject, vertex.position);
    else if (rules.mirrorClipZ)
        positionClip.z = rules.clipZ == ClipZ::Gl ? -positionClip.z : positionClip.w - positionClip.z;
    out.positionClip = positionClip;
    shadeVertex(vertex, rules, out.varyings);
}

/// Appends what the alpha test reads.
void addMaskUv(const MeshVertex& vertex, const Rules& rules, ClipVertex& out)
{
    const auto at = static_cast<std::size_t>(rules.maskUv);
    const glm::vec2 uv = cornerUv(vertex, rules.texels);
    out.varyings[at] = uv.x;
    out.varyings[at + 1] = uv.y;
}

} // namespace

void shadeVertexAt(const Scene& scene, const Matrices& matrices, const Rules& rules, std::size_t index, ClipVertex& out)
{
    shadeOne(scene, matrices, rules, index, out);
    if (rules.maskUv >= 0)
        addMaskUv(scene.mesh.vertices[index], rules, out);
}

ClipVertex shadeVertexAt(const Scene& scene, const Matrices& matrices, const Rules& rules, std::size_t index)
{
    ClipVertex out;
    shadeVertexAt(scene, matrices, rules, index, out);
    return out;
}

std::vector<ClipVertex> shadeVertices(const Scene& scene, const Matrices& matrices, const Rules& rules)
{
    std::vector<ClipVertex> out(scene.mesh.vertices.size());
    for (std::size_t i = 0; i < out.size(); ++i)
        shadeOne(scene, matrices, rules, i, out[i]);
    for (std::size_t i = 0; rules.maskUv >= 0 && i < out.size(); ++i)
        addMaskUv(scene.mesh.vertices[i], rules, out[i]);
    return out;
}

} // namespace rasterlens
