// Batches of faces: which are to be drawn, and the queue of those. Included once for each target: see README.md.
#if defined(RASTERLENS_TILED_BATCH_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_BATCH_INL_H
#undef RASTERLENS_TILED_BATCH_INL_H
#else
#define RASTERLENS_TILED_BATCH_INL_H
#endif

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
    const std::uint32_t* indices;
    std::array<ScreenPoint, 3 * kFaceBatch> corners; ///< where the frame keeps none

    HWY_INLINE const ScreenPoint& point(const FrameJob& job, std::size_t face, std::size_t corner) const
    {
        const std::size_t at = 3 * face + corner;
        return job.points != nullptr ? job.points[indices[at]] : corners[at];
    }
};

HWY_INLINE void GatherFaces(const FrameJob& job, std::uint32_t first, std::uint32_t count, FaceBatch& batch)
{
    batch.indices = job.scene->mesh.indices.data() + 3 * std::size_t(first);
    if (job.points == nullptr)
        ProcessCorners(job, batch.indices, 3 * std::size_t(count), batch.corners.data());
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            batch.position[k][i] = batch.point(job, i, k).position;
    for (std::size_t i = count; i < kFaceBatch && i % kDoubles != 0; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            batch.position[k][i] = {0, 0};
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

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
