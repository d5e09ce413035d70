#include "core/truth/exact_face.h"

#include "core/settings/depth_rules.h"

#include <algorithm>
#include <cmath>
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
    if (outline.fate == Outline::Fate::Drawn && isBiased(static_cast<std::int32_t>(triangle.face)))
        outline.left = screenPolygon(clipExactly(integers, m_options.clipZ, m_options.sides), triangle);
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
    for (const Corner& corner : clipped) {
        screen.push_back(toScreen(corner, triangle, m_lattice));
        if (m_options.textured)
            screen.back().uv = textureCoordinates(corner, triangle);
    }
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
    const Fraction bias = fractionOf(isBiased(outline.face) ? biasOf(outline) : 0);
    for (std::size_t i = 1; i + 1 < outline.corners.size(); ++i) {
        const std::array<ScreenCorner, 3> corners{outline.corners[0], outline.corners[i], outline.corners[i + 1]};
        const Integer det = determinant(corners);
        if (det.sign() != outline.sign)
            continue;
        Piece& piece = fan.emplace_back(pieceOf(corners, det, outline.face));
        if (bias.numerator.sign() == 0)
            continue;
        piece.depthNumerator = piece.depthNumerator * bias.denominator;
        piece.depthNumerator.origin += bias.numerator * piece.depthDenominator;
        piece.depthDenominator *= bias.denominator;
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
        piece.uvs[i] = t[i].uv;
    }
    finishDepth(piece);
    return piece;
}

/// From z/w to the depth that is stored, and the sides of near and far.
void FaceSetup::finishDepth(Piece& piece) const
{
    if (m_options.clipZ == ClipZ::Gl) {
        piece.depthNumerator.origin += piece.depthDenominator;
        piece.depthDenominator *= 2;
    }
    if (m_options.sides.nearFar) {
        piece.nearSide = piece.depthNumerator;
        piece.farSide = piece.depthNumerator * Integer(-1);
        piece.farSide.origin += piece.depthDenominator;
    }
    if (!m_options.depthRange.isWhole())
        toDepthRange(piece);
}

/// From 0..1 to the depth range.
void FaceSetup::toDepthRange(Piece& piece) const
{
    const Fraction near = fractionOf(m_options.depthRange.near);
    const Fraction far = fractionOf(m_options.depthRange.far);
    const Integer atNear = near.numerator * far.denominator;
    const Integer atFar = far.numerator * near.denominator;
    piece.depthNumerator = piece.depthNumerator * Integer(atFar - atNear);
    piece.depthNumerator.origin += piece.depthDenominator * atNear;
    piece.depthDenominator *= near.denominator * far.denominator;
}

bool FaceSetup::isBiased(std::int32_t face) const
{
    return m_options.depthBias.isOn() && static_cast<std::size_t>(face) >= m_options.firstPassFaces;
}

/// The depth bias of a face, to the nearest double or so.
double FaceSetup::biasOf(const Outline& outline) const
{
    constexpr int kMantissaBits = 23; // of float32
    const DepthBias& asked = m_options.depthBias;
    std::vector<glm::dvec3> points; // samples, samples, depth
    for (const ScreenCorner& corner : outline.left.empty() ? outline.corners : outline.left) {
        const Integer sample = corner.w * (2 * m_lattice.unit);
        const double z = nearestQuotient(corner.z, corner.w);
        const double depth = m_options.clipZ == ClipZ::Gl ? (z + 1) / 2 : z;
        points.emplace_back(nearestQuotient(corner.x, sample), nearestQuotient(corner.y, sample),
                            m_options.depthRange.near + (m_options.depthRange.far - m_options.depthRange.near) * depth);
    }
    const int largest = largestDepthCode(m_options.depthFormat);
    double unit = largest > 0 ? 1.0 / largest : 0;
    glm::dvec3 normal(0);
    float deepest = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const glm::dvec3& p = points[i];
        const glm::dvec3& q = points[(i + 1) % points.size()];
        normal += glm::dvec3((p.y - q.y) * (p.z + q.z), (p.z - q.z) * (p.x + q.x), (p.x - q.x) * (p.y + q.y));
        deepest = std::max(deepest, static_cast<float>(std::abs(p.z)));
    }
    if (largest == 0 && deepest > 0)
        unit = std::exp2(std::floor(std::log2(static_cast<double>(deepest))) - kMantissaBits);
    const double slope = std::max(std::abs(normal.x), std::abs(normal.y)) / std::abs(normal.z) * m_options.sampleGrid;
    const double bias = asked.constant * unit + (asked.slope != 0 ? asked.slope * slope : 0);
    if (asked.clamp == 0)
        return bias;
    return asked.clamp > 0 ? std::min(asked.clamp, bias) : std::max(asked.clamp, bias);
}

} // namespace rasterlens::exact
