#include "core/scene/orientation.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rasterlens
{
namespace
{

/// A number as a sum of doubles that do not overlap, the smallest first.
class Expansion
{
public:
    /// Adds x * y, which is the sum of two doubles exactly.
    void addProduct(double x, double y)
    {
        const double high = x * y;
        add(std::fma(x, y, -high));
        add(high);
    }

    [[nodiscard]] double value() const
    {
        double sum = 0;
        for (std::size_t i = 0; i < m_size; ++i)
            sum += m_parts[i];
        return sum;
    }

private:
    void add(double term)
    {
        double rest = term;
        for (std::size_t i = 0; i < m_size; ++i) {
            const double sum = rest + m_parts[i];
            const double back = sum - rest;
            m_parts[i] = (rest - (sum - back)) + (m_parts[i] - back);
            rest = sum;
        }
        m_parts[m_size++] = rest;
    }

    std::array<double, 12> m_parts{};
    std::size_t m_size = 0;
};

double exactOrientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    Expansion area;
    area.addProduct(a.x, b.y);
    area.addProduct(-a.y, b.x);
    area.addProduct(b.x, c.y);
    area.addProduct(-b.y, c.x);
    area.addProduct(c.x, a.y);
    area.addProduct(-c.y, a.x);
    return area.value();
}

} // namespace

double orientation(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c)
{
    constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2;
    const double left = (b.x - a.x) * (c.y - a.y);
    const double right = (b.y - a.y) * (c.x - a.x);
    const double area = left - right;
    const double bound = (3 + 16 * kUnit) * kUnit * (std::abs(left) + std::abs(right));
    return std::abs(area) > bound || bound == 0 ? area : exactOrientation(a, b, c);
}

} // namespace rasterlens
