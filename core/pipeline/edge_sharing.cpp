#include "core/pipeline/edge_sharing.h"

#include <bit>
#include <utility>

namespace rasterlens
{
namespace
{

constexpr std::size_t kFirstPlaces = 64;

/// Whether of two samples of equal depth the first one stays.
bool firstStays(const Rules& rules)
{
    if (!rules.depthTested)
        return false;
    switch (rules.depthCompare) {
    case DepthCompare::Less:
    case DepthCompare::Greater:
    case DepthCompare::NotEqual: return true;
    case DepthCompare::LessEqual:
    case DepthCompare::Equal:
    case DepthCompare::GreaterEqual:
    case DepthCompare::Always: break;
    }
    return false;
}

} // namespace

EdgeSharing::EdgeSharing(const Rules& rules) : m_firstDraws(firstStays(rules)), m_table(kFirstPlaces, 0) {}

std::uint32_t EdgeSharing::add(const ScreenTriangle& triangle)
{
    const auto number = static_cast<std::uint32_t>(m_shared.size());
    m_shared.push_back(0);
    for (std::size_t i = 0; i < 3; ++i)
        addEdge(
            {endsOf(triangle.vertices[i], triangle.vertices[(i + 1) % 3]), number, static_cast<std::uint8_t>(1U << i)});
    return number;
}

void EdgeSharing::addEdge(const Edge& edge)
{
    if (2 * m_edges.size() >= m_table.size())
        grow();
    std::uint32_t& place = m_table[placeOf(edge.ends)];
    if (place == 0) {
        m_edges.push_back(edge);
        place = static_cast<std::uint32_t>(m_edges.size());
        return;
    }
    Edge& drawn = m_edges[place - 1];
    const Edge& left = m_firstDraws ? edge : drawn;
    m_shared[left.triangle] |= left.bit;
    if (!m_firstDraws)
        drawn = edge;
}

EdgeSharing::Ends EdgeSharing::endsOf(const ScreenVertex& a, const ScreenVertex& b)
{
    // 0 is added so that no -0 is kept
    const auto end = [](const ScreenVertex& v) {
        return std::array{v.position.x + 0.0, v.position.y + 0.0, v.depth + 0.0};
    };
    std::array first = end(a);
    std::array second = end(b);
    if (second < first)
        std::swap(first, second);
    return {first[0], first[1], first[2], second[0], second[1], second[2]};
}

std::uint64_t EdgeSharing::hashOf(const Ends& ends)
{
    std::uint64_t hash = 0;
    for (const double value : ends)
        hash = (hash ^ std::bit_cast<std::uint64_t>(value)) * 0x9e3779b97f4a7c15U + (hash >> 29U);
    return hash ^ hash >> 32U;
}

/// Where the edge stands in the table, or is to stand. Numbers that are none equal nothing: such an edge is its own.
std::size_t EdgeSharing::placeOf(const Ends& ends) const
{
    const std::size_t mask = m_table.size() - 1;
    std::size_t place = hashOf(ends) & mask;
    while (m_table[place] != 0 && m_edges[m_table[place] - 1].ends != ends)
        place = (place + 1) & mask;
    return place;
}

void EdgeSharing::grow()
{
    m_table.assign(2 * m_table.size(), 0);
    for (std::size_t i = 0; i < m_edges.size(); ++i)
        m_table[placeOf(m_edges[i].ends)] = static_cast<std::uint32_t>(i + 1);
}

} // namespace rasterlens
