#include "core/observe/step_cursor.h"

#include "core/pipeline/framebuffer.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <utility>

namespace rasterlens
{

StepCursor::StepCursor(std::shared_ptr<const StepLog> log) : m_log(std::move(log)) { clear(); }

StepCursor::StepCursor(std::shared_ptr<const StepRecord> record)
    : m_record(std::move(record)), m_log(m_record->emptyWindow())
{
    clear();
    if (size() == 0)
        return;
    openWindow(0);
    moveTo(0);
}

void StepCursor::clear()
{
    const int grid = m_log->grid();
    m_image = QImage(m_log->columns() / grid, m_log->rows() / grid, QImage::Format_RGB32);
    m_image.fill(m_log->clear().color);
    m_planes = clearedPlanes(m_log->rules(), m_log->clear(), true, {});
    m_planes.turn = 1;
    touchAll();
}

bool StepCursor::isInLog(std::size_t position) const
{
    return !m_record || (position > m_log->first() && position <= m_log->last()) ||
           (position == 0 && m_log->first() == 0);
}

/// Makes the log a window that holds the position, with about as much on either side of it. The samples are then those
/// at its end.
void StepCursor::openWindow(std::size_t position)
{
    const std::size_t last = position == 0 ? 0 : position - 1; // the event that must be there
    const std::size_t count = m_record->index().memory().windowEvents;
    const std::size_t before = std::min(last, count / 2);
    m_log = m_record->window(last - before, count, m_planes);
    if (!isInLog(position))
        m_log = m_record->window(last, count, m_planes);
    m_position = m_log->last();
}

void StepCursor::moveTo(std::size_t position)
{
    position = std::min(position, size());
    ++m_planes.turn;
    const bool isFar = !isInLog(position);
    if (isFar)
        openWindow(position);
    const std::span<const StepEffect> effects = m_log->effects();
    const std::size_t from = m_log->effectsAt(positionInLog());
    const std::size_t to = m_log->effectsAt(inLog(position));
    for (std::size_t i = from; i < to; ++i)
        m_planes.put(effects[i].sample, effects[i].after);
    for (std::size_t i = from; i > to; --i)
        m_planes.put(effects[i - 1].sample, effects[i - 1].before);
    m_position = position;
    if (isFar && std::exchange(m_resolved, 0) > 0)
        touchAll();
    if (from != to || isFar)
        show();
    if (!finishedImage().isNull())
        resolveUpTo(m_log->resolvedPixels(positionInLog()));
}

void StepCursor::resolveUpTo(std::size_t pixels)
{
    if (pixels == m_resolved)
        return;
    touchAll();
    const auto width = static_cast<std::size_t>(m_image.width());
    auto* const colors = reinterpret_cast<std::uint32_t*>(m_image.bits()); // rows of 32 bits follow without gaps
    const auto* const finished = reinterpret_cast<const std::uint32_t*>(finishedImage().constBits());
    for (std::size_t i = m_resolved; i < pixels; ++i)
        colors[i] = finished[i];
    for (std::size_t i = pixels; i < m_resolved; ++i)
        colors[i] = meanAt(static_cast<int>(i % width), static_cast<int>(i / width));
    m_resolved = pixels;
}

std::uint32_t StepCursor::meanAt(int x, int y) const
{
    std::array<std::uint32_t, ResolvedPixel::kMostSamples> colors{};
    const Rules& rules = m_log->rules();
    const int count = rules.samplesPerPixel();
    for (int i = 0; i < count; ++i)
        colors[static_cast<std::size_t>(i)] = m_planes.color[readIndex(rules, x, y, i)];
    const auto samples = std::span(colors).first(static_cast<std::size_t>(count));
    const bool isOneColor = std::ranges::count(samples, samples.front()) == count; // as of most pixels: their mean
    return isOneColor ? 0xff000000U | samples.front() : meanColor(samples, rules.resolveLight);
}

std::vector<StepCursor::RowRange> StepCursor::changedSince(std::uint32_t turn) const
{
    std::vector<RowRange> rows(std::size_t(m_image.height()), {std::numeric_limits<int>::max(), -1});
    const auto columns = static_cast<std::size_t>(m_log->columns());
    const auto grid = static_cast<std::size_t>(m_log->grid());
    const auto height = static_cast<std::size_t>(m_log->rows()); // of the frame of one sample of a pattern
    const auto frames = static_cast<std::size_t>(m_log->rules().patternSamples);
    const std::size_t read = columns * height * frames; // others are stored, but not read
    for (std::size_t run = 0; run < m_planes.runs.size(); ++run) {
        if (m_planes.runs[run].turn <= turn)
            continue;
        const std::size_t last = std::min((run + 1) * FramePlanes::kRun, read);
        for (std::size_t first = run * FramePlanes::kRun; first < last;) {
            const std::size_t line = first / columns;
            const std::size_t end = std::min(last, (line + 1) * columns);
            RowRange& row = rows[line % height / grid];
            row.left = std::min(row.left, static_cast<int>((first - line * columns) / grid));
            row.right = std::max(row.right, static_cast<int>((end - 1 - line * columns) / grid));
            first = end;
        }
    }
    return rows;
}

void StepCursor::touchAll()
{
    for (FramePlanes::Run& run : m_planes.runs)
        run.turn = m_planes.turn;
}

void StepCursor::show()
{
    const std::vector<RowRange> rows = changedSince(m_planes.turn - 1);
    const auto columns = static_cast<std::size_t>(m_log->columns());
    uchar* const bits = m_image.bits();
    for (int y = 0; y < m_image.height(); ++y) {
        const auto [left, right] = rows[std::size_t(y)];
        auto* line = reinterpret_cast<std::uint32_t*>(bits + y * m_image.bytesPerLine());
        if (m_log->samplesPerPixel() == 1 && left <= right)
            std::copy_n(m_planes.color.data() + std::size_t(y) * columns + std::size_t(left), right - left + 1,
                        line + left);
        for (int x = left; m_log->samplesPerPixel() > 1 && x <= right; ++x)
            line[x] = meanAt(x, y);
    }
}

} // namespace rasterlens
