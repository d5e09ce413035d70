#include "core/observe/because.h"

#include "core/observe/step_text.h"
#include "core/pipeline/clipping.h"
#include "core/pipeline/culling.h"
#include "core/pipeline/depth_test.h"
#include "core/pipeline/interpolation.h"
#include "core/pipeline/line_places.h"
#include "core/pipeline/texel_path.h"
#include "core/pipeline/triangle_setup.h"
#include "core/pipeline/viewport.h"
#include "core/settings/mistakes.h"
#include "core/settings/sample_pattern.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace rasterlens
{
namespace
{

/// The stages with the right rules, for what a record holds.
class Right
{
public:
    explicit Right(const StepLog& log) : m_log(log), m_rules(log.rules()), m_right(log.rightRules()) {}

    /// Whether the right rules would have made something else of the event.
    [[nodiscard]] bool differs(std::size_t i) const
    {
        const StepEvent& event = m_log.event(i);
        switch (event.kind) {
        case StepKind::CohenSutherland: return differs(m_log.payload<CohenSutherlandStep>(event));
        case StepKind::Viewport: return differs(m_log.payload<ViewportStep>(event));
        case StepKind::Facing: return differs(m_log.payload<FacingStep>(event).decision);
        case StepKind::Fate: return differs(m_log.payload<FateStep>(event).fate, i);
        case StepKind::Setup: return setupDiffers(*m_log.triangle(event));
        case StepKind::Halves: return m_rules.extraEdgeHeight != 0;
        case StepKind::Crossing: return m_rules.extraEdgeHeight != 0 || m_rules.wholeRows;
        case StepKind::Span: return differs(event, m_log.payload<SpanStep>(event));
        case StepKind::Sample: return covers(event, event.x, event.y) != event.has(StepEvent::kCovered);
        case StepKind::Fragment:
            return differs(event, m_log.payload<FragmentStep>(event)) || (m_rules.depthInLockstep && losesRace(i));
        case StepKind::Shade:
            return m_rules.cornerData != CornerData::Own || shadeDiffers(event) || isShadedElsewhere(event);
        case StepKind::Write: return (m_rules.strideIsRows && event.y > 0) || m_rules.resolvedByFace;
        case StepKind::Resolve: return m_log.payload<ResolveStep>(event).pixel.black != 0;
        case StepKind::End: return m_rules.resolve != m_right.resolve || endsEarly(i);
        case StepKind::Vertex: return vertexDiffers();
        case StepKind::ClipPlane: return differs(m_log.payload<ClipStep>(event));
        case StepKind::LineSample: return m_rules.fill == Fill::Points && isMovedPoint(event);
        case StepKind::Clipped:
        case StepKind::Triangle:
        case StepKind::Outline:
        case StepKind::Walk:
        case StepKind::Sides:
        case StepKind::Column:
        case StepKind::LineDecision:
        case StepKind::LinePosition: break; // see becauseOfLines()
        }
        return false;
    }

private:
    [[nodiscard]] bool vertexDiffers() const
    {
        return m_rules.camera != m_right.camera || m_rules.normals != m_right.normals ||
               m_rules.texels.vUp != m_right.texels.vUp;
    }

    /// Whether new corners are given other attributes, or a corner outside is cut at twice and written over.
    [[nodiscard]] bool differs(const ClipStep& step) const
    {
        const std::size_t n = step.distances.size();
        const auto isInside = [&](std::size_t i) { return step.distances[i % n] >= 0; };
        bool isCutTwice = false;
        for (std::size_t i = 0; i < n; ++i)
            isCutTwice = isCutTwice || (!isInside(i) && isInside(i + 1) && isInside(i + n - 1));
        return (!m_rules.clipInterpolates && !step.cuts.empty()) ||
               (m_rules.cutStore == CutStore::InPlace && isCutTwice);
    }

    /// Whether some corner of the triangle is drawn at this sample that lies in another one.
    [[nodiscard]] bool isMovedPoint(const StepEvent& event) const
    {
        return std::ranges::any_of(m_log.triangle(event)->screen.vertices, [&](const ScreenVertex& vertex) {
            const GridPoint drawn = sampleOf(vertex.position, m_rules.gridRounding);
            const GridPoint right = sampleOf(vertex.position, m_right.gridRounding);
            return drawn.x == event.x && drawn.y == event.y && (drawn.x != right.x || drawn.y != right.y);
        });
    }

    /// Whether texels or light are made of something else than they should be at this sample.
    [[nodiscard]] bool shadeDiffers(const StepEvent& event) const
    {
        const bool showsLevel = m_rules.shading == Shading::MipLevel;
        if (m_rules.shading != Shading::Texture && m_rules.shading != Shading::Phong && !showsLevel)
            return false;
        if (m_rules.shading == Shading::Phong && (!m_rules.colorsClamped || !m_rules.normals.normalized))
            return true;
        const ScreenTriangle& triangle = m_log.triangle(event)->screen;
        const FaceInterpolation interpolation(triangle, triangle.area2, m_right, DepthUse::Ignored);
        const Weights screen = interpolation.weightsAt(event.x, event.y);
        const Weights weights = interpolation.perspective(screen);
        Varyings varyings{};
        interpolation.varyings(weights, varyings);
        const TexelRules& texels = m_rules.texels;
        const glm::vec2 uv(varyings[kVaryingUv], varyings[kVaryingUv + 1]);
        const bool isBelowZero = m_rules.textureFilter == TextureFilter::Nearest && (uv.x < 0 || uv.y < 0);
        if (texels.uv != UvSource::Corners || (!texels.floored && isBelowZero && !showsLevel))
            return true;
        const bool blends = m_rules.textureFilter != TextureFilter::Nearest && !showsLevel;
        const bool readsLevel = m_rules.textureFilter == TextureFilter::Trilinear || showsLevel;
        return (blends && texels.centre != m_right.texels.centre) ||
               (readsLevel && levelDiffers(interpolation, screen, weights, varyings));
    }

    /// Whether the mip level comes from other derivatives, or rises otherwise, at a sample.
    [[nodiscard]] bool levelDiffers(const FaceInterpolation& interpolation, const Weights& screen,
                                    const Weights& weights, Varyings varyings) const
    {
        const UvGradient right = interpolation.uvGradient(screen, weights, kVaryingUv);
        UvGradient taken = right;
        takeOtherTexels(interpolation, m_rules, screen, varyings, taken);
        constexpr float kRounding = 1e-4F; // of differences of coordinates
        return glm::distance(taken.perX, right.perX) > kRounding || glm::distance(taken.perY, right.perY) > kRounding ||
               m_rules.texels.levelsPerDoubling != m_right.texels.levelsPerDoubling;
    }

    /// Whether the cuts are moved, of which there are some where a corner lies outside, or corners are left out.
    [[nodiscard]] bool differs(const CohenSutherlandStep& step) const
    {
        const bool isCut = std::ranges::any_of(step.regions, [](unsigned region) { return region != 0; });
        return (m_rules.clipInset != 0 && isCut) || leavesCornerOut(step);
    }

    /// Whether a corner of the screen lies inside the projected polygon, and the result is to do without it.
    [[nodiscard]] bool leavesCornerOut(const CohenSutherlandStep& step) const
    {
        if (m_rules.clipKeepsCorners)
            return false;
        const auto inside = [&](const glm::dvec2& corner) {
            bool left = true;
            bool right = true;
            for (std::size_t i = 0; i < step.before.size(); ++i) {
                const glm::dvec4& a = step.before[i].positionClip;
                const glm::dvec4& b = step.before[(i + 1) % step.before.size()].positionClip;
                const double area = twiceArea(glm::dvec2(a) / a.w, glm::dvec2(b) / b.w, corner);
                left = left && area > 0;
                right = right && area < 0;
            }
            return left || right;
        };
        return inside({-1, -1}) || inside({1, -1}) || inside({-1, 1}) || inside({1, 1});
    }

    [[nodiscard]] bool differs(const ViewportStep& step) const
    {
        const ScreenVertex right = toScreen({step.positionClip, {}}, m_right);
        constexpr double kSameSample = 1e-3; // vertices that clipping made are snapped without rounding
        const bool isCut = outcode(step.positionClip, clipVolume(m_right)).cut != 0;
        return (isCut && m_rules.clipping != m_right.clipping) || m_rules.depthIsDistance ||
               right.invW != step.screen.invW ||
               !(glm::distance(right.position, step.screen.position) < unit() + kSameSample);
    }

    /// Samples between two neighbouring positions of the snapping grid.
    [[nodiscard]] double unit() const
    {
        return m_rules.numberType == NumberType::Fixed ? double(m_rules.sampleGrid) / (1 << m_rules.subpixelBits) : 0;
    }

    [[nodiscard]] bool differs(const FacingDecision& decision) const
    {
        FaceFate right = FaceFate::Degenerate;
        if (decision.screenArea != 0)
            right = cull(m_rules.facing == m_right.facing ? decision.value : decision.screenArea, m_right);
        return right != decision.fate;
    }

    /// Culling is told of by the event of facing before it; a face that no clipping rejects is rejected by a mistake.
    [[nodiscard]] bool differs(FaceFate fate, std::size_t i) const
    {
        if (fate == FaceFate::Rejected)
            return m_rules.clipping != m_right.clipping || m_rules.rejectBy != m_right.rejectBy;
        const auto isFacing = [&](const StepEvent& event) {
            return event.kind == StepKind::Facing && event.face == m_log.event(i).face;
        };
        const auto facing = m_log.find(i, StepDirection::Backward, isFacing);
        return facing && differs(m_log.payload<FacingStep>(m_log.event(*facing)).decision);
    }

    [[nodiscard]] bool setupDiffers(const StepTriangle& triangle) const
    {
        const bool isTurned = triangle.hasSetup && triangle.setup.area2 < 0;
        return isTurned || m_rules.bounds != m_right.bounds;
    }

    /// Whether a pixel of a pattern is shaded at another place, or with other derivatives: those to a neighbour that is
    /// shaded as far away as the right rules think.
    [[nodiscard]] bool isShadedElsewhere(const StepEvent& event) const
    {
        const StepTriangle& triangle = *m_log.triangle(event);
        if (!m_rules.multiSampled() || !triangle.hasSetup)
            return false;
        const auto offsetAt = [&](const Rules& rules, int x, int y) {
            return shadingOffset(rules, coveredSamples(triangle.setup, m_right, x, y));
        };
        const glm::dvec2 right = offsetAt(m_right, event.x, event.y);
        if (right != offsetAt(m_rules, event.x, event.y))
            return true;
        return m_rules.gradientByNeighbours &&
               (right != offsetAt(m_right, event.x ^ 1, event.y) || right != offsetAt(m_right, event.x, event.y ^ 1));
    }

    template <class T>
    [[nodiscard]] bool covers(const ScreenTriangle& triangle, int x, int y) const
    {
        const auto setup = setupTriangle<T>(triangle, m_right);
        if (!setup)
            return false;
        const PixelRect& box = setup->bounds;
        const Point<T> centre = TriangleSetup<T>::centre(x, y);
        const T reach = cornerReach<T>(m_right);
        return x >= box.x && y >= box.y && x < box.x + box.width && y < box.y + box.height &&
               std::ranges::all_of(setup->edges, [&](const EdgeFunction<T>& edge) {
                   return edge.atCorner(centre, reach) >= edge.threshold;
               });
    }

    /// Whether the triangle of an event covers a sample.
    [[nodiscard]] bool covers(const StepEvent& event, int x, int y) const
    {
        ScreenTriangle triangle = m_log.triangle(event)->screen;
        if (m_right.multiSampled())
            for (ScreenVertex& vertex : triangle.vertices)
                vertex.position -= testedOffset(m_right, event.sample).pixels();
        switch (m_right.numberType) {
        case NumberType::Fixed: return covers<std::int64_t>(triangle, x, y);
        case NumberType::Float32: return covers<float>(triangle, x, y);
        case NumberType::Float64: break;
        }
        return covers<double>(triangle, x, y);
    }

    [[nodiscard]] bool differs(const StepEvent& event, const SpanStep& span) const
    {
        const auto isRight = [&](int x) { return covers(event, x, event.y) == (x >= span.xBegin && x < span.xEnd); };
        return !(isRight(span.xBegin - 1) && isRight(span.xBegin) && isRight(span.xEnd - 1) && isRight(span.xEnd));
    }

    [[nodiscard]] bool differs(const StepEvent& event, const FragmentStep& step) const
    {
        const bool passed = event.has(StepEvent::kPassed);
        const bool clear = step.storedDepth == m_rules.depthClear;
        const float stored = clear ? m_right.depthClear : step.storedDepth;
        const bool passes =
            !m_right.depthTested || depthPasses(step.depth, stored, depthCompareOf(m_right, event.face));
        if (m_rules.depthTested != m_right.depthTested || passes != passed || (!passed && m_rules.depthWrittenOnFail) ||
            m_rules.integerLineWeights || event.has(StepEvent::kSharedDepth))
            return true;
        if (m_rules.depthFormat != m_right.depthFormat || m_rules.depthIsDistance || !m_rules.depthLinear ||
            m_rules.keptW != KeptW::Inverse || !m_rules.clipUpdatesW || m_rules.weightUnit > 0)
            return true;
        if (m_rules.depthTruncated || (m_rules.depthBias != m_right.depthBias && !isFirstPass(m_right, event.face)) ||
            (m_rules.clipping == Clipping::DepthClamp && m_right.clipping != Clipping::DepthClamp &&
             isHeld(step.depth)))
            return true;
        const ScreenTriangle& triangle = m_log.triangle(event)->screen;
        const auto& [a, b, c] = triangle.vertices;
        const FaceInterpolation interpolation(triangle, twiceArea(a.position, b.position, c.position), m_right);
        const bool moved = m_rules.positionInterpolated && interpolation.weightsAt(event.x, event.y) != step.screen;
        const bool unlike = m_rules.perspectiveCorrect != m_right.perspectiveCorrect && m_rules.varyingCount > 0 &&
                            step.shaded && interpolation.perspective(step.screen) != step.weights;
        return moved || unlike;
    }

    /// Whether the other face of a pair in lockstep has written a depth that would have decided otherwise.
    [[nodiscard]] bool losesRace(std::size_t i) const
    {
        const StepEvent& event = m_log.event(i);
        const float depth = m_log.payload<FragmentStep>(event).depth;
        for (std::size_t k = i; event.face % 2 == 1 && k-- > 0 && m_log.event(k).face + 1 >= event.face;) {
            const StepEvent& other = m_log.event(k);
            if (other.kind == StepKind::Fragment && other.face + 1 == event.face && other.x == event.x &&
                other.y == event.y && other.sample == event.sample && other.has(StepEvent::kPassed))
                return event.has(StepEvent::kPassed) != depthPasses(depth, m_log.payload<FragmentStep>(other).depth,
                                                                    depthCompareOf(m_right, event.face));
        }
        return false;
    }

    /// Whether a depth lies at an end of the depth range, where those that are clamped come to lie.
    [[nodiscard]] bool isHeld(float depth) const
    {
        const DepthStore store(m_rules);
        return depth == static_cast<float>(store.low) || depth == static_cast<float>(store.high);
    }

    /// A frame that ends with a face that was rejected, and not for want of more faces.
    [[nodiscard]] bool endsEarly(std::size_t i) const
    {
        const auto fates = m_log.eventsOf(StepKind::Fate);
        return !m_rules.continuesAfterReject && i > 0 && !fates.empty() &&
               m_log.payload<FateStep>(m_log.event(fates.back())).fate == FaceFate::Rejected;
    }

    const StepLog& m_log;
    const Rules& m_rules;
    const Rules& m_right;
};

/// A line of a triangle, as samples.
struct SampleLine {
    GridPoint from;
    GridPoint to;

    [[nodiscard]] bool runsLeft() const { return from.x > to.x; }
};

/// The lines that a triangle draws.
std::vector<SampleLine> linesOf(const ScreenTriangle& triangle)
{
    const auto& [a, b, c] = triangle.vertices;
    const std::array<GridPoint, 3> at{sampleOf(a.position), sampleOf(b.position), sampleOf(c.position)};
    std::vector<SampleLine> lines;
    for (std::size_t i = 0; i < 3; ++i)
        if (triangle.drawsEdge(i))
            lines.push_back({at[i], at[(i + 1) % 3]});
    return lines;
}

/// Whether a decision about a line is made at its right end, or leads there.
bool touchesRightEnd(const SampleLine& line, const StepEvent& event, const LineDecision& decision)
{
    const bool isFirst = decision.step == 0 && event.x == line.from.x && event.y == line.from.y;
    const bool isLast = decision.step + 1 == decision.longer && std::abs(event.x - line.to.x) <= 1 &&
                        std::abs(event.y - line.to.y) <= 1;
    return line.runsLeft() ? isFirst : isLast;
}

/// Whether a position on a line is its right end.
bool isRightEnd(const SampleLine& line, const LinePosition& position)
{
    const GridPoint end = line.runsLeft() ? line.from : line.to;
    return position.step == (line.runsLeft() ? 0 : position.steps) && position.column == end.x && position.row == end.y;
}

/// Whether rules are the reason why an event of a wireframe is what it is. Samples that are left out have no event: the
/// triangle they belong to and the decisions beside them speak for them.
bool drawOtherLines(const Rules& rules, const StepLog& log, const StepEvent& event)
{
    if (event.kind == StepKind::LineSample)
        return rules.lineAdvance != log.rightRules().lineAdvance;
    const std::vector<SampleLine> lines = linesOf(log.triangle(event)->screen);
    if (event.kind == StepKind::Triangle)
        return !rules.rightLineEnds || std::ranges::any_of(lines, [&](const SampleLine& line) {
            return (rules.lineOctants >> octantOf(line.from, line.to) & 1U) == 0;
        });
    if (event.kind == StepKind::LineDecision && rules.lineTiesByDirection != log.rightRules().lineTiesByDirection &&
        log.payload<LineStep>(event).decision.decision == 0)
        return true;
    return !rules.rightLineEnds && std::ranges::any_of(lines, [&](const SampleLine& line) {
        return event.kind == StepKind::LinePosition
                   ? isRightEnd(line, log.payload<LinePositionStep>(event).position)
                   : touchesRightEnd(line, event, log.payload<LineStep>(event).decision);
    });
}

/// The mistakes of a record each of which draws other lines.
std::vector<const Mistake*> becauseOfLines(const StepLog& log, const StepEvent& event)
{
    std::vector<const Mistake*> causes;
    for (const Mistake* mistake : log.mistakes()) {
        Rules rules = log.rightRules();
        mistake->apply(rules);
        if (drawOtherLines(rules, log, event))
            causes.push_back(mistake);
    }
    return causes;
}

bool isAboutLines(StepKind kind)
{
    return kind == StepKind::Triangle || kind == StepKind::LineDecision || kind == StepKind::LinePosition ||
           kind == StepKind::LineSample;
}

/// The kinds that a mistake is to name for an event: what became of a face was decided before it.
StepKinds kindsFor(const StepLog& log, const StepEvent& event)
{
    if (event.kind != StepKind::Fate)
        return kindBit(event.kind);
    const bool rejected = log.payload<FateStep>(event).fate == FaceFate::Rejected;
    return kindBit(rejected ? StepKind::ClipPlane : StepKind::Facing);
}

} // namespace

std::vector<const Mistake*> becauseOf(const StepLog& log, std::size_t i)
{
    const StepEvent& event = log.event(i);
    if (isAboutLines(event.kind) && passRules(log.rules(), event.face).fill == Fill::Wireframe)
        return becauseOfLines(log, event);
    std::vector<const Mistake*> causes;
    const StepKinds kinds = kindsFor(log, event);
    for (const Mistake* mistake : log.mistakes())
        if ((stepsOf(*mistake) & kinds) != 0)
            causes.push_back(mistake);
    if (!causes.empty() && !Right(log).differs(i))
        causes.clear();
    return causes;
}

Reason becauseText(std::span<const Mistake* const> mistakes)
{
    Reason names = QString();
    for (const Mistake* mistake : mistakes) {
        const Reason name{"%1 %2", {QString::fromLatin1(mistake->number), mistake->title}};
        names = isEmpty(names) ? name : Reason(QT_TRANSLATE_NOOP("Steps", "%1 and %2"), {names, name});
    }
    return isEmpty(names) ? names : Reason(QT_TRANSLATE_NOOP("Steps", "because of %1"), {names});
}

} // namespace rasterlens
