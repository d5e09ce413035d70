#include "core/observe/frame_history.h"

#include "core/base/in_parallel.h"

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
    first.layout = planes.layout;
    return first;
}

/// Calls visit(sample in the planes, place in the run) for the samples of a run. Its places go pixel by pixel.
template <class Visit>
void forEachSample(const SampleRuns& layout, std::size_t run, Visit&& visit)
{
    const std::size_t first = layout.first(run);
    const std::size_t length = layout.length(run);
    for (std::size_t f = 0; f < layout.frames; ++f)
        for (std::size_t i = 0; i < length; ++i)
            visit(f * layout.frame + first + i, i * layout.frames + f);
}

/// Reads the next value of packed bytes.
template <class T>
T taken(const std::byte*& from)
{
    T value;
    std::memcpy(&value, from, sizeof(value));
    from += sizeof(value);
    return value;
}

/// Calls visit() with the number of frames as one that the compiler knows, so that it need not divide.
template <class Visit>
void withKnown(std::size_t frames, Visit&& visit)
{
    switch (frames) {
    case 2: visit(std::integral_constant<std::size_t, 2>()); return;
    case 4: visit(std::integral_constant<std::size_t, 4>()); return;
    case 8: visit(std::integral_constant<std::size_t, 8>()); return;
    default: visit(frames);
    }
}

/// A run in a plane. Places in it go pixel by pixel.
template <class T>
struct RunOfPlane {
    T* first; ///< of its samples in the first frame
    std::size_t length;
    const SampleRuns& layout;
    bool isFirstOnly = false; ///< samples of other frames are left as they are

    /// Makes the samples at places [begin, end) one value.
    void fill(std::size_t begin, std::size_t end, T value) const
    {
        if (layout.frames == 1) {
            std::fill(first + begin, first + end, value);
        } else if (isFirstOnly) {
            withKnown(layout.frames, [&](auto frames) {
                std::fill(first + (begin + frames - 1) / frames, first + (end + frames - 1) / frames, value);
            });
        } else if (begin == 0 && end == length * layout.frames) {
            for (std::size_t f = 0; f < layout.frames; ++f)
                std::fill_n(first + f * layout.frame, length, value);
        } else {
            withKnown(layout.frames, [&](auto frames) {
                for (std::size_t i = begin; i < end; ++i)
                    first[i % frames * layout.frame + i / frames] = value;
            });
        }
    }

    /// Makes the samples what is packed.
    ///
    /// out  behind it
    const std::byte* unpack(const std::byte* from) const
    {
        const std::size_t count = length * layout.frames;
        const std::size_t stretches = taken<std::uint8_t>(from);
        if (stretches == 0 && layout.frames == 1) {
            std::memcpy(first, from, count * sizeof(T));
            return from + count * sizeof(T);
        }
        if (stretches == 0) {
            for (std::size_t i = 0; i < count; ++i)
                fill(i, i + 1, taken<T>(from));
            return from;
        }
        const std::byte* ends = from + stretches * sizeof(T);
        std::size_t begin = 0;
        for (std::size_t i = 0; i < stretches; ++i) {
            const std::size_t end = i + 1 < stretches ? taken<std::uint8_t>(ends) : count;
            fill(begin, end, taken<T>(from));
            begin = end;
        }
        return ends;
    }
};

} // namespace

FrameHistory::FrameHistory(const FramePlanes& cleared)
    : m_clear(firstSample(cleared)), m_isTouched(cleared.runs.size(), 0)
{
    FramePlanes::forEach(m_clear, [&](const auto& plane) { m_cleared.add(std::span(plane)); });
}

template <class T>
void FrameHistory::Packed::add(std::span<const T> values)
{
    std::array<T, SampleRuns::kMostSamples> stretchValues;
    std::array<std::uint8_t, SampleRuns::kMostSamples> ends;
    std::size_t stretches = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        stretchValues[stretches] = values[i];
        ends[stretches] = static_cast<std::uint8_t>(i + 1);
        const bool isLast = i + 1 == values.size() || std::memcmp(&values[i], &values[i + 1], sizeof(T)) != 0;
        stretches += isLast ? 1 : 0;
    }
    const auto write = [&](const auto* from, std::size_t count) {
        std::memcpy(bytes.data() + size, from, count * sizeof(*from));
        size += static_cast<std::uint32_t>(count * sizeof(*from));
    };
    const bool isShorter = stretches * (sizeof(T) + 1) - 1 <= values.size() * sizeof(T);
    const auto head = static_cast<std::uint8_t>(isShorter ? stretches : 0);
    write(&head, 1);
    if (isShorter) {
        write(stretchValues.data(), stretches);
        write(ends.data(), stretches - 1);
    } else {
        write(values.data(), values.size());
    }
}

