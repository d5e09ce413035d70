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
#include "core/rasterizers/tiled/kernels.h"
#include "core/rasterizers/tiled/lanes-inl.h"
#include "core/rasterizers/tiled/shaders-inl.h"
#include "core/rasterizers/tiled/subtile-inl.h"

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

/// Samples of a block that belong to the target.
inline std::uint32_t LanesOnTarget(const FrameJob& job, TileOrigin origin, int block)
{
    const int columns = std::min(job.rules.columns() - origin.x, job.grid.pitch) - blockColumn(block) * kBlockSide;
    const int rows = std::min(job.rules.rows() - origin.y, job.grid.pitch) - blockRow(block) * kBlockSide;
    if (columns >= kBlockSide && rows >= kBlockSide)
        return 0xffff;
    std::uint32_t bits = 0;
    for (int y = 0; y < std::min(rows, kBlockSide); ++y)
        for (int x = 0; x < std::min(columns, kBlockSide); ++x)
            bits |= 1U << (y * kBlockSide + x);
    return bits;
}

/// The planes of a triangle, on their way from memory: they are read when all who are visible have been found.
template <class Planes>
HWY_INLINE const void* FetchPlanes(const Chunk& chunk, std::uint32_t number)
{
    constexpr std::size_t kLine = 64;
    const Planes* planes = &chunk.planes<Planes>(number);
    for (std::size_t at = 0; at < sizeof(Planes); at += kLine)
        __builtin_prefetch(reinterpret_cast<const std::byte*>(planes) + at);
    return planes;
}

HWY_INLINE const void* FetchPlanes(Shading shading, const Chunk& chunk, std::uint32_t number)
{
    switch (shading) {
    case Shading::Gouraud: return FetchPlanes<ColorPlanes>(chunk, number);
    case Shading::Texture: return FetchPlanes<VaryingPlanes<kTextureVaryings>>(chunk, number);
    case Shading::Phong: return FetchPlanes<VaryingPlanes<kPhongVaryings>>(chunk, number);
    case Shading::Normals: return FetchPlanes<VaryingPlanes<kNormalVaryings>>(chunk, number);
    case Shading::Uv: return FetchPlanes<VaryingPlanes<kUvVaryings>>(chunk, number);
    default: return nullptr;
    }
}

