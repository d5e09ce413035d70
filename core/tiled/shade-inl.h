// Second phase of a tile: every visible sample is shaded once, block by block and triangle by triangle. Included once
// for each target: see README.md.
#if defined(RASTERLENS_TILED_SHADE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_SHADE_INL_H
#undef RASTERLENS_TILED_SHADE_INL_H
#else
#define RASTERLENS_TILED_SHADE_INL_H
#endif

#include "core/pipeline/shading.h"
#include "core/tiled/exact_path.h"
#include "core/tiled/frame_job.h"
#include "core/tiled/gouraud-inl.h"
#include "core/tiled/lanes-inl.h"
#include "core/tiled/pattern-inl.h"
#include "core/tiled/shaders-inl.h"
#include "core/tiled/subtile-inl.h"
#include "core/tiled/textured-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// Prefetches the planes of a triangle into the cache: they are read once all visible triangles have been found.
template <std::size_t kCount>
HWY_INLINE const void* FetchVaryings(const Chunk& chunk, std::uint32_t number)
{
    constexpr std::size_t kLine = 64;
    using Planes = VaryingPlanes<kCount>;
    const Planes* planes = &chunk.varyings<Planes>(number);
    for (std::size_t at = 0; at < sizeof(Planes); at += kLine)
        __builtin_prefetch(reinterpret_cast<const std::byte*>(planes) + at);
    return planes;
}

HWY_INLINE const void* FetchVaryings(Shading shading, const Chunk& chunk, std::uint32_t number)
{
    switch (shading) {
    case Shading::Phong: return FetchVaryings<kPhongVaryings>(chunk, number);
    case Shading::Normals: return FetchVaryings<kNormalVaryings>(chunk, number);
    case Shading::Uv: return FetchVaryings<kUvVaryings>(chunk, number);
    case Shading::Gouraud:
    case Shading::Flat:
    case Shading::RandomFlat:
    case Shading::Texture:
    case Shading::Depth:
    case Shading::Overdraw:
    case Shading::TriangleId:
    case Shading::MipLevel: break;
    }
    return nullptr;
}

/// The place of a triangle in worker.visible.
HWY_INLINE std::uint32_t VisiblePlace(const FrameJob& job, std::uint32_t number, Worker& worker)
{
    std::uint32_t& place = worker.visibleOf[number];
    if (place != kNobody)
        return place;
    place = static_cast<std::uint32_t>(worker.visible.size());
    const Chunk& chunk = worker.chunkOf(number);
    const std::uint32_t source = worker.triangle(number).source;
    const Shading shading = job.rules.shading;
    const ColorPlanes& colors = worker.colors(number);
    const void* varyings = job.interpolatesColor() ? &colors
                           : job.interpolates()    ? FetchVaryings(shading, chunk, colors.extra)
                                                   : nullptr;
    worker.visible.push_back(
        {number, source, &chunk, varyings, faceUniforms(*job.scene, faceOf(chunk, source), job.rules)});
    return place;
}

/// Remembers the last triangle looked up: neighbours tend to belong to the same one.
struct LastVisible {
    std::uint32_t number = kNobody;
    std::uint32_t place = 0;
};

HWY_INLINE std::uint32_t VisiblePlace(const FrameJob& job, std::uint32_t number, Worker& worker, LastVisible& last)
{
    if (number != last.number)
        last = {number, VisiblePlace(job, number, worker)};
    return last.place;
}

/// The shares of a block.
///
/// in   its samples on the target
/// out  behind the last share
HWY_INLINE BlockShare* CollectBlock(const FrameJob& job, Worker& worker, int block, std::uint32_t remaining,
                                    LastVisible& last, BlockShare* out)
{
    const std::uint32_t* ids = worker.samples.ids.data() + std::size_t(block) * kLanes;
    const std::uint32_t owner = worker.samples.owner[static_cast<std::size_t>(block)];
    if (owner == kEmpty) {
        worker.full = false;
        return out;
    }
    while (remaining != 0) {
        const std::uint32_t number = owner != kNobody ? owner : ids[std::countr_zero(remaining)];
        const std::uint32_t lanes = owner != kNobody ? remaining : LanesWith(ids, number) & remaining;
        remaining &= ~lanes;
        if (number == kNobody) {
            worker.full = false;
            continue;
        }
        *out++ = {static_cast<std::uint16_t>(block), static_cast<std::uint16_t>(lanes),
                  VisiblePlace(job, number, worker, last)};
    }
    return out;
}

