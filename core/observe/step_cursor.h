#pragma once
#include "core/base/in_parallel.h"
#include "core/observe/step_record.h"

#include <QImage>

#include <algorithm>
#include <iterator>
#include <memory>
#include <vector>

namespace rasterlens
{

/// The frame at one position of a step log or a step record: pixels, depth and counters.
///
/// cost   a move takes time in proportion to the pixel effects between the two positions: a million in some
///        milliseconds, forth or back. The cursor of a record holds a window of it; a move out of the window takes as
///        long as StepRecord::window()
/// exact  after any moves, what a run that ends there would have left
class StepCursor
{
public:
    /// At position 0: the cleared frame.
    explicit StepCursor(std::shared_ptr<const StepLog> log);
    explicit StepCursor(std::shared_ptr<const StepRecord> record);

    /// in      0..size(); more is held to the end
    /// errors  throws std::bad_alloc
    void moveTo(std::size_t position);

    /// The log; of a record, the window about the position.
    [[nodiscard]] const StepLog& log() const { return *m_log; }
    [[nodiscard]] const std::shared_ptr<const StepLog>& sharedLog() const { return m_log; }
    [[nodiscard]] std::size_t size() const { return m_record ? m_record->size() : m_log->size(); }
    [[nodiscard]] std::size_t position() const { return m_position; }
    /// How many events of log() have happened: the position, counted there.
    [[nodiscard]] std::size_t positionInLog() const { return inLog(m_position); }
    /// The event that happened last; nothing at position 0.
    [[nodiscard]] const StepEvent* lastEvent() const
    {
        return m_position == 0 ? nullptr : &m_log->event(positionInLog() - 1);
    }

    /// Pixels, Format_RGB32: with several samples their mean. Where a mistake makes the picture something else than the
    /// mean, a pixel is that from its step Resolve on.
    [[nodiscard]] const QImage& image() const { return m_image; }
    /// Pixels [left, right] of a row; left > right: none.
    struct RowRange {
        int left;
        int right;
    };
    /// Counts the moves that have changed samples or pixels.
    [[nodiscard]] std::uint32_t turn() const { return m_planes.turn; }
    /// Where image(), and what its samples store, may have changed since it was `turn`; of each row of pixels. Since 0
    /// all of them have.
    [[nodiscard]] std::vector<RowRange> changedSince(std::uint32_t turn) const;
    /// Calls body(y, pixels) for each row that has any, in several threads where there are many.
    template <class Body>
    static void forEachRow(const std::vector<RowRange>& rows, Body&& body)
    {
        constexpr std::size_t kRowsOfThread = 64; // at least
        const auto hasAny = [](const RowRange& row) { return row.left <= row.right; };
        const auto top = std::ranges::find_if(rows, hasAny);
        const auto bottom = std::find_if(rows.rbegin(), std::make_reverse_iterator(top), hasAny).base();
        const auto part = [&](std::size_t first, std::size_t last) {
            for (auto row = top + std::ptrdiff_t(first); row != top + std::ptrdiff_t(last); ++row)
                if (hasAny(*row))
                    body(static_cast<int>(row - rows.begin()), *row);
        };
        inParallel(static_cast<std::size_t>(bottom - top), kRowsOfThread, part);
    }
    /// All samples, row by row. Packed samples are made now, which takes some tens of milliseconds.
    [[nodiscard]] const FramePlanes& samples() const
    {
        m_planes.makeAll();
        return m_planes;
    }
    /// 0xffRRGGBB of each sample, row by row; see samples().
    [[nodiscard]] std::span<const std::uint32_t> sampleColors() const { return samples().color; }
    /// Depth of each sample, row by row; see samples().
    [[nodiscard]] std::span<const float> sampleDepths() const { return samples().depth; }
    /// The face drawn last at each sample, row by row, -1 none; see samples().
    [[nodiscard]] std::span<const std::int32_t> sampleOwners() const { return samples().owners; }
    /// The samples of which one, with a pattern the first, stands for a pixel: those of the others may not be there.
    [[nodiscard]] const FramePlanes& firstSamples() const { return m_planes; }
    /// The colour and depth of a sample, by its place in the planes.
    [[nodiscard]] Pixel sample(std::size_t at) const
    {
        m_planes.make(m_planes.layout.of(at));
        return {m_planes.color[at], m_planes.depth[at]};
    }
    [[nodiscard]] Statistics counters() const { return m_log->countersAt(positionInLog()); }

private:
    /// Writes pixels of a row, the means of their samples.
    ///
    /// in  line  the row in the picture
    void writeMeans(int y, RowRange range, QRgb* line) const;
    /// writeMeans() of pixels whose samples the planes have.
    void writeMadeMeans(int y, RowRange range, QRgb* line) const;
    /// writeMeans() of pixels in a packed run, of which the first is the run's pixel number `place`.
    void writePackedMeans(std::size_t run, RowRange range, int place, QRgb* line) const;
    /// Gives pixels the colours of the finished picture, or takes them away.
    void resolveUpTo(std::size_t pixels);
    [[nodiscard]] const QImage& finishedImage() const
    {
        return m_record ? m_record->finishedImage() : m_log->finishedImage();
    }
    [[nodiscard]] std::size_t inLog(std::size_t position) const { return position - m_log->first() + m_log->lead(); }
    /// The log holds the event before the position.
    [[nodiscard]] bool isInLog(std::size_t position) const;
    void openWindow(std::size_t position);
    void clearPicture();
    /// Makes the planes of the cleared frame without a record.
    void clearPlanes();
    /// All pixels are to be made anew.
    void touchAll();
    /// Makes pixels of the samples that this move has changed.
    void show();

    std::shared_ptr<const StepRecord> m_record; ///< null: the log is all there is
    std::shared_ptr<const StepLog> m_log;
    std::size_t m_position = 0;
    QImage m_image;
    mutable FramePlanes m_planes; ///< packed runs are made when they are asked for
    std::size_t m_resolved = 0;   ///< pixels, row by row, that have the colours of the finished picture
};

} // namespace rasterlens
