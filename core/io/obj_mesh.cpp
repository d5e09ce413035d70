#include "core/io/obj_mesh.h"

#include "core/scene/origin.h"
#include "core/scene/triangulate.h"

#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr std::size_t kManyCorners = 1000; ///< of a polygon, most of whose triangles are thin
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// A triangle of the mesh to be: three indices into ObjText::corners, and the face it is a part of.
struct CornerTriangle {
    CornerTriple corners;
    std::uint32_t face;
};

std::size_t indexOf(int index) { return static_cast<std::size_t>(index); }

/// The box of the positions that faces use.
BoundingBox boxInUse(const ObjText& text)
{
    BoundingBox box;
    for (const ObjCorner& corner : text.corners)
        box.add(text.positions[indexOf(corner.position)]);
    return box;
}

/// The positions in object space.
std::vector<glm::vec3> objectPositions(const ObjText& text, const glm::dvec3& origin)
{
    std::vector<glm::vec3> positions;
    positions.reserve(text.positions.size());
    for (const glm::dvec3& world : text.positions)
        positions.push_back(objectFromWorld(world, origin));
    return positions;
}

std::vector<CornerTriangle> triangulateFaces(const ObjText& text, const std::vector<glm::vec3>& positions,
                                             DiagnosticSink& diagnostics)
{
    std::vector<CornerTriangle> triangles;
    triangles.reserve(text.corners.size() - 2 * text.faces.size());
    std::vector<glm::vec3> polygon;
    std::vector<CornerTriple> cut;
    std::uint32_t begin = 0;
    for (std::uint32_t face = 0; face < text.faces.size(); ++face) {
        const std::uint32_t end = text.faces[face].cornersEnd;
        polygon.clear();
        for (std::uint32_t i = begin; i < end && end - begin > 3; ++i)
            polygon.push_back(positions[indexOf(text.corners[i].position)]);
        cut.assign(1, {0, 1, 2});
        if (!polygon.empty()) {
            cut.clear();
            if (triangulate(polygon, cut) == Cut::Overlaps)
                diagnostics.warning(
                    text.faces[face].line,
                    {QT_TRANSLATE_NOOP("Diagnostic",
                                       "f: the outline of %1 corners crosses itself; its inside is a guess"),
                     {polygon.size()}});
            else if (polygon.size() >= kManyCorners)
                diagnostics.note(
                    text.faces[face].line,
                    {QT_TRANSLATE_NOOP("Diagnostic", "f: %1 corners, cut without overlap; where corners come close to "
                                                     "each other on the screen, snapping turns thin triangles over, "
                                                     "and single samples are drawn twice"),
                     {polygon.size()}});
        }
        for (const CornerTriple& triple : cut)
            triangles.push_back({{begin + triple[0], begin + triple[1], begin + triple[2]}, face});
        begin = end;
    }
    return triangles;
}

/// A unit vector, or nothing if the length is zero.
std::optional<glm::vec3> unit(const glm::dvec3& v)
{
    const double length = std::sqrt(glm::dot(v, v));
    if (!(length > 0) || !std::isfinite(length))
        return std::nullopt;
    return glm::vec3(v / length);
}

/// The sums of area vectors, one for each position and smoothing group that meet.
class SmoothNormals
{
public:
    explicit SmoothNormals(std::size_t positions) : m_first(positions, kNone) { m_sums.reserve(positions); }

    void add(int position, int group, const glm::dvec3& area)
    {
        std::uint32_t& first = m_first[indexOf(position)];
        std::uint32_t at = first;
        while (at != kNone && m_sums[at].group != group)
            at = m_sums[at].next;
        if (at == kNone) {
            at = static_cast<std::uint32_t>(m_sums.size());
            m_sums.push_back({glm::dvec3(0), group, std::exchange(first, at)});
        }
        m_sums[at].area += area;
    }

    [[nodiscard]] const glm::dvec3& at(int position, int group) const
    {
        std::uint32_t at = m_first[indexOf(position)];
        while (m_sums[at].group != group)
            at = m_sums[at].next;
        return m_sums[at].area;
    }

private:
    struct Sum {
        glm::dvec3 area;
        int group;
        std::uint32_t next; ///< of the same position
    };

    std::vector<std::uint32_t> m_first;
    std::vector<Sum> m_sums;
};

/// Makes the vertex buffer: one vertex per distinct (position, uv, normal, material).
class MeshBuilder
{
public:
    MeshBuilder(const ObjText& text, const std::vector<glm::vec3>& positions,
                const std::vector<std::uint32_t>& materialOfFace, const std::vector<Material>& materials)
        : m_text(text), m_positions(positions), m_materialOfFace(materialOfFace), m_materials(materials),
          m_smooth(positions.size()), m_firstVertex(positions.size(), kNone)
    {
    }

    Mesh build(const std::vector<CornerTriangle>& triangles)
    {
        sumNormals(triangles);
        m_mesh.vertices.reserve(m_text.positions.size());
        m_keys.reserve(m_text.positions.size());
        m_mesh.indices.reserve(3 * triangles.size());
        m_mesh.faceLine.reserve(triangles.size());
        for (const CornerTriangle& triangle : triangles) {
            for (const std::uint32_t corner : triangle.corners)
                m_mesh.indices.push_back(vertex(m_text.corners[corner], triangle.face));
            m_mesh.faceLine.push_back(m_text.faces[triangle.face].line);
        }
        if (m_materials.size() > 1) {
            m_mesh.faceMaterial.reserve(triangles.size());
            for (const CornerTriangle& triangle : triangles)
                m_mesh.faceMaterial.push_back(m_materialOfFace[triangle.face]);
        }
        fillMissingUvs();
        return std::move(m_mesh);
    }

private:
    /// What makes two vertices of one position the same.
    struct Key {
        std::int64_t normal; ///< from 0: of the file; below it: see normal()
        int uv;
        std::uint32_t material;

