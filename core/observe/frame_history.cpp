#include "core/observe/frame_history.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <type_traits>
#include <utility>

namespace rasterlens
{
namespace
{

FramePlanes firstSample(const FramePlanes& planes)
{
    const auto firstOf = [](const auto& plane) {
        return std::remove_cvref_t<decltype(plane)>(plane.begin(), plane.begin() + (plane.empty() ? 0 : 1));
    };
    FramePlanes first;
    first.color = firstOf(planes.color);
    first.depth = firstOf(planes.depth);
    first.coverCount = firstOf(planes.coverCount);
    first.ownDepth = firstOf(planes.ownDepth);
    first.owners = firstOf(planes.owners);
    return first;
}

} // namespace

FrameHistory::FrameHistory(const FramePlanes& cleared)
    : m_sampleCount(cleared.color.size()), m_clear(firstSample(cleared)), m_cleared(pack(m_clear, 0, 1)),
      m_isTouched(cleared.runs.size(), 0), m_versions(cleared.runs.size())
{
}

FrameHistory::Packed FrameHistory::pack(const FramePlanes& planes, std::size_t first, std::size_t count)
{
    Packed packed;
    std::uint32_t bit = 1;
    std::array<std::byte, 5 * kRun * sizeof(float)> bytes;
    std::size_t size = 0;
    FramePlanes::forEach(planes, [&](const auto& plane) {
        const auto* from = plane.data() + first;
        constexpr std::size_t kSize = sizeof(*from);
        // Each sample is as the next one.
        const bool isUniform = std::memcmp(from, from + 1, (count - 1) * kSize) == 0;
        const std::size_t length = (isUniform ? 1 : count) * kSize;
        std::memcpy(bytes.data() + size, from, length);
        size += length;
        packed.uniform |= isUniform ? bit : 0;
        bit *= 2;
    });
    packed.bytes.assign(bytes.begin(), bytes.begin() + std::ptrdiff_t(size));
    return packed;
}

void FrameHistory::unpack(const Packed& samples, FramePlanes& planes, std::size_t first, std::size_t count)
{
    const std::byte* from = samples.bytes.data();
    std::uint32_t bit = 1;
    FramePlanes::forEach(planes, [&](auto& plane) {
        auto* to = plane.data() + first;
        constexpr std::size_t kSize = sizeof(*to);
        const bool isUniform = (samples.uniform & bit) != 0;
        const std::size_t length = (isUniform ? 1 : count) * kSize;
        std::memcpy(to, from, length);
        if (isUniform)
            std::fill_n(to, count, *to);
        from += length;
        bit *= 2;
    });
}

void FrameHistory::keep(std::uint32_t moment, const FramePlanes& planes)
{
    for (std::size_t run = 0; run < m_versions.size(); ++run) {
        if (m_isTouched[run] == 0)
            continue;
        m_isTouched[run] = 0;
        std::vector<Version>& versions = m_versions[run];
        if (!versions.empty() && versions.back().moment == moment) { // kept of a moment that was forgotten
            m_bytes -= versions.back().size();
            versions.pop_back();
        }
        versions.push_back({moment, ++m_lastId, pack(planes, run * kRun, lengthOf(run))});
        m_bytes += versions.back().size();
    }
}

void FrameHistory::thin()
{
    for (std::vector<Version>& versions : m_versions) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < versions.size(); ++i) {
            // What has changed up to an odd moment is seen from the next even one on.
            versions[i].moment = (versions[i].moment + 1) / 2;
            if (kept > 0 && versions[kept - 1].moment == versions[i].moment)
                m_bytes -= versions[--kept].size();
            if (kept != i)
                versions[kept] = std::move(versions[i]);
            ++kept;
        }
        versions.resize(kept);
    }
}

void FrameHistory::restore(std::uint32_t moment, FramePlanes& planes) const
{
    if (planes.runs.size() != m_versions.size()) {
        planes = m_clear;
        FramePlanes::forEach(planes, [&](auto& plane) { plane.resize(m_sampleCount, plane.front()); });
        planes.runs.resize(m_versions.size());
    }
    for (std::size_t run = 0; run < m_versions.size(); ++run) {
        const std::vector<Version>& versions = m_versions[run];
        const auto after = std::ranges::upper_bound(versions, moment, {}, &Version::moment);
        const bool isCleared = after == versions.begin();
        const std::uint32_t id = isCleared ? 0 : std::prev(after)->id;
        if (planes.runs[run].version == id)
            continue;
        unpack(isCleared ? m_cleared : std::prev(after)->samples, planes, run * kRun, lengthOf(run));
        planes.runs[run] = {id, planes.turn};
    }
}

} // namespace rasterlens
