#include "core/observe/step_record.h"

#include <algorithm>

namespace rasterlens
{

std::size_t StepRecord::step(std::size_t position, StepLevel level, StepDirection direction) const
{
    position = std::min(position, size());
    if (level != StepLevel::Event)
        return m_index.step(position, level, direction);
    if (direction == StepDirection::Forward)
        return std::min(position + 1, size());
    return position - std::min<std::size_t>(position, 1);
}

bool StepFinder::holds(std::size_t event) const
{
    return m_window && m_window->first() <= event && event < m_window->last();
}

std::shared_ptr<const StepLog> StepFinder::windowAt(std::size_t event)
{
    if (holds(event))
        return m_window;
    m_window.reset();
    const std::size_t count = m_record->index().memory().windowEvents;
    const std::size_t before = std::min(event, count / 2);
    m_window = m_record->window(event - before, count, m_planes);
    if (event >= m_window->last())
        m_window = m_record->window(event, count, m_planes);
    return m_window;
}

StepEvent StepFinder::event(std::size_t event)
{
    const auto log = windowAt(event);
    return log->event(event - log->first() + log->lead());
}

std::size_t StepFinder::step(std::size_t position, StepLevel level, StepDirection direction)
{
    if (level != StepLevel::Sample)
        return m_record->step(position, level, direction);
    std::size_t p = m_record->step(position, StepLevel::Event, direction);
    while (p > 0 && p < m_record->size() && !isStepBoundary(event(p - 1), event(p), level))
        p = m_record->step(p, StepLevel::Event, direction);
    return p;
}

std::optional<std::size_t> StepFinder::findWithin(StepIndex::Range range, StepDirection direction, const StepStop& stop)
{
    const bool forward = direction == StepDirection::Forward;
    while (range.first < range.last) {
        const std::size_t wanted = forward ? range.first : range.last - 1;
        if (!holds(wanted)) // no more than what is searched
            m_window = m_record->window(range.first, range.last - range.first, m_planes);
        const auto log = windowAt(wanted);
        const std::size_t first = std::max(range.first, log->first());
        const std::size_t last = std::min(range.last, log->last());
        for (std::size_t k = 0; k < last - first; ++k) {
            const std::size_t at = forward ? first + k : last - 1 - k;
            if (stopsAt(event(at), stop, log->grid()))
                return at;
        }
        (forward ? range.first : range.last) = forward ? last : first;
    }
    return std::nullopt;
}

std::optional<std::size_t> StepFinder::findBetween(std::size_t from, std::size_t until, const StepStop& stop)
{
    const StepDirection direction = from <= until ? StepDirection::Forward : StepDirection::Backward;
    const bool forward = direction == StepDirection::Forward;
    const int grid = m_record->emptyWindow()->grid();
    while (from != until) {
        const auto stretch = m_record->index().stretchWith(stop, from, direction, grid);
        if (!stretch || (forward ? stretch->first >= until : stretch->last <= until))
            return std::nullopt;
        const StepIndex::Range range{std::max(stretch->first, std::min(from, until)),
                                     std::min(stretch->last, std::max(from, until))};
        if (const auto at = findWithin(range, direction, stop))
            return at;
        from = forward ? range.last : range.first;
    }
    return std::nullopt;
}

std::optional<std::size_t> StepFinder::findStop(std::size_t from, StepDirection direction, const StepStop& stop)
{
    const bool forward = direction == StepDirection::Forward;
    return findBetween(std::min(from, m_record->size()), forward ? m_record->size() : 0, stop);
}

std::optional<std::size_t> StepFinder::firstEventOf(std::uint32_t face, int x, int y)
{
    const auto all = m_record->index().eventsOf(face);
    if (!all)
        return std::nullopt;
    const auto at = findBetween(all->first, all->last, {StepStop::Kind::Pixel, x, y});
    return at ? at : all->first;
}

} // namespace rasterlens
