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
    void touch(std::uint32_t sample) { m_isTouched[m_clear.layout.of(sample)] = 1; }
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
    /// out   changed runs of a pattern have their first samples alone (FramePlanes::make())
    /// in    seal() has been called; planes of the cleared frame, or those of this history at another moment, drawn on
    ///       or not; or empty ones
    /// cost  a copy of the runs that are not as they were at this moment, in as many threads as there are processors
    void restore(std::uint32_t moment, FramePlanes& planes) const;
    /// The colours of a packed run as they are at the moment that the planes were restored to, pixel by pixel.
    void takeColors(const FramePlanes& planes, std::size_t run, std::span<std::uint32_t> colors) const;
    /// Colours of a packed run in which all samples of each pixel have one colour: a colour a pixel.
    ///
    /// out  false: they have not, and the colours say nothing
    [[nodiscard]] bool takePixelColors(const FramePlanes& planes, std::size_t run,
                                       std::span<std::uint32_t> colors) const;
    /// The memory of what is kept.
    [[nodiscard]] std::size_t bytes() const
    {
        return m_storedBytes + m_versions.size() * sizeof(Version) + m_sealed.size() * sizeof(Sealed);
    }

private:
    static constexpr std::size_t kBlock = std::size_t(1) << 20; ///< bytes

    /// The samples of a run, pixel by pixel: of each plane the number of stretches in which all values have the same
    /// bits, these values, and where each stretch but the last one ends. Or 0 and all values, where that is shorter.
    struct Packed {
        std::uint32_t size = 0;
        std::array<std::byte, 5 * (1 + SampleRuns::kMostSamples * sizeof(float))> bytes;

        template <class T>
        void add(std::span<const T> values);
    };
    /// What a run has become, in the order of the moments.
    struct Version {
        std::uint32_t run;
        std::uint32_t moment; ///< from which on the run is so
        std::uint32_t size;
        std::size_t at; ///< in the blocks
    };
    /// A version in the order of the runs. Its number and 1 tells it from all others; 0 stands for the cleared frame.
    struct Sealed {
        std::uint32_t moment;
        std::size_t at; ///< in m_bytes
    };

    [[nodiscard]] static Packed pack(const FramePlanes& planes, std::size_t run);
    /// in  isFirstOnly  unpacks the samples of the first frame alone
    static void unpack(const std::byte* from, FramePlanes& planes, std::size_t run, bool isFirstOnly);
    /// The packed bytes of a version of a run.
    [[nodiscard]] const std::byte* bytesOf(std::uint32_t version) const
    {
        return version == 0 ? m_cleared.bytes.data() : m_bytes.data() + m_sealed[version - 1].at;
    }
    friend void FramePlanes::unpack(std::size_t run);
    /// Makes empty planes those of the cleared frame, of which they are restored.
    void makeCleared(FramePlanes& planes) const;
    /// restore() of the runs [first, last).
    void restoreRuns(std::uint32_t moment, FramePlanes& planes, std::size_t first, std::size_t last) const;
    /// Stores bytes; where.
    std::size_t store(std::span<const std::byte> bytes);
    [[nodiscard]] const std::byte* stored(const Version& version) const
    {
        return m_blocks[version.at / kBlock].get() + version.at % kBlock;
    }
    /// Forgets versions that another one of the same run and moment stands for.
    void dropReplaced();

    FramePlanes m_clear; ///< one sample of the cleared frame, in the layout of all
    Packed m_cleared;    ///< a run of the cleared frame
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
