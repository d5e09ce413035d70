// Textures multiplied with interpolated colours. Included once for each target.
#if defined(RASTERLENS_TILED_TEXTURED_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_TEXTURED_INL_H
#undef RASTERLENS_TILED_TEXTURED_INL_H
#else
#define RASTERLENS_TILED_TEXTURED_INL_H
#endif

#include "core/rasterizers/tiled/blocks-inl.h"
#include "core/rasterizers/tiled/exact_path.h"
#include "core/rasterizers/tiled/gouraud-inl.h"
#include "core/rasterizers/tiled/kernels.h"
#include "core/rasterizers/tiled/texels-inl.h"
#include "core/rasterizers/tiled/texture-inl.h"
#include "core/rasterizers/tiled/tile_output.h"
#include "core/rasterizers/tiled/varyings-inl.h"

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
                                 hn::Zero(HalfIntTag())};
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
    HWY_INLINE Ints plus(int offset) const
    {
        constexpr int kBits = std::bit_cast<std::int32_t>(kOnes);
        return hn::Add(hn::BitCast(IntTag(), counted), hn::Set(IntTag(), offset - kBits));
    }
};

/// The texel along an axis, from the one where the coordinates begin.
HWY_INLINE Ints WrapTexel(const RoundedLanes& at, int first, int size)
{
    constexpr FloatTag tag;
    constexpr IntTag intTag;
    if (std::has_single_bit(static_cast<unsigned>(size)))
        return hn::And(at.plus(first), hn::Set(intTag, size - 1));
    // Up to 2^22 no quotient is rounded to a whole number that it has not reached.
    const Floats sizes = hn::Set(tag, static_cast<float>(size));
    const Floats texel = hn::Add(at.floats(), hn::Set(tag, static_cast<float>(first)));
    return hn::ConvertTo(intTag, hn::Sub(texel, hn::Mul(hn::Floor(hn::Div(texel, sizes)), sizes)));
}

/// A vector of samples: where they are in the texture, and the colour their texels are to be multiplied with. What
/// belongs to other triangles of the block stays as it is.
template <TextureFilter kFilter>
struct TexturedLanes {
    Ints place;         ///< of nearest texels
    Floats u, v, level; ///< for filters
    RgbLanes color;     ///< 0 to 1
};

/// Coordinates of samples in double, and which of the lanes can be counted.
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
    const auto found = hn::And(InReach(u, texture.width), InReach(v, texture.height));
    return {u, v, level, planes.exact ? MaskOf(FloatTag(), 0) : found};
}

/// The samples of one triangle in a block.
struct TexelFinder {
    const FrameJob& job;
    Worker& worker;
    BlockPlace block;
    std::uint32_t number;
    const ColorPlanes& colors;
    const TexelPlanes& texels;
    const Texture& texture;
    std::uint32_t left = 0; ///< samples that only the scalar stages can do, a bit each

    HWY_INLINE PreciseUv precise(std::size_t vector, hn::Mask<FloatTag> wanted)
    {
        PreciseUv at = FindPrecisely(job, worker, number, BlockPlace(block), vector);
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
        const Ints x = WrapTexel(column, texels.first[0], texture.width);
        const Ints y = WrapTexel(row, texels.first[1], texture.height);
        const Ints place = hn::Add(hn::Mul(y, hn::Set(intTag, texture.width)), x);
        if (HWY_LIKELY(hn::AllFalse(tag, unsure)))
            return place;
        const PreciseUv at = precise(vector, unsure);
        return hn::IfThenElse(hn::RebindMask(intTag, unsure), TexelPlaces(texture, at.u, at.v, at.found), place);
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
        return {toUv(u, 0, texture.width), toUv(v, 1, texture.height), MipLevel(inTexels), wanted};
    }

