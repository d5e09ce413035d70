// Textures multiplied with interpolated colours. Included once for each target: see README.md.
#if defined(RASTERLENS_TILED_TEXTURED_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_TEXTURED_INL_H
#undef RASTERLENS_TILED_TEXTURED_INL_H
#else
#define RASTERLENS_TILED_TEXTURED_INL_H
#endif

#include "core/tiled/blocks-inl.h"
#include "core/tiled/exact_path.h"
#include "core/tiled/factors-inl.h"
#include "core/tiled/frame_job.h"
#include "core/tiled/gouraud-inl.h"
#include "core/tiled/pattern-inl.h"
#include "core/tiled/texels-inl.h"
#include "core/tiled/texture-inl.h"
#include "core/tiled/tile_output.h"
#include "core/tiled/varyings-inl.h"

#include <bit>

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// A block's place: in the tile, and its first sample on the target.
struct BlockPlace {
    TileOrigin origin;
    std::size_t block;

    [[nodiscard]] int x() const { return origin.x + blockColumn(static_cast<int>(block)) * kBlockSide; }
    [[nodiscard]] int y() const { return origin.y + blockRow(static_cast<int>(block)) * kBlockSide; }
};

/// Texture coordinates of a triangle of the tile in double: no faster than they must be, as few samples ask for them.
inline VaryingPlanes<kUvVaryings> MakePreciseTexels(const FrameJob& job, const Worker& worker, std::uint32_t number)
{
    const ScreenTriangle triangle = screenTriangle(job, worker.chunkOf(number), worker.triangle(number).source);
    const auto& [a, b, c] = triangle.vertices;
    VaryingStage<kUvVaryings> stage;
    for (std::size_t k = 0; k < 3; ++k) {
        stage.w[k].fill(1 / triangle.vertices[k].invW);
        for (std::size_t i = 0; i < kUvVaryings; ++i)
            stage.value[k][i].fill(triangle.vertices[k].varyings[kVaryingUv + i]);
    }
    const auto toUnits = [](double samples)
                             HWY_ATTR { return hn::Set(HalfIntTag(), static_cast<std::int32_t>(samples * kUnit)); };
    const ColorPlanes& anchor = worker.colors(number);
    const auto fromCorner = [&](int sample, double corner) HWY_ATTR { return toUnits(sample + 0.5 - corner); };
    const PlaneGeometry geometry{toUnits(b.position.x - a.position.x),
                                 toUnits(b.position.y - a.position.y),
                                 toUnits(c.position.x - a.position.x),
                                 toUnits(c.position.y - a.position.y),
                                 fromCorner(anchor.x0, a.position.x),
                                 fromCorner(anchor.y0, a.position.y),
                                 hn::Set(DoubleTag(), 1 / twiceArea(a.position, b.position, c.position)),
                                 hn::Zero(HalfIntTag()),
                                 hn::Zero(HalfIntTag()),
                                 static_cast<float>(job.pattern.reach) / 16};
    VaryingPlanes<kUvVaryings> planes;
    MakeVaryingPlanes<kUvVaryings>(job.rules, geometry, stage, 1, hn::Set(HalfIntTag(), anchor.x0),
                                   hn::Set(HalfIntTag(), anchor.y0), {&planes});
    return planes;
}

HWY_NOINLINE inline const VaryingPlanes<kUvVaryings>& PreciseTexelsOf(const FrameJob& job, Worker& worker,
                                                                      std::uint32_t number)
{
    PreciseTexels& known = worker.precise;
    const std::size_t place = number % PreciseTexels::kCapacity;
    if (known.number[place] != number) {
        known.number[place] = number;
        known.planes[place] = MakePreciseTexels(job, worker, number);
    }
    return known.planes[place];
}

/// Numbers of up to 2^22 rounded to whole ones: above 2^23 a float counts in ones, below its bits.
struct RoundedLanes {
    static constexpr float kOnes = 0x1.8p23F;
    Floats counted;

    HWY_INLINE explicit RoundedLanes(Floats a) : counted(hn::Add(a, hn::Set(FloatTag(), kOnes))) {}
    HWY_INLINE Floats floats() const { return hn::Sub(counted, hn::Set(FloatTag(), kOnes)); }
    /// in   powers of two of up to 2^22: what is above them is a whole number of times there
    HWY_INLINE Ints plusModulo(int offset, int size) const
    {
        return hn::And(hn::Add(hn::BitCast(IntTag(), counted), hn::Set(IntTag(), offset)), hn::Set(IntTag(), size - 1));
    }
};

