#pragma once
#include "core/pipeline/clipping.h"
#include "core/pipeline/culling.h"
#include "core/pipeline/depth_bias.h"
#include "core/pipeline/edge_sharing.h"
#include "core/pipeline/interpolation.h"
#include "core/pipeline/observer.h"
#include "core/pipeline/unsnapped.h"
#include "core/pipeline/viewport.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"
#include "core/settings/depth_rules.h"
#include "core/settings/rules.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace rasterlens
{

/// A vertex of the mesh with all that the faces around it share. What most faces are rejected or culled by comes first,
/// side by side.
struct ProcessedVertex {
    bool finite;
    bool beforeEye; ///< w > 0
    Outcode outcode;
    ScreenVertex screen; ///< only where the mode may draw it uncut
    ClipVertex clip;

    ProcessedVertex() {} // writes nothing
};

/// The stages a face goes through between vertex and coverage: reject, clip, to the screen, cull.
class FaceStages
{
public:
    using Corners = std::array<const ProcessedVertex*, 3>;

    FaceStages(const Scene& scene, const Matrices& matrices, const Rules& rules);

    /// Fills all but the clip-space vertex, which is there.
    void processVertex(ProcessedVertex& vertex) const;

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
        for (std::uint32_t i = 0; i < 3; ++i)
            observer.onVertex(face, static_cast<int>(i), m_scene->mesh.indices[3 * face + i], corners[i]->clip);
        if (!a.finite || !b.finite || !c.finite)
            return FaceFate::NonFinite;
        if (m_rules.rejectBy == RejectBy::DividedBox && isDividedBoxOutside({&a.clip, &b.clip, &c.clip}))
            return FaceFate::Rejected;
        const ClipVerdict verdict = clipVerdict(m_rules.clipping, a.outcode, b.outcode, c.outcode);
        if (verdict == ClipVerdict::Reject)
            return FaceFate::Rejected;
        if (verdict == ClipVerdict::Keep)
            return drawUncut(face, corners, out, observer);
        const ClipTriangle triangle{{a.clip, b.clip, c.clip}, face};
        Clipper clipper(triangle, m_volume, a.outcode.cut | b.outcode.cut | c.outcode.cut, m_rules);
        clipper.clip(observer);
        if (clipper.polygon().count == 0)
            return FaceFate::Rejected;
        return drawClipped(face, corners, clipper, out, observer);
    }

private:
    template <class Observer>
    FaceFate drawUncut(std::uint32_t face, const Corners& corners, std::vector<ScreenTriangle>& out,
                       Observer& observer) const
    {
        const ProcessedVertex& a = *corners[0];
        const ProcessedVertex& b = *corners[1];
        const ProcessedVertex& c = *corners[2];
        // x = y = z = w = 0 is inside every plane, yet nowhere on the screen.
        if (m_volume.cutBy != 0 && !(a.beforeEye && b.beforeEye && c.beforeEye))
            return FaceFate::Degenerate;
        for (std::uint32_t i = 0; i < 3; ++i)
            observer.onViewport(face, static_cast<int>(i), corners[i]->clip, corners[i]->screen);
        if (isLine(face)) {
            out.push_back({{a.screen, b.screen, b.screen}, face, 0, true, 0});
            return FaceFate::Rasterized;
        }
        const double area2 = twiceArea(a.screen.position, b.screen.position, c.screen.position);
        const FaceFate fate = facing(face, corners, area2, observer);
        if (fate == FaceFate::Rasterized) {
            out.push_back({{a.screen, b.screen, c.screen}, face, area2, false, 0});
            ScreenTriangle& triangle = out.back();
            if (isBiased(m_rules, face))
                bias(triangle.vertices, std::span(&triangle, 1));
        }
        return fate;
    }

    template <class Observer>
    FaceFate drawClipped(std::uint32_t face, const Corners& corners, const Clipper& clipper,
                         std::vector<ScreenTriangle>& out, Observer& observer) const
    {
        std::array<ScreenVertex, ClipPolygon::kMaxVertices> vertices;
        std::size_t count = 0;
        for (const ClipVertex& vertex : clipper.polygon().span()) {
            if (!isBeforeEye(vertex))
                return FaceFate::Degenerate; // the plane of the face runs through the eye
            vertices[count] = screenVertex(clipper, count);
            observer.onViewport(face, static_cast<int>(count), vertex, vertices[count]);
            ++count;
        }
        if (isLine(face)) {
            const FaceFate fate = appendCutLine(face, clipper.polygon(), vertices, out);
            observer.onClipped(face, fate == FaceFate::Rasterized ? 1 : 0);
            if (!m_rules.clipUpdatesW)
                giveWOfCorners(corners, std::span(out).last(fate == FaceFate::Rasterized ? 1 : 0));
            return fate;
        }
        const std::span<const ScreenVertex> polygon(vertices.data(), count);
        const double area2 = twicePolygonArea(polygon);
        const FaceFate fate = facing(face, corners, area2, observer);
        const int pieces = fate == FaceFate::Rasterized ? appendFan(face, polygon, area2, out) : 0;
        observer.onClipped(face, pieces);
        if (isBiased(m_rules, face))
            bias(polygon, std::span(out).last(static_cast<std::size_t>(pieces)));
        if (!m_rules.clipUpdatesW)
            giveWOfCorners(corners, std::span(out).last(static_cast<std::size_t>(pieces)));
        return fate;
    }

    /// Front, back or edge-on, in the space the rules ask for; zero area on the screen draws nothing in any.
    ///
    /// in   twice the area of what is left of the face on the screen
    template <class Observer>
    FaceFate facing(std::uint32_t face, const Corners& corners, double area2, Observer& observer) const
    {
        FacingDecision decision;
        decision.by = m_rules.facing;
        decision.screenArea = area2 / 2;
        decision.value = m_rules.facing == Facing::ScreenArea ? decision.screenArea : facingElsewhere(face, corners);
        decision.fate = fateOf(area2, decision.value);
        observer.onFacing(face, decision);
        return decision.fate;
    }

    [[nodiscard]] FaceFate fateOf(double area2, double facing) const
    {
        if ((area2 == 0 && m_rules.rejectsZeroArea) || std::abs(area2) < m_rules.smallestArea2)
            return FaceFate::Degenerate;
        return area2 == 0 ? FaceFate::Rasterized : cull(facing, m_rules);
    }

    /// Which way a face looks by what is not the area on the screen.
    [[nodiscard]] double facingElsewhere(std::uint32_t face, const Corners& corners) const;

    [[nodiscard]] static bool isBeforeEye(const ClipVertex& vertex) { return vertex.positionClip.w > 0; }

    [[nodiscard]] ScreenVertex screenVertex(const ClipVertex& vertex) const
    {
        return withDepthRule(vertex, toScreen(vertex, m_rules));
    }

    /// A vertex of a clipped polygon: it is snapped without the rounding of its position.
    [[nodiscard]] ScreenVertex screenVertex(const Clipper& clipper, std::size_t i) const
    {
        const ClipVertex& vertex = clipper.polygon().vertices[i];
        if (m_rules.cutStore == CutStore::LastUnwritten && isLastNew(clipper, i))
            return unwrittenVertex(vertex);
        if (m_rules.numberType != NumberType::Fixed || !clipper.isNew(i))
            return screenVertex(vertex);
        return withDepthRule(vertex, toScreen(vertex, clipper.snapped(i), m_rules));
    }

    /// Whether a vertex of a clipped polygon is the last one that a cut has made.
    [[nodiscard]] static bool isLastNew(const Clipper& clipper, std::size_t i)
    {
        for (auto last = static_cast<std::size_t>(clipper.polygon().count); last-- > i;)
            if (clipper.isNew(last))
                return last == i;
        return false;
    }

    /// What stands in memory that is cleared and not written: a corner at (0, 0). It keeps its w, by which all divide.
    [[nodiscard]] static ScreenVertex unwrittenVertex(const ClipVertex& vertex)
    {
        return {{0, 0}, 0, 1 / vertex.positionClip.w, {}};
    }

    [[nodiscard]] bool isLine(std::uint32_t face) const { return m_scene->mesh.isLine(face); }

    /// Adds the depth bias of a face's polygon to the triangles made of it.
    void bias(std::span<const ScreenVertex> polygon, std::span<ScreenTriangle> triangles) const
    {
        const double bias = depthBias(polygon, m_rules);
        for (ScreenTriangle& triangle : triangles)
            for (ScreenVertex& vertex : triangle.vertices)
                vertex.depth += bias;
    }

    [[nodiscard]] ScreenVertex withDepthRule(const ClipVertex& vertex, ScreenVertex out) const
    {
        if (m_rules.depthIsDistance)
            out.depth = depthOfDistance(vertex.positionClip.w, m_near, m_far);
        return out;
    }

    /// Cuts a polygon into triangles from a corner that sees all of it: snapping may have dented it a little. Where no
    /// corner does, snapping has folded it over itself, and its convex hull is drawn: no sample is hit twice.
    ///
    /// in    twice the area of the polygon
    /// out   the number of triangles
    int appendFan(std::uint32_t face, std::span<const ScreenVertex> polygon, double area2,
                  std::vector<ScreenTriangle>& out) const;

    /// What clipping has left of a line: of its polygon, in which B is there twice, the edge that lies on AB.
    static FaceFate appendCutLine(std::uint32_t face, const ClipPolygon& polygon,
                                  std::span<const ScreenVertex> vertices, std::vector<ScreenTriangle>& out);

    /// Gives the pieces of a cut face the w of the face's vertices, as if there had been no cut.
    static void giveWOfCorners(const Corners& corners, std::span<ScreenTriangle> pieces);

    const Scene* m_scene;
    Rules m_rules;
    glm::dvec3 m_eyeObject;
    glm::dvec3 m_toViewer; ///< orthographic: in place of the eye
    double m_near;
    double m_far;
    ClipVolume m_volume;
};

