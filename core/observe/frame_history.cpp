#include "core/observe/frame_history.h"

#include <algorithm>
#include <utility>

namespace rasterlens
{
namespace
{

/// A run of samples out of whole planes.
FramePlanes runOf(const FramePlanes& planes, std::size_t first, std::size_t count)
{
    FramePlanes run;
    FramePlanes::forEachPair(run, planes, [&](auto& part, const auto& plane) {
        if (!plane.empty())
            part.assign(plane.begin() + std::ptrdiff_t(first), plane.begin() + std::ptrdiff_t(first + count));
    });
    return run;
}

} // namespace

FrameHistory::FrameHistory(const FramePlanes& cleared)
    : m_sampleCount(cleared.color.size()), m_clear(runOf(cleared, 0, std::min(kRun, cleared.color.size()))),
      m_isTouched((cleared.color.size() + kRun - 1) / kRun, 0), m_versions(m_isTouched.size())
{
    m_bytesOfRun = sizeof(Version);
    FramePlanes::forEachPair(m_clear, m_clear, [&](const auto& plane, const auto&) {
        m_bytesOfRun += plane.size() * sizeof(plane.front());
    });
}

void FrameHistory::keep(std::uint32_t moment, const FramePlanes& planes)
{
    for (std::size_t run = 0; run < m_versions.size(); ++run) {
        if (m_isTouched[run] == 0)
            continue;
        m_isTouched[run] = 0;
        std::vector<Version>& versions = m_versions[run];
        const std::size_t first = run * kRun;
        Version version{moment, runOf(planes, first, std::min(kRun, m_sampleCount - first))};
        if (!versions.empty() && versions.back().moment == moment) { // kept of a moment that was forgotten
            versions.back() = std::move(version);
            continue;
        }
        versions.push_back(std::move(version));
        m_bytes += m_bytesOfRun;
    }
}

void FrameHistory::thin()
{
    for (std::vector<Version>& versions : m_versions) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < versions.size(); ++i) {
            // What has changed up to an odd moment is seen from the next even one on.
            versions[i].moment = (versions[i].moment + 1) / 2;
            const bool isLater = kept > 0 && versions[kept - 1].moment == versions[i].moment;
            m_bytes -= isLater ? m_bytesOfRun : 0;
            kept += isLater ? 0 : 1;
            if (kept - 1 != i)
                versions[kept - 1] = std::move(versions[i]);
        }
        versions.resize(kept);
    }
}

void FrameHistory::restore(std::uint32_t moment, FramePlanes& planes) const
{
    FramePlanes::forEachPair(planes, m_clear,
                             [&](auto& plane, const auto& clear) { plane.resize(clear.empty() ? 0 : m_sampleCount); });
    for (std::size_t run = 0; run < m_versions.size(); ++run) {
        const std::vector<Version>& versions = m_versions[run];
        const auto after = std::ranges::upper_bound(versions, moment, {}, &Version::moment);
        const FramePlanes& samples = after == versions.begin() ? m_clear : std::prev(after)->samples;
        const std::size_t first = run * kRun;
        const std::size_t count = std::min(kRun, m_sampleCount - first);
        FramePlanes::forEachPair(planes, samples, [&](auto& plane, const auto& part) {
            if (!plane.empty())
                std::copy_n(part.begin(), count, plane.begin() + std::ptrdiff_t(first));
        });
    }
}

} // namespace rasterlens
