#include "core/scenes/builtin_scenes.h"

#include <array>
#include <cmath>
#include <numbers>

namespace rasterlens
{
namespace
{

constexpr double kTexture = 512; ///< uv repeat after so many pixels

/// splitmix64 (Steele, Lea & Flood, OOPSLA 2014)
class Random
{
public:
    explicit Random(std::uint64_t seed) : m_state(seed) {}

    std::uint64_t bits()
    {
        std::uint64_t z = m_state += 0x9E3779B97F4A7C15U;
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31);
    }

    /// [0, 1) in steps of 2^-53
    double unit() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

private:
    std::uint64_t m_state;
};

double snapped(double pixels) { return std::floor(pixels * 256 + 0.5) / 256; }

glm::vec3 colorOf(std::uint64_t bits)
{
    const auto channel = [&](int shift) { return static_cast<float>((bits >> shift) & 255U) / 255.0F; };
    return {channel(0), channel(8), channel(16)};
}

struct RandomTriangles {
    int count;
    double smallestArea; ///< square pixels
    double largestArea;
    std::uint64_t seed;
};

/// Triangles anywhere in the viewport, turned and stretched at random, counter-clockwise. The order of the draws from
/// the generator is part of the scene: centre, angle, area, stretch; then depth and colour of each corner.
Mesh randomTriangles(const RandomTriangles& what, QSize size)
{
    constexpr double kPi = std::numbers::pi;
    const double width = size.width();
    const double height = size.height();
    Random random(what.seed);
    Mesh mesh;
    mesh.vertices.reserve(3 * static_cast<std::size_t>(what.count));
    mesh.indices.reserve(3 * static_cast<std::size_t>(what.count));
    for (int i = 0; i < what.count; ++i) {
        const double centerX = width * random.unit();
        const double centerY = height * random.unit(); // y up
        const double turn = 2 * kPi * random.unit();
        const double area = what.smallestArea + (what.largestArea - what.smallestArea) * random.unit();
        const double stretch = std::exp2(2 * random.unit() - 1);
        const double radius = std::sqrt(4 * area / (3 * std::sqrt(3.0)));
        for (int k = 0; k < 3; ++k) {
            const double depth = 0.05 + 0.9 * random.unit();
            const glm::vec3 color = colorOf(random.bits());
            const double angle = turn + 2 * kPi * k / 3;
            const double x = snapped(centerX + stretch * radius * std::cos(angle));
            const double y = snapped(centerY + radius / stretch * std::sin(angle));
            mesh.indices.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
            mesh.vertices.push_back({.position = {2 * x / width - 1, 2 * y / height - 1, 2 * depth - 1, 1},
                                     .uv = {x / kTexture, y / kTexture},
                                     .color = color});
        }
    }
    return mesh;
}

enum class Order { FrontToBack, BackToFront };

/// Ten quads that fill the viewport, one behind the other.
Mesh fillQuads(Order order, QSize size)
{
    constexpr int kLayers = 10;
    constexpr std::array<glm::vec2, 4> kCornersNdc = {{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    constexpr std::array<glm::vec3, 4> kColors = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}}};
    const glm::vec2 sizePixels(static_cast<float>(size.width()), static_cast<float>(size.height()));
    Mesh mesh;
    for (int drawn = 0; drawn < kLayers; ++drawn) {
        const int layer = order == Order::FrontToBack ? drawn : kLayers - 1 - drawn;
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (std::size_t k = 0; k < kCornersNdc.size(); ++k)
            mesh.vertices.push_back({.position = {kCornersNdc[k], 2 * ((layer + 0.5) / kLayers) - 1, 1},
                                     .uv = (kCornersNdc[k] * 0.5F + 0.5F) * sizePixels / static_cast<float>(kTexture),
                                     .color = kColors[k] * static_cast<float>(1 - layer / 20.0)});
        for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U})
            mesh.indices.push_back(first + corner);
    }
    return mesh;
}

constexpr StressScene kStressScenes[] = {
    {"tiny", QT_TRANSLATE_NOOP("StressScene", "1,000,000 triangles of 1 to 4 pixels"),
     [](QSize size) {
         return randomTriangles({1'000'000, 1, 4, 1}, size);
     }},
    {"medium", QT_TRANSLATE_NOOP("StressScene", "100,000 triangles of 100 pixels"),
     [](QSize size) {
         return randomTriangles({100'000, 100, 100, 2}, size);
     }},
    {"large", QT_TRANSLATE_NOOP("StressScene", "2,000 triangles of 20,000 pixels"),
     [](QSize size) {
         return randomTriangles({2'000, 20'000, 20'000, 3}, size);
     }},
    {"fill-front-to-back", QT_TRANSLATE_NOOP("StressScene", "10 full-screen quads, nearest first"),
     [](QSize size) { return fillQuads(Order::FrontToBack, size); }},
    {"fill-back-to-front", QT_TRANSLATE_NOOP("StressScene", "10 full-screen quads, farthest first"),
     [](QSize size) { return fillQuads(Order::BackToFront, size); }}};

} // namespace

std::span<const StressScene> stressScenes() { return kStressScenes; }

SceneLoad makeStressScene(const QString& name, QSize size)
{
    const QString id = QStringLiteral("stress:") + name;
    const auto inRange = [](int pixels) { return pixels >= 1 && pixels <= kMaxViewport; };
    if (!inRange(size.width()) || !inRange(size.height()))
        return {std::nullopt,
                {{Severity::Error,
                  id,
                  0,
                  {QT_TRANSLATE_NOOP("Diagnostic", "a size of 1 to %1 pixels each is expected"), {kMaxViewport}}}}};
    QStringList names;
    for (const StressScene& stress : kStressScenes) {
        names << QString::fromLatin1(stress.name);
        if (name != names.back())
            continue;
        Scene scene;
        scene.id = id;
        scene.title = QString::fromLatin1(stress.title);
        scene.space = SceneSpace::Clip;
        scene.lit = false;
        scene.mesh = stress.make(size);
        scene.materials = {Material{}};
        scene.bounds = boundingSphere(scene.mesh);
        scene.defaults.size = size;
        return {std::move(scene), {}};
    }
    return {std::nullopt,
            {{Severity::Error,
              id,
              0,
              {QT_TRANSLATE_NOOP("Diagnostic", "there is no such stress scene; expected: %1"),
               {names.join(QStringLiteral(", "))}}}}};
}

} // namespace rasterlens
