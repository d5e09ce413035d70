#include "core/observe/step_index.h"

#include <algorithm>

namespace rasterlens
{
namespace
{

constexpr std::size_t kMostPoints = 4096;

constexpr StepStop::Kind kMarkedStops[] = {StepStop::Kind::SignChange, StepStop::Kind::Tie, StepStop::Kind::DepthFail,
                                           StepStop::Kind::Clip, StepStop::Kind::NonFinite};

std::uint32_t bitOf(StepStop::Kind kind) { return 1U << static_cast<unsigned>(kind); }

template <class T>
std::size_t bytesOf(const std::vector<T>& values)
{
    return values.capacity() * sizeof(T);
}

} // namespace

StepIndex::StepIndex(const FramePlanes& cleared, const RecordMemory& memory)
    : m_memory(memory), m_workBetween(memory.workBetween), m_history(cleared)
{
    m_points.push_back({});
}

void StepIndex::add(const StepEvent& event)
{
    const auto position = static_cast<std::uint32_t>(m_size);
    if (m_size == 0 || m_last.face != event.face) {
        m_faces.push_back(position);
        m_faceOf.push_back(event.face);
    }
    if (m_size > 0 && isStepBoundary(m_last, event, StepLevel::Row)) {
        m_rows.push_back(position);
        if (isStepBoundary(m_last, event, StepLevel::Stage))
            m_stages.push_back(position);
    }
    if (m_size % kStretch == 0)
        m_stretches.push_back({});
    Stretch& stretch = m_stretches.back();
    const bool isPlain =
        (event.kind == StepKind::Sample || event.kind == StepKind::Write) && event.flags <= StepEvent::kCovered;
    if (!isPlain) // few events are not
        for (const StepStop::Kind kind : kMarkedStops)
            if (stopsAt(event, {kind}, 1))
                stretch.stops |= bitOf(kind);
    if (event.x >= 0 && event.y >= 0) {
        stretch.left = std::min(stretch.left, event.x);
        stretch.right = std::max(stretch.right, event.x);
        stretch.top = std::min(stretch.top, event.y);
        stretch.bottom = std::max(stretch.bottom, event.y);
    }
    m_pips.add(event);
    m_last = event;
    ++m_size;
}

void StepIndex::addPoint(const ResumePoint& point, std::uint64_t work, const FramePlanes& planes)
{
    m_history.keep(static_cast<std::uint32_t>(m_points.size()), planes);
    m_points.push_back(point);
    m_workOfLastPoint = work;
    while (m_points.size() > 2 && (m_history.bytes() > m_memory.history || m_points.size() > kMostPoints)) {
        m_history.thin();
        for (std::size_t i = 0; 2 * i < m_points.size(); ++i)
            m_points[i] = m_points[2 * i];
        m_points.resize((m_points.size() + 1) / 2);
        m_workBetween *= 2;
    }
}

void StepIndex::seal()
{
    m_rows.shrink_to_fit();
    m_stages.shrink_to_fit();
    m_faces.shrink_to_fit();
    m_faceOf.shrink_to_fit();
    m_stretches.shrink_to_fit();
    m_doubleHits.shrink_to_fit();
    m_points.shrink_to_fit();
    m_history.seal();
}

std::size_t StepIndex::pointBefore(std::size_t position) const
{
    const auto after = std::ranges::lower_bound(m_points, position, {}, &ResumePoint::position);
    return after == m_points.begin() ? 0 : static_cast<std::size_t>(after - m_points.begin()) - 1;
}

const std::vector<std::uint32_t>& StepIndex::boundaries(StepLevel level) const
{
    switch (level) {
    case StepLevel::Event:
    case StepLevel::Sample:
    case StepLevel::Row: return m_rows;
    case StepLevel::Face: return m_faces;
    case StepLevel::Stage: break;
    }
    return m_stages;
}

std::size_t StepIndex::step(std::size_t position, StepLevel level, StepDirection direction) const
{
    const std::vector<std::uint32_t>& all = boundaries(level);
    if (direction == StepDirection::Forward) {
        const auto after = std::ranges::upper_bound(all, position);
        return after == all.end() ? m_size : *after;
    }
    const auto here = std::ranges::lower_bound(all, position);
    return here == all.begin() ? 0 : *std::prev(here);
}

std::optional<StepIndex::Range> StepIndex::eventsOf(std::uint32_t face) const
{
    const auto found = std::ranges::find(m_faceOf, face);
    if (found == m_faceOf.end())
        return std::nullopt;
    const auto i = static_cast<std::size_t>(found - m_faceOf.begin());
    return Range{m_faces[i], i + 1 < m_faces.size() ? m_faces[i + 1] : m_size};
}

std::optional<StepIndex::Range> StepIndex::stretchWith(const StepStop& stop, std::size_t from, StepDirection direction,
                                                       int grid) const
{
    const auto mayHold = [&](const Stretch& stretch) {
        if (stop.kind != StepStop::Kind::Pixel)
            return (stretch.stops & bitOf(stop.kind)) != 0;
        return stretch.left / grid <= stop.x && stop.x <= stretch.right / grid && stretch.top / grid <= stop.y &&
               stop.y <= stretch.bottom / grid;
    };
    const bool forward = direction == StepDirection::Forward;
    const std::size_t count = m_stretches.size();
    // Backward the last event that is asked about is the one before `from`.
    std::size_t i = forward ? from / kStretch : (from + kStretch - 1) / kStretch;
    for (; forward ? i < count : i > 0; forward ? ++i : --i) {
        const std::size_t at = forward ? i : i - 1;
        if (at < count && mayHold(m_stretches[at]))
            return Range{at * kStretch, std::min((at + 1) * kStretch, m_size)};
    }
    return std::nullopt;
}

std::size_t StepIndex::bytes() const
{
    return bytesOf(m_rows) + bytesOf(m_stages) + bytesOf(m_faces) + bytesOf(m_faceOf) + bytesOf(m_stretches) +
           bytesOf(m_doubleHits) + bytesOf(m_points) + m_history.bytes();
}

} // namespace rasterlens
