#pragma once
#include "core/observe/names.h"
#include "core/pipeline/observer.h"
#include "core/pipeline/statistics.h"
#include "core/settings/mistakes.h"
#include "core/settings/rules.h"
#include "core/settings/sample_pattern.h"
#include "core/settings/step_kind.h"

#include <QImage>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

namespace rasterlens
{

/// Which events are stored. What is not stored still takes effect on pixels and counters: it counts as part of the next
/// stored event.
struct StepFilter {
    std::optional<std::uint32_t> face; ///< only this face
    /// Only what happens to samples of these pixels, and spans that hold one. Events that belong to no pixel (vertices,
    /// clipping, set-up) are stored for the faces and triangles to which something happens there.
    std::optional<PixelRect> pixels;
    StepKinds kinds = kAllSteps; ///< End is always stored
    std::size_t cap = 1'000'000; ///< most events stored beside End; the drawing stops there
};

/// One event; what it holds beside this is its payload (StepLog::payload).
struct StepEvent {
    // Bits of `flags`.
    static constexpr std::uint8_t kCovered = 1;      ///< Sample: inside. LineSample: on the target
    static constexpr std::uint8_t kPassed = 2;       ///< Fragment: passed the depth test
    static constexpr std::uint8_t kTie = 4;          ///< Sample: exactly on an edge of the triangle
    static constexpr std::uint8_t kSignChange = 8;   ///< Sample: a sign differs from the sample to the left
    static constexpr std::uint8_t kNonFinite = 16;   ///< one of its numbers is NaN or infinite
    static constexpr std::uint8_t kHitTwice = 32;    ///< Fragment: the other face at this edge was here, too
    static constexpr std::uint8_t kSharedDepth = 64; ///< Fragment: compared with what another sample of the pixel wrote
    static constexpr std::uint32_t kNone = 0xffffffff;

    StepKind kind = StepKind::End;
    std::uint8_t flags = 0;
    std::int8_t sample = 0; ///< multi-sampling: which of the pattern; -1: the event belongs to the whole pixel
    std::uint32_t face = kNone;
    std::uint32_t triangle = kNone; ///< index for StepLog::triangle, from Triangle on
    std::int32_t x = -1;            ///< sample column; -1: the event belongs to no sample
    std::int32_t y = -1;            ///< sample row; -1: the event belongs to no row
    std::uint32_t payload = 0;
    std::uint32_t effects = 0; ///< how many pixel effects there are up to and with this event

    [[nodiscard]] bool has(std::uint8_t flag) const { return (flags & flag) != 0; }
};

struct VertexStep {
    static constexpr StepKind kKind = StepKind::Vertex;
    int corner; ///< 0..2 = A, B, C
    std::uint32_t meshVertex;
    glm::vec4 positionObject; ///< as the mesh has it
    glm::dvec3 origin;        ///< Mesh::origin: what the world's coordinates are more
    ClipVertex clip;
    std::uint32_t outside; ///< planes of the view volume it is outside of, one bit a ClipPlane
};

/// Where an edge of the polygon crosses a plane.
struct ClipCut {
    int inside;  ///< corner of `before`
    int outside; ///< corner of `before`
    double t;    ///< fraction of the way from the inside to the outside corner
    int corner;  ///< the new corner in `after`; -1 if nothing was left
};

struct ClipStep {
    static constexpr StepKind kKind = StepKind::ClipPlane;
    ClipPlane plane;
    std::vector<ClipVertex> before;
    std::vector<ClipVertex> after;
    std::vector<double> distances; ///< of each corner of `before`; inside is >= 0
    std::vector<ClipCut> cuts;
};

struct CohenSutherlandStep {
    static constexpr StepKind kKind = StepKind::CohenSutherland;
    std::vector<ClipVertex> before;
    std::vector<ClipVertex> after;
    std::vector<unsigned> regions; ///< of each corner of `before`
};

struct ViewportStep {
    static constexpr StepKind kKind = StepKind::Viewport;
    int corner; ///< of the polygon after clipping
    glm::dvec4 positionClip;
    glm::dvec2 unsnapped; ///< samples
    ScreenVertex screen;  ///< snapped
};

struct FacingStep {
    static constexpr StepKind kKind = StepKind::Facing;
    FacingDecision decision;
};

struct ClippedStep {
    static constexpr StepKind kKind = StepKind::Clipped;
    int pieces;
};

struct FateStep {
    static constexpr StepKind kKind = StepKind::Fate;
    FaceFate fate;
};

struct WalkStep {
    static constexpr StepKind kKind = StepKind::Walk;
    WalkedTriangle walk;
};

struct SidesStep {
    static constexpr StepKind kKind = StepKind::Sides;
    WalkedTriangle walk;
};

struct HalvesStep {
    static constexpr StepKind kKind = StepKind::Halves;
    WalkedTriangle walk;
    WalkedHalves halves;
};

struct CrossingStep {
    static constexpr StepKind kKind = StepKind::Crossing;
    RowCrossings row;
};

struct SpanStep {
    static constexpr StepKind kKind = StepKind::Span;
    int xBegin; ///< samples [xBegin, xEnd) of the row
    int xEnd;
    SpanEnds ends;
};

struct ColumnFillStep {
    static constexpr StepKind kKind = StepKind::Column;
    FilledColumn column;
};

struct SampleStep {
    static constexpr StepKind kKind = StepKind::Sample;
    EdgeValues values; ///< AB, BC, CA of the setup; in units of StepSetup::unitsPerArea
};

struct LineStep {
    static constexpr StepKind kKind = StepKind::LineDecision;
    LineDecision decision;

