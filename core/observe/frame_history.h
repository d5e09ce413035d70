#pragma once
#include "core/observe/frame_planes.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace rasterlens
{

/// The planes of a frame at some of its moments, numbered from 0, the cleared frame. A moment keeps only those runs of
/// samples that have changed since the moment before.
class FrameHistory
{
public:
    /// in  the planes of the cleared frame
    explicit FrameHistory(const FramePlanes& cleared);

    /// The sample has changed since the last moment that was kept.
    void touch(std::uint32_t sample) { m_isTouched[sample / FramePlanes::kRun] = 1; }
    /// Keeps the next moment.
    ///
    /// in  its number, one more than the last one
    void keep(std::uint32_t moment, const FramePlanes& planes);
    /// Forgets every second moment: 0, 2, 4, ... stay, and are then 0, 1, 2, ...
    void thin();
    /// Makes the planes those of a moment.
    ///
    /// in    planes of the cleared frame, or those of this history at another moment, drawn on or not; or empty ones
    /// cost  a copy of the runs that are not as they were at this moment
    void restore(std::uint32_t moment, FramePlanes& planes) const;
    /// The memory of what is kept.
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }

private:
    static constexpr std::size_t kRun = FramePlanes::kRun;

    /// A run of samples: of each plane one value where all of its samples have the same bits, else all of them.
    struct Packed {
        std::uint32_t uniform = 0; ///< one bit a plane
        std::vector<std::byte> bytes;
    };
    struct Version {
        std::uint32_t moment; ///< from which on the run is so
        std::uint32_t id;     ///< different from those of all other versions; 0 stands for the cleared frame
        Packed samples;

        [[nodiscard]] std::size_t size() const { return sizeof(Version) + samples.bytes.capacity(); }
    };

    [[nodiscard]] std::size_t lengthOf(std::size_t run) const { return std::min(kRun, m_sampleCount - run * kRun); }
    [[nodiscard]] static Packed pack(const FramePlanes& planes, std::size_t first, std::size_t count);
    static void unpack(const Packed& samples, FramePlanes& planes, std::size_t first, std::size_t count);

    std::size_t m_sampleCount;
    FramePlanes m_clear; ///< one sample of the cleared frame
    Packed m_cleared;    ///< a run of it
    std::vector<char> m_isTouched;
    std::vector<std::vector<Version>> m_versions; ///< of each run, by moment
    std::uint32_t m_lastId = 0;
    std::size_t m_bytes = 0;
};

} // namespace rasterlens
