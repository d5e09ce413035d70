#include "core/pipeline/clipping.h"

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
constexpr double kSmallestW = 1e-5;

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
    for (PlaneEquation& equation : table)
        equation.offset += rules.clipInset;
    return table;
}

ClipPlanes outside(const glm::dvec4& position, const PlaneTable& planes, ClipPlanes among)
{
    ClipPlanes code = 0;
    for (unsigned i = 0; i < planes.size(); ++i)
        if ((among & 1U << i) != 0 && planes[i].distance(position) < 0)
            code |= 1U << i;
    return code;
}

} // namespace

ClipVolume clipVolume(const Rules& rules)
{
    ClipVolume volume;
    volume.view = planeTable(1, 1, rules);
    const bool hasGuardBand = rules.clipping == Clipping::GuardBand || rules.clipping == Clipping::CohenSutherland;
    volume.cut = hasGuardBand ? planeTable(guardFactor(rules.width), guardFactor(rules.height), rules) : volume.view;
    volume.known = kNearFar | kSides;
    switch (rules.clipping) {
    case Clipping::FrustumW: volume.known |= planeBit(ClipPlane::W); [[fallthrough]];
    case Clipping::Frustum:
    case Clipping::GuardBand:
    case Clipping::CohenSutherland: volume.cutBy = volume.known; break;
    case Clipping::AnyVertexInside:
    case Clipping::NearFarReject:
    case Clipping::None: volume.cutBy = 0; break;
    }
    return volume;
}

Outcode outcode(const glm::dvec4& positionClip, const ClipVolume& volume)
{
    return {outside(positionClip, volume.view, volume.known), outside(positionClip, volume.cut, volume.cutBy)};
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
    case Clipping::CohenSutherland: break;
    }
    if ((a.view & b.view & c.view) != 0)
        return ClipVerdict::Reject;
    const ClipPlanes crossed = mode == Clipping::CohenSutherland ? a.view | b.view | c.view : a.cut | b.cut | c.cut;
    return crossed != 0 ? ClipVerdict::Cut : ClipVerdict::Keep;
}

namespace
{

/// Where an edge crosses a plane. Whether the short way is good enough is decided by the edge alone, so that both
/// faces at an edge decide alike.
glm::dvec4 cutPosition(const glm::dvec4& inside, const glm::dvec4& outside, double t, const PlaneEquation& plane)
{
    constexpr double kLongest = 0x1p20; // in units of the new w; double then keeps 2^-33 of it
    const glm::dvec4 cut = inside + t * (outside - inside);
    double longest = 0;
    for (int k = 0; k < 4; ++k)
        longest = std::max({longest, std::abs(inside[k]), std::abs(outside[k])});
    return longest <= kLongest * cut.w ? cut : cutExactly(inside, outside, plane);
}

} // namespace

double cutParameter(const glm::dvec4& a, const glm::dvec4& b, const PlaneEquation& plane)
{
    const double da = plane.distance(a);
    const double db = plane.distance(b);
    return da / (da - db);
}

ClipPolygon polygonOf(const ClipTriangle& triangle)
{
    ClipPolygon polygon;
    std::copy(triangle.vertices.begin(), triangle.vertices.end(), polygon.vertices.begin());
    polygon.count = 3;
    return polygon;
}

ClipPolygon clipByPlane(const ClipPolygon& polygon, const PlaneEquation& plane, int varyingCount)
{
    ClipPolygon out;
    out.count = 0;
    const auto addCut = [&](const ClipVertex& inside, const ClipVertex& outside) {
        assert(out.count < ClipPolygon::kMaxVertices);
        ClipVertex& cut = out.vertices[static_cast<std::size_t>(out.count++)];
        const double t = cutParameter(inside.positionClip, outside.positionClip, plane);
        cut.positionClip = cutPosition(inside.positionClip, outside.positionClip, t, plane);
        const float s = static_cast<float>(t);
        for (std::size_t k = 0; k < static_cast<std::size_t>(varyingCount); ++k)
            cut.varyings[k] = inside.varyings[k] + s * (outside.varyings[k] - inside.varyings[k]);
    };
    for (std::size_t i = 0, n = static_cast<std::size_t>(polygon.count); i < n; ++i) {
        const ClipVertex& current = polygon.vertices[i];
        const ClipVertex& next = polygon.vertices[(i + 1) % n];
        const bool currentInside = plane.distance(current.positionClip) >= 0;
        const bool nextInside = plane.distance(next.positionClip) >= 0;
        if (currentInside)
            out.vertices[static_cast<std::size_t>(out.count++)] = current;
        if (currentInside && !nextInside)
            addCut(current, next);
        else if (!currentInside && nextInside)
            addCut(next, current);
    }
    if (out.count < 3)
        out.count = 0;
    return out;
}

} // namespace rasterlens
