#include "core/pipeline/culling.h"

#include "core/pipeline/interpolation.h"

namespace rasterlens
{
namespace
{

glm::dvec3 cornerOf(const Mesh& mesh, std::uint32_t face, std::uint32_t corner)
{
    return mesh.vertices[mesh.indices[3 * face + corner]].position;
}

glm::dvec3 normalOf(const Mesh& mesh, std::uint32_t face)
{
    const glm::dvec3 a = cornerOf(mesh, face, 0);
    return glm::cross(cornerOf(mesh, face, 1) - a, cornerOf(mesh, face, 2) - a);
}

} // namespace

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

double areaWithoutDivide(const ClipTriangle& triangle)
{
    const auto& [a, b, c] = triangle.vertices;
    return -twiceArea(glm::dvec2(a.positionClip), glm::dvec2(b.positionClip), glm::dvec2(c.positionClip));
}

double areaWithoutClipping(const ClipTriangle& triangle)
{
    const auto divided = [&](std::size_t i) {
        const glm::dvec4& p = triangle.vertices[i].positionClip;
        return glm::dvec2(p) / p.w;
    };
    return -twiceArea(divided(0), divided(1), divided(2));
}

double viewFacing(const Mesh& mesh, std::uint32_t face, const glm::dvec3& eyeObject)
{
    return glm::dot(normalOf(mesh, face), eyeObject - cornerOf(mesh, face, 0));
}

double directionFacing(const Mesh& mesh, std::uint32_t face, const glm::dvec3& towards)
{
    return glm::dot(normalOf(mesh, face), towards);
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
