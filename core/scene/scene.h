#pragma once
#include "core/base/diagnostics.h"
#include "core/scene/texture.h"
#include "core/settings/settings.h"

#include <QString>
#include <glm/glm.hpp>

#include <algorithm>
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
    std::vector<std::int32_t> faceLine;      ///< line of the `f` in the file that a face is a part of; empty = no file
    /// Faces that are lines, ascending: from the first corner to the second, and the third is the second once more.
    std::vector<std::uint32_t> lines;

    [[nodiscard]] std::size_t faceCount() const { return indices.size() / 3; }
    [[nodiscard]] bool isLine(std::uint32_t face) const
    {
        return !lines.empty() && std::binary_search(lines.begin(), lines.end(), face);
    }
    /// The line in the scene's file that a face comes from, counted from 1; -1 where there is none.
    [[nodiscard]] std::int32_t lineOf(std::size_t face) const { return face < faceLine.size() ? faceLine[face] : -1; }
};

struct Material {
    QString name;
    glm::vec3 diffuse{1, 1, 1};              ///< for information: already multiplied into MeshVertex::color
    glm::vec3 specular{0.25F, 0.25F, 0.25F}; ///< Phong
    float shininess = 32;                    ///< Phong exponent
    int texture = -1;                        ///< index into Scene::textures; -1 none
    glm::vec2 uvScale{1, 1};                 ///< for information: MeshVertex::uv are uv * uvScale + uvOffset already
    glm::vec2 uvOffset{0, 0};
    /// The texture whose red channel says where the surface is: below one half there is a hole (--alpha-test). -1 none.
    int mask = -1;
    glm::vec2 maskScale{1, 1}; ///< a mask is looked up at uv * maskScale + maskOffset
    glm::vec2 maskOffset{0, 0};
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
    /// How the mesh was stretched along the axes after its shape was made; its normals are those of what came out.
    glm::vec3 stretch{1, 1, 1};
    bool lit = true; ///< false: vertex colours are shown as they are
    glm::vec3 background{0.1F, 0.1F, 0.1F};
    Mesh mesh;
    std::vector<Material> materials; ///< at least one
    std::vector<Texture> textures;
    BoundingSphere bounds;
    Settings defaults; ///< what the scene asks for; the user may change all of it
    /// The face with which a second pass begins, which is drawn over what the first has left in the buffers: a decal,
    /// or a wireframe over a surface. Depth test, depth bias and fill of the settings are the second pass's; the first
    /// is filled and compared by `less`. 0: there is one pass.
    std::uint32_t secondPassFrom = 0;
    std::optional<double> depthClear;                      ///< what the depth buffer is cleared to; none: the far end
    std::optional<PixelRect> window;                       ///< the part of the viewport worth looking at
    std::vector<std::pair<QString, QString>> expectations; ///< `expect key value` of case files
    bool exact = false;                                    ///< case file with `exact`: the reference is not to snap
};

/// The bounding sphere of the finite positions; radius 1 about the origin for an empty mesh, radius 1 for one point.
[[nodiscard]] BoundingSphere boundingSphere(const Mesh& mesh);

/// What shading texture shows of faces whose material has no texture: one white texel, which leaves their colour as it
/// is. A scene without any texture shows the checkerboard instead.
[[nodiscard]] const Texture& plainTexture(const Scene& scene);

/// The mask of a face's material, or null.
[[nodiscard]] const Texture* maskOfFace(const Scene& scene, std::uint32_t face);

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

} // namespace rasterlens
