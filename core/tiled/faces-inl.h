// Faces: reject, cull, set up many at once and sort them into the tiles. Included once for each target: see README.md.
#if defined(RASTERLENS_TILED_FACES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_FACES_INL_H
#undef RASTERLENS_TILED_FACES_INL_H
#else
#define RASTERLENS_TILED_FACES_INL_H
#endif

#include "core/tiled/batch-inl.h"
#include "core/tiled/exact_path.h"
#include "core/tiled/frame_job.h"
#include "core/tiled/lanes-inl.h"
#include "core/tiled/planes-inl.h"
#include "core/tiled/setup-inl.h"
#include "core/tiled/texels-inl.h"
#include "core/tiled/varyings-inl.h"
#include "core/tiled/vertices-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// Puts the pieces of a face that went through the scalar stages into the queue.
inline void QueueOutsideFace(const FrameJob& job, Chunk& chunk, std::uint32_t face, std::array<std::int32_t, 3> codes,
                             SetupQueue& queue, auto&& makeRoom)
{
    processOutsideFace(job, chunk, face, codes);
    for (const ScreenTriangle& triangle : chunk.clipped) {
        makeRoom();
        const std::size_t at = queue.count++;
        for (std::size_t k = 0; k < 3; ++k) {
            const ScreenVertex& v = triangle.vertices[k];
            queue.position[k][at] = {static_cast<std::int32_t>(v.position.x * kUnit),
                                     static_cast<std::int32_t>(v.position.y * kUnit)};
            queue.depth[k][at] = v.depth;
        }
        queue.source[at] = kPiece | static_cast<std::uint32_t>(chunk.pieces.size());
        chunk.pieces.push_back(triangle);
    }
}

/// A vector of triangles ready for the bins.
struct alignas(64) SetupLanes {
    // Records as they are in the tile of the triangle's first sample: lane after lane, so many numbers each.
    std::array<std::int32_t, 4 * kDoubles> gradients; ///< as the record has them
    std::array<std::int32_t, 4 * kDoubles> constants; ///< c, nearest
    std::array<double, 4 * kDoubles> depth;           ///< source and bounds as 64 bits, depth plane
    ColorPlaneLanes colors;
    TexelPlaneLanes texels;
    // What it takes to move them to other tiles.
    std::array<std::array<std::int32_t, kDoubles>, 3> a, b;
    std::array<std::array<double, kDoubles>, 3> c; ///< not held within 32 bits
    std::array<std::int32_t, kDoubles> x0, y0, x1, y1;
    std::array<std::int32_t, kDoubles> column0, row0, column1, row1; ///< of tiles
    std::array<std::int32_t, kDoubles> tile;                         ///< of the first sample
    std::array<std::uint32_t, kDoubles> varyings{};                  ///< numbers of VaryingPlanes
    std::uint32_t used;    ///< a bit for each lane whose bounds hold samples; the masks below have a bit a lane too
    std::uint32_t alone;   ///< lanes of triangles that lie in one tile
    std::uint32_t exact;   ///< lanes that the fast path cannot draw everywhere
    std::uint32_t needles; ///< lanes of `exact` that may leave samples out: without a plane of depth, or with holes

    [[nodiscard]] HWY_INLINE std::int32_t nearest(std::size_t lane) const
    {
        return std::max(constants[4 * lane + 3], 0); // bits of depths order like them from 0 on
    }

    HWY_INLINE void copyTo(std::size_t lane, const FrameJob& job, Chunk::Slot slot) const
    {
        TileTriangle& t = *slot.triangle;
        std::memcpy(&t.gradients, gradients.data() + 4 * lane, 4 * sizeof(std::int32_t));
        std::memcpy(&t.c, constants.data() + 4 * lane, 4 * sizeof(std::int32_t));
        std::memcpy(&t.source, depth.data() + 4 * lane, 4 * sizeof(double));
        if (job.interpolatesColor() || job.hasTexels())
            colors.copyTo(lane, *slot.colors);
        else
            slot.colors->extra = varyings[lane];
        if (slot.texels != nullptr)
            texels.copyTo(lane, *slot.texels);
    }
};

