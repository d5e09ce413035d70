#include "core/truth/exact_geometry.h"

#include "core/pipeline/shading.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace mp = boost::multiprecision;

namespace rasterlens::exact
{

Integer floorDivide(const Integer& numerator, const Integer& denominator)
{
    assert(denominator > 0);
    Integer quotient;
    Integer remainder;
    mp::divide_qr(numerator, denominator, quotient, remainder);
    return remainder.sign() < 0 ? Integer(quotient - 1) : quotient;
}

Integer roundHalfToEven(const Integer& numerator, const Integer& denominator)
{
    const Integer low = floorDivide(numerator, denominator);
    const Integer twice = 2 * (numerator - low * denominator);
    const bool up = twice > denominator || (twice == denominator && mp::bit_test(mp::abs(low), 0));
    return up ? Integer(low + 1) : low;
}

Linear operator*(const Linear& f, const Integer& factor)
{
    return {f.perColumn * factor, f.perRow * factor, f.origin * factor};
}

Linear operator+(const Linear& f, const Linear& g)
{
    return {f.perColumn + g.perColumn, f.perRow + g.perRow, f.origin + g.origin};
}

void keepPositive(const Linear& f, int row, Columns& columns)
{
    const Integer onRow = f.onRow(row);
    const int slope = f.perColumn.sign();
    if (slope == 0) {
        if (onRow.sign() < 0 || (onRow.sign() == 0 && f.perRow.sign() < 0))
            columns.end = columns.begin;
        return;
    }
    // f crosses zero at -onRow / perColumn
    const Integer ceiling = slope > 0 ? Integer(-floorDivide(onRow, f.perColumn))
                                      : Integer(-floorDivide(Integer(-onRow), Integer(-f.perColumn)));
    const int crossing = clampedTo(columns, ceiling);
    (slope > 0 ? columns.begin : columns.end) = crossing;
}

namespace
{

/// An odd integer times 2^exponent; 0 has the largest exponent there is.
struct Dyadic {
    std::int64_t mantissa = 0;
    int exponent = std::numeric_limits<int>::max();
};

Dyadic dyadicOf(double value)
{
    constexpr int kMantissaBits = 53;
    Dyadic result;
    if (value == 0)
        return result;
    result.mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &result.exponent), kMantissaBits));
    result.exponent -= kMantissaBits;
    for (; result.mantissa % 2 == 0; result.mantissa /= 2)
        ++result.exponent;
    return result;
}

/// in: unit <= value.exponent
Integer inUnits(const Dyadic& value, int unit)
{
    return value.mantissa == 0 ? Integer(0) : Integer(Integer(value.mantissa) << (value.exponent - unit));
}

} // namespace

Fraction fractionOf(double value)
{
    const Dyadic dyadic = dyadicOf(value);
    if (dyadic.mantissa == 0)
        return {0, 1};
    const int unit = std::min(dyadic.exponent, 0);
    return {inUnits(dyadic, unit), Integer(1) << -unit};
}

IntegerTriangle integerTriangle(const ClipTriangle& triangle, double smallestW, const glm::dmat4& clipFromPosition)
{
    // Each coordinate is the sum of four products of a matrix entry and a coordinate of the position.
    std::array<std::array<Dyadic, 4>, 4> entries;
    std::array<std::array<Dyadic, 4>, 3> positions;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            entries[std::size_t(row)][std::size_t(column)] = dyadicOf(clipFromPosition[column][row]);
    const Dyadic w = dyadicOf(smallestW);
    int unit = w.exponent;
    const auto forEachProduct = [&](auto&& visit) {
        for (std::size_t v = 0; v < 3; ++v)
            for (std::size_t row = 0; row < 4; ++row)
                for (std::size_t column = 0; column < 4; ++column)
                    if (entries[row][column].mantissa != 0 && positions[v][column].mantissa != 0)
                        visit(v, row, entries[row][column], positions[v][column]);
    };
    for (std::size_t v = 0; v < 3; ++v)
        for (std::size_t k = 0; k < 4; ++k)
            positions[v][k] = dyadicOf(triangle.vertices[v].positionClip[static_cast<int>(k)]);
    forEachProduct([&](std::size_t, std::size_t, const Dyadic& a, const Dyadic& b) {
        unit = std::min(unit, a.exponent + b.exponent);
    });

    IntegerTriangle result;
    result.smallestW = inUnits(w, unit);
    for (std::size_t v = 0; v < 3; ++v)
        result.corners[v].weights[v] = 1;
    forEachProduct([&](std::size_t v, std::size_t row, const Dyadic& a, const Dyadic& b) {
        result.corners[v].position[row] += (Integer(a.mantissa) * b.mantissa) << (a.exponent + b.exponent - unit);
    });
    return result;
}

