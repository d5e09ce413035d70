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

/// The place of a triangle in worker.visible.
HWY_INLINE std::uint32_t VisiblePlace(const FrameJob& job, std::uint32_t number, Worker& worker)
{
    std::uint32_t& place = worker.visibleOf[number];
    if (place != kNobody)
        return place;
    place = static_cast<std::uint32_t>(worker.visible.size());
    const TileTriangle& t = worker.triangle(number);
    worker.visible.push_back({t.source, 0, &worker.chunkOf(number)});
    worker.planes.emplace_back();
    worker.planes.back().x0 = static_cast<float>(t.x0 / kBlockSide * kBlockSide);
    worker.planes.back().y0 = static_cast<float>(t.y0 / kBlockSide * kBlockSide);
    if ((t.source & kPiece) == 0)
        __builtin_prefetch(&job.scene->mesh.indices[3 * std::size_t(t.source)]);
    return place;
}

/// Finds who is visible where.
inline void CollectShares(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    worker.visible.clear();
    worker.planes.clear();
    worker.shares.clear();
    worker.visibleOf.assign(worker.blocks.size() * BinBlock::kCapacity, kNobody);
    const bool whole = origin.x + kTileSide <= job.rules.columns() && origin.y + kTileSide <= job.rules.rows() &&
                       job.grid.pitch == kTileSide;
    for (int block = 0; block < kTileBlocks; ++block) {
        std::uint32_t remaining = whole ? 0xffff : LanesOnTarget(job, origin, block);
        const auto add = [&](std::uint32_t number, std::uint32_t lanes) HWY_ATTR {
            worker.shares.push_back({static_cast<std::uint16_t>(block), static_cast<std::uint16_t>(lanes),
                                     VisiblePlace(job, number, worker)});
        };
        if (const std::uint32_t owner = worker.samples.owner[static_cast<std::size_t>(block)]; owner != kNobody) {
            if (remaining != 0)
                add(owner, remaining);
            continue;
        }
        const std::uint32_t* ids = worker.samples.ids.data() + std::size_t(block) * kLanes;
        while (remaining != 0) {
            const std::uint32_t number = ids[std::countr_zero(remaining)];
            const std::uint32_t lanes = LanesWith(ids, number) & remaining;
            remaining &= ~lanes;
            if (number != kNobody)
                add(number, lanes);
        }
    }
}

/// Corners of visible triangles, lane by lane: positions in samples, w of clip space, colours.
struct alignas(64) CornerStage {
    std::array<std::array<double, kDoubles>, 3> x;
    std::array<std::array<double, kDoubles>, 3> y;
    std::array<std::array<double, kDoubles>, 3> w;
    std::array<std::array<std::array<float, kDoubles>, 3>, 3> color;
    std::array<double, kDoubles> anchorX; ///< centre of the sample the planes start at
    std::array<double, kDoubles> anchorY;
};

inline void StagePiece(const ScreenTriangle& triangle, std::size_t lane, CornerStage& stage)
{
    for (std::size_t k = 0; k < 3; ++k) {
        const ScreenVertex& v = triangle.vertices[k];
        stage.x[k][lane] = v.position.x;
        stage.y[k][lane] = v.position.y;
        stage.w[k][lane] = 1 / v.invW;
        for (std::size_t c = 0; c < 3; ++c)
            stage.color[k][c][lane] = v.varyings[c];
    }
}

HWY_INLINE void StageFace(const FrameJob& job, std::uint32_t face, std::size_t lane, CornerStage& stage)
{
    const Mesh& mesh = job.scene->mesh;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = mesh.indices[3 * std::size_t(face) + k];
        stage.x[k][lane] = job.points[i].x * (1.0 / kUnit);
        stage.y[k][lane] = job.points[i].y * (1.0 / kUnit);
        const MeshVertex& vertex = mesh.vertices[i];
        const glm::vec4 color = job.colors != nullptr ? job.colors[i] : glm::vec4(vertex.color, vertex.position.w);
        stage.w[k][lane] = color.w;
        for (int c = 0; c < 3; ++c)
            stage.color[k][static_cast<std::size_t>(c)][lane] = color[c];
    }
}

