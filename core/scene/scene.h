#pragma once
#include "core/base/diagnostics.h"
#include "core/scene/mip_chain.h"
#include "core/settings/settings.h"

#include <QString>
#include <glm/glm.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace rasterlens
{

/// A corner of a mesh: what a vertex buffer holds.
struct MeshVertex {
    glm::vec4 position{0, 0, 0, 1}; ///< object space (world minus Mesh::origin) with w = 1, or clip space (SceneSpace)
    glm::vec3 normal{0, 0, 1};      ///< object space, unit length
    glm::vec2 uv{0, 0};             ///< texture coordinates, (0, 0) is the first texel
    glm::vec3 color{1, 1, 1};       ///< display value 0..1, the material's diffuse colour multiplied in
};

/// Triangles that share vertices. The index of a triangle is its face id, kept to the end of the pipeline.
struct Mesh {
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices;      ///< three a face
    std::vector<std::uint32_t> faceMaterial; ///< index into Scene::materials a face; empty = material 0 for all
    glm::dvec3 origin{0, 0, 0};              ///< of object space, in the world (the file's coordinates): see origin.h

    [[nodiscard]] std::size_t faceCount() const { return indices.size() / 3; }
};

/// Texels as display values, 0xffRRGGBB. Row 0 lies at v = 0 (a loader flips image files, whose row 0 is on top).
struct Texture {
    QString name;
    int width = 0;
    int height = 0;
    std::vector<std::uint32_t> texels; ///< width * height, row by row
    MipChain mips{};                   ///< made of them when first asked for
};

struct Material {
    QString name;
    glm::vec3 diffuse{1, 1, 1};              ///< for information: already multiplied into MeshVertex::color
    glm::vec3 specular{0.25F, 0.25F, 0.25F}; ///< Phong
    float shininess = 32;                    ///< Phong exponent
    int texture = -1;                        ///< index into Scene::textures; -1 none
};

enum class SceneSpace { Object, Clip };

/// Centre of the bounding box and the largest distance of a vertex from it.
struct BoundingSphere {
    glm::dvec3 center{0, 0, 0}; ///< object space
    double radius = 1;
};

/// What there is to draw. A plain value; shared between threads as `std::shared_ptr<const Scene>`.
struct Scene {
    QString id;    ///< how to open it again: `builtin:NAME`, `stress:NAME` or a file path
    QString title; ///< for people; builtin titles are marked for translation
    QString note;  ///< what to look at; may be empty
    SceneSpace space = SceneSpace::Object;
    bool lit = true; ///< false: vertex colours are shown as they are
    glm::vec3 background{0.1F, 0.1F, 0.1F};
    Mesh mesh;
    std::vector<Material> materials; ///< at least one
    std::vector<Texture> textures;
    BoundingSphere bounds;
    Settings defaults;                                     ///< what the scene asks for; the user may change all of it
    std::optional<PixelRect> window;                       ///< the part of the viewport worth looking at
    std::vector<std::pair<QString, QString>> expectations; ///< `expect key value` of case files
    bool exact = false;                                    ///< case file with `exact`: the reference is not to snap
};

/// The bounding sphere of the finite positions; radius 1 about the origin for an empty mesh, radius 1 for one point.
[[nodiscard]] BoundingSphere boundingSphere(const Mesh& mesh);

/// 512 x 512 checkerboard with 32-texel cells, (230, 230, 230) and (40, 60, 120): the texture of a scene that has none.
[[nodiscard]] const Texture& checkerTexture();

/// A scene, or why there is none.
struct SceneLoad {
    std::optional<Scene> scene; ///< empty when diagnostics hold an error
    Diagnostics diagnostics;
};

struct LoadOptions {
    bool peerMesh = false;  ///< normals and uv of OBJ files as the peer harness computes them, colour (0.8, 0.7, 0.6)
    QSize size{1920, 1080}; ///< the stress scenes are made for a size
    QString texture;        ///< image that replaces the materials' textures; empty = none
};

/// Opens whatever a user may name: an `.obj`, a `.case`, `builtin:NAME`, `stress:NAME`.
/// (A session `.json` holds a scene name and settings: see session.h.)
///
/// errors  in the diagnostics, with file and line; never throws
[[nodiscard]] SceneLoad loadScene(const QString& name, const LoadOptions& options = {});

} // namespace rasterlens
