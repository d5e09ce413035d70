#pragma once
#include "core/pipeline/resolve.h"
// What several tests need: seeded random numbers, small scenes in clip space, frames and how to compare them.
#include "core/observe/counting_observer.h"
#include "core/pipeline/geometry.h"
#include "core/pipeline/interpolation.h"
#include "core/render/render.h"
#include "core/scenes/builtin_scenes.h"
#include "core/settings/rules.h"
#include "tests/seed.h"

#include <QString>
#include <QtGlobal>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

namespace rasterlens::test
{

using Random = std::mt19937_64;

inline Random seededRandom() { return Random(seedOfRun()); }

inline double uniform(Random& random, double low, double high)
{
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// out  low..high, both included
inline int integer(Random& random, int low, int high) { return std::uniform_int_distribution<int>(low, high)(random); }

/// Any float32: also denormals, infinities and NaN.
inline float anyFloat(Random& random) { return std::bit_cast<float>(static_cast<std::uint32_t>(random())); }

/// A scene of triangles in clip space, not lit, black behind.
inline Scene clipScene(const std::vector<glm::vec4>& positionsClip, std::vector<std::uint32_t> indices)
{
    Scene scene;
    scene.space = SceneSpace::Clip;
    scene.lit = false;
    scene.background = {0, 0, 0};
    scene.materials.emplace_back();
    for (std::size_t i = 0; i < positionsClip.size(); ++i) {
        MeshVertex vertex;
        vertex.position = positionsClip[i];
        vertex.color = {float(i % 3 == 0), float(i % 3 == 1), float(i % 3 == 2)};
        vertex.uv = {float(i % 5) / 4, float(i % 7) / 6};
        scene.mesh.vertices.push_back(vertex);
    }
    scene.mesh.indices = std::move(indices);
    scene.bounds = boundingSphere(scene.mesh);
    return scene;
}

/// Three vertices a face, in order.
inline Scene soup(const std::vector<glm::vec4>& positionsClip)
{
    std::vector<std::uint32_t> indices(positionsClip.size());
    for (std::size_t i = 0; i < indices.size(); ++i)
        indices[i] = static_cast<std::uint32_t>(i);
    return clipScene(positionsClip, std::move(indices));
}

/// The clip-space position, w = 1, of a point of the screen in pixels.
///
/// exact  for a size that is a power of two and multiples of 1/256 pixel
inline glm::vec4 atPixel(double x, double y, double depth, QSize size)
{
    return {2 * x / size.width() - 1, 1 - 2 * y / size.height(), 2 * depth - 1, 1};
}

/// Nothing culled, colours as given.
inline Settings plainSettings(QSize size)
{
    Settings settings;
    settings.size = size;
    settings.culling = Culling::None;
    return settings;
}

constexpr Outputs kAllOutputs{.depth = true, .ids = true, .coverage = true};

inline Frame draw(const Scene& scene, const Settings& settings)
{
    Frame frame;
    render(scene, settings, frame, kAllOutputs);
    return frame;
}

/// The first difference between two frames, or an empty string.
inline QString difference(const Frame& a, const Frame& b)
{
    const std::size_t width = static_cast<std::size_t>(std::max(a.image.width(), 1));
    const auto differsAt = [&](const auto& x, const auto& y, const char* what) -> QString {
        if (x.size() != y.size())
            return QStringLiteral("%1: %2 and %3 entries").arg(QLatin1String(what)).arg(x.size()).arg(y.size());
        const auto at = static_cast<std::size_t>(std::mismatch(x.begin(), x.end(), y.begin()).first - x.begin());
        if (at == x.size())
            return {};
        return QStringLiteral("%1 at (%2, %3): %4 and %5")
            .arg(QLatin1String(what))
            .arg(at % width)
            .arg(at / width)
            .arg(double(x[at]), 0, 'g', 17)
            .arg(double(y[at]), 0, 'g', 17);
    };
    for (const QString& text : {differsAt(a.coverage, b.coverage, "coverage"), differsAt(a.ids, b.ids, "ids"),
                                differsAt(a.depth, b.depth, "depth")})
        if (!text.isEmpty())
            return text;
    return a.image == b.image ? QString() : QStringLiteral("image");
}

/// The algorithms that go by the centres of samples, and so are to give one picture, as far as they can draw these
/// settings. Column fill is none of them.
inline std::vector<Algorithm> algorithmsFor(const Scene& scene, Settings settings)
{
    std::vector<Algorithm> algorithms;
    const SettingsField* field = findSettingsField(QStringLiteral("algorithm"));
    for (int value = field->minimum; value <= field->maximum; ++value) {
        field->set(settings, value);
        const auto algorithm = static_cast<Algorithm>(value);
        if (algorithm != Algorithm::ColumnFill && !unsupported(scene, settings))
            algorithms.push_back(algorithm);
    }
    return algorithms;
}

inline const char* idOf(Algorithm algorithm)
{
    return findSettingsField(QStringLiteral("algorithm"))->choices[static_cast<std::size_t>(algorithm)].id;
}

/// What geometry makes of the faces of a scene.
struct Processed {
    std::vector<ScreenTriangle> triangles;
    std::vector<FaceFate> fates; ///< one a face
};

struct FateObserver : NullObserver {
    std::vector<FaceFate> fates;
    void onFace(std::uint32_t, FaceFate fate) { fates.push_back(fate); }
};

inline Processed process(const Scene& scene, const Settings& settings)
{
    const Resolved resolved = resolve(settings, scene);
    const Geometry geometry(scene, resolved.matrices, resolved.rules);
    Processed result;
    FateObserver observer;
    for (std::uint32_t face = 0; face < scene.mesh.faceCount(); ++face)
        geometry.process(face, result.triangles, observer);
    result.fates = observer.fates;
    return result;
}

} // namespace rasterlens::test
