#pragma once
#include "core/observe/frame_history.h"
#include "core/observe/step_pips.h"

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace rasterlens
{

/// What a record may keep, and how much it makes anew at a time.
struct RecordMemory {
    std::uint64_t workBetween = 1 << 13;             ///< samples and faces between resume points, if there is room
    std::size_t history = std::size_t(72) << 20;     ///< bytes of the frames at resume points
    std::size_t windowEvents = std::size_t(1) << 13; ///< events of a window
};

/// A moment from which a frame can be drawn on: before a face, between two samples of a triangle, or, once all faces
/// are drawn, before a pixel is made of its samples.
struct ResumePoint {
    std::size_t position = 0; ///< events stored before it
    std::size_t face = 0;     ///< how many faces were drawn before it
    std::size_t triangle = 0; ///< of that face: how many were drawn before it
    /// How often the algorithm had called for the triangle (CountedStage): 0 stands for the moment before the face.
    std::uint64_t calls = 0;
    /// The row or column of samples at which the algorithm was (skipsLine()), or which sample of a pattern it covered
    /// the triangle for, and `calls` at its beginning.
    int line = std::numeric_limits<int>::min();
    std::uint64_t callsBeforeLine = 0;
    bool resolves = false; ///< all faces are drawn, and so many pixels as `calls` are made
    Statistics statistics;

    [[nodiscard]] bool isWithinFace() const { return calls > 0 && !resolves; }
};

/// What is kept of all events of a frame in order to find one of them and to make it anew: where rows, stages and faces
/// begin, what kinds of events there are along the way, and moments from which to draw on.
class StepIndex
{
public:
    /// in  the planes of the cleared frame
    StepIndex(const FramePlanes& cleared, const RecordMemory& memory);

    /// The next event.
    void add(const StepEvent& event);
    /// A sample has changed.
    void touch(std::uint32_t sample) { m_history.touch(sample); }
    /// The fragment that was counted as the n-th was the second hit of its sample at an edge (Statistics).
    void addDoubleHit(std::uint64_t nth) { m_doubleHits.push_back(nth); }
    /// Whether the work since the last resume point asks for another.
    ///
    /// in  work: samples and faces so far
    [[nodiscard]] bool wantsPoint(std::uint64_t work) const { return work - m_workOfLastPoint >= m_workBetween; }
    /// Keeps a resume point. Where there are too many for the memory, every second one is forgotten, down to two.
    void addPoint(const ResumePoint& point, std::uint64_t work, const FramePlanes& planes);

    /// All events and points are there.
    void seal();

    [[nodiscard]] const RecordMemory& memory() const { return m_memory; }
    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] const PipCounts& pips() const { return m_pips; }
    [[nodiscard]] std::span<const std::uint64_t> doubleHits() const { return m_doubleHits; }
    /// The last resume point that has a stored event between it and this position, or the first one. Its number is that
    /// of the moment in history().
    [[nodiscard]] std::size_t pointBefore(std::size_t position) const;
    [[nodiscard]] const ResumePoint& point(std::size_t number) const { return m_points[number]; }
    [[nodiscard]] const FrameHistory& history() const { return m_history; }

    /// StepRecord::step() for rows, faces and stages.
    [[nodiscard]] std::size_t step(std::size_t position, StepLevel level, StepDirection direction) const;
    /// The events of a face, [first, last); nothing where it has none.
    struct Range {
        std::size_t first;
        std::size_t last;
    };
    [[nodiscard]] std::optional<Range> eventsOf(std::uint32_t face) const;
    /// The next run of events, from the one that holds `from` on (or back), in which there may be an event that stops a
    /// run.
    [[nodiscard]] std::optional<Range> stretchWith(const StepStop& stop, std::size_t from, StepDirection direction,
                                                   int grid) const;
    /// The memory of everything.
    [[nodiscard]] std::size_t bytes() const;

    static constexpr std::size_t kMostPositions = 4'000'000'000; ///< they are counted in 32 bits
    static constexpr std::size_t kStretch = 4096;                ///< events that stretchWith() looks at as one

private:
    /// What there is in kStretch events.
    struct Stretch {
        std::uint32_t stops = 0;                                      ///< one bit a StepStop::Kind
        std::int32_t left = std::numeric_limits<std::int32_t>::max(); ///< samples
        std::int32_t top = std::numeric_limits<std::int32_t>::max();
        std::int32_t right = -1;
        std::int32_t bottom = -1;
    };

    [[nodiscard]] const std::vector<std::uint32_t>& boundaries(StepLevel level) const;

    RecordMemory m_memory;
    std::size_t m_size = 0;
    StepEvent m_last;
    std::vector<std::uint32_t> m_rows;   ///< positions between two rows, also those of the next two
    std::vector<std::uint32_t> m_stages; ///< positions between two stages, also those between faces
    std::vector<std::uint32_t> m_faces;  ///< positions at which a face begins, from 0 on
    std::vector<std::uint32_t> m_faceOf; ///< which face begins there
    std::vector<Stretch> m_stretches;
    PipCounts m_pips;
    std::vector<std::uint64_t> m_doubleHits;
    std::vector<ResumePoint> m_points;
    std::uint64_t m_workOfLastPoint = 0;
    std::uint64_t m_workBetween;
    FrameHistory m_history;
};

} // namespace rasterlens
