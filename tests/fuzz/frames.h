#pragma once
// What must hold of every frame, whatever it is drawn from.
#include "core/render/render.h"
#include "tests/fuzz/target.h"

namespace rasterlens::fuzz
{

/// The conservation laws of Statistics.
inline void requireLaws(const Statistics& statistics, const Scene& scene, const Settings& settings)
{
    const auto& faces = statistics.faces;
    require(faces.submitted == scene.mesh.faceCount() || !settings.mistakes.isEmpty(), // one of them gives up
            "every face is submitted");
    require(faces.submitted == faces.rejected + faces.culledBack + faces.culledFront + faces.degenerate +
                                   faces.nonFinite + faces.rasterized,
            "every face has one fate");
    require(statistics.pixels.covered == statistics.pixels.depthPassed + statistics.pixels.depthFailed,
            "every covered sample passes or fails");
}

/// Draws a scene in a small picture, by the conservation laws; nothing where it cannot be drawn.
inline void requireDrawn(const Scene& scene, Settings settings)
{
    constexpr QSize kSize(24, 20);
    settings.size = kSize;
    settings.threads = 1;
    if (unsupported(scene, settings))
        return;
    Frame frame;
    requireLaws(renderCounted(scene, settings, frame), scene, settings);
    require(frame.image.size() == kSize, "the picture has its size");
}

/// Indices, materials and textures that a mesh names are there.
inline void requireSound(const Scene& scene)
{
    const Mesh& mesh = scene.mesh;
    require(mesh.indices.size() % 3 == 0, "faces have three corners");
    for (const std::uint32_t index : mesh.indices)
        require(index < mesh.vertices.size(), "an index names a vertex");
    require(!scene.materials.empty(), "there is a material");
    for (const std::uint32_t material : mesh.faceMaterial)
        require(material < scene.materials.size(), "a face's material is there");
    for (const Material& material : scene.materials)
        require(material.texture < int(scene.textures.size()) && material.mask < int(scene.textures.size()),
                "a material's textures are there");
}

} // namespace rasterlens::fuzz
