#pragma once
#include "core/observe/frame_planes.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
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
    /// No more moments are kept. What there is is laid down run by run: to go back to a moment reads it from front to
    /// end.
    void seal();
    /// Makes the planes those of a moment.
    ///
    /// in    seal() has been called; planes of the cleared frame, or those of this history at another moment, drawn on
    ///       or not; or empty ones
    /// cost  a copy of the runs that are not as they were at this moment
    void restore(std::uint32_t moment, FramePlanes& planes) const;
    /// The memory of what is kept.
    [[nodiscard]] std::size_t bytes() const
    {
        return m_storedBytes + m_versions.size() * sizeof(Version) + m_sealed.size() * sizeof(Sealed);
    }

private:
    static constexpr std::size_t kRun = FramePlanes::kRun;
    static constexpr std::size_t kBlock = std::size_t(1) << 20; ///< bytes

    /// The samples of a run: of each plane one value where all have the same bits, else all of them.
    struct Packed {
        std::uint32_t uniform = 0; ///< one bit a plane
        std::uint32_t size = 0;
        std::array<std::byte, 5 * kRun * sizeof(float)> bytes;
    };
    /// What a run has become, in the order of the moments.
    struct Version {
        std::uint32_t run;
        std::uint32_t moment; ///< from which on the run is so
        std::uint32_t uniform;
        std::uint32_t size;
        std::size_t at; ///< in the blocks
    };
    /// A version in the order of the runs. Its number and 1 tells it from all others; 0 stands for the cleared frame.
    struct Sealed {
        std::uint32_t moment;
        std::uint32_t uniform;
        std::size_t at; ///< in m_bytes
    };

    [[nodiscard]] std::size_t lengthOf(std::size_t run) const { return std::min(kRun, m_sampleCount - run * kRun); }
    [[nodiscard]] static Packed pack(const FramePlanes& planes, std::size_t first, std::size_t count);
    static void unpack(const std::byte* from, std::uint32_t uniform, FramePlanes& planes, std::size_t first,
                       std::size_t count);
    /// Stores bytes; where.
    std::size_t store(std::span<const std::byte> bytes);
    [[nodiscard]] const std::byte* stored(const Version& version) const
    {
        return m_blocks[version.at / kBlock].get() + version.at % kBlock;
    }
    /// Forgets versions that another one of the same run and moment stands for.
    void dropReplaced();

    std::size_t m_sampleCount;
    FramePlanes m_clear; ///< one sample of the cleared frame
    Packed m_cleared;    ///< a run of it
    std::vector<char> m_isTouched;

    // Until it is sealed.
    std::vector<Version> m_versions;
    std::vector<std::unique_ptr<std::byte[]>> m_blocks;
    std::size_t m_end = 0; ///< of what the blocks hold
    std::size_t m_storedBytes = 0;

    // From then on.
    std::vector<std::uint32_t> m_first; ///< of each run, into m_sealed; and the end
    std::vector<Sealed> m_sealed;
    std::vector<std::byte> m_bytes;
};

} // namespace rasterlens
