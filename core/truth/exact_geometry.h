#pragma once
#include "core/base/nearest_double.h"
#include "core/pipeline/types.h"
#include "core/settings/settings.h"
#include "core/truth/exact_frame.h"

#include <QSize>
#include <boost/multiprecision/cpp_int.hpp>
#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

// The integer geometry of the exact reference, for its sources and its tests only.

namespace rasterlens::exact
{

/// Integers of any length; the first 512 bits need no allocation.
using Integer =
    boost::multiprecision::number<boost::multiprecision::cpp_int_backend<
                                      512, 0, boost::multiprecision::signed_magnitude, boost::multiprecision::unchecked,
                                      std::allocator<boost::multiprecision::limb_type>>,
                                  boost::multiprecision::et_off>;

/// in: denominator > 0
[[nodiscard]] Integer floorDivide(const Integer& numerator, const Integer& denominator);
[[nodiscard]] Integer roundHalfToEven(const Integer& numerator, const Integer& denominator);

/// A double as a fraction, the denominator a power of two.
struct Fraction {
    Integer numerator;
    Integer denominator;
};
[[nodiscard]] Fraction fractionOf(double value);

/// A linear function on the lattice of samples: perColumn * column + perRow * row + origin.
struct Linear {
    Integer perColumn;
    Integer perRow;
    Integer origin;

    [[nodiscard]] Integer onRow(int row) const { return perRow * row + origin; }
    [[nodiscard]] Integer at(int column, int row) const { return perColumn * column + onRow(row); }
};
[[nodiscard]] Linear operator*(const Linear& f, const Integer& factor);
[[nodiscard]] Linear operator+(const Linear& f, const Linear& g);

/// Columns (or rows) [begin, end).
struct Columns {
    int begin;
    int end;

    [[nodiscard]] bool empty() const { return begin >= end; }
};

/// `column` moved into begin..end.
template <typename Number>
[[nodiscard]] int clampedTo(Columns columns, const Number& column)
{
    if (column <= columns.begin)
        return columns.begin;
    return column >= columns.end ? columns.end : static_cast<int>(column);
}

/// Keeps the columns of a row whose displaced sample has f >= 0. The displacement (e, e^2) decides where f is 0: by
/// the slope along the row, then by the slope down; where f is 0 everywhere the sample stays.
void keepPositive(const Linear& f, int row, Columns& columns);

/// A corner in clip space as integers with a common exponent, and the weights of A, B, C it is made of.
struct Corner {
    std::array<Integer, 4> position; ///< x, y, z, w
    std::array<Integer, 3> weights;
};

/// A corner on the screen, homogeneous: x and y in lattice units times w.
struct ScreenCorner {
    Integer x;
    Integer y;
    Integer z;
    Integer w;
    Integer scale; ///< z and w are those of clip space times this
    glm::dvec3 color;
    glm::dvec2 uv; ///< textureCoordinates(), where they are asked for
};

/// Where the samples lie: sample (column, row) is at ((2 column + 1) * unit, (2 row + 1) * unit) + offset.
struct Lattice {
    QSize size;            ///< pixels
    int grid;              ///< samples a pixel along each axis
    std::int64_t unit;     ///< half of the distance of two samples
    std::int64_t subpixel; ///< what positions snap to multiples of
    std::int64_t offsetX = 0;
    std::int64_t offsetY = 0;

    [[nodiscard]] std::int64_t unitsPerPixel() const { return 2 * grid * unit; }
};

/// The lattice on which all samples and all positions that snap are whole.
[[nodiscard]] Lattice latticeOf(const ExactOptions& options);

/// A corner of a snapped polygon on the lattice.
struct Snapped {
    std::int64_t x;
    std::int64_t y;
};

/// A triangle in integers: everything is divided by the same power of two.
struct IntegerTriangle {
    std::array<Corner, 3> corners;
    Integer smallestW; ///< of the clip planes
};

/// The exact products of a matrix and the triangle's positions, which lie in the space that the matrix takes: the
/// identity where they lie in clip space already.
///
/// in   finite positions and entries
[[nodiscard]] IntegerTriangle integerTriangle(const ClipTriangle& triangle, double smallestW,
                                              const glm::dmat4& clipFromPosition);

/// What is left inside the planes; empty when nothing is. The first corner is the first met walking A, B, C.
[[nodiscard]] std::vector<Corner> clipExactly(const IntegerTriangle& triangle, ClipZ clipZ, const ExactSides& sides);

/// What is left of the line from the first corner to the second inside the planes: its ends, or nothing. An end on a
/// plane is inside, so a line may be left with one point.
[[nodiscard]] std::vector<Corner> clipLineExactly(const IntegerTriangle& triangle, ClipZ clipZ,
                                                  const ExactSides& sides);

/// Clip space to the lattice, homogeneous and without rounding.
[[nodiscard]] ScreenCorner toScreen(const Corner& corner, const ClipTriangle& triangle, const Lattice& lattice);

/// The texture coordinates of a corner. in: varyings of Shading::Texture
[[nodiscard]] glm::dvec2 textureCoordinates(const Corner& corner, const ClipTriangle& triangle);

/// Rounds the screen position to 1/2^bits pixel. in: w > 0
[[nodiscard]] Snapped snap(ScreenCorner& corner, const Lattice& lattice);

/// det[P B C] for the sample P of a column and a row.
[[nodiscard]] Linear determinantWith(const ScreenCorner& b, const ScreenCorner& c, const Lattice& lattice);

/// det[A B C]: where w > 0 its sign is that of the area on the screen (y down).
[[nodiscard]] Integer determinant(const std::array<ScreenCorner, 3>& t);

/// Twice the area; positive where the polygon runs clockwise on the screen (y down).
[[nodiscard]] std::int64_t doubledArea(std::span<const Snapped> polygon);

/// Whether all sides of a polygon are to be seen from one of its corners, from within. in: sign of its area
[[nodiscard]] bool seesAll(std::span<const Snapped> polygon, int sign, std::size_t eye);

/// Whether snapping has folded a polygon over itself so far that no corner sees all of it. in: sign of its area
[[nodiscard]] bool isFolded(std::span<const Snapped> polygon, int sign);

/// The corners of the convex hull in the sense of the sign, from the leftmost (of those the topmost) on.
[[nodiscard]] std::vector<std::size_t> hullCorners(std::span<const Snapped> polygon, int sign);

/// Whether a triangle touches a closed square (conservative), or holds all of it (inner).
///
/// in  corners in any sense, with area; the square's least corner and side, on the lattice
[[nodiscard]] bool coversSquare(const std::array<Snapped, 3>& triangle, const Snapped& least, std::int64_t side,
                                CoverageRule rule);

/// The columns of one row of samples where the polygon winds round the sample in the sense of its area.
[[nodiscard]] std::vector<Columns> windingColumns(std::span<const Snapped> polygon, int sign, int row, Columns columns,
                                                  const Lattice& lattice);

} // namespace rasterlens::exact
