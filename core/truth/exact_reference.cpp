#include "core/truth/exact_reference.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace rasterlens {

namespace {

// Integers of any length; the first 512 bits need no allocation.
namespace mp = boost::multiprecision;
using Integer = mp::number<
    mp::cpp_int_backend<512, 0, mp::signed_magnitude, mp::unchecked, std::allocator<mp::limb_type>>, mp::et_off>;

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

/// A double with an exponent of its own: mantissa * 2^exponent, good to 2^-52.
struct Scaled {
    double mantissa = 0;
    int exponent = 0;

    [[nodiscard]] double value(int base) const { return std::ldexp(mantissa, exponent - base); }
};

Scaled scaled(const Integer& value)
{
    const auto& backend = value.backend();
    const int limbs = static_cast<int>(backend.size());
    double mantissa = 0;
    const int first = std::max(0, limbs - 3);
    for (int i = limbs - 1; i >= first; --i)
        mantissa = mantissa * 0x1p64 + static_cast<double>(backend.limbs()[i]);
    Scaled result;
    result.mantissa = std::frexp(value.sign() < 0 ? -mantissa : mantissa, &result.exponent);
    result.exponent += 64 * first;
    return result;
}

double ratio(const Integer& numerator, const Integer& denominator)
{
    const Scaled top = scaled(numerator);
    const Scaled bottom = scaled(denominator);
    return std::ldexp(top.mantissa / bottom.mantissa, top.exponent - bottom.exponent);
}

/// A linear function on the lattice of samples: perColumn * column + perRow * row + origin.
struct Linear {
    Integer perColumn;
    Integer perRow;
    Integer origin;

    [[nodiscard]] Integer onRow(int row) const { return perRow * row + origin; }
    [[nodiscard]] Integer at(int column, int row) const { return perColumn * column + onRow(row); }
};

Linear operator*(const Linear& f, const Integer& factor)
{
    return {f.perColumn * factor, f.perRow * factor, f.origin * factor};
}

Linear operator+(const Linear& f, const Linear& g)
{
    return {f.perColumn + g.perColumn, f.perRow + g.perRow, f.origin + g.origin};
}

/// Columns [begin, end).
struct Columns {
    int begin;
    int end;
};

/// The smallest column in begin..end at or right of numerator / denominator; denominator > 0.
template <typename Number>
int columnAtOrRightOf(const Number& ceiling, Columns columns)
{
    if (ceiling <= columns.begin)
        return columns.begin;
    if (ceiling >= columns.end)
        return columns.end;
    return static_cast<int>(ceiling);
}

/// Keeps the columns of a row whose displaced sample has f >= 0. The displacement (e, e^2) decides where f is 0: by
/// the slope along the row, then by the slope down; where f is 0 everywhere the sample stays.
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
    const int crossing = columnAtOrRightOf(ceiling, columns);
    (slope > 0 ? columns.begin : columns.end) = crossing;
}

/// A corner in clip space as integers with a common exponent, and the weights of A, B, C it is made of.
struct Corner {
    std::array<Integer, 4> position;  // x, y, z, w
    std::array<Integer, 3> weights;
};

/// A corner on the screen, homogeneous: x and y in units of 1 / (2 * grid * 2^bits) pixel times w.
struct ScreenCorner {
    Integer x;
    Integer y;
    Integer z;
    Integer w;
    Integer scale;  // z and w are those of clip space times this
    glm::dvec3 color;
};

/// Where the samples lie: sample (column, row) is at ((2 column + 1) * unit, (2 row + 1) * unit).
struct Lattice {
    QSize size;         // pixels
    int grid;           // samples a pixel along each axis
    int bits;           // 0 when unsnapped
    std::int64_t unit;  // 2^bits
};

/// One triangle to interpolate over: three weights that are >= 0 inside and as the perspective-correct ones to each other.
struct Piece {
    std::array<Linear, 3> weights;
    Linear depthNumerator;
    Integer depthDenominator;  // > 0
    std::array<glm::dvec3, 3> colors;
    std::int32_t face;
};

/// det[P B C] for the sample P of a column and a row.
Linear determinantWith(const ScreenCorner& b, const ScreenCorner& c, std::int64_t unit)
{
    const Integer x = (b.y * c.w - c.y * b.w) * unit;
    const Integer y = (c.x * b.w - b.x * c.w) * unit;
    return {2 * x, 2 * y, x + y + b.x * c.y - c.x * b.y};
}

