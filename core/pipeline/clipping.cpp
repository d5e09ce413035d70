#include "core/pipeline/clipping.h"

#include "core/pipeline/viewport.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr ClipPlanes kNearFar = planeBit(ClipPlane::Near) | planeBit(ClipPlane::Far);
constexpr ClipPlanes kSides =
    planeBit(ClipPlane::Right) | planeBit(ClipPlane::Left) | planeBit(ClipPlane::Top) | planeBit(ClipPlane::Bottom);

/// The guard band ends this many pixels from the origin, so that edge values fit 64 bits.
constexpr double kGuardBandPixels = 32768;

/// Half-width of the guard band in units of w, for a viewport of so many pixels.
double guardFactor(int pixels) { return 2 * kGuardBandPixels / pixels - 1; }

PlaneTable planeTable(double gx, double gy, const Rules& rules)
{
    PlaneTable table;
    const auto plane = [&](ClipPlane p) -> PlaneEquation& { return table[static_cast<std::size_t>(p)]; };
    plane(ClipPlane::W) = {{0, 0, 0, 1}, kSmallestW};
    plane(ClipPlane::Right) = {{-1, 0, 0, gx}};
    plane(ClipPlane::Left) = {{1, 0, 0, gx}};
    plane(ClipPlane::Top) = {{0, -1, 0, gy}};
    plane(ClipPlane::Bottom) = {{0, 1, 0, gy}};
    plane(ClipPlane::Near) = {{0, 0, 1, rules.clipZ == ClipZ::Gl ? 1.0 : 0.0}};
    plane(ClipPlane::Far) = {{0, 0, -1, 1}};
    return table;
}

} // namespace

ClipVolume clipVolume(const Rules& rules)
{
    ClipVolume volume;
    volume.view = planeTable(1, 1, rules);
    volume.hasGuardBand = rules.clipping == Clipping::GuardBand || rules.clipping == Clipping::CohenSutherland;
    volume.cut =
        volume.hasGuardBand ? planeTable(guardFactor(rules.width), guardFactor(rules.height), rules) : volume.view;
    volume.known = kNearFar | kSides;
    switch (rules.clipping) {
    case Clipping::FrustumW: volume.known |= planeBit(ClipPlane::W); [[fallthrough]];
    case Clipping::Frustum:
    case Clipping::GuardBand:
    case Clipping::CohenSutherland: volume.cutBy = volume.known; break;
    case Clipping::DepthClamp:
        volume.known = kSides | planeBit(ClipPlane::W);
        volume.cutBy = volume.known;
        break;
    case Clipping::AnyVertexInside:
    case Clipping::NearFarReject:
    case Clipping::None: volume.cutBy = 0; break;
    }
    return volume;
}

Outcode outcode(const glm::dvec4& positionClip, const ClipVolume& volume)
{
    Outcode code{};
    for (unsigned i = 0; i < volume.view.size(); ++i)
        if ((volume.known & 1U << i) != 0 && volume.view[i].distance(positionClip) < 0)
            code.view |= 1U << i;
    if (!volume.hasGuardBand) {
        code.cut = code.view & volume.cutBy;
        return code;
    }
    for (unsigned i = 0; i < volume.cut.size(); ++i)
        if ((volume.cutBy & 1U << i) != 0 && volume.cut[i].carefulDistance(positionClip) < 0)
            code.cut |= 1U << i;
    return code;
}

ClipVerdict clipVerdict(Clipping mode, const Outcode& a, const Outcode& b, const Outcode& c)
{
    switch (mode) {
    case Clipping::None: return ClipVerdict::Keep;
    case Clipping::AnyVertexInside:
        return a.view == 0 || b.view == 0 || c.view == 0 ? ClipVerdict::Keep : ClipVerdict::Reject;
    case Clipping::NearFarReject:
        return ((a.view | b.view | c.view) & kNearFar) != 0 ? ClipVerdict::Reject : ClipVerdict::Keep;
    case Clipping::Frustum:
    case Clipping::FrustumW:
    case Clipping::GuardBand:
    case Clipping::DepthClamp:
    case Clipping::CohenSutherland: break;
    }
    if ((a.view & b.view & c.view) != 0)
        return ClipVerdict::Reject;
    const ClipPlanes crossed = mode == Clipping::CohenSutherland ? a.view | b.view | c.view : a.cut | b.cut | c.cut;
    return crossed != 0 ? ClipVerdict::Cut : ClipVerdict::Keep;
}

bool isDividedBoxOutside(const std::array<const ClipVertex*, 3>& corners)
{
    const auto allBeyond = [&](auto axis, double sign) {
        return std::ranges::all_of(corners, [&](const ClipVertex* corner) {
            return sign * (corner->positionClip.*axis) / corner->positionClip.w > 1;
        });
    };
    return allBeyond(&glm::dvec4::x, 1) || allBeyond(&glm::dvec4::x, -1) || allBeyond(&glm::dvec4::y, 1) ||
           allBeyond(&glm::dvec4::y, -1);
}

