#include "core/pipeline/pixel_area.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rasterlens
{
namespace
{

/// A convex polygon; cutting a triangle by four lines leaves at most seven corners.
struct Polygon {
    std::array<glm::dvec2, 8> corners{};
    std::size_t count = 0;

    void add(const glm::dvec2& corner) { corners[count++] = corner; }

    [[nodiscard]] double area() const
    {
        double twice = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const glm::dvec2& a = corners[i];
            const glm::dvec2& b = corners[(i + 1) % count];
            twice += a.x * b.y - b.x * a.y;
        }
        return std::abs(twice) / 2;
    }
};

/// What lies where sign * (p[axis] - at) >= 0.
Polygon cut(const Polygon& polygon, int axis, double at, double sign)
{
    Polygon out;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        const glm::dvec2& a = polygon.corners[i];
        const glm::dvec2& b = polygon.corners[(i + 1) % polygon.count];
        const double da = sign * (a[axis] - at);
        const double db = sign * (b[axis] - at);
        if (da >= 0)
            out.add(a);
        if ((da >= 0) != (db >= 0))
            out.add(a + (b - a) * (da / (da - db)));
    }
    return out;
}

Polygon between(const Polygon& polygon, int axis, double low, double side = 1)
{
    return cut(cut(polygon, axis, low, 1), axis, low + side, -1);
}

Polygon polygonOf(const ScreenTriangle& triangle)
{
    Polygon polygon;
    for (const ScreenVertex& vertex : triangle.vertices)
        polygon.add(vertex.position);
    return polygon;
}

/// The pixels that a polygon may touch along an axis: [begin, end).
std::array<int, 2> pixelsOf(const Polygon& polygon, int axis, int size)
{
    double low = size;
    double high = 0;
    for (std::size_t i = 0; i < polygon.count; ++i) {
        low = std::min(low, polygon.corners[i][axis]);
        high = std::max(high, polygon.corners[i][axis]);
    }
    const auto held = [&](double p) { return static_cast<int>(std::clamp(p, 0.0, double(size))); };
    return {held(std::floor(low)), held(std::ceil(high))};
}

} // namespace

double areaInPixel(const ScreenTriangle& triangle, int x, int y, int grid)
{
    const double side = grid;
    const Polygon row = between(polygonOf(triangle), 1, y * side, side);
    return between(row, 0, x * side, side).area() / (side * side);
}

void addAreas(const ScreenTriangle& triangle, QSize size, std::vector<double>& areas)
{
    const Polygon whole = polygonOf(triangle);
    const auto [top, bottom] = pixelsOf(whole, 1, size.height());
    for (int y = top; y < bottom; ++y) {
        const Polygon row = between(whole, 1, y);
        const auto [left, right] = pixelsOf(row, 0, size.width());
        for (int x = left; x < right; ++x)
            areas[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width()) + static_cast<std::size_t>(x)] +=
                between(row, 0, x).area();
    }
}

} // namespace rasterlens
