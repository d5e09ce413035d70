// Batches of faces: which are to be drawn, and the queue of those. Included once for each target: see README.md.
#if defined(RASTERLENS_TILED_BATCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_BATCH_INL_H
#undef RASTERLENS_TILED_BATCH_INL_H
#else
#define RASTERLENS_TILED_BATCH_INL_H
#endif

#include "core/pipeline/depth_bias.h"
#include "core/settings/depth_rules.h"
#include "core/tiled/frame_job.h"
#include "core/tiled/lanes-inl.h"
#include "core/tiled/setup-inl.h"
#include "core/tiled/vertices-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

constexpr std::uint32_t kFaceBatch = 64;

/// Triangles that passed every test and wait for their set-up, corner by corner.
struct alignas(64) SetupQueue {
    static constexpr std::size_t kCapacity = 2 * kFaceBatch + 16;
    std::array<std::array<ScreenXY, kCapacity>, 3> position;
    std::array<std::array<double, kCapacity>, 3> depth;
    std::array<std::uint32_t, kCapacity> source;
    std::size_t count = 0;

    void moveToFront(std::size_t from)
    {
        const auto move = [&](auto& lanes) {
            std::copy_n(lanes.begin() + std::ptrdiff_t(from), count - from, lanes.begin());
        };
        for (std::size_t k = 0; k < 3; ++k) {
            move(position[k]);
            move(depth[k]);
        }
        move(source);
        count -= from;
    }
};

/// Corners of a batch of faces.
struct alignas(64) FaceBatch {
    std::array<std::array<ScreenXY, kFaceBatch>, 3> position;
    std::array<std::array<double, kFaceBatch>, 3> depth;
    std::array<ScreenPoint, 3 * kFaceBatch> corners; ///< where the frame keeps none
};

HWY_INLINE void GatherFaces(const FrameJob& job, std::uint32_t first, std::uint32_t count, FaceBatch& batch)
{
    const std::uint32_t* indices = job.scene->mesh.indices.data() + 3 * std::size_t(first);
    if (job.points == nullptr)
        ProcessCorners(job, indices, 3 * std::size_t(count), batch.corners.data());
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t at = 3 * i + k;
            const ScreenPoint& point = job.points != nullptr ? job.points[indices[at]] : batch.corners[at];
            batch.position[k][i] = point.position;
            batch.depth[k][i] = point.depth;
        }
    for (std::size_t i = count; i < kFaceBatch && i % kDoubles != 0; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            batch.position[k][i] = {0, 0};
            batch.depth[k][i] = 0;
        }
}

/// What becomes of the faces in the lanes of a vector, a bit each.
struct FaceVerdicts {
    std::uint32_t outside = 0; ///< a corner is not inside the view volume
    std::uint32_t degenerate = 0;
    std::uint32_t front = 0;
    std::uint32_t holdsSamples = 0; ///< the bounds hold a sample centre
};

/// Units by which samples may lie beside the centres of pixels.
HWY_INLINE int ReachInUnits(const FrameJob& job) { return job.pattern.reach * (kUnit / 16); }

HWY_INLINE FaceVerdicts JudgeFaces(const FrameJob& job, const FaceBatch& batch, std::size_t at)
{
    const Rules& rules = job.rules;
    const int reach = ReachInUnits(job);
    constexpr HalfIntTag tag;
    constexpr DoubleTag wide;
    HalfInts ax, ay, bx, by, cx, cy;
    hn::LoadInterleaved2(tag, &batch.position[0][at].x, ax, ay);
    hn::LoadInterleaved2(tag, &batch.position[1][at].x, bx, by);
    hn::LoadInterleaved2(tag, &batch.position[2][at].x, cx, cy);
    const HalfInts lowX = Min3(ax, bx, cx);
    const Doubles area = TwiceArea(hn::PromoteTo(wide, hn::Sub(bx, ax)), hn::PromoteTo(wide, hn::Sub(by, ay)),
                                   hn::PromoteTo(wide, hn::Sub(cx, ax)), hn::PromoteTo(wide, hn::Sub(cy, ay)));
    const SampleLanes columns = SamplesBetween(lowX, Max3(ax, bx, cx), rules.columns(), reach);
    const SampleLanes rows = SamplesBetween(Min3(ay, by, cy), Max3(ay, by, cy), rules.rows(), reach);
    FaceVerdicts verdicts;
    verdicts.outside = BitsOf(tag, hn::Eq(lowX, hn::Set(tag, kOutside)));
    verdicts.degenerate = BitsOf(wide, hn::Eq(area, hn::Zero(wide)));
    verdicts.front = BitsOf(wide, hn::Gt(hn::Mul(area, hn::Set(wide, rules.frontSign)), hn::Zero(wide)));
    verdicts.holdsSamples = ~BitsOf(tag, hn::Or(hn::Lt(columns.last, columns.first), hn::Lt(rows.last, rows.first)));
    return verdicts;
}

