#include "core/observe/face_moment.h"

#include "core/observe/names.h"
#include "core/pipeline/unsnapped.h"

#include <algorithm>

namespace rasterlens
{
namespace
{

bool isGeometry(StepKind kind) { return kind < StepKind::Triangle; }

/// Follows the corners of a face from step to step.
class MomentWriter
{
public:
    explicit MomentWriter(std::uint32_t face) { m_moment.face = face; }

    void take(const StepLog& log, const StepEvent& event)
    {
        m_moment.kind = event.kind;
        m_moment.before.clear();
        m_moment.plane.reset();
        switch (event.kind) {
        case StepKind::Vertex: take(log.payload<VertexStep>(event)); break;
        case StepKind::ClipPlane: take(log.payload<ClipStep>(event)); break;
        case StepKind::CohenSutherland: take(log.payload<CohenSutherlandStep>(event)); break;
        case StepKind::Viewport: take(log.payload<ViewportStep>(event)); break;
        case StepKind::Facing: m_moment.fate = log.payload<FacingStep>(event).decision.fate; break;
        case StepKind::Fate: m_moment.fate = log.payload<FateStep>(event).fate; break;
        case StepKind::Clipped:
        case StepKind::Triangle:
        case StepKind::Setup:
        case StepKind::Outline:
        case StepKind::Walk:
        case StepKind::Sides:
        case StepKind::Halves:
        case StepKind::Crossing:
        case StepKind::Span:
        case StepKind::Column:
        case StepKind::Sample:
        case StepKind::LineDecision:
        case StepKind::LinePosition:
        case StepKind::LineSample:
        case StepKind::Fragment:
        case StepKind::Shade:
        case StepKind::Write:
        case StepKind::Resolve:
        case StepKind::End: break;
        }
    }

    [[nodiscard]] const FaceMoment& moment() const { return m_moment; }

private:
    void take(const VertexStep& step)
    {
        m_moment.corner = m_moment.corners.size();
        m_moment.corners.push_back({cornerLetter(std::size_t(step.corner)), step.clip.positionClip, std::nullopt});
    }

    [[nodiscard]] QString nextName() { return QStringLiteral("I%1").arg(++m_cuts); }

    void take(const ClipStep& step)
    {
        m_moment.plane = step.plane;
        m_moment.before = std::move(m_moment.corners);
        m_moment.corners.clear();
        const std::size_t n = std::min(step.before.size(), m_moment.before.size());
        for (std::size_t i = 0; i < n; ++i) {
            const bool isInside = step.distances[i] >= 0;
            if (isInside)
                m_moment.corners.push_back(m_moment.before[i]);
            if (isInside != (step.distances[(i + 1) % n] >= 0))
                m_moment.corners.push_back({nextName(), {}, std::nullopt});
        }
        // Where all of it is cut away, there are no new corners.
        m_moment.corners.resize(std::min(m_moment.corners.size(), step.after.size()));
        for (std::size_t i = 0; i < m_moment.corners.size(); ++i)
            m_moment.corners[i].positionClip = step.after[i].positionClip;
    }

    /// The stage does not tell which corner came from which: those that stayed are found by their place.
    void take(const CohenSutherlandStep& step)
    {
        m_moment.before = std::move(m_moment.corners);
        m_moment.corners.clear();
        for (const ClipVertex& vertex : step.after) {
            const auto same = std::ranges::find(m_moment.before, vertex.positionClip, &MomentCorner::positionClip);
            m_moment.corners.push_back(
                {same != m_moment.before.end() ? same->name : nextName(), vertex.positionClip, std::nullopt});
        }
    }

    void take(const ViewportStep& step)
    {
        m_moment.corner = std::size_t(step.corner);
        if (m_moment.corner < m_moment.corners.size())
            m_moment.corners[m_moment.corner].snapped = step.screen.position;
    }

    FaceMoment m_moment;
    int m_cuts = 0;
};

} // namespace

std::optional<glm::dvec2> MomentCorner::onScreen(const Rules& rules) const
{
    if (snapped)
        return snapped;
    return positionClip.w > 0 ? std::optional(unsnappedPosition(positionClip, rules)) : std::nullopt;
}

std::optional<FaceMoment> faceMomentAt(const StepLog& log, std::size_t position)
{
    if (position == 0 || !isGeometry(log.event(position - 1).kind))
        return std::nullopt;
    const std::uint32_t face = log.event(position - 1).face;
    std::size_t first = position - 1;
    while (first > 0 && log.event(first - 1).face == face && isGeometry(log.event(first - 1).kind))
        --first;
    MomentWriter writer(face);
    for (std::size_t i = first; i < position; ++i)
        writer.take(log, log.event(i));
    return writer.moment();
}

std::optional<std::array<glm::dvec2, 2>> edgeOnScreen(const MomentCorner& from, const MomentCorner& to,
                                                      const Rules& rules)
{
    if (const auto a = from.onScreen(rules), b = to.onScreen(rules); a && b)
        return std::array{*a, *b};
    // An edge that runs past the eye goes to infinity; its last part is too far off to be seen.
    const bool isFromInFront = from.positionClip.w > 0;
    const glm::dvec4& inFront = isFromInFront ? from.positionClip : to.positionClip;
    const glm::dvec4& behind = isFromInFront ? to.positionClip : from.positionClip;
    if (!(inFront.w > 0) || !(behind.w <= 0))
        return std::nullopt;
    constexpr double kLeastW = 1e-3;
    const double t = (1 - kLeastW) * inFront.w / (inFront.w - behind.w);
    const glm::dvec2 near = unsnappedPosition(inFront, rules);
    const glm::dvec2 far = unsnappedPosition(inFront + t * (behind - inFront), rules);
    return isFromInFront ? std::array{near, far} : std::array{far, near};
}

} // namespace rasterlens
