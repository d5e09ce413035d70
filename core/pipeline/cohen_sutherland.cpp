#include "core/pipeline/clipping.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr unsigned kSides = 4; // right, left, top, bottom: the order of ClipPlane

constexpr ClipLine lineOfSide(unsigned side) { return static_cast<ClipLine>(kFirstSide + side); }

/// The sides in the order of a counter-clockwise walk round the viewport, and back.
constexpr std::array<unsigned, kSides> kRound{0, 2, 1, 3};
constexpr std::array<unsigned, kSides> kPlaceOfSide{0, 2, 1, 3};

glm::dvec2 project(const glm::dvec4& p) { return glm::dvec2(p) / p.w; }

double cross(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

/// Where the line from NDC point a to b crosses a side of the viewport, as the fraction of the way.
double parameterAt(unsigned side, const glm::dvec2& a, const glm::dvec2& b)
{
    const int axis = side < 2 ? 0 : 1;
    const double border = side % 2 == 0 ? 1 : -1;
    return (border - a[axis]) / (b[axis] - a[axis]);
}

/// A point on a side of the viewport, so many pixels further inside as the rules say.
glm::dvec4 movedInward(glm::dvec4 positionClip, unsigned side, const Rules& rules)
{
    const int axis = side < 2 ? 0 : 1;
    const double border = side % 2 == 0 ? 1 : -1;
    const double ndcPerPixel = 2.0 / (axis == 0 ? rules.width : rules.height);
    positionClip[axis] -= border * rules.clipInset * ndcPerPixel * positionClip.w;
    return positionClip;
}

/// The point at the screen-linear parameter t between two clip-space points: perspective undone.
void interpolate(const ClipVertex& a, const ClipVertex& b, double t, int varyingCount, ClipVertex& point)
{
    const double wa = (1 - t) / a.positionClip.w;
    const double wb = t / b.positionClip.w;
    const double s = wb / (wa + wb);
    point.positionClip = a.positionClip + s * (b.positionClip - a.positionClip);
    for (std::size_t k = 0; k < static_cast<std::size_t>(varyingCount); ++k)
        point.varyings[k] = a.varyings[k] + static_cast<float>(s) * (b.varyings[k] - a.varyings[k]);
}

/// The point of the triangle a, b, c seen at an NDC point, if that point lies inside it.
bool findSeenAt(const glm::dvec2& ndc, const ClipVertex& a, const ClipVertex& b, const ClipVertex& c, int varyingCount,
                ClipVertex& point)
{
    const glm::dvec2 pa = project(a.positionClip) - ndc;
    const glm::dvec2 pb = project(b.positionClip) - ndc;
    const glm::dvec2 pc = project(c.positionClip) - ndc;
    const double area = cross(pa, pb) + cross(pb, pc) + cross(pc, pa);
    const glm::dvec3 weights = glm::dvec3(cross(pb, pc), cross(pc, pa), cross(pa, pb)) / area;
    if (!(weights.x >= 0 && weights.y >= 0 && weights.z >= 0))
        return false;
    glm::dvec3 s = weights / glm::dvec3(a.positionClip.w, b.positionClip.w, c.positionClip.w);
    s /= s.x + s.y + s.z;
    point.positionClip = s.x * a.positionClip + s.y * b.positionClip + s.z * c.positionClip;
    for (std::size_t k = 0; k < static_cast<std::size_t>(varyingCount); ++k)
        point.varyings[k] = static_cast<float>(s.x * a.varyings[k] + s.y * b.varyings[k] + s.z * c.varyings[k]);
    return true;
}

/// The vertex from which the polygon is drawn: the first one by its direction from the middle.
std::ptrdiff_t firstByDirection(const ClipPolygon& polygon, bool counterClockwise)
{
    glm::dvec2 middle(0, 0);
    for (const ClipVertex& v : polygon.span())
        middle += project(v.positionClip) / double(polygon.count);
    const auto angle = [&](const ClipVertex& v) {
        const glm::dvec2 d = project(v.positionClip) - middle;
        return counterClockwise ? std::atan2(d.y, d.x) : -std::atan2(d.y, d.x);
    };
    return std::ranges::min_element(polygon.span(), {}, angle) - polygon.span().begin();
}

/// One order for both faces that share an edge, so that both cut it at the same points.
bool comesFirst(const glm::dvec2& a, const glm::dvec2& b) { return std::pair(a.x, a.y) < std::pair(b.x, b.y); }

} // namespace

