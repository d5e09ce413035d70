// What the exact reference is asked for a scene and its settings.
#include "core/pipeline/clipping.h"
#include "core/pipeline/resolve.h"
#include "core/pipeline/vertex_stage.h"
#include "core/scene/camera.h"
#include "core/settings/depth_rules.h"
#include "core/truth/exact_reference.h"

#include <QRect>

#include <optional>
#include <utility>

namespace rasterlens
{
namespace
{

/// The part of a window that a viewport shows, if it shows any.
std::optional<PixelRect> visiblePart(const PixelRect& window, QSize size)
{
    const QRect visible = QRect(window.x, window.y, window.width, window.height) & QRect({0, 0}, size);
    if (visible.isEmpty())
        return std::nullopt;
    return PixelRect{visible.x(), visible.y(), visible.width(), visible.height()};
}

} // namespace

ExactOptions exactOptions(const Scene& scene, const Settings& settings, ReferenceSpace space)
{
    Settings correct = settings;
    correct.visibility = Visibility::ZBuffer;
    correct.mistakes.clear();
    const Resolved resolved = resolve(correct, scene);
    const Rules& rules = resolved.rules;

    ExactOptions options;
    options.size = settings.size;
    options.snap = settings.numberType == NumberType::Fixed && !scene.exact;
    options.subpixelBits = settings.subpixelBits;
    options.clipZ = settings.clipZ;
    options.culling = settings.culling;
    options.winding = settings.winding;
    options.depthCompare = rules.depthTested ? rules.depthCompare : DepthCompare::Always;
    options.depthTested = rules.depthTested;
    options.depthClear = static_cast<double>(rules.depthClear);
    options.firstPassFaces = rules.firstPassFaces;
    options.firstPassCompare = depthCompareOf(rules, 0);
    options.depthRange = rules.depthRange;
    options.depthBias = rules.depthBias;
    options.lines = scene.mesh.lines;
    options.lineRule = rules.lineRule;
    options.lineTiesByDirection = rules.lineTiesByDirection;
    if (settings.clipping == Clipping::DepthClamp)
        options.sides = {.smallestW = kSmallestW, .nearFar = false};
    options.depthFormat = settings.depthFormat;
    options.sampleGrid = rules.sampleGrid;
    options.coverageRule = rules.coverageRule;
    options.patternSamples = rules.patternSamples;
    options.resolveLight = rules.resolveLight;
    options.window = scene.window ? visiblePart(*scene.window, settings.size) : std::nullopt;
    if (space == ReferenceSpace::Object)
        options.clipFromObject = resolved.matrices.clipFromObjectDouble;
    return options;
}

std::vector<ClipTriangle> exactTriangles(const Scene& scene, const Settings& settings, ReferenceSpace space)
{
    Settings correct = settings;
    correct.shading = settings.shading == Shading::Texture ? Shading::Texture : Shading::Gouraud;
    correct.mistakes.clear();
    const Resolved resolved = resolve(correct, scene);
    std::vector<ClipVertex> vertices = shadeVertices(scene, resolved.matrices, resolved.rules);
    if (space == ReferenceSpace::Object)
        for (std::size_t i = 0; i < vertices.size(); ++i)
            vertices[i].positionClip = glm::dvec4(scene.mesh.vertices[i].position);
    std::vector<ClipTriangle> triangles(scene.mesh.faceCount());
    for (std::size_t face = 0; face < triangles.size(); ++face) {
        triangles[face].face = static_cast<std::uint32_t>(face);
        for (std::size_t i = 0; i < 3; ++i)
            triangles[face].vertices[i] = vertices[scene.mesh.indices[3 * face + i]];
    }
    return triangles;
}

ReferenceSpace referenceSpace(const Scene& scene, ReferenceSpace asked)
{
    return scene.space == SceneSpace::Object ? asked : ReferenceSpace::Clip;
}

ExactFrame exactReference(const Scene& scene, const Settings& settings, std::stop_token stop)
{
    ExactOptions options = exactOptions(scene, settings);
    options.textured = settings.shading == Shading::Texture;
    return exactReference(exactTriangles(scene, settings), options, std::move(stop));
}

} // namespace rasterlens
