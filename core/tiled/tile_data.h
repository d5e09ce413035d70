#pragma once
#include "core/pipeline/statistics.h"
#include "core/pipeline/types.h"
#include "core/scene/scene.h"
#include "core/settings/rules.h"
#include "core/tiled/large_array.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace rasterlens::tiled
{

// A tile is 64 x 64 samples, stored block by block: 4 x 4 subtiles of 16 x 16 samples, each of 4 x 4 blocks of 4 x 4
// samples. So one set of 16 lanes serves the samples of a block, the blocks of a subtile and the subtiles of a tile.
constexpr int kTileSide = 64;
constexpr int kBlockSide = 4;
constexpr int kLanes = 16;
constexpr int kTileBlocks = 256;
constexpr int kTileSamples = kTileSide * kTileSide;

/// The block at column and row of blocks in a tile.
[[nodiscard]] constexpr int blockIndex(int column, int row)
{
    return (row >> 2) * 64 + (column >> 2) * 16 + (row & 3) * 4 + (column & 3);
}

[[nodiscard]] constexpr int blockColumn(int block) { return (block >> 4 & 3) * 4 + (block & 3); }
[[nodiscard]] constexpr int blockRow(int block) { return (block >> 6) * 4 + (block >> 2 & 3); }

/// The place of a sample of a tile in its arrays.
[[nodiscard]] constexpr int sampleIndex(int x, int y)
{
    return blockIndex(x >> 2, y >> 2) * kLanes + (y & 3) * kBlockSide + (x & 3);
}

/// Units of a sample: 1/256, the grid of the edge functions.
constexpr int kUnit = 256;

/// A position on the screen in units, y down, or outside the view volume.
struct ScreenXY {
    std::int32_t x; ///< kOutside: not to be drawn as it is
    std::int32_t y; ///< or the planes it is outside of (ClipPlanes), kNotFinite
};

/// A vertex on the screen.
struct ScreenPoint {
    ScreenXY position;
    double depth;
};
static_assert(sizeof(ScreenPoint) == 16);

constexpr std::int32_t kOutside = std::numeric_limits<std::int32_t>::min();
constexpr std::int32_t kNotFinite = 1 << 30;

/// Where edges are decided in 32 bits: both gradients of each edge are at most this, in units.
///
/// exact  Over a tile an edge value changes by at most 2 * 63 * kLargestGradient < 2^29, and values from kFarInside on
///        are held there, as are those below minus that, so no value leaves 32 bits or changes its sign.
constexpr std::int32_t kLargestGradient = 1 << 22;
constexpr std::int32_t kFarInside = 1 << 30;
static_assert(2LL * 63 * kLargestGradient < kFarInside);
static_assert(kFarInside + 2LL * 63 * kLargestGradient <= std::numeric_limits<std::int32_t>::max());

/// What a tile needs to know of a triangle to find its samples: one cache line, which set-up fills from its lanes four
/// numbers at a time.
struct alignas(64) TileTriangle {
    /// What edge values change by from column to column (a) and from row to row (b). Narrow triangles have a and b of
    /// AB, BC, CA in the lower and upper halves of three numbers, and kNarrow. Others have a of AB and BC, then b of
    /// both; CA's are minus their sum. Multi-sampling: these times 16, and in the lowest 4 bits of the first three what
    /// c of AB, BC, CA lacks, in sixteenths.
    std::array<std::int32_t, 4> gradients;

    std::array<std::int32_t, 3> c; ///< edge values >> 8 with the tie threshold taken off, at the anchor
    float nearest;                 ///< no sample is nearer than this

    std::uint32_t source;        ///< a face, or kPiece + the place of a piece of the chunk
    std::uint8_t x0, y0, x1, y1; ///< bounds in samples of the tile, both ends included
    double depthOrigin;          ///< DepthPlane, at the anchor
    double depthPerX;
    double depthPerY;

    /// The first sample of the first block, in the tile: from there on all sums of depth are exact.
    [[nodiscard]] int anchorX() const { return x0 & -kBlockSide; }
    [[nodiscard]] int anchorY() const { return y0 & -kBlockSide; }

    /// Triangles beyond the numbers of the fast path are pieces, to be drawn sample by sample.
    [[nodiscard]] bool exact() const { return x1 < x0; }
    /// Whether it is looked at subtile by subtile. Otherwise in windows of up to 4 x 4 blocks, from the anchor on.
    [[nodiscard]] bool isLarge() const
    {
        return x1 / kBlockSide - x0 / kBlockSide >= kMostWindowBlocks ||
               y1 / kBlockSide - y0 / kBlockSide >= kMostWindowBlocks;
    }
    static constexpr int kMostWindowBlocks = 8; ///< along either axis
    /// Whether all gradients have 16 bits.
    [[nodiscard]] bool isNarrow() const { return gradients[3] == kNarrow; }
    static constexpr std::int32_t kNarrow = std::numeric_limits<std::int32_t>::min(); ///< no gradient
    void makeExact() { x0 = 1, x1 = 0; }
};
static_assert(sizeof(TileTriangle) == 64);

/// In the source of a triangle that is not a face of the mesh as it stands: a piece, cut by a clip plane or beyond the
/// numbers of the fast path. The rest of the bits are its place among the pieces of the chunk.
constexpr std::uint32_t kPiece = 1U << 31;

/// How a triangle's colours are found.
enum class ColorWay : std::int32_t {
    Affine,      ///< planes of colour: w changes too little to be seen, no sample lies outside of 0 to 1
    Perspective, ///< planes of colour/w and 1/w
    Exact        ///< too steep for float32: sample by sample
};

/// Colours of a triangle as planes over the target, the second cache line of its record: 1/w relative to a corner, then
/// the channels.
///
/// units  Affine: 2^-24 of a step of 255, modulo 2^32, with what rounding takes added to the origin. So sums are exact
///        in any order; outside the triangle they may wrap round, and are not used. Perspective: steps, as the bits of
///        float32. Shading texture: factors, 0 to 65535, and always 1/w, as the bits of float32.
struct alignas(64) ColorPlanes {
    std::array<std::int32_t, 4> origin; ///< at the anchor
    std::array<std::int32_t, 4> perX;
    std::array<std::int32_t, 4> perY;
    std::int32_t x0; ///< the anchor, a sample of the target
    std::int32_t y0;
    ColorWay way;
    /// Shading texture: place of the texture in the scene. Other shadings that have more than colours: the number of
    /// their VaryingPlanes, and nothing else in here.
    std::uint32_t extra;
};
static_assert(sizeof(ColorPlanes) == 64);

/// Texture coordinates of a triangle over w, as planes over the target: what shading texture has beside ColorPlanes,
/// whose anchor and 1/w it shares. They are counted in texels from half a texel behind `first`, so that rounding to a
/// whole number finds the texel, and small numbers keep small errors.
struct alignas(32) TexelPlanes {
    std::array<float, 2> origin; ///< at the anchor: u, v
    float certain;               ///< both coordinates closer than this to a whole number: the texel is the right one
    std::array<std::uint16_t, 2> first;
    std::array<float, 2> perX;
    std::array<float, 2> perY;
};
static_assert(sizeof(TexelPlanes) == 32);
constexpr int kMostTexels = 1 << 16; ///< along an axis, for TexelPlanes::first

constexpr std::uint32_t kNobody = 0xffffffffU; ///< in place of a number: no triangle
constexpr std::uint32_t kEmpty = 0xfffffffeU;  ///< in place of an owner: no triangle has touched the block yet

/// One link in the list of triangles that a chunk has for a tile, in the order of the faces.
struct BinBlock {
    static constexpr std::uint32_t kCapacity = 32;
    std::array<TileTriangle, kCapacity> triangles;
    std::array<ColorPlanes, kCapacity> colors; ///< of shadings that interpolate a colour
};

/// Texture planes of the triangles of a BinBlock, in the same order. Only shading texture has them.
using TexelBlock = std::array<TexelPlanes, BinBlock::kCapacity>;

/// Blocks of bins, by number. Their memory is kept from frame to frame.
class BinArena
{
public:
    void reset(bool textured)
    {
        m_next.clear();
        m_textured = textured;
    }
    [[nodiscard]] std::uint32_t allocate();
    [[nodiscard]] BinBlock& block(std::uint32_t number) const
    {
        return m_slabs[number / kSlabBlocks].data()[number % kSlabBlocks];
    }
    /// Null with other shadings than texture.
    [[nodiscard]] TexelBlock* texels(std::uint32_t number) const
    {
        return m_textured ? &m_texelSlabs[number / kSlabBlocks].data()[number % kSlabBlocks] : nullptr;
    }
    /// The block that follows in its bin, or kNobody.
    [[nodiscard]] std::uint32_t& next(std::uint32_t number) { return m_next[number]; }
    [[nodiscard]] std::uint32_t next(std::uint32_t number) const { return m_next[number]; }

private:
    static constexpr std::size_t kSlabBlocks = 512; // 2 MiB
    std::vector<LargeArray<BinBlock>> m_slabs;
    std::vector<LargeArray<TexelBlock>> m_texelSlabs;
    bool m_textured = false;
    std::vector<std::uint32_t> m_next; ///< apart from the blocks: a walk along a list touches few lines
};

/// Depths compare like their bits from 0 on, and what is nearer than 0 counts as 0.
[[nodiscard]] constexpr std::int32_t depthKey(float depth) { return std::max(std::bit_cast<std::int32_t>(depth), 0); }

struct Bin {
    BinBlock* lastBlock = nullptr;
    TexelBlock* lastTexels = nullptr;
    std::uint32_t first = kNobody;
    std::uint32_t last = kNobody;
    std::uint32_t used = BinBlock::kCapacity; ///< triangles in the last block
    /// Bounds with the usual depth test: no triangle of the bin is nearer than the one, and none farther than the other
    /// is seen.
    std::int32_t nearest = std::numeric_limits<std::int32_t>::max();
    std::int32_t farthest = std::numeric_limits<std::int32_t>::max();
};

/// 1/w and any kCount varyings as planes over the target, in double: a sample's come out as the scalar stages round
/// them to float32, so whatever has a threshold (texels, repeats) falls on the same side of it.
template <std::size_t kCount>
struct VaryingPlanes {
    std::array<double, kCount + 1> origin; ///< 1/w, then varyings over w
    std::array<double, kCount + 1> perX;
    std::array<double, kCount + 1> perY;
    std::int32_t x0; ///< the anchor, a sample of the target
    std::int32_t y0;
    bool exact; ///< too steep even so
};

/// A run of consecutive faces, sorted into tiles by one thread.
struct Chunk {
    std::vector<Bin> bins; ///< one a tile
    std::vector<ScreenTriangle> pieces;
    BinArena arena;
    std::uint32_t varyingCount = 0; ///< of VaryingPlanes
    Statistics::Faces faces;
    std::vector<ScreenTriangle> clipped; ///< of one face

    /// Forgets the triangles of a tile: something is in front of them all.
    void clear(Bin& bin)
    {
        if (bin.first == kNobody)
            return;
        arena.next(bin.first) = kNobody;
        bin.last = bin.first;
        bin.lastBlock = &arena.block(bin.first);
        bin.lastTexels = arena.texels(bin.first);
        bin.used = 0;
    }

    struct Slot {
        TileTriangle* triangle;
        ColorPlanes* colors;
        TexelPlanes* texels; ///< null with other shadings than texture
    };
    /// Room for one more triangle of a tile, no nearer than `nearest`.
    Slot append(Bin& bin, std::int32_t nearest)
    {
        bin.nearest = std::min(bin.nearest, nearest);
        if (bin.used == BinBlock::kCapacity)
            grow(bin);
        const Slot slot{&bin.lastBlock->triangles[bin.used], &bin.lastBlock->colors[bin.used],
                        bin.lastTexels != nullptr ? &(*bin.lastTexels)[bin.used] : nullptr};
        ++bin.used;
        __builtin_prefetch(slot.triangle + 1, 1); // the next one comes after those of many other tiles
        __builtin_prefetch(slot.colors + 1, 1);
        if (slot.texels != nullptr)
            __builtin_prefetch(slot.texels + 1, 1);
        return slot;
    }

    /// Planes of the triangle that has the number; those of a frame are all of one type.
    template <class Planes>
    [[nodiscard]] Planes& varyings(std::uint32_t number)
    {
        while (number / kPerSlab<Planes> >= m_varyings.size())
            m_varyings.emplace_back().reserve(kSlabBytes);
        return std::as_const(*this).template varyings<Planes>(number);
    }
    template <class Planes>
    [[nodiscard]] Planes& varyings(std::uint32_t number) const
    {
        auto* slab = reinterpret_cast<Planes*>(m_varyings[number / kPerSlab<Planes>].data());
        return slab[number % kPerSlab<Planes>];
    }

private:
    void grow(Bin& bin);

    static constexpr std::size_t kSlabBytes = 2U << 20;
    template <class Planes>
    static constexpr std::uint32_t kPerSlab = kSlabBytes / sizeof(Planes);
    std::vector<LargeArray<std::byte>> m_varyings;
};

/// The samples of a tile while it is drawn, block by block.
struct alignas(64) TileSamples {
    /// Depth as its bits, which order like it from 0 to 1.
    std::array<std::int32_t, kTileSamples> key;
    std::array<std::uint32_t, kTileSamples> ids; ///< number of the triangle in the tile, or kNobody
    std::array<std::uint32_t, kTileSamples> color;
    std::array<std::uint16_t, kTileSamples> coverage; ///< only if asked for
    std::array<std::int32_t, kTileBlocks> farthest;   ///< a key no sample of the block is farther than
    std::array<std::int32_t, kTileBlocks> nearest;    ///< a key no sample of the block is nearer than
    /// Number of the triangle that has the whole block, or kEmpty for a block without triangles: in both cases its
    /// keys and ids are not written yet. kNobody: they are written, and the block may belong to several triangles.
    std::array<std::uint32_t, kTileBlocks> owner;
    std::int32_t clearKey; ///< last: the arrays stay aligned
};

/// Multi-sampling: the samples of a pixel, seen from its centre. A tile then has 64 x 64 pixels.
struct PixelPattern {
    std::size_t samples = 1;
    std::int32_t reach = 0; ///< no sample is farther along an axis, in sixteenths of a pixel
    alignas(64) std::array<std::int32_t, kLanes> x{}, y{}; ///< sixteenths of a pixel
    std::array<double, kLanes> offsetX{}, offsetY{};       ///< pixels

    [[nodiscard]] bool isOn() const { return samples > 1; }
    /// How much nearer or farther than its pixel's centre a sample of a plane lies: as FaceInterpolation::depthAt() has
    /// it.
    [[nodiscard]] double depthOffset(std::size_t sample, double perX, double perY) const
    {
        return perX * offsetX[sample] + perY * offsetY[sample];
    }
    /// No depthOffset() is larger: rounding keeps the order of the terms.
    [[nodiscard]] double depthReach(double perX, double perY) const
    {
        return std::abs(perX) * (reach / 16.0) + std::abs(perY) * (reach / 16.0);
    }
    /// Where a sample of the pixel at this place of a tile is stored: block by block, in them sample by sample.
    [[nodiscard]] std::size_t place(std::size_t pixel, std::size_t sample) const
    {
        return (pixel / kLanes * samples + sample) * kLanes + pixel % kLanes;
    }
};

/// Multi-sampling: what TileSamples has for pixels, for their samples. A block that belongs to one triangle is not
/// written here.
struct PatternSamples {
    LargeArray<std::int32_t> key;
    LargeArray<std::uint32_t> ids;
    LargeArray<std::uint32_t> color;
    LargeArray<std::uint16_t> coverage;

    void reserve(std::size_t samples)
    {
        key.reserve(kTileSamples * samples);
        ids.reserve(kTileSamples * samples);
        color.reserve(kTileSamples * samples);
        coverage.reserve(kTileSamples * samples);
    }
};

/// A picture cut into tiles.
struct TileGrid {
    int pitch = kTileSide; ///< samples from tile to tile: a multiple of a block and of the sample grid
    int columns = 0;
    int rows = 0;

    [[nodiscard]] std::size_t count() const { return std::size_t(columns) * std::size_t(rows); }
    [[nodiscard]] std::size_t index(int column, int row) const
    {
        return std::size_t(row) * std::size_t(columns) + std::size_t(column);
    }
};

} // namespace rasterlens::tiled
