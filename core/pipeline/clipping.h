#pragma once
#include "core/pipeline/observer.h"
#include "core/pipeline/triangle_lines.h"
#include "core/pipeline/types.h"
#include "core/settings/rules.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace rasterlens
{

constexpr double kSmallestW = 1e-5; ///< the plane of w, where the mode has one

/// Which planes there are, and which of them the mode looks at.
struct ClipVolume {
    PlaneTable view;  ///< the view volume
    PlaneTable cut;   ///< what triangles are cut by: the view volume, or the wider sides of a guard band
    ClipPlanes cutBy; ///< planes a triangle that crosses them is cut by
    ClipPlanes known; ///< planes of the view volume a vertex is compared with
    bool hasGuardBand;
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

/// Whether all three corners lie beyond one side of the screen after the divide, also those behind the eye, whose signs
/// the divide turns round: what RejectBy::DividedBox rejects by.
[[nodiscard]] bool isDividedBoxOutside(const std::array<const ClipVertex*, 3>& corners);

/// How far along an edge its plane is crossed, 0..1, from the distances of its ends.
[[nodiscard]] constexpr double cutParameter(double inside, double outside) { return inside / (inside - outside); }

/// Whether a new vertex between a and b is computed well enough in double: not where edges are so long that the
/// difference of their ends swallows the point between them.
[[nodiscard]] bool isWellConditioned(const glm::dvec4& a, const glm::dvec4& b, double w);

/// Clips one triangle by the planes it crosses, one plane at a time. Two polygons take turns: one is read while the
/// other is written.
///
/// in      clip space, before the divide; any finite position, also w <= 0
/// out     convex polygon of 0 or 3..10 vertices (Cohen-Sutherland: 22), same winding. A cut runs from the inside
///         vertex to the outside one, so that neighbours that share an edge get the same new vertex bit for bit
/// exact   which side of a plane a vertex lies on, and the vertices snapped to the screen's grid, for float32 positions
///         of any size; scaling x, y, z and w together by a power of two changes nothing (but for `frustum-w`)
/// source  Sutherland & Hodgman, Reentrant polygon clipping, CACM 17(1), 1974
class Clipper
{
public:
    /// in   crossed: planes of volume.cut that a vertex is outside of. All arguments are to outlive the clipper
    Clipper(const ClipTriangle& triangle, const ClipVolume& volume, ClipPlanes crossed, const Rules& rules);
    Clipper(const Clipper&) = delete; // the polygons that take turns are pointed to
    Clipper& operator=(const Clipper&) = delete;

    template <class Observer>
    void clip(Observer& observer)
    {
        for (unsigned i = 0; i < m_volume->cut.size() && m_now->count > 0; ++i) {
            if ((m_crossed & 1U << i) == 0)
                continue;
            cutBy(static_cast<ClipPlane>(i));
            observer.onClipPlane(m_triangle->face, static_cast<ClipPlane>(i), *m_before, *m_now);
        }
        if (m_rules->clipping == Clipping::CohenSutherland && m_now->count > 0 && isBeforeEye()) {
            cutByViewport();
            observer.onCohenSutherland(m_triangle->face, *m_before, *m_now);
        }
    }

    [[nodiscard]] const ClipPolygon& polygon() const { return *m_now; }

    /// Whether a vertex of the result was made by a cut.
    [[nodiscard]] bool isNew(std::size_t vertex) const;

    /// The screen position of a vertex of the result, in units of 1/2^subpixelBits pixel, half to even.
    ///
    /// in     w > 0
    /// exact  always
    [[nodiscard]] glm::dvec2 snapped(std::size_t vertex) const;

private:
    void cutBy(ClipPlane plane);

    /// Clips the projected polygon by the four sides of the viewport, edge by edge, and joins what is left of the edges
    /// by (with rules.clipKeepsCorners) the corners of the viewport inside the polygon.
    ///
    /// in      all w > 0: cut by near, far and the guard band before, so that x / w stays small
    /// source  the outcodes of Cohen and Sutherland: Newman & Sproull, Principles of Interactive Computer Graphics,
    /// 1973
    void cutByViewport();

    [[nodiscard]] bool isBeforeEye() const;
    ClipVertex& append(ClipCorner corner);
    void takeTurns() { std::swap(m_before, m_now); }

    // Cohen-Sutherland, in cohen_sutherland.cpp.
    struct SidesOf {
        unsigned outside; ///< sides of the viewport a corner is outside of, one bit a side
        unsigned on;      ///< those it is on
    };
    struct EdgeEnd;
    [[nodiscard]] SidesOf sidesOf(ClipCorner corner, const glm::dvec4& estimate) const;
    [[nodiscard]] bool clipEdge(EdgeEnd& begin, EdgeEnd& end, ClipLine line) const;
    [[nodiscard]] bool has(ClipCorner corner) const;
    void appendEnd(const EdgeEnd& end, const ClipVertex& vertex, const ClipVertex& other);
    void appendViewportCorner(unsigned side, unsigned nextSide);
    void walkBorder(unsigned from, unsigned to, unsigned step);
    void placeExactly(ClipVertex& point, ClipCorner corner) const;

    const ClipTriangle* m_triangle;
    const ClipVolume* m_volume;
    const Rules* m_rules;
    ClipPlanes m_crossed;
    TriangleLines m_lines;
    std::array<ClipPolygon, 2> m_polygons;
    ClipPolygon* m_now = &m_polygons[0];    ///< the latest result
    ClipPolygon* m_before = &m_polygons[1]; ///< the one it was cut from
};

} // namespace rasterlens
