#pragma once
#include "core/pipeline/frame.h"
#include "core/pipeline/geometry.h"
#include "core/pipeline/shading.h"
#include "core/scene/texel_border.h"
#include "core/settings/depth_rules.h"
#include "core/tiled/tile_data.h"

#include <array>
#include <span>

namespace rasterlens::tiled
{

/// What the tiles' texture coordinates in texels may be off by beside what their planes lose, in units of 2^-24, and
/// the rule of texel borders.
struct AxisErrors {
    double borderShare, borderReach; ///< texel_border.h; filters know no borders
    double perLargest;               ///< times the largest coordinate, counted from the first texel of the triangle
    double perCoordinate;            ///< times the largest coordinate, counted from the first texel of all
    double always;
};

/// exact  Nearest texels: the share of the border's distance is that of one corner, off by at most 5 (largest + 1); the
///        scalar stages round coordinate times size, and the sum with the border's reach. A quarter more of each.
[[nodiscard]] inline AxisErrors axisErrors(TextureFilter filter)
{
    static_assert(kBorderShare * 0x1p24F <= 5);
    if (filter == TextureFilter::Nearest)
        return {double(kBorderShare), double(kBorderReach), 15, 4, 9};
    return {0, 0, 8, 2, 2};
}

/// Everything the stages of a frame read.
struct FrameJob {
    const Scene* scene = nullptr;
    Rules rules;
    Matrices matrices;
    const FaceStages* stages = nullptr;    ///< for faces that need more than the fast path has
    const Texture* plainTexture = nullptr; ///< of materials without
    TileGrid grid;
    PixelPattern pattern;
    Outputs outputs;
    int shadingVaryings = 0;   ///< floats that the shading interpolates: none where nothing is shaded
    bool masked = false;       ///< some faces may have holes
    bool leavesTexels = false; ///< some textures are not for the fast way: fastTexels()
    AxisErrors texelErrors = axisErrors(TextureFilter::Nearest);
    bool counting = false; ///< count samples: nothing hidden is skipped then
    std::uint32_t clearColor = 0;
    std::uint32_t emptyColor = 0; ///< of pixels no triangle covers
    /// One entry per tile: whether the tile is known to hold nothing but background, in the picture and in the depths.
    std::uint8_t* blank = nullptr;
    /// One entry per vertex of the mesh. Null if vertices are not kept: each face then processes its own corners.
    ScreenPoint* points = nullptr;
    /// One entry per vertex: lit colour and clip-space w. Null if the mesh already has them, or if no shading needs
    /// them.
    glm::vec4* colors = nullptr;
    std::vector<Chunk>* chunks = nullptr;
    std::uint32_t* color = nullptr; ///< the picture, row by row; this and the next three are null if not asked for
    float* depth = nullptr;
    std::int32_t* ids = nullptr;
    std::uint16_t* coverage = nullptr;
    std::uint16_t* sampleCoverage = nullptr; ///< multi-sampling: all first samples of the pixels, then all second ones

    [[nodiscard]] bool interpolates() const { return shadingVaryings > 0; }
    [[nodiscard]] bool interpolatesColor() const { return interpolates() && rules.shading == Shading::Gouraud; }
    [[nodiscard]] bool hasTexels() const { return interpolates() && rules.shading == Shading::Texture; }
    /// in   Material::texture
    [[nodiscard]] const Texture& texture(std::int32_t place) const
    {
        return place >= 0 ? scene->textures[static_cast<std::size_t>(place)] : *plainTexture;
    }
    /// Whether vertices have lit colours; else their colours are as the mesh has them.
    [[nodiscard]] bool lightsVertices() const
    {
        return scene->lit && (rules.shading == Shading::Gouraud || rules.shading == Shading::Texture);
    }
    [[nodiscard]] bool countsCoverage() const
    {
        return counting || outputs.coverage || outputs.sampleCoverage || rules.shading == Shading::Overdraw;
    }
    /// True for the usual depth test (float32, 0 to 1, the smaller depth wins, in both passes of two) if covered
    /// samples are not counted. Only then may hidden samples be skipped.
    [[nodiscard]] bool usualDepth() const
    {
        return rules.depthTested && rules.depthCompare == DepthCompare::Less &&
               depthCompareOf(rules, 0) == DepthCompare::Less && rules.depthFormat == DepthFormat::Float32 &&
               rules.depthRange.isWhole() && !countsCoverage();
    }
    [[nodiscard]] bool depthOnly() const { return usualDepth() && color == nullptr && ids == nullptr; }
    /// True if samples may be coloured at once: nothing but the colour depends on which triangle won.
    [[nodiscard]] bool colorsAtOnce() const
    {
        return usualDepth() && color != nullptr && ids == nullptr && interpolatesColor();
    }
};

/// Whether the fast way may count the texels of a texture.
[[nodiscard]] inline bool fastTexels(const Texture& texture)
{
    return !texture.clamp && texture.width <= kMostTexels && texture.height <= kMostTexels;
}

/// A triangle of the tile that won samples.
struct VisibleTriangle {
    std::uint32_t number; ///< in the tile
    std::uint32_t source;
    const Chunk* chunk;
    const void* varyings; ///< VaryingPlanes of shadings that have them; ColorPlanes of interpolated colours
    FaceUniforms uniforms;
};

/// A block and the samples of it that a triangle won.
struct BlockShare {
    std::uint16_t block;
    std::uint16_t lanes; ///< a bit each
    std::uint32_t visible;
};

/// Triangles of a tile.
struct TileBlock {
    const BinBlock* bin;
    const TexelBlock* texels;
    const Chunk* chunk;
    std::uint32_t count;
};

/// Texture coordinates in double, for those triangles of a tile of which a sample needed them.
struct PreciseTexels {
    static constexpr std::size_t kCapacity = 32;
    std::array<std::uint32_t, kCapacity> number; ///< of the triangle at this place, or kNobody
    std::array<VaryingPlanes<2>, kCapacity> planes;
};

/// The memory one thread draws tiles with; kept from frame to frame.
struct Worker {
    TileSamples samples;
    PatternSamples pattern;               ///< multi-sampling: `samples` then has the colours of pixels
    std::vector<TileBlock> blocks;        ///< of the tile, in the order of the faces
    std::vector<std::uint32_t> visibleOf; ///< of a triangle of the tile
    std::vector<VisibleTriangle> visible;
    LargeArray<BlockShare> shares; ///< as many as can be
    std::size_t shareCount = 0;
    std::uint32_t resolvedSubtiles = 0; ///< a bit each: their pixels have been written already
    bool full = false;                  ///< every sample of the tile that is on the target has been won

    PreciseTexels precise;

    [[nodiscard]] std::span<const BlockShare> sharesInUse() const { return {shares.data(), shareCount}; }

    Statistics::Pixels pixels;

    /// Triangles of a tile are numbered block by block.
    [[nodiscard]] const TileTriangle& triangle(std::uint32_t number) const
    {
        return blocks[number / BinBlock::kCapacity].bin->triangles[number % BinBlock::kCapacity];
    }
    [[nodiscard]] const ColorPlanes& colors(std::uint32_t number) const
    {
        return blocks[number / BinBlock::kCapacity].bin->colors[number % BinBlock::kCapacity];
    }
    [[nodiscard]] const TexelPlanes& texels(std::uint32_t number) const
    {
        return (*blocks[number / BinBlock::kCapacity].texels)[number % BinBlock::kCapacity];
    }
    [[nodiscard]] const Chunk& chunkOf(std::uint32_t number) const
    {
        return *blocks[number / BinBlock::kCapacity].chunk;
    }
};

} // namespace rasterlens::tiled
