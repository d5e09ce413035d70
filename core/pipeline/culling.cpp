#include "core/pipeline/culling.h"

#include "core/pipeline/interpolation.h"

namespace rasterlens
{

double twicePolygonArea(std::span<const ScreenVertex> polygon)
{
    double area = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        area += twiceArea(polygon[0].position, polygon[i - 1].position, polygon[i].position);
    return area;
}

double clipDeterminant(const ClipTriangle& triangle)
{
    const auto xyw = [&](std::size_t i) {
        const glm::dvec4& p = triangle.vertices[i].positionClip;
        return glm::dvec3(p.x, p.y, p.w);
    };
    return glm::dot(xyw(0), glm::cross(xyw(1), xyw(2)));
}

double viewFacing(const Mesh& mesh, std::uint32_t face, const glm::dvec3& eyeWorld)
{
    const auto position = [&](std::uint32_t corner) {
        return glm::dvec3(mesh.vertices[mesh.indices[3 * face + corner]].position);
    };
    const glm::dvec3 a = position(0);
    return glm::dot(glm::cross(position(1) - a, position(2) - a), eyeWorld - a);
}

FaceFate cull(double signedArea, const Rules& rules)
{
    if (signedArea == 0)
        return FaceFate::Degenerate;
    const bool front = signedArea * rules.frontSign > 0;
    if (front && rules.culling == Culling::Front)
        return FaceFate::CulledFront;
    if (!front && rules.culling == Culling::Back)
        return FaceFate::CulledBack;
    return FaceFate::Rasterized;
}

} // namespace rasterlens