/// How much nearer than its corners a sample of a plane may come out. Only float32 depths are compared with this slack.
constexpr double kDepthSlack = 0x1p-28;

/// Tiles of samples along an axis.
HWY_INLINE HalfInts TilesOf(HalfInts samples, int pitch)
{
    constexpr HalfFloatTag tag;
    const HalfFloats middle = hn::Add(hn::ConvertTo(tag, samples), hn::Set(tag, 0.5F));
    return hn::ConvertTo(HalfIntTag(), hn::Mul(middle, hn::Set(tag, 1.0F / static_cast<float>(pitch))));
}

/// Bounds of triangles in samples, and where they lie in the tiles.
///
/// out  bounds in the tile of the first sample, a byte each as TileTriangle has them
HWY_INLINE HalfInts StoreBounds(const TileGrid& grid, const SampleLanes& columns, const SampleLanes& rows,
                                HalfInts column0, HalfInts row0, SetupLanes& out)
{
    constexpr HalfIntTag tag;
    const HalfInts column1 = TilesOf(columns.last, grid.pitch);
    const HalfInts row1 = TilesOf(rows.last, grid.pitch);
    hn::Store(columns.first, tag, out.x0.data());
    hn::Store(columns.last, tag, out.x1.data());
    hn::Store(rows.first, tag, out.y0.data());
    hn::Store(rows.last, tag, out.y1.data());
    hn::Store(column0, tag, out.column0.data());
    hn::Store(column1, tag, out.column1.data());
    hn::Store(row0, tag, out.row0.data());
    hn::Store(row1, tag, out.row1.data());
    hn::Store(hn::Add(hn::Mul(row0, hn::Set(tag, grid.columns)), column0), tag, out.tile.data());
    out.alone = BitsOf(tag, hn::And(hn::Eq(column0, column1), hn::Eq(row0, row1)));
    const HalfInts pitch = hn::Set(tag, grid.pitch);
    const HalfInts last = hn::Set(tag, grid.pitch - 1);
    const HalfInts originX = hn::Mul(column0, pitch);
    const HalfInts originY = hn::Mul(row0, pitch);
    const HalfInts low = hn::Or(hn::Sub(columns.first, originX), hn::ShiftLeft<8>(hn::Sub(rows.first, originY)));
    const HalfInts high = hn::Or(hn::Min(hn::Sub(columns.last, originX), last),
                                 hn::ShiftLeft<8>(hn::Min(hn::Sub(rows.last, originY), last)));
    return hn::Or(low, hn::ShiftLeft<16>(high));
}

HWY_INLINE Doubles SourceAndBounds(const SetupQueue& queue, std::size_t at, HalfInts bounds)
{
    using Wide = hn::RebindToUnsigned<DoubleTag>;
    using Half = hn::RebindToUnsigned<HalfIntTag>;
    const auto sources = hn::PromoteTo(Wide(), hn::LoadU(Half(), queue.source.data() + at));
    return hn::BitCast(DoubleTag(),
                       hn::Or(sources, hn::ShiftLeft<32>(hn::PromoteTo(Wide(), hn::BitCast(Half(), bounds)))));
}

HWY_INLINE void StageColors(const FrameJob& job, const Chunk& chunk, const SetupQueue& queue, std::size_t at,
                            std::uint32_t lanes, CornerColors& colors)
{
    for (std::uint32_t unused = ~lanes & ((1U << kDoubles) - 1); unused != 0; unused &= unused - 1)
        for (auto& corner : colors.lanes)
            corner[static_cast<std::size_t>(std::countr_zero(unused))] = glm::vec4(0);
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
        const std::uint32_t source = queue.source[at + lane];
        if (HWY_UNLIKELY((source & kPiece) != 0))
            StagePieceColors(chunk.pieces[source & ~kPiece], lane, colors);
        else
            StageFaceColors(job, source, lane, colors);
    }
}