/// The place of a triangle in worker.visible.
HWY_INLINE std::uint32_t VisiblePlace(const FrameJob& job, std::uint32_t number, Worker& worker)
{
    std::uint32_t& place = worker.visibleOf[number];
    if (place != kNobody)
        return place;
    place = static_cast<std::uint32_t>(worker.visible.size());
    const Chunk& chunk = worker.chunkOf(number);
    const std::uint32_t inChunk = worker.triangle(number).number & ~kExact;
    const Shading shading = job.rules.shading;
    VisibleTriangle& visible = worker.visible.emplace_back();
    visible.source = chunk.sources[inChunk];
    visible.chunk = &chunk;
    visible.planes = FetchPlanes(shading, chunk, inChunk);
    if (shading != Shading::Gouraud && shading != Shading::Depth)
        visible.uniforms = faceUniforms(*job.scene, faceOf(chunk, visible.source), shading);
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

/// Shades a subtile that a triangle has to itself.
///
/// out  false if it is to be done block by block
HWY_INLINE bool TakeSubtile(const FrameJob& job, Worker& worker, TileOrigin origin, int subtile, LastVisible& last)
{
    const std::uint32_t number = SubtileOwner(worker.samples, static_cast<std::size_t>(subtile));
    if (number == kNobody)
        return false;
    const VisibleTriangle& visible = worker.visible[VisiblePlace(job, number, worker, last)];
    const auto& planes = *static_cast<const ColorPlanes*>(visible.planes);
    if (planes.exact)
        return false;
    ShadeSubtile(job, planes, origin.x + blockColumn(subtile * kLanes) * kBlockSide,
                 origin.y + blockRow(subtile * kLanes) * kBlockSide);
    worker.resolvedSubtiles |= 1U << subtile;
    return true;
}

/// Finds who is visible where.
inline void CollectShares(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    worker.visible.clear();
    worker.visibleOf.assign(worker.blocks.size() * BinBlock::kCapacity, kNobody);
    worker.full = true;
    worker.resolvedSubtiles = 0;
    const bool whole = origin.x + kTileSide <= job.rules.columns() && origin.y + kTileSide <= job.rules.rows() &&
                       job.grid.pitch == kTileSide;
    const bool takesSubtiles = whole && job.rules.sampleGrid == 4 && job.rules.shading == Shading::Gouraud &&
                               job.color != nullptr && !job.counting;
    LastVisible last;
    BlockShare* out = worker.shares.data();
    for (int subtile = 0; subtile < kLanes; ++subtile) {
        if (takesSubtiles && TakeSubtile(job, worker, origin, subtile, last))
            continue;
        for (int block = subtile * kLanes; block < (subtile + 1) * kLanes; ++block)
            out = CollectBlock(job, worker, block, whole ? 0xffff : LanesOnTarget(job, origin, block), last, out);
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

/// The interpolated colour of a triangle over its lanes of a block.
HWY_INLINE void ShadeColors(const ColorPlanes& planes, const BlockShare& share, TileOrigin origin, TileSamples& samples)
{
    constexpr FloatTag tag;
    const Floats blockX =
        hn::Set(tag, static_cast<float>(origin.x + blockColumn(share.block) * kBlockSide) - planes.x0);
    const Floats blockY = hn::Set(tag, static_cast<float>(origin.y + blockRow(share.block) * kBlockSide) - planes.y0);
    for (std::size_t v = 0; v < kVectors; ++v) {
        const Floats x = hn::Add(blockX, hn::Load(tag, kPattern.floatX.data() + v * kPerVector));
        const Floats y = hn::Add(blockY, hn::Load(tag, kPattern.floatY.data() + v * kPerVector));
        const auto plane = [&](std::size_t i) HWY_ATTR { return hn::Add(AlongX(planes, i, x), AlongY(planes, i, y)); };
        BlendColor(PackChannels(ColorOf(plane(0), {plane(1), plane(2), plane(3)})), share, v, samples);
    }
}

inline void ShadeInterpolated(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    for (const BlockShare& share : worker.sharesInUse()) {
        const auto& planes = *static_cast<const ColorPlanes*>(worker.visible[share.visible].planes);
        if (HWY_UNLIKELY(planes.exact))
            shadeExactly(job, worker.visible[share.visible], share, origin, worker.samples);
        else
            ShadeColors(planes, share, origin, worker.samples);
    }
}

/// The samples of a share by a shader; false: it leaves them to the scalar stages.
template <class Shader>
HWY_INLINE bool ShadeShare(const Shader& shader, const VisibleTriangle& visible, const BlockShare& share,
                           TileOrigin origin, TileSamples& samples)
{
    constexpr std::size_t kCount = Shader::kVaryings;
    const auto& planes = *static_cast<const VaryingPlanes<kCount>*>(visible.planes);
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
        BlendColor(PackChannels(shader(lanes)), share, v, samples);
    }
    return true;
}

template <class Shader>
inline void ShadeVaryings(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    const Shader shader(job);
    for (const BlockShare& share : worker.sharesInUse()) {
        const VisibleTriangle& visible = worker.visible[share.visible];
        if (HWY_UNLIKELY(!ShadeShare(shader, visible, share, origin, worker.samples)))
            shadeExactly(job, visible, share, origin, worker.samples);
    }
}

/// Shadings with one colour a face.
inline void ShadeUniform(Worker& worker)
{
    for (const BlockShare& share : worker.sharesInUse())
        for (std::size_t v = 0; v < kVectors; ++v)
            BlendColor(hn::Set(UintTag(), worker.visible[share.visible].uniforms.color), share, v, worker.samples);
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
            BlendColor(PackChannels({depth, depth, depth}), share, v, worker.samples);
        }
}

inline void CountShares(const FrameJob& job, Worker& worker)
{
    for (const BlockShare& share : worker.sharesInUse()) {
        const auto samples = static_cast<unsigned>(std::popcount(share.lanes));
        worker.pixels.written += samples;
        worker.pixels.shaded += job.color != nullptr ? samples : 0;
    }
}

inline void ShadeTile(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    const bool overdraw = job.rules.shading == Shading::Overdraw;
    if (job.color != nullptr && overdraw)
        for (std::size_t i = 0; i < kTileSamples; ++i)
            worker.samples.color[i] = overdrawColor(worker.samples.coverage[i]);
    const bool shades = job.color != nullptr && !overdraw;
    if (!shades && !job.counting)
        return;
    CollectShares(job, worker, origin);
    if (job.counting)
        CountShares(job, worker);
    if (!shades)
        return;
    if (!worker.full)
        worker.samples.color.fill(job.clearColor);
    switch (job.rules.shading) {
    case Shading::Gouraud: ShadeInterpolated(job, worker, origin); break;
    case Shading::Depth: ShadeDepth(job, worker); break;
    case Shading::Flat:
    case Shading::RandomFlat:
    case Shading::TriangleId: ShadeUniform(worker); break;
    case Shading::Texture: ShadeVaryings<TextureShader>(job, worker, origin); break;
    case Shading::Phong: ShadeVaryings<PhongShader>(job, worker, origin); break;
    case Shading::Normals: ShadeVaryings<NormalShader>(job, worker, origin); break;
    case Shading::Uv: ShadeVaryings<UvShader>(job, worker, origin); break;
    case Shading::Overdraw: break;
    }
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
