#include "core/observe/counting_observer.h"

#include "core/pipeline/fate_count.h"
#include "core/pipeline/interpolation.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace rasterlens
{
namespace
{

/// In fixed point only a centre exactly on an edge can be hit from both sides; the weights it is told by err by less
/// than this. Floating point may err further, though by far less than this again.
constexpr double kFixedTie = 1e-9;
constexpr double kFloatTie = 1.0 / 64;
/// The outline of column fill joins corners rounded to samples, and runs a column ahead where it is steep.
constexpr double kColumnFillTie = 3;

double nearDistance(const Rules& rules)
{
    if (rules.algorithm == Algorithm::ColumnFill)
        return kColumnFillTie;
    return rules.numberType == NumberType::Fixed ? kFixedTie : kFloatTie;
}

} // namespace

CountingObserver::CountingObserver(const Rules& rules)
    : m_rules(rules), m_columns(rules.columns()), m_rows(rules.rows()), m_isFilled(rules.fill == Fill::Solid),
      m_firstPassFaces(rules.firstPassFaces), m_nearDistance(nearDistance(rules))
{
}

CountingObserver::CountingObserver(const Rules& rules, const Statistics& before,
                                   std::span<const std::uint64_t> doubleHits)
    : CountingObserver(rules)
{
    m_statistics = before;
    const auto next = std::ranges::upper_bound(doubleHits, before.pixels.covered);
    m_doubleHits = std::span(next, doubleHits.end());
}

void CountingObserver::onFace(std::uint32_t, FaceFate fate) { countFate(fate, m_statistics.faces); }

void CountingObserver::onClipped(std::uint32_t, int pieces)
{
    ++m_statistics.faces.clipped;
    m_statistics.faces.createdByClipping += static_cast<std::uint64_t>(pieces);
}

void CountingObserver::beginTriangle(const ScreenTriangle& triangle)
{
    m_sample = 0;
    m_isLine = triangle.isLine;
    for (std::size_t i = 0; i < 3; ++i)
        m_positions[i] = triangle.vertices[i].position;
    const double area2 = twiceArea(m_positions[0], m_positions[1], m_positions[2]);
    m_counterClockwise = area2 > 0;
    for (std::size_t i = 0; i < 3; ++i)
        m_nearEdge[i] =
            m_nearDistance * glm::distance(m_positions[(i + 1) % 3], m_positions[(i + 2) % 3]) / std::abs(area2);
}

void CountingObserver::onFragment(const Fragment& fragment, float, bool passedDepth)
{
    Statistics::Pixels& pixels = m_statistics.pixels;
    ++pixels.covered;
    ++(passedDepth ? pixels.depthPassed : pixels.depthFailed);
    if (m_doubleHits) {
        if (!m_doubleHits->empty() && m_doubleHits->front() == pixels.covered) {
            m_doubleHits = m_doubleHits->subspan(1);
            ++pixels.coveredTwice;
        }
        return;
    }
    if (m_isLine || (!m_isFilled && fragment.face >= m_firstPassFaces))
        return;
    for (std::size_t i = 0; i < 3; ++i) {
        if (fragment.screen[i] > m_nearEdge[i])
            continue;
        glm::dvec2 from = m_positions[(i + 1) % 3];
        glm::dvec2 to = m_positions[(i + 2) % 3];
        if (!m_counterClockwise)
            std::swap(from, to);
        const std::int64_t row = std::int64_t(m_sample) * m_rows + fragment.y;
        const auto sample = static_cast<std::uint64_t>(row * m_columns + fragment.x);
        m_hits.insert({from, to, sample});
        if (m_hits.contains({to, from, sample}) && m_hitTwice.insert(sample).second)
            ++pixels.coveredTwice;
    }
}

std::size_t CountingObserver::EdgeHitHash::operator()(const EdgeHit& hit) const
{
    std::uint64_t h = hit.sample;
    for (const double v : {hit.from.x, hit.from.y, hit.to.x, hit.to.y})
        h = (h ^ std::bit_cast<std::uint64_t>(v)) * 0x9e3779b97f4a7c15U + (h >> 29);
    return h;
}

} // namespace rasterlens