/// The texel along an axis, from the one where the coordinates begin, in a texture of any size.
HWY_INLINE Ints WrapTexel(const RoundedLanes& at, int first, int size)
{
    // Up to 2^22 no quotient is rounded to a whole number that it has not reached.
    constexpr FloatTag tag;
    const Floats sizes = hn::Set(tag, static_cast<float>(size));
    const Floats texel = hn::Add(at.floats(), hn::Set(tag, static_cast<float>(first)));
    return IntsOf(hn::Sub(texel, hn::Mul(hn::Floor(hn::Div(texel, sizes)), sizes)));
}

/// A texture, and how its texels are counted.
struct TexelGrid {
    const Texture& texture;
    int width, height;
    int rowShift; ///< of textures that have powers of two of columns and rows, or -1

    HWY_INLINE explicit TexelGrid(const Texture& t)
        : texture(t), width(t.width), height(t.height),
          rowShift(isPower(width) && isPower(height) ? std::countr_zero(static_cast<unsigned>(width)) : -1)
    {
    }

    HWY_INLINE Ints placesOf(const RoundedLanes& column, const RoundedLanes& row,
                             const std::array<std::uint16_t, 2>& first) const
    {
        if (HWY_LIKELY(rowShift >= 0))
            return hn::Add(hn::ShiftLeftSame(row.plusModulo(first[1], height), rowShift),
                           column.plusModulo(first[0], width));
        return hn::Add(hn::Mul(WrapTexel(row, first[1], height), hn::Set(IntTag(), width)),
                       WrapTexel(column, first[0], width));
    }

private:
    static bool isPower(int size) { return std::has_single_bit(static_cast<unsigned>(size)); }
};

HWY_INLINE Floats NumberOf(float number) { return hn::Set(FloatTag(), number); }
HWY_INLINE Floats NumberOf(std::int32_t bits) { return NumberOf(std::bit_cast<float>(bits)); }

/// A plane at samples relative to the anchor, rounded alike on every instruction set.
template <class Planes>
HWY_INLINE Floats PlaneAt(const Planes& planes, std::size_t i, Floats x, Floats y)
{
    return hn::Add(NumberOf(planes.origin[i]),
                   hn::Add(hn::Mul(NumberOf(planes.perX[i]), x), hn::Mul(NumberOf(planes.perY[i]), y)));
}

/// A plane at samples relative to the anchor, for results whose last bits do not matter: the multiplication and the
/// addition are fused where the instruction set can, and then round once instead of twice.
template <class Planes>
HWY_INLINE Floats FusedPlaneAt(const Planes& planes, std::size_t i, Floats x, Floats y)
{
    return hn::MulAdd(NumberOf(planes.perX[i]), x, hn::MulAdd(NumberOf(planes.perY[i]), y, NumberOf(planes.origin[i])));
}

/// A vector of samples: where they are in the texture, and what their texels are to be multiplied with.
template <TextureFilter kFilter>
struct TexturedLanes {
    Ints place;         ///< of nearest texels
    Floats u, v, level; ///< for filters
    RgbLanes factors;
};

/// Coordinates of samples in double, and which of the lanes can be counted; those of the others are 0.
struct PreciseUv {
    Floats u, v, level;
    hn::Mask<FloatTag> found;
};

HWY_NOINLINE inline PreciseUv FindPrecisely(const FrameJob& job, Worker& worker, std::uint32_t number,
                                            const BlockPlace& place, std::size_t vector)
{
    const VaryingPlanes<kUvVaryings>& planes = PreciseTexelsOf(job, worker, number);
    const Texture& texture = job.texture(static_cast<std::int32_t>(worker.colors(number).extra));
    const VaryingLanes<kUvVaryings> at = VaryingsAt(planes, place.x(), place.y(), vector);
    const auto [u, v] = at.value;
    const Floats level = MipLevel(texture, GradientOf(planes, 0, u, v, at.w));
    const bool counted = !planes.exact && !texture.clamp;
    const auto inReach = hn::And(InReach(u, texture.width), InReach(v, texture.height));
    const auto found = counted ? inReach : MaskOf(FloatTag(), 0);
    return {hn::IfThenElseZero(found, u), hn::IfThenElseZero(found, v), hn::IfThenElseZero(found, level), found};
}