/// The sign of the area on the screen (y down) is that of det[A B C], since w > 0 for all that is visible.
Integer determinant(const std::array<ScreenCorner, 3>& t)
{
    const auto& [a, b, c] = t;
    return a.x * (b.y * c.w - c.y * b.w) + a.y * (c.x * b.w - b.x * c.w) + a.w * (b.x * c.y - c.x * b.y);
}

Piece makePiece(const std::array<ScreenCorner, 3>& t, const Integer& det, const ExactOptions& options,
                std::int64_t unit, std::int32_t face)
{
    const Integer sign = det.sign();
    Piece piece{};
    piece.face = face;
    piece.depthDenominator = det * sign;
    for (std::size_t i = 0; i < 3; ++i) {
        piece.weights[i] = determinantWith(t[(i + 1) % 3], t[(i + 2) % 3], unit) * sign;
        piece.depthNumerator = piece.depthNumerator + piece.weights[i] * t[i].z;
        piece.weights[i] = piece.weights[i] * t[i].scale;
        piece.colors[i] = t[i].color;
    }
    if (options.clipZ == ClipZ::Gl) {
        piece.depthNumerator.origin += piece.depthDenominator;
        piece.depthDenominator *= 2;
    }
    return piece;
}

/// Depth and colour along one row of a piece. Every weight is a sum of two terms >= 0, so none cancels.
class RowValues
{
public:
    RowValues(const Piece& piece, int row, Columns columns) : m_piece(piece), m_columns(columns)
    {
        const int last = columns.end - 1;
        std::array<Scaled, 3> starts;
        std::array<Scaled, 3> steps;
        int base = std::numeric_limits<int>::min();
        for (std::size_t i = 0; i < 3; ++i) {
            const Linear& weight = piece.weights[i];
            m_rising[i] = weight.perColumn.sign() >= 0;
            starts[i] = scaled(weight.at(m_rising[i] ? columns.begin : last, row));
            steps[i] = scaled(mp::abs(weight.perColumn));
            base = std::max({base, starts[i].exponent, steps[i].exponent});
        }
        for (std::size_t i = 0; i < 3; ++i) {
            m_starts[i] = starts[i].value(base);
            m_steps[i] = steps[i].value(base);
        }
        m_depthFirst = ratio(piece.depthNumerator.at(columns.begin, row), piece.depthDenominator);
        const double depthLast = ratio(piece.depthNumerator.at(last, row), piece.depthDenominator);
        m_depthStep = last > columns.begin ? (depthLast - m_depthFirst) / (last - columns.begin) : 0;
    }

    [[nodiscard]] double depth(int column) const { return m_depthFirst + m_depthStep * (column - m_columns.begin); }

    [[nodiscard]] glm::dvec3 color(int column) const
    {
        glm::dvec3 sum{0};
        double total = 0;
        for (std::size_t i = 0; i < 3; ++i) {
            const int steps = m_rising[i] ? column - m_columns.begin : m_columns.end - 1 - column;
            const double weight = m_starts[i] + m_steps[i] * steps;
            sum += weight * m_piece.colors[i];
            total += weight;
        }
        return sum / total;
    }

private:
    const Piece& m_piece;
    Columns m_columns;
    std::array<bool, 3> m_rising{};
    std::array<double, 3> m_starts{};
    std::array<double, 3> m_steps{};
    double m_depthFirst = 0;
    double m_depthStep = 0;
};

/// The depth buffer: a double in front, the piece it came from behind it for the exact comparison.
class DepthBuffer
{
public:
    DepthBuffer(const ExactOptions& options, ExactFrame& frame)
        : m_test(options.depthTest), m_clear(options.depthTest == DepthTest::Greater ? 0 : 1),
          m_owners(frame.cover.size(), -1), m_frame(frame)
    {
        if (options.depthFormat != DepthFormat::Float32)
            m_codeMax = options.depthFormat == DepthFormat::Unorm16 ? 0xffff : 0xffffff;
        frame.depthClear = m_clear;
        std::fill(frame.depth.begin(), frame.depth.end(), frame.depthClear);
    }

