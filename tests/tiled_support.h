#pragma once
// What the tests of the tiled algorithm share: the comparison with edge-equation, and triangles that are hard.
#include "core/render/render.h"
#include "core/scenes/builtin_scenes.h"

#include <QString>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <random>
#include <vector>

namespace rasterlens::test
{

constexpr Outputs kAll{.depth = true, .ids = true, .coverage = true};

/// Instruction sets of this machine.
inline std::vector<Simd> simds()
{
    std::vector<Simd> found;
    for (const Simd simd : {Simd::Scalar, Simd::Sse4, Simd::Avx2, Simd::Avx512, Simd::Neon}) {
        Settings settings;
        settings.algorithm = Algorithm::Tiled;
        settings.simd = simd;
        if (!unsupported(Scene(), settings))
            found.push_back(simd);
    }
    return found;
}

inline int largestColorStep(const QImage& a, const QImage& b)
{
    int step = 0;
    for (int y = 0; y < a.height(); ++y) {
        const auto* rowA = reinterpret_cast<const QRgb*>(a.constScanLine(y));
        const auto* rowB = reinterpret_cast<const QRgb*>(b.constScanLine(y));
        for (int x = 0; x < a.width(); ++x)
            if (rowA[x] != rowB[x])
                step =
                    std::max({step, std::abs(qRed(rowA[x]) - qRed(rowB[x])),
                              std::abs(qGreen(rowA[x]) - qGreen(rowB[x])), std::abs(qBlue(rowA[x]) - qBlue(rowB[x]))});
    }
    return step;
}

inline bool sameBits(const DepthBuffer& a, const DepthBuffer& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float p, float q) {
        return std::bit_cast<std::uint32_t>(p) == std::bit_cast<std::uint32_t>(q);
    });
}

template <class Values>
QString firstDifference(const Values& a, const Values& b, int width)
{
    for (std::size_t i = 0; i < a.size(); ++i)
        if (a[i] != b[i])
            return QStringLiteral("at (%1, %2): %3, expected %4")
                .arg(i % std::size_t(width))
                .arg(i / std::size_t(width))
                .arg(double(b[i]), 0, 'g', 9)
                .arg(double(a[i]), 0, 'g', 9);
    return QStringLiteral("none");
}

/// What of two pictures differs, or nothing.
inline QString difference(const Frame& expected, const Frame& actual)
{
    const int width = expected.image.width();
    if (expected.coverage != actual.coverage)
        return "coverage " + firstDifference(expected.coverage, actual.coverage, width);
    if (!sameBits(expected.depth, actual.depth))
        return "depth " + firstDifference(expected.depth, actual.depth, width);
    if (expected.ids != actual.ids)
        return "ids " + firstDifference(expected.ids, actual.ids, width);
    if (expected.sampleCoverage != actual.sampleCoverage)
        return "coverage of samples " + firstDifference(expected.sampleCoverage, actual.sampleCoverage, width);
    const int step = largestColorStep(expected.image, actual.image);
    return step > 1 ? QStringLiteral("colours by %1").arg(step) : QString();
}

struct Way {
    Simd simd;
    int threads;
};

/// Every instruction set with every number of threads; under the sanitizers that is the last set, the others have
/// one number each in turn.
inline std::vector<Way> waysOf(const std::vector<Simd>& among, const std::vector<int>& threadCounts)
{
    std::vector<Way> ways;
    for (std::size_t i = 0; i < among.size(); ++i)
        for (std::size_t k = 0; k < threadCounts.size(); ++k)
            if (!RASTERLENS_SANITIZED || i + 1 == among.size() || k == i % threadCounts.size())
                ways.push_back({among[i], threadCounts[k]});
    return ways;
}

/// Compares with edge-equation: every instruction set, several threads, with and without the other outputs (which
/// take different ways through the kernel).
inline QString compareAll(const Scene& scene, Settings settings, const std::vector<Simd>& among,
                          const std::vector<int>& threadCounts = {1, 2, 5})
{
    settings.algorithm = Algorithm::EdgeEquation;
    Frame expected;
    Outputs everything = kAll;
    everything.sampleCoverage = patternSamples(settings.samples) > 1;
    const Statistics expectedCounts = renderCounted(scene, settings, expected, everything);
    settings.algorithm = Algorithm::Tiled;
    std::optional<QImage> first;
    for (const Way& way : waysOf(among, threadCounts)) {
        settings.simd = way.simd;
        settings.threads = way.threads;
        const auto tell = [&](const QString& what) {
            return QStringLiteral("simd %1, %2 threads: %3")
                .arg(valueId(*findSettingsField("simd"), settings))
                .arg(way.threads)
                .arg(what);
        };
        Frame all;
        const Statistics counts = renderCounted(scene, settings, all, everything);
        if (const QString d = difference(expected, all); !d.isEmpty())
            return tell(d);
        if (!(counts.faces == expectedCounts.faces))
            return tell("counts of faces");
        if (counts.pixels.covered != expectedCounts.pixels.covered ||
            counts.pixels.depthPassed != expectedCounts.pixels.depthPassed ||
            counts.pixels.depthFailed != expectedCounts.pixels.depthFailed || counts.pixels.coveredTwice != 0)
            return tell("counts of samples");
        if (first && *first != all.image)
            return tell("colours differ from those of another instruction set");
        first = all.image;
        Frame usual;
        render(scene, settings, usual, {.depth = true, .ids = true});
        usual.coverage = all.coverage;
        usual.sampleCoverage = all.sampleCoverage;
        if (const QString d = difference(expected, usual); !d.isEmpty())
            return tell("uncounted: " + d);
        if (usual.image != all.image)
            return tell("counting changes colours");
        Frame alone;
        render(scene, settings, alone, {.depth = true});
        if (!sameBits(expected.depth, alone.depth))
            return tell("depth with a picture");
        if (alone.image != all.image)
            return tell("colours differ where nobody asks for numbers");
        Frame picture;
        render(scene, settings, picture, {});
        if (picture.image != all.image)
            return tell("colours differ where nobody asks for more");
        Frame depth;
        render(scene, settings, depth, {.depth = true, .picture = false});
        if (!depth.image.isNull() || !sameBits(expected.depth, depth.depth))
            return tell("depth alone");
    }
    return {};
}