namespace
{

/// How far a corner is inside each plane, times something > 0: x, y, z, the one at -w (z: at the near plane) first;
/// then w >= smallestW.
Integer planeDistance(const Corner& corner, int plane, ClipZ clipZ, const ExactSides& sides, const Integer& smallestW)
{
    const auto& [x, y, z, w] = corner.position;
    switch (plane) {
    case 0:
    case 1:
    case 2:
    case 3: {
        const Dyadic side = dyadicOf(plane < 2 ? sides.sideX : sides.sideY);
        const int unit = std::min(side.exponent, 0);
        const Integer reach = inUnits(side, unit) * w;
        const Integer value = (plane < 2 ? x : y) << -unit;
        return plane % 2 == 0 ? Integer(reach + value) : Integer(reach - value);
    }
    case 4: return clipZ == ClipZ::D3d ? z : Integer(w + z);
    case 5: return w - z;
    default: return w - smallestW * (corner.weights[0] + corner.weights[1] + corner.weights[2]);
    }
}

/// The point of the segment on the plane that lies `a` inside and `b` outside of it; positive multiples only.
Corner cut(const Corner& first, const Integer& firstDistance, const Corner& second, const Integer& secondDistance)
{
    const Integer a = mp::abs(secondDistance);
    const Integer b = mp::abs(firstDistance);
    Corner result;
    for (std::size_t k = 0; k < 4; ++k)
        result.position[k] = first.position[k] * a + second.position[k] * b;
    for (std::size_t k = 0; k < 3; ++k)
        result.weights[k] = first.weights[k] * a + second.weights[k] * b;

    Integer common = 0;
    for (const Integer& value : result.position)
        common = mp::gcd(common, value);
    for (const Integer& value : result.weights)
        common = mp::gcd(common, value);
    for (Integer& value : result.position)
        value /= common;
    for (Integer& value : result.weights)
        value /= common;
    return result;
}

} // namespace

std::vector<Corner> clipExactly(const IntegerTriangle& triangle, ClipZ clipZ, const ExactSides& sides)
{
    const int planes = sides.smallestW > 0 ? 7 : 6;
    std::vector<Corner> polygon(triangle.corners.begin(), triangle.corners.end());
    for (int plane = 0; plane < planes && polygon.size() >= 3; ++plane) {
        if ((plane == 4 || plane == 5) && !sides.nearFar)
            continue;
        std::vector<Integer> distances;
        for (const Corner& corner : polygon)
            distances.push_back(planeDistance(corner, plane, clipZ, sides, triangle.smallestW));
        if (std::all_of(distances.begin(), distances.end(), [](const Integer& d) { return d.sign() >= 0; }))
            continue;
        std::vector<Corner> kept;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const std::size_t next = (i + 1) % polygon.size();
            if (distances[i].sign() >= 0)
                kept.push_back(polygon[i]);
            if (distances[i].sign() * distances[next].sign() < 0)
                kept.push_back(cut(polygon[i], distances[i], polygon[next], distances[next]));
        }
        polygon = std::move(kept);
    }
    if (polygon.size() < 3)
        polygon.clear();
    return polygon;
}

std::vector<Corner> clipLineExactly(const IntegerTriangle& triangle, ClipZ clipZ, const ExactSides& sides)
{
    const int planes = sides.smallestW > 0 ? 7 : 6;
    std::vector<Corner> ends{triangle.corners[0], triangle.corners[1]};
    for (int plane = 0; plane < planes; ++plane) {
        if ((plane == 4 || plane == 5) && !sides.nearFar)
            continue;
        const Integer first = planeDistance(ends[0], plane, clipZ, sides, triangle.smallestW);
        const Integer second = planeDistance(ends[1], plane, clipZ, sides, triangle.smallestW);
        if (first.sign() < 0 && second.sign() < 0)
            return {};
        if (first.sign() < 0)
            ends[0] = cut(ends[0], first, ends[1], second);
        else if (second.sign() < 0)
            ends[1] = cut(ends[1], second, ends[0], first);
    }
    return ends;
}

