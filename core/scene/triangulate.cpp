#include "core/scene/triangulate.h"

#include "core/scene/ear_clipper.h"
#include "core/scene/orientation.h"

#include <cmath>

namespace rasterlens
{
namespace
{

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
void project(std::span<const glm::vec3> corners, std::span<glm::dvec2> points)
{
    const glm::dvec3 area = areaVector(corners);
    const glm::dvec3 size = glm::abs(area);
    const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    const double mirror = area[axis] < 0 ? -1 : 1;
    for (std::size_t i = 0; i < corners.size(); ++i)
        points[i] = {mirror * corners[i][u], corners[i][v]};
}

/// No corner turns right.
bool isConvex(std::span<const glm::dvec2> points)
{
    const std::size_t count = points.size();
    for (std::size_t i = 0; i < count; ++i)
        if (orientation(points[i], points[(i + 1) % count], points[(i + 2) % count]) < 0)
            return false;
    return true;
}

/// Whether the triangles' areas add up to the polygon's: where some overlap, or turn the other way round, they do not.
bool fillsOutline(std::span<const glm::dvec2> points, std::span<const CornerTriple> triangles)
{
    constexpr double kRounding = 1e-9;
    double sum = 0;
    double sizes = 0;
    for (const auto& [a, b, c] : triangles) {
        const double area = orientation(points[a], points[b], points[c]);
        sum += area;
        sizes += std::abs(area);
    }
    return sizes - std::abs(sum) <= kRounding * sizes;
}

Cut cutProjected(std::span<const glm::dvec2> points, std::vector<CornerTriple>& triangles)
{
    const std::size_t before = triangles.size();
    if (isConvex(points))
        for (std::uint32_t i = 2; i < points.size(); ++i)
            triangles.push_back({0, i - 1, i});
    else
        clipEars(points, triangles);
    return fillsOutline(points, std::span(triangles).subspan(before)) ? Cut::Exact : Cut::Overlaps;
}

} // namespace

Cut triangulate(std::span<const glm::vec3> corners, std::vector<CornerTriple>& triangles)
{
    if (corners.size() == 3) {
        triangles.push_back({0, 1, 2});
        return Cut::Exact;
    }
    constexpr std::size_t kFew = 16;
    std::array<glm::dvec2, kFew> few;
    std::vector<glm::dvec2> many(corners.size() <= kFew ? 0 : corners.size());
    const std::span<glm::dvec2> points =
        corners.size() <= kFew ? std::span(few).first(corners.size()) : std::span(many);
    project(corners, points);
    return cutProjected(points, triangles);
}

} // namespace rasterlens
