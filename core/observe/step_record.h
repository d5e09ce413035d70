#pragma once
#include "core/observe/frame_planes.h"
#include "core/observe/step_index.h"
#include "core/observe/step_log.h"

#include <QImage>

#include <memory>
#include <optional>
#include <span>

namespace rasterlens
{

/// The record of a whole frame, of any number of events. It holds where everything is, and makes the events themselves
/// anew, by drawing the frame on from a moment that it has kept: frames are drawn the same way every time. Positions
/// are those of a StepLog. Immutable; shared between threads.
class StepRecord
{
public:
    virtual ~StepRecord() = default;

    [[nodiscard]] std::size_t size() const { return m_index.size(); }
    /// More events than were asked for, or than positions can be counted: the record ends there.
    [[nodiscard]] bool truncated() const { return m_truncated; }
    /// The drawing was stopped from outside.
    [[nodiscard]] bool stopped() const { return m_stopped; }
    [[nodiscard]] const PipCounts& pips() const { return m_index.pips(); }
    [[nodiscard]] const StepIndex& index() const { return m_index; }

    /// The position one step further (or back), as StepLog::step().
    ///
    /// in  no level that is finer than rows, but for events
    [[nodiscard]] std::size_t step(std::size_t position, StepLevel level, StepDirection direction) const;

    /// Makes events anew: those from position `first` on, as many as `count` if there are so many and the samples they
    /// change are not too many; at least one.
    ///
    /// in      first < size()
    /// out     a window; the planes are those at its end, in which runs of a pattern may be packed
    /// cost    of 32,768 events some milliseconds; of the samples drawn since the last moment that was kept, and of the
    ///         planes, a copy
    /// errors  throws std::bad_alloc
    [[nodiscard]] virtual std::shared_ptr<const StepLog> window(std::size_t first, std::size_t count,
                                                                FramePlanes& planes) const = 0;
    /// Makes the coverage of one triangle anew, without what becomes of its samples.
    ///
    /// in   a triangle of a window; pixels
    /// out  its set-up, and the samples, spans and columns in these pixels; nothing but End if there are none
    [[nodiscard]] virtual std::shared_ptr<const StepLog> coverage(const ScreenTriangle& triangle,
                                                                  const PixelRect& pixels) const = 0;
    /// A window without events, at position 0: it has what holds for all of the record, as rules and filter.
    [[nodiscard]] const std::shared_ptr<const StepLog>& emptyWindow() const { return m_emptyWindow; }

    /// The finished picture where a mistake makes it something else than the mean of the samples; else null.
    [[nodiscard]] const QImage& finishedImage() const { return m_finished; }

protected:
    StepRecord(const FramePlanes& cleared, const RecordMemory& memory) : m_index(cleared, memory) {}

    StepIndex m_index;
    std::shared_ptr<const StepLog> m_emptyWindow;
    QImage m_finished;
    bool m_truncated = false;
    bool m_stopped = false;
};

/// Looks for events in a record, with planes of its own.
class StepFinder
{
public:
    explicit StepFinder(std::shared_ptr<const StepRecord> record) : m_record(std::move(record)) {}

    /// "Run until": the number of the next event at or after `from` (or the last one before it) that stops the run.
    ///
    /// cost  of a window for each run of 4096 events in which there may be one
    [[nodiscard]] std::optional<std::size_t> findStop(std::size_t from, StepDirection direction, const StepStop& stop);
    /// The first event of a face at a pixel (x, y in pixels), or of the face at all if it has none there.
    [[nodiscard]] std::optional<std::size_t> firstEventOf(std::uint32_t face, int x, int y);
    /// StepRecord::step() of any level.
    [[nodiscard]] std::size_t step(std::size_t position, StepLevel level, StepDirection direction);
    /// An event of the record.
    ///
    /// in  event < size()
    [[nodiscard]] StepEvent event(std::size_t event);
    /// A window that holds an event and those about it.
    [[nodiscard]] std::shared_ptr<const StepLog> windowAt(std::size_t event);

private:
    [[nodiscard]] bool holds(std::size_t event) const;
    /// The next (or last) such event of [from, until) or [until, from).
    [[nodiscard]] std::optional<std::size_t> findBetween(std::size_t from, std::size_t until, const StepStop& stop);
    [[nodiscard]] std::optional<std::size_t> findWithin(StepIndex::Range range, StepDirection direction,
                                                        const StepStop& stop);

    std::shared_ptr<const StepRecord> m_record;
    FramePlanes m_planes;
    std::shared_ptr<const StepLog> m_window;
};

} // namespace rasterlens