/// Planes of any kCount varyings, for the lanes in use.
template <std::size_t kCount>
inline void SetUpVaryings(const FrameJob& job, Chunk& chunk, const SetupQueue& queue, std::size_t at,
                          const PlaneGeometry& geometry, HalfInts anchorX, HalfInts anchorY, SetupLanes& lanes)
{
    VaryingStage<kCount> stage;
    std::array<VaryingPlanes<kCount>*, kDoubles> out{};
    for (std::uint32_t bits = lanes.used; bits != 0; bits &= bits - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
        const std::uint32_t source = queue.source[at + lane];
        if (HWY_UNLIKELY((source & kPiece) != 0))
            StagePieceVaryings(chunk.pieces[source & ~kPiece], lane, stage);
        else
            StageFaceVaryings(job, source, lane, stage);
        lanes.varyings[lane] = chunk.varyingCount++;
        out[lane] = &chunk.varyings<VaryingPlanes<kCount>>(lanes.varyings[lane]);
    }
    MakeVaryingPlanes(job.rules, geometry, stage, lanes.used, anchorX, anchorY, out);
}

/// Colours, and what a texture needs beside them.
HWY_INLINE void SetUpColors(const FrameJob& job, const Chunk& chunk, const SetupQueue& queue, std::size_t at,
                            const PlaneGeometry& geometry, HalfInts anchorX, HalfInts anchorY, SetupLanes& lanes)
{
    CornerColors colors;
    StageColors(job, chunk, queue, at, lanes.used, colors);
    if (!job.hasTexels()) {
        MakeColorPlanes(job.rules, geometry, colors, lanes.used, anchorX, anchorY, nullptr, lanes.colors);
        return;
    }
    TexelStage stage;
    for (std::uint32_t bits = lanes.used; bits != 0; bits &= bits - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
        StageTexels(job, chunk, queue.source[at + lane], lane, stage);
    }
    if (HWY_UNLIKELY(job.leavesTexels))
        LeaveTexels(job, lanes.used, stage);
    const TextureLanes textured = MakeTexelPlanes(job.rules, job.texelErrors, geometry, colors, stage, lanes.texels);
    MakeColorPlanes(job.rules, geometry, colors, lanes.used, anchorX, anchorY, &textured, lanes.colors);
}

/// What the shading interpolates.
HWY_INLINE void SetUpPlanes(const FrameJob& job, Chunk& chunk, const SetupQueue& queue, std::size_t at,
                            const PlaneGeometry& geometry, HalfInts anchorX, HalfInts anchorY, SetupLanes& lanes)
{
    const auto setUp = [&](auto count) HWY_ATTR {
        SetUpVaryings<count()>(job, chunk, queue, at, geometry, anchorX, anchorY, lanes);
    };
    switch (job.rules.shading) {
    case Shading::Gouraud:
    case Shading::Texture: SetUpColors(job, chunk, queue, at, geometry, anchorX, anchorY, lanes); break;
    case Shading::Phong: setUp(std::integral_constant<std::size_t, kPhongVaryings>()); break;
    case Shading::Normals: setUp(std::integral_constant<std::size_t, kNormalVaryings>()); break;
    case Shading::Uv: setUp(std::integral_constant<std::size_t, kUvVaryings>()); break;
    case Shading::Flat:
    case Shading::RandomFlat:
    case Shading::Depth:
    case Shading::Overdraw:
    case Shading::TriangleId:
    case Shading::MipLevel: break;
    }
}

/// The triangles that may have holes, a bit each.
inline std::uint32_t LanesWithMasks(const FrameJob& job, const Chunk& chunk, const SetupQueue& queue, std::size_t at,
                                    std::uint32_t lanes)
{
    std::uint32_t masked = 0;
    for (; lanes != 0; lanes &= lanes - 1) {
        const int lane = std::countr_zero(lanes);
        const std::uint32_t source = queue.source[at + static_cast<std::size_t>(lane)];
        if (maskOfFace(*job.scene, faceOf(chunk, source)) != nullptr)
            masked |= 1U << lane;
    }
    return masked;
}

