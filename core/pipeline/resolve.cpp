#include "core/pipeline/resolve.h"

#include "core/pipeline/depth_test.h"
#include "core/pipeline/shading.h"

#include <algorithm>

namespace rasterlens
{
namespace
{

DepthCompare compareFor(DepthTest test, bool reversedZ)
{
    switch (test) {
    case DepthTest::Less: return reversedZ ? DepthCompare::Greater : DepthCompare::Less;
    case DepthTest::LessEqual: return reversedZ ? DepthCompare::GreaterEqual : DepthCompare::LessEqual;
    case DepthTest::Equal: return DepthCompare::Equal;
    case DepthTest::NotEqual: return DepthCompare::NotEqual;
    case DepthTest::GreaterEqual: return reversedZ ? DepthCompare::LessEqual : DepthCompare::GreaterEqual;
    case DepthTest::Greater: return reversedZ ? DepthCompare::Less : DepthCompare::Greater;
    case DepthTest::Always:
    case DepthTest::None: break;
    }
    return DepthCompare::Always;
}

/// The value every first fragment beats; of `equal` and `notequal`, that of `less`.
float clearValueFor(DepthTest test, bool reversedZ)
{
    const bool nearIsLarger = test == DepthTest::Greater || test == DepthTest::GreaterEqual;
    return nearIsLarger != reversedZ ? 0.0F : 1.0F;
}

Rules::TieThresholds thresholdsFor(const Settings& settings)
{
    // Squares are closed: what only touches one touches it, and what reaches its border holds it.
    if (settings.coverageRule != CoverageRule::Centre)
        return {0, 0};
    switch (settings.tieRule) {
    case TieRule::Inclusive: return {0, 0};
    case TieRule::Exclusive: return {1, 1};
    case TieRule::TopLeft: break;
    }
    return {0, 1};
}

Facing facingFor(CullSpace space)
{
    switch (space) {
    case CullSpace::Clip: return Facing::ClipDeterminant;
    case CullSpace::View: return Facing::ViewNormal;
    case CullSpace::Screen: break;
    }
    return Facing::ScreenArea;
}

bool hasMasks(const Scene& scene)
{
    return std::ranges::any_of(scene.materials, [](const Material& material) { return material.mask >= 0; });
}

/// Masks are looked up whatever the shading: where it carries no texture coordinates, they follow its own floats.
void carryMaskUv(Rules& rules)
{
    switch (rules.shading) {
    case Shading::Texture:
    case Shading::MipLevel:
    case Shading::Phong: rules.maskUv = kVaryingUv; break;
    case Shading::Uv: rules.maskUv = 0; break;
    case Shading::Gouraud:
    case Shading::Flat:
    case Shading::RandomFlat:
    case Shading::Depth:
    case Shading::Normals:
    case Shading::Overdraw:
    case Shading::TriangleId: rules.maskUv = rules.varyingCount; break;
    }
    rules.varyingCount = std::max(rules.varyingCount, rules.maskUv + 2);
}

void resolveLines(const Settings& settings, const Scene& scene, Rules& rules)
{
    rules.line = settings.line;
    rules.lineRule = settings.lineRule;
    rules.lineTiesByDirection = settings.lineTies == LineTies::ByDirection;
    rules.sharedEdgesOnce = settings.sharedEdges == SharedEdges::Once;
    if (!scene.mesh.lines.empty())
        rules.lineFaces = std::make_shared<const std::vector<std::uint32_t>>(scene.mesh.lines);
}

/// The rules without the mistakes.
Rules rightRules(const Settings& settings, const Scene& scene, const Matrices& matrices)
{
    Rules rules;
    rules.shading = settings.shading;
    rules.textureFilter = settings.textureFilter;
    rules.lit = scene.lit && settings.fill == Fill::Solid; // lines in the shade would be lost on black
    rules.light = lightDirection(settings.light, matrices.toViewer);
    rules.orthographic = matrices.orthographic;
    rules.toViewer = glm::vec3(matrices.toViewer);
    rules.eye = glm::vec3(matrices.eyeObject);
    rules.stretch = scene.stretch;
    rules.varyingCount = varyingCount(settings.shading);
    if (settings.alphaTest == AlphaTest::On && hasMasks(scene))
        carryMaskUv(rules);
    rules.reversedZ = settings.reversedZ;
    rules.mirrorClipZ = settings.reversedZ && scene.space == SceneSpace::Clip;

    rules.clipping = settings.clipping;
    rules.clipZ = settings.clipZ;
    rules.width = settings.size.width();
    rules.height = settings.size.height();
    rules.sampleGrid = sampleGrid(settings.samples);
    rules.patternSamples = patternSamples(settings.samples);
    rules.attributeAt = settings.attributeAt;
    rules.resolveLight = settings.resolveLight;
    rules.numberType = settings.numberType;
    rules.subpixelBits = settings.subpixelBits;

    rules.culling = settings.culling;
    rules.facing = facingFor(settings.cullSpace);
    rules.frontSign = settings.winding == Winding::CounterClockwise ? 1 : -1;

    rules.algorithm = settings.algorithm;
    rules.stepping = settings.stepping;
    rules.fill = settings.fill;
    resolveLines(settings, scene, rules);
    rules.coverageRule = settings.coverageRule;
    rules.tie = thresholdsFor(settings);

    rules.painter = settings.visibility == Visibility::Painter;
    rules.firstPassFaces = std::min(scene.secondPassFrom, static_cast<std::uint32_t>(scene.mesh.faceCount()));
    const bool firstPassTests = rules.firstPassFaces > 0;
    rules.depthTested =
        settings.visibility == Visibility::ZBuffer && (settings.depthTest != DepthTest::None || firstPassTests);
    rules.depthCompare = compareFor(settings.depthTest, settings.reversedZ);
    rules.depthClear = clearValueFor(firstPassTests ? DepthTest::Less : settings.depthTest, settings.reversedZ);
    rules.depthFormat = settings.depthFormat;
    rules.depthRange = settings.depthRange;
    rules.depthBias = settings.depthBias;
    if (scene.depthClear)
        rules.depthClear = storedDepth(*scene.depthClear, DepthStore(rules));
    rules.depthBeforeShading = settings.depthOrder == DepthOrder::BeforeShading;

    rules.perspectiveCorrect = settings.interpolation != Interpolation::Affine;
    rules.dividedEvery = dividedEvery(settings.interpolation);
    rules.attributePath = settings.attributePath;
    return rules;
}

} // namespace

Resolved resolve(const Settings& settings, const Scene& scene)
{
    Resolved resolved;
    resolved.matrices = cameraMatrices(scene, settings);
    resolved.right = rightRules(settings, scene, resolved.matrices);
    resolved.rules = resolved.right;
    for (const QString& id : settings.mistakes)
        if (const Mistake* mistake = findMistake(id)) {
            mistake->apply(resolved.rules);
            resolved.mistakes.push_back(mistake);
        }
    if (resolved.rules.camera != CameraRules())
        resolved.matrices = cameraMatrices(scene, settings, resolved.rules.camera);
    // Orthographic depth is linear in the distance: who takes the one for the other makes no mistake there.
    if (resolved.rules.orthographic)
        resolved.rules.depthIsDistance = false;
    return resolved;
}

} // namespace rasterlens