        friend bool operator==(const Key&, const Key&) = default;
    };

    struct KeyAt {
        Key key;
        int position;

        friend bool operator==(const KeyAt&, const KeyAt&) = default;
    };

    struct KeyHash {
        std::size_t operator()(const KeyAt& at) const
        {
            std::uint64_t hash = 0;
            for (const std::uint64_t part :
                 {static_cast<std::uint64_t>(at.position), static_cast<std::uint64_t>(at.key.uv),
                  static_cast<std::uint64_t>(at.key.normal), std::uint64_t{at.key.material}})
                hash = (hash ^ part) * 0x9E3779B97F4A7C15U + (hash >> 32);
            return hash ^ (hash >> 29);
        }
    };

    struct Link {
        Key key;
        std::uint32_t next; ///< vertex of the same position
    };

    glm::dvec3 position(std::uint32_t corner) const { return m_positions[indexOf(m_text.corners[corner].position)]; }

    void sumNormals(const std::vector<CornerTriangle>& triangles)
    {
        m_faceArea.assign(m_text.faces.size(), glm::dvec3(0));
        for (const CornerTriangle& triangle : triangles) {
            const auto& [a, b, c] = triangle.corners;
            const glm::dvec3 area = glm::cross(position(b) - position(a), position(c) - position(a));
            m_faceArea[triangle.face] += area;
            const int group = m_text.faces[triangle.face].smoothingGroup;
            if (group == ObjFace::kFlat)
                continue;
            for (const std::uint32_t corner : triangle.corners)
                m_smooth.add(m_text.corners[corner].position, group, area);
        }
    }

    /// The normal of the file, else the smooth one, else that of the face.
    std::pair<std::int64_t, glm::vec3> normal(const ObjCorner& corner, std::uint32_t face) const
    {
        constexpr std::int64_t kSmooth = -2;
        constexpr std::int64_t kOfFace = std::numeric_limits<std::int64_t>::min();
        if (corner.normal >= 0)
            if (const auto given = unit(glm::dvec3(m_text.normals[indexOf(corner.normal)])))
                return {corner.normal, *given};
        const int group = m_text.faces[face].smoothingGroup;
        if (group != ObjFace::kFlat)
            if (const auto smooth = unit(m_smooth.at(corner.position, group)))
                return {kSmooth - group, *smooth};
        return {kOfFace + face, unit(m_faceArea[face]).value_or(glm::vec3(0, 0, 1))};
    }

    /// The vertex of a corner. Vertices of one position form a chain; where the chain grows long, a hash finds them.
    std::uint32_t vertex(const ObjCorner& corner, std::uint32_t face)
    {
        constexpr int kLongChain = 24;
        const auto [normalKey, normalObject] = normal(corner, face);
        const Key key{normalKey, corner.uv, m_materialOfFace[face]};
        std::uint32_t& first = m_firstVertex[indexOf(corner.position)];
        int looked = 0;
        for (std::uint32_t at = first; at != kNone && looked < kLongChain; at = m_keys[at].next, ++looked)
            if (m_keys[at].key == key)
                return at;
        const auto next = static_cast<std::uint32_t>(m_mesh.vertices.size());
        if (looked == kLongChain) {
            const auto [found, isNew] = m_vertexOfKey.try_emplace({key, corner.position}, next);
            if (!isNew)
                return found->second;
            m_keys.push_back({key, kNone});
        } else {
            m_keys.push_back({key, std::exchange(first, next)});
        }
        addVertex(corner, normalObject, key.material);
        return next;
    }

    void addVertex(const ObjCorner& corner, const glm::vec3& normalObject, std::uint32_t material)
    {
        const std::size_t p = indexOf(corner.position);
        const glm::vec3 vertexColor = m_text.colors.empty() ? glm::vec3(1) : m_text.colors[p];
        if (corner.uv < 0)
            m_withoutUv.push_back(static_cast<std::uint32_t>(m_mesh.vertices.size()));
        m_mesh.vertices.push_back({.position = glm::vec4(m_positions[p], 1),
                                   .normal = normalObject,
                                   .uv = corner.uv >= 0 ? m_text.uvs[indexOf(corner.uv)] : glm::vec2(0),
                                   .color = m_materials[material].diffuse * vertexColor});
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

    const ObjText& m_text;
    const std::vector<glm::vec3>& m_positions; ///< object space
    const std::vector<std::uint32_t>& m_materialOfFace;
    const std::vector<Material>& m_materials;
    Mesh m_mesh;
    SmoothNormals m_smooth;
    std::vector<glm::dvec3> m_faceArea;       ///< area vectors
    std::vector<std::uint32_t> m_firstVertex; ///< of each position
    std::vector<Link> m_keys;                 ///< of each vertex
    std::unordered_map<KeyAt, std::uint32_t, KeyHash> m_vertexOfKey;
    std::vector<std::uint32_t> m_withoutUv;
};

} // namespace

Mesh makeObjMesh(const ObjText& text, const std::vector<std::uint32_t>& materialOfFace,
                 const std::vector<Material>& materials, DiagnosticSink& diagnostics)
{
    const BoundingBox box = boxInUse(text);
    const glm::dvec3 origin = originFor(box);
    const std::vector<glm::vec3> positions = objectPositions(text, origin);
    const std::vector<CornerTriangle> triangles = triangulateFaces(text, positions, diagnostics);
    Mesh mesh = MeshBuilder(text, positions, materialOfFace, materials).build(triangles);
    mesh.origin = origin;
    if (const auto remark = remarkOnDistance(box))
        diagnostics.warning(0, *remark);
    return mesh;
}

} // namespace rasterlens
