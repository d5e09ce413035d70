#pragma once
#include "core/observe/frame_planes.h"

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
    static constexpr std::size_t kRun = 128; ///< samples that are kept or not kept together

    /// in  the planes of the cleared frame
    explicit FrameHistory(const FramePlanes& cleared);

    /// The sample has changed since the last moment that was kept.
    void touch(std::uint32_t sample) { m_isTouched[sample / kRun] = 1; }
    /// Keeps the next moment.
    ///
    /// in  its number, one more than the last one
    void keep(std::uint32_t moment, const FramePlanes& planes);
    /// Forgets every second moment: 0, 2, 4, ... stay, and are then 0, 1, 2, ...
    void thin();
    /// Makes the planes those of a moment.
    ///
    /// out   planes of the right size; memory they have is used again
    /// cost  one copy of all planes
    void restore(std::uint32_t moment, FramePlanes& planes) const;
    /// The memory of what is kept.
    [[nodiscard]] std::size_t bytes() const { return m_bytes; }

private:
    struct Version {
        std::uint32_t moment;
        FramePlanes samples;
    };

    std::size_t m_sampleCount;
    FramePlanes m_clear; ///< one run of the cleared frame
    std::vector<char> m_isTouched;
    std::vector<std::vector<Version>> m_versions; ///< of each run, by moment
    std::size_t m_bytesOfRun = 0;
    std::size_t m_bytes = 0;
};

} // namespace rasterlens
