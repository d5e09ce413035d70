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
HWY_INLINE std::uint32_t VisiblePlace(Worker& worker, std::uint32_t number)
{
    std::uint32_t& place = worker.visibleOf[number];
    if (place == kNobody) {
        place = static_cast<std::uint32_t>(worker.visible.size());
        const std::size_t block = number / (BinBlock::kCapacity + 1);
        const TileTriangle& t = worker.blocks[block]->triangles[number % (BinBlock::kCapacity + 1)];
        worker.visible.push_back({t.source, worker.blockChunk[block],
                                  static_cast<float>(t.x0 / kBlockSide * kBlockSide),
                                  static_cast<float>(t.y0 / kBlockSide * kBlockSide)});
    }
    return place;
}

/// Finds who is visible where.
inline void CollectShares(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    worker.visible.clear();
    worker.shares.clear();
    worker.visibleOf.assign(worker.blocks.size() * (BinBlock::kCapacity + 1), kNobody);
    for (int block = 0; block < kTileBlocks; ++block) {
        std::uint32_t remaining = LanesOnTarget(job, origin, block);
        const std::uint32_t* ids = worker.samples.ids.data() + std::size_t(block) * kLanes;
        while (remaining != 0) {
            const std::uint32_t number = ids[std::countr_zero(remaining)];
            const std::uint32_t lanes = LanesWith(ids, number) & remaining;
            remaining &= ~lanes;
            if (number != kNobody)
                worker.shares.push_back({static_cast<std::uint16_t>(block), static_cast<std::uint16_t>(lanes),
                                         VisiblePlace(worker, number)});
        }
    }
}

/// Corners of visible triangles, lane by lane: positions in samples, 1/w, varyings.
struct alignas(64) CornerStage {
    std::array<std::array<double, kDoubles>, 3> x;
    std::array<std::array<double, kDoubles>, 3> y;
    std::array<std::array<double, kDoubles>, 3> invW;
    std::array<std::array<std::array<float, kDoubles>, kMaxVaryings>, 3> varyings;
    std::array<double, kDoubles> anchorX; ///< centre of the sample the planes start at
    std::array<double, kDoubles> anchorY;
};

inline void StagePiece(const FrameJob& job, const ScreenTriangle& triangle, std::size_t lane, CornerStage& stage)
{
    for (std::size_t k = 0; k < 3; ++k) {
        const ScreenVertex& v = triangle.vertices[k];
        stage.x[k][lane] = v.position.x;
        stage.y[k][lane] = v.position.y;
        stage.invW[k][lane] = v.invW;
        for (std::size_t i = 0; i < static_cast<std::size_t>(job.rules.varyingCount); ++i)
            stage.varyings[k][i][lane] = v.varyings[i];
    }
}

/// A face of the mesh, for the shadings that interpolate a colour.
HWY_INLINE void StageFace(const FrameJob& job, std::uint32_t face, std::size_t lane, CornerStage& stage)
{
    const Mesh& mesh = job.scene->mesh;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = mesh.indices[3 * std::size_t(face) + k];
        stage.x[k][lane] = job.points[i].x * (1.0 / kUnit);
        stage.y[k][lane] = job.points[i].y * (1.0 / kUnit);
        stage.invW[k][lane] = job.clipW[i];
        const glm::vec3& color = job.litColors != nullptr ? job.litColors[i] : mesh.vertices[i].color;
        for (std::size_t c = 0; c < 3; ++c)
            stage.varyings[k][c][lane] = color[static_cast<int>(c)];
    }
}

