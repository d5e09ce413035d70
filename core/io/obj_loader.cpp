#include "core/io/obj_loader.h"

#include "core/io/mtl_loader.h"
#include "core/io/obj_text.h"
#include "core/io/peer_mesh.h"
#include "core/io/texture_loader.h"
#include "core/scene/origin.h"
#include "core/scene/triangulate.h"

#include <QDir>
#include <QFileInfo>
#include <QHash>
#include <QSet>
#include <tiny_obj_loader.h>

#include <cmath>
#include <istream>
#include <streambuf>
#include <unordered_map>

namespace rasterlens
{
namespace
{

constexpr glm::vec3 kDefaultDiffuse{0.8F, 0.7F, 0.6F};

void append(Diagnostics& to, Diagnostics&& from)
{
    to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

/// Indices from 0, -1 none.
struct Corner {
    int position;
    int uv;
    int normal;
};

/// The geometry of an OBJ as it stands in the file.
struct ObjGeometry {
    std::vector<glm::dvec3> positions; ///< world space: the file's coordinates
    glm::dvec3 origin{0};              ///< of the mesh to be, and so of object space
    std::size_t positionsRead = 0;     ///< `v` statements before the one that is read
    std::vector<glm::vec3> normals;
    std::vector<glm::vec2> uvs;
    std::vector<Corner> corners;
    std::vector<std::uint32_t> faceEnds; ///< of each `f`, an index into corners
};

/// OBJ indices count from 1, or backwards from the end if negative; 0 stands for none.
int fromObjIndex(int index, std::size_t count) { return index < 0 ? index + static_cast<int>(count) : index - 1; }

/// A text that a stream reads in place.
class TextBuffer : public std::streambuf
{
public:
    explicit TextBuffer(QByteArray& text) { setg(text.data(), text.data(), text.data() + text.size()); }
};

/// The box of the positions that faces use.
BoundingBox boxInUse(const ObjGeometry& geometry)
{
    BoundingBox box;
    for (const Corner& corner : geometry.corners)
        box.add(geometry.positions[static_cast<std::size_t>(corner.position)]);
    return box;
}

ObjGeometry readGeometry(ObjText& text)
{
    ObjGeometry geometry;
    geometry.positions = std::move(text.positions);
    tinyobj::callback_t callbacks;
    callbacks.vertex_cb = [](void* out, float, float, float, float) {
        ++static_cast<ObjGeometry*>(out)->positionsRead;
    };
    callbacks.normal_cb = [](void* out, float x, float y, float z) {
        static_cast<ObjGeometry*>(out)->normals.emplace_back(x, y, z);
    };
    callbacks.texcoord_cb = [](void* out, float u, float v, float) {
        static_cast<ObjGeometry*>(out)->uvs.emplace_back(u, v);
    };
    callbacks.index_cb = [](void* out, tinyobj::index_t* corners, int count) {
        ObjGeometry& g = *static_cast<ObjGeometry*>(out);
        for (int i = 0; i < count; ++i)
            g.corners.push_back({fromObjIndex(corners[i].vertex_index, g.positionsRead),
                                 fromObjIndex(corners[i].texcoord_index, g.uvs.size()),
                                 fromObjIndex(corners[i].normal_index, g.normals.size())});
        g.faceEnds.push_back(static_cast<std::uint32_t>(g.corners.size()));
    };
    TextBuffer buffer(text.geometry);
    std::istream stream(&buffer);
    tinyobj::LoadObjWithCallback(stream, callbacks, &geometry);
    return geometry;
}

/// The materials and textures of a scene, made as faces use them.
class MaterialTable
{
public:
    MaterialTable(const QString& objPath, const LoadOptions& options, bool vertexColors, Scene& scene)
        : m_objPath(objPath), m_objDiagnostics(objPath), m_options(options), m_vertexColors(vertexColors),
          m_scene(scene)
    {
    }

    void loadLibraries(const std::vector<ObjReference>& libraries)
    {
        for (const ObjReference& library : libraries)
            for (const QString& name : libraryFiles(library.name))
                loadLibrary(name, library.line);
    }

    /// The index of a material in the scene.
    std::uint32_t use(const ObjReference& reference)
    {
        if (const auto known = m_used.find(reference.name); known != m_used.end())
            return *known;
        const auto found = m_library.find(reference.name);
        if (found == m_library.end() && !m_libraryMissing)
            m_objDiagnostics.warning(
                reference.line,
                {QT_TRANSLATE_NOOP("Diagnostic",
                                   "usemtl: no material %1 in the MTL files; the default material is used"),
                 {quotedWord(reference.name.toStdString())}});
        const std::uint32_t index = found == m_library.end() ? useDefault() : add(*found);
        m_used.insert(reference.name, index);
        return index;
    }

    /// The material of faces that name none.
    std::uint32_t useDefault()
    {
        if (!m_default)
            m_default = add(MtlMaterial{});
        return *m_default;
    }

    Diagnostics takeDiagnostics()
    {
        Diagnostics all = m_objDiagnostics.take();
        append(all, std::move(m_otherDiagnostics));
        return all;
    }

private:
    /// A name may hold blanks; otherwise `mtllib` takes several names.
    QStringList libraryFiles(const QString& names) const
    {
        if (QFileInfo::exists(pathOf(names)))
            return {names};
        return names.split(QLatin1Char(' '), Qt::SkipEmptyParts);
    }

    QString pathOf(QString name) const
    {
        name.replace(QLatin1Char('\\'), QLatin1Char('/'));
        return QFileInfo(m_objPath).dir().filePath(name);
    }

    void loadLibrary(const QString& name, int line)
    {
        const QString path = pathOf(name);
        if (m_read.contains(path))
            return;
        m_read.insert(path);
        InputBytes input = readInput(path);
        if (input.problem) {
            m_libraryMissing = true;
            m_objDiagnostics.warning(line,
                                     {QT_TRANSLATE_NOOP("Diagnostic", "mtllib %1: %2; the default material is used"),
                                      {path, *input.problem}});
            return;
        }
        DiagnosticSink diagnostics(path);
        for (const MtlMaterial& material : parseMtl(std::move(input.bytes), path, diagnostics))
            if (!m_library.contains(material.name))
                m_library.insert(material.name, material);
        append(m_otherDiagnostics, diagnostics.take());
    }

    std::uint32_t add(const MtlMaterial& mtl)
    {
        Material material;
        material.name = mtl.name;
        material.texture = m_options.texture.isEmpty() ? textureOf(mtl) : 0;
        const bool ownColor = material.texture >= 0 || m_vertexColors;
        material.diffuse = mtl.diffuse.value_or(ownColor ? glm::vec3(1) : kDefaultDiffuse);
        material.specular = mtl.specular;
        material.shininess = mtl.shininess.value_or(material.shininess);
        m_scene.materials.push_back(std::move(material));
        return static_cast<std::uint32_t>(m_scene.materials.size() - 1);
    }

    int textureOf(const MtlMaterial& mtl)
    {
        if (mtl.diffuseTexture.isEmpty())
            return -1;
        if (const auto known = m_textures.find(mtl.diffuseTexture); known != m_textures.end())
            return *known;
        TextureLoad load = loadTexture(mtl.diffuseTexture);
        int index = -1;
        if (load.texture) {
            index = static_cast<int>(m_scene.textures.size());
            m_scene.textures.push_back(std::move(*load.texture));
        } else {
            m_otherDiagnostics.push_back({Severity::Warning,
                                          mtl.file,
                                          mtl.textureLine,
                                          {QT_TRANSLATE_NOOP("Diagnostic", "map_Kd %1: %2; drawn without texture"),
                                           {mtl.diffuseTexture, *load.problem}}});
        }
        m_textures.insert(mtl.diffuseTexture, index);
        return index;
    }

    const QString m_objPath;
    DiagnosticSink m_objDiagnostics;
    Diagnostics m_otherDiagnostics;
    const LoadOptions& m_options;
    const bool m_vertexColors;
    Scene& m_scene;
    bool m_libraryMissing = false;
    QSet<QString> m_read;
    QHash<QString, MtlMaterial> m_library;
    QHash<QString, std::uint32_t> m_used;
    QHash<QString, int> m_textures;
    std::optional<std::uint32_t> m_default;
};

/// A triangle of the mesh to be: three indices into ObjGeometry::corners.
struct CornerTriangle {
    CornerTriple corners;
    std::uint32_t material;
};

std::vector<CornerTriangle> triangulateFaces(const ObjGeometry& geometry, const std::vector<ObjReference>& uses,
                                             MaterialTable& materials)
{
    std::vector<CornerTriangle> triangles;
    std::vector<glm::vec3> polygon;
    std::vector<CornerTriple> cut;
    std::optional<std::uint32_t> material;
    std::size_t use = 0;
    std::uint32_t begin = 0;
    for (std::size_t face = 0; face < geometry.faceEnds.size(); ++face) {
        bool changed = false;
        for (; use < uses.size() && uses[use].face == face; ++use)
            changed = true;
        if (changed)
            material = materials.use(uses[use - 1]);
        else if (!material)
            material = materials.useDefault();
        polygon.clear();
        for (std::uint32_t i = begin; i < geometry.faceEnds[face]; ++i)
            polygon.push_back(objectFromWorld(
                geometry.positions[static_cast<std::size_t>(geometry.corners[i].position)], geometry.origin));
        cut.clear();
        triangulate(polygon, cut);
        for (const CornerTriple& triple : cut)
            triangles.push_back({{begin + triple[0], begin + triple[1], begin + triple[2]}, *material});
        begin = geometry.faceEnds[face];
    }
    return triangles;
}

/// A unit vector, or nothing if the length is zero.
std::optional<glm::vec3> unit(const glm::dvec3& v)
{
    const double length = std::sqrt(glm::dot(v, v));
    if (!(length > 0))
        return std::nullopt;
    return glm::vec3(v / length);
}

/// Makes the vertex buffer: one vertex per distinct (position, uv, normal, material).
class MeshBuilder
{
public:
    MeshBuilder(const ObjGeometry& geometry, const std::vector<glm::vec3>& colors,
                const std::vector<Material>& materials)
        : m_geometry(geometry), m_colors(colors), m_materials(materials)
    {
    }

    Mesh build(const std::vector<CornerTriangle>& triangles)
    {
        sumNormals(triangles);
        m_mesh.origin = m_geometry.origin;
        m_mesh.indices.reserve(3 * triangles.size());
        m_vertexOfKey.reserve(m_geometry.positions.size());
        for (std::size_t face = 0; face < triangles.size(); ++face)
            for (const std::uint32_t corner : triangles[face].corners)
                m_mesh.indices.push_back(vertex(m_geometry.corners[corner], triangles[face], static_cast<int>(face)));
        if (m_materials.size() > 1)
            for (const CornerTriangle& triangle : triangles)
                m_mesh.faceMaterial.push_back(triangle.material);
        fillMissingUvs();
        return std::move(m_mesh);
    }

private:
    static constexpr int kSmooth = -1; ///< the normal of the position; below it, -2 - face, that of a face

    struct Key {
        int position;
        int uv;
        int normal;
        std::uint32_t material;

        friend bool operator==(const Key&, const Key&) = default;
    };

    struct KeyHash {
        std::size_t operator()(const Key& key) const
        {
            std::uint64_t hash = 0;
            for (const std::uint64_t part :
                 {static_cast<std::uint64_t>(key.position), static_cast<std::uint64_t>(key.uv),
                  static_cast<std::uint64_t>(key.normal), std::uint64_t{key.material}})
                hash = (hash ^ part) * 0x9E3779B97F4A7C15U + (hash >> 32);
            return hash ^ (hash >> 29);
        }
    };

    glm::dvec3 position(const Corner& corner) const
    {
        return glm::dvec3(
            objectFromWorld(m_geometry.positions[static_cast<std::size_t>(corner.position)], m_geometry.origin));
    }

    /// Twice the area vector of a triangle.
    glm::dvec3 areaVector(const CornerTriangle& triangle) const
    {
        const glm::dvec3 a = position(m_geometry.corners[triangle.corners[0]]);
        const glm::dvec3 b = position(m_geometry.corners[triangle.corners[1]]);
        const glm::dvec3 c = position(m_geometry.corners[triangle.corners[2]]);
        return glm::cross(b - a, c - a);
    }

    void sumNormals(const std::vector<CornerTriangle>& triangles)
    {
        m_normalSums.assign(m_geometry.positions.size(), glm::dvec3(0));
        for (const CornerTriangle& triangle : triangles) {
            const glm::dvec3 area = areaVector(triangle);
            for (const std::uint32_t corner : triangle.corners)
                m_normalSums[static_cast<std::size_t>(m_geometry.corners[corner].position)] += area;
        }
    }

    /// The normal of the file, else the smooth one, else that of the face.
    std::pair<int, glm::vec3> normal(const Corner& corner, const CornerTriangle& triangle, int face) const
    {
        if (corner.normal >= 0)
            if (const auto given = unit(glm::dvec3(m_geometry.normals[static_cast<std::size_t>(corner.normal)])))
                return {corner.normal, *given};
        if (const auto smooth = unit(m_normalSums[static_cast<std::size_t>(corner.position)]))
            return {kSmooth, *smooth};
        return {kSmooth - 1 - face, unit(areaVector(triangle)).value_or(glm::vec3(0, 0, 1))};
    }

    std::uint32_t vertex(const Corner& corner, const CornerTriangle& triangle, int face)
    {
        const auto [normalKey, normalObject] = normal(corner, triangle, face);
        const auto next = static_cast<std::uint32_t>(m_mesh.vertices.size());
        const auto [found, isNew] =
            m_vertexOfKey.try_emplace({corner.position, corner.uv, normalKey, triangle.material}, next);
        if (isNew) {
            const auto p = static_cast<std::size_t>(corner.position);
            const glm::vec3 vertexColor = m_colors.empty() ? glm::vec3(1) : m_colors[p];
            m_mesh.vertices.push_back(
                {.position = glm::vec4(objectFromWorld(m_geometry.positions[p], m_geometry.origin), 1),
                 .normal = normalObject,
                 .uv = corner.uv >= 0 ? m_geometry.uvs[static_cast<std::size_t>(corner.uv)] : glm::vec2(0),
                 .color = m_materials[triangle.material].diffuse * vertexColor});
            if (corner.uv < 0)
                m_withoutUv.push_back(next);
        }
        return found->second;
    }

    /// Planar, x and y across the bounding sphere.
    void fillMissingUvs()
    {
        if (m_withoutUv.empty())
            return;
        const BoundingSphere bounds = boundingSphere(m_mesh);
        for (const std::uint32_t i : m_withoutUv) {
            MeshVertex& vertex = m_mesh.vertices[i];
            vertex.uv =
                glm::vec2((glm::dvec2(vertex.position) - glm::dvec2(bounds.center)) / (2 * bounds.radius) + 0.5);
        }
    }

    const ObjGeometry& m_geometry;
    const std::vector<glm::vec3>& m_colors;
    const std::vector<Material>& m_materials;
    Mesh m_mesh;
    std::vector<glm::dvec3> m_normalSums;
    std::unordered_map<Key, std::uint32_t, KeyHash> m_vertexOfKey;
    std::vector<std::uint32_t> m_withoutUv;
};

Diagnostics fillScene(ObjText text, const QString& path, const LoadOptions& options, Scene& scene)
{
    ObjGeometry geometry = readGeometry(text);
    const BoundingBox box = boxInUse(geometry);
    geometry.origin = originFor(box);
    MaterialTable materials(path, options, !text.colors.empty(), scene);
    materials.loadLibraries(text.libraries);
    const std::vector<CornerTriangle> triangles = triangulateFaces(geometry, text.materialUses, materials);
    scene.mesh = MeshBuilder(geometry, text.colors, scene.materials).build(triangles);
    scene.bounds = boundingSphere(scene.mesh);
    Diagnostics diagnostics = materials.takeDiagnostics();
    if (const auto remark = remarkOnDistance(box))
        diagnostics.push_back({Severity::Warning, path, 0, *remark});
    return diagnostics;
}

void fillPeerScene(const ObjText& text, Scene& scene)
{
    PeerMesh peer = peerMesh(text);
    scene.mesh = std::move(peer.mesh);
    scene.bounds = peer.bounds;
    Material material;
    material.diffuse = kDefaultDiffuse;
    material.texture = scene.textures.empty() ? -1 : 0;
    scene.materials = {material};
}

} // namespace

SceneLoad loadObj(const QString& path, const LoadOptions& options)
{
    DiagnosticSink diagnostics(path);
    InputBytes input = readInput(path);
    if (input.problem)
        diagnostics.error(0, *input.problem);
    ObjText text;
    if (!diagnostics.hasErrors())
        text = checkObjText(std::move(input.bytes), diagnostics);
    if (diagnostics.hasErrors())
        return {std::nullopt, diagnostics.take()};

    Scene scene;
    scene.id = path;
    scene.title = QFileInfo(path).completeBaseName();
    if (!options.texture.isEmpty()) {
        TextureLoad texture = loadTexture(options.texture);
        if (!texture.texture)
            return {std::nullopt, {{Severity::Error, options.texture, 0, *texture.problem}}};
        scene.textures.push_back(std::move(*texture.texture));
    }
    Diagnostics all = diagnostics.take();
    if (options.peerMesh)
        fillPeerScene(text, scene);
    else
        append(all, fillScene(std::move(text), path, options, scene));
    return {std::move(scene), std::move(all)};
}

} // namespace rasterlens