/// Asks for what StageFace() will read.
HWY_INLINE void PrefetchFace(const FrameJob& job, const VisibleTriangle& visible)
{
    if ((visible.source & kPiece) != 0)
        return;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = job.scene->mesh.indices[3 * std::size_t(visible.source) + k];
        __builtin_prefetch(&job.points[i]);
        if (job.colors != nullptr) {
            __builtin_prefetch(&job.colors[i]);
        } else {
            __builtin_prefetch(&job.scene->mesh.vertices[i].position.w);
            __builtin_prefetch(&job.scene->mesh.vertices[i].color.z);
        }
    }
}

/// Screen weights of B and C over a triangle: per sample to the right and down, and at the anchor.
struct WeightLanes {
    Doubles bPerX, bPerY, cPerX, cPerY;
    Doubles bAtAnchor, cAtAnchor;
    Doubles steepness; ///< how much weights change over the part of a tile the triangle may have
};

HWY_INLINE WeightLanes MakeWeights(const CornerStage& stage)
{
    constexpr DoubleTag tag;
    const auto load = [](const auto& lanes) HWY_ATTR { return hn::Load(DoubleTag(), lanes.data()); };
    const Doubles ax = load(stage.x[0]);
    const Doubles ay = load(stage.y[0]);
    const Doubles abX = hn::Sub(load(stage.x[1]), ax);
    const Doubles abY = hn::Sub(load(stage.y[1]), ay);
    const Doubles acX = hn::Sub(load(stage.x[2]), ax);
    const Doubles acY = hn::Sub(load(stage.y[2]), ay);
    const Doubles inverse = hn::Div(hn::Set(tag, 1.0), hn::Sub(hn::Mul(abY, acX), hn::Mul(abX, acY)));
    const Doubles toX = hn::Sub(load(stage.anchorX), ax);
    const Doubles toY = hn::Sub(load(stage.anchorY), ay);
    WeightLanes w;
    w.bPerX = hn::Neg(hn::Mul(acY, inverse));
    w.bPerY = hn::Mul(acX, inverse);
    w.cPerX = hn::Mul(abY, inverse);
    w.cPerY = hn::Neg(hn::Mul(abX, inverse));
    w.bAtAnchor = hn::Add(hn::Mul(w.bPerX, toX), hn::Mul(w.bPerY, toY));
    w.cAtAnchor = hn::Add(hn::Mul(w.cPerX, toX), hn::Mul(w.cPerY, toY));
    const Doubles slope =
        hn::Add(hn::Add(hn::Abs(w.bPerX), hn::Abs(w.bPerY)), hn::Add(hn::Abs(w.cPerX), hn::Abs(w.cPerY)));
    const Doubles extent = hn::Add(hn::Add(hn::Abs(abX), hn::Abs(abY)), hn::Add(hn::Abs(acX), hn::Abs(acY)));
    w.steepness =
        hn::Mul(slope, hn::Add(hn::Min(extent, hn::Set(tag, 2.0 * kTileSide)), hn::Set(tag, 2.0 * kBlockSide)));
    return w;
}

/// Colour planes of one vector of triangles.
HWY_INLINE void MakePlanes(const FrameJob& job, const CornerStage& stage, std::size_t count, ColorPlanes* out)
{
    constexpr DoubleTag tag;
    constexpr HalfFloatTag narrow;
    const WeightLanes weights = MakeWeights(stage);
    const Doubles one = hn::Set(tag, 1.0);
    std::array<Doubles, 3> q{one, one, one};
    if (job.rules.perspectiveCorrect)
        for (std::size_t k = 0; k < 3; ++k)
            q[k] = hn::Div(one, hn::Load(tag, stage.w[k].data()));
    alignas(64) std::array<std::array<std::array<float, kDoubles>, 4>, 3> planes;
    const auto makePlane = [&](std::size_t i, Doubles a, Doubles b, Doubles c) HWY_ATTR {
        const Doubles ab = hn::Sub(b, a);
        const Doubles ac = hn::Sub(c, a);
        const auto store = [&](std::size_t at, Doubles value)
                               HWY_ATTR { hn::Store(hn::DemoteTo(narrow, value), narrow, planes[at][i].data()); };
        store(0, hn::Add(a, hn::Add(hn::Mul(ab, weights.bAtAnchor), hn::Mul(ac, weights.cAtAnchor))));
        store(1, hn::Add(hn::Mul(ab, weights.bPerX), hn::Mul(ac, weights.cPerX)));
        store(2, hn::Add(hn::Mul(ab, weights.bPerY), hn::Mul(ac, weights.cPerY)));
    };
    makePlane(0, q[0], q[1], q[2]);
    Doubles largest = one;
    for (std::size_t i = 0; i < 3; ++i) {
        std::array<Doubles, 3> value;
        for (std::size_t k = 0; k < 3; ++k) {
            const Doubles v = hn::PromoteTo(tag, hn::Load(narrow, stage.color[k][i].data()));
            largest = hn::Max(largest, hn::Abs(v));
            value[k] = hn::Mul(hn::Mul(v, hn::Set(tag, 255.0)), q[k]);
        }
        makePlane(i + 1, value[0], value[1], value[2]);
    }

    // float32 keeps 24 bits of the largest term of a sum; what is left of them after the terms cancel and after the
    // division by w must be enough for a colour.
    constexpr double kEnough = 1 << 12;
    const Doubles ratio = hn::Div(hn::Max(hn::Max(q[0], q[1]), q[2]), hn::Min(hn::Min(q[0], q[1]), q[2]));
    const Doubles cancelled = hn::Mul(weights.steepness, hn::Mul(ratio, largest));
    const std::uint32_t enough = BitsOf(tag, hn::Lt(cancelled, hn::Set(tag, kEnough)));
    for (std::size_t lane = 0; lane < count; ++lane) {
        out[lane].exact = (enough >> lane & 1) == 0;
        for (std::size_t i = 0; i < 4; ++i) {
            out[lane].origin[i] = planes[0][i][lane];
            out[lane].perX[i] = planes[1][i][lane];
            out[lane].perY[i] = planes[2][i][lane];
        }
    }
}

