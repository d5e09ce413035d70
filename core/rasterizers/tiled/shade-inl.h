// Second phase of a tile: every visible sample is shaded once, block by block and triangle by triangle. Included once
// for each target.
#if defined(RASTERLENS_TILED_SHADE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_SHADE_INL_H
#undef RASTERLENS_TILED_SHADE_INL_H
#else
#define RASTERLENS_TILED_SHADE_INL_H
#endif

#include "core/pipeline/shading.h"
#include "core/rasterizers/tiled/exact_path.h"
#include "core/rasterizers/tiled/gouraud-inl.h"
#include "core/rasterizers/tiled/kernels.h"
#include "core/rasterizers/tiled/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// Samples of the block that hold the number, a bit each.
HWY_INLINE std::uint32_t LanesWith(const std::uint32_t* ids, std::uint32_t number)
{
    constexpr UintTag tag;
    std::uint32_t bits = 0;
    for (std::size_t v = 0; v < kVectors; ++v)
        bits |= BitsOf(tag, hn::Eq(hn::Load(tag, ids + v * kPerVector), hn::Set(tag, number))) << (v * kPerVector);
    return bits;
}

/// The place of a triangle in worker.visible.
HWY_INLINE std::uint32_t VisiblePlace(std::uint32_t number, Worker& worker)
{
    std::uint32_t& place = worker.visibleOf[number];
    if (place != kNobody)
        return place;
    place = static_cast<std::uint32_t>(worker.visible.size());
    worker.visible.push_back({worker.triangle(number).source, 0, &worker.chunkOf(number)});
    return place;
}

/// Finds who is visible where.
inline void CollectShares(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    worker.visible.clear();
    worker.visibleOf.assign(worker.blocks.size() * BinBlock::kCapacity, kNobody);
    worker.full = true;
    const bool whole = origin.x + kTileSide <= job.rules.columns() && origin.y + kTileSide <= job.rules.rows() &&
                       job.grid.pitch == kTileSide;
    std::uint32_t lastNumber = kNobody; // neighbours tend to belong to the same triangle
    std::uint32_t lastPlace = 0;
    BlockShare* out = worker.shares.data();
    for (int block = 0; block < kTileBlocks; ++block) {
        std::uint32_t remaining = whole ? 0xffff : LanesOnTarget(job, origin, block);
        const std::uint32_t* ids = worker.samples.ids.data() + std::size_t(block) * kLanes;
        const std::uint32_t owner = worker.samples.owner[static_cast<std::size_t>(block)];
        if (owner == kEmpty) {
            worker.full = false;
            continue;
        }
        while (remaining != 0) {
            const std::uint32_t number = owner != kNobody ? owner : ids[std::countr_zero(remaining)];
            const std::uint32_t lanes = owner != kNobody ? remaining : LanesWith(ids, number) & remaining;
            remaining &= ~lanes;
            if (number == kNobody) {
                worker.full = false;
                continue;
            }
            if (number != lastNumber) {
                lastNumber = number;
                lastPlace = VisiblePlace(number, worker);
            }
            *out++ = {static_cast<std::uint16_t>(block), static_cast<std::uint16_t>(lanes), lastPlace};
        }
    }
    worker.shareCount = static_cast<std::size_t>(out - worker.shares.data());
}

/// Writes the lanes of a share that fall into vector v.
HWY_INLINE void BlendColor(Uints color, const BlockShare& share, std::size_t v, TileSamples& samples)
{
    constexpr UintTag tag;
    std::uint32_t* out = samples.color.data() + std::size_t(share.block) * kLanes + v * kPerVector;
    const auto mask = MaskOf(tag, std::uint32_t(share.lanes) >> (v * kPerVector));
    hn::Store(hn::IfThenElse(mask, color, hn::Load(tag, out)), tag, out);
}

/// Shadings with one colour a face.
inline void ShadeUniform(const FrameJob& job, Worker& worker)
{
    for (VisibleTriangle& visible : worker.visible)
        visible.color = faceUniforms(*job.scene, faceOf(*visible.chunk, visible.source), job.rules.shading).color;
    for (const BlockShare& share : worker.sharesInUse())
        for (std::size_t v = 0; v < kVectors; ++v)
            BlendColor(hn::Set(UintTag(), worker.visible[share.visible].color), share, v, worker.samples);
}

inline void ShadeDepth(const FrameJob& job, Worker& worker)
{
    constexpr IntTag tag;
    constexpr FloatTag floatTag;
    const Ints flip = hn::Set(tag, depthFlip(job.rules.depthCompare));
    for (const BlockShare& share : worker.sharesInUse())
        for (std::size_t v = 0; v < kVectors; ++v) {
            const std::int32_t* key = worker.samples.key.data() + std::size_t(share.block) * kLanes + v * kPerVector;
            const Floats depth =
                hn::Mul(hn::BitCast(floatTag, hn::Xor(hn::Load(tag, key), flip)), hn::Set(floatTag, 255.0F));
            BlendColor(PackHeld(depth, depth, depth), share, v, worker.samples);
        }
}

inline void ShadeTile(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    if (job.rules.shading == Shading::Overdraw) {
        for (std::size_t i = 0; i < kTileSamples; ++i)
            worker.samples.color[i] = overdrawColor(worker.samples.coverage[i]);
        if (!job.counting)
            return;
    }
    if (job.rules.shading == Shading::Gouraud) {
        ShadeColors(job, worker, origin);
        return;
    }
    CollectShares(job, worker, origin);
    if (job.counting)
        for (const BlockShare& share : worker.sharesInUse())
            worker.pixels.shaded += static_cast<unsigned>(std::popcount(share.lanes));
    if (job.rules.shading == Shading::Overdraw)
        return;
    if (!worker.full)
        worker.samples.color.fill(job.clearColor);
    switch (job.rules.shading) {
    case Shading::Depth: ShadeDepth(job, worker); break;
    case Shading::Flat:
    case Shading::RandomFlat:
    case Shading::TriangleId: ShadeUniform(job, worker); break;
    default:
        for (const BlockShare& share : worker.sharesInUse())
            shadeExactly(job, worker.visible[share.visible], share, origin, worker.samples);
    }
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