Clipper::Clipper(const ClipTriangle& triangle, const ClipVolume& volume, ClipPlanes crossed, const Rules& rules)
    : m_triangle(&triangle), m_volume(&volume), m_rules(&rules), m_crossed(crossed & volume.cutBy),
      m_lines(triangle, volume.cut, volume.view, m_crossed)
{
    m_now->count = 0;
    append({kEdgeCA, kEdgeAB}) = triangle.vertices[0];
    append({kEdgeAB, kEdgeBC}) = triangle.vertices[1];
    append({kEdgeBC, kEdgeCA}) = triangle.vertices[2];
}

ClipVertex& Clipper::append(ClipCorner corner)
{
    assert(m_now->count < ClipPolygon::kMaxVertices);
    const auto last = static_cast<std::size_t>(m_now->count++);
    m_now->corners[last] = corner;
    return m_now->vertices[last];
}

bool Clipper::isBeforeEye() const
{
    return std::ranges::all_of(m_now->span(), [](const ClipVertex& v) { return v.positionClip.w > 0; });
}

bool Clipper::isNew(std::size_t vertex) const { return !TriangleLines::isVertex(m_now->corners[vertex]); }

glm::dvec2 Clipper::snapped(std::size_t vertex) const
{
    if (m_rules->cutStore != CutStore::InPlace)
        return m_lines.snapped(m_now->corners[vertex], *m_rules);
    // What is cut in place does not keep to its lines.
    const glm::dvec4& p = m_now->vertices[vertex].positionClip;
    const int shortBy = m_rules->viewportShort;
    return {snapToGrid(p.x, p.w, m_rules->width - shortBy, m_rules->subpixelBits),
            snapToGrid(m_rules->screenUp * p.y, p.w, m_rules->height - shortBy, m_rules->subpixelBits)};
}

bool isWellConditioned(const glm::dvec4& a, const glm::dvec4& b, double w)
{
    constexpr double kLongest = 0x1p20; // in units of the new w; double then keeps 2^-33 of it
    double longest = 0;
    for (int k = 0; k < 4; ++k)
        longest = std::max({longest, std::abs(a[k]), std::abs(b[k])});
    return longest <= kLongest * w;
}

void Clipper::cutBy(ClipPlane plane)
{
    takeTurns();
    m_now->count = 0;
    ClipPolygon& from = *m_before;
    const auto n = static_cast<std::size_t>(from.count);
    for (std::size_t i = 0; i < n; ++i) {
        const double estimate = m_volume->cut[lineOf(plane)].carefulDistance(from.vertices[i].positionClip);
        from.distances[i] = m_rules->cutStore == CutStore::InPlace
                                ? estimate
                                : m_lines.distance(from.corners[i], lineOf(plane), estimate);
    }
    const auto addCut = [&](std::size_t inside, std::size_t outside, ClipCorner corner) {
        const ClipVertex& a = from.vertices[inside];
        const ClipVertex& b = from.vertices[outside];
        const double t = cutParameter(from.distances[inside], from.distances[outside]);
        ClipVertex& cut = append(corner);
        cut.positionClip = a.positionClip + t * (b.positionClip - a.positionClip);
        // This is decided by the edge alone, so that both faces at it decide alike.
        if (!isWellConditioned(a.positionClip, b.positionClip, cut.positionClip.w))
            cut.positionClip = m_lines.position(corner);
        const float s = static_cast<float>(t);
        for (std::size_t k = 0; k < static_cast<std::size_t>(m_rules->varyingCount); ++k)
            cut.varyings[k] =
                m_rules->clipInterpolates ? a.varyings[k] + s * (b.varyings[k] - a.varyings[k]) : b.varyings[k];
    };
    // In place, the second cut at a corner is made from where the first one has moved it: it falls on the first.
    const auto isMoved = [&](std::size_t outside) {
        return m_rules->cutStore == CutStore::InPlace && from.distances[(outside + n - 1) % n] >= 0;
    };
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t next = (i + 1) % n;
        const bool isInside = from.distances[i] >= 0;
        const bool nextInside = from.distances[next] >= 0;
        if (isInside)
            append(from.corners[i]) = from.vertices[i];
        if (isInside && !nextInside)
            addCut(i, next, {from.corners[i].leaving, lineOf(plane)});
        else if (!isInside && nextInside && !isMoved(i))
            addCut(next, i, {lineOf(plane), from.corners[i].leaving});
    }
    if (m_now->count < 3)
        m_now->count = 0;
}

} // namespace rasterlens
