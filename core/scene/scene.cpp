#include "core/scene/scene.h"

#include "core/io/case_file.h"
#include "core/io/obj_loader.h"
#include "core/scenes/builtin_scenes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rasterlens
{
namespace
{

bool isFinite(const glm::vec4& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

Texture makeChecker()
{
    constexpr int kSize = 512;
    constexpr int kCell = 32;
    constexpr std::uint32_t kLight = 0xffe6e6e6; // 230, 230, 230
    constexpr std::uint32_t kDark = 0xff283c78;  // 40, 60, 120
    Texture checker{QStringLiteral("checkerboard"), kSize, kSize, {}};
    checker.texels.reserve(kSize * kSize);
    for (int y = 0; y < kSize; ++y)
        for (int x = 0; x < kSize; ++x)
            checker.texels.push_back((x / kCell + y / kCell) % 2 == 0 ? kLight : kDark);
    return checker;
}

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

const Texture& checkerTexture()
{
    static const Texture checker = makeChecker();
    return checker;
}

SceneLoad loadScene(const QString& name, const LoadOptions& options)
{
    const QLatin1String builtin("builtin:");
    const QLatin1String stress("stress:");
    if (name.startsWith(builtin))
        return makeBuiltinScene(name.mid(builtin.size()));
    if (name.startsWith(stress))
        return makeStressScene(name.mid(stress.size()), options.size);
    if (name.endsWith(QLatin1String(".obj"), Qt::CaseInsensitive))
        return loadObj(name, options);
    if (name.endsWith(QLatin1String(".case"), Qt::CaseInsensitive))
        return loadCase(name);
    return {
        std::nullopt,
        {{Severity::Error, name, 0,
          QT_TRANSLATE_NOOP("Diagnostic",
                            "this is not a scene; an .obj or .case file, builtin:NAME or stress:NAME is expected")}}};
}

} // namespace rasterlens
