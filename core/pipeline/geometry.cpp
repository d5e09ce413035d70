#include "core/pipeline/geometry.h"

#include "core/pipeline/interpolation.h"
#include "core/pipeline/vertex_stage.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rasterlens
{
namespace
{

bool isFinite(const glm::dvec4& p)
{
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

/// Fan triangles of a polygon seen from one of its corners, as indices.
struct FanTriangle {
    std::array<std::size_t, 3> corners;
    double area2;
};

struct Fan {
    std::array<FanTriangle, ClipPolygon::kMaxVertices> triangles;
    std::size_t count = 0;

    [[nodiscard]] std::span<const FanTriangle> span() const { return {triangles.data(), count}; }
};

Fan fanFrom(std::size_t apex, std::span<const ScreenVertex> polygon)
{
    Fan fan;
    const std::size_t n = polygon.size();
    for (std::size_t i = 1; i + 1 < n; ++i) {
        const std::array<std::size_t, 3> c{apex, (apex + i) % n, (apex + i + 1) % n};
        const double area2 = twiceArea(polygon[c[0]].position, polygon[c[1]].position, polygon[c[2]].position);
        if (area2 != 0)
            fan.triangles[fan.count++] = {c, area2};
    }
    return fan;
}

} // namespace

FaceStages::FaceStages(const Scene& scene, const Matrices& matrices, const Rules& rules)
    : m_scene(&scene), m_rules(rules), m_eyeWorld(matrices.eyeWorld), m_near(matrices.near), m_far(matrices.far),
      m_volume(clipVolume(rules))
{
}

ProcessedVertex FaceStages::processVertex(const ClipVertex& vertex) const
{
    ProcessedVertex v;
    v.clip = vertex;
    v.finite = isFinite(v.clip.positionClip);
    if (!v.finite)
        return v;
    v.outcode = outcode(v.clip.positionClip, m_volume);
    if (v.outcode.cut == 0)
        v.screen = screenVertex(v.clip);
    return v;
}

int FaceStages::appendFan(std::uint32_t face, std::span<const ScreenVertex> polygon, std::vector<ScreenTriangle>& out)
{
    const double area2 = twicePolygonArea(polygon);
    const auto sameWay = [&](const FanTriangle& t) { return (t.area2 > 0) == (area2 > 0); };
    Fan fan;
    for (std::size_t apex = 0; apex < polygon.size(); ++apex) {
        fan = fanFrom(apex, polygon);
        if (const auto triangles = fan.span(); std::all_of(triangles.begin(), triangles.end(), sameWay))
            break;
    }
    int pieces = 0;
    for (const FanTriangle& t : fan.span())
        if (sameWay(t)) {
            out.push_back({{polygon[t.corners[0]], polygon[t.corners[1]], polygon[t.corners[2]]}, face});
            ++pieces;
        }
    return pieces;
}

double FaceStages::facingElsewhere(std::uint32_t face, const Corners& corners) const
{
    const ClipTriangle triangle{{corners[0]->clip, corners[1]->clip, corners[2]->clip}, face};
    switch (m_rules.facing) {
    case Facing::ViewNormal: return viewFacing(m_scene->mesh, face, m_eyeWorld);
    case Facing::LightNormal: return lightFacing(m_scene->mesh, face);
    case Facing::AreaWithoutDivide: return areaWithoutDivide(triangle);
    case Facing::AreaWithoutClipping: return areaWithoutClipping(triangle);
    case Facing::ScreenArea:
    case Facing::ClipDeterminant: break;
    }
    return clipDeterminant(triangle);
}

void FaceStages::giveWOfCorners(const Corners& corners, std::span<ScreenTriangle> pieces)
{
    for (ScreenTriangle& piece : pieces)
        for (std::size_t i = 0; i < 3; ++i)
            piece.vertices[i].invW = 1 / corners[i]->clip.positionClip.w;
}

Geometry::Geometry(const Scene& scene, const Matrices& matrices, const Rules& rules)
    : m_scene(&scene), m_rules(rules), m_stages(scene, matrices, rules)
{
    m_vertices.reserve(scene.mesh.vertices.size());
    for (const ClipVertex& vertex : shadeVertices(scene, matrices, rules))
        m_vertices.push_back(m_stages.processVertex(vertex));
}

std::vector<std::uint32_t> Geometry::order() const
{
    std::vector<std::uint32_t> order(m_scene->mesh.faceCount());
    std::iota(order.begin(), order.end(), 0U);
    if (!m_rules.painter)
        return order;
    // Distance: w is the depth in view space of a perspective camera; clip-space scenes have their z/w.
    const bool perspective = m_scene->space == SceneSpace::Object;
    const double sign = m_rules.mirrorClipZ ? -1 : 1;
    std::vector<double> distance(order.size());
    for (const std::uint32_t face : order)
        for (std::uint32_t i = 0; i < 3; ++i) {
            const glm::dvec4& p = corner(face, i).clip.positionClip;
            const double d = perspective ? p.w : sign * p.z / p.w;
            distance[face] += std::isfinite(d) ? d : 0;
        }
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return distance[a] > distance[b]; });
    return order;
}

} // namespace rasterlens
