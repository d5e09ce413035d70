#include "core/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rasterlens
{
namespace
{

bool isFinite(const glm::vec4& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

} // namespace

BoundingSphere boundingSphere(const Mesh& mesh)
{
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    for (const MeshVertex& vertex : mesh.vertices)
        if (isFinite(vertex.position)) {
            low = glm::min(low, glm::dvec3(vertex.position));
            high = glm::max(high, glm::dvec3(vertex.position));
        }
    if (low.x > high.x)
        return {};
    BoundingSphere sphere{0.5 * (low + high), 0};
    for (const MeshVertex& vertex : mesh.vertices)
        if (isFinite(vertex.position)) {
            const glm::dvec3 e = glm::dvec3(vertex.position) - sphere.center;
            sphere.radius = std::max(sphere.radius, std::sqrt(e.x * e.x + e.y * e.y + e.z * e.z));
        }
    if (sphere.radius == 0)
        sphere.radius = 1;
    return sphere;
}

const Texture& plainTexture(const Scene& scene)
{
    if (scene.textures.empty())
        return checkerTexture();
    static const Texture white{QStringLiteral("white"), 1, 1, {0xffffffffU}};
    return white;
}

const Texture* maskOfFace(const Scene& scene, std::uint32_t face)
{
    const std::size_t material = scene.mesh.faceMaterial.empty() ? 0 : scene.mesh.faceMaterial[face];
    const int mask = material < scene.materials.size() ? scene.materials[material].mask : -1;
    return mask >= 0 ? &scene.textures[static_cast<std::size_t>(mask)] : nullptr;
}

} // namespace rasterlens
