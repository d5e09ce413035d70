#include "core/lessons/step_place.h"

#include "core/base/typed_numbers.h"

#include <QStringList>

#include <algorithm>
#include <array>
#include <vector>

namespace rasterlens
{
namespace
{

struct StopName {
    StepStop::Kind stop;
    const char* id;
};

constexpr std::array kStops{
    StopName{StepStop::Kind::Tie, "tie"},
    StopName{StepStop::Kind::SignChange, "sign-change"},
    StopName{StepStop::Kind::DepthFail, "depth-fail"},
    StopName{StepStop::Kind::Clip, "clip"},
    StopName{StepStop::Kind::NonFinite, "nan"},
};

std::optional<StepKind> kindNamed(const QString& id)
{
    for (int kind = 0; kind < kStepKinds; ++kind)
        if (id == QLatin1String(stepKindId(static_cast<StepKind>(kind))))
            return static_cast<StepKind>(kind);
    return std::nullopt;
}

std::optional<std::size_t> wholeNumber(const QString& word)
{
    bool isNumber = false;
    const qulonglong number = word.toULongLong(&isNumber);
    return isNumber ? std::optional(static_cast<std::size_t>(number)) : std::nullopt;
}

/// Reads the words of a place from left to right.
class PlaceReader
{
public:
    explicit PlaceReader(const QString& text) : m_words(text.simplified().split(QLatin1Char(' '), Qt::SkipEmptyParts))
    {
    }

    std::optional<StepPlace> read()
    {
        if (m_words.isEmpty() || !face())
            return std::nullopt;
        kindOrStop();
        if (m_next < m_words.size() && m_words[m_next].contains(QLatin1Char(','))) {
            m_place.pixel = typedPoint(m_words[m_next++]);
            if (!m_place.pixel)
                return std::nullopt;
        }
        if (!ordinal() || m_next != m_words.size())
            return std::nullopt;
        return m_place;
    }

private:
    QStringList m_words;
    qsizetype m_next = 0;
    StepPlace m_place;

    /// False for `face` without its number.
    bool face()
    {
        if (m_words[0] != QLatin1String("face"))
            return true;
        const auto number = wholeNumber(m_words.value(1));
        m_place.face = static_cast<std::uint32_t>(number.value_or(0));
        m_next = 2;
        return number.has_value();
    }

    void kindOrStop()
    {
        const QString word = m_words.value(m_next);
        m_place.kind = kindNamed(word);
        for (const StopName& stop : kStops)
            if (word == QLatin1String(stop.id))
                m_place.stop = stop.stop;
        if (m_place.kind || m_place.stop)
            ++m_next;
    }

    /// False for a `#` without a number from 1 on.
    bool ordinal()
    {
        if (!m_words.value(m_next).startsWith(QLatin1Char('#')))
            return true;
        const auto number = wholeNumber(m_words[m_next++].mid(1));
        m_place.nth = static_cast<int>(number.value_or(0));
        return m_place.nth > 0;
    }
};

/// A log as searchFor() reads it.
struct LogEvents {
    const StepLog& log;

    [[nodiscard]] std::size_t size() const { return log.size(); }
    [[nodiscard]] StepEvent event(std::size_t i) const { return log.event(i); }
    [[nodiscard]] int grid() const { return log.grid(); }
    [[nodiscard]] std::optional<std::size_t> next(std::size_t from, const StepStop& stop) const
    {
        return log.findStop(from, StepDirection::Forward, stop);
    }
};

/// A record as searchFor() reads it.
struct RecordEvents {
    const StepRecord& record;
    StepFinder& finder;

    [[nodiscard]] std::size_t size() const { return record.size(); }
    [[nodiscard]] StepEvent event(std::size_t i) const { return finder.event(i); }
    [[nodiscard]] int grid() const { return record.emptyWindow()->grid(); }
    [[nodiscard]] std::optional<std::size_t> next(std::size_t from, const StepStop& stop) const
    {
        return finder.findStop(from, StepDirection::Forward, stop);
    }
};

/// The position after the event that a place of conditions names.
template <class Events>
std::optional<std::size_t> searchFor(const StepPlace& place, const Events& events)
{
    std::vector<StepStop> stops;
    if (place.pixel)
        stops.push_back({StepStop::Kind::Pixel, place.pixel->x(), place.pixel->y()});
    if (place.stop)
        stops.push_back({*place.stop});
    int left = place.nth;
    for (std::size_t i = 0; i < events.size(); ++i) {
        if (!stops.empty()) {
            const auto next = events.next(i, stops.front());
            if (!next)
                return std::nullopt;
            i = *next;
        }
        const StepEvent event = events.event(i);
        const bool fits =
            (!place.face || event.face == *place.face) && (!place.kind || event.kind == *place.kind) &&
            std::ranges::all_of(stops, [&](const StepStop& stop) { return stopsAt(event, stop, events.grid()); });
        if (fits && --left == 0)
            return i + 1;
    }
    return std::nullopt;
}

} // namespace

std::optional<StepPlace> stepPlaceFromText(const QString& text)
{
    StepPlace place;
    place.position = wholeNumber(text);
    place.end = text == QLatin1String("end");
    return place.position || place.end ? place : PlaceReader(text).read();
}

QString textOf(const StepPlace& place)
{
    if (place.position)
        return QString::number(*place.position);
    if (place.end)
        return QStringLiteral("end");
    QStringList words;
    if (place.face)
        words << QStringLiteral("face %1").arg(*place.face);
    if (place.kind)
        words << QLatin1String(stepKindId(*place.kind));
    for (const StopName& stop : kStops)
        if (place.stop == stop.stop)
            words << QLatin1String(stop.id);
    if (place.pixel)
        words << QStringLiteral("%1,%2").arg(place.pixel->x()).arg(place.pixel->y());
    if (place.nth > 1)
        words << QStringLiteral("#%1").arg(place.nth);
    return words.join(QLatin1Char(' '));
}

std::optional<std::size_t> positionOf(const StepPlace& place, const StepLog& log)
{
    if (place.position)
        return *place.position <= log.size() ? place.position : std::nullopt;
    if (place.end)
        return log.truncated() ? std::nullopt : std::optional(log.size());
    return searchFor(place, LogEvents{log});
}

std::optional<std::size_t> positionOf(const StepPlace& place, const std::shared_ptr<const StepRecord>& record)
{
    if (place.position)
        return *place.position <= record->size() ? place.position : std::nullopt;
    if (place.end)
        return record->size();
    StepFinder finder(record);
    return searchFor(place, RecordEvents{*record, finder});
}

QString stepPlaceHelp()
{
    QStringList names;
    for (const StopName& stop : kStops)
        names << QLatin1String(stop.id);
    return QStringLiteral("a number, %1, end, or [face N] [KIND] [x,y] [#n]").arg(names.join(QStringLiteral(", ")));
}

} // namespace rasterlens
