// With 4 x 4 samples a pixel, where a triangle has a subtile to itself: sixteen pixels at a time, sample by sample, so
// that a pixel's samples are summed up in its lane and never stored. Included once for each target.
#if defined(RASTERLENS_TILED_SUBTILE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_SUBTILE_INL_H
#undef RASTERLENS_TILED_SUBTILE_INL_H
#else
#define RASTERLENS_TILED_SUBTILE_INL_H
#endif

#include "core/rasterizers/tiled/gouraud-inl.h"
#include "core/rasterizers/tiled/tile_output.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// The triangle that has all blocks of a subtile, or kNobody.
HWY_INLINE std::uint32_t SubtileOwner(const TileSamples& samples, std::size_t subtile)
{
    constexpr UintTag tag;
    const std::uint32_t* owners = samples.owner.data() + subtile * kLanes;
    for (std::size_t v = 0; v < kVectors; ++v)
        if (!hn::AllTrue(tag, hn::Eq(hn::Load(tag, owners + v * kPerVector), hn::Set(tag, owners[0]))))
            return kNobody;
    return owners[0] == kEmpty ? kNobody : owners[0];
}

/// Sums of 16 channels in the lowest 12 bits.
struct ChannelSums {
    Ints red, green, blue;
};

HWY_INLINE void AddSample(Floats red, Floats green, Floats blue, ChannelSums& sums)
{
    // 16 times the bits of 2^23 leave the lowest 24 bits alone.
    sums.red = hn::Add(sums.red, ChannelOf(red));
    sums.green = hn::Add(sums.green, ChannelOf(green));
    sums.blue = hn::Add(sums.blue, ChannelOf(blue));
}

HWY_INLINE Uints MeanOf16(const ChannelSums& sums)
{
    constexpr IntTag tag;
    const auto mean = [&](Ints sum) HWY_ATTR {
        return hn::And(hn::ShiftRight<4>(hn::Add(sum, hn::Set(tag, 8))), hn::Set(tag, 0xff));
    };
    const Ints redGreen = hn::Or(hn::ShiftLeft<16>(mean(sums.red)), hn::ShiftLeft<8>(mean(sums.green)));
    const Ints opaque = hn::Set(tag, static_cast<std::int32_t>(0xff000000U));
    return hn::BitCast(UintTag(), hn::Or3(redGreen, mean(sums.blue), opaque));
}

/// What changes in the planes from column to column of a pixel's samples, and from row to row, for a vector of pixels.
struct PixelSlopes {
    std::array<std::array<Floats, 4>, kBlockSide> alongX;
    std::array<std::array<Floats, 4>, kBlockSide> alongY;
};

/// in   the first samples of the pixels, relative to the anchor of the planes
HWY_INLINE void SpreadSlopes(const ColorPlanes& planes, Floats x, Floats y, PixelSlopes& out)
{
    constexpr FloatTag tag;
    for (std::size_t k = 0; k < kBlockSide; ++k) {
        const Floats step = hn::Set(tag, static_cast<float>(k));
        for (std::size_t i = 0; i < 4; ++i) {
            out.alongX[k][i] = hn::Mul(hn::Set(tag, planes.perX[i]), hn::Add(x, step));
            out.alongY[k][i] = hn::Mul(hn::Set(tag, planes.perY[i]), hn::Add(y, step));
        }
    }
}

/// Channels of all samples of a vector of pixels.
template <bool kPerspective>
HWY_INLINE ChannelSums SumSamples(const ColorPlanes& planes, const PixelSlopes& slopes)
{
    constexpr FloatTag tag;
    const Ints zero = hn::Zero(IntTag());
    ChannelSums sums{zero, zero, zero};
    for (const auto& alongY : slopes.alongY)
        for (const auto& alongX : slopes.alongX) {
            const auto plane = [&](std::size_t i) HWY_ATTR {
                return hn::Add(hn::Set(tag, planes.origin[i]), hn::Add(alongX[i], alongY[i]));
            };
            if constexpr (kPerspective) {
                const Floats w = hn::Div(hn::Set(tag, 1.0F), plane(0));
                AddSample(hn::Mul(plane(1), w), hn::Mul(plane(2), w), hn::Mul(plane(3), w), sums);
            } else {
                AddSample(plane(1), plane(2), plane(3), sums);
            }
        }
    return sums;
}

