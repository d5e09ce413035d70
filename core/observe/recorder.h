#pragma once
#include "core/observe/counting_observer.h"
#include "core/observe/frame_planes.h"
#include "core/observe/step_index.h"
#include "core/observe/step_log.h"
#include "core/pipeline/clipping.h"
#include "core/pipeline/resolve.h"
#include "core/pipeline/triangle_setup.h"
#include "core/scene/scene.h"
#include "core/settings/sample_pattern.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
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
        if (edge.owner())
            out.edges[i].side = edge.a > 0 ? EdgeSide::Left : EdgeSide::Top;
    }
    return out;
}

/// The least rectangle that holds two.
[[nodiscard]] inline PixelRect united(const PixelRect& a, const PixelRect& b)
{
    const int left = std::min(a.x, b.x);
    const int top = std::min(a.y, b.y);
    return {left, top, std::max(a.x + a.width, b.x + b.width) - left, std::max(a.y + a.height, b.y + b.height) - top};
}

/// What of a frame a recorder stores, and where the drawing begins.
struct RecordedPart {
    /// Positions of the first event stored and of the last; the drawing stops there.
    std::size_t first = 0;
    std::size_t last = std::numeric_limits<std::size_t>::max();
    /// Effects after which the last event is taken before it is due.
    std::size_t mostEffects = std::numeric_limits<std::size_t>::max();
    ResumePoint from;
    std::span<const std::uint64_t> doubleHits{}; ///< see CountingObserver; read where `from` is not the beginning
};

/// Writes a step log: every callback is one event, and every change of the frame buffer one effect. Or the index of a
/// record, which has neither.
class StepRecorder : public NullObserver
{
public:
    static constexpr int kFacesPerBatch = 1;

    /// A log of all that passes the filter, up to its cap.
    ///
    /// in  what the frame is drawn by; planes of the cleared frame, which the recorder writes, without depths but with
    ///     rules.depthPerPixel; `full` is asked to stop the drawing when the cap is reached
    StepRecorder(const Scene& scene, const Resolved& resolved, const StepFilter& filter, FramePlanes& planes,
                 std::stop_source full);
    /// A window of a record. The frame is drawn into the planes, which are those at part.from.
    StepRecorder(const Scene& scene, const Resolved& resolved, const StepFilter& filter, FramePlanes& planes,
                 std::stop_source full, const RecordedPart& part);
    /// The index of a record of so many events at most. The frame is drawn into the planes.
    StepRecorder(const Scene& scene, const Resolved& resolved, const StepFilter& filter, FramePlanes& planes,
                 std::stop_source full, std::size_t mostEvents, StepIndex& index);

    // DrawnRecord, which draws for windows and indices, calls these beside the stages.

    /// This face is next, the n-th that is drawn, counted from 0.
    void beginFace(std::size_t nth, std::uint32_t face);
    /// The n-th triangle of the present face is next. False: it was drawn before the resume point.
    [[nodiscard]] bool takeTriangle(std::size_t nth);
    /// The algorithm comes to a row or column of samples. True: all of its calls came before the resume point.
    [[nodiscard]] bool skipsLine(int line);
    /// Multi-sampling: the algorithm is about to cover the triangle for a sample of the pattern.
    void beginPass(int sample);
    /// The algorithm calls for a sample. False: not now, for it was drawn before the resume point, or comes after the
    /// end.
    [[nodiscard]] bool takeCall();
    /// takeCall() for a pixel of which any sample may be read and written.
    [[nodiscard]] bool takePixel(int x, int y);
    /// All faces are drawn, and the n-th pixel is next, row by row, counted from 0.
    void beginPixel(std::size_t nth);
    /// The triangle is finished; the samples of a pixel are about to share their depth where the rules want it.
    void endTriangle();

    void onVertex(std::uint32_t face, int corner, std::uint32_t meshVertex, const ClipVertex& clip);
    void onFace(std::uint32_t face, FaceFate fate);
    void onClipPlane(std::uint32_t face, ClipPlane plane, const ClipPolygon& before, const ClipPolygon& after);
    void onCohenSutherland(std::uint32_t face, const ClipPolygon& before, const ClipPolygon& after);
    void onViewport(std::uint32_t face, int corner, const ClipVertex& clip, const ScreenVertex& screen);
    void onClipped(std::uint32_t face, int pieces);
    void onFacing(std::uint32_t face, const FacingDecision& decision);
    void onTriangle(const ScreenTriangle& triangle);
    void onPatternSample(int sample)
    {
        m_counter.onPatternSample(sample);
        m_sample = sample;
    }
    void onShared(int x, int y, Pixel before, Pixel after);
    template <class T>
    void onSetup(const std::optional<TriangleSetup<T>>& setup)
    {
        if (!isFaceWanted())
            return;
        if (setup && !m_log->m_triangles.empty())
            keepSetup(stepSetup(*setup), boundsOfAllSamples<T>(setup->bounds));
        storeFaceEvent(StepKind::Setup);
    }
    void onOutline();
    void onWalk(const WalkedTriangle& walk);
    void onSides(const WalkedTriangle& walk);
    void onHalves(const WalkedTriangle& walk, const WalkedHalves& halves);
    void onCrossing(const RowCrossings& row);
    void onSpan(int y, int xBegin, int xEnd, const SpanEnds& ends);
    void onSample(int x, int y, const EdgeValues& values, bool covered)
    {
        if (!m_isPassKnown)
            takeSample(x, y, values, covered);
    }
    void onColumn(const FilledColumn& column);
    void onLineDecision(const LineDecision& decision);
    void onLinePosition(const LinePosition& position);
    void onLineSample(int x, int y, bool onTarget);
    void onFragment(const Fragment& fragment, float storedDepth, bool passed);
    void onShade(const Fragment& fragment, std::uint32_t color);
    void onWrite(int x, int y, Pixel before, Pixel after);
    void onResolve(const ResolvedPixel& pixel);