/// The samples of one triangle in a block.
struct TexelFinder {
    const FrameJob& job;
    Worker& worker;
    BlockPlace block;
    std::uint32_t number;
    const ColorPlanes& colors;
    const TexelPlanes& texels;
    const TexelGrid& grid;
    std::uint32_t left = 0; ///< samples that only the scalar stages can do, a bit each

    HWY_INLINE PreciseUv precise(std::size_t vector, hn::Mask<FloatTag> wanted)
    {
        PreciseUv at = FindPrecisely(job, worker, number, block, vector);
        left |= BitsOf(FloatTag(), hn::AndNot(at.found, wanted)) << (vector * kPerVector);
        at.found = hn::And(at.found, wanted);
        return at;
    }

    /// The nearest texels; in double where the closest border between two may be on the other side.
    HWY_INLINE Ints nearest(Floats u, Floats v, std::size_t vector, hn::Mask<FloatTag> wanted)
    {
        constexpr FloatTag tag;
        constexpr IntTag intTag;
        const RoundedLanes column(u);
        const RoundedLanes row(v);
        const Floats off = hn::Max(hn::Abs(hn::Sub(u, column.floats())), hn::Abs(hn::Sub(v, row.floats())));
        const auto unsure = hn::AndNot(hn::Lt(off, hn::Set(tag, texels.certain)), wanted);
        const Ints place = grid.placesOf(column, row, texels.first);
        if (HWY_LIKELY(hn::AllFalse(tag, unsure)))
            return place;
        const PreciseUv at = precise(vector, unsure);
        return hn::IfThenElse(hn::RebindMask(intTag, unsure), TexelPlaces(grid.texture, at.u, at.v, at.found), place);
    }

    /// Filters forgive what is far below a step of colour.
    HWY_INLINE PreciseUv smooth(Floats u, Floats v, Floats w, std::size_t vector, hn::Mask<FloatTag> wanted)
    {
        constexpr FloatTag tag;
        constexpr float kEnough = 0.5F - 0x1p-10F; // a quarter of a step between black and white texels
        if (HWY_UNLIKELY(!(texels.certain >= kEnough)))
            return precise(vector, wanted);
        const auto toUv = [&](Floats at, std::size_t axis, int size) HWY_ATTR {
            const Floats first = hn::Set(tag, static_cast<float>(texels.first[axis]) + 0.5F);
            return hn::Mul(hn::Add(at, first), hn::Set(tag, 1.0F / static_cast<float>(size)));
        };
        // The quotient rule: (U/W)' = (U' - u W') / W.
        const auto derivative = [&](float ofProduct, std::int32_t ofInverseW, Floats at) HWY_ATTR {
            const Floats perW = hn::Set(tag, std::bit_cast<float>(ofInverseW));
            return hn::Mul(hn::Sub(hn::Set(tag, ofProduct), hn::Mul(at, perW)), w);
        };
        const GradientLanes inTexels{
            derivative(texels.perX[0], colors.perX[0], u), derivative(texels.perY[0], colors.perY[0], u),
            derivative(texels.perX[1], colors.perX[0], v), derivative(texels.perY[1], colors.perY[0], v)};
        return {toUv(u, 0, grid.width), toUv(v, 1, grid.height), MipLevel(inTexels), wanted};
    }

    /// in   the samples on the target
    template <TextureFilter kFilter>
    HWY_INLINE TexturedLanes<kFilter> find(Floats sampleX, Floats sampleY, std::size_t vector,
                                           hn::Mask<FloatTag> wanted)
    {
        const auto fromAnchor = [](Floats sample, int anchor) HWY_ATTR {
            return hn::Sub(sample, hn::ConvertTo(FloatTag(), hn::Set(IntTag(), anchor)));
        };
        const Floats x = fromAnchor(sampleX, colors.x0);
        const Floats y = fromAnchor(sampleY, colors.y0);
        // Nearest texels are the right ones however the coordinates are rounded.
        const auto plane = [&](const auto& planes, std::size_t i) HWY_ATTR {
            return kFilter == TextureFilter::Nearest ? FusedPlaneAt(planes, i, x, y) : PlaneAt(planes, i, x, y);
        };
        TexturedLanes<kFilter> out;
        out.factors = {PlaneAt(colors, 1, x, y), PlaneAt(colors, 2, x, y), PlaneAt(colors, 3, x, y)};
        if (HWY_UNLIKELY(colors.way == ColorWay::Perspective))
            out.factors = Scale(out.factors, hn::Div(NumberOf(1.0F), PlaneAt(colors, 0, x, y)));
        const Floats w = hn::Div(NumberOf(1.0F), plane(colors, 0));
        const Floats u = hn::Mul(plane(texels, 0), w);
        const Floats v = hn::Mul(plane(texels, 1), w);
        if constexpr (kFilter == TextureFilter::Nearest) {
            out.place = nearest(u, v, vector, wanted);
        } else {
            const PreciseUv smoothly = smooth(u, v, w, vector, wanted);
            out.u = smoothly.u;
            out.v = smoothly.v;
            out.level = smoothly.level;
        }
        return out;
    }
};

