#pragma once
#include "core/io/mtl_loader.h"
#include "core/io/texture_loader.h"
#include "core/scene/scene.h"

#include <map>
#include <optional>

namespace rasterlens
{

/// The textures and masks of a scene, loaded as materials use them; each once for the options it is used with.
class TextureTable
{
public:
    /// in   whether the textures that the scene has already, colour and perhaps opacity, replace those of all materials
    TextureTable(Scene& scene, bool replaced);

    /// Gives a material its texture, how its coordinates are changed, and its mask: what `map_d` names, else the
    /// transparency of the texture.
    ///
    /// out  warnings about images that cannot be read
    void dress(const MtlMaterial& mtl, Material& material, Diagnostics& diagnostics);

private:
    /// Places in Scene::textures, or -1.
    struct Places {
        int texture = -1;
        int opacity = -1;
    };

    Places colorOf(const MtlImage& image, const QString& file, Diagnostics& diagnostics);
    int maskAlone(const MtlImage& image, const QString& file, Diagnostics& diagnostics);
    int add(Texture texture, bool clamp);
    TextureLoad read(const MtlImage& image);

    Scene* m_scene;
    std::optional<Places> m_replacement;
    std::map<QString, Places> m_known;
};

/// Changes the texture coordinates of the vertices as the options of their materials' textures say.
///
/// in   no vertex belongs to faces of two materials
void changeCoordinates(Scene& scene);

} // namespace rasterlens
