#include "core/observe/step_cursor.h"

#include "core/pipeline/framebuffer.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <type_traits>
#include <utility>

namespace rasterlens
{

namespace
{

using PixelSamples = std::array<const std::uint32_t*, ResolvedPixel::kMostSamples>;

/// The means of pixels that follow each other, each of whose samples lies `next` behind that of the one before. Most
/// pixels are of one colour, which is their mean. Numbers that the compiler knows make it twice as fast.
template <class Count, class Next>
void writeLine(const PixelSamples& samples, std::size_t pixels, ResolveLight light, std::uint32_t* line, Count count,
               Next next)
{
    std::array<std::uint32_t, ResolvedPixel::kMostSamples> colors;
    for (std::size_t x = 0; x < pixels; ++x) {
        std::uint32_t differing = 0;
        for (std::size_t i = 0; i < count; ++i) {
            colors[i] = samples[i][x * next];
            differing |= colors[i] ^ colors[0];
        }
        line[x] = differing == 0 ? 0xff000000U | colors[0] : meanColor(std::span(colors).first(count), light);
    }
}

/// The pixels of a picture of 32 bits a pixel; its rows follow each other without gaps.
QRgb* colorsOf(QImage& image) { return reinterpret_cast<QRgb*>(image.bits()); }

template <std::size_t kValue>
using Known = std::integral_constant<std::size_t, kValue>;

} // namespace

StepCursor::StepCursor(std::shared_ptr<const StepLog> log) : m_log(std::move(log))
{
    clearPicture();
    clearPlanes();
}

StepCursor::StepCursor(std::shared_ptr<const StepRecord> record)
    : m_record(std::move(record)), m_log(m_record->emptyWindow())
{
    clearPicture();
    m_planes.turn = 1;
    if (size() == 0) {
        clearPlanes();
        return;
    }
    openWindow(0); // the record makes the planes
    moveTo(0);
}

void StepCursor::clearPicture()
{
    const int grid = m_log->grid();
    m_image = QImage(m_log->columns() / grid, m_log->rows() / grid, QImage::Format_RGB32);
    m_image.fill(m_log->clear().color);
}

void StepCursor::clearPlanes()
{
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
    QRgb* const colors = colorsOf(m_image);
    const auto* const finished = reinterpret_cast<const std::uint32_t*>(finishedImage().constBits());
    for (std::size_t i = m_resolved; i < pixels; ++i)
        colors[i] = finished[i];
    for (std::size_t first = pixels; first < m_resolved;) {
        const std::size_t y = first / width;
        const std::size_t end = std::min(m_resolved, (y + 1) * width);
        const RowRange pixels{static_cast<int>(first - y * width), static_cast<int>(end - 1 - y * width)};
        writeMeans(static_cast<int>(y), pixels, colors + y * width);
        first = end;
    }
    m_resolved = pixels;
}

void StepCursor::writeMeans(int y, RowRange range, QRgb* line) const
{
    const SampleRuns& layout = m_planes.layout;
    if (!layout.hasPixels) {
        writeMadeMeans(y, range, line);
        return;
    }
    const std::size_t row = std::size_t(y) * std::size_t(m_image.width());
    const auto isPackedAt = [&](int x) { return m_planes.runs[layout.of(row + std::size_t(x))].isPacked; };
    for (int x = range.left; x <= range.right;) {
        const int left = x;
        const bool isPacked = isPackedAt(x);
        while (x <= range.right && isPackedAt(x) == isPacked) { // run by run
            const std::size_t run = layout.of(row + std::size_t(x));
            const auto end = static_cast<int>(layout.first(run) + layout.length(run) - row);
            const RowRange part{x, std::min(end - 1, range.right)};
            if (isPacked)
                writePackedMeans(run, part, static_cast<int>(row + std::size_t(x) - layout.first(run)), line);
            x = part.right + 1;
        }
        if (!isPacked)
            writeMadeMeans(y, {left, x - 1}, line);
    }
}

void StepCursor::writePackedMeans(std::size_t run, RowRange range, int place, QRgb* line) const
{
    const SampleRuns& layout = m_planes.layout;
    std::array<std::uint32_t, SampleRuns::kMostSamples> colors;
    const auto pixels = std::size_t(range.right - range.left + 1);
    if (m_planes.history->takePixelColors(m_planes, run, std::span(colors).first(layout.length(run)))) {
        for (std::size_t i = 0; i < pixels; ++i)
            line[std::size_t(range.left) + i] = 0xff000000U | colors[std::size_t(place) + i];
        return;
    }
    m_planes.history->takeColors(m_planes, run, std::span(colors).first(layout.length(run) * layout.frames));
    PixelSamples samples; // of the first pixel
    for (std::size_t i = 0; i < layout.frames; ++i)
        samples[i] = colors.data() + std::size_t(place) * layout.frames + i;
    const auto write = [&](auto frames) {
        writeLine(samples, pixels, m_log->rules().resolveLight, line + range.left, frames, frames);
    };
    if (layout.frames == 4)
        write(Known<4>());
    else if (layout.frames == 8)
        write(Known<8>());
    else
        write(layout.frames);
}

void StepCursor::writeMadeMeans(int y, RowRange range, QRgb* line) const
{
    const Rules& rules = m_log->rules();
    const auto count = static_cast<std::size_t>(rules.samplesPerPixel());
    std::array<const std::uint32_t*, ResolvedPixel::kMostSamples> samples; // of the first pixel
    for (std::size_t i = 0; i < count; ++i)
        samples[i] = m_planes.color.data() + readIndex(rules, range.left, y, static_cast<int>(i));
    const auto next = static_cast<std::size_t>(
        rules.multiSampled() ? 1 : rules.sampleGrid); // from a pixel's sample to that of the next pixel
    const auto pixels = static_cast<std::size_t>(range.right - range.left + 1);
    line += range.left;
    if (count == 4 && next == 2)
        writeLine(samples, pixels, rules.resolveLight, line, Known<4>(), Known<2>());
    else if (count == 4 && next == 1)
        writeLine(samples, pixels, rules.resolveLight, line, Known<4>(), Known<1>());
    else if (count == 8 && next == 1)
        writeLine(samples, pixels, rules.resolveLight, line, Known<8>(), Known<1>());
    else
        writeLine(samples, pixels, rules.resolveLight, line, count, next);
}

std::vector<StepCursor::RowRange> StepCursor::changedSince(std::uint32_t turn) const
{
    std::vector<RowRange> rows(std::size_t(m_image.height()), {std::numeric_limits<int>::max(), -1});
    const auto columns = static_cast<std::size_t>(m_log->columns());
    const auto grid = static_cast<std::size_t>(m_log->grid());
    const auto height = static_cast<std::size_t>(m_log->rows()); // of the frame of one sample of a pattern
    const auto frames = static_cast<std::size_t>(m_log->rules().patternSamples);
    const std::size_t read = columns * height * frames; // others are stored, but not read
    const SampleRuns& layout = m_planes.layout;
    // But for a mistake in addresses a run lies at the same pixels of every frame.
    const std::size_t pieces = layout.frame == columns * height ? 1 : layout.frames;
    for (std::size_t run = 0; run < m_planes.runs.size(); ++run) {
        if (m_planes.runs[run].turn <= turn)
            continue;
        for (std::size_t frame = 0; frame < pieces; ++frame) {
            const std::size_t begin = frame * layout.frame + layout.first(run);
            const std::size_t last = std::min(begin + layout.length(run), read);
            for (std::size_t first = begin; first < last;) {
                const std::size_t line = first / columns;
                const std::size_t end = std::min(last, (line + 1) * columns);
                RowRange& row = rows[line % height / grid];
                row.left = std::min(row.left, static_cast<int>((first - line * columns) / grid));
                row.right = std::max(row.right, static_cast<int>((end - 1 - line * columns) / grid));
                first = end;
            }
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
    QRgb* const colors = colorsOf(m_image);
    forEachRow(changedSince(m_planes.turn - 1), [&](int y, RowRange pixels) {
        QRgb* const line = colors + std::size_t(y) * std::size_t(m_image.width());
        if (m_log->samplesPerPixel() > 1) {
            writeMeans(y, pixels, line);
            return;
        }
        const std::uint32_t* const row = m_planes.color.data() + std::size_t(y) * std::size_t(m_log->columns());
        std::copy(row + pixels.left, row + pixels.right + 1, line + pixels.left);
    });
}

} // namespace rasterlens