/// An end of an edge, or what it was moved to: where the edge crosses a side of the viewport.
struct Clipper::EdgeEnd {
    ClipCorner corner;
    SidesOf sides;
    std::optional<unsigned> side; ///< it was moved to
};

Clipper::SidesOf Clipper::sidesOf(ClipCorner corner, const glm::dvec4& estimate) const
{
    SidesOf sides{0, 0};
    for (unsigned side = 0; side < kSides; ++side) {
        const double guess = m_volume->view[lineOf(ClipPlane::Right) + side].distance(estimate);
        const double distance = m_lines.distance(corner, lineOfSide(side), guess);
        sides.outside |= distance < 0 ? 1U << side : 0U;
        sides.on |= distance == 0 ? 1U << side : 0U;
    }
    return sides;
}

/// Moves the end that is outside to a side it is outside of, until both ends are inside or the edge is out. An end
/// comes to no side twice, unless a mistake has left what lies behind the eye: such an edge is taken to be out.
bool Clipper::clipEdge(EdgeEnd& begin, EdgeEnd& end, ClipLine line) const
{
    constexpr unsigned kMostMoves = 2 * kSides;
    for (unsigned moves = 0; moves <= kMostMoves && (begin.sides.outside & end.sides.outside) == 0; ++moves) {
        if ((begin.sides.outside | end.sides.outside) == 0)
            return true;
        EdgeEnd& moved = begin.sides.outside != 0 ? begin : end;
        moved.side = static_cast<unsigned>(std::countr_zero(moved.sides.outside));
        const ClipLine sideLine = lineOfSide(*moved.side);
        moved.corner = &moved == &begin ? ClipCorner{sideLine, line} : ClipCorner{line, sideLine};
        moved.sides = sidesOf(moved.corner, glm::dvec4(std::numeric_limits<double>::quiet_NaN()));
    }
    return false;
}

/// Whether the polygon has the corner already.
bool Clipper::has(ClipCorner corner) const
{
    const auto known = std::span(m_now->corners).first(static_cast<std::size_t>(m_now->count));
    return std::ranges::find(known, corner) != known.end();
}

void Clipper::appendEnd(const EdgeEnd& end, const ClipVertex& vertex, const ClipVertex& other)
{
    if (has(end.corner))
        return;
    ClipVertex& point = append(end.corner);
    if (!end.side) {
        point = vertex;
        return;
    }
    const bool inOrder = comesFirst(project(vertex.positionClip), project(other.positionClip));
    const ClipVertex& a = inOrder ? vertex : other;
    const ClipVertex& b = inOrder ? other : vertex;
    const double t = parameterAt(*end.side, project(a.positionClip), project(b.positionClip));
    interpolate(a, b, t, m_rules->varyingCount, point);
    if (!isWellConditioned(a.positionClip, b.positionClip, std::min(a.positionClip.w, b.positionClip.w)) ||
        !isWellConditioned(a.positionClip, b.positionClip, point.positionClip.w))
        placeExactly(point, end.corner);
    point.positionClip = movedInward(point.positionClip, *end.side, *m_rules);
}

void Clipper::placeExactly(ClipVertex& point, ClipCorner corner) const
{
    point.positionClip = m_lines.position(corner);
    const Weights weights = m_lines.weights(corner);
    const auto& [a, b, c] = m_triangle->vertices;
    for (std::size_t k = 0; k < static_cast<std::size_t>(m_rules->varyingCount); ++k)
        point.varyings[k] =
            static_cast<float>(weights[0] * a.varyings[k] + weights[1] * b.varyings[k] + weights[2] * c.varyings[k]);
}