ScreenCorner toScreen(const Corner& corner, const ClipTriangle& triangle, const Lattice& lattice)
{
    const auto& [x, y, z, w] = corner.position;
    ScreenCorner screen;
    screen.x = (x + w) * (lattice.size.width() * lattice.grid * lattice.unit);
    screen.y = (w - y) * (lattice.size.height() * lattice.grid * lattice.unit);
    screen.z = z;
    screen.w = w;
    screen.scale = corner.weights[0] + corner.weights[1] + corner.weights[2];
    screen.color = glm::dvec3(0);
    for (std::size_t i = 0; i < 3; ++i) {
        const Varyings& varyings = triangle.vertices[i].varyings;
        screen.color +=
            nearestQuotient(corner.weights[i], screen.scale) * glm::dvec3(varyings[0], varyings[1], varyings[2]);
    }
    screen.uv = glm::dvec2(0);
    return screen;
}

glm::dvec2 textureCoordinates(const Corner& corner, const ClipTriangle& triangle)
{
    const Integer scale = corner.weights[0] + corner.weights[1] + corner.weights[2];
    glm::dvec2 uv(0);
    for (std::size_t i = 0; i < 3; ++i) {
        const Varyings& varyings = triangle.vertices[i].varyings;
        uv += nearestQuotient(corner.weights[i], scale) * glm::dvec2(varyings[kVaryingUv], varyings[kVaryingUv + 1]);
    }
    return uv;
}

Lattice latticeOf(const ExactOptions& options)
{
    const std::int64_t subpixels = std::int64_t{1} << (options.snap ? options.subpixelBits : 0);
    const SampleOffset& offset = options.offset;
    if (offset.x == 0 && offset.y == 0)
        return {options.size, options.sampleGrid, subpixels, 2 * options.sampleGrid};
    // 16 units a subpixel, hence as many units a sixteenth of a pixel as there are subpixels
    return {options.size,         options.sampleGrid,  8 * subpixels, 16 * options.sampleGrid,
            offset.x * subpixels, offset.y * subpixels};
}

Snapped snap(ScreenCorner& corner, const Lattice& lattice)
{
    const std::int64_t step = lattice.subpixel;
    const Integer denominator = corner.w * step;
    const Integer x = roundHalfToEven(corner.x, denominator) * step;
    const Integer y = roundHalfToEven(corner.y, denominator) * step;
    corner.x = x * corner.w;
    corner.y = y * corner.w;
    return {static_cast<std::int64_t>(x), static_cast<std::int64_t>(y)};
}

std::int64_t doubledArea(std::span<const Snapped> polygon)
{
    std::int64_t sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Snapped& a = polygon[i];
        const Snapped& b = polygon[(i + 1) % polygon.size()];
        sum += a.x * b.y - b.x * a.y;
    }
    return sum;
}

namespace
{

/// Positive where a, b, c run clockwise on the screen (y down).
std::int64_t turn(const Snapped& a, const Snapped& b, const Snapped& c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

} // namespace

bool seesAll(std::span<const Snapped> polygon, int sign, std::size_t eye)
{
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i)
        if (turn(polygon[eye], polygon[i], polygon[(i + 1) % n]) * sign < 0)
            return false;
    return true;
}

bool isFolded(std::span<const Snapped> polygon, int sign)
{
    for (std::size_t eye = 0; eye < polygon.size(); ++eye)
        if (seesAll(polygon, sign, eye))
            return false;
    return true;
}

std::vector<std::size_t> hullCorners(std::span<const Snapped> polygon, int sign)
{
    const auto before = [&](std::size_t a, std::size_t b) {
        return std::pair(polygon[a].x, polygon[a].y) < std::pair(polygon[b].x, polygon[b].y);
    };
    const auto distance = [&](std::size_t a, std::size_t b) {
        return std::abs(polygon[a].x - polygon[b].x) + std::abs(polygon[a].y - polygon[b].y);
    };
    std::size_t leftmost = 0;
    for (std::size_t i = 1; i < polygon.size(); ++i)
        if (before(i, leftmost))
            leftmost = i;
    // gift wrapping: from corner to corner, always the one that leaves all others on the inside; of several in line
    // the farthest
    std::vector<std::size_t> hull;
    std::size_t corner = leftmost;
    do {
        hull.push_back(corner);
        std::size_t next = corner;
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const std::int64_t side = turn(polygon[corner], polygon[next], polygon[i]) * sign;
            if (distance(corner, i) > 0 &&
                (next == corner || side < 0 || (side == 0 && distance(corner, i) > distance(corner, next))))
                next = i;
        }
        corner = next;
    } while (distance(corner, leftmost) > 0);
    return hull;
}

