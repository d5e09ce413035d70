#include "core/pipeline/geometry.h"

#include "core/pipeline/vertex_stage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr std::uint32_t kNotDrawn = std::numeric_limits<std::uint32_t>::max(); ///< in place of a triangle's number

bool isFinite(const glm::dvec4& p)
{
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z) && std::isfinite(p.w);
}

/// Corners of a polygon, as indices.
struct Outline {
    std::array<std::size_t, ClipPolygon::kMaxVertices + 1> corners;
    std::size_t count = 0;

    void add(std::size_t corner) { corners[count++] = corner; }
};

double cornerArea2(std::span<const ScreenVertex> polygon, std::size_t a, std::size_t b, std::size_t c)
{
    return twiceArea(polygon[a].position, polygon[b].position, polygon[c].position);
}

/// Whether all triangles of the fan round a corner turn the polygon's way.
bool seesAll(std::span<const ScreenVertex> polygon, std::size_t apex, double sense)
{
    const std::size_t n = polygon.size();
    for (std::size_t i = 1; i + 1 < n; ++i)
        if (cornerArea2(polygon, apex, (apex + i) % n, (apex + i + 1) % n) * sense < 0)
            return false;
    return true;
}

/// The outline from the first corner that sees all of it, if there is one; or from the leftmost one of them (of those
/// the topmost).
std::optional<Outline> outlineSeenFromACorner(std::span<const ScreenVertex> polygon, double sense, bool fromTheLeft)
{
    const std::size_t n = polygon.size();
    const auto isLeftOf = [&](std::size_t a, std::size_t b) {
        const glm::dvec2& p = polygon[a].position;
        const glm::dvec2& q = polygon[b].position;
        return std::pair(p.x, p.y) < std::pair(q.x, q.y);
    };
    std::optional<std::size_t> apex;
    for (std::size_t corner = 0; corner < n && (!apex || fromTheLeft); ++corner)
        if ((!apex || isLeftOf(corner, *apex)) && seesAll(polygon, corner, sense))
            apex = corner;
    if (!apex)
        return std::nullopt;
    Outline outline;
    for (std::size_t k = 0; k < n; ++k)
        outline.add((*apex + k) % n);
    return outline;
}

/// The corners of the convex hull in the sense given, from the leftmost (of those the topmost) on.
///
/// source  Andrew, Another efficient algorithm for convex hulls in two dimensions, Information Processing Letters
///         9(5), 1979
Outline convexHull(std::span<const ScreenVertex> polygon, double sense)
{
    std::array<std::size_t, ClipPolygon::kMaxVertices> sorted{};
    const auto end = sorted.begin() + static_cast<std::ptrdiff_t>(polygon.size());
    std::iota(sorted.begin(), end, std::size_t{0});
    std::sort(sorted.begin(), end, [&](std::size_t a, std::size_t b) {
        const glm::dvec2& p = polygon[a].position;
        const glm::dvec2& q = polygon[b].position;
        return std::pair(p.x, p.y) < std::pair(q.x, q.y);
    });
    Outline hull;
    const auto addChain = [&](auto first, auto last) {
        const std::size_t start = hull.count;
        for (auto corner = first; corner != last; ++corner) {
            while (hull.count >= start + 2 &&
                   cornerArea2(polygon, hull.corners[hull.count - 2], hull.corners[hull.count - 1], *corner) * sense <=
                       0)
                --hull.count;
            hull.add(*corner);
        }
        --hull.count; // the next chain starts with it
    };
    addChain(sorted.begin(), end);
    addChain(std::make_reverse_iterator(end), sorted.rend());
    return hull;
}

} // namespace

FaceStages::FaceStages(const Scene& scene, const Matrices& matrices, const Rules& rules)
    : m_scene(&scene), m_rules(rules), m_eyeObject(matrices.eyeObject), m_toViewer(matrices.toViewer),
      m_near(matrices.near), m_far(matrices.far), m_volume(clipVolume(rules))
{
}

void FaceStages::processVertex(ProcessedVertex& v) const
{
    v.finite = isFinite(v.clip.positionClip);
    v.beforeEye = isBeforeEye(v.clip);
    if (!v.finite)
        return;
    v.outcode = outcode(v.clip.positionClip, m_volume);
    if (v.outcode.cut == 0)
        v.screen = screenVertex(v.clip);
}