/// Lays down the edges' gradients, their values at the anchor, and the nearest depth.
HWY_INLINE void StoreEdges(const TriangleEdges& edges, HalfInts anchorX, HalfInts anchorY, HalfFloats nearest,
                           SetupLanes& out)
{
    constexpr HalfIntTag tag;
    std::array<HalfInts, 3> c;
    for (std::size_t k = 0; k < 3; ++k) {
        hn::Store(edges.edge[k].a, tag, out.a[k].data());
        hn::Store(edges.edge[k].b, tag, out.b[k].data());
        c[k] = edges.heldAt(k, anchorX, anchorY);
        hn::Store(edges.at(k, anchorX, anchorY), DoubleTag(), out.c[k].data());
    }
    hn::StoreInterleaved4(c[0], c[1], c[2], hn::BitCast(tag, nearest), tag, out.constants.data());
}

/// Lays down the gradients as TileTriangle has them.
HWY_INLINE void StoreGradients(const std::array<EdgeLanes, 3>& edges, SetupLanes& out)
{
    constexpr HalfIntTag tag;
    const auto narrow = hn::Lt(Steepest(edges), hn::Set(tag, 1 << 15));
    const auto choose = [&](std::size_t k, HalfInts wide) HWY_ATTR {
        const HalfInts lower = hn::And(edges[k].a, hn::Set(HalfIntTag(), 0xffff));
        return hn::IfThenElse(narrow, hn::Or(lower, hn::ShiftLeft<16>(edges[k].b)), wide);
    };
    hn::StoreInterleaved4(choose(0, edges[0].a), choose(1, edges[1].a), choose(2, edges[0].b),
                          hn::IfThenElse(narrow, hn::Set(tag, TileTriangle::kNarrow), edges[1].b), tag,
                          out.gradients.data());
}

/// Multi-sampling: lays down the gradients as TileTriangle has them then.
HWY_INLINE void StoreFineGradients(const TriangleEdges& edges, SetupLanes& out)
{
    const auto fine = [](HalfInts gradient, HalfInts rest)
                          HWY_ATTR { return hn::Or(hn::ShiftLeft<4>(gradient), rest); };
    const auto& [ab, bc, ca] = edges.edge;
    hn::StoreInterleaved4(fine(ab.a, edges.rest[0]), fine(bc.a, edges.rest[1]), fine(ab.b, edges.rest[2]),
                          hn::ShiftLeft<4>(bc.b), HalfIntTag(), out.gradients.data());
}

/// in   the last samples of the bounds
HWY_INLINE PlaneGeometry GeometryOf(const PixelPattern& pattern, const std::array<HalfInts, 3>& x,
                                    const std::array<HalfInts, 3>& y, HalfInts anchorX, HalfInts anchorY,
                                    Doubles inverseArea, HalfInts lastColumn, HalfInts lastRow)
{
    const auto toCentre = [](HalfInts samples, HalfInts from) HWY_ATTR {
        return hn::Sub(hn::Add(hn::ShiftLeft<8>(samples), hn::Set(HalfIntTag(), kUnit / 2)), from);
    };
    return {hn::Sub(x[1], x[0]),
            hn::Sub(y[1], y[0]),
            hn::Sub(x[2], x[0]),
            hn::Sub(y[2], y[0]),
            toCentre(anchorX, x[0]),
            toCentre(anchorY, y[0]),
            inverseArea,
            hn::Sub(lastColumn, anchorX),
            hn::Sub(lastRow, anchorY),
            static_cast<float>(pattern.reach) / 16};
}

