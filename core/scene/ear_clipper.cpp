#include "core/scene/ear_clipper.h"

#include "core/scene/orientation.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rasterlens
{
namespace
{

constexpr std::uint64_t kMostPointTests = 150'000'000;

struct Triangle2 {
    glm::dvec2 a;
    glm::dvec2 b;
    glm::dvec2 c;
};

/// The reflex corners of a polygon by place, in square cells, about as many as corners.
class ReflexGrid
{
public:
    explicit ReflexGrid(std::span<const glm::dvec2> points) : m_points(points), m_slot(points.size(), kNone)
    {
        glm::dvec2 high(-std::numeric_limits<double>::infinity());
        m_low = -high;
        for (const glm::dvec2& p : points) {
            m_low = glm::min(m_low, p);
            high = glm::max(high, p);
        }
        const glm::dvec2 size = high - m_low;
        const auto count = static_cast<double>(points.size());
        const double side = std::max(std::sqrt(size.x * size.y / count), std::max(size.x, size.y) / count);
        m_perUnit = side > 0 && std::isfinite(1 / side) ? 1 / side : 0;
        m_columns = cell(size.x) + 1;
        m_rows = cell(size.y) + 1;
        m_cells.resize(static_cast<std::size_t>(m_columns) * static_cast<std::size_t>(m_rows));
    }

    void insert(std::uint32_t corner)
    {
        std::vector<std::uint32_t>& cell = cellOf(corner);
        m_slot[corner] = static_cast<std::uint32_t>(cell.size());
        cell.push_back(corner);
        ++m_count;
    }

    void remove(std::uint32_t corner)
    {
        std::vector<std::uint32_t>& cell = cellOf(corner);
        const std::uint32_t slot = m_slot[corner];
        cell[slot] = cell.back();
        m_slot[cell[slot]] = slot;
        cell.pop_back();
        m_slot[corner] = kNone;
        --m_count;
    }

    [[nodiscard]] bool holds(std::uint32_t corner) const { return m_slot[corner] != kNone; }
    [[nodiscard]] bool empty() const { return m_count == 0; }

    /// Whether `test` is true of a corner in one of the cells that the triangle touches.
    template <class Test>
    bool any(const Triangle2& t, Test&& test) const
    {
        const int firstRow = cell(std::min({t.a.y, t.b.y, t.c.y}) - m_low.y);
        const int lastRow = std::min(m_rows - 1, cell(std::max({t.a.y, t.b.y, t.c.y}) - m_low.y));
        for (int row = firstRow; row <= lastRow; ++row) {
            const auto [first, last] = columns(t, row);
            for (int column = first; column <= last; ++column)
                for (const std::uint32_t corner : m_cells[index(column, row)])
                    if (test(corner))
                        return true;
        }
        return false;
    }

private:
    static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

    [[nodiscard]] int cell(double distance) const { return static_cast<int>(distance * m_perUnit); }

    [[nodiscard]] std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(m_columns) + static_cast<std::size_t>(column);
    }

    std::vector<std::uint32_t>& cellOf(std::uint32_t corner)
    {
        const glm::dvec2 at = m_points[corner] - m_low;
        return m_cells[index(std::min(cell(at.x), m_columns - 1), std::min(cell(at.y), m_rows - 1))];
    }

    /// The columns that the triangle may touch within a row of cells: one more on each side for the rounding.
    [[nodiscard]] std::pair<int, int> columns(const Triangle2& t, int row) const
    {
        const double low = m_low.y + (row - 0.01) / m_perUnit;
        const double high = m_low.y + (row + 1.01) / m_perUnit;
        double left = std::numeric_limits<double>::infinity();
        double right = -left;
        const auto take = [&](double x) {
            left = std::min(left, x);
            right = std::max(right, x);
        };
        for (const auto& [from, to] : {std::pair(t.a, t.b), std::pair(t.b, t.c), std::pair(t.c, t.a)}) {
            if (std::max(from.y, to.y) < low || std::min(from.y, to.y) > high)
                continue;
            for (const double y : {low, high})
                if ((from.y < y) != (to.y < y))
                    take(from.x + (to.x - from.x) * ((y - from.y) / (to.y - from.y)));
            for (const glm::dvec2& end : {from, to})
                if (end.y >= low && end.y <= high)
                    take(end.x);
        }
        if (left > right)
            return {0, -1};
        return {std::max(0, cell(left - m_low.x) - 1), std::min(m_columns - 1, cell(right - m_low.x) + 1)};
    }

    std::span<const glm::dvec2> m_points;
    glm::dvec2 m_low{0};
    double m_perUnit = 0; ///< cells a unit; 0 puts all into one
    int m_columns = 1;
    int m_rows = 1;
    std::vector<std::vector<std::uint32_t>> m_cells;
    std::vector<std::uint32_t> m_slot; ///< of a corner in its cell
    std::size_t m_count = 0;
};

class EarClipper
{
public:
    EarClipper(std::span<const glm::dvec2> points, std::vector<CornerTriple>& triangles)
        : m_points(points), m_triangles(triangles), m_left(static_cast<std::uint32_t>(points.size())), m_next(m_left),
          m_previous(m_left), m_reflex(points)
    {
        for (std::uint32_t i = 0; i < m_left; ++i) {
            m_next[i] = (i + 1) % m_left;
            m_previous[i] = (i + m_left - 1) % m_left;
        }
        for (std::uint32_t i = 0; i < m_left; ++i)
            if (turn(i) < 0)
                m_reflex.insert(i);
    }

    /// Walks round the polygon until no ear is left. If two neighbouring corners are both ears, one of them waits for
    /// the next round, so that the triangles stay small.
    void run()
    {
        std::uint32_t corner = 1;
        std::uint32_t triedInVain = 0;
        while (m_left > 3 && !m_reflex.empty() && m_tests < kMostPointTests && triedInVain < m_left) {
            if (isEar(corner)) {
                cut(corner);
                triedInVain = 0;
                corner = m_next[corner];
            } else {
                ++triedInVain;
            }
            corner = m_next[corner];
        }
        fanTheRest(m_previous[corner]);
    }

private:
    double turn(std::uint32_t i) const
    {
        return orientation(m_points[m_previous[i]], m_points[i], m_points[m_next[i]]);
    }

    /// A convex corner whose triangle holds no other corner; only reflex ones can lie in it.
    bool isEar(std::uint32_t i)
    {
        if (m_reflex.holds(i))
            return false;
        const Triangle2 t{m_points[m_previous[i]], m_points[i], m_points[m_next[i]]};
        return !m_reflex.any(t, [&](std::uint32_t other) {
            ++m_tests;
            const glm::dvec2 p = m_points[other];
            if (other == m_previous[i] || other == m_next[i] || p == t.a || p == t.c)
                return false;
            return orientation(t.a, t.b, p) >= 0 && orientation(t.b, t.c, p) >= 0 && orientation(t.c, t.a, p) >= 0;
        });
    }

    void cut(std::uint32_t i)
    {
        const std::uint32_t before = m_previous[i];
        const std::uint32_t after = m_next[i];
        m_triangles.push_back({before, i, after});
        m_next[before] = after;
        m_previous[after] = before;
        --m_left;
        for (const std::uint32_t neighbour : {before, after})
            if (m_reflex.holds(neighbour) && turn(neighbour) >= 0)
                m_reflex.remove(neighbour);
    }

    void fanTheRest(std::uint32_t hub)
    {
        for (std::uint32_t i = m_next[hub]; m_next[i] != hub; i = m_next[i])
            m_triangles.push_back({hub, i, m_next[i]});
    }

    std::span<const glm::dvec2> m_points;
    std::vector<CornerTriple>& m_triangles;
    std::uint32_t m_left;
    std::vector<std::uint32_t> m_next; // the corners that are left, as a ring
    std::vector<std::uint32_t> m_previous;
    ReflexGrid m_reflex;
    std::uint64_t m_tests = 0;
};

} // namespace

void clipEars(std::span<const glm::dvec2> points, std::vector<CornerTriple>& triangles)
{
    EarClipper(points, triangles).run();
}

} // namespace rasterlens