    /// in   samples of the target
    template <TextureFilter kFilter>
    HWY_INLINE void find(Ints sampleX, Ints sampleY, std::size_t vector, hn::Mask<FloatTag> wanted,
                         TexturedLanes<kFilter>& out)
    {
        constexpr FloatTag tag;
        const Floats x = hn::ConvertTo(tag, hn::Sub(sampleX, hn::Set(IntTag(), colors.x0)));
        const Floats y = hn::ConvertTo(tag, hn::Sub(sampleY, hn::Set(IntTag(), colors.y0)));
        const auto number = [](auto bits) HWY_ATTR { return hn::Set(FloatTag(), std::bit_cast<float>(bits)); };
        const auto plane = [&](const auto& planes, std::size_t i) HWY_ATTR {
            return hn::Add(number(planes.origin[i]),
                           hn::Add(hn::Mul(number(planes.perX[i]), x), hn::Mul(number(planes.perY[i]), y)));
        };
        const auto keep = [&](Floats& to, Floats value) HWY_ATTR { to = hn::IfThenElse(wanted, value, to); };
        const Floats w = hn::Div(hn::Set(tag, 1.0F), plane(colors, 0));
        RgbLanes color{plane(colors, 1), plane(colors, 2), plane(colors, 3)};
        if (HWY_UNLIKELY(colors.way == ColorWay::Perspective))
            color = Scale(color, w);
        keep(out.color.red, color.red);
        keep(out.color.green, color.green);
        keep(out.color.blue, color.blue);
        const Floats u = hn::Mul(plane(texels, 0), w);
        const Floats v = hn::Mul(plane(texels, 1), w);
        if constexpr (kFilter == TextureFilter::Nearest) {
            out.place = hn::IfThenElse(hn::RebindMask(IntTag(), wanted), nearest(u, v, vector, wanted), out.place);
        } else {
            const PreciseUv at = smooth(u, v, w, vector, wanted);
            keep(out.u, at.u);
            keep(out.v, at.v);
            if constexpr (kFilter == TextureFilter::Trilinear)
                keep(out.level, at.level);
        }
    }
};

/// A block while it is shaded: each triangle says where in the texture its samples are, and texels are fetched for all
/// of them together.
template <TextureFilter kFilter>
class TexturedBlock
{
public:
    /// out  background where nobody won
    HWY_INLINE TexturedBlock(const FrameJob& job, Worker& worker, const BlockPlace& place)
        : m_job(job), m_worker(worker), m_place(place)
    {
        const std::uint32_t owner = worker.samples.owner[place.block];
        for (std::size_t v = 0; v < kVectors; ++v) {
            const std::size_t lane = v * kPerVector;
            m_x[v] = hn::Add(hn::Load(IntTag(), kPattern.x.data() + lane), hn::Set(IntTag(), place.x()));
            m_y[v] = hn::Add(hn::Load(IntTag(), kPattern.y.data() + lane), hn::Set(IntTag(), place.y()));
            m_color[v] = hn::Set(UintTag(), job.clearColor);
            m_ids[v] = owner != kNobody ? hn::Set(UintTag(), owner) : hn::Load(UintTag(), ids() + lane);
        }
    }

    /// out  the colours of its samples
    HWY_INLINE void shade(std::uint32_t* out)
    {
        const std::uint32_t owner = m_worker.samples.owner[m_place.block];
        std::uint32_t remaining = owner == kEmpty ? 0 : 0xffff & ~lanesOf(kNobody);
        if (m_job.counting) {
            remaining &= LanesOnTarget(m_job, m_place.origin, static_cast<int>(m_place.block));
            m_worker.pixels.shaded += static_cast<unsigned>(std::popcount(remaining));
            m_worker.pixels.written += static_cast<unsigned>(std::popcount(remaining));
        }
        while (remaining != 0) {
            const std::uint32_t number = owner != kNobody ? owner : ids()[std::countr_zero(remaining)];
            const std::uint32_t lanes = lanesOf(number);
            add(number, lanes & remaining);
            remaining &= ~lanes;
        }
        fetch();
        store(out);
    }

private:
    [[nodiscard]] HWY_INLINE const std::uint32_t* ids() const
    {
        return m_worker.samples.ids.data() + m_place.block * kLanes;
    }
    [[nodiscard]] HWY_INLINE std::uint32_t* colors() const
    {
        return m_worker.samples.color.data() + m_place.block * kLanes;
    }
    HWY_INLINE void store(std::uint32_t* to) const
    {
        for (std::size_t v = 0; v < kVectors; ++v)
            hn::Store(m_color[v], UintTag(), to + v * kPerVector);
    }
    static HWY_INLINE hn::Mask<FloatTag> MaskAt(std::uint32_t bits, std::size_t v)
    {
        return MaskOf(FloatTag(), bits >> (v * kPerVector));
    }

    /// Samples that hold the number, a bit each.
    HWY_INLINE std::uint32_t lanesOf(std::uint32_t number) const
    {
        std::uint32_t lanes = 0;
        for (std::size_t v = 0; v < kVectors; ++v)
            lanes |= BitsOf(UintTag(), hn::Eq(m_ids[v], hn::Set(UintTag(), number))) << (v * kPerVector);
        return lanes;
    }

