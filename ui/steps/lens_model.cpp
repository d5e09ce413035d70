#include "ui/steps/lens_model.h"

#include "core/observe/step_text.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace rasterlens
{
namespace
{

QString translated(const char* text) { return QCoreApplication::translate("Lens", text); }

/// The last event at a position that is one of `events`, or null.
template <class Payload>
const Payload* lastOf(const StepLog& log, std::span<const std::uint32_t> events, std::size_t position)
{
    const auto after = std::lower_bound(events.begin(), events.end(), position);
    return after == events.begin() ? nullptr : &log.payload<Payload>(log.event(*std::prev(after)));
}

/// The events of a sample of the pattern, out of those of one triangle: one sample comes after the other.
std::span<const std::uint32_t> ofSample(const StepLog& log, std::span<const std::uint32_t> events, int sample)
{
    const auto sampleOf = [&](std::uint32_t i) { return int(log.event(i).sample); };
    const auto found = std::ranges::equal_range(events, sample, {}, sampleOf);
    return {found.begin(), found.end()};
}

} // namespace

EdgeSign signOf(double value)
{
    if (std::isnan(value))
        return EdgeSign::NotANumber;
    if (value == 0)
        return EdgeSign::Zero;
    return value > 0 ? EdgeSign::Plus : EdgeSign::Minus;
}

LensModel::LensModel(const StepLog& log, const StepEvent& triangle, std::size_t position)
    : LensModel(log, triangle, position, position > 0 ? &log.event(position - 1) : nullptr)
{
}

LensModel::LensModel(const StepLog& log, const StepEvent& triangle, std::size_t position, const StepEvent* now)
    : m_log(&log), m_triangle(log.triangle(triangle)), m_index(triangle.triangle),
      m_begin(std::size_t(&triangle - log.events().data())), m_position(position), m_now(now)
{
    const auto setup = eventsOfTriangle(StepKind::Setup);
    m_hasSetup = m_triangle->hasSetup && !setup.empty() && setup.front() < position;
    m_walks = log.rules().algorithm == Algorithm::EdgeWalking;
    m_sample = ownsEvent() ? std::max(0, int(m_now->sample)) : 0;
    m_samples = ofSample(log, eventsOfTriangle(StepKind::Sample), m_sample);
    m_spans = ofSample(log, eventsOfTriangle(StepKind::Span), m_sample);
}

std::span<const std::uint32_t> LensModel::eventsOfTriangle(StepKind kind) const
{
    const auto events = m_log->eventsOf(kind);
    const auto first = std::partition_point(events.begin(), events.end(),
                                            [this](std::uint32_t i) { return m_log->event(i).triangle < m_index; });
    const auto last = std::partition_point(first, events.end(),
                                           [this](std::uint32_t i) { return m_log->event(i).triangle == m_index; });
    return {first, last};
}

/// The samples of a triangle come row by row, left to right: all of its bounds, unless the record is filtered or cut
/// off.
const StepEvent* LensModel::sampleAt(int x, int y) const
{
    const PixelRect& bounds = m_triangle->setup.bounds;
    const auto isIt = [&](const StepEvent& event) { return event.x == x && event.y == y; };
    const auto guess = std::size_t(y - bounds.y) * std::size_t(bounds.width) + std::size_t(x - bounds.x);
    if (guess < m_samples.size() && isIt(m_log->event(m_samples[guess])))
        return &m_log->event(m_samples[guess]);
    const auto at = std::partition_point(m_samples.begin(), m_samples.end(), [&](std::uint32_t i) {
        const StepEvent& event = m_log->event(i);
        return std::tie(event.y, event.x) < std::tie(y, x);
    });
    return at != m_samples.end() && isIt(m_log->event(*at)) ? &m_log->event(*at) : nullptr;
}

bool LensModel::isFinished() const
{
    return m_now != nullptr && m_position == m_log->size() && m_now->face != m_triangle->screen.face;
}

bool LensModel::wantsFar() const { return m_hasSetup && (m_begin < m_log->lead() || isFinished()); }

/// Whether a sample of the triangle has had its turn, but not in this window: samples come row by row.
bool LensModel::isPastElsewhere(int x, int y) const
{
    const bool isCutBefore = m_begin < m_log->lead() && m_position > m_begin;
    const std::span<const std::uint32_t> held = m_walks ? m_spans : m_samples;
    if (held.empty())
        return isCutBefore || isFinished();
    const StepEvent& first = m_log->event(held.front());
    const StepEvent& last = m_log->event(held.back());
    const auto comesBefore = [&](int x0, int y0, int x1, int y1) {
        return m_walks ? y0 < y1 : std::tie(y0, x0) < std::tie(y1, x1);
    };
    return (isCutBefore && comesBefore(x, y, first.x, first.y)) || (isFinished() && comesBefore(last.x, last.y, x, y));
}

/// The event of a sample, or of a row's span, that the window does not hold; null: none is known.
const StepEvent* LensModel::farEvent(StepKind kind, int x, int y) const
{
    if (!m_far || !isPastElsewhere(x, y))
        return nullptr;
    const auto events = ofSample(*m_far, m_far->eventsOf(kind), m_sample);
    const auto at = std::partition_point(events.begin(), events.end(), [&](std::uint32_t i) {
        const StepEvent& event = m_far->event(i);
        return kind == StepKind::Span ? event.y < y : std::tie(event.y, event.x) < std::tie(y, x);
    });
    if (at == events.end())
        return nullptr;
    const StepEvent& event = m_far->event(*at);
    return event.y == y && (kind == StepKind::Span || event.x == x) ? &event : nullptr;
}

void LensModel::readSample(LensCell& cell, int x, int y) const
{
    const StepSetup& setup = m_triangle->setup;
    const StepEvent* sample = sampleAt(x, y);
    const StepEvent* far = sample ? nullptr : farEvent(StepKind::Sample, x, y);
    cell.hasValues = true;
    cell.values = sample ? m_log->payload<SampleStep>(*sample).values
                  : far  ? m_far->payload<SampleStep>(*far).values
                         : testedValues(setup, m_log->rules(), x, y, m_sample);
    if (far || (sample && sample < &m_log->events().front() + m_position))
        cell.state =
            (far ? far : sample)->has(StepEvent::kCovered) ? LensCell::State::Covered : LensCell::State::Rejected;
    const DecidingEdge decides = decidingEdge(setup, cell.values, m_log->rules());
    cell.deciding = int(decides.edge);
    cell.tie = decides.isTie();
    for (std::size_t i = 0; i < 3; ++i) {
        cell.signs[i] = signOf(cell.values[i]);
        cell.ours[i] = decides.sign == DecidingEdge::Sign::AtMost || cell.values[i] >= setup.edges[i].threshold ||
                       m_log->rules().insideTest == InsideTest::None;
    }
}

void LensModel::readSpan(LensCell& cell, int x, int y) const
{
    const SpanStep* span = nullptr;
    const auto row =
        std::partition_point(m_spans.begin(), m_spans.end(), [&](std::uint32_t i) { return m_log->event(i).y < y; });
    if (row != m_spans.end() && *row < m_position && m_log->event(*row).y == y)
        span = &m_log->payload<SpanStep>(m_log->event(*row));
    else if (const StepEvent* far = farEvent(StepKind::Span, x, y))
        span = &m_far->payload<SpanStep>(*far);
    if (span != nullptr)
        cell.state = x >= span->xBegin && x < span->xEnd ? LensCell::State::Covered : LensCell::State::Rejected;
}

LensCell LensModel::cell(int x, int y) const
{
    LensCell cell;
    const PixelRect& bounds = m_triangle->setup.bounds;
    if (!m_hasSetup || x < bounds.x || y < bounds.y || x >= bounds.x + bounds.width || y >= bounds.y + bounds.height)
        return cell;
    cell.state = LensCell::State::Waiting;
    if (m_walks)
        readSpan(cell, x, y);
    else
        readSample(cell, x, y);
    return cell;
}

const WalkedTriangle* LensModel::walk() const
{
    const auto* step = lastOf<WalkStep>(*m_log, eventsOfTriangle(StepKind::Walk), m_position);
    return step ? &step->walk : nullptr;
}

const WalkedTriangle* LensModel::sides() const
{
    const auto* step = lastOf<SidesStep>(*m_log, eventsOfTriangle(StepKind::Sides), m_position);
    return step ? &step->walk : nullptr;
}

const WalkedHalves* LensModel::halves() const
{
    const auto* step = lastOf<HalvesStep>(*m_log, eventsOfTriangle(StepKind::Halves), m_position);
    return step ? &step->halves : nullptr;
}

const RowCrossings* LensModel::crossings() const
{
    const auto* step = lastOf<CrossingStep>(*m_log, eventsOfTriangle(StepKind::Crossing), m_position);
    return step ? &step->row : nullptr;
}

const SpanStep* LensModel::span() const { return lastOf<SpanStep>(*m_log, m_spans, m_position); }

const FilledColumn* LensModel::column() const
{
    const auto* step = lastOf<ColumnFillStep>(*m_log, eventsOfTriangle(StepKind::Column), m_position);
    return step ? &step->column : nullptr;
}

const LineStep* LensModel::line() const
{
    return lastOf<LineStep>(*m_log, eventsOfTriangle(StepKind::LineDecision), m_position);
}

const LinePosition* LensModel::linePosition() const
{
    const auto* step = lastOf<LinePositionStep>(*m_log, eventsOfTriangle(StepKind::LinePosition), m_position);
    return step ? &step->position : nullptr;
}

std::optional<std::array<glm::ivec2, 2>> LensModel::lineEnds() const
{
    const LineStep* step = line();
    return step != nullptr ? rasterlens::lineEnds(m_triangle->screen, step->decision, m_log->rules()) : std::nullopt;
}

std::optional<std::array<glm::ivec2, 2>> lineEnds(const ScreenTriangle& triangle, const LineDecision& decision,
                                                  const Rules& rules)
{
    const auto sampleOf = [&](std::size_t i) { return glm::ivec2(glm::floor(triangle.vertices[i].position)); };
    const int axis = decision.steep ? 1 : 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (!triangle.drawsEdge(i))
            continue;
        glm::ivec2 from = sampleOf(i);
        glm::ivec2 to = sampleOf((i + 1) % 3);
        if (!rules.lineTiesByDirection && std::pair(from.y, from.x) > std::pair(to.y, to.x))
            std::swap(from, to);
        const glm::ivec2 size = glm::abs(to - from);
        if (size[axis] != decision.longer || size[1 - axis] != decision.shorter)
            continue;
        const int now = axis == 0 ? decision.x : decision.y;
        if (from[axis] + (to[axis] < from[axis] ? -decision.step : decision.step) == now)
            return std::array{from, to};
    }
    return std::nullopt;
}

