#pragma once
#include "core/base/unfilled.h"
#include "core/observe/step_log.h"
#include "core/scene/scene.h"

#include <algorithm>
#include <cstdint>
#include <stop_token>
#include <vector>

namespace rasterlens
{

/// How the stored samples of a frame are taken together in runs: pixels that follow each other, with all samples of
/// their pattern. Where there is no pattern, samples stand for pixels.
struct SampleRuns {
    static constexpr std::size_t kMostSamples = 256; ///< of a run

    std::size_t frame = 0;  ///< samples of a frame
    std::size_t frames = 1; ///< as many as the pattern has samples; they are stored one behind the other
    int shift = 6;          ///< a run has 2^shift samples of each frame
    bool hasPixels = false; ///< the samples of a pixel lie in one run; false on a grid, and with a mistake in addresses

    SampleRuns() = default;
    explicit SampleRuns(const Rules& rules);

    /// The run that holds a sample.
    [[nodiscard]] std::size_t of(std::size_t sample) const { return (frames == 1 ? sample : sample % frame) >> shift; }
    [[nodiscard]] std::size_t count() const { return (frame + (std::size_t(1) << shift) - 1) >> shift; }
    /// The first sample of a run, in the first frame.
    [[nodiscard]] std::size_t first(std::size_t run) const { return run << shift; }
    /// Runs are unpacked when their samples are asked for (FramePlanes::make()).
    [[nodiscard]] bool areLeftPacked() const { return frames > 1 && hasPixels; }
    /// How many samples of each frame a run has.
    [[nodiscard]] std::size_t length(std::size_t run) const
    {
        return std::min(std::size_t(1) << shift, frame - first(run));
    }
};

class FrameHistory;

/// All samples of a frame at one moment, in the order they are stored. Planes that the rules do not call for are empty.
struct FramePlanes {
    static constexpr std::uint32_t kNoVersion = 0xffffffff; ///< Run::version
    /// Samples of packed runs need not have been written.
    template <class T>
    using Plane = std::vector<T, UnfilledAllocator<T>>;
    /// What is known of a run of samples.
    struct Run {
        std::uint32_t version = 0; ///< of a FrameHistory, if the run is still as it was restored; 0 as it was cleared
        std::uint32_t turn = 0;    ///< in which it changed last
        /// The planes have samples of the first frame alone; those of other frames are packed in the history.
        bool isPacked = false;
    };

    Plane<std::uint32_t> color; ///< 0xffRRGGBB as it is shown: with overdraw, the colour of the count
    Plane<float> depth;
    Plane<std::uint16_t> coverCount; ///< overdraw only: how often the sample was covered
    Plane<float> ownDepth;           ///< rules.depthPerPixel only: the depth last written for this sample alone
    Plane<std::int32_t> owners;      ///< the face drawn last, -1 none
    SampleRuns layout;
    std::vector<Run> runs;  ///< layout.count()
    std::uint32_t turn = 0; ///< counts what is told apart by Run::turn

    const FrameHistory* history = nullptr; ///< where packed runs are; it must outlive them

    /// Unpacks a run. Call this before samples of it are read or written.
    void make(std::size_t run)
    {
        if (runs[run].isPacked)
            unpack(run);
    }
    void makeAll()
    {
        for (std::size_t run = 0; run < runs.size(); ++run)
            make(run);
    }
    /// A sample changes.
    void touch(std::uint32_t sample) { runs[layout.of(sample)] = {kNoVersion, turn}; }
    /// What a sample stores.
    ///
    /// in  planes with depth
    void put(std::uint32_t sample, const StepEffect::State& state)
    {
        color[sample] = state.pixel.color;
        depth[sample] = state.pixel.depth;
        owners[sample] = state.owner;
        touch(sample);
    }

    /// make() of a packed run; frame_history.cpp has it.
    void unpack(std::size_t run);

    /// Calls visit(plane) for each plane that is not empty.
    template <class Planes, class Visit>
    static void forEach(Planes& planes, Visit&& visit)
    {
        const auto visitOne = [&](auto& plane) {
            if (!plane.empty())
                visit(plane);
        };
        visitOne(planes.color);
        visitOne(planes.depth);
        visitOne(planes.coverCount);
        visitOne(planes.ownDepth);
        visitOne(planes.owners);
    }
};

/// How many samples a frame stores: columns * rows, times those of a pattern, but for a mistake in their addresses.
[[nodiscard]] inline std::size_t storedSamples(const Rules& rules)
{
    const int stride = rules.strideIsRows ? rules.rows() : rules.columns();
    return std::size_t(std::max(rules.columns(), stride)) * std::size_t(rules.rows()) *
           std::size_t(rules.patternSamples);
}

/// What a sample of the cleared frame shows and stores.
[[nodiscard]] Pixel clearedPixel(const Scene& scene, const Rules& rules);

/// The planes of the cleared frame.
///
/// in      `hasDepth`: whether the depth plane is wanted
/// errors  throws std::bad_alloc; where `stop` comes in between there are fewer samples, and nothing may be drawn
[[nodiscard]] FramePlanes clearedPlanes(const Rules& rules, const Pixel& clear, bool hasDepth,
                                        const std::stop_token& stop);

} // namespace rasterlens