/// Colours of the wanted samples; those of the others are anything.
template <TextureFilter kFilter>
HWY_INLINE Uints ColorsOf(const Texture& texture, const TexturedLanes<kFilter>& at, hn::Mask<FloatTag> wanted)
{
    if constexpr (kFilter == TextureFilter::Nearest)
        return Modulate(Gather(texture.texels.data(), at.place, wanted), at.factors, wanted);
    else if constexpr (kFilter == TextureFilter::Bilinear)
        return Modulate(SampleBilinear(texture, at.u, at.v, wanted), at.factors);
    else
        return Modulate(SampleTrilinear(texture, at.u, at.v, at.level, wanted), at.factors);
}

/// What a triangle won of a block of a subtile.
struct TexturedShare {
    std::uint32_t number;
    std::uint32_t lanesAndSquare; ///< lanes, a bit each, from bit 16 on

    [[nodiscard]] std::uint32_t lanes() const { return lanesAndSquare >> 16; }
    [[nodiscard]] std::size_t square() const { return lanesAndSquare & 0xffff; }
};

/// A subtile while it is shaded, in three loops that do not wait for each other: find which triangle won which samples;
/// find where in the texture these samples lie; fetch the texels of a block together, whichever triangles they are of.
template <TextureFilter kFilter>
class TexturedSubtile
{
public:
    /// in   the first of its blocks
    /// out  its samples' colours, block by block
    HWY_INLINE TexturedSubtile(const FrameJob& job, Worker& worker, const BlockPlace& first, std::uint32_t* out)
        : m_job(job), m_worker(worker), m_first(first), m_out(out)
    {
        for (int i = 0; i < 4; ++i)
            for (std::size_t lane = 0; lane < kLanes; lane += kPerVector) {
                const auto put = [&](const std::array<float, kLanes>& pattern, int from, SampleNumbers& to) HWY_ATTR {
                    const Floats inBlock = hn::Load(FloatTag(), pattern.data() + lane);
                    hn::Store(hn::Add(inBlock, NumberOf(static_cast<float>(from + i * kBlockSide))), FloatTag(),
                              to[static_cast<std::size_t>(i)].data() + lane);
                };
                put(kPattern.floatX, first.x(), m_x);
                put(kPattern.floatY, first.y(), m_y);
            }
    }

    HWY_INLINE void shade()
    {
        const std::uint32_t* owners = m_worker.samples.owner.data() + m_first.block;
        const std::uint32_t empty = LanesWith(owners, kEmpty);
        const std::uint32_t mixed = LanesWith(owners, kNobody);
        for (std::uint32_t owned = 0xffff & ~(empty | mixed); owned != 0;) {
            const std::uint32_t number = owners[std::countr_zero(owned)];
            const std::uint32_t blocks = LanesWith(owners, number);
            shadeOwned(number, blocks);
            owned &= ~blocks;
        }
        for (std::uint32_t bits = empty | mixed; bits != 0; bits &= bits - 1)
            clear(static_cast<std::size_t>(std::countr_zero(bits)));
        if (m_job.pattern.isOn()) {
            for (std::uint32_t bits = mixed; bits != 0; bits &= bits - 1)
                shadePattern(static_cast<std::size_t>(std::countr_zero(bits)));
            return;
        }
        for (std::size_t row = 0; row < kLanes; row += 4)
            collectRow(row, mixed >> row);
        while (m_shareCount != 0)
            shadeShares();
    }

private:
    [[nodiscard]] HWY_INLINE BlockPlace place(std::size_t square) const
    {
        return {m_first.origin, m_first.block + square};
    }
    static HWY_INLINE hn::Mask<FloatTag> MaskAt(std::uint32_t bits, std::size_t v)
    {
        return MaskOf(FloatTag(), bits >> (v * kPerVector));
    }
    [[nodiscard]] HWY_INLINE const Texture& textureOf(std::uint32_t number) const
    {
        return m_job.texture(static_cast<std::int32_t>(m_worker.colors(number).extra));
    }