inline Scene clipScene(QSize size)
{
    Scene scene;
    scene.space = SceneSpace::Clip;
    scene.lit = false;
    scene.materials = {Material{}};
    scene.defaults.size = size;
    return scene;
}

inline void addTriangle(Scene& scene, const std::array<glm::vec4, 3>& positions, std::mt19937& random)
{
    std::uniform_real_distribution<float> unit(0, 1);
    for (const glm::vec4& position : positions) {
        scene.mesh.indices.push_back(static_cast<std::uint32_t>(scene.mesh.vertices.size()));
        scene.mesh.vertices.push_back({.position = position,
                                       .uv = {unit(random), unit(random)},
                                       .color = {unit(random), unit(random), unit(random)}});
    }
}

inline glm::vec4 fromScreen(double x, double y, double depth, double w, QSize size)
{
    return {float((x / size.width() * 2 - 1) * w), float((1 - y / size.height() * 2) * w), float((2 * depth - 1) * w),
            float(w)};
}

/// Triangles of every kind that is hard: small, slivers, huge, clipped, on sample centres, at equal depth.
inline Scene soup(std::mt19937& random, QSize size, int count)
{
    Scene scene = clipScene(size);
    std::uniform_real_distribution<double> unit(0, 1);
    const auto range = [&](double low, double high) { return low + (high - low) * unit(random); };
    for (int i = 0; i < count; ++i) {
        const int kind = int(range(0, 7));
        const double scale = kind == 0 ? 3 : kind == 1 ? 30 : kind == 2 ? 3000 : 0.6 * size.width();
        const glm::dvec2 centre(range(-0.1, 1.1) * size.width(), range(-0.1, 1.1) * size.height());
        const double depth = kind == 3 ? 0.5 : range(-0.05, 1.05);
        const double angle = range(0, 6.28);
        std::array<glm::vec4, 3> p;
        for (glm::vec4& v : p) {
            glm::dvec2 at = centre + scale * glm::dvec2(range(-1, 1), range(-1, 1));
            if (kind == 4) { // a sliver
                const double along = range(-1, 1) * size.width();
                const double across = range(-0.01, 0.01);
                at = centre + glm::dvec2(along * std::cos(angle) - across * std::sin(angle),
                                         along * std::sin(angle) + across * std::cos(angle));
            }
            if (kind == 5)
                at = glm::floor(at) + 0.5;
            const double w = kind == 6 ? range(-0.5, 2) : kind == 1 ? range(0.5, 4) : 1;
            v = fromScreen(at.x, at.y, kind == 3 ? depth : depth + range(-0.1, 0.1), w, size);
        }
        addTriangle(scene, p, random);
    }
    return scene;
}

inline Texture noise(std::mt19937& random, int width, int height)
{
    Texture texture{QStringLiteral("noise"), width, height, {}, {}};
    for (int i = 0; i < width * height; ++i)
        texture.texels.push_back(0xff000000U | static_cast<std::uint32_t>(random() & 0xffffffU));
    return texture;
}

/// Gives every face one of several materials: with textures of all kinds of sizes, without, dull and shiny; and the
/// vertices normals and coordinates that repeat.
inline void dress(Scene& scene, std::mt19937& random)
{
    scene.textures = {noise(random, 16, 8), noise(random, 7, 5), noise(random, 1, 3), noise(random, 64, 64)};
    scene.materials.clear();
    for (int i = 0; i < 6; ++i) {
        Material material;
        material.texture = i < 4 ? i : -1;
        material.shininess = std::array{1.0F, 32.0F, 1000.0F, 0.5F, 7.25F, 0.0F}[std::size_t(i)];
        scene.materials.push_back(material);
    }
    std::uniform_real_distribution<float> unit(-1, 1);
    for (MeshVertex& v : scene.mesh.vertices) {
        v.normal = {unit(random), unit(random), unit(random)}; // not of length 1
        v.uv = 4.0F * glm::vec2(unit(random), unit(random));
    }
    for (std::size_t face = 0; face < scene.mesh.faceCount(); ++face)
        scene.mesh.faceMaterial.push_back(static_cast<std::uint32_t>(random() % scene.materials.size()));
}

} // namespace rasterlens::test