/// The edges of a vector of triangles.
///
/// in   in units; where the winding is the other one
/// out  the bounds, in samples; the edges (returned, they would be copied, which costs 4 % of the stage with GCC 12)
HWY_INLINE void MakeTriangleEdges(const FrameJob& job, const std::array<HalfInts, 3>& x,
                                  const std::array<HalfInts, 3>& y, hn::Mask<HalfIntTag> swapped, SampleLanes& columns,
                                  SampleLanes& rows, TriangleEdges& edges)
{
    const Rules& rules = job.rules;
    // Inside is where all three edges are positive: B and C change places where the triangle winds the other way.
    const HalfInts bx = hn::IfThenElse(swapped, x[2], x[1]);
    const HalfInts by = hn::IfThenElse(swapped, y[2], y[1]);
    const HalfInts cx = hn::IfThenElse(swapped, x[1], x[2]);
    const HalfInts cy = hn::IfThenElse(swapped, y[1], y[2]);
    const HalfInts lowX = Min3(x[0], x[1], x[2]), highX = Max3(x[0], x[1], x[2]);
    const HalfInts lowY = Min3(y[0], y[1], y[2]), highY = Max3(y[0], y[1], y[2]);
    const int reach = ReachInUnits(job);
    columns = SamplesBetween(lowX, highX, rules.columns(), reach);
    rows = SamplesBetween(lowY, highY, rules.rows(), reach);
    edges.edge = {MakeEdge(x[0], y[0], bx, by, rules), MakeEdge(bx, by, cx, cy, rules),
                  MakeEdge(cx, cy, x[0], y[0], rules)};
    edges.x = columns.first;
    edges.y = rows.first;
    edges.compact = !job.pattern.isOn() && IsCompact(lowX, lowY, highX, highY, edges.x, edges.y);
    EvaluateEdges(rules, edges);
}

/// Sets up a vector of triangles from the queue; `present`: a bit for each lane that holds one.
HWY_INLINE void SetUpLanes(const FrameJob& job, Chunk& chunk, const SetupQueue& queue, std::size_t at,
                           std::uint32_t present, SetupLanes& out)
{
    constexpr HalfIntTag tag;
    constexpr DoubleTag wide;
    const Rules& rules = job.rules;
    std::array<HalfInts, 3> x, y;
    std::array<CornerLanes, 3> corner;
    LoadCorners(rules, queue, at, present, x, y, corner);
    const Doubles area = TwiceArea(hn::Sub(corner[1].x, corner[0].x), hn::Sub(corner[1].y, corner[0].y),
                                   hn::Sub(corner[2].x, corner[0].x), hn::Sub(corner[2].y, corner[0].y));
    const auto swapped =
        hn::Gt(hn::DemoteTo(tag, hn::IfThenElseZero(hn::Lt(area, hn::Zero(wide)), hn::Set(wide, 1.0))), hn::Zero(tag));

    SampleLanes columns, rows;
    TriangleEdges edges;
    MakeTriangleEdges(job, x, y, swapped, columns, rows, edges);
    const auto tooSteep = TooSteep(edges.edge);
    if (!job.pattern.isOn())
        NarrowBounds(edges, tooSteep, columns, rows);
    out.used = present & ~BitsOf(tag, hn::Or(hn::Lt(columns.last, columns.first), hn::Lt(rows.last, rows.first)));
    if (out.used == 0)
        return;

    const HalfInts column0 = TilesOf(columns.first, job.grid.pitch);
    const HalfInts row0 = TilesOf(rows.first, job.grid.pitch);
    const HalfInts bounds = StoreBounds(job.grid, columns, rows, column0, row0, out);
    const HalfInts anchorX = hn::And(columns.first, hn::Set(tag, -kBlockSide));
    const HalfInts anchorY = hn::And(rows.first, hn::Set(tag, -kBlockSide));
    const Doubles wideX = hn::PromoteTo(wide, anchorX);
    const Doubles wideY = hn::PromoteTo(wide, anchorY);
    const Doubles inverseArea = hn::Div(hn::Set(wide, 1.0), area);
    const PlaneLanes plane = MakeDepthPlane(corner[0], corner[1], corner[2], inverseArea, rules);
    const Doubles nearestCorner = Min3(corner[0].depth, corner[1].depth, corner[2].depth);
    const HalfFloats nearest = hn::DemoteTo( // needles come out at any depth
        HalfFloatTag(), hn::IfThenElseZero(plane.plane, hn::Sub(nearestCorner, hn::Set(wide, kDepthSlack))));
    StoreEdges(edges, anchorX, anchorY, nearest, out);
    if (job.pattern.isOn())
        StoreFineGradients(edges, out);
    else
        StoreGradients(edges.edge, out);
    const Doubles depth = hn::Add(plane.origin, hn::Add(hn::Mul(plane.perX, wideX), hn::Mul(plane.perY, wideY)));
    hn::StoreInterleaved4(SourceAndBounds(queue, at, bounds), depth, plane.perX, plane.perY, wide, out.depth.data());
    out.needles = ~BitsOf(wide, plane.plane);
    if (HWY_UNLIKELY(job.masked))
        out.needles |= LanesWithMasks(job, chunk, queue, at, out.used);
    out.exact = BitsOf(tag, tooSteep) | out.needles;

    if (job.interpolates()) {
        const PlaneGeometry geometry =
            GeometryOf(job.pattern, x, y, anchorX, anchorY, inverseArea, columns.last, rows.last);
        SetUpPlanes(job, chunk, queue, at, geometry, anchorX, anchorY, out);
    }
}

