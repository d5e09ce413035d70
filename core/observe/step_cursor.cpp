#include "core/observe/step_cursor.h"

#include "core/pipeline/framebuffer.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace rasterlens
{
namespace
{

constexpr int kNowhere = std::numeric_limits<int>::max();

} // namespace

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
    m_touched.assign(std::size_t(m_image.height()), {kNowhere, -1});
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
    for (RowRange& row : m_touched)
        row = {0, m_image.width() - 1};
}

void StepCursor::moveTo(std::size_t position)
{
    position = std::min(position, size());
    const bool isFar = !isInLog(position);
    if (isFar)
        openWindow(position);
    const std::span<const StepEffect> effects = m_log->effects();
    const std::size_t from = m_log->effectsAt(positionInLog());
    const std::size_t to = m_log->effectsAt(inLog(position));
    for (std::size_t i = from; i < to; ++i)
        put(effects[i].sample, effects[i].after);
    for (std::size_t i = from; i > to; --i)
        put(effects[i - 1].sample, effects[i - 1].before);
    m_position = position;
    m_changed = {};
    if (from != to || isFar)
        show();
    if (isFar)
        m_resolved = 0;
    if (!finishedImage().isNull())
        resolveUpTo(m_log->resolvedPixels(positionInLog()));
}

void StepCursor::resolveUpTo(std::size_t pixels)
{
    if (pixels == m_resolved)
        return;
    const auto width = static_cast<std::size_t>(m_image.width());
    auto* const colors = reinterpret_cast<std::uint32_t*>(m_image.bits()); // rows of 32 bits follow without gaps
    const auto* const finished = reinterpret_cast<const std::uint32_t*>(finishedImage().constBits());
    for (std::size_t i = m_resolved; i < pixels; ++i)
        colors[i] = finished[i];
    for (std::size_t i = pixels; i < m_resolved; ++i)
        colors[i] = meanAt(static_cast<int>(i % width), static_cast<int>(i / width));
    m_resolved = pixels;
    m_changed = {0, 0, m_image.width(), m_image.height()};
}

std::uint32_t StepCursor::meanAt(int x, int y) const
{
    std::array<std::uint32_t, ResolvedPixel::kMostSamples> colors;
    const Rules& rules = m_log->rules();
    const int count = rules.samplesPerPixel();
    for (int i = 0; i < count; ++i)
        colors[static_cast<std::size_t>(i)] = m_planes.color[readIndex(rules, x, y, i)];
    return meanColor(std::span(colors).first(static_cast<std::size_t>(count)), rules.resolveLight);
}

void StepCursor::put(std::uint32_t sample, const StepEffect::State& state)
{
    m_planes.put(sample, state);
    const auto columns = static_cast<std::uint32_t>(m_log->columns());
    const auto grid = static_cast<std::uint32_t>(m_log->grid());
    std::uint32_t y = sample / columns / grid;
    if (m_log->rules().multiSampled())
        y %= static_cast<std::uint32_t>(m_touched.size());
    if (y >= m_touched.size())
        return;
    const int x = static_cast<int>(sample % columns / grid);
    RowRange& row = m_touched[y];
    row.left = std::min(row.left, x);
    row.right = std::max(row.right, x);
}

void StepCursor::show()
{
    int left = kNowhere;
    int right = -1;
    int top = kNowhere;
    int bottom = -1;
    uchar* const bits = m_image.bits();
    for (int y = 0; y < m_image.height(); ++y) {
        RowRange& row = m_touched[std::size_t(y)];
        if (row.left > row.right)
            continue;
        auto* line = reinterpret_cast<std::uint32_t*>(bits + y * m_image.bytesPerLine());
        const std::uint32_t* samples = m_planes.color.data();
        const auto columns = std::size_t(m_log->columns());
        if (m_log->samplesPerPixel() == 1)
            std::copy_n(samples + std::size_t(y) * columns + std::size_t(row.left), row.right - row.left + 1,
                        line + row.left);
        else
            for (int x = row.left; x <= row.right; ++x)
                line[x] = meanAt(x, y);
        left = std::min(left, row.left);
        right = std::max(right, row.right);
        top = std::min(top, y);
        bottom = y;
        row = {kNowhere, -1};
    }
    m_changed = {left, top, right - left + 1, bottom - top + 1};
}

} // namespace rasterlens