    HWY_INLINE TexturedLanes<kFilter> find(TexelFinder& finder, std::size_t square, std::size_t v,
                                           hn::Mask<FloatTag> wanted) const
    {
        const Floats x = hn::Load(FloatTag(), m_x[square % 4].data() + v * kPerVector);
        const Floats y = hn::Load(FloatTag(), m_y[square / 4].data() + v * kPerVector);
        return finder.find<kFilter>(x, y, v, wanted);
    }

    /// Prefetches pixels of the next subtile into the cache, one row for each block: many at once would wait for each
    /// other.
    HWY_INLINE void fetchPixels(std::size_t square) const
    {
        if (m_job.rules.sampleGrid != 1)
            return;
        const BlockPlace next{m_first.origin, std::min(m_first.block + kLanes, std::size_t(kTileBlocks - kLanes))};
        const int y = std::min(next.y() + static_cast<int>(square), m_job.rules.height - 1);
        __builtin_prefetch(m_job.color + pixelIndex(m_job, std::min(next.x(), m_job.rules.width - 1), y), 1);
    }

    HWY_INLINE void clear(std::size_t square)
    {
        fetchPixels(square);
        for (std::size_t lane = 0; lane < kLanes; lane += kPerVector)
            hn::Store(hn::Set(UintTag(), m_job.clearColor), UintTag(), m_out + square * kLanes + lane);
    }

    /// Finds which triangles won which samples of four blocks side by side. The blocks take turns, because each step
    /// for a block waits for the step before.
    HWY_INLINE void collectRow(std::size_t firstSquare, std::uint32_t mixed)
    {
        const std::uint32_t* ids = m_worker.samples.ids.data() + (m_first.block + firstSquare) * kLanes;
        std::array<std::uint32_t, 4> remaining;
        for (std::size_t i = 0; i < 4; ++i)
            remaining[i] = (mixed >> i & 1) != 0 ? 0xffff & ~LanesWith(ids + i * kLanes, kNobody) : 0;
        if (m_job.counting)
            for (std::size_t i = 0; i < 4; ++i) {
                remaining[i] &= LanesOnTarget(m_job, m_first.origin, static_cast<int>(m_first.block + firstSquare + i));
                m_worker.pixels.shaded += static_cast<unsigned>(std::popcount(remaining[i]));
                m_worker.pixels.written += static_cast<unsigned>(std::popcount(remaining[i]));
            }
        while ((remaining[0] | remaining[1] | remaining[2] | remaining[3]) != 0)
            for (std::size_t i = 0; i < 4; ++i) {
                const std::uint32_t* blockIds = ids + i * kLanes;
                const std::uint32_t number = blockIds[std::countr_zero(remaining[i]) % kLanes];
                const std::uint32_t lanes = LanesWith(blockIds, number) & remaining[i];
                m_shares[m_shareCount] = {number, lanes << 16 | static_cast<std::uint32_t>(firstSquare + i)};
                m_shareCount += lanes != 0;
                remaining[i] &= ~lanes;
            }
    }

    /// The samples of a share by the scalar stages.
    HWY_NOINLINE void colorExactly(std::uint32_t number, std::size_t square, std::uint32_t lanes)
    {
        const std::size_t block = m_first.block + square;
        ColorExactly(m_job, m_first.origin, number, block, lanes, m_worker);
        const std::uint32_t* colors = m_worker.samples.color.data() + block * kLanes;
        for (; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
            m_out[square * kLanes + lane] = colors[lane];
        }
    }