/// Appends faces of a vector of a batch, a bit each. Whole vectors may be written: the queue has room for one more.
HWY_INLINE void QueueFaces(const FaceBatch& batch, std::uint32_t firstFace, std::size_t at, std::uint32_t lanes,
                           SetupQueue& queue)
{
#if HWY_TARGET <= HWY_AVX3
    // Without a loop, whose end would be guessed wrong. Not hn::Compress(), whose table of 2 KB GCC copies each time.
    const auto mask = static_cast<__mmask8>(lanes);
    const auto append = [&](const auto* from, auto* to) HWY_ATTR {
        _mm512_storeu_si512(to + queue.count, _mm512_maskz_compress_epi64(mask, _mm512_load_si512(from + at)));
    };
    for (std::size_t k = 0; k < 3; ++k) {
        append(batch.position[k].data(), queue.position[k].data());
        append(batch.depth[k].data(), queue.depth[k].data());
    }
    constexpr hn::RebindToUnsigned<HalfIntTag> tag;
    const auto faces =
        hn::Add(hn::LoadU(tag, kPattern.place.data()), hn::Set(tag, static_cast<std::uint32_t>(firstFace + at)));
    hn::StoreU(hn::Compress(faces, MaskOf(tag, lanes)), tag, queue.source.data() + queue.count);
    queue.count += static_cast<std::size_t>(std::popcount(lanes));
#else
    for (; lanes != 0; lanes &= lanes - 1) {
        const std::size_t i = at + static_cast<std::size_t>(std::countr_zero(lanes));
        const std::size_t slot = queue.count++;
        for (std::size_t k = 0; k < 3; ++k) {
            queue.position[k][slot] = batch.position[k][i];
            queue.depth[k][slot] = batch.depth[k][i];
        }
        queue.source[slot] = static_cast<std::uint32_t>(firstFace + i);
    }
#endif
}

/// Adds the depth bias of faces to the depths of their corners. Pieces have it already, from the scalar stages.
inline void AddBias(const Rules& rules, const SetupQueue& queue, std::size_t at, std::uint32_t present,
                    std::array<CornerLanes, 3>& corner)
{
    constexpr DoubleTag tag;
    alignas(64) std::array<std::array<double, kDoubles>, 3> depth;
    for (std::size_t k = 0; k < 3; ++k)
        hn::Store(corner[k].depth, tag, depth[k].data());
    for (; present != 0; present &= present - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(present));
        const std::uint32_t source = queue.source[at + lane];
        if ((source & kPiece) != 0 || !isBiased(rules, source))
            continue;
        std::array<ScreenVertex, 3> vertices;
        for (std::size_t k = 0; k < 3; ++k) {
            const ScreenXY& units = queue.position[k][at + lane];
            vertices[k].position = glm::dvec2(units.x, units.y) / double(kUnit);
            vertices[k].depth = depth[k][lane];
        }
        const double bias = depthBias(vertices, rules);
        for (std::size_t k = 0; k < 3; ++k)
            depth[k][lane] += bias;
    }
    for (std::size_t k = 0; k < 3; ++k)
        corner[k].depth = hn::Load(tag, depth[k].data());
}

/// Fetches a vector of triangles from the queue, corner by corner: in units, and in samples with the depth.
HWY_INLINE void LoadCorners(const Rules& rules, const SetupQueue& queue, std::size_t at, std::uint32_t present,
                            std::array<HalfInts, 3>& x, std::array<HalfInts, 3>& y, std::array<CornerLanes, 3>& corner)
{
    constexpr DoubleTag wide;
    const Doubles samplesPerUnit = hn::Set(wide, 1.0 / kUnit);
    for (std::size_t k = 0; k < 3; ++k) {
        hn::LoadInterleaved2(HalfIntTag(), &queue.position[k][at].x, x[k], y[k]);
        corner[k] = {hn::Mul(hn::PromoteTo(wide, x[k]), samplesPerUnit),
                     hn::Mul(hn::PromoteTo(wide, y[k]), samplesPerUnit), hn::LoadU(wide, queue.depth[k].data() + at)};
    }
    if (HWY_UNLIKELY(rules.depthBias.isOn()))
        AddBias(rules, queue, at, present, corner);
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
