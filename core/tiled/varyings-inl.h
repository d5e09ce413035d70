// Varyings of triangles as planes over the target. Included once for each target: see README.md.
#if defined(RASTERLENS_TILED_VARYINGS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_VARYINGS_INL_H
#undef RASTERLENS_TILED_VARYINGS_INL_H
#else
#define RASTERLENS_TILED_VARYINGS_INL_H
#endif

#include "core/tiled/frame_job.h"
#include "core/tiled/lanes-inl.h"
#include "core/tiled/planes-inl.h"
#include "core/tiled/texture-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

// varyingCount() of the shadings, known when this is compiled.
constexpr std::size_t kPhongVaryings = kVaryingPosition + 3;
constexpr std::size_t kNormalVaryings = 3;
constexpr std::size_t kUvVaryings = 2;

/// w of clip space and varyings of the corners of triangles, lane by lane.
template <std::size_t kCount>
struct alignas(64) VaryingStage {
    std::array<std::array<double, kDoubles>, 3> w{};
    std::array<std::array<std::array<float, kDoubles>, kCount>, 3> value{};
};

template <std::size_t kCount>
HWY_INLINE void StagePieceVaryings(const ScreenTriangle& triangle, std::size_t lane, VaryingStage<kCount>& stage)
{
    for (std::size_t k = 0; k < 3; ++k) {
        const ScreenVertex& v = triangle.vertices[k];
        stage.w[k][lane] = 1 / v.invW;
        for (std::size_t i = 0; i < kCount; ++i)
            stage.value[k][i][lane] = v.varyings[i];
    }
}

template <std::size_t kCount>
HWY_INLINE void StageFaceVaryings(const FrameJob& job, std::uint32_t face, std::size_t lane,
                                  VaryingStage<kCount>& stage)
{
    const Mesh& mesh = job.scene->mesh;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t vertex = mesh.indices[3 * std::size_t(face) + k];
        const MeshVertex& v = mesh.vertices[vertex];
        Varyings varyings;
        shadeVertex(v, job.rules, varyings);
        stage.w[k][lane] = job.colors != nullptr ? job.colors[vertex].w : v.position.w;
        for (std::size_t i = 0; i < kCount; ++i)
            stage.value[k][i][lane] = varyings[i];
    }
}

/// Planes of one vector of triangles.
///
/// in   which lanes are wanted, their anchors (samples of the target), and where they go
template <std::size_t kCount>
HWY_INLINE void MakeVaryingPlanes(const Rules& rules, const PlaneGeometry& g, const VaryingStage<kCount>& stage,
                                  std::uint32_t lanes, HalfInts anchorX, HalfInts anchorY,
                                  const std::array<VaryingPlanes<kCount>*, kDoubles>& out)
{
    constexpr DoubleTag tag;
    const WeightLanes<Doubles> weights = MakeWeights(g);
    const Doubles one = hn::Set(tag, 1.0);
    std::array<Doubles, 3> q{one, one, one};
    // 1/w in units of the first corner's: only ratios matter.
    if (rules.perspectiveCorrect)
        for (std::size_t k = 1; k < 3; ++k)
            q[k] = hn::Div(hn::LoadU(tag, stage.w[0].data()), hn::LoadU(tag, stage.w[k].data()));
    alignas(64) std::array<std::array<std::array<double, kDoubles>, kCount + 1>, 3> planes;
    const auto makePlane = [&](std::size_t i, Doubles a, Doubles b, Doubles c) HWY_ATTR {
        const Doubles ab = hn::Sub(b, a);
        const Doubles ac = hn::Sub(c, a);
        const auto along = [&](Doubles slopeB, Doubles slopeC)
                               HWY_ATTR { return hn::Add(hn::Mul(ab, slopeB), hn::Mul(ac, slopeC)); };
        hn::Store(hn::Add(a, along(weights.bAtAnchor, weights.cAtAnchor)), tag, planes[0][i].data());
        hn::Store(along(weights.bPerX, weights.cPerX), tag, planes[1][i].data());
        hn::Store(along(weights.bPerY, weights.cPerY), tag, planes[2][i].data());
    };
    makePlane(0, q[0], q[1], q[2]);
    // What 20 bits less leave of larger corners may drown the others. (Comparing is false for NaN.)
    constexpr double kLargest = 1 << 20;
    auto moderate = hn::Eq(one, one);
    for (std::size_t i = 0; i < kCount; ++i) {
        std::array<Doubles, 3> value;
        for (std::size_t k = 0; k < 3; ++k) {
            value[k] = hn::PromoteTo(tag, hn::LoadU(HalfFloatTag(), stage.value[k][i].data()));
            moderate = hn::And(moderate, hn::Le(hn::Abs(value[k]), hn::Set(tag, kLargest)));
        }
        makePlane(i + 1, hn::Mul(value[0], q[0]), hn::Mul(value[1], q[1]), hn::Mul(value[2], q[2]));
    }

    // So much of the 53 bits may be lost where terms cancel; what is left is still more than float32 holds.
    constexpr double kEnough = 1 << 20;
    const Doubles highest = hn::Max(hn::Max(q[0], q[1]), q[2]);
    const Doubles smallest = SmallestInverseW(g, weights, hn::Min(hn::Min(q[0], q[1]), q[2]), highest);
    const Doubles ratio = hn::Div(highest, smallest);
    const auto precise =
        hn::And(hn::Gt(smallest, hn::Zero(tag)), hn::Lt(hn::Mul(weights.steepness, ratio), hn::Set(tag, kEnough)));
    const std::uint32_t good = BitsOf(tag, hn::And(hn::And(moderate, precise), AreNumbers(q)));
    alignas(32) std::array<std::int32_t, kDoubles> x0, y0;
    hn::Store(anchorX, HalfIntTag(), x0.data());
    hn::Store(anchorY, HalfIntTag(), y0.data());
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
        VaryingPlanes<kCount>& to = *out[lane];
        to.exact = (good >> lane & 1) == 0;
        to.x0 = x0[lane];
        to.y0 = y0[lane];
        for (std::size_t i = 0; i <= kCount; ++i) {
            to.origin[i] = planes[0][i][lane];
            to.perX[i] = planes[1][i][lane];
            to.perY[i] = planes[2][i][lane];
        }
    }
}

