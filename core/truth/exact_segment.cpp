// Lines in the exact reference: the clipped and snapped ends of a face that is a line, and its samples and depths.
#include "core/truth/exact_face.h"
#include "core/truth/exact_line.h"

#include <algorithm>
#include <utility>

namespace rasterlens::exact
{
namespace
{

constexpr int kFinestBits = 8;

/// How far along a line a sample lies: top / bottom, 0..1, linear in the column of the sample or in its row.
struct Way {
    Linear top{0, 0, 0};
    Integer bottom = 1; ///< > 0
};

glm::ivec2 sampleOf(const glm::i64vec2& position)
{
    return {static_cast<int>(position.x >> kFinestBits), static_cast<int>(position.y >> kFinestBits)};
}

/// The line from one sample's centre to another's.
std::vector<glm::ivec2> centreSamples(const glm::ivec2& from, const glm::ivec2& to, const ExactOptions& options)
{
    const bool isBackward = std::pair(from.y, from.x) > std::pair(to.y, to.x);
    std::vector<glm::ivec2> samples =
        !options.lineTiesByDirection && isBackward ? exactCentreLine(to, from) : exactCentreLine(from, to);
    if (options.lineRule == LineRule::HalfOpen)
        std::erase(samples, to);
    return samples;
}

/// From `from` to `to`, both on the axis: columns, or rows.
Way wayAlong(int axis, std::int64_t scale, std::int64_t offset, std::int64_t from, std::int64_t to)
{
    const std::int64_t sign = to < from ? -1 : 1;
    if (from == to)
        return {};
    Way way;
    (axis == 0 ? way.top.perColumn : way.top.perRow) = sign * scale;
    way.top.origin = sign * (offset - from);
    way.bottom = sign * (to - from);
    return way;
}

} // namespace

bool FaceSetup::isLine(std::uint32_t face) const
{
    return std::binary_search(m_options.lines.begin(), m_options.lines.end(), face);
}

Segment FaceSetup::segmentOf(const ClipTriangle& triangle) const
{
    Segment segment;
    const IntegerTriangle integers =
        integerTriangle(triangle, m_options.sides.smallestW, m_options.clipFromObject.value_or(glm::dmat4(1)));
    const std::vector<Corner> ends = clipLineExactly(integers, m_options.clipZ, m_options.sides);
    if (ends.empty()) {
        segment.fate = Outline::Fate::Outside;
        return segment;
    }
    ExactOptions onGrid = m_options;
    onGrid.snap = true;
    onGrid.subpixelBits = m_options.snap ? m_options.subpixelBits : kFinestBits;
    const Lattice lattice = latticeOf(onGrid);
    std::array<ScreenCorner, 2> corners{toScreen(ends.front(), triangle, lattice),
                                        toScreen(ends.back(), triangle, lattice)};
    if (m_options.textured)
        for (std::size_t i = 0; i < 2; ++i)
            corners[i].uv = textureCoordinates(i == 0 ? ends.front() : ends.back(), triangle);
    std::array<glm::i64vec2, 2> at{};
    for (std::size_t i = 0; i < 2; ++i) {
        if (corners[i].w.sign() == 0) {
            segment.fate = Outline::Fate::Degenerate;
            return segment;
        }
        const Snapped snapped = snap(corners[i], lattice);
        const std::int64_t finest = (std::int64_t{1} << kFinestBits) / 2;
        at[i] = {snapped.x * finest / lattice.unit, snapped.y * finest / lattice.unit};
    }
    const glm::i64vec2 size = glm::abs(at[1] - at[0]);
    const bool byDiamonds = m_options.lineRule == LineRule::DiamondExit;
    const glm::ivec2 from = sampleOf(at[0]);
    const glm::ivec2 to = sampleOf(at[1]);
    const glm::ivec2 steps = glm::abs(to - from);
    const int axis = byDiamonds ? (size.y > size.x ? 1 : 0) : (steps.y > steps.x ? 1 : 0);
    constexpr std::int64_t kUnit = std::int64_t{1} << kFinestBits;
    const Way along = byDiamonds ? wayAlong(axis, kUnit, kUnit / 2, at[0][axis], at[1][axis])
                                 : wayAlong(axis, 1, 0, from[axis], to[axis]);
    Way end;
    end.top.origin = 1;
    const auto face = static_cast<std::int32_t>(triangle.face);
    for (const Way& way : {along, Way(), end})
        segment.pieces.push_back(pieceAlong(corners, way.top, way.bottom, face));
    for (const glm::ivec2& sample : byDiamonds ? exactLine(at[0], at[1]) : centreSamples(from, to, m_options)) {
        const Integer top = along.top.at(sample.x, sample.y);
        const int piece = top.sign() < 0 ? 1 : top > along.bottom ? 2 : 0; // a diamond may be left beside its centre
        segment.samples.push_back({sample.x, sample.y, piece});
    }
    return segment;
}

/// Along a line, depth is linear on the screen, and colours are weighted by 1 / w of the ends.
Piece FaceSetup::pieceAlong(const std::array<ScreenCorner, 2>& ends, const Linear& top, const Integer& bottom,
                            std::int32_t face) const
{
    const auto& [a, b] = ends;
    Linear left = top * Integer(-1); // of the way
    left.origin += bottom;
    Piece piece{};
    piece.face = face;
    piece.isLine = true;
    piece.weights[0] = left * Integer(a.scale * b.w);
    piece.weights[1] = top * Integer(b.scale * a.w);
    piece.depthNumerator = left * Integer(a.z * b.w) + top * Integer(b.z * a.w);
    piece.depthDenominator = bottom * a.w * b.w;
    piece.colors = {a.color, b.color, b.color};
    piece.uvs = {a.uv, b.uv, b.uv};
    finishDepth(piece);
    return piece;
}

std::vector<Piece> FaceSetup::piecesOf(const ClipTriangle& triangle) const
{
    return isLine(triangle.face) ? segmentOf(triangle).pieces : fanOf(outlineOf(triangle));
}

} // namespace rasterlens::exact
