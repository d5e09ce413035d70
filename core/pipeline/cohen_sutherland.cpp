#include "core/pipeline/clipping.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

namespace rasterlens
{
namespace
{

// The nine regions of the projected plane: one bit a side of the viewport.
constexpr unsigned kLeft = 1;
constexpr unsigned kRight = 2;
constexpr unsigned kBelow = 4;
constexpr unsigned kAbove = 8;

glm::dvec2 project(const glm::dvec4& p) { return glm::dvec2(p) / p.w; }

unsigned region(const glm::dvec2& ndc)
{
    return (ndc.x < -1 ? kLeft : 0U) | (ndc.x > 1 ? kRight : 0U) | (ndc.y < -1 ? kBelow : 0U) |
           (ndc.y > 1 ? kAbove : 0U);
}

/// What is left of a line from NDC point a to b, as parameters along it.
struct Segment {
    double begin;
    double end;
};

/// Moves the end that is outside to the side it is outside of, until both ends are inside or the line is out.
std::optional<Segment> clipSegment(const glm::dvec2& a, const glm::dvec2& b)
{
    Segment s{0, 1};
    const auto parameterAt = [&](unsigned code) {
        if ((code & kLeft) != 0)
            return (-1 - a.x) / (b.x - a.x);
        if ((code & kRight) != 0)
            return (1 - a.x) / (b.x - a.x);
        if ((code & kBelow) != 0)
            return (-1 - a.y) / (b.y - a.y);
        return (1 - a.y) / (b.y - a.y);
    };
    unsigned beginCode = region(a);
    unsigned endCode = region(b);
    for (int i = 0; i < 4 && (beginCode | endCode) != 0; ++i) {
        if ((beginCode & endCode) != 0)
            return std::nullopt;
        const bool moveBegin = beginCode != 0;
        const unsigned side = (moveBegin ? beginCode : endCode);
        const double t = parameterAt(side);
        const unsigned done = side & (~side + 1); // the side just dealt with: rounding must not bring it back
        const unsigned code = region(a + t * (b - a)) & ~done;
        (moveBegin ? s.begin : s.end) = t;
        (moveBegin ? beginCode : endCode) = code;
        if (s.begin > s.end)
            return std::nullopt;
    }
    return s;
}

/// The point at the screen-linear parameter t between two clip-space points: perspective undone.
ClipVertex pointAt(const ClipVertex& a, const ClipVertex& b, double t, int varyingCount)
{
    const double wa = (1 - t) / a.positionClip.w;
    const double wb = t / b.positionClip.w;
    const double s = wb / (wa + wb);
    ClipVertex p;
    p.positionClip = a.positionClip + s * (b.positionClip - a.positionClip);
    for (std::size_t k = 0; k < static_cast<std::size_t>(varyingCount); ++k)
        p.varyings[k] = a.varyings[k] + static_cast<float>(s) * (b.varyings[k] - a.varyings[k]);
    return p;
}

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// The point of the triangle a, b, c seen at an NDC point, if that point lies inside it.
std::optional<ClipVertex> pointSeenAt(const glm::dvec2& ndc, const ClipVertex& a, const ClipVertex& b,
                                      const ClipVertex& c, int varyingCount)
{
    const glm::dvec2 pa = project(a.positionClip) - ndc;
    const glm::dvec2 pb = project(b.positionClip) - ndc;
    const glm::dvec2 pc = project(c.positionClip) - ndc;
    const double area = cross(pa, pb) + cross(pb, pc) + cross(pc, pa);
    const glm::dvec3 weights = glm::dvec3(cross(pb, pc), cross(pc, pa), cross(pa, pb)) / area;
    if (!(weights.x >= 0 && weights.y >= 0 && weights.z >= 0))
        return std::nullopt;
    glm::dvec3 s = weights / glm::dvec3(a.positionClip.w, b.positionClip.w, c.positionClip.w);
    s /= s.x + s.y + s.z;
    ClipVertex p;
    p.positionClip = s.x * a.positionClip + s.y * b.positionClip + s.z * c.positionClip;
    for (std::size_t k = 0; k < static_cast<std::size_t>(varyingCount); ++k)
        p.varyings[k] = static_cast<float>(s.x * a.varyings[k] + s.y * b.varyings[k] + s.z * c.varyings[k]);
    return p;
}

class PolygonBuilder
{
public:
    void add(const ClipVertex& vertex)
    {
        for (const ClipVertex& v : m_polygon.span())
            if (v.positionClip == vertex.positionClip)
                return;
        assert(m_polygon.count < ClipPolygon::kMaxVertices);
        m_polygon.vertices[static_cast<std::size_t>(m_polygon.count++)] = vertex;
    }

    /// Sorts the points of a convex polygon round their middle.
    [[nodiscard]] ClipPolygon finish(bool counterClockwise)
    {
        if (m_polygon.count < 3)
            m_polygon.count = 0;
        glm::dvec2 middle(0, 0);
        for (const ClipVertex& v : m_polygon.span())
            middle += project(v.positionClip) / double(m_polygon.count);
        const auto angle = [&](const ClipVertex& v) {
            const glm::dvec2 d = project(v.positionClip) - middle;
            return counterClockwise ? std::atan2(d.y, d.x) : -std::atan2(d.y, d.x);
        };
        std::stable_sort(m_polygon.vertices.begin(), m_polygon.vertices.begin() + m_polygon.count,
                         [&](const ClipVertex& a, const ClipVertex& b) { return angle(a) < angle(b); });
        return m_polygon;
    }

private:
    ClipPolygon m_polygon{.vertices = {}, .count = 0};
};

double signedArea(const ClipPolygon& polygon)
{
    double area = 0;
    for (std::size_t i = 0, n = static_cast<std::size_t>(polygon.count); i < n; ++i)
        area += cross(project(polygon.vertices[i].positionClip), project(polygon.vertices[(i + 1) % n].positionClip));
    return area;
}

/// One order for both faces that share an edge, so that both cut it at the same points.
bool comesFirst(const glm::dvec2& a, const glm::dvec2& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); }

} // namespace

ClipPolygon clipCohenSutherland(const ClipPolygon& polygon, const Rules& rules)
{
    const int varyingCount = rules.varyingCount;
    PolygonBuilder builder;
    const std::size_t n = static_cast<std::size_t>(polygon.count);
    for (std::size_t i = 0; i < n; ++i) {
        const ClipVertex* a = &polygon.vertices[i];
        const ClipVertex* b = &polygon.vertices[(i + 1) % n];
        if (comesFirst(project(b->positionClip), project(a->positionClip)))
            std::swap(a, b);
        if (const auto s = clipSegment(project(a->positionClip), project(b->positionClip))) {
            builder.add(s->begin == 0 ? *a : pointAt(*a, *b, s->begin, varyingCount));
            builder.add(s->end == 1 ? *b : pointAt(*a, *b, s->end, varyingCount));
        }
    }
    if (rules.clipKeepsCorners)
        for (const glm::dvec2 corner : {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)})
            for (std::size_t i = 2; i < n; ++i)
                if (const auto p = pointSeenAt(corner, polygon.vertices[0], polygon.vertices[i - 1],
                                               polygon.vertices[i], varyingCount)) {
                    builder.add(*p);
                    break;
                }
    return builder.finish(signedArea(polygon) > 0);
}

} // namespace rasterlens