/// Multi-sampling: the shares of a block that has samples of its own. What no triangle has of them is cleared.
HWY_INLINE BlockShare* CollectPatternBlock(const FrameJob& job, Worker& worker, int block, std::uint32_t onTarget,
                                           LastVisible& last, BlockShare* out)
{
    if (job.color != nullptr)
        ClearSamples(job, static_cast<std::size_t>(block), worker);
    ForEachNumber(job.pattern, worker, static_cast<std::size_t>(block), onTarget,
                  [&](std::uint32_t number, std::uint32_t lanes, int samples) HWY_ATTR {
                      worker.pixels.written += job.counting ? static_cast<unsigned>(samples) : 0;
                      *out++ = {static_cast<std::uint16_t>(block), static_cast<std::uint16_t>(lanes),
                                VisiblePlace(job, number, worker, last)};
                  });
    return out;
}

/// Finds which triangles of the tile are visible, and their samples block by block.
inline void CollectShares(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    worker.visible.clear();
    worker.visibleOf.assign(worker.blocks.size() * BinBlock::kCapacity, kNobody);
    worker.full = true;
    const bool whole = origin.x + kTileSide <= job.rules.columns() && origin.y + kTileSide <= job.rules.rows() &&
                       job.grid.pitch == kTileSide;
    LastVisible last;
    BlockShare* out = worker.shares.data();
    for (int block = 0; block < kTileBlocks; ++block) {
        const std::uint32_t onTarget = whole ? 0xffff : LanesOnTarget(job, origin, block);
        if (job.pattern.isOn() && worker.samples.owner[static_cast<std::size_t>(block)] == kNobody)
            out = CollectPatternBlock(job, worker, block, onTarget, last, out);
        else
            out = CollectBlock(job, worker, block, onTarget, last, out);
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

/// The samples of a share by a shader; false: it leaves them to the scalar stages.
template <class Shader>
HWY_INLINE bool ShadeShare(const Shader& shader, const VisibleTriangle& visible, const BlockShare& share,
                           TileOrigin origin, TileSamples& samples)
{
    constexpr std::size_t kCount = Shader::kVaryings;
    const auto& planes = *static_cast<const VaryingPlanes<kCount>*>(visible.varyings);
    if (HWY_UNLIKELY(planes.exact))
        return false;
    const int x = origin.x + blockColumn(share.block) * kBlockSide;
    const int y = origin.y + blockRow(share.block) * kBlockSide;
    for (std::size_t v = 0; v < kVectors; ++v) {
        const std::uint32_t bits = std::uint32_t(share.lanes) >> (v * kPerVector);
        if (kVectors > 1 && (bits & ((1U << kPerVector) - 1)) == 0)
            continue;
        const ShaderLanes<kCount> lanes{visible, planes, VaryingsAt(planes, x, y, v), MaskOf(FloatTag(), bits)};
        if (HWY_UNLIKELY(!shader.Can(lanes)))
            return false;
        BlendColor(PackHeld(shader(lanes)), share, v, samples);
    }
    return true;
}

/// Multi-sampling: a share has been shaded once a pixel, and its samples take that.
HWY_INLINE void FinishShare(const FrameJob& job, const BlockShare& share, Worker& worker)
{
    if (job.pattern.isOn() && worker.samples.owner[share.block] == kNobody)
        ShareColors(job.pattern, worker.visible[share.visible].number, share.block, worker);
}

template <class Shader>
inline void ShadeVaryings(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    const Shader shader(job);
    for (const BlockShare& share : worker.sharesInUse()) {
        const VisibleTriangle& visible = worker.visible[share.visible];
        if (HWY_UNLIKELY(!ShadeShare(shader, visible, share, origin, worker.samples)))
            shadeExactly(job, visible, share, origin, worker.samples);
        FinishShare(job, share, worker);
    }
}

/// Interpolated colours, where samples had to remember whose they are.
inline void ShadeColors(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    for (const BlockShare& share : worker.sharesInUse()) {
        const VisibleTriangle& visible = worker.visible[share.visible];
        const auto& planes = *static_cast<const ColorPlanes*>(visible.varyings);
        if (HWY_UNLIKELY(planes.way == ColorWay::Exact)) {
            shadeExactly(job, visible, share, origin, worker.samples);
            FinishShare(job, share, worker);
            continue;
        }
        const int x = origin.x + blockColumn(share.block) * kBlockSide;
        const int y = origin.y + blockRow(share.block) * kBlockSide;
        for (std::size_t v = 0; v < kVectors; ++v)
            BlendColor(BlockColor(planes, x, y, v, job.pattern.isOn()), share, v, worker.samples);
        FinishShare(job, share, worker);
    }
}

/// Shadings with one colour a face.
inline void ShadeUniform(const FrameJob& job, Worker& worker)
{
    for (const BlockShare& share : worker.sharesInUse()) {
        for (std::size_t v = 0; v < kVectors; ++v)
            BlendColor(hn::Set(UintTag(), worker.visible[share.visible].uniforms.color), share, v, worker.samples);
        FinishShare(job, share, worker);
    }
}

/// Multi-sampling: depths at the centres of pixels, which are no sample's, in the scalar way.
inline void ShadeCentreDepths(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    for (const BlockShare& share : worker.sharesInUse()) {
        shadeExactly(job, worker.visible[share.visible], share, origin, worker.samples);
        FinishShare(job, share, worker);
    }
}

inline void ShadeDepth(Worker& worker)
{
    constexpr FloatTag tag;
    for (const BlockShare& share : worker.sharesInUse())
        for (std::size_t v = 0; v < kVectors; ++v) {
            const std::int32_t* key = worker.samples.key.data() + std::size_t(share.block) * kLanes + v * kPerVector;
            const Floats depth = hn::Mul(hn::BitCast(tag, hn::Load(IntTag(), key)), hn::Set(tag, 255.0F));
            BlendColor(PackHeld({depth, depth, depth}), share, v, worker.samples);
        }
}

inline void CountShares(const FrameJob& job, Worker& worker)
{
    for (const BlockShare& share : worker.sharesInUse()) {
        const auto samples = static_cast<unsigned>(std::popcount(share.lanes));
        if (!job.pattern.isOn() || worker.samples.owner[share.block] != kNobody)
            worker.pixels.written += samples * static_cast<unsigned>(job.pattern.samples);
        worker.pixels.shaded += job.color != nullptr ? samples : 0;
    }
}

/// Colours the samples of all shares; with multi-sampling the pixels too.
inline void ShadeShares(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    if (!worker.full)
        worker.samples.color.fill(job.clearColor);
    switch (job.rules.shading) {
    case Shading::Depth:
        if (job.pattern.isOn())
            ShadeCentreDepths(job, worker, origin);
        else
            ShadeDepth(worker);
        break;
    case Shading::Flat:
    case Shading::RandomFlat:
    case Shading::TriangleId: ShadeUniform(job, worker); break;
    case Shading::MipLevel: break; // not supported
    case Shading::Phong: ShadeVaryings<PhongShader>(job, worker, origin); break;
    case Shading::Normals: ShadeVaryings<NormalShader>(job, worker, origin); break;
    case Shading::Uv: ShadeVaryings<UvShader>(job, worker, origin); break;
    case Shading::Gouraud: ShadeColors(job, worker, origin); break;
    case Shading::Texture:
    case Shading::Overdraw: break;
    }
}

inline void ShadeTile(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    const bool overdraw = job.rules.shading == Shading::Overdraw;
    if (job.color != nullptr && overdraw && job.pattern.isOn()) {
        for (std::size_t i = 0; i < kTileSamples * job.pattern.samples; ++i)
            worker.pattern.color.data()[i] = overdrawColor(worker.pattern.coverage.data()[i]);
        ResolveBlocks(job.pattern, worker);
    } else if (job.color != nullptr && overdraw) {
        for (std::size_t i = 0; i < kTileSamples; ++i)
            worker.samples.color[i] = overdrawColor(worker.samples.coverage[i]);
    }
    worker.resolvedSubtiles = 0;
    if (job.colorsAtOnce()) {
        if (job.pattern.isOn())
            FinishPatternColors(job, worker, origin);
        else
            FinishColors(job, worker, origin);
        return;
    }
    if (job.color != nullptr && job.rules.shading == Shading::Texture) {
        ShadeTextured(job, worker, origin);
        return;
    }
    const bool shades = job.color != nullptr && !overdraw;
    if (!shades && !job.counting)
        return;
    CollectShares(job, worker, origin);
    if (job.counting)
        CountShares(job, worker);
    if (!shades)
        return;
    ShadeShares(job, worker, origin);
    if (job.pattern.isOn())
        ResolveBlocks(job.pattern, worker);
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