/// Adds a corner of the viewport where it lies inside the polygon.
void Clipper::appendViewportCorner(unsigned side, unsigned nextSide)
{
    if (!m_rules->clipKeepsCorners)
        return;
    const ClipCorner corner{lineOfSide(side), lineOfSide(nextSide)};
    if (has(corner)) // under a mistake the way round the viewport may come here twice
        return;
    const auto lines = std::span(m_before->corners).first(static_cast<std::size_t>(m_before->count));
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    if (!std::ranges::all_of(lines, [&](ClipCorner c) { return m_lines.distance(corner, c.leaving, kUnknown) >= 0; }))
        return;
    const unsigned vertical = side < 2 ? side : nextSide;
    const unsigned horizontal = side < 2 ? nextSide : side;
    const glm::dvec2 ndc(vertical == 0 ? 1 : -1, horizontal == 2 ? 1 : -1);
    ClipVertex& point = append(corner);
    for (std::size_t i = 2; i < lines.size(); ++i) {
        const ClipVertex& a = m_before->vertices[0];
        const ClipVertex& b = m_before->vertices[i - 1];
        const ClipVertex& c = m_before->vertices[i];
        if (!findSeenAt(ndc, a, b, c, m_rules->varyingCount, point))
            continue;
        const double smallestW = std::min({a.positionClip.w, b.positionClip.w, c.positionClip.w});
        if (isWellConditioned(a.positionClip, b.positionClip, smallestW) &&
            isWellConditioned(c.positionClip, c.positionClip, smallestW))
            return;
    }
    placeExactly(point, corner);
}

/// Walks along the border of the viewport from one side to another.
void Clipper::walkBorder(unsigned from, unsigned to, unsigned step)
{
    for (unsigned place = from; place != to; place = (place + step) % kSides)
        appendViewportCorner(kRound[place], kRound[(place + step) % kSides]);
}

void Clipper::cutByViewport()
{
    takeTurns();
    m_now->count = 0;
    m_lines.addSides();
    const ClipPolygon& from = *m_before;
    const auto n = static_cast<std::size_t>(from.count);
    std::array<SidesOf, ClipPolygon::kMaxVertices> sides{};
    for (std::size_t i = 0; i < n; ++i)
        sides[i] = sidesOf(from.corners[i], from.vertices[i].positionClip);
    const bool counterClockwise = m_lines.isCounterClockwise();
    const unsigned step = counterClockwise ? 1 : kSides - 1;
    // Where on the way round the viewport an end that was moved lies. One exactly at a corner of the viewport lies on
    // two sides: the outline enters from the first of them and leaves along the second.
    const auto placeOf = [&](const EdgeEnd& end, bool enters) -> std::optional<unsigned> {
        if (!end.side)
            return std::nullopt;
        const unsigned place = kPlaceOfSide[*end.side];
        const unsigned other = (place + (enters ? kSides - step : step)) % kSides;
        return (end.sides.on & 1U << kRound[other]) != 0 ? other : place;
    };
    std::optional<unsigned> entered; // where the first visible edge comes in, if it does
    std::optional<unsigned> left;    // where the last visible edge goes out, if it does
    bool isVisible = false;
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        EdgeEnd begin{from.corners[i], sides[i], {}};
        EdgeEnd end{from.corners[next], sides[next], {}};
        if (!clipEdge(begin, end, from.corners[i].leaving))
            continue;
        if (!isVisible)
            entered = placeOf(begin, true);
        else if (begin.side && left)
            walkBorder(*left, *placeOf(begin, true), step);
        appendEnd(begin, from.vertices[i], from.vertices[next]);
        appendEnd(end, from.vertices[next], from.vertices[i]);
        left = placeOf(end, false);
        isVisible = true;
    }
    if (left && entered)
        walkBorder(*left, *entered, step);
    for (unsigned i = 0; !isVisible && i < kSides; ++i) // all of the viewport, or nothing
        walkBorder(i * step % kSides, (i + 1) * step % kSides, step);
    if (m_now->count < 3)
        m_now->count = 0;
    const std::ptrdiff_t first = firstByDirection(*m_now, counterClockwise);
    std::rotate(m_now->vertices.begin(), m_now->vertices.begin() + first, m_now->vertices.begin() + m_now->count);
    std::rotate(m_now->corners.begin(), m_now->corners.begin() + first, m_now->corners.begin() + m_now->count);
}

} // namespace rasterlens