/// The vertices of one frame and the stages of its faces.
class Geometry
{
public:
    Geometry(const Scene& scene, const Matrices& matrices, const Rules& rules);

    /// Takes a face through the stages and appends the triangles to draw.
    template <class Observer>
    FaceFate process(std::uint32_t face, std::vector<ScreenTriangle>& out, Observer& observer) const
    {
        const std::size_t before = out.size();
        const FaceFate fate =
            m_stages.process(face, {&corner(face, 0), &corner(face, 1), &corner(face, 2)}, out, observer);
        if (m_rules.cornerData != CornerData::Own)
            for (ScreenTriangle& piece : std::span(out).subspan(before))
                piece = withCornerData(piece, m_rules.cornerData);
        if (!m_firstTriangle.empty())
            markSharedEdges(face, std::span(out).subspan(before));
        observer.onFace(face, fate);
        return fate;
    }

    /// Takes the first of the faces that are left to draw through the stages, as many as the observer wants at once.
    ///
    /// in   faces: at least one, in the order they are drawn in
    /// out  their triangles, and the faces that are left then
    template <class Observer>
    std::span<const std::uint32_t> processBatch(std::span<const std::uint32_t> faces,
                                                std::vector<ScreenTriangle>& triangles, Observer& observer) const
    {
        triangles.clear();
        const std::size_t count = std::min<std::size_t>(faces.size(), Observer::kFacesPerBatch);
        for (const std::uint32_t face : faces.first(count))
            if (process(face, triangles, observer) == FaceFate::Rejected && !m_rules.continuesAfterReject)
                return {};
        return faces.subspan(count);
    }

    /// Faces from far to near by the mean depth of their corners (painter's algorithm), or in the order of the mesh.
    [[nodiscard]] std::vector<std::uint32_t> order() const;

private:
    [[nodiscard]] const ProcessedVertex& corner(std::uint32_t face, std::uint32_t i) const
    {
        return m_vertices[m_scene->mesh.indices[3 * face + i]];
    }

    void findSharedEdges();
    void markSharedEdges(std::uint32_t face, std::span<ScreenTriangle> pieces) const;

    const Scene* m_scene;
    Rules m_rules;
    FaceStages m_stages;
    std::vector<ProcessedVertex> m_vertices;
    EdgeSharing m_sharing;
    std::vector<std::uint32_t>
        m_firstTriangle; ///< of each face, the number of its first triangle in m_sharing; empty: none is shared
};

} // namespace rasterlens