/// A triangle in one of several tiles.
struct TilePart {
    int x0, y0, x1, y1;        ///< bounds in samples of the tile, both ends included
    int toX, toY;              ///< from the anchor in the triangle's first tile to the one in this
    std::array<double, 3> c{}; ///< edge values at the anchor
    bool touches = true,
         covers = true; ///< whether it may cover samples of the tile; whether all that are on the target
};

inline TilePart PartInTile(const FrameJob& job, const SetupLanes& lanes, std::size_t i, int column, int row)
{
    const int originX = column * job.grid.pitch;
    const int originY = row * job.grid.pitch;
    const int last = job.grid.pitch - 1;
    const auto anchor = [](int sample) { return sample & -kBlockSide; };
    const int x0 = std::max(lanes.x0[i] - originX, 0);
    const int y0 = std::max(lanes.y0[i] - originY, 0);
    const int x1 = std::min(lanes.x1[i] - originX, last);
    const int y1 = std::min(lanes.y1[i] - originY, last);
    const int toX = originX + anchor(x0) - anchor(lanes.x0[i]);
    const int toY = originY + anchor(y0) - anchor(lanes.y0[i]);
    TilePart part{x0, y0, x1, y1, toX, toY};
    // Read from the local variables, not from `part`: the compiler would read two fields of it as one number, and that
    // read waits until all earlier stores have reached the cache.
    part.covers = (x0 | y0) == 0 && x1 == std::min(last, job.rules.columns() - originX - 1) &&
                  y1 == std::min(last, job.rules.rows() - originY - 1);
    const double width = x1 - anchor(x0);
    const double height = y1 - anchor(y0);
    const double a[3] = {double(lanes.a[0][i]), double(lanes.a[1][i]), double(lanes.a[2][i])};
    const double b[3] = {double(lanes.b[0][i]), double(lanes.b[1][i]), double(lanes.b[2][i])};
    // Steep edges have values of up to 2^56, which double rounds a few times.
    const double rounded = (lanes.exact >> i & 1) != 0 ? 0x1p10 : 0;
    const double sides =
        job.pattern.reach / 16.0; // a sample of a pattern is so far from the centre, and c lacks its rest
    const double doubt = rounded + (job.pattern.isOn() ? 1 : 0);
    for (std::size_t k = 0; k < 3; ++k)
        part.c[k] = lanes.c[k][i] + a[k] * toX + b[k] * toY;
    // A triangle in a single row or column of tiles has samples in each of them, or next to none.
    const bool alwaysTouches =
        (lanes.column0[i] == lanes.column1[i] || lanes.row0[i] == lanes.row1[i]) && (lanes.exact >> i & 1) == 0;
    if (HWY_LIKELY(alwaysTouches && !part.covers))
        return part;
    for (std::size_t k = 0; k < 3; ++k) {
        const double margin = doubt + sides * (std::abs(a[k]) + std::abs(b[k]));
        part.touches &= part.c[k] + std::max(a[k], 0.0) * width + std::max(b[k], 0.0) * height >= -margin;
        part.covers &= part.c[k] + std::min(a[k], 0.0) * width + std::min(b[k], 0.0) * height >= margin;
    }
    part.covers &= (lanes.needles >> i & 1) == 0;
    return part;
}