/// Attribute planes of one vector of triangles.
template <std::size_t kVaryings>
HWY_INLINE void MakePlanes(const FrameJob& job, const CornerStage& stage, std::size_t count, AttributePlanes* out)
{
    constexpr DoubleTag tag;
    constexpr HalfFloatTag narrow;
    const auto load = [](const auto& lanes) HWY_ATTR { return hn::Load(DoubleTag(), lanes.data()); };
    const Doubles ax = load(stage.x[0]);
    const Doubles ay = load(stage.y[0]);
    const Doubles abX = hn::Sub(load(stage.x[1]), ax);
    const Doubles abY = hn::Sub(load(stage.y[1]), ay);
    const Doubles acX = hn::Sub(load(stage.x[2]), ax);
    const Doubles acY = hn::Sub(load(stage.y[2]), ay);
    const Doubles one = hn::Set(tag, 1.0);
    const Doubles inverseArea = hn::Div(one, hn::Sub(hn::Mul(abY, acX), hn::Mul(abX, acY)));
    // Weights of B and C: per x, per y and at the anchor.
    const Doubles toX = hn::Sub(load(stage.anchorX), ax);
    const Doubles toY = hn::Sub(load(stage.anchorY), ay);
    const Doubles bPerX = hn::Neg(hn::Mul(acY, inverseArea));
    const Doubles bPerY = hn::Mul(acX, inverseArea);
    const Doubles cPerX = hn::Mul(abY, inverseArea);
    const Doubles cPerY = hn::Neg(hn::Mul(abX, inverseArea));
    const Doubles bAtAnchor = hn::Add(hn::Mul(bPerX, toX), hn::Mul(bPerY, toY));
    const Doubles cAtAnchor = hn::Add(hn::Mul(cPerX, toX), hn::Mul(cPerY, toY));

    std::array<Doubles, 3> q{one, one, one};
    if (job.rules.perspectiveCorrect)
        for (std::size_t k = 0; k < 3; ++k)
            q[k] = load(stage.invW[k]);
    alignas(64) std::array<std::array<float, kDoubles>, 3 * (kVaryings + 1)> planes;
    const auto makePlane = [&](std::size_t i, Doubles a, Doubles b, Doubles c) HWY_ATTR {
        const Doubles ab = hn::Sub(b, a);
        const Doubles ac = hn::Sub(c, a);
        const auto store = [&](std::size_t at, Doubles value)
                               HWY_ATTR { hn::Store(hn::DemoteTo(narrow, value), narrow, planes[at].data()); };
        store(3 * i, hn::Add(a, hn::Add(hn::Mul(ab, bAtAnchor), hn::Mul(ac, cAtAnchor))));
        store(3 * i + 1, hn::Add(hn::Mul(ab, bPerX), hn::Mul(ac, cPerX)));
        store(3 * i + 2, hn::Add(hn::Mul(ab, bPerY), hn::Mul(ac, cPerY)));
    };
    makePlane(0, q[0], q[1], q[2]);
    Doubles largest = one;
    for (std::size_t i = 0; i < kVaryings; ++i) {
        std::array<Doubles, 3> value;
        for (std::size_t k = 0; k < 3; ++k) {
            const Doubles v = hn::PromoteTo(tag, hn::Load(narrow, stage.varyings[k][i].data()));
            largest = hn::Max(largest, hn::Abs(v));
            value[k] = hn::Mul(v, q[k]);
        }
        makePlane(i + 1, value[0], value[1], value[2]);
    }

    // float32 keeps 24 bits of the largest term of a sum; what is left of them after the terms cancel and after the
    // division by w must be enough for a colour.
    constexpr double kEnough = 1 << 12;
    const Doubles slope = hn::Add(hn::Add(hn::Abs(bPerX), hn::Abs(bPerY)), hn::Add(hn::Abs(cPerX), hn::Abs(cPerY)));
    const Doubles reach =
        hn::Add(hn::Min(hn::Add(hn::Add(hn::Abs(abX), hn::Abs(abY)), hn::Add(hn::Abs(acX), hn::Abs(acY))),
                        hn::Set(tag, 2.0 * kTileSide)),
                hn::Set(tag, 2.0 * kBlockSide));
    const Doubles ratio = hn::Div(hn::Max(hn::Max(q[0], q[1]), q[2]), hn::Min(hn::Min(q[0], q[1]), q[2]));
    const Doubles cancelled = hn::Mul(hn::Mul(slope, reach), hn::Mul(ratio, largest));
    const std::uint32_t enough = BitsOf(tag, hn::Lt(cancelled, hn::Set(tag, kEnough)));
    for (std::size_t lane = 0; lane < count; ++lane) {
        out[lane].exact = (enough >> lane & 1) == 0;
        for (std::size_t i = 0; i < planes.size(); ++i)
            out[lane].plane[i] = planes[i][lane];
    }
}

inline void SetUpColors(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    CornerStage stage{};
    for (std::size_t first = 0; first < worker.visible.size(); first += kDoubles) {
        const std::size_t count = std::min(kDoubles, worker.visible.size() - first);
        for (std::size_t lane = 0; lane < count; ++lane) {
            const VisibleTriangle& visible = worker.visible[first + lane];
            if ((visible.source & kPiece) != 0)
                StagePiece(job, visible.chunk->pieces[visible.source & ~kPiece].triangle, lane, stage);
            else
                StageFace(job, visible.source, lane, stage);
            stage.anchorX[lane] = double(visible.x0) + origin.x + 0.5;
            stage.anchorY[lane] = double(visible.y0) + origin.y + 0.5;
            if ((visible.source & kPiece) == 0)
                for (std::size_t k = 0; k < 3; ++k)
                    stage.invW[k][lane] = 1 / stage.invW[k][lane];
        }
        MakePlanes<3>(job, stage, count, &worker.planes[first]);
    }
}