    int addPiece(Piece piece)
    {
        m_pieces.push_back(std::move(piece));
        return static_cast<int>(m_pieces.size()) - 1;
    }
    void dropLastPiece() { m_pieces.pop_back(); }
    [[nodiscard]] const Piece& piece(int index) const { return m_pieces[static_cast<std::size_t>(index)]; }

    /// Compares and, when the fragment passes, stores.
    bool test(std::size_t sample, int pieceIndex, int column, int row, double depth)
    {
        const double value = m_codeMax > 0 ? code(pieceIndex, column, row, depth) / m_codeMax : depth;
        if (!passes(sample, pieceIndex, column, row, value))
            return false;
        m_frame.depth[sample] = value;
        m_owners[sample] = pieceIndex;
        return true;
    }

private:
    bool passes(std::size_t sample, int pieceIndex, int column, int row, double value) const
    {
        if (m_test == DepthTest::Always || m_test == DepthTest::None)
            return true;
        const int order = compare(sample, pieceIndex, column, row, value);
        return m_test == DepthTest::Less ? order < 0 : m_test == DepthTest::LessEqual ? order <= 0 : order > 0;
    }

    /// The sign of new - stored.
    int compare(std::size_t sample, int pieceIndex, int column, int row, double value) const
    {
        constexpr double kFilter = 1e-14;
        const double difference = value - m_frame.depth[sample];
        if (m_codeMax > 0 || std::abs(difference) > kFilter)
            return (difference > 0) - (difference < 0);
        const int owner = m_owners[sample];
        const Piece& mine = piece(pieceIndex);
        const Integer numerator = mine.depthNumerator.at(column, row);
        if (owner < 0)
            return numerator.compare(mine.depthDenominator * m_clear);
        const Piece& stored = piece(owner);
        return Integer(numerator * stored.depthDenominator)
            .compare(Integer(stored.depthNumerator.at(column, row) * mine.depthDenominator));
    }

    /// The nearest unorm code, half up.
    double code(int pieceIndex, int column, int row, double depth) const
    {
        constexpr double kFilter = 1e-6;
        const double scaledUp = depth * m_codeMax + 0.5;
        if (std::abs(scaledUp - std::round(scaledUp)) > kFilter)
            return std::floor(scaledUp);
        const Piece& p = piece(pieceIndex);
        const Integer numerator = p.depthNumerator.at(column, row) * (2 * m_codeMax) + p.depthDenominator;
        return static_cast<double>(static_cast<std::int64_t>(floorDivide(numerator, 2 * p.depthDenominator)));
    }

    DepthTest m_test;
    int m_clear;
    int m_codeMax = 0;  // 0: exact depths
    std::vector<int> m_owners;
    std::vector<Piece> m_pieces;
    ExactFrame& m_frame;
};

/// The positions as integers with one common exponent. in: finite
std::array<Corner, 3> integerCorners(const ClipTriangle& triangle)
{
    constexpr int kMantissaBits = 53;
    std::array<std::array<std::int64_t, 4>, 3> mantissas{};
    std::array<std::array<int, 4>, 3> exponents{};
    int lowest = std::numeric_limits<int>::max();
    for (std::size_t v = 0; v < 3; ++v)
        for (std::size_t k = 0; k < 4; ++k) {
            const double value = triangle.vertices[v].positionClip[static_cast<int>(k)];
            if (value == 0)
                continue;
            int exponent = 0;
            auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), kMantissaBits));
            exponent -= kMantissaBits;
            for (; mantissa % 2 == 0; mantissa /= 2)
                ++exponent;
            mantissas[v][k] = mantissa;
            exponents[v][k] = exponent;
            lowest = std::min(lowest, exponent);
        }
    std::array<Corner, 3> corners;
    for (std::size_t v = 0; v < 3; ++v) {
        corners[v].weights[v] = 1;
        for (std::size_t k = 0; k < 4; ++k)
            if (mantissas[v][k] != 0)
                corners[v].position[k] = Integer(mantissas[v][k]) << (exponents[v][k] - lowest);
    }
    return corners;
}