/// Varyings of a vector of samples, and w in the unit of the planes.
template <std::size_t kCount>
struct VaryingLanes {
    std::array<Floats, kCount> value;
    Floats w;
};

/// in   the first sample of a block; v: which vector of its samples
template <std::size_t kCount>
HWY_INLINE VaryingLanes<kCount> VaryingsAt(const VaryingPlanes<kCount>& planes, int blockX, int blockY, std::size_t v)
{
    constexpr DoubleTag tag;
    const double toX = blockX - planes.x0;
    const double toY = blockY - planes.y0;
    WideDoubles x, y;
    for (std::size_t p = 0; p < kParts; ++p) {
        const std::size_t at = v * kPerVector + p * kDoubles;
        x.part[p] = hn::Add(hn::Set(tag, toX), hn::Load(tag, kPattern.doubleX.data() + at));
        y.part[p] = hn::Add(hn::Set(tag, toY), hn::Load(tag, kPattern.doubleY.data() + at));
    }
    const auto plane = [&](std::size_t i, std::size_t p) HWY_ATTR {
        const Doubles alongX =
            hn::Add(hn::Set(tag, planes.origin[i]), hn::Mul(hn::Set(tag, planes.perX[i]), x.part[p]));
        return hn::Add(alongX, hn::Mul(hn::Set(tag, planes.perY[i]), y.part[p]));
    };
    WideDoubles w;
    for (std::size_t p = 0; p < kParts; ++p)
        w.part[p] = hn::Div(hn::Set(tag, 1.0), plane(0, p));
    VaryingLanes<kCount> lanes;
    lanes.w = ToFloats(w);
    for (std::size_t i = 0; i < kCount; ++i) {
        WideDoubles value;
        for (std::size_t p = 0; p < kParts; ++p)
            value.part[p] = hn::Mul(plane(i + 1, p), w.part[p]);
        lanes.value[i] = ToFloats(value);
    }
    return lanes;
}

/// in   which varying is the first of texture coordinates u and v, and their values
HWY_INLINE GradientLanes GradientOf(const auto& planes, std::size_t first, Floats u, Floats v, Floats w)
{
    // The quotient rule: (U/W)' = (U' - u W') / W.
    const auto derivative = [&](const auto& slope, std::size_t i, Floats value) HWY_ATTR {
        constexpr FloatTag tag;
        const Floats ofProduct = hn::Set(tag, static_cast<float>(slope[first + i + 1]));
        const Floats ofInverseW = hn::Set(tag, static_cast<float>(slope[0]));
        return hn::Mul(hn::Sub(ofProduct, hn::Mul(value, ofInverseW)), w);
    };
    return {derivative(planes.perX, 0, u), derivative(planes.perY, 0, u), derivative(planes.perX, 1, v),
            derivative(planes.perY, 1, v)};
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
