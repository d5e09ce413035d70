#pragma once
// What the tests of the exact reference share: faces given in pixels, and sums over a frame.
#include "core/truth/exact_reference.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <vector>

namespace rasterlens::test
{

inline ClipVertex clipVertex(glm::dvec4 position, glm::vec3 color = {1, 1, 1})
{
    ClipVertex vertex{};
    vertex.positionClip = position;
    vertex.varyings[0] = color.r;
    vertex.varyings[1] = color.g;
    vertex.varyings[2] = color.b;
    return vertex;
}

/// Builds faces from pixel positions of an 8 x 8 viewport, where every 1/256 px is a float.
class Faces
{
public:
    explicit Faces(int size = 8) : m_size(size) {}

    Faces& pixels(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c) { return clip(at(a), at(b), at(c)); }
    Faces& clip(glm::dvec4 a, glm::dvec4 b, glm::dvec4 c)
    {
        m_triangles.push_back(
            {{clipVertex(a), clipVertex(b), clipVertex(c)}, static_cast<std::uint32_t>(m_triangles.size())});
        return *this;
    }
    [[nodiscard]] glm::dvec4 at(glm::dvec2 p) const { return {2 * p.x / m_size - 1, 1 - 2 * p.y / m_size, 0, 1}; }
    [[nodiscard]] const std::vector<ClipTriangle>& list() const { return m_triangles; }
    [[nodiscard]] ExactOptions options(bool snap = true) const
    {
        ExactOptions options;
        options.size = {m_size, m_size};
        options.snap = snap;
        return options;
    }
    [[nodiscard]] ExactFrame draw(bool snap = true) const { return exactReference(m_triangles, options(snap)); }

private:
    int m_size;
    std::vector<ClipTriangle> m_triangles;
};

inline std::uint32_t totalCover(const ExactFrame& frame)
{
    return std::accumulate(frame.cover.begin(), frame.cover.end(), 0U);
}

inline bool everySampleOnce(const ExactFrame& frame)
{
    return std::all_of(frame.cover.begin(), frame.cover.end(), [](std::uint32_t n) { return n == 1; });
}

} // namespace rasterlens::test