    /// How far the ideal line is from the sample it may step to, and from the one it may stay at: 0..1.
    [[nodiscard]] double dUpper() const { return 0.5 * (1 - double(decision.decision) / decision.longer); }
    [[nodiscard]] double dLower() const { return 0.5 * (1 + double(decision.decision) / decision.longer); }
};

struct LinePositionStep {
    static constexpr StepKind kKind = StepKind::LinePosition;
    LinePosition position;
};

struct FragmentStep {
    static constexpr StepKind kKind = StepKind::Fragment;
    Weights screen;    ///< of the vertices A, B, C of the screen triangle
    Weights weights;   ///< after perspective correction; as `screen` where nothing is interpolated
    double invW;       ///< 1/w, linear on the screen
    float depth;       ///< new, as the buffer stores it
    float storedDepth; ///< what it was compared with
    Varyings varyings; ///< what shading reads; 0 where it does not
    bool shaded;       ///< weights and varyings are there
};

struct ShadeStep {
    static constexpr StepKind kKind = StepKind::Shade;
    std::uint32_t color; ///< 0xffRRGGBB
};

struct WriteStep {
    static constexpr StepKind kKind = StepKind::Write;
    Pixel before;
    Pixel after;
};

struct ResolveStep {
    static constexpr StepKind kKind = StepKind::Resolve;
    ResolvedPixel pixel;
};

/// E(x, y) = a (x - fromX) + b (y - fromY), positive inside, in the units of the number type.
struct StepEdge {
    double a;
    double b;
    double perX; ///< added for a step of one sample to the right
    double perY; ///< added for a step of one sample down
    glm::dvec2 from;
    double threshold; ///< the smallest value that counts as inside
    EdgeSide side;    ///< Left or Top: it owns its points under the top-left rule
};

/// The numbers coverage of one triangle is decided with.
struct StepSetup {
    std::array<StepEdge, 3> edges;      ///< AB, BC, CA, counter-clockwise with y up whatever the face's winding
    std::array<glm::dvec2, 3> vertices; ///< samples
    std::array<std::uint8_t, 3> source; ///< which vertex of the screen triangle each of them is
    PixelRect bounds;                   ///< samples
    double unitsPerSample = 1;          ///< 256 in fixed point
    double unitsPerArea = 1;            ///< edge values are areas in samples times this: 65536 in fixed point
    double area2 = 0;                   ///< the sum of the three edge values anywhere

    /// The edge values at a point, in samples, evaluated directly.
    ///
    /// exact  in fixed point, below 2^53
    [[nodiscard]] EdgeValues at(const glm::dvec2& point) const;

    /// Moves the triangle, but not its bounds, by so many samples.
    void move(const glm::dvec2& offset);
};

/// Where the rules test a sample: at its centre, or at its pixel's corner, or where the pattern has it. In samples.
///
/// in   of a pattern, the number of the sample; -1: the pixel's centre
[[nodiscard]] glm::dvec2 testedPoint(const Rules& rules, int x, int y, int sample = 0);

class StepLog;
/// Whether an event belongs to one sample of a pattern, rather than to a pixel or a face.
[[nodiscard]] bool isOfPattern(const StepLog& log, const StepEvent& event);

/// The samples of a pattern that a triangle covers of a pixel.
[[nodiscard]] SampleMask coveredSamples(const StepSetup& setup, const Rules& rules, int x, int y);

/// Whether edge equation adds up its edge values from sample to sample; else it evaluates them anew at each.
[[nodiscard]] bool addsUpEdgeValues(const Rules& rules);

/// The edge that decides whether a sample is inside, and the comparison that holds for it.
struct DecidingEdge {
    std::size_t edge; ///< of the setup
    double value;     ///< in units
    double threshold; ///< in units
    enum class Sign { AtLeast, Below, AtMost } sign;