namespace
{

int signOf(std::int64_t value) { return (value > 0) - (value < 0); }

bool holds(const std::array<Snapped, 3>& t, const Snapped& p)
{
    const int a = signOf(turn(t[0], t[1], p));
    const int b = signOf(turn(t[1], t[2], p));
    const int c = signOf(turn(t[2], t[0], p));
    return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

/// Whether two segments have a point in common, ends included.
bool meet(const Snapped& a, const Snapped& b, const Snapped& c, const Snapped& d)
{
    const auto isBetween = [](const Snapped& from, const Snapped& to, const Snapped& p) {
        return turn(from, to, p) == 0 && std::min(from.x, to.x) <= p.x && p.x <= std::max(from.x, to.x) &&
               std::min(from.y, to.y) <= p.y && p.y <= std::max(from.y, to.y);
    };
    if (isBetween(a, b, c) || isBetween(a, b, d) || isBetween(c, d, a) || isBetween(c, d, b))
        return true;
    return signOf(turn(a, b, c)) * signOf(turn(a, b, d)) < 0 && signOf(turn(c, d, a)) * signOf(turn(c, d, b)) < 0;
}

} // namespace

bool coversSquare(const std::array<Snapped, 3>& triangle, const Snapped& least, std::int64_t side, CoverageRule rule)
{
    const std::array<Snapped, 4> square{Snapped{least.x, least.y}, Snapped{least.x + side, least.y},
                                        Snapped{least.x + side, least.y + side}, Snapped{least.x, least.y + side}};
    const auto isHeld = [&](const Snapped& corner) { return holds(triangle, corner); };
    if (rule == CoverageRule::Inner)
        return std::ranges::all_of(square, isHeld);
    const auto isInSquare = [&](const Snapped& p) {
        return p.x >= least.x && p.x <= least.x + side && p.y >= least.y && p.y <= least.y + side;
    };
    if (std::ranges::any_of(square, isHeld) || std::ranges::any_of(triangle, isInSquare))
        return true;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 4; ++j)
            if (meet(triangle[i], triangle[(i + 1) % 3], square[j], square[(j + 1) % 4]))
                return true;
    return false;
}

std::vector<Columns> windingColumns(std::span<const Snapped> polygon, int sign, int row, Columns columns,
                                    const Lattice& lattice)
{
    struct Crossing {
        int column;
        int winding;
    };
    std::vector<Crossing> crossings;
    const std::int64_t y = (2 * row + 1) * lattice.unit + lattice.offsetY;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        Snapped a = polygon[i];
        Snapped b = polygon[(i + 1) % polygon.size()];
        if (a.y == b.y)
            continue;
        // clockwise on the screen: an edge going up has the inside on its right
        const int winding = b.y < a.y ? 1 : -1;
        if (b.y < a.y)
            std::swap(a, b);
        if (y < a.y || y >= b.y)
            continue;
        // column >= (x - offset - unit) / (2 unit) with x on the edge
        const std::int64_t height = b.y - a.y;
        const std::int64_t numerator = (a.x - lattice.offsetX - lattice.unit) * height + (y - a.y) * (b.x - a.x);
        const std::int64_t denominator = 2 * lattice.unit * height;
        const std::int64_t ceiling = numerator / denominator + (numerator > 0 && numerator % denominator != 0 ? 1 : 0);
        crossings.push_back({clampedTo(columns, ceiling), winding * sign});
    }
    std::sort(crossings.begin(), crossings.end(), [](const auto& a, const auto& b) { return a.column < b.column; });

    std::vector<Columns> inside;
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        winding += crossings[i].winding;
        if (winding > 0 && crossings[i].column < crossings[i + 1].column)
            inside.push_back({crossings[i].column, crossings[i + 1].column});
    }
    return inside;
}

Linear determinantWith(const ScreenCorner& b, const ScreenCorner& c, const Lattice& lattice)
{
    const Integer x = b.y * c.w - c.y * b.w;
    const Integer y = c.x * b.w - b.x * c.w;
    const std::int64_t unit = lattice.unit;
    return {2 * x * unit, 2 * y * unit,
            x * (unit + lattice.offsetX) + y * (unit + lattice.offsetY) + b.x * c.y - c.x * b.y};
}

Integer determinant(const std::array<ScreenCorner, 3>& t)
{
    const auto& [a, b, c] = t;
    return a.x * (b.y * c.w - c.y * b.w) + a.y * (c.x * b.w - b.x * c.w) + a.w * (b.x * c.y - c.x * b.y);
}

} // namespace rasterlens::exact
