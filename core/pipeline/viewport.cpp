#include "core/pipeline/viewport.h"

#include "core/pipeline/unsnapped.h"

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

/// Vertices further out than this are moved: edge values must fit 64 bits even where nothing is clipped.
constexpr double kFarthestPixel = 1 << 19;

double hold(double pixels) { return std::isnan(pixels) ? 0 : std::clamp(pixels, -kFarthestPixel, kFarthestPixel); }

/// The screen coordinate in pixels, not snapped.
double toPixels(double p, double w, int size) { return (p / w * 0.5 + 0.5) * size; }

glm::dvec2 inPixels(const glm::dvec4& p, const Rules& rules)
{
    return {toPixels(p.x, p.w, rules.width - rules.viewportShort),
            toPixels(rules.screenUp * p.y, p.w, rules.height - rules.viewportShort)};
}

} // namespace

double snapToGrid(double p, double w, int size, int bits)
{
    const double unitsPerPixel = double(1 << bits);
    const double halfSize = size * unitsPerPixel / 2; // in units
    const double limit = kFarthestPixel * unitsPerPixel;
    const double estimate = (p + w) / w * halfSize;
    if (!(std::abs(estimate) < limit))
        return hold(estimate / unitsPerPixel) * unitsPerPixel;
    const double below = std::floor(estimate);
    const double fraction = estimate - below;
    if (std::abs(fraction - 0.5) > 1e-6)
        return fraction < 0.5 ? below : below + 1;
    // Close to a tie: compare with below + 1/2 by a sum of two products that are exact in double for float32 p and w.
    const double difference = p * halfSize + w * (halfSize - (below + 0.5));
    if (difference == 0)
        return std::fmod(below, 2) == 0 ? below : below + 1;
    return (difference > 0) == (w > 0) ? below + 1 : below;
}

namespace
{

ScreenVertex screenVertexAt(const glm::dvec2& position, const ClipVertex& vertex, const Rules& rules)
{
    const glm::dvec4& p = vertex.positionClip;
    ScreenVertex out;
    out.position = position + rules.screenShift;
    if (rules.rowsRounded)
        out.position.y = std::floor(out.position.y + 0.5);
    if (rules.verticesTruncated)
        out.position = glm::trunc(out.position);
    const double depth = rules.clipZ == ClipZ::Gl ? (p.w + p.z) / (2 * p.w) : p.z / p.w;
    out.depth = rules.depthRange.near + (rules.depthRange.far - rules.depthRange.near) * depth;
    out.invW = rules.keptW == KeptW::Inverse ? 1 / p.w : rules.keptW == KeptW::One ? 1 : p.w;
    out.varyings = vertex.varyings;
    return out;
}

} // namespace

ScreenVertex toScreen(const ClipVertex& vertex, const glm::dvec2& snapped, const Rules& rules)
{
    const double samplesPerUnit = double(rules.sampleGrid) / (1 << rules.subpixelBits);
    return screenVertexAt(snapped * samplesPerUnit, vertex, rules);
}

ScreenVertex toScreen(const ClipVertex& vertex, const Rules& rules)
{
    const glm::dvec4& p = vertex.positionClip;
    if (rules.numberType == NumberType::Fixed) {
        const glm::dvec2 snapped(
            snapToGrid(p.x, p.w, rules.width - rules.viewportShort, rules.subpixelBits),
            snapToGrid(rules.screenUp * p.y, p.w, rules.height - rules.viewportShort, rules.subpixelBits));
        return toScreen(vertex, snapped, rules);
    }
    const glm::dvec2 position = inPixels(p, rules);
    return screenVertexAt(glm::dvec2(hold(position.x), hold(position.y)) * double(rules.sampleGrid), vertex, rules);
}

glm::dvec2 unsnappedPosition(const glm::dvec4& positionClip, const Rules& rules)
{
    return inPixels(positionClip, rules) * double(rules.sampleGrid) + rules.screenShift;
}

} // namespace rasterlens