FrameHistory::Packed FrameHistory::pack(const FramePlanes& planes, std::size_t run)
{
    const SampleRuns& layout = planes.layout;
    const std::size_t count = layout.length(run) * layout.frames;
    Packed packed;
    FramePlanes::forEach(planes, [&]<class T>(const FramePlanes::Plane<T>& plane) {
        if (layout.frames == 1) {
            packed.add(std::span(plane).subspan(layout.first(run), count));
            return;
        }
        std::array<T, SampleRuns::kMostSamples> values;
        forEachSample(layout, run, [&](std::size_t sample, std::size_t place) { values[place] = plane[sample]; });
        packed.add(std::span<const T>(values).first(count));
    });
    return packed;
}

void FrameHistory::unpack(const std::byte* from, FramePlanes& planes, std::size_t run, bool isFirstOnly)
{
    const SampleRuns layout = planes.layout;
    FramePlanes::forEach(planes, [&]<class T>(FramePlanes::Plane<T>& plane) {
        from = RunOfPlane<T>{plane.data() + layout.first(run), layout.length(run), layout, isFirstOnly}.unpack(from);
    });
}

void FramePlanes::unpack(std::size_t run)
{
    FrameHistory::unpack(history->bytesOf(runs[run].version), *this, run, false);
    runs[run].isPacked = false;
}

void FrameHistory::takeColors(const FramePlanes& planes, std::size_t run, std::span<std::uint32_t> colors) const
{
    const SampleRuns flat; // one frame: place by place
    RunOfPlane<std::uint32_t>{colors.data(), colors.size(), flat}.unpack(bytesOf(planes.runs[run].version));
}

bool FrameHistory::takePixelColors(const FramePlanes& planes, std::size_t run, std::span<std::uint32_t> colors) const
{
    const std::size_t frames = m_clear.layout.frames;
    const std::byte* from = bytesOf(planes.runs[run].version);
    const std::size_t stretches = taken<std::uint8_t>(from);
    const std::byte* ends = from + stretches * sizeof(std::uint32_t);
    std::size_t begin = 0;
    for (std::size_t i = 0; i < stretches; ++i) {
        const std::size_t end = i + 1 < stretches ? taken<std::uint8_t>(ends) : colors.size() * frames;
        if (end % frames != 0)
            return false;
        std::fill(colors.begin() + std::ptrdiff_t(begin / frames), colors.begin() + std::ptrdiff_t(end / frames),
                  taken<std::uint32_t>(from));
        begin = end;
    }
    return stretches > 0;
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
        const Packed packed = pack(planes, run);
        const std::size_t at = store(std::span(packed.bytes).first(packed.size));
        m_versions.push_back({static_cast<std::uint32_t>(run), moment, packed.size, at});
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
        m_sealed.push_back({version.moment, m_bytes.size()});
        m_bytes.insert(m_bytes.end(), stored(version), stored(version) + version.size);
    }
    m_versions = {};
    m_blocks.clear();
    m_isTouched = {};
}

void FrameHistory::makeCleared(FramePlanes& planes) const
{
    const SampleRuns& layout = m_clear.layout;
    const std::uint32_t turn = planes.turn;
    planes = m_clear;
    FramePlanes::forEach(planes, [&](auto& plane) {
        const auto clear = plane.front();
        plane.resize(layout.frame * layout.frames);
        std::fill_n(plane.begin(), layout.areLeftPacked() ? layout.frame : plane.size(), clear);
    });
    planes.turn = turn;
    planes.runs.assign(layout.count(), {0, turn, layout.areLeftPacked()});
}

void FrameHistory::restore(std::uint32_t moment, FramePlanes& planes) const
{
    const SampleRuns& layout = m_clear.layout;
    if (planes.runs.size() != layout.count())
        makeCleared(planes);
    planes.history = this;
    constexpr std::size_t kRunsOfThread = 1024; // at least
    inParallel(layout.count(), kRunsOfThread,
               [&](std::size_t first, std::size_t last) { restoreRuns(moment, planes, first, last); });
}

void FrameHistory::restoreRuns(std::uint32_t moment, FramePlanes& planes, std::size_t first, std::size_t last) const
{
    const SampleRuns& layout = m_clear.layout;
    for (std::size_t run = first; run < last; ++run) {
        std::uint32_t id = m_first[run + 1];
        while (id > m_first[run] && m_sealed[id - 1].moment > moment)
            --id;
        const std::uint32_t version = id == m_first[run] ? 0 : id;
        if (planes.runs[run].version == version)
            continue;
        planes.runs[run] = {version, planes.turn, layout.areLeftPacked()};
        unpack(bytesOf(version), planes, run, layout.areLeftPacked());
    }
}

} // namespace rasterlens
