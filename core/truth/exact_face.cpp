#include "core/truth/exact_face.h"

#include <algorithm>
#include <utility>

namespace rasterlens::exact
{
namespace
{

bool hasArea(const std::vector<ScreenCorner>& polygon)
{
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
        if (determinant({polygon[0], polygon[i], polygon[i + 1]}).sign() != 0)
            return true;
    return false;
}

template <class Value>
std::vector<Value> picked(const std::vector<Value>& values, const std::vector<std::size_t>& indices)
{
    std::vector<Value> result;
    for (const std::size_t i : indices)
        result.push_back(values[i]);
    return result;
}

} // namespace

FaceSetup::FaceSetup(const ExactOptions& options) : m_options(options), m_lattice(latticeOf(options)) {}

Outline FaceSetup::outlineOf(const ClipTriangle& triangle) const
{
    const IntegerTriangle integers =
        integerTriangle(triangle, m_options.sides.smallestW, m_options.clipFromObject.value_or(glm::dmat4(1)));
    Outline outline = m_options.snap ? snappedOutline(triangle, integers) : unsnappedOutline(triangle, integers);
    outline.face = static_cast<std::int32_t>(triangle.face);
    return outline;
}

Outline::Fate FaceSetup::fateOf(int areaSign) const
{
    if (areaSign == 0)
        return Outline::Fate::Degenerate;
    const bool counterClockwise = areaSign < 0;
    const bool front = counterClockwise == (m_options.winding == Winding::CounterClockwise);
    return m_options.culling == (front ? Culling::Front : Culling::Back) ? Outline::Fate::Culled : Outline::Fate::Drawn;
}

Outline FaceSetup::unsnappedOutline(const ClipTriangle& triangle, const IntegerTriangle& integers) const
{
    Outline outline;
    outline.corners = screenPolygon(integers.corners, triangle);
    outline.sign = determinant({outline.corners[0], outline.corners[1], outline.corners[2]}).sign();
    outline.fate = fateOf(outline.sign);
    if (m_options.edgeDistance && outline.fate == Outline::Fate::Drawn)
        outline.trueEdges = pixelsOf(screenPolygon(clipExactly(integers, m_options.clipZ, m_options.sides), triangle));
    return outline;
}

Outline FaceSetup::snappedOutline(const ClipTriangle& triangle, const IntegerTriangle& integers) const
{
    Outline outline;
    const std::vector<Corner> clipped = clipExactly(integers, m_options.clipZ, m_options.sides);
    if (clipped.empty()) {
        outline.fate = Outline::Fate::Outside;
        return outline;
    }
    outline.clippedCorners = static_cast<int>(clipped.size());
    outline.corners = screenPolygon(clipped, triangle);
    // only (0, 0, 0, 0) is inside all planes with w = 0: the face is seen edge-on
    const auto atEye = [](const ScreenCorner& corner) { return corner.w.sign() == 0; };
    if (std::ranges::any_of(outline.corners, atEye)) {
        outline.fate = Outline::Fate::Degenerate;
        return outline;
    }
    const std::vector<ScreenCorner> unsnapped = m_options.edgeDistance ? outline.corners : std::vector<ScreenCorner>();
    for (ScreenCorner& corner : outline.corners)
        outline.polygon.push_back(snap(corner, m_lattice));
    const std::int64_t area = doubledArea(outline.polygon);
    outline.sign = (area > 0) - (area < 0);
    outline.fate = fateOf(outline.sign);
    // a face whose area vanishes on snapping still has true edges
    if (outline.sign != 0 ? outline.fate == Outline::Fate::Drawn : hasArea(unsnapped))
        outline.trueEdges = pixelsOf(unsnapped);
    if (outline.fate == Outline::Fate::Drawn && isFolded(outline.polygon, outline.sign)) {
        const std::vector<std::size_t> hull = hullCorners(outline.polygon, outline.sign);
        outline.corners = picked(outline.corners, hull);
        outline.polygon = picked(outline.polygon, hull);
    }
    return outline;
}

std::vector<ScreenCorner> FaceSetup::screenPolygon(std::span<const Corner> clipped, const ClipTriangle& triangle) const
{
    std::vector<ScreenCorner> screen;
    screen.reserve(clipped.size());
    for (const Corner& corner : clipped)
        screen.push_back(toScreen(corner, triangle, m_lattice));
    return screen;
}

std::vector<glm::dvec2> FaceSetup::pixelsOf(const std::vector<ScreenCorner>& polygon) const
{
    std::vector<glm::dvec2> pixels;
    for (const ScreenCorner& corner : polygon) {
        const Integer denominator = corner.w * m_lattice.unitsPerPixel();
        pixels.emplace_back(nearestQuotient(corner.x, denominator), nearestQuotient(corner.y, denominator));
    }
    return pixels;
}

std::vector<Piece> FaceSetup::fanOf(const Outline& outline) const
{
    std::vector<Piece> fan;
    for (std::size_t i = 1; i + 1 < outline.corners.size(); ++i) {
        const std::array<ScreenCorner, 3> corners{outline.corners[0], outline.corners[i], outline.corners[i + 1]};
        const Integer det = determinant(corners);
        if (det.sign() == outline.sign)
            fan.push_back(pieceOf(corners, det, outline.face));
    }
    return fan;
}

Piece FaceSetup::pieceOf(const std::array<ScreenCorner, 3>& t, const Integer& det, std::int32_t face) const
{
    const Integer sign = det.sign();
    Piece piece{};
    piece.face = face;
    piece.depthDenominator = det * sign;
    for (std::size_t i = 0; i < 3; ++i) {
        piece.weights[i] = determinantWith(t[(i + 1) % 3], t[(i + 2) % 3], m_lattice) * sign;
        piece.depthNumerator = piece.depthNumerator + piece.weights[i] * t[i].z;
        piece.weights[i] = piece.weights[i] * t[i].scale;
        piece.colors[i] = t[i].color;
    }
    if (m_options.clipZ == ClipZ::Gl) {
        piece.depthNumerator.origin += piece.depthDenominator;
        piece.depthDenominator *= 2;
    }
    return piece;
}

} // namespace rasterlens::exact