    /// The end of the window was reached, or the cap.
    [[nodiscard]] bool isFull() const { return m_full; }
    /// Ends the log.
    ///
    /// in   whether the drawing was stopped from outside; the picture it made, if it made one
    /// out  of a window, its planes are those at its end
    [[nodiscard]] std::shared_ptr<const StepLog> finish(bool stopped, const QImage& picture = {});

private:
    /// What to go back to when a face or triangle turns out to have nothing in the filter's pixels.
    struct Mark {
        std::size_t position = 0;
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
    /// Before the window only what the present face and triangle have come to is stored.
    [[nodiscard]] bool isBeforeWindow() const { return m_isResuming || m_position < m_part.first; }
    [[nodiscard]] Mark mark() const;
    void shorten(const Mark& mark);
    void rollBack(const Mark& mark);
    void beginFaceOf(std::uint32_t face);
    void dropPending();
    /// After this, events belong to no face.
    void leaveFaces();
    /// Whether something that happens to samples [xBegin, xEnd) of a row is within the filter; the face then is, too.
    [[nodiscard]] bool admit(int y, int xBegin, int xEnd);
    void setFull();
    void beginWindow();
    void keepPoint(const ResumePoint& now);
    void cutAtEnd();

    /// Stores an event with what makePayload() returns.
    template <class MakePayload>
    void storeWith(StepEvent event, MakePayload&& makePayload);
    /// out  whether the log has one event more
    bool store(StepEvent event);
    bool storeInLog(StepEvent event);
    void storeFaceEvent(StepKind kind, std::uint8_t flags = 0);
    [[nodiscard]] StepEvent sampleEvent(StepKind kind, int x, int y, std::uint8_t flags = 0) const;
    [[nodiscard]] StepEvent faceEvent(StepKind kind, std::uint8_t flags = 0) const;

    void keepSetup(StepSetup setup, const PixelRect& bounds);
    /// Where any sample of the pattern may be covered, whichever of them is at work; without a pattern the bounds
    /// given.
    template <class T>
    [[nodiscard]] PixelRect boundsOfAllSamples(PixelRect bounds) const
    {
        for (int sample = 0; m_rules.multiSampled() && sample < m_rules.patternSamples; ++sample) {
            ScreenTriangle moved = m_log->m_triangles.back().screen;
            for (ScreenVertex& vertex : moved.vertices)
                vertex.position -= testedOffset(m_rules, sample).pixels();
            if (const auto other = setupTriangle<T>(moved, m_rules))
                bounds = united(bounds, other->bounds);
        }
        return bounds;
    }
    void takeSample(int x, int y, const EdgeValues& values, bool covered);
    void addEffect(const StepEffect& effect);
    void writePixel(int x, int y, Pixel before, const StepEffect::State& after);
    void shareDepth(int x, int y);
    [[nodiscard]] std::size_t gapBegin() const { return m_log->m_events.empty() ? 0 : m_log->m_events.back().effects; }
    [[nodiscard]] std::uint32_t sampleIndex(int x, int y) const
    {
        const std::uint32_t row = static_cast<std::uint32_t>(m_sample) * static_cast<std::uint32_t>(m_rules.rows()) +
                                  static_cast<std::uint32_t>(y);
        return row * static_cast<std::uint32_t>(m_stride) + static_cast<std::uint32_t>(x);
    }

    const Scene* m_scene;
    Rules m_rules;
    StepFilter m_filter;
    PixelRect m_samples; ///< filter.pixels in samples
    int m_stride = 0;    ///< samples from one row of the frame buffer to the next
    int m_sample = 0;    ///< of a pattern: what happens belongs to it; -1: to the pixel
    ClipVolume m_volume;
    std::stop_source m_stopDrawing;
    FramePlanes* m_planes;
    StepIndex* m_index = nullptr; ///< null: a log is written
    bool m_isWindow = false;
    RecordedPart m_part;
    std::shared_ptr<StepLog> m_log;
    CountingObserver m_counter;

    std::size_t m_position = 0; ///< events stored so far, in the record
    std::uint32_t m_face = StepEvent::kNone;
    std::uint32_t m_triangle = StepEvent::kNone; ///< index into the log's triangles
    std::array<double, 3> m_invW{};
    Mark m_faceMark;
    Mark m_triangleMark;
    Mark m_geometryMark; ///< before the first triangle of the face
    bool m_faceKept = true;
    bool m_triangleKept = true;
    bool m_full = false;
    bool m_gap = true;                ///< something was counted since the last stored event
    std::vector<StepEvent> m_pending; ///< for the index: what may have to be taken back

    ResumePoint m_now;          ///< how far the drawing is, but for position and counters
    bool m_isResuming = false;  ///< the resume point is not reached
    bool m_isPassKnown = false; ///< all calls of the present pass of a pattern came before the resume point
    std::uint64_t m_work = 0;   ///< samples and faces

    std::array<int, 3> m_previousSigns{};
    int m_previousX = -2;
    int m_previousY = -2;
    bool m_mergesEffects = false;                ///< there may be many between two events
    std::vector<std::uint32_t> m_lastEffect;     ///< of each sample, an index into effects that may be out of date
    bool m_isLine = false;                       ///< the triangle is drawn as lines or corners
    std::vector<std::array<int, 2>> m_newDepths; ///< with rules.depthPerPixel: samples of the triangle
};

} // namespace rasterlens