QString edgeSideText(EdgeSide side)
{
    switch (side) {
    case EdgeSide::Left: return translated(QT_TRANSLATE_NOOP("Lens", "left"));
    case EdgeSide::Top: return translated(QT_TRANSLATE_NOOP("Lens", "top"));
    case EdgeSide::Neither: break;
    }
    return translated(QT_TRANSLATE_NOOP("Lens", "neither"));
}

QString lensCellText(const StepSetup& setup, const LensCell& cell)
{
    const auto edge = std::size_t(cell.deciding);
    const double value = cell.values[edge];
    if (!cell.tie) {
        const QString text = edgeValueText(value, setup.unitsPerArea);
        return value > 0 ? QLatin1Char('+') + text : text;
    }
    const bool ours = cell.ours[edge];
    return QStringLiteral("%1: %2, %3")
        .arg(translated(QT_TRANSLATE_NOOP("Lens", "tie")), edgeSideText(setup.edges[edge].side),
             ours ? translated(QT_TRANSLATE_NOOP("Lens", "ours")) : translated(QT_TRANSLATE_NOOP("Lens", "not ours")));
}

QStringList lensHoverLines(const LensModel& model, int x, int y)
{
    const StepSetup& setup = model.triangle().setup;
    const LensCell cell = model.cell(x, y);
    if (!cell.hasValues)
        return {};
    QStringList lines{translated(QT_TRANSLATE_NOOP("Lens", "sample (%1, %2)")).arg(x).arg(y)};
    const auto steps = [&](double units) {
        const QString text = edgeValueText(units, setup.unitsPerArea);
        return units < 0 ? text : QLatin1Char('+') + text;
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const StepEdge& edge = setup.edges[i];
        QString line =
            QStringLiteral("%1 = %2   ")
                .arg(edgeValueName(setup, int(i)), edgeValueText(cell.values[i], setup.unitsPerArea)) +
            translated(QT_TRANSLATE_NOOP("Lens", "%1 per x, %2 per y")).arg(steps(edge.perX), steps(edge.perY));
        if (cell.signs[i] == EdgeSign::Zero)
            line += QStringLiteral("   ") +
                    translated(QT_TRANSLATE_NOOP("Lens", "tie: %1, %2"))
                        .arg(edgeSideText(edge.side), cell.ours[i] ? translated(QT_TRANSLATE_NOOP("Lens", "ours"))
                                                                   : translated(QT_TRANSLATE_NOOP("Lens", "not ours")));
        lines << line;
    }
    return lines;
}

} // namespace rasterlens