/// 255 c + 1/2 cut to whole numbers, c held within 0..1.
HWY_INLINE Ints ChannelOf(Floats c)
{
    constexpr FloatTag tag;
    const Floats held = hn::Min(hn::Max(c, hn::Zero(tag)), hn::Set(tag, 1.0F));
    return hn::ConvertTo(IntTag(), hn::Add(hn::Mul(held, hn::Set(tag, 255.0F)), hn::Set(tag, 0.5F)));
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
    const std::uint32_t lanes = share.lanes >> (v * kPerVector);
    const std::array<std::uint8_t, 8> bytes{static_cast<std::uint8_t>(lanes), static_cast<std::uint8_t>(lanes >> 8)};
    hn::Store(hn::IfThenElse(hn::LoadMaskBits(tag, bytes.data()), color, hn::Load(tag, out)), tag, out);
}

/// The interpolated colour of a triangle over its lanes of a block.
HWY_INLINE void ShadeColors(const AttributePlanes& planes, const VisibleTriangle& visible, const BlockShare& share,
                            TileSamples& samples)
{
    constexpr FloatTag tag;
    const float x = static_cast<float>(blockColumn(share.block) * kBlockSide) - visible.x0;
    const float y = static_cast<float>(blockRow(share.block) * kBlockSide) - visible.y0;
    for (std::size_t v = 0; v < kVectors; ++v) {
        const Floats laneX = hn::ConvertTo(tag, hn::Load(IntTag(), kPattern.x.data() + v * kPerVector));
        const Floats laneY = hn::ConvertTo(tag, hn::Load(IntTag(), kPattern.y.data() + v * kPerVector));
        const auto plane = [&](std::size_t i) HWY_ATTR {
            const float* p = planes.plane.data() + 3 * i;
            const Floats offset = hn::Add(hn::Mul(hn::Set(tag, p[1]), laneX), hn::Mul(hn::Set(tag, p[2]), laneY));
            return hn::Add(hn::Set(tag, p[0] + p[1] * x + p[2] * y), offset);
        };
        const Floats w = hn::Div(hn::Set(tag, 1.0F), plane(0));
        BlendColor(PackChannels(hn::Mul(plane(1), w), hn::Mul(plane(2), w), hn::Mul(plane(3), w)), share, v, samples);
    }
}

inline void ShadeInterpolated(const FrameJob& job, Worker& worker, TileOrigin origin)
{
    SetUpColors(job, worker, origin);
    for (const BlockShare& share : worker.shares) {
        const AttributePlanes& planes = worker.planes[share.visible];
        const VisibleTriangle& visible = worker.visible[share.visible];
        if (planes.exact)
            shadeExactly(job, visible, share, origin, worker.samples);
        else
            ShadeColors(planes, visible, share, worker.samples);
    }
}

/// Shadings with one colour a face.
inline void ShadeUniform(const FrameJob& job, Worker& worker)
{
    for (std::size_t i = 0; i < worker.visible.size(); ++i)
        worker.planes[i].color =
            faceUniforms(*job.scene, faceOf(*worker.visible[i].chunk, worker.visible[i].source), job.rules.shading)
                .color;
    for (const BlockShare& share : worker.shares)
        for (std::size_t v = 0; v < kVectors; ++v)
            BlendColor(hn::Set(UintTag(), worker.planes[share.visible].color), share, v, worker.samples);
}

inline void ShadeDepth(const FrameJob& job, Worker& worker)
{
    constexpr IntTag tag;
    const Ints flip = hn::Set(tag, depthFlip(job.rules.depthCompare));
    for (const BlockShare& share : worker.shares)
        for (std::size_t v = 0; v < kVectors; ++v) {
            const std::int32_t* key = worker.samples.key.data() + std::size_t(share.block) * kLanes + v * kPerVector;
            const Floats depth = hn::BitCast(FloatTag(), hn::Xor(hn::Load(tag, key), flip));
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
    if (worker.planes.size() < worker.visible.size())
        worker.planes.resize(worker.visible.size());
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