/// The interpolated colours of a subtile into its 4 x 4 pixels.
///
/// in     (x, y) of its first sample on the target
/// exact  the same sums as ColorAt(): the picture does not depend on who owns what
inline void ColorSubtile(const FrameJob& job, const ColorPlanes& planes, int x, int y)
{
    constexpr FloatTag tag;
    std::array<std::uint32_t, kLanes> pixels;
    PixelSlopes slopes;
    for (std::size_t v = 0; v < kVectors; ++v) {
        const auto toBlock = [&](float first, const std::array<float, kLanes>& pattern) HWY_ATTR {
            const Floats inBlocks = hn::Load(tag, pattern.data() + v * kPerVector);
            return hn::Add(hn::Set(tag, first), hn::Mul(inBlocks, hn::Set(tag, float(kBlockSide))));
        };
        SpreadSlopes(planes, toBlock(static_cast<float>(x) - planes.x0, kPattern.floatX),
                     toBlock(static_cast<float>(y) - planes.y0, kPattern.floatY), slopes);
        const ChannelSums sums =
            planes.way == ColorWay::Affine ? SumSamples<false>(planes, slopes) : SumSamples<true>(planes, slopes);
        hn::StoreU(MeanOf16(sums), UintTag(), pixels.data() + v * kPerVector);
    }
    for (int row = 0; row < 4; ++row)
        std::copy_n(pixels.begin() + 4 * row, 4, job.color + pixelIndex(job, x / 4, y / 4 + row));
}

/// Colours a subtile that a triangle has to itself.
///
/// out  false if it is to be done block by block
HWY_INLINE bool TakeSubtile(const FrameJob& job, Worker& worker, TileOrigin origin, int subtile)
{
    const std::uint32_t number = SubtileOwner(worker.samples, static_cast<std::size_t>(subtile));
    if (number == kNobody || worker.colors(number).way == ColorWay::Exact)
        return false;
    ColorSubtile(job, worker.colors(number), origin.x + blockColumn(subtile * kLanes) * kBlockSide,
                 origin.y + blockRow(subtile * kLanes) * kBlockSide);
    worker.resolvedSubtiles |= 1U << subtile;
    return true;
}

/// Brings the pixels of four blocks side by side near.
HWY_INLINE void PrefetchBlocks(const FrameJob& job, TileOrigin origin, int firstBlock)
{
    const int x = origin.x + blockColumn(firstBlock) * kBlockSide;
    const int y = origin.y + blockRow(firstBlock) * kBlockSide;
    const std::uint32_t* pixels = job.color + std::ptrdiff_t(y) * job.rules.width + x;
    for (int row = 0; row < kBlockSide; ++row)
        __builtin_prefetch(pixels + std::ptrdiff_t(row) * job.rules.width, 1);
}

/// Colours four blocks side by side; with one sample a pixel they go into the picture at once.
template <class Shader>
HWY_INLINE void ColorBlockRow(const FrameJob& job, Worker& worker, TileOrigin origin, int firstBlock)
{
    constexpr int kAhead = 8;
    const bool direct = job.rules.sampleGrid == 1;
    alignas(64) std::array<std::uint32_t, std::size_t(4) * kLanes> row;
    std::uint32_t* out = direct ? row.data() : worker.samples.color.data() + std::size_t(firstBlock) * kLanes;
    if (direct && firstBlock + kAhead < kTileBlocks)
        PrefetchBlocks(job, origin, firstBlock + kAhead);
    for (int i = 0; i < 4; ++i)
        ColorWholeBlock<Shader>(job, worker, origin, static_cast<std::size_t>(firstBlock + i), out + i * kLanes);
    if (direct)
        writeBlocks(job, origin, firstBlock, row.data());
}

/// Colours a whole tile.
template <class Shader>
inline void ColorTile(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    const bool whole = origin.x + kTileSide <= job.rules.columns() && origin.y + kTileSide <= job.rules.rows();
    const bool takesSubtiles =
        std::is_same_v<Shader, Interpolated> && whole && job.rules.sampleGrid == 4 && !job.counting;
    for (int subtile = 0; subtile < kLanes; ++subtile) {
        if (takesSubtiles && TakeSubtile(job, worker, origin, subtile))
            continue;
        for (int block = subtile * kLanes; block < (subtile + 1) * kLanes; block += 4)
            ColorBlockRow<Shader>(job, worker, origin, block);
    }
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
