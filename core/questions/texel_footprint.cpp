#include "core/questions/texel_footprint.h"

#include "core/pipeline/texel_path.h"

#include <algorithm>
#include <cmath>

namespace rasterlens
{
namespace
{

constexpr int kMostCells = 24; ///< texels along each axis of a patch, margins apart
constexpr double kMargin = 1;  ///< texels of the patch's level round the parallelogram
constexpr double kFarthest = 0x1p40;

/// The level whose texels are small enough to tell the parallelogram, and not so many that they cannot be told apart.
int patchLevel(const TexelFootprint& footprint, int last)
{
    const int finest = footprint.reads.empty() ? 0 : footprint.reads.front().level;
    const glm::dvec2 extent = glm::abs(footprint.right) + glm::abs(footprint.down);
    int level = 0;
    while (level < last && std::ldexp(std::max(extent.x, extent.y), -level) > kMostCells)
        ++level;
    return std::max(level, std::min(finest, last));
}

TexelPatch patchOf(const Texture& texture, const TexelFootprint& footprint)
{
    const MipLevels& mips = texture.mipLevels();
    TexelPatch patch;
    patch.level = patchLevel(footprint, static_cast<int>(mips.levels.size()) - 1);
    const MipLevels::Level& level = mips.levels[static_cast<std::size_t>(patch.level)];
    patch.levelSize = {level.width, level.height};
    const glm::dvec2 scale = glm::dvec2(level.width, level.height) / glm::dvec2(texture.width, texture.height);
    glm::dvec2 low = footprint.place * scale;
    glm::dvec2 high = low;
    for (const glm::dvec2& corner : footprint.corners()) {
        low = glm::min(low, corner * scale);
        high = glm::max(high, corner * scale);
    }
    for (const TexelRead& read : footprint.reads)
        if (read.level == patch.level) {
            low = glm::min(low, glm::dvec2(read.column, read.row));
            high = glm::max(high, glm::dvec2(read.column, read.row) + 1.0);
        }
    low = glm::floor(low - kMargin);
    high = glm::ceil(high + kMargin);
    const auto isDrawn = [](double value) { return std::abs(value) < kFarthest; };
    if (!isDrawn(low.x) || !isDrawn(low.y) || !isDrawn(high.x) || !isDrawn(high.y))
        return {};
    // a footprint may be longer than the smallest level can tell
    constexpr double kMost = 4.0 * kMostCells;
    const glm::dvec2 middle = glm::floor(footprint.place * scale);
    low = glm::max(low, middle - kMost);
    high = glm::min(high, middle + kMost);
    patch.column = low.x;
    patch.row = low.y;
    patch.size = {static_cast<int>(high.x - low.x), static_cast<int>(high.y - low.y)};
    const auto index = [&](double texel, int size) {
        return static_cast<std::int32_t>(texture.clamp ? std::clamp(texel, 0.0, size - 1.0)
                                                       : texel - std::floor(texel / size) * size);
    };
    for (int row = 0; row < patch.size.height(); ++row)
        for (int column = 0; column < patch.size.width(); ++column) {
            const std::int32_t x = index(low.x + column, level.width);
            const std::int32_t y = index(low.y + row, level.height);
            patch.texels.push_back(mips.texels[static_cast<std::size_t>(level.first + y * level.width + x)]);
        }
    return patch;
}

} // namespace

std::optional<TexelFootprint> texelFootprint(const Scene& scene, const Rules& rules, const ScreenTriangle& triangle,
                                             const FragmentStep& step)
{
    const bool readsTexels =
        rules.shading == Shading::Texture || rules.shading == Shading::Phong || rules.shading == Shading::MipLevel;
    const Texture* texture = readsTexels ? faceUniforms(scene, triangle.face, rules).texture : nullptr;
    if (texture == nullptr || !step.shaded || triangle.isLine)
        return std::nullopt;
    const FaceInterpolation interpolation(triangle, triangle.area2, rules, DepthUse::Ignored);
    UvGradient gradient = interpolation.uvGradient(step.screen, step.weights, kVaryingUv);
    Varyings varyings = step.varyings;
    if (takesOtherTexels(rules))
        takeOtherTexels(interpolation, rules, step.screen, varyings, gradient);
    const glm::dvec2 size(texture->width, texture->height);
    TexelFootprint footprint;
    footprint.size = {texture->width, texture->height};
    footprint.place = size * glm::dvec2(step.varyings[kVaryingUv], step.varyings[kVaryingUv + 1]);
    footprint.right = size * glm::dvec2(gradient.perX);
    footprint.down = size * glm::dvec2(gradient.perY);
    footprint.level = static_cast<double>(mipLevel(*texture, gradient, rules.texels));
    footprint.filter = rules.textureFilter;
    if (rules.shading != Shading::MipLevel)
        footprint.reads = texelReads(*texture, {step.varyings[kVaryingUv], step.varyings[kVaryingUv + 1]},
                                     rules.textureFilter, gradient, rules.texels);
    footprint.patch = patchOf(*texture, footprint);
    return footprint;
}

} // namespace rasterlens
