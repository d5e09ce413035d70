#pragma once
#include "core/observe/step_log.h"

#include <QImage>

#include <memory>
#include <vector>

namespace rasterlens
{

/// The frame at one position of a step log: pixels, depth and counters.
///
/// cost   a move takes time in proportion to the pixel effects between the two positions: a million in some
///        milliseconds, forth or back
/// exact  after any moves, what a run that ends there would have left
class StepCursor
{
public:
    /// At position 0: the cleared frame.
    explicit StepCursor(std::shared_ptr<const StepLog> log);

    /// in  0..log size; more is held to the end
    void moveTo(std::size_t position);

    [[nodiscard]] const StepLog& log() const { return *m_log; }
    [[nodiscard]] std::size_t position() const { return m_position; }
    /// The event that happened last; nothing at position 0.
    [[nodiscard]] const StepEvent* lastEvent() const
    {
        return m_position == 0 ? nullptr : &m_log->event(m_position - 1);
    }

    /// Pixels, Format_RGB32: with several samples their mean. Where a mistake makes the picture something else than the
    /// mean, a pixel is that from its step Resolve on.
    [[nodiscard]] const QImage& image() const { return m_image; }
    /// The pixels that the last moveTo changed lie within; empty: none.
    [[nodiscard]] PixelRect changedPixels() const { return m_changed; }
    /// 0xffRRGGBB of each sample, row by row.
    [[nodiscard]] std::span<const std::uint32_t> sampleColors() const { return m_color; }
    /// Depth of each sample, row by row.
    [[nodiscard]] std::span<const float> sampleDepths() const { return m_depth; }
    [[nodiscard]] Statistics counters() const { return m_log->countersAt(m_position); }

private:
    /// Pixels [left, right] of a row; left > right: none.
    struct RowRange {
        int left;
        int right;
    };

    [[nodiscard]] std::uint32_t meanAt(int x, int y) const;
    /// Gives pixels the colours of the finished picture, or takes them away.
    void resolveUpTo(std::size_t pixels);
    void put(std::uint32_t sample, const Pixel& pixel);
    /// Makes pixels of the samples that were put.
    void show();

    std::shared_ptr<const StepLog> m_log;
    std::size_t m_position = 0;
    QImage m_image;
    std::vector<std::uint32_t> m_color;
    std::vector<float> m_depth;
    std::vector<RowRange> m_touched; ///< of each row of pixels
    std::size_t m_resolved = 0;      ///< pixels, row by row, that have the colours of the finished picture
    PixelRect m_changed;
};

} // namespace rasterlens
