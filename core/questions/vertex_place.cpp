#include "core/questions/vertex_place.h"

#include "core/pipeline/resolve.h"
#include "core/pipeline/vertex_stage.h"

namespace rasterlens
{

std::optional<glm::vec4> positionAtPixel(const Scene& scene, const Settings& settings, std::uint32_t vertex,
                                         const glm::dvec2& pixel)
{
    const Resolved resolved = resolve(settings, scene);
    const Rules& rules = resolved.rules;
    const glm::dvec4 clip = shadeVertexAt(scene, resolved.matrices, rules, vertex).positionClip;
    if (!(clip.w > 0))
        return std::nullopt;

    const glm::dvec2 unshifted = pixel - rules.screenShift / double(rules.sampleGrid);
    const glm::dvec2 size = glm::max(glm::dvec2(rules.width, rules.height) - double(rules.viewportShort), 1.0);
    const glm::dvec2 ndc(2 * unshifted.x / size.x - 1, (2 * unshifted.y / size.y - 1) / rules.screenUp);
    if (scene.space == SceneSpace::Clip) {
        const glm::vec4& former = scene.mesh.vertices[vertex].position;
        return glm::vec4(static_cast<float>(ndc.x * clip.w), static_cast<float>(ndc.y * clip.w), former.z, former.w);
    }
    // z of view space is kept rather than z of clip space, which has lost digits to the near plane.
    const Matrices& matrices = resolved.matrices;
    glm::dvec4 view = matrices.viewFromObject * glm::dvec4(scene.mesh.vertices[vertex].position);
    view.x = ndc.x * clip.w / matrices.clipFromView[0][0];
    view.y = ndc.y * clip.w / matrices.clipFromView[1][1];
    return glm::vec4(glm::inverse(matrices.viewFromObject) * view);
}

} // namespace rasterlens