    /// Blocks, a bit each, that a triangle has to itself.
    HWY_INLINE void shadeOwned(std::uint32_t number, std::uint32_t blocks)
    {
        const ColorPlanes& planes = m_worker.colors(number);
        const TexelGrid grid(textureOf(number));
        const auto all = MaskOf(FloatTag(), 0xffff);
        for (std::uint32_t bits = blocks; bits != 0; bits &= bits - 1) {
            const auto square = static_cast<std::size_t>(std::countr_zero(bits));
            TexelFinder finder{m_job, m_worker, place(square), number, planes, m_worker.texels(number), grid};
            fetchPixels(square);
            std::uint32_t left = 0xffff;
            if (HWY_LIKELY(planes.way != ColorWay::Exact)) {
                for (std::size_t v = 0; v < kVectors; ++v)
                    hn::Store(ColorsOf<kFilter>(grid.texture, find(finder, square, v, all), all), UintTag(),
                              m_out + square * kLanes + v * kPerVector);
                left = finder.left;
            }
            if (HWY_UNLIKELY(left != 0))
                colorExactly(number, square, left);
        }
    }

    /// Multi-sampling: a block that has samples of its own, triangle by triangle, each shaded once a pixel.
    HWY_INLINE void shadePattern(std::size_t square)
    {
        const std::size_t block = m_first.block + square;
        const std::uint32_t pixels =
            m_job.counting ? LanesOnTarget(m_job, m_first.origin, static_cast<int>(block)) : 0xffff;
        ClearSamples(m_job, block, m_worker);
        ForEachNumber(m_job.pattern, m_worker, block, pixels,
                      [&](std::uint32_t number, std::uint32_t lanes, int samples) HWY_ATTR {
                          if (m_job.counting) {
                              m_worker.pixels.shaded += static_cast<unsigned>(std::popcount(lanes));
                              m_worker.pixels.written += static_cast<unsigned>(samples);
                          }
                          shadePatternShare(number, square, lanes);
                      });
        ResolveBlock(m_job.pattern, m_worker, block, m_out + square * kLanes);
    }

