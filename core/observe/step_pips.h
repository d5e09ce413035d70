#pragma once
#include "core/observe/step_log.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rasterlens
{

/// What a pip of a scrubber marks. Where several fall on one place, the rare ones are shown, the last of this list
/// before the others, and of the common ones, up to Cull, the most frequent.
enum class PipKind : std::uint8_t { None, Other, Sample, Outside, Cull, Clip, DepthFail, Tie };
constexpr std::size_t kPipKinds = 8;
[[nodiscard]] PipKind pipKindOf(const StepEvent& event);

/// How many pips of each kind there are along a record: in runs of equally many events, which grow with the record.
class PipCounts
{
public:
    /// The next event.
    void add(const StepEvent& event);

    /// The most telling pip of each column of a scrubber; one column more than there are events has a column for the
    /// cleared frame and for each event.
    ///
    /// exact  where the runs are single events or the columns no narrower than a run
    [[nodiscard]] std::vector<PipKind> columns(int count) const;

private:
    using Counts = std::array<std::uint32_t, kPipKinds>;
    static constexpr std::size_t kMostRuns = 16384;

    std::vector<Counts> m_runs;
    std::size_t m_eventsOfRun = 1;
    std::size_t m_size = 0;
};

} // namespace rasterlens