inline void SetUpColors(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    constexpr std::size_t kAhead = 16;
    CornerStage stage{};
    const std::size_t total = worker.visible.size();
    for (std::size_t i = 0; i < std::min(kAhead, total); ++i)
        PrefetchFace(job, worker.visible[i]);
    for (std::size_t first = 0; first < total; first += kDoubles) {
        const std::size_t count = std::min(kDoubles, total - first);
        for (std::size_t i = first + kAhead; i < std::min(first + kAhead + kDoubles, total); ++i)
            PrefetchFace(job, worker.visible[i]);
        for (std::size_t lane = 0; lane < count; ++lane) {
            const VisibleTriangle& visible = worker.visible[first + lane];
            if ((visible.source & kPiece) != 0)
                StagePiece(visible.chunk->pieces[visible.source & ~kPiece].triangle, lane, stage);
            else
                StageFace(job, visible.source, lane, stage);
            const ColorPlanes& planes = worker.planes[first + lane];
            stage.anchorX[lane] = double(planes.x0) + origin.x + 0.5;
            stage.anchorY[lane] = double(planes.y0) + origin.y + 0.5;
        }
        MakePlanes(job, stage, count, &worker.planes[first]);
    }
}

/// Colours of 0 to 255, held within that and rounded.
HWY_INLINE Ints ChannelOf(Floats c)
{
    constexpr FloatTag tag;
    const Floats held = hn::Min(hn::Max(c, hn::Zero(tag)), hn::Set(tag, 255.0F));
    return hn::ConvertTo(IntTag(), hn::Add(held, hn::Set(tag, 0.5F)));
}

HWY_INLINE Uints PackChannels(Floats red, Floats green, Floats blue)
{
    constexpr IntTag tag;
    const Ints packed = hn::Or(hn::Or(hn::ShiftLeft<16>(ChannelOf(red)), hn::ShiftLeft<8>(ChannelOf(green))),
                               hn::Or(ChannelOf(blue), hn::Set(tag, static_cast<std::int32_t>(0xff000000U))));
    return hn::BitCast(UintTag(), packed);
}

/// Writes the lanes of a share that fall into vector v.
HWY_INLINE void BlendColor(Uints color, const BlockShare& share, std::size_t v, TileSamples& samples)
{
    constexpr UintTag tag;
    std::uint32_t* out = samples.color.data() + std::size_t(share.block) * kLanes + v * kPerVector;
    const auto mask = MaskOf(tag, std::uint32_t(share.lanes) >> (v * kPerVector));
    hn::Store(hn::IfThenElse(mask, color, hn::Load(tag, out)), tag, out);
}

/// How planes change from the first sample of a block to the others.
struct PlaneOffsets {
    std::array<std::array<Floats, kVectors>, 4> plane;
};