int FaceStages::appendFan(std::uint32_t face, std::span<const ScreenVertex> polygon, double area2,
                          std::vector<ScreenTriangle>& out) const
{
    const std::optional<Outline> seen =
        outlineSeenFromACorner(polygon, area2, m_rules.coverageRule != CoverageRule::Centre);
    const Outline outline = seen ? *seen : convexHull(polygon, area2);
    int pieces = 0;
    for (std::size_t i = 1; i + 1 < outline.count; ++i) {
        const auto [a, b, c] = std::tuple(outline.corners[0], outline.corners[i], outline.corners[i + 1]);
        const double pieceArea2 = cornerArea2(polygon, a, b, c);
        if (pieceArea2 != 0) {
            out.push_back({{polygon[a], polygon[b], polygon[c]}, face, pieceArea2, false, 0});
            ++pieces;
        }
    }
    return pieces;
}

FaceFate FaceStages::appendCutLine(std::uint32_t face, const ClipPolygon& polygon,
                                   std::span<const ScreenVertex> vertices, std::vector<ScreenTriangle>& out)
{
    const auto count = static_cast<std::size_t>(polygon.count);
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        if (polygon.corners[i].leaving != kEdgeAB || polygon.corners[next].arriving != kEdgeAB)
            continue;
        out.push_back({{vertices[i], vertices[next], vertices[next]}, face, 0, true, 0});
        return FaceFate::Rasterized;
    }
    return FaceFate::Rejected;
}

double FaceStages::facingElsewhere(std::uint32_t face, const Corners& corners) const
{
    const ClipTriangle triangle{{corners[0]->clip, corners[1]->clip, corners[2]->clip}, face};
    switch (m_rules.facing) {
    case Facing::ViewNormal:
        return m_rules.orthographic ? directionFacing(m_scene->mesh, face, m_toViewer)
                                    : viewFacing(m_scene->mesh, face, m_eyeObject);
    case Facing::LightNormal: return directionFacing(m_scene->mesh, face, glm::dvec3(m_rules.light));
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
    : m_scene(&scene), m_rules(rules), m_stages(scene, matrices, rules), m_sharing(rules)
{
    m_vertices.reserve(scene.mesh.vertices.size());
    for (std::size_t i = 0; i < scene.mesh.vertices.size(); ++i) {
        ProcessedVertex& vertex = m_vertices.emplace_back();
        shadeVertexAt(scene, matrices, rules, i, vertex.clip);
        m_stages.processVertex(vertex);
    }
    if (rules.fill == Fill::Wireframe && rules.sharedEdgesOnce)
        findSharedEdges();
}

/// Takes all faces through the stages once, in the order they are drawn in.
void Geometry::findSharedEdges()
{
    std::vector<std::uint32_t> first(m_scene->mesh.faceCount(), kNotDrawn);
    std::vector<ScreenTriangle> triangles;
    NullObserver nobody;
    for (const std::uint32_t face : order()) {
        if (isFirstPass(m_rules, face)) // it is filled
            continue;
        triangles.clear();
        const FaceFate fate = process(face, triangles, nobody);
        if (fate == FaceFate::Rejected && !m_rules.continuesAfterReject)
            break;
        bool isFirst = true;
        for (const ScreenTriangle& triangle : triangles) {
            if (triangle.isLine)
                continue;
            const std::uint32_t number = m_sharing.add(triangle);
            if (std::exchange(isFirst, false))
                first[face] = number;
        }
    }
    m_firstTriangle = std::move(first);
}

void Geometry::markSharedEdges(std::uint32_t face, std::span<ScreenTriangle> pieces) const
{
    if (m_firstTriangle[face] == kNotDrawn)
        return;
    for (std::size_t i = 0; i < pieces.size(); ++i)
        pieces[i].sharedEdges = m_sharing.of(m_firstTriangle[face] + static_cast<std::uint32_t>(i));
}

std::vector<std::uint32_t> Geometry::order() const
{
    std::vector<std::uint32_t> order(m_scene->mesh.faceCount());
    std::iota(order.begin(), order.end(), 0U);
    if (!m_rules.painter)
        return order;
    // Distance: w is the depth in view space of a perspective camera; all others have their z/w.
    const bool perspective = m_scene->space == SceneSpace::Object && !m_rules.orthographic;
    const double sign = m_rules.reversedZ ? -1 : 1;
    std::vector<double> distance(order.size());
    for (const std::uint32_t face : order)
        for (std::uint32_t i = 0; i < 3; ++i) {
            const glm::dvec4& p = corner(face, i).clip.positionClip;
            const double d = perspective ? p.w : sign * p.z / p.w;
            distance[face] += std::isfinite(d) ? d : 0;
        }
    // Each pass is sorted by itself.
    const auto secondPass = order.begin() + static_cast<std::ptrdiff_t>(m_rules.firstPassFaces);
    const auto isFarther = [&](std::uint32_t a, std::uint32_t b) { return distance[a] > distance[b]; };
    std::stable_sort(order.begin(), secondPass, isFarther);
    std::stable_sort(secondPass, order.end(), isFarther);
    return order;
}

} // namespace rasterlens
