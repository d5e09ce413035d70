#include "core/io/texture_table.h"

#include "core/io/path_bytes.h"
#include "core/io/reach.h"

#include <utility>
#include <vector>

namespace rasterlens
{
namespace
{

/// Images of which the same texels are made have the same key.
QString keyOf(const MtlImage& image, const char* use)
{
    const MtlMap& map = image.map;
    return QStringLiteral("%1|%2|%3|%4|%5|%6")
        .arg(image.path, QLatin1String(use))
        .arg(double(map.base))
        .arg(double(map.gain))
        .arg(int(map.clamp))
        .arg(int(map.channel));
}

void adjust(Texture& texture, const MtlMap& map)
{
    if (map.base != 0 || map.gain != 1)
        spread(texture, map.base, map.gain);
}

/// Where a mask is looked up from coordinates that the texture's options have changed.
void placeMask(const MtlMap& color, const MtlMap& mask, Material& material)
{
    for (int axis = 0; axis < 2; ++axis) {
        const float share = color.scale[axis] != 0 ? mask.scale[axis] / color.scale[axis] : 0;
        material.maskScale[axis] = share;
        material.maskOffset[axis] = mask.offset[axis] - share * color.offset[axis];
    }
}

} // namespace

int TextureTable::add(Texture texture, bool clamp)
{
    texture.clamp = clamp;
    m_scene->textures.push_back(std::move(texture));
    return static_cast<int>(m_scene->textures.size()) - 1;
}

TextureTable::TextureTable(Scene& scene, bool replaced) : m_scene(&scene)
{
    if (replaced)
        m_replacement = Places{0, scene.textures.size() > 1 ? 1 : -1};
}

void TextureTable::dress(const MtlMaterial& mtl, Material& material, Diagnostics& diagnostics)
{
    if (m_replacement) {
        material.texture = m_replacement->texture;
        material.mask = m_replacement->opacity;
        return;
    }
    MtlMap color;
    if (mtl.texture) {
        const Places places = colorOf(*mtl.texture, mtl.file, diagnostics);
        material.texture = places.texture;
        material.mask = places.opacity;
        color = mtl.texture->map;
        material.uvScale = color.scale;
        material.uvOffset = color.offset;
    }
    const int mask = mtl.opacity ? maskAlone(*mtl.opacity, mtl.file, diagnostics) : -1;
    if (mask < 0)
        return;
    material.mask = mask;
    placeMask(color, mtl.opacity->map, material);
}

TextureLoad TextureTable::read(const MtlImage& image)
{
    if (!image.isOutside)
        return loadTexture(image.path);
    Consent::refuse(m_scene->id, image.path);
    return {{}, {}, outsideReason()};
}

TextureTable::Places TextureTable::colorOf(const MtlImage& image, const QString& file, Diagnostics& diagnostics)
{
    const QString key = keyOf(image, "color");
    if (const auto known = m_known.find(key); known != m_known.end())
        return known->second;
    TextureLoad load = read(image);
    Places places;
    if (load.texture) {
        adjust(*load.texture, image.map);
        places.texture = add(std::move(*load.texture), image.map.clamp);
        if (load.opacity)
            places.opacity = add(std::move(*load.opacity), image.map.clamp);
    } else {
        diagnostics.push_back({Severity::Warning,
                               readablePath(file),
                               image.line,
                               {QT_TRANSLATE_NOOP("Diagnostic", "map_Kd %1: %2; drawn without texture"),
                                {readablePath(image.path), *load.problem}}});
    }
    m_known.emplace(key, places);
    return places;
}

int TextureTable::maskAlone(const MtlImage& image, const QString& file, Diagnostics& diagnostics)
{
    const QString key = keyOf(image, "mask");
    if (const auto known = m_known.find(key); known != m_known.end())
        return known->second.opacity;
    TextureLoad load = read(image);
    Places places;
    if (load.texture) {
        Texture mask = maskOf(std::move(load), image.map.channel);
        adjust(mask, image.map);
        places.opacity = add(std::move(mask), image.map.clamp);
    } else {
        diagnostics.push_back({Severity::Warning,
                               readablePath(file),
                               image.line,
                               {QT_TRANSLATE_NOOP("Diagnostic", "map_d %1: %2; drawn without holes"),
                                {readablePath(image.path), *load.problem}}});
    }
    m_known.emplace(key, places);
    return places.opacity;
}

void changeCoordinates(Scene& scene)
{
    std::vector<bool> changed(scene.mesh.vertices.size());
    for (std::size_t i = 0; i < scene.mesh.indices.size(); ++i) {
        const std::size_t vertex = scene.mesh.indices[i];
        if (changed[vertex])
            continue;
        changed[vertex] = true;
        const Material& material =
            scene.materials[scene.mesh.faceMaterial.empty() ? 0 : scene.mesh.faceMaterial[i / 3]];
        glm::vec2& uv = scene.mesh.vertices[vertex].uv;
        uv = uv * material.uvScale + material.uvOffset;
    }
}

} // namespace rasterlens
