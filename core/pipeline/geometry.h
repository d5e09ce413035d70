#pragma once
#include "core/camera.h"
#include "core/observe/observer.h"
#include "core/pipeline/clipping.h"
#include "core/pipeline/culling.h"
#include "core/pipeline/viewport.h"
#include "core/rules.h"
#include "core/scene.h"

#include <vector>

namespace rasterlens
{

/// A vertex of the mesh with all that the faces around it share.
struct ProcessedVertex {
    ClipVertex clip;
    Outcode outcode;
    ScreenVertex screen; ///< only where the mode may draw it uncut
    bool finite;
};

/// The stages a face goes through between vertex and coverage: reject, clip, to the screen, cull.
class FaceStages
{
public:
    using Corners = std::array<const ProcessedVertex*, 3>;

    FaceStages(const Scene& scene, const Matrices& matrices, const Rules& rules);

    [[nodiscard]] ProcessedVertex processVertex(const ClipVertex& vertex) const;

    /// Takes a face through the stages and appends the triangles to draw.
    ///
    /// out   0 triangles, 1, or as many as the fan of the clipped polygon has
    template <class Observer>
    FaceFate process(std::uint32_t face, const Corners& corners, std::vector<ScreenTriangle>& out,
                     Observer& observer) const
    {
        const ProcessedVertex& a = *corners[0];
        const ProcessedVertex& b = *corners[1];
        const ProcessedVertex& c = *corners[2];
        if (!a.finite || !b.finite || !c.finite)
            return FaceFate::NonFinite;
        const ClipVerdict verdict = clipVerdict(m_rules.clipping, a.outcode, b.outcode, c.outcode);
        if (verdict == ClipVerdict::Reject)
            return FaceFate::Rejected;
        if (verdict == ClipVerdict::Keep) {
            const std::array<ScreenVertex, 3> polygon{a.screen, b.screen, c.screen};
            const FaceFate fate = facing(face, corners, polygon, observer);
            if (fate == FaceFate::Rasterized)
                out.push_back({polygon, face});
            return fate;
        }
        const ClipTriangle triangle{{a.clip, b.clip, c.clip}, face};
        ClipPolygon clipped =
            clip(triangle, m_volume, a.outcode.cut | b.outcode.cut | c.outcode.cut, m_rules.varyingCount, observer);
        if (m_rules.clipping == Clipping::CohenSutherland && clipped.count > 0)
            clipped = clipCohenSutherland(clipped, m_rules.varyingCount);
        if (clipped.count == 0)
            return FaceFate::Rejected;
        return drawClipped(face, corners, clipped, out, observer);
    }

private:
    template <class Observer>
    FaceFate drawClipped(std::uint32_t face, const Corners& corners, const ClipPolygon& clipped,
                         std::vector<ScreenTriangle>& out, Observer& observer) const
    {
        std::array<ScreenVertex, ClipPolygon::kMaxVertices> vertices;
        std::size_t count = 0;
        for (const ClipVertex& vertex : clipped.span()) {
            if (!(vertex.positionClip.w > 0))
                return FaceFate::Degenerate; // the plane of the face runs through the eye
            vertices[count++] = toScreen(vertex, m_rules);
        }
        const std::span<const ScreenVertex> polygon(vertices.data(), count);
        const FaceFate fate = facing(face, corners, polygon, observer);
        if (fate == FaceFate::Rasterized)
            observer.onClipped(face, appendFan(face, polygon, out));
        return fate;
    }

    /// Front, back or edge-on, in the space the rules ask for; zero area on the screen draws nothing in any.
    template <class Observer>
    FaceFate facing(std::uint32_t face, const Corners& corners, std::span<const ScreenVertex> polygon,
                    Observer& observer) const
    {
        const double area2 = twicePolygonArea(polygon);
        observer.onFacing(face, area2 / 2);
        if (area2 == 0)
            return FaceFate::Degenerate;
        switch (m_rules.cullSpace) {
        case CullSpace::Screen: break;
        case CullSpace::Clip:
            return cull(clipDeterminant({{corners[0]->clip, corners[1]->clip, corners[2]->clip}, face}), m_rules);
        case CullSpace::View: return cull(viewFacing(m_scene->mesh, face, m_eyeWorld), m_rules);
        }
        return cull(area2, m_rules);
    }

    /// Cuts a convex polygon into triangles from a corner that sees all of it: snapping may have dented it a little.
    ///
    /// out   the number of triangles
    static int appendFan(std::uint32_t face, std::span<const ScreenVertex> polygon, std::vector<ScreenTriangle>& out);

    const Scene* m_scene;
    Rules m_rules;
    glm::dvec3 m_eyeWorld;
    ClipVolume m_volume;
};

/// The vertices of one frame and the stages of its faces.
class Geometry
{
public:
    Geometry(const Scene& scene, const Matrices& matrices, const Rules& rules);

    /// Takes a face through the stages and appends the triangles to draw.
    template <class Observer>
    void process(std::uint32_t face, std::vector<ScreenTriangle>& out, Observer& observer) const
    {
        const FaceFate fate =
            m_stages.process(face, {&corner(face, 0), &corner(face, 1), &corner(face, 2)}, out, observer);
        observer.onFace(face, fate);
    }

    /// Faces from far to near by the mean depth of their corners (painter's algorithm), or in the order of the mesh.
    [[nodiscard]] std::vector<std::uint32_t> order() const;

private:
    [[nodiscard]] const ProcessedVertex& corner(std::uint32_t face, std::uint32_t i) const
    {
        return m_vertices[m_scene->mesh.indices[3 * face + i]];
    }

    const Scene* m_scene;
    Rules m_rules;
    FaceStages m_stages;
    std::vector<ProcessedVertex> m_vertices;
};

} // namespace rasterlens