    HWY_INLINE void shadePatternShare(std::uint32_t number, std::size_t square, std::uint32_t lanes)
    {
        const std::size_t block = m_first.block + square;
        const ColorPlanes& planes = m_worker.colors(number);
        const TexelGrid grid(textureOf(number));
        std::uint32_t left = lanes;
        if (HWY_LIKELY(planes.way != ColorWay::Exact)) {
            TexelFinder finder{m_job, m_worker, place(square), number, planes, m_worker.texels(number), grid};
            for (std::size_t v = 0; v < kVectors; ++v) {
                const auto wanted = MaskAt(lanes, v);
                const Uints color = ColorsOf<kFilter>(grid.texture, find(finder, square, v, wanted), wanted);
                ShareColors(m_job.pattern, number, block, v * kPerVector, color, m_worker);
            }
            left &= finder.left;
        }
        if (HWY_LIKELY(left == 0))
            return;
        ColorExactly(m_job, m_first.origin, number, block, left, m_worker);
        for (; left != 0; left &= left - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(left));
            for (std::size_t s = 0; s < m_job.pattern.samples; ++s) {
                const std::size_t at = m_job.pattern.place(block * kLanes + lane, s);
                if (m_worker.pattern.ids.data()[at] == number)
                    m_worker.pattern.color.data()[at] = m_worker.samples.color[block * kLanes + lane];
            }
        }
    }

    /// Shades the shares that have the texture of the first, and keeps the others.
    HWY_INLINE void shadeShares()
    {
        const TexelGrid grid(textureOf(m_shares[0].number));
        m_waiting.fill(0);
        std::size_t kept = 0;
        for (std::size_t i = 0; i < m_shareCount; ++i) {
            const TexturedShare share = m_shares[i];
            const ColorPlanes& planes = m_worker.colors(share.number);
            if (HWY_UNLIKELY(&m_job.texture(static_cast<std::int32_t>(planes.extra)) != &grid.texture)) {
                m_shares[kept++] = share;
                continue;
            }
            const std::size_t square = share.square();
            std::uint32_t left = share.lanes();
            if (HWY_LIKELY(planes.way != ColorWay::Exact)) {
                TexelFinder finder{m_job, m_worker, place(square), share.number, planes, m_worker.texels(share.number),
                                   grid};
                for (std::size_t v = 0; v < kVectors; ++v) {
                    const auto wanted = MaskAt(share.lanes(), v);
                    keep(square * kLanes + v * kPerVector, wanted, find(finder, square, v, wanted));
                }
                left &= finder.left;
            }
            m_waiting[square] |= share.lanes() & ~left;
            if (HWY_UNLIKELY(left != 0))
                colorExactly(share.number, square, left);
        }
        m_shareCount = kept;
        for (std::size_t square = 0; square < kLanes; ++square)
            fetch(grid.texture, square);
    }

    HWY_INLINE void keep(std::size_t at, hn::Mask<FloatTag> wanted, const TexturedLanes<kFilter>& found)
    {
        constexpr FloatTag tag;
        hn::BlendedStore(found.factors.red, wanted, tag, m_red.data() + at);
        hn::BlendedStore(found.factors.green, wanted, tag, m_green.data() + at);
        hn::BlendedStore(found.factors.blue, wanted, tag, m_blue.data() + at);
        if constexpr (kFilter == TextureFilter::Nearest) {
            hn::BlendedStore(found.place, hn::RebindMask(IntTag(), wanted), IntTag(), m_texel.data() + at);
        } else {
            hn::BlendedStore(found.u, wanted, tag, m_u.data() + at);
            hn::BlendedStore(found.v, wanted, tag, m_v.data() + at);
            if constexpr (kFilter == TextureFilter::Trilinear)
                hn::BlendedStore(found.level, wanted, tag, m_level.data() + at);
        }
    }

    /// Fetches and colours what waits of a block.
    HWY_INLINE void fetch(const Texture& texture, std::size_t square)
    {
        constexpr FloatTag tag;
        for (std::size_t v = 0; v < kVectors; ++v) {
            const auto wanted = MaskAt(m_waiting[square], v);
            const std::size_t at = square * kLanes + v * kPerVector;
            TexturedLanes<kFilter> lanes;
            lanes.factors = {hn::Load(tag, m_red.data() + at), hn::Load(tag, m_green.data() + at),
                             hn::Load(tag, m_blue.data() + at)};
            if constexpr (kFilter == TextureFilter::Nearest) {
                lanes.place = hn::Load(IntTag(), m_texel.data() + at);
            } else {
                lanes.u = hn::MaskedLoad(wanted, tag, m_u.data() + at); // of the others nothing was written
                lanes.v = hn::MaskedLoad(wanted, tag, m_v.data() + at);
                if constexpr (kFilter == TextureFilter::Trilinear)
                    lanes.level = hn::MaskedLoad(wanted, tag, m_level.data() + at);
            }
            hn::BlendedStore(ColorsOf<kFilter>(texture, lanes, wanted), hn::RebindMask(UintTag(), wanted), UintTag(),
                             m_out + at);
        }
    }

    static constexpr std::size_t kSamples = std::size_t(kLanes) * kLanes;
    using Numbers = std::array<float, kSamples>;
    using SampleNumbers = std::array<std::array<float, kLanes>, 4>;

    const FrameJob& m_job;
    Worker& m_worker;
    BlockPlace m_first;
    std::uint32_t* m_out;
    std::size_t m_shareCount = 0;
    std::array<std::uint32_t, kLanes> m_waiting;      ///< samples of a block that have texels to fetch, a bit each
    std::array<TexturedShare, kSamples + 1> m_shares; ///< and one that does not count
    alignas(64) SampleNumbers m_x, m_y;               ///< of a column or a row of blocks on the target
    alignas(64) std::array<std::int32_t, kSamples> m_texel;
    alignas(64) Numbers m_u, m_v, m_level, m_red, m_green, m_blue;
};

/// A whole tile; with one sample a pixel its subtiles go into the picture at once.
template <TextureFilter kFilter>
inline void ShadeTextured(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    const bool direct = job.rules.sampleGrid == 1;
    worker.precise.number.fill(kNobody);
    for (std::size_t first = 0; first < kTileBlocks; first += kLanes) {
        alignas(64) std::array<std::uint32_t, std::size_t(kLanes) * kLanes> pixels;
        std::uint32_t* colors = direct ? pixels.data() : worker.samples.color.data() + first * kLanes;
        TexturedSubtile<kFilter>(job, worker, {origin, first}, colors).shade();
        if (!direct)
            continue;
        for (std::size_t row = 0; row < 4; ++row)
            writeBlocks(job, origin, static_cast<int>(first + 4 * row), colors + 4 * row * kLanes);
    }
}

inline void ShadeTextured(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    switch (job.rules.textureFilter) {
    case TextureFilter::Nearest: ShadeTextured<TextureFilter::Nearest>(job, worker, origin); break;
    case TextureFilter::Bilinear: ShadeTextured<TextureFilter::Bilinear>(job, worker, origin); break;
    case TextureFilter::Trilinear: ShadeTextured<TextureFilter::Trilinear>(job, worker, origin); break;
    }
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
