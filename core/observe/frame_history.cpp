#include "core/observe/frame_history.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <ranges>
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
      m_isTouched(cleared.runs.size(), 0)
{
}

FrameHistory::Packed FrameHistory::pack(const FramePlanes& planes, std::size_t first, std::size_t count)
{
    Packed packed;
    std::uint32_t bit = 1;
    FramePlanes::forEach(planes, [&](const auto& plane) {
        const auto* from = plane.data() + first;
        constexpr std::size_t kSize = sizeof(*from);
        // Each sample is as the next one.
        const bool isUniform = std::memcmp(from, from + 1, (count - 1) * kSize) == 0;
        const std::size_t length = (isUniform ? 1 : count) * kSize;
        std::memcpy(packed.bytes.data() + packed.size, from, length);
        packed.size += static_cast<std::uint32_t>(length);
        packed.uniform |= isUniform ? bit : 0;
        bit *= 2;
    });
    return packed;
}

void FrameHistory::unpack(const std::byte* from, std::uint32_t uniform, FramePlanes& planes, std::size_t first,
                          std::size_t count)
{
    std::uint32_t bit = 1;
    FramePlanes::forEach(planes, [&](auto& plane) {
        auto* to = plane.data() + first;
        constexpr std::size_t kSize = sizeof(*to);
        const bool isUniform = (uniform & bit) != 0;
        const std::size_t length = (isUniform ? 1 : count) * kSize;
        std::memcpy(to, from, length);
        if (isUniform)
            std::fill_n(to, count, *to);
        from += length;
        bit *= 2;
    });
}

std::size_t FrameHistory::store(std::span<const std::byte> bytes)
{
    if (m_end % kBlock + bytes.size() > kBlock || m_end == m_blocks.size() * kBlock)
        m_end = (m_end + kBlock - 1) / kBlock * kBlock; // it lies in one block
    while (m_end / kBlock >= m_blocks.size())
        m_blocks.push_back(std::make_unique_for_overwrite<std::byte[]>(kBlock));
    const std::size_t at = m_end;
    std::memcpy(m_blocks[at / kBlock].get() + at % kBlock, bytes.data(), bytes.size());
    m_end += bytes.size();
    m_storedBytes += bytes.size();
    return at;
}

void FrameHistory::keep(std::uint32_t moment, const FramePlanes& planes)
{
    for (std::size_t run = 0; run < m_isTouched.size(); ++run) {
        if (m_isTouched[run] == 0)
            continue;
        m_isTouched[run] = 0;
        const Packed packed = pack(planes, run * kRun, lengthOf(run));
        const std::size_t at = store(std::span(packed.bytes).first(packed.size));
        m_versions.push_back({static_cast<std::uint32_t>(run), moment, packed.uniform, packed.size, at});
    }
}

void FrameHistory::dropReplaced()
{
    constexpr std::uint32_t kNever = 0xffffffff;
    std::vector<std::uint32_t> later(m_isTouched.size(), kNever); // of each run, the moment of its next version
    for (Version& version : std::views::reverse(m_versions))
        if (std::exchange(later[version.run], version.moment) == version.moment)
            version.size = 0;
    std::vector<std::unique_ptr<std::byte[]>> blocks;
    blocks.swap(m_blocks);
    m_end = 0;
    m_storedBytes = 0;
    std::size_t kept = 0;
    std::size_t done = 0; // blocks
    for (const Version& version : m_versions) {
        if (version.size == 0)
            continue;
        for (; done < version.at / kBlock; ++done)
            blocks[done].reset();
        const std::byte* from = blocks[done].get() + version.at % kBlock;
        Version moved = version;
        moved.at = store({from, version.size});
        m_versions[kept++] = moved;
    }
    m_versions.resize(kept);
}

void FrameHistory::thin()
{
    // What has changed up to an odd moment is seen from the next even one on.
    for (Version& version : m_versions)
        version.moment = (version.moment + 1) / 2;
    dropReplaced();
}

void FrameHistory::seal()
{
    dropReplaced();
    m_first.assign(m_isTouched.size() + 1, 0);
    for (const Version& version : m_versions)
        ++m_first[version.run + 1];
    std::partial_sum(m_first.begin(), m_first.end(), m_first.begin());
    std::vector<std::uint32_t> order(m_versions.size()); // run by run; of a run by moment
    std::vector<std::uint32_t> next = m_first;
    for (std::uint32_t i = 0; i < m_versions.size(); ++i)
        order[next[m_versions[i].run]++] = i;
    m_sealed.reserve(m_versions.size());
    m_bytes.reserve(m_storedBytes);
    for (const std::uint32_t i : order) {
        const Version& version = m_versions[i];
        m_sealed.push_back({version.moment, version.uniform, m_bytes.size()});
        m_bytes.insert(m_bytes.end(), stored(version), stored(version) + version.size);
    }
    m_versions = {};
    m_blocks.clear();
    m_isTouched = {};
}

void FrameHistory::restore(std::uint32_t moment, FramePlanes& planes) const
{
    const std::size_t runs = m_first.size() - 1;
    if (planes.runs.size() != runs) {
        planes = m_clear;
        FramePlanes::forEach(planes, [&](auto& plane) { plane.resize(m_sampleCount, plane.front()); });
        planes.runs.resize(runs);
    }
    for (std::size_t run = 0; run < runs; ++run) {
        std::uint32_t id = m_first[run + 1];
        while (id > m_first[run] && m_sealed[id - 1].moment > moment)
            --id;
        const bool isCleared = id == m_first[run];
        if (planes.runs[run].version == (isCleared ? 0 : id))
            continue;
        if (isCleared)
            unpack(m_cleared.bytes.data(), m_cleared.uniform, planes, run * kRun, lengthOf(run));
        else
            unpack(m_bytes.data() + m_sealed[id - 1].at, m_sealed[id - 1].uniform, planes, run * kRun, lengthOf(run));
        planes.runs[run] = {isCleared ? 0 : id, planes.turn};
    }
}

} // namespace rasterlens
