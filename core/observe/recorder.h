#pragma once
#include "core/observe/counting_observer.h"
#include "core/observe/step_log.h"
#include "core/pipeline/clipping.h"
#include "core/pipeline/resolve.h"
#include "core/pipeline/triangle_setup.h"
#include "core/scene/scene.h"

#include <memory>
#include <stop_token>

namespace rasterlens
{

/// A triangle's set-up as doubles, whatever numbers it is made of.
template <class T>
[[nodiscard]] StepSetup stepSetup(const TriangleSetup<T>& setup)
{
    constexpr double kUnit = double(Grid<T>::kUnit);
    StepSetup out;
    out.source = setup.source;
    out.bounds = setup.bounds;
    out.unitsPerSample = kUnit;
    out.unitsPerArea = kUnit * kUnit;
    out.area2 = static_cast<double>(setup.edges[0].at(setup.vertices[2]));
    for (std::size_t i = 0; i < 3; ++i) {
        const EdgeFunction<T>& edge = setup.edges[i];
        out.vertices[i] = glm::dvec2(double(setup.vertices[i].x), double(setup.vertices[i].y)) / kUnit;
        out.edges[i] = {double(edge.a),
                        double(edge.b),
                        double(edge.a) * kUnit,
                        double(edge.b) * kUnit,
                        {double(edge.from.x), double(edge.from.y)},
                        double(edge.threshold),
                        EdgeSide::Neither};
        if (edge.owner)
            out.edges[i].side = edge.a > 0 ? EdgeSide::Left : EdgeSide::Top;
    }
    return out;
}

/// Writes a step log: every callback is one event, and every change of the frame buffer one effect.
class StepRecorder : public NullObserver
{
public:
    static constexpr int kFacesPerBatch = 1;

    /// in  what the frame is drawn by; `full` is asked to stop the drawing when the cap is reached
    StepRecorder(const Scene& scene, const Resolved& resolved, const StepFilter& filter, std::stop_source full);

    void onVertex(std::uint32_t face, int corner, std::uint32_t meshVertex, const ClipVertex& clip);
    void onFace(std::uint32_t face, FaceFate fate);
    void onClipPlane(std::uint32_t face, ClipPlane plane, const ClipPolygon& before, const ClipPolygon& after);
    void onCohenSutherland(std::uint32_t face, const ClipPolygon& before, const ClipPolygon& after);
    void onViewport(std::uint32_t face, int corner, const ClipVertex& clip, const ScreenVertex& screen);
    void onClipped(std::uint32_t face, int pieces);
    void onFacing(std::uint32_t face, const FacingDecision& decision);
    void onTriangle(const ScreenTriangle& triangle);
    template <class T>
    void onSetup(const std::optional<TriangleSetup<T>>& setup)
    {
        if (!isFaceWanted())
            return;
        if (setup) {
            m_log->m_triangles.back().hasSetup = true;
            m_log->m_triangles.back().setup = stepSetup(*setup);
        }
        storeFaceEvent(StepKind::Setup);
    }
    void onOutline();
    void onWalk(const WalkedTriangle& walk);
    void onSides(const WalkedTriangle& walk);
    void onHalves(const WalkedTriangle& walk, const WalkedHalves& halves);
    void onCrossing(const RowCrossings& row);
    void onSpan(int y, int xBegin, int xEnd, const SpanEnds& ends);
    void onSample(int x, int y, const EdgeValues& values, bool covered);
    void onColumn(const FilledColumn& column);
    void onLineDecision(const LineDecision& decision);
    void onLineSample(int x, int y, bool onTarget);
    void onFragment(const Fragment& fragment, float storedDepth, bool passed);
    void onShade(const Fragment& fragment, std::uint32_t color);
    void onWrite(int x, int y, Pixel before, Pixel after);
    void onResolve(const ResolvedPixel& pixel);

    /// Ends the log.
    ///
    /// in  whether the drawing was stopped from outside; the picture it made
    [[nodiscard]] std::shared_ptr<const StepLog> finish(bool stopped, const QImage& picture);

private:
    /// What to go back to when a face or triangle turns out to have nothing in the filter's pixels.
    struct Mark {
        std::size_t events = 0;
        std::size_t triangles = 0;
        std::array<std::size_t, std::tuple_size_v<StepLog::Payloads>> payloads{};
    };

    [[nodiscard]] bool isFaceWanted() const { return !m_full && (!m_filter.face || *m_filter.face == m_face); }
    [[nodiscard]] bool isPending() const { return m_filter.pixels && !(m_faceKept && m_triangleKept); }
    [[nodiscard]] bool isRowWanted(int y) const
    {
        return isFaceWanted() && (!m_filter.pixels || (y >= m_samples.y && y < m_samples.y + m_samples.height));
    }
    [[nodiscard]] Mark mark() const;
    void rollBack(const Mark& mark);
    void beginFace(std::uint32_t face);
    void dropPending();
    /// After this, events belong to no face.
    void leaveFaces();
    /// Whether something that happens to samples [xBegin, xEnd) of a row is within the filter; the face then is, too.
    [[nodiscard]] bool admit(int y, int xBegin, int xEnd);
    void setFull();

    template <class Payload>
    void storePayload(StepEvent event, Payload&& payload);
    void store(StepEvent event);
    void storeFaceEvent(StepKind kind, std::uint8_t flags = 0);
    [[nodiscard]] StepEvent sampleEvent(StepKind kind, int x, int y, std::uint8_t flags = 0) const;
    [[nodiscard]] StepEvent faceEvent(StepKind kind, std::uint8_t flags = 0) const;

    void addEffect(const StepEffect& effect);
    [[nodiscard]] std::size_t gapBegin() const { return m_log->m_events.empty() ? 0 : m_log->m_events.back().effects; }
    [[nodiscard]] std::uint32_t sampleIndex(int x, int y) const
    {
        return static_cast<std::uint32_t>(y) * static_cast<std::uint32_t>(m_stride) + static_cast<std::uint32_t>(x);
    }

    const Scene* m_scene;
    Rules m_rules;
    StepFilter m_filter;
    PixelRect m_samples; ///< filter.pixels in samples
    int m_stride = 0;    ///< samples from one row of the frame buffer to the next
    ClipVolume m_volume;
    std::stop_source m_stopDrawing;
    std::shared_ptr<StepLog> m_log;
    CountingObserver m_counter;

    std::uint32_t m_face = StepEvent::kNone;
    std::uint32_t m_triangle = StepEvent::kNone; ///< index into the log's triangles
    std::array<double, 3> m_invW{};
    Mark m_faceMark;
    Mark m_triangleMark;
    bool m_faceKept = true;
    bool m_triangleKept = true;
    bool m_full = false;
    bool m_gap = true; ///< something was counted since the last stored event

    std::array<int, 3> m_previousSigns{};
    int m_previousX = -2;
    int m_previousY = -2;
    std::vector<std::uint32_t> m_lastEffect; ///< of each sample, an index into effects that may be out of date
    std::vector<std::uint32_t> m_color;      ///< of each sample
    std::vector<std::uint16_t> m_coverCount; ///< of each sample; overdraw only
    /// With rules.depthPerPixel: of each sample, the depth that was last written for it alone.
    std::vector<float> m_ownDepth;
};

} // namespace rasterlens