/// Moves the anchor of affine colours: sums of whole numbers are exact.
inline void MoveAnchor(ColorPlanes& planes, int x, int y)
{
    for (std::size_t i = 1; i < 4; ++i) {
        const auto alongX = static_cast<std::uint32_t>(planes.perX[i]) * static_cast<std::uint32_t>(x);
        const auto alongY = static_cast<std::uint32_t>(planes.perY[i]) * static_cast<std::uint32_t>(y);
        planes.origin[i] = static_cast<std::int32_t>(static_cast<std::uint32_t>(planes.origin[i]) + alongX + alongY);
    }
    planes.x0 += x;
    planes.y0 += y;
}

/// Writes a triangle into the bin of a tile, if it may be seen there; what it hides leaves the bin.
inline void EmitToTile(const FrameJob& job, Chunk& chunk, const SetupLanes& lanes, std::size_t i, int column, int row,
                       bool hides)
{
    Bin& bin = chunk.bins[job.grid.index(column, row)];
    const std::int32_t nearest = lanes.nearest(i);
    if (hides && nearest >= bin.farthest)
        return;
    const TilePart part = PartInTile(job, lanes, i, column, row);
    if (!part.touches)
        return;
    const double perX = lanes.depth[4 * i + 2];
    const double perY = lanes.depth[4 * i + 3];
    const double depthOrigin = lanes.depth[4 * i + 1] + perX * part.toX + perY * part.toY;
    if (hides && part.covers) {
        double farthest = depthOrigin + std::max(perX, 0.0) * part.x1 + std::max(perY, 0.0) * part.y1;
        if (job.pattern.isOn())
            farthest += job.pattern.depthReach(perX, perY);
        const std::int32_t key = depthKey(static_cast<float>(farthest));
        if (key < bin.nearest) {
            chunk.clear(bin);
            bin.nearest = nearest;
        }
        bin.farthest = std::min(bin.farthest, key);
    }
    const Chunk::Slot slot = chunk.append(bin, nearest);
    lanes.copyTo(i, job, slot);
    TileTriangle& t = *slot.triangle;
    t.depthOrigin = depthOrigin;
    t.x0 = static_cast<std::uint8_t>(part.x0);
    t.y0 = static_cast<std::uint8_t>(part.y0);
    t.x1 = static_cast<std::uint8_t>(part.x1);
    t.y1 = static_cast<std::uint8_t>(part.y1);
    if (job.interpolatesColor() && !job.pattern.isOn() && slot.colors->way == ColorWay::Affine && !t.isLarge())
        MoveAnchor(*slot.colors, part.toX, part.toY); // CoverTriangle() counts from there
    if ((lanes.exact >> i & 1) == 0) {
        for (std::size_t k = 0; k < 3; ++k)
            t.c[k] = static_cast<std::int32_t>(std::clamp(part.c[k], -double(kFarInside), double(kFarInside)));
        return;
    }
    t.source = kPiece | static_cast<std::uint32_t>(chunk.pieces.size() - 1);
    if (part.covers)
        t.gradients = {}, t.c = {};
    else
        t.makeExact();
}

/// Writes a triangle that the fast path cannot draw, or that lies in several tiles, into their bins.
inline void EmitToTiles(const FrameJob& job, Chunk& chunk, const SetupLanes& lanes, std::size_t i, std::uint32_t source)
{
    if ((lanes.exact >> i & 1) != 0) {
        const ScreenTriangle triangle = screenTriangle(job, chunk, source);
        chunk.pieces.push_back(triangle);
    }
    const bool hides = job.usualDepth();
    for (int row = lanes.row0[i]; row <= lanes.row1[i]; ++row)
        for (int column = lanes.column0[i]; column <= lanes.column1[i]; ++column)
            EmitToTile(job, chunk, lanes, i, column, row, hides);
}

/// Sets up one vector of triangles from the queue and writes them into the bins.
HWY_INLINE void SetUpAndBin(const FrameJob& job, Chunk& chunk, const SetupQueue& queue, std::size_t at,
                            std::size_t count)
{
    SetupLanes lanes;
    SetUpLanes(job, chunk, queue, at, (1U << count) - 1, lanes);
    for (std::uint32_t bits = lanes.used; bits != 0; bits &= bits - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(bits));
        if (HWY_LIKELY((lanes.alone & ~lanes.exact) >> i & 1))
            lanes.copyTo(i, job, chunk.append(chunk.bins[static_cast<std::size_t>(lanes.tile[i])], lanes.nearest(i)));
        else
            EmitToTiles(job, chunk, lanes, i, queue.source[at + i]);
    }
}

