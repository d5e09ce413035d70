#include "core/io/peer_mesh.h"

#include <cmath>
#include <unordered_map>

namespace rasterlens
{
namespace
{

/// Polygons as fans: three corners a triangle, and the line of each triangle.
struct Fans {
    std::vector<ObjCorner> corners;
    std::vector<std::int32_t> lines;
};

Fans fansOf(const ObjText& text)
{
    Fans fans;
    std::uint32_t begin = 0;
    for (const ObjFace& face : text.faces) {
        for (std::uint32_t k = begin + 2; k < face.cornersEnd; ++k) {
            fans.corners.insert(fans.corners.end(), {text.corners[begin], text.corners[k - 1], text.corners[k]});
            fans.lines.push_back(face.line);
        }
        begin = face.cornersEnd;
    }
    return fans;
}

BoundingSphere boundsOf(const std::vector<glm::dvec3>& positions)
{
    Mesh points;
    points.vertices.reserve(positions.size());
    for (const glm::dvec3& position : positions)
        points.vertices.push_back({.position = glm::vec4(position, 1)});
    return boundingSphere(points);
}

/// Cross products of the triangles summed up at their positions, in the order of the file.
std::vector<glm::vec3> normalSums(const ObjText& text, const std::vector<ObjCorner>& corners)
{
    std::vector<glm::vec3> sums(text.positions.size(), glm::vec3(0));
    const auto at = [&](std::size_t corner) { return static_cast<std::size_t>(corners[corner].position); };
    for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
        const glm::vec3 a(text.positions[at(i)]);
        const glm::vec3 e = glm::vec3(text.positions[at(i + 1)]) - a;
        const glm::vec3 g = glm::vec3(text.positions[at(i + 2)]) - a;
        const glm::vec3 normal(e.y * g.z - e.z * g.y, e.z * g.x - e.x * g.z, e.x * g.y - e.y * g.x);
        for (std::size_t j = 0; j < 3; ++j)
            sums[at(i + j)] += normal;
    }
    return sums;
}

glm::vec3 unit(const glm::vec3& sum)
{
    const glm::dvec3 n(sum);
    const double length = std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    return length == 0 ? sum : glm::vec3(n / length);
}

glm::vec2 planarUv(const glm::vec3& position, const BoundingSphere& bounds)
{
    return {static_cast<float>((position.x - bounds.center.x) / (2 * bounds.radius) + 0.5),
            static_cast<float>((position.y - bounds.center.y) / (2 * bounds.radius) + 0.5)};
}

} // namespace

PeerMesh peerMesh(const ObjText& text)
{
    Fans fans = fansOf(text);
    PeerMesh out;
    out.bounds = boundsOf(text.positions);
    const std::vector<glm::vec3> normals = normalSums(text, fans.corners);
    std::unordered_map<std::int64_t, std::uint32_t> vertexOfCorner;
    for (const ObjCorner& corner : fans.corners) {
        const std::int64_t key = (std::int64_t{corner.position} << 32) + corner.uv + 1;
        const auto [found, isNew] =
            vertexOfCorner.try_emplace(key, static_cast<std::uint32_t>(out.mesh.vertices.size()));
        if (isNew) {
            const auto p = static_cast<std::size_t>(corner.position);
            const glm::vec3 position(text.positions[p]);
            out.mesh.vertices.push_back(
                {.position = glm::vec4(position, 1),
                 .normal = unit(normals[p]),
                 .uv = corner.uv >= 0 ? text.uvs[static_cast<std::size_t>(corner.uv)] : planarUv(position, out.bounds),
                 .color = kPeerColor});
        }
        out.mesh.indices.push_back(found->second);
    }
    out.mesh.faceLine = std::move(fans.lines);
    return out;
}

} // namespace rasterlens