    /// The samples that a triangle won.
    HWY_INLINE void add(std::uint32_t number, std::uint32_t won)
    {
        const ColorPlanes& planes = m_worker.colors(number);
        if (HWY_UNLIKELY(planes.way == ColorWay::Exact)) {
            colorExactly(number, won);
            return;
        }
        const Texture& texture = m_job.texture(static_cast<std::int32_t>(planes.extra));
        if (HWY_UNLIKELY(m_waiting != 0 && m_texture != &texture))
            fetch();
        m_texture = &texture;
        TexelFinder finder{m_job, m_worker, m_place, number, planes, m_worker.texels(number), texture};
        for (std::size_t v = 0; v < kVectors; ++v)
            finder.find(m_x[v], m_y[v], v, MaskAt(won, v), m_lanes[v]);
        m_waiting |= won & ~finder.left;
        if (HWY_UNLIKELY((won & finder.left) != 0))
            colorExactly(number, won & finder.left);
    }

    HWY_INLINE void colorExactly(std::uint32_t number, std::uint32_t lanes)
    {
        store(colors());
        ColorExactly(m_job, m_place.origin, number, m_place.block, lanes, m_worker);
        for (std::size_t v = 0; v < kVectors; ++v)
            m_color[v] = hn::Load(UintTag(), colors() + v * kPerVector);
    }

    HWY_INLINE RgbLanes texels(const TexturedLanes<kFilter>& at, hn::Mask<FloatTag> wanted) const
    {
        if constexpr (kFilter == TextureFilter::Nearest)
            return Unpack(hn::GatherIndex(UintTag(), m_texture->texels.data(),
                                          hn::IfThenElseZero(hn::RebindMask(IntTag(), wanted), at.place)));
        else if constexpr (kFilter == TextureFilter::Bilinear)
            return SampleBilinear(*m_texture, at.u, at.v, wanted);
        else
            return SampleTrilinear(*m_texture, at.u, at.v, at.level, wanted);
    }

    /// Fetches and colours what waits.
    HWY_INLINE void fetch()
    {
        if (m_waiting == 0)
            return;
        for (std::size_t v = 0; v < kVectors; ++v) {
            const auto wanted = MaskAt(m_waiting, v);
            const RgbLanes color = Scale(texels(m_lanes[v], wanted), m_lanes[v].color);
            m_color[v] = hn::IfThenElse(hn::RebindMask(UintTag(), wanted), PackHeld(color.red, color.green, color.blue),
                                        m_color[v]);
        }
        m_waiting = 0;
    }

    const FrameJob& m_job;
    Worker& m_worker;
    BlockPlace m_place;
    std::array<Uints, kVectors> m_ids;
    std::array<Uints, kVectors> m_color;
    std::array<Ints, kVectors> m_x, m_y; ///< samples of the target
    const Texture* m_texture = nullptr;  ///< of the samples that wait for their texels
    std::uint32_t m_waiting = 0;         ///< a bit each
    std::array<TexturedLanes<kFilter>, kVectors> m_lanes;
};

/// Brings the pixels of four blocks side by side near.
HWY_INLINE void FetchPixels(const FrameJob& job, const BlockPlace& first)
{
    const std::uint32_t* pixels = job.color + std::ptrdiff_t(first.y()) * job.rules.width + first.x();
    for (int row = 0; row < kBlockSide; ++row)
        __builtin_prefetch(pixels + std::ptrdiff_t(row) * job.rules.width, 1);
}

/// A whole tile, four blocks side by side at a time; with one sample a pixel they go into the picture at once.
template <TextureFilter kFilter>
inline void ShadeTextured(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    constexpr std::size_t kAhead = 8;
    const bool direct = job.rules.sampleGrid == 1;
    worker.precise.number.fill(kNobody);
    for (std::size_t first = 0; first < kTileBlocks; first += 4) {
        alignas(64) std::array<std::uint32_t, std::size_t(4) * kLanes> row;
        std::uint32_t* out = direct ? row.data() : worker.samples.color.data() + first * kLanes;
        if (direct)
            FetchPixels(job, {origin, std::min(first + kAhead, std::size_t(kTileBlocks) - 1)});
        for (std::size_t i = 0; i < 4; ++i)
            TexturedBlock<kFilter>(job, worker, {origin, first + i}).shade(out + i * kLanes);
        if (direct)
            writeBlocks(job, origin, static_cast<int>(first), row.data());
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