/// Sets up whole vectors of the queue; `all`: the rest too.
HWY_INLINE void DrainQueue(const FrameJob& job, Chunk& chunk, SetupQueue& queue, bool all)
{
    std::size_t at = 0;
    for (; at + kDoubles <= queue.count; at += kDoubles)
        SetUpAndBin(job, chunk, queue, at, kDoubles);
    if (all && at < queue.count) {
        for (std::size_t i = queue.count; i < at + kDoubles; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                queue.position[k][i] = {0, 0};
                queue.depth[k][i] = 0;
            }
        SetUpAndBin(job, chunk, queue, at, queue.count - at);
        queue.count = at;
    }
    queue.moveToFront(at);
}

/// One vector of a batch: counts fates, queues what is to be drawn.
HWY_INLINE void SortFaces(const FrameJob& job, Chunk& chunk, const FaceBatch& batch, std::uint32_t firstFace,
                          std::size_t at, std::uint32_t present, SetupQueue& queue)
{
    const Rules& rules = job.rules;
    const FaceVerdicts verdicts = JudgeFaces(job, batch, at);
    const std::uint32_t outside = (rules.facing == Facing::ScreenArea ? verdicts.outside : ~0U) & present;
    const std::uint32_t inside = present & ~outside;
    const std::uint32_t degenerate = inside & verdicts.degenerate;
    const std::uint32_t culledFront = rules.culling == Culling::Front ? inside & ~degenerate & verdicts.front : 0;
    const std::uint32_t culledBack = rules.culling == Culling::Back ? inside & ~degenerate & ~verdicts.front : 0;
    const std::uint32_t drawn = inside & ~(degenerate | culledFront | culledBack);
    Statistics::Faces& faces = chunk.faces;
    faces.submitted += static_cast<unsigned>(std::popcount(inside));
    faces.degenerate += static_cast<unsigned>(std::popcount(degenerate));
    faces.culledFront += static_cast<unsigned>(std::popcount(culledFront));
    faces.culledBack += static_cast<unsigned>(std::popcount(culledBack));
    faces.rasterized += static_cast<unsigned>(std::popcount(drawn));
    const auto makeRoom = [&] {
        if (queue.count >= kFaceBatch)
            DrainQueue(job, chunk, queue, false);
    };
    makeRoom();
    const std::uint32_t wanted = drawn & verdicts.holdsSamples;
    if (HWY_LIKELY(outside == 0)) {
        QueueFaces(batch, firstFace, at, wanted, queue);
        return;
    }
    for (std::uint32_t bits = wanted | outside; bits != 0; bits &= bits - 1) { // in the order of the faces
        const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
        const std::size_t i = at + lane;
        if ((outside >> lane & 1) == 0) {
            QueueFaces(batch, firstFace, at, 1U << lane, queue);
            continue;
        }
        const auto code = [&](std::size_t k) {
            const ScreenXY& p = batch.position[k][i];
            return p.x == kOutside ? p.y : 0;
        };
        QueueOutsideFace(job, chunk, static_cast<std::uint32_t>(firstFace + i), {code(0), code(1), code(2)}, queue,
                         makeRoom);
    }
}

inline void ProcessFaces(const FrameJob& job, Chunk& chunk, std::uint32_t begin, std::uint32_t end)
{
    SetupQueue queue;
    FaceBatch batch;
    for (std::uint32_t first = begin; first < end; first += kFaceBatch) {
        const std::uint32_t count = std::min(kFaceBatch, end - first);
        GatherFaces(job, first, count, batch);
        for (std::uint32_t at = 0; at < count; at += kDoubles) {
            const std::uint32_t lanes = std::min<std::uint32_t>(kDoubles, count - at);
            SortFaces(job, chunk, batch, first, at, (1U << lanes) - 1, queue);
        }
    }
    DrainQueue(job, chunk, queue, true);
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