    [[nodiscard]] bool isInside() const { return sign != Sign::Below; }
    [[nodiscard]] bool isTie() const { return value == 0; }
};

/// The edge that decides about a sample: the smallest value of those that fail their thresholds, or else of all three.
/// Under the mistake that takes a sample as inside where all values are at most their threshold, the largest value.
[[nodiscard]] DecidingEdge decidingEdge(const StepSetup& setup, const EdgeValues& values, const Rules& rules);

/// One triangle that is drawn: a whole face or a piece of a cut one.
struct StepTriangle {
    ScreenTriangle screen;
    bool hasSetup = false; ///< false: its bounds hold no sample's centre, or it is drawn as lines or points
    StepSetup setup;
};

/// How far a step goes. A row of a triangle is what edge walking calls a span.
enum class StepLevel { Event, Sample, Row, Face, Stage };
enum class StepDirection { Forward, Backward };

/// Whether a step of this level ends between two events that follow each other. The stages of a face are: vertices;
/// clipping; screen and facing; set-up; coverage with all that follows for each sample.
[[nodiscard]] bool isStepBoundary(const StepEvent& before, const StepEvent& after, StepLevel level);

/// Where a run stops.
struct StepStop {
    enum class Kind { Pixel, SignChange, Tie, DepthFail, Clip, NonFinite };
    Kind kind = Kind::Pixel;
    int x = 0; ///< Pixel only, pixels: anything that happens to one of its samples
    int y = 0;
};

/// Whether an event stops a run.
///
/// in  samples a pixel along each axis
[[nodiscard]] bool stopsAt(const StepEvent& event, const StepStop& stop, int grid);

/// A change of one sample of the frame buffer.
struct StepEffect {
    /// What a sample stores, and the face that was drawn there last, -1 none.
    struct State {
        Pixel pixel;
        std::int32_t owner;
    };

    std::uint32_t sample; ///< where it is read from: row * columns + column; the samples of a pattern follow each other
    State before;
    State after;
};

/// Everything that happened while a frame was drawn, in order, filtered. Immutable once recorded; shared between
/// threads as `std::shared_ptr<const StepLog>`.
///
/// A *position* k, 0..size(), is the moment after event k - 1; 0 is the cleared frame. Events that were not stored
/// happen together with the next stored one. Unless the log is truncated its last event is End, and position size() is
/// the finished picture.
///
/// A log may also be a *window* of a StepRecord: its first lead() events are what the face and the triangle at work had
/// come to before, and those that follow are the events of the record from first() on.
///
/// covers  every algorithm; `tiled` is shown by edge-equation, which draws the same pixels
class StepLog
{
public:
    [[nodiscard]] std::size_t size() const { return m_events.size(); }
    [[nodiscard]] const StepEvent& event(std::size_t i) const { return m_events[i]; }
    [[nodiscard]] std::span<const StepEvent> events() const { return m_events; }

    /// The payload of an event, of the type its kind names.
    template <class Payload>
    [[nodiscard]] const Payload& payload(const StepEvent& event) const
    {
        return std::get<std::vector<Payload>>(m_payloads)[event.payload];
    }
    /// The triangle an event belongs to; nothing before Triangle.
    [[nodiscard]] const StepTriangle* triangle(const StepEvent& event) const
    {
        return event.triangle == StepEvent::kNone ? nullptr : &m_triangles[event.triangle];
    }

    /// The line of the `f` in the scene's file that a face is a part of; -1 none.
    [[nodiscard]] std::int32_t lineOf(std::uint32_t face) const
    {
        return face < m_faceLines.size() ? m_faceLines[face] : -1;
    }

    /// The cap was reached: the log ends there, and so does the picture.
    [[nodiscard]] bool truncated() const { return m_truncated; }
    /// The drawing was stopped from outside.
    [[nodiscard]] bool stopped() const { return m_stopped; }
    [[nodiscard]] const StepFilter& filter() const { return m_filter; }
    /// What the stages read; the mistakes that are part of it, in the order they were switched on; and the same rules
    /// without them.
    [[nodiscard]] const Rules& rules() const { return m_rules; }
    [[nodiscard]] std::span<const Mistake* const> mistakes() const { return m_mistakes; }
    [[nodiscard]] const Rules& rightRules() const { return m_rightRules; }
    [[nodiscard]] int columns() const { return m_rules.columns(); } ///< samples
    [[nodiscard]] int rows() const { return m_rules.rows(); }       ///< samples
    /// How many samples the frame buffer holds: columns * rows, times those of a pattern, but for a mistake in their
    /// addresses.
    [[nodiscard]] std::size_t sampleCount() const { return m_sampleCount; }
    [[nodiscard]] int grid() const { return m_rules.sampleGrid; } ///< samples a pixel along each axis
    [[nodiscard]] int varyingCount() const { return m_rules.varyingCount; }
    [[nodiscard]] Pixel clear() const { return m_clear; }

