// With 4 x 4 samples a pixel, where a triangle has a subtile to itself: sixteen pixels at a time, sample by sample, so
// that a pixel's samples are summed up in its lane and never stored. Included once for each target.
#if defined(RASTERLENS_TILED_SUBTILE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_SUBTILE_INL_H
#undef RASTERLENS_TILED_SUBTILE_INL_H
#else
#define RASTERLENS_TILED_SUBTILE_INL_H
#endif

#include "core/rasterizers/tiled/shaders-inl.h"
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

/// Sums of channels, from bit 8 on.
struct ChannelSums {
    Ints red, green, blue;
};

HWY_INLINE void AddSample(const ColorLanes& color, ChannelSums& sums)
{
    constexpr IntTag tag;
    const Ints whole = hn::Set(tag, 0xff00);
    const auto add = [&](Floats channel, Ints& sum)
                         HWY_ATTR { sum = hn::Add(sum, hn::And(ChannelOf(channel), whole)); };
    add(color.red, sums.red);
    add(color.green, sums.green);
    add(color.blue, sums.blue);
}

HWY_INLINE Uints MeanOf16(const ChannelSums& sums)
{
    constexpr IntTag tag;
    const auto mean = [&](Ints sum) HWY_ATTR { return hn::ShiftRight<12>(hn::Add(sum, hn::Set(tag, 8 << 8))); };
    const Ints redGreen = hn::Or(hn::ShiftLeft<16>(mean(sums.red)), hn::ShiftLeft<8>(mean(sums.green)));
    const Ints opaque = hn::Set(tag, static_cast<std::int32_t>(0xff000000U));
    return hn::BitCast(UintTag(), hn::Or3(redGreen, mean(sums.blue), opaque));
}

/// The parts of the planes' values that change from column to column of samples, and from row to row, for a vector of
/// pixels.
struct PixelPlanes {
    std::array<std::array<Floats, 4>, kBlockSide> alongX;
    std::array<std::array<Floats, 4>, kBlockSide> alongY;
};

/// in   the first samples of the pixels, relative to the anchor of the planes
HWY_INLINE void SpreadPixels(const ColorPlanes& planes, Floats x, Floats y, PixelPlanes& out)
{
    for (std::size_t k = 0; k < kBlockSide; ++k) {
        const Floats step = hn::Set(FloatTag(), static_cast<float>(k));
        for (std::size_t i = 0; i < 4; ++i) {
            out.alongX[k][i] = AlongX(planes, i, hn::Add(x, step));
            out.alongY[k][i] = AlongY(planes, i, hn::Add(y, step));
        }
    }
}

/// The interpolated colours of a subtile into its 4 x 4 pixels.
///
/// in     (x, y) of its first sample on the target
/// exact  the same sums as block by block: the picture does not depend on who owns what
inline void ShadeSubtile(const FrameJob& job, const ColorPlanes& planes, int x, int y)
{
    constexpr FloatTag tag;
    std::array<std::uint32_t, kLanes> pixels;
    PixelPlanes spread;
    for (std::size_t v = 0; v < kVectors; ++v) {
        const auto toBlock = [&](float first, const std::array<float, kLanes>& pattern) HWY_ATTR {
            const Floats inBlocks = hn::Load(tag, pattern.data() + v * kPerVector);
            return hn::Add(hn::Set(tag, first), hn::Mul(inBlocks, hn::Set(tag, float(kBlockSide))));
        };
        SpreadPixels(planes, toBlock(static_cast<float>(x) - planes.x0, kPattern.floatX),
                     toBlock(static_cast<float>(y) - planes.y0, kPattern.floatY), spread);
        const Ints zero = hn::Zero(IntTag());
        ChannelSums sums{zero, zero, zero};
        for (const auto& alongY : spread.alongY)
            for (const auto& alongX : spread.alongX) {
                const auto plane = [&](std::size_t i) HWY_ATTR { return hn::Add(alongX[i], alongY[i]); };
                AddSample(ColorOf(plane(0), {plane(1), plane(2), plane(3)}), sums);
            }
        hn::StoreU(MeanOf16(sums), UintTag(), pixels.data() + v * kPerVector);
    }
    for (int row = 0; row < 4; ++row)
        std::copy_n(pixels.begin() + 4 * row, 4, job.color + pixelIndex(job, x / 4, y / 4 + row));
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
