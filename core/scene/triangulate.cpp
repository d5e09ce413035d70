#include "core/scene/triangulate.h"

#include <cmath>
#include <numeric>

namespace rasterlens
{
namespace
{

constexpr std::uint64_t kMostPointTests = 50'000'000;

/// Twice the signed area vector of the polygon (Newell), about corner 0 so that far-away polygons lose no digits.
glm::dvec3 areaVector(std::span<const glm::vec3> corners)
{
    const glm::dvec3 origin(corners[0]);
    glm::dvec3 sum(0);
    for (std::size_t i = 1; i + 1 < corners.size(); ++i)
        sum += glm::cross(glm::dvec3(corners[i]) - origin, glm::dvec3(corners[i + 1]) - origin);
    return sum;
}

/// The polygon along the axis in which its area is largest, counter-clockwise.
std::vector<glm::dvec2> projected(std::span<const glm::vec3> corners)
{
    const glm::dvec3 area = areaVector(corners);
    const glm::dvec3 size = glm::abs(area);
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const double mirror = area[axis] < 0 ? -1 : 1;
    std::vector<glm::dvec2> points;
    points.reserve(corners.size());
    for (const glm::vec3& corner : corners)
        points.emplace_back(mirror * corner[u], corner[v]);
    return points;
}

/// Twice the signed area of a triangle, positive if it is counter-clockwise.
double area2(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// No corner turns right.
bool isConvex(const std::vector<glm::dvec2>& points)
{
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i)
        if (area2(points[i], points[(i + 1) % count], points[(i + 2) % count]) < 0)
            return false;
    return true;
}

class EarClipper
{
public:
    EarClipper(std::vector<glm::dvec2> points, std::vector<CornerTriple>& triangles)
        : m_points(std::move(points)), m_triangles(triangles), m_left(static_cast<std::uint32_t>(m_points.size())),
          m_next(m_left), m_previous(m_left), m_reflex(m_left)
    {
        for (std::uint32_t i = 0; i < m_left; ++i) {
            m_next[i] = (i + 1) % m_left;
            m_previous[i] = (i + m_left - 1) % m_left;
        }
        for (std::uint32_t i = 0; i < m_left; ++i)
            if (turn(i) < 0) {
                m_reflex[i] = true;
                m_reflexCorners.push_back(i);
            }
    }

    void run()
    {
        std::uint32_t corner = 1;
        std::uint32_t triedInVain = 0;
        while (m_left > 3 && !m_reflexCorners.empty() && m_tests < kMostPointTests && triedInVain < m_left) {
            if (isEar(corner)) {
                cut(corner);
                triedInVain = 0;
            } else {
                ++triedInVain;
            }
            corner = m_next[corner];
        }
        fanTheRest(m_previous[corner]);
    }

private:
    double turn(std::uint32_t i) const { return area2(m_points[m_previous[i]], m_points[i], m_points[m_next[i]]); }

    /// A convex corner whose triangle holds no other corner; only reflex ones can lie in it.
    bool isEar(std::uint32_t i)
    {
        if (m_reflex[i])
            return false;
        const glm::dvec2 a = m_points[m_previous[i]];
        const glm::dvec2 b = m_points[i];
        const glm::dvec2 c = m_points[m_next[i]];
        for (const std::uint32_t other : m_reflexCorners) {
            ++m_tests;
            const glm::dvec2 p = m_points[other];
            if (other == m_previous[i] || other == m_next[i] || p == a || p == c)
                continue;
            if (area2(a, b, p) >= 0 && area2(b, c, p) >= 0 && area2(c, a, p) >= 0)
                return false;
        }
        return true;
    }

    void cut(std::uint32_t i)
    {
        const std::uint32_t before = m_previous[i];
        const std::uint32_t after = m_next[i];
        m_triangles.push_back({before, i, after});
        m_next[before] = after;
        m_previous[after] = before;
        --m_left;
        for (const std::uint32_t neighbour : {before, after})
            if (m_reflex[neighbour] && turn(neighbour) >= 0) {
                m_reflex[neighbour] = false;
                std::erase(m_reflexCorners, neighbour);
            }
    }

    void fanTheRest(std::uint32_t hub)
    {
        for (std::uint32_t i = m_next[hub]; m_next[i] != hub; i = m_next[i])
            m_triangles.push_back({hub, i, m_next[i]});
    }

    std::vector<glm::dvec2> m_points;
    std::vector<CornerTriple>& m_triangles;
    std::uint32_t m_left;
    std::vector<std::uint32_t> m_next; // the corners that are left, as a ring
    std::vector<std::uint32_t> m_previous;
    std::vector<bool> m_reflex;
    std::vector<std::uint32_t> m_reflexCorners;
    std::uint64_t m_tests = 0;
};

} // namespace

void triangulate(std::span<const glm::vec3> corners, std::vector<CornerTriple>& triangles)
{
    if (corners.size() == 3) {
        triangles.push_back({0, 1, 2});
        return;
    }
    std::vector<glm::dvec2> points = projected(corners);
    if (isConvex(points))
        for (std::uint32_t i = 2; i < points.size(); ++i)
            triangles.push_back({0, i - 1, i});
    else
        EarClipper(std::move(points), triangles).run();
}

} // namespace rasterlens