HWY_INLINE PlaneOffsets SpreadPlanes(const ColorPlanes& planes)
{
    constexpr FloatTag tag;
    PlaneOffsets offsets;
    for (std::size_t v = 0; v < kVectors; ++v) {
        const Floats x = hn::Load(tag, kPattern.floatX.data() + v * kPerVector);
        const Floats y = hn::Load(tag, kPattern.floatY.data() + v * kPerVector);
        for (std::size_t i = 0; i < 4; ++i)
            offsets.plane[i][v] =
                hn::Add(hn::Mul(hn::Set(tag, planes.perX[i]), x), hn::Mul(hn::Set(tag, planes.perY[i]), y));
    }
    return offsets;
}

/// The interpolated colour of a triangle over its lanes of a block.
HWY_INLINE void ShadeColors(const ColorPlanes& planes, const PlaneOffsets& offsets, const BlockShare& share,
                            TileSamples& samples)
{
    constexpr FloatTag tag;
    const float x = static_cast<float>(blockColumn(share.block) * kBlockSide) - planes.x0;
    const float y = static_cast<float>(blockRow(share.block) * kBlockSide) - planes.y0;
    std::array<float, 4> corner;
    for (std::size_t i = 0; i < 4; ++i)
        corner[i] = planes.origin[i] + planes.perX[i] * x + planes.perY[i] * y;
    for (std::size_t v = 0; v < kVectors; ++v) {
        const auto plane = [&](std::size_t i)
                               HWY_ATTR { return hn::Add(hn::Set(tag, corner[i]), offsets.plane[i][v]); };
        const Floats w = hn::Div(hn::Set(tag, 1.0F), plane(0));
        BlendColor(PackChannels(hn::Mul(plane(1), w), hn::Mul(plane(2), w), hn::Mul(plane(3), w)), share, v, samples);
    }
}

inline void ShadeInterpolated(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    SetUpColors(job, worker, origin);
    std::uint32_t spread = kNobody; // whose offsets these are: large triangles have many blocks in sequence
    PlaneOffsets offsets;
    for (const BlockShare& share : worker.shares) {
        const ColorPlanes& planes = worker.planes[share.visible];
        if (planes.exact) {
            shadeExactly(job, worker.visible[share.visible], share, origin, worker.samples);
            continue;
        }
        if (share.visible != spread) {
            offsets = SpreadPlanes(planes);
            spread = share.visible;
        }
        ShadeColors(planes, offsets, share, worker.samples);
    }
}

/// Shadings with one colour a face.
inline void ShadeUniform(const FrameJob& job, Worker& worker)
{
    for (VisibleTriangle& visible : worker.visible)
        visible.color = faceUniforms(*job.scene, faceOf(*visible.chunk, visible.source), job.rules.shading).color;
    for (const BlockShare& share : worker.shares)
        for (std::size_t v = 0; v < kVectors; ++v)
            BlendColor(hn::Set(UintTag(), worker.visible[share.visible].color), share, v, worker.samples);
}

inline void ShadeDepth(const FrameJob& job, Worker& worker)
{
    constexpr IntTag tag;
    constexpr FloatTag floatTag;
    const Ints flip = hn::Set(tag, depthFlip(job.rules.depthCompare));
    for (const BlockShare& share : worker.shares)
        for (std::size_t v = 0; v < kVectors; ++v) {
            const std::int32_t* key = worker.samples.key.data() + std::size_t(share.block) * kLanes + v * kPerVector;
            const Floats depth =
                hn::Mul(hn::BitCast(floatTag, hn::Xor(hn::Load(tag, key), flip)), hn::Set(floatTag, 255.0F));
            BlendColor(PackChannels(depth, depth, depth), share, v, worker.samples);
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
    CollectShares(job, worker, origin);
    if (job.counting)
        for (const BlockShare& share : worker.shares)
            worker.pixels.shaded += static_cast<unsigned>(std::popcount(share.lanes));
    if (job.rules.shading == Shading::Overdraw)
        return;
    worker.samples.color.fill(job.clearColor);
    switch (job.rules.shading) {
    case Shading::Gouraud: ShadeInterpolated(job, worker, origin); break;
    case Shading::Depth: ShadeDepth(job, worker); break;
    case Shading::Flat:
    case Shading::RandomFlat:
    case Shading::TriangleId: ShadeUniform(job, worker); break;
    default:
        for (const BlockShare& share : worker.shares)
            shadeExactly(job, worker.visible[share.visible], share, origin, worker.samples);
    }
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
