// Colours of triangles as planes over the target. Included once for each target.
#if defined(RASTERLENS_TILED_PLANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_PLANES_INL_H
#undef RASTERLENS_TILED_PLANES_INL_H
#else
#define RASTERLENS_TILED_PLANES_INL_H
#endif

#include "core/rasterizers/tiled/kernels.h"
#include "core/rasterizers/tiled/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// Corners of triangles, lane by lane: positions in samples, w of clip space, colours.
struct alignas(64) CornerStage {
    std::array<std::array<double, kDoubles>, 3> x;
    std::array<std::array<double, kDoubles>, 3> y;
    std::array<std::array<double, kDoubles>, 3> w;
    std::array<double, kDoubles> anchorX; ///< centre of the sample the planes start at
    std::array<double, kDoubles> anchorY;
    std::array<std::array<std::array<float, kDoubles>, 3>, 3> color; ///< last: the doubles stay aligned
};

HWY_INLINE void StagePieceColors(const ScreenTriangle& triangle, std::size_t lane, CornerStage& stage)
{
    for (std::size_t k = 0; k < 3; ++k) {
        const ScreenVertex& v = triangle.vertices[k];
        stage.w[k][lane] = 1 / v.invW;
        for (std::size_t c = 0; c < 3; ++c)
            stage.color[k][c][lane] = v.varyings[c];
    }
}

HWY_INLINE void StageFaceColors(const FrameJob& job, std::uint32_t face, std::size_t lane, CornerStage& stage)
{
    const Mesh& mesh = job.scene->mesh;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = mesh.indices[3 * std::size_t(face) + k];
        const MeshVertex& vertex = mesh.vertices[i];
        const glm::vec4 color = job.colors != nullptr ? job.colors[i] : glm::vec4(vertex.color, vertex.position.w);
        stage.w[k][lane] = color.w;
        for (int c = 0; c < 3; ++c)
            stage.color[k][static_cast<std::size_t>(c)][lane] = color[c];
    }
}

/// Screen weights of B and C over a triangle: per sample to the right and down, and at the anchor.
struct WeightLanes {
    Doubles bPerX, bPerY, cPerX, cPerY;
    Doubles bAtAnchor, cAtAnchor;
    Doubles steepness; ///< how much weights change over the extent of the triangle
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
    w.steepness = hn::Mul(slope, hn::Add(extent, hn::Set(tag, 2.0 * kBlockSide)));
    return w;
}

/// Colour planes of one vector of triangles.
///
/// in   which lanes are wanted, and where they go
HWY_INLINE void MakePlanes(const FrameJob& job, const CornerStage& stage, std::uint32_t lanes,
                           const std::array<ColorPlanes*, kDoubles>& out)
{
    constexpr DoubleTag tag;
    constexpr HalfFloatTag narrow;
    const WeightLanes weights = MakeWeights(stage);
    const Doubles one = hn::Set(tag, 1.0);
    std::array<Doubles, 3> q{one, one, one};
    // 1/w in units of the first corner's: only ratios matter, and w itself may be beyond what float32 can invert.
    if (job.rules.perspectiveCorrect)
        for (std::size_t k = 1; k < 3; ++k)
            q[k] = hn::Div(hn::Load(tag, stage.w[0].data()), hn::Load(tag, stage.w[k].data()));
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
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
        ColorPlanes& to = *out[lane];
        to.exact = (enough >> lane & 1) == 0;
        to.x0 = static_cast<float>(stage.anchorX[lane] - 0.5);
        to.y0 = static_cast<float>(stage.anchorY[lane] - 0.5);
        for (std::size_t i = 0; i < 4; ++i) {
            to.origin[i] = planes[0][i][lane];
            to.perX[i] = planes[1][i][lane];
            to.perY[i] = planes[2][i][lane];
        }
    }
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