    /// The events of a kind, ascending: pips of a scrubber.
    [[nodiscard]] std::span<const std::uint32_t> eventsOf(StepKind kind) const
    {
        return m_byKind[static_cast<std::size_t>(kind)];
    }

    /// The position of the record at which a window begins; 0 in a log of its own.
    [[nodiscard]] std::size_t first() const { return m_first; }
    /// How many events a window holds from before its beginning.
    [[nodiscard]] std::size_t lead() const { return m_lead; }
    /// The number in its record of an event from lead() on.
    [[nodiscard]] std::size_t numberOf(std::size_t i) const { return i - m_lead + m_first; }
    /// The position of the record at which a window ends.
    [[nodiscard]] std::size_t last() const { return numberOf(size()); }

    /// The position one step further (or back): past (or to the beginning of) the sample, row, face or stage.
    [[nodiscard]] std::size_t step(std::size_t position, StepLevel level, StepDirection direction) const;

    /// The index of the next event at or after `from` (or the last one before `from`) for which test(event) holds.
    template <class Test>
    [[nodiscard]] std::optional<std::size_t> find(std::size_t from, StepDirection direction, Test&& test) const
    {
        if (direction == StepDirection::Forward) {
            for (std::size_t i = from; i < m_events.size(); ++i)
                if (test(m_events[i]))
                    return i;
        } else {
            for (std::size_t i = from; i-- > 0;)
                if (test(m_events[i]))
                    return i;
        }
        return std::nullopt;
    }
    /// "Run until": the index of the next event that stops the run. The position to go to is one more.
    [[nodiscard]] std::optional<std::size_t> findStop(std::size_t from, StepDirection direction,
                                                      const StepStop& stop) const;
    /// The first event of a face at a pixel (x, y in pixels), or of the face at all if it has none there.
    [[nodiscard]] std::optional<std::size_t> firstEventOf(std::uint32_t face, int x, int y) const;

    /// The counters at a position.
    ///
    /// cost  at most kCheckpointEvents events
    [[nodiscard]] Statistics countersAt(std::size_t position) const;

    /// How many pixels, row by row, the picture has of their samples at a position. With one sample a pixel none need
    /// to be made.
    [[nodiscard]] std::size_t resolvedPixels(std::size_t position) const;
    /// The finished picture where a mistake makes it something else than the mean of the samples; else null.
    [[nodiscard]] const QImage& finishedImage() const { return m_finished; }
    /// Samples a pixel, on a grid or in a pattern.
    [[nodiscard]] int samplesPerPixel() const { return m_rules.samplesPerPixel(); }

    [[nodiscard]] std::span<const StepEffect> effects() const { return m_effects; }
    /// How many effects there are at a position.
    [[nodiscard]] std::size_t effectsAt(std::size_t position) const
    {
        return position == 0 ? 0 : m_events[position - 1].effects;
    }

private:
    friend class StepRecorder;

    static constexpr std::size_t kCheckpointEvents = 256;

    std::vector<std::int32_t> m_faceLines; ///< see Mesh::faceLine

    /// The counters after so many events.
    struct Checkpoint {
        std::uint32_t position;
        Statistics statistics;
    };

    using Payloads =
        std::tuple<std::vector<VertexStep>, std::vector<ClipStep>, std::vector<CohenSutherlandStep>,
                   std::vector<ViewportStep>, std::vector<FacingStep>, std::vector<ClippedStep>, std::vector<FateStep>,
                   std::vector<WalkStep>, std::vector<SidesStep>, std::vector<HalvesStep>, std::vector<CrossingStep>,
                   std::vector<SpanStep>, std::vector<ColumnFillStep>, std::vector<SampleStep>, std::vector<LineStep>,
                   std::vector<LinePositionStep>, std::vector<FragmentStep>, std::vector<ShadeStep>,
                   std::vector<WriteStep>, std::vector<ResolveStep>>;

    /// What this event alone adds to the counters.
    void count(const StepEvent& event, Statistics& statistics) const;

    StepFilter m_filter;
    Rules m_rules;
    Rules m_rightRules;
    std::vector<const Mistake*> m_mistakes;
    std::size_t m_sampleCount = 0;
    QImage m_finished; ///< the finished picture, where it is not the mean of the samples
    Pixel m_clear;
    bool m_truncated = false;
    bool m_stopped = false;
    std::size_t m_first = 0;
    std::size_t m_lead = 0;
    std::vector<StepEvent> m_events;
    std::vector<StepTriangle> m_triangles;
    Payloads m_payloads;
    std::vector<StepEffect> m_effects;
    std::vector<Checkpoint> m_checkpoints; ///< by position, the first at 0
    std::array<std::vector<std::uint32_t>, kStepKinds> m_byKind;
};

} // namespace rasterlens
