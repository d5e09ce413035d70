#include "core/io/peer_mesh.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <unordered_map>

namespace rasterlens
{
namespace
{

constexpr glm::vec3 kColor{0.8F, 0.7F, 0.6F};

struct Corner {
    std::int64_t position;
    std::int64_t uv; ///< -1 none
};

struct PeerObj {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec2> uvs;
    std::vector<Corner> corners; ///< three a triangle
};

template <int N>
glm::vec<N, float> numbers(std::string_view rest)
{
    glm::vec<N, float> values(0);
    for (int i = 0; i < N; ++i)
        values[i] = decimalFromText(nextWord(rest)).value;
    return values;
}

/// An index of a corner, counted from 0; -1 if the text is empty.
std::int64_t index(std::string_view digits, std::size_t count)
{
    std::int64_t value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value < 0 ? value + static_cast<std::int64_t>(count) : value - 1;
}

void addFan(std::string_view rest, PeerObj& obj)
{
    std::vector<Corner> polygon;
    for (std::string_view word = nextWord(rest); !word.empty(); word = nextWord(rest)) {
        const std::size_t slash = std::min(word.find('/'), word.size());
        const std::string_view afterSlash = word.substr(std::min(slash + 1, word.size()));
        polygon.push_back({index(word.substr(0, slash), obj.positions.size()),
                           index(afterSlash.substr(0, afterSlash.find('/')), obj.uvs.size())});
    }
    for (std::size_t k = 2; k < polygon.size(); ++k)
        obj.corners.insert(obj.corners.end(), {polygon[0], polygon[k - 1], polygon[k]});
}

PeerObj read(QByteArray text)
{
    PeerObj obj;
    LineCursor lines(text, Continuation::None);
    while (const auto line = lines.next()) {
        std::string_view rest = line->text();
        const std::string_view keyword = nextWord(rest);
        if (keyword == "v")
            obj.positions.push_back(numbers<3>(rest));
        else if (keyword == "vt")
            obj.uvs.push_back(numbers<2>(rest));
        else if (keyword == "f")
            addFan(rest, obj);
    }
    return obj;
}

BoundingSphere boundsOf(const std::vector<glm::vec3>& positions)
{
    Mesh points;
    points.vertices.reserve(positions.size());
    for (const glm::vec3& position : positions)
        points.vertices.push_back({.position = glm::vec4(position, 1)});
    return boundingSphere(points);
}

/// Cross products of the triangles summed up at their positions, in the order of the file.
std::vector<glm::vec3> normalSums(const PeerObj& obj)
{
    std::vector<glm::vec3> sums(obj.positions.size(), glm::vec3(0));
    const auto at = [&](std::size_t corner) { return static_cast<std::size_t>(obj.corners[corner].position); };
    for (std::size_t i = 0; i + 2 < obj.corners.size(); i += 3) {
        const glm::vec3 e = obj.positions[at(i + 1)] - obj.positions[at(i)];
        const glm::vec3 g = obj.positions[at(i + 2)] - obj.positions[at(i)];
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
    const PeerObj obj = read(text.geometry);
    PeerMesh out;
    out.bounds = boundsOf(obj.positions);
    const std::vector<glm::vec3> normals = normalSums(obj);
    std::unordered_map<std::int64_t, std::uint32_t> vertexOfCorner;
    for (const Corner& corner : obj.corners) {
        const std::int64_t key = (corner.position << 32) + corner.uv + 1;
        const auto [found, isNew] =
            vertexOfCorner.try_emplace(key, static_cast<std::uint32_t>(out.mesh.vertices.size()));
        if (isNew) {
            const auto p = static_cast<std::size_t>(corner.position);
            const glm::vec3& position = obj.positions[p];
            out.mesh.vertices.push_back(
                {.position = glm::vec4(position, 1),
                 .normal = unit(normals[p]),
                 .uv = corner.uv >= 0 ? obj.uvs[static_cast<std::size_t>(corner.uv)] : planarUv(position, out.bounds),
                 .color = kColor});
        }
        out.mesh.indices.push_back(found->second);
    }
    return out;
}

} // namespace rasterlens