/// How far a corner is inside each plane, times w: x, y, z; the one at -w (z: at the near plane) first.
Integer planeDistance(const Corner& corner, int plane, ClipZ clipZ)
{
    const Integer& value = corner.position[static_cast<std::size_t>(plane / 2)];
    const Integer& w = corner.position[3];
    if (plane == 4 && clipZ == ClipZ::D3d)
        return value;
    return plane % 2 == 0 ? Integer(w + value) : Integer(w - value);
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

std::vector<Corner> clipExactly(const std::array<Corner, 3>& corners, ClipZ clipZ)
{
    std::vector<Corner> polygon(corners.begin(), corners.end());
    for (int plane = 0; plane < 6 && polygon.size() >= 3; ++plane) {
        std::vector<Integer> distances;
        for (const Corner& corner : polygon)
            distances.push_back(planeDistance(corner, plane, clipZ));
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

/// Clip space to the lattice, homogeneous and without rounding.
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
        screen.color += ratio(corner.weights[i], screen.scale) * glm::dvec3(varyings[0], varyings[1], varyings[2]);
    }
    return screen;
}

/// A corner of a snapped polygon on the lattice.
struct Snapped {
    std::int64_t x;
    std::int64_t y;
};

/// Rounds the screen position to 1/2^bits pixel. in: w > 0
Snapped snap(ScreenCorner& corner, const Lattice& lattice)
{
    // lattice units a subpixel
    const std::int64_t step = 2 * lattice.grid;
    const Integer denominator = corner.w * step;
    const Integer x = roundHalfToEven(corner.x, denominator) * step;
    const Integer y = roundHalfToEven(corner.y, denominator) * step;
    corner.x = x * corner.w;
    corner.y = y * corner.w;
    return {static_cast<std::int64_t>(x), static_cast<std::int64_t>(y)};
}

/// Twice the area; positive where the polygon runs clockwise on the screen (y down).
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

/// The columns of one row of samples where the polygon winds round the sample in the sense of its area.
std::vector<Columns> windingColumns(std::span<const Snapped> polygon, int sign, int row, Columns columns,
                                    const Lattice& lattice)
{
    struct Crossing {
        int column;
        int winding;
    };
    std::vector<Crossing> crossings;
    const std::int64_t y = (2 * row + 1) * lattice.unit;
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
        // column >= (x - unit) / (2 unit) with x on the edge
        const std::int64_t height = b.y - a.y;
        const std::int64_t numerator = (a.x - lattice.unit) * height + (y - a.y) * (b.x - a.x);
        const std::int64_t denominator = 2 * lattice.unit * height;
        const std::int64_t ceiling = numerator / denominator + (numerator > 0 && numerator % denominator != 0 ? 1 : 0);
        crossings.push_back({columnAtOrRightOf(ceiling, columns), winding * sign});
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

/// Samples of the window, as columns and rows of the whole viewport.
struct SampleWindow {
    Columns columns;
    Columns rows;
};

/// Draws one face after the other into the frame.
class Painter
{
public:
    Painter(const ExactOptions& options, ExactFrame& frame)
        : m_options(options), m_frame(frame), m_depth(options, frame)
    {
        const int bits = options.snap ? options.subpixelBits : 0;
        m_lattice = {options.size, options.sampleGrid, bits, std::int64_t{1} << bits};
        const PixelRect& w = frame.window;
        const int n = options.sampleGrid;
        m_window = {{w.x * n, (w.x + w.width) * n}, {w.y * n, (w.y + w.height) * n}};
    }

    void draw(const ClipTriangle& triangle)
    {
        const std::array<Corner, 3> corners = integerCorners(triangle);
        if (m_options.snap)
            drawSnapped(triangle, corners);
        else
            drawUnsnapped(triangle, corners);
    }

private:
    /// Counts and refuses what culling or a zero area removes. The sign is that of the area on the screen, y down.
    bool refused(int areaSign)
    {
        if (areaSign == 0) {
            ++m_frame.degenerate;
            return true;
        }
        const bool counterClockwise = areaSign < 0;
        const bool front = counterClockwise == (m_options.winding == Winding::CounterClockwise);
        const bool culled = m_options.culling == (front ? Culling::Front : Culling::Back);
        m_frame.culled += culled;
        return culled;
    }

    void drawUnsnapped(const ClipTriangle& triangle, const std::array<Corner, 3>& corners)
    {
        std::array<ScreenCorner, 3> screen;
        for (std::size_t i = 0; i < 3; ++i)
            screen[i] = toScreen(corners[i], triangle, m_lattice);
        const Integer det = determinant(screen);
        if (refused(det.sign()))
            return;
        Piece piece = makePiece(screen, det, m_options, m_lattice.unit, static_cast<std::int32_t>(triangle.face));
        const Linear nearSide = piece.depthNumerator;
        Linear farSide = nearSide * Integer(-1);
        farSide.origin += piece.depthDenominator;

        const int index = m_depth.addPiece(std::move(piece));
        bool owns = false;
        const Columns rows = rowsOf(screen);
        for (int row = rows.begin; row < rows.end; ++row) {
            Columns columns = m_window.columns;
            for (const Linear& weight : m_depth.piece(index).weights)
                if (columns.begin < columns.end)
                    keepPositive(weight, row, columns);
            if (columns.begin < columns.end)
                keepPositive(nearSide, row, columns);
            if (columns.begin < columns.end)
                keepPositive(farSide, row, columns);
            owns |= drawColumns(index, row, columns);
        }
        if (!owns)
            m_depth.dropLastPiece();
    }

    /// Rows the face may touch; all of them when it reaches behind the eye.
    [[nodiscard]] Columns rowsOf(const std::array<ScreenCorner, 3>& screen) const
    {
        Columns rows{m_window.rows.end, m_window.rows.begin};
        for (const ScreenCorner& corner : screen) {
            if (corner.w.sign() <= 0)
                return m_window.rows;
            const Integer row = floorDivide(corner.y, corner.w * (2 * m_lattice.unit));
            rows.begin = std::min(rows.begin, columnAtOrRightOf(Integer(row - 1), m_window.rows));
            rows.end = std::max(rows.end, columnAtOrRightOf(Integer(row + 1), m_window.rows));
        }
        return rows;
    }

    void drawSnapped(const ClipTriangle& triangle, const std::array<Corner, 3>& corners)
    {
        const std::vector<Corner> clipped = clipExactly(corners, m_options.clipZ);
        if (clipped.empty()) {
            ++m_frame.outside;
            return;
        }
        m_frame.maxClipVertices = std::max(m_frame.maxClipVertices, static_cast<int>(clipped.size()));
        std::vector<ScreenCorner> screen;
        std::vector<Snapped> polygon;
        for (const Corner& corner : clipped) {
            // only (0, 0, 0, 0) is inside all planes with w = 0: the face is seen edge-on
            if (corner.position[3].sign() == 0) {
                ++m_frame.degenerate;
                return;
            }
            screen.push_back(toScreen(corner, triangle, m_lattice));
            polygon.push_back(snap(screen.back(), m_lattice));
        }
        const std::int64_t area = doubledArea(polygon);
        const int sign = (area > 0) - (area < 0);
        if (!refused(sign))
            drawPolygon(screen, polygon, sign, static_cast<std::int32_t>(triangle.face));
    }

    void drawPolygon(const std::vector<ScreenCorner>& screen, const std::vector<Snapped>& polygon, int sign,
                     std::int32_t face)
    {
        std::vector<int> fan;
        for (std::size_t i = 1; i + 1 < screen.size(); ++i) {
            const std::array<ScreenCorner, 3> corners{screen[0], screen[i], screen[i + 1]};
            const Integer det = determinant(corners);
            if (det.sign() == sign)
                fan.push_back(m_depth.addPiece(makePiece(corners, det, m_options, m_lattice.unit, face)));
        }
        const auto byY = [](const Snapped& a, const Snapped& b) { return a.y < b.y; };
        const auto [top, bottom] = std::minmax_element(polygon.begin(), polygon.end(), byY);
        const int firstRow = std::max(m_window.rows.begin, static_cast<int>(top->y / (2 * m_lattice.unit)) - 1);
        const int endRow = std::min(m_window.rows.end, static_cast<int>(bottom->y / (2 * m_lattice.unit)) + 1);
        bool owns = false;
        for (int row = firstRow; row < endRow; ++row)
            for (const Columns& columns : windingColumns(polygon, sign, row, m_window.columns, m_lattice))
                owns |= drawFan(fan, row, columns);
        for (std::size_t i = 0; i < fan.size() && !owns; ++i)
            m_depth.dropLastPiece();
    }

    /// Hands every sample of the columns to the first triangle of the fan that holds it.
    bool drawFan(const std::vector<int>& fan, int row, Columns columns)
    {
        if (fan.size() == 1)
            return drawColumns(fan.front(), row, columns);
        bool owns = false;
        std::vector<Columns> open{columns};
        for (const int index : fan) {
            std::vector<Columns> left;
            for (const Columns& gap : open) {
                Columns held = gap;
                for (const Linear& weight : m_depth.piece(index).weights)
                    if (held.begin < held.end)
                        keepPositive(weight, row, held);
                if (held.begin >= held.end) {
                    left.push_back(gap);
                    continue;
                }
                owns |= drawColumns(index, row, held);
                if (gap.begin < held.begin)
                    left.push_back({gap.begin, held.begin});
                if (held.end < gap.end)
                    left.push_back({held.end, gap.end});
            }
            open = std::move(left);
        }
        assert(open.empty());
        return owns;
    }

    /// out: whether any sample passed the depth test
    bool drawColumns(int pieceIndex, int row, Columns columns)
    {
        if (columns.begin >= columns.end)
            return false;
        const Piece& piece = m_depth.piece(pieceIndex);
        const RowValues values(piece, row, columns);
        bool owns = false;
        const std::size_t rowStart = static_cast<std::size_t>(row - m_window.rows.begin) *
                                     static_cast<std::size_t>(m_frame.width);
        for (int column = columns.begin; column < columns.end; ++column) {
            const std::size_t sample = rowStart + static_cast<std::size_t>(column - m_window.columns.begin);
            ++m_frame.cover[sample];
            if (!m_depth.test(sample, pieceIndex, column, row, values.depth(column)))
                continue;
            m_frame.id[sample] = piece.face;
            m_frame.color[sample] = values.color(column);
            owns = true;
        }
        return owns;
    }

    const ExactOptions& m_options;
    ExactFrame& m_frame;
    DepthBuffer m_depth;
    Lattice m_lattice{};
    SampleWindow m_window{};
};

bool isFinite(const ClipTriangle& triangle)
{
    for (const ClipVertex& vertex : triangle.vertices)
        for (int k = 0; k < 4; ++k)
            if (!std::isfinite(vertex.positionClip[k]))
                return false;
    return true;
}

ExactFrame emptyFrame(const ExactOptions& options)
{
    ExactFrame frame;
    frame.window = options.window.value_or(PixelRect{0, 0, options.size.width(), options.size.height()});
    frame.sampleGrid = options.sampleGrid;
    frame.width = frame.window.width * options.sampleGrid;
    frame.height = frame.window.height * options.sampleGrid;
    const std::size_t samples = static_cast<std::size_t>(frame.width) * static_cast<std::size_t>(frame.height);
    frame.cover.assign(samples, 0);
    frame.id.assign(samples, -1);
    frame.depth.assign(samples, 1);
    frame.color.assign(samples, glm::dvec3(0));
    return frame;
}

}  // namespace

ExactFrame exactReference(std::span<const ClipTriangle> triangles, const ExactOptions& options)
{
    ExactFrame frame = emptyFrame(options);
    Painter painter(options, frame);
    for (const ClipTriangle& triangle : triangles) {
        if (isFinite(triangle))
            painter.draw(triangle);
        else
            ++frame.nonFinite;
    }
    return frame;
}

ExactOptions exactOptions(const Scene& scene, const Settings& settings)
{
    ExactOptions options;
    options.size = settings.size;
    options.snap = !scene.exact && settings.numberType == NumberType::Fixed;
    options.subpixelBits = settings.subpixelBits;
    options.clipZ = settings.clipZ;
    options.culling = settings.culling;
    options.winding = settings.winding;
    options.depthTest = settings.depthTest;
    options.depthFormat = settings.depthFormat;
    options.sampleGrid = sampleGrid(settings.samples);
    options.window = scene.window;
    return options;
}

std::vector<ClipTriangle> clipSpaceTriangles(const Scene& scene)
{
    std::vector<ClipTriangle> triangles(scene.mesh.faceCount());
    for (std::size_t face = 0; face < triangles.size(); ++face) {
        triangles[face].face = static_cast<std::uint32_t>(face);
        for (std::size_t i = 0; i < 3; ++i) {
            const MeshVertex& vertex = scene.mesh.vertices[scene.mesh.indices[3 * face + i]];
            ClipVertex& out = triangles[face].vertices[i];
            out.positionClip = glm::dvec4(vertex.position);
            out.varyings = {vertex.color.r, vertex.color.g, vertex.color.b};
        }
    }
    return triangles;
}

}  // namespace rasterlens
