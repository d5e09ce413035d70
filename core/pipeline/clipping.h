#pragma once
#include "core/pipeline/observer.h"
#include "core/pipeline/types.h"
#include "core/settings/rules.h"

#include <array>
#include <cstdint>

namespace rasterlens
{

/// A set of clip planes, one bit a ClipPlane.
using ClipPlanes = std::uint32_t;

[[nodiscard]] constexpr ClipPlanes planeBit(ClipPlane plane) { return 1U << static_cast<unsigned>(plane); }

/// Inside is dot(normal, position) >= offset. Only w >= 1e-5 has an offset (and all planes have with
/// rules.clipInset); without one a plane does not change under scaling.
struct PlaneEquation {
    glm::dvec4 normal{0, 0, 0, 0};
    double offset = 0;

    /// exact  the sign: w + x and its like round once
    [[nodiscard]] double distance(const glm::dvec4& p) const
    {
        return (normal.x * p.x + normal.y * p.y + normal.z * p.z) + normal.w * p.w - offset;
    }
};

using PlaneTable = std::array<PlaneEquation, 7>; ///< indexed by ClipPlane

/// Which planes there are, and which of them the mode looks at.
struct ClipVolume {
    PlaneTable view;  ///< the view volume
    PlaneTable cut;   ///< what triangles are cut by: the view volume, or the wider sides of a guard band
    ClipPlanes cutBy; ///< planes a triangle that crosses them is cut by
    ClipPlanes known; ///< planes of the view volume a vertex is compared with
};

[[nodiscard]] ClipVolume clipVolume(const Rules& rules);

/// The planes a vertex is outside of.
struct Outcode {
    ClipPlanes view;
    ClipPlanes cut;
};

[[nodiscard]] Outcode outcode(const glm::dvec4& positionClip, const ClipVolume& volume);

/// What the mode does with a face, seen from the outcodes of its vertices.
enum class ClipVerdict { Reject, Keep, Cut };

[[nodiscard]] ClipVerdict clipVerdict(Clipping mode, const Outcode& a, const Outcode& b, const Outcode& c);

/// Clips a convex polygon by one plane.
///
/// in      clip space, any w
/// out     convex polygon, same winding; a cut runs from the inside vertex to the outside one, so that neighbours
///         that share an edge get the same new vertex bit for bit
/// source  Sutherland & Hodgman, Reentrant polygon clipping, CACM 17(1), 1974
[[nodiscard]] ClipPolygon clipByPlane(const ClipPolygon& polygon, const PlaneEquation& plane, int varyingCount);

/// How far along the edge from a (inside) to b (outside) the plane is crossed, 0..1.
[[nodiscard]] double cutParameter(const glm::dvec4& a, const glm::dvec4& b, const PlaneEquation& plane);

/// The point where the edge crosses the plane, by rational arithmetic: for edges so long that the difference of their
/// ends would swallow the point between them.
///
/// exact   each coordinate to a few units of its own last place
[[nodiscard]] glm::dvec4 cutExactly(const glm::dvec4& inside, const glm::dvec4& outside, const PlaneEquation& plane);

[[nodiscard]] ClipPolygon polygonOf(const ClipTriangle& triangle);

/// Clips the projected polygon by the four sides of the viewport, edge by edge, and rebuilds it from what is left of
/// the edges and, with rules.clipKeepsCorners, the corners of the viewport inside it.
///
/// in      clip space, all w > 0: cut by near, far and the guard band before, so that x / w stays small; convex
/// out     convex polygon, same winding
/// source  the outcodes of Cohen and Sutherland: Newman & Sproull, Principles of Interactive Computer Graphics, 1973
[[nodiscard]] ClipPolygon clipCohenSutherland(const ClipPolygon& polygon, const Rules& rules);

/// Clips one triangle by the planes it crosses, one plane at a time.
///
/// in      clip space, before the divide; any finite position, also w <= 0
/// out     convex polygon of 0 or 3..10 vertices, same winding
/// exact   scaling x, y, z and w together by a power of two changes nothing (but for `frustum-w`)
template <class Observer>
[[nodiscard]] ClipPolygon clip(const ClipTriangle& triangle, const ClipVolume& volume, ClipPlanes crossed,
                               int varyingCount, Observer& observer)
{
    ClipPolygon polygon = polygonOf(triangle);
    for (unsigned i = 0; i < volume.cut.size() && polygon.count > 0; ++i) {
        if ((crossed & volume.cutBy & 1U << i) == 0)
            continue;
        const ClipPolygon before = polygon;
        polygon = clipByPlane(before, volume.cut[i], varyingCount);
        observer.onClipPlane(triangle.face, static_cast<ClipPlane>(i), before, polygon);
    }
    return polygon;
}

} // namespace rasterlens
