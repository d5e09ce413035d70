// Texture coordinates of triangles as planes over the target, and how far off they may be. Included once for each
// target: see README.md.
#if defined(RASTERLENS_TILED_TEXELS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_TEXELS_INL_H
#undef RASTERLENS_TILED_TEXELS_INL_H
#else
#define RASTERLENS_TILED_TEXELS_INL_H
#endif

#include "core/tiled/frame_job.h"
#include "core/tiled/lanes-inl.h"
#include "core/tiled/planes-inl.h"
#include "core/tiled/setup-inl.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// Texture coordinates of the corners of triangles, and their textures, lane by lane.
struct alignas(64) TexelStage {
    std::array<std::array<glm::vec2, kDoubles>, 3> uv{};
    std::array<std::int32_t, kDoubles> texture{}, width{}, height{};
};

HWY_INLINE void StageTexels(const FrameJob& job, const Chunk& chunk, std::uint32_t source, std::size_t lane,
                            TexelStage& stage)
{
    const Mesh& mesh = job.scene->mesh;
    const std::uint32_t face = faceOf(chunk, source);
    if (HWY_UNLIKELY((source & kPiece) != 0)) {
        const ScreenTriangle& triangle = chunk.pieces[source & ~kPiece];
        for (std::size_t k = 0; k < 3; ++k) {
            const Varyings& varyings = triangle.vertices[k].varyings;
            stage.uv[k][lane] = {varyings[kVaryingUv], varyings[kVaryingUv + 1]};
        }
    } else {
        for (std::size_t k = 0; k < 3; ++k)
            stage.uv[k][lane] = mesh.vertices[mesh.indices[3 * std::size_t(face) + k]].uv;
    }
    const std::size_t material = mesh.faceMaterial.empty() ? 0 : mesh.faceMaterial[face];
    stage.texture[lane] = job.scene->materials[material].texture;
    const Texture& texture = job.texture(stage.texture[lane]);
    stage.width[lane] = texture.width;
    stage.height[lane] = texture.height;
}

/// Where the fast way may not count texels: coordinates that are no numbers are left to the precise way.
inline void LeaveTexels(const FrameJob& job, std::uint32_t lanes, TexelStage& stage)
{
    for (; lanes != 0; lanes &= lanes - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(lanes));
        if (!fastTexels(job.texture(stage.texture[lane])))
            stage.uv[0][lane] = glm::vec2(std::numeric_limits<float>::quiet_NaN());
    }
}

/// Planes as their records hold them, lane after lane.
struct alignas(64) TexelPlaneLanes {
    std::array<float, 4 * kDoubles> origin; ///< with `certain` and `first`
    std::array<float, 4 * kDoubles> slopes;

    HWY_INLINE void copyTo(std::size_t lane, TexelPlanes& to) const
    {
        std::memcpy(&to.origin, origin.data() + 4 * lane, 4 * sizeof(float));
        std::memcpy(&to.perX, slopes.data() + 4 * lane, 4 * sizeof(float));
    }
};

/// A plane in double, over the bounds of its triangle.
struct PlaneOver {
    Doubles origin, perX, perY;
    Doubles largest; ///< its terms at any sample, in sum: what errors of float32 are fractions of
};

/// What all planes of a vector of triangles are made with.
struct PlaneMaker {
    const PlaneGeometry& geometry;
    WeightLanes<Doubles> weights;
    Doubles width, height; ///< no sample is farther from the anchor

    HWY_INLINE explicit PlaneMaker(const PlaneGeometry& g) : geometry(g), weights(MakeWeights(g))
    {
        width = hn::PromoteTo(DoubleTag(), g.columns);
        height = hn::PromoteTo(DoubleTag(), g.rows);
    }

    HWY_INLINE PlaneOver operator()(const std::array<Doubles, 3>& corner) const
    {
        const Doubles ab = hn::Sub(corner[1], corner[0]);
        const Doubles ac = hn::Sub(corner[2], corner[0]);
        const auto along = [&](Doubles slopeB, Doubles slopeC)
                               HWY_ATTR { return hn::Add(hn::Mul(ab, slopeB), hn::Mul(ac, slopeC)); };
        PlaneOver plane;
        plane.origin = hn::Add(corner[0], along(weights.bAtAnchor, weights.cAtAnchor));
        plane.perX = along(weights.bPerX, weights.cPerX);
        plane.perY = along(weights.bPerY, weights.cPerY);
        plane.largest = hn::Add(hn::Abs(plane.origin),
                                hn::Add(hn::Mul(hn::Abs(plane.perX), width), hn::Mul(hn::Abs(plane.perY), height)));
        return plane;
    }
};

/// 1/w of triangles in units of their first corners': only ratios matter.
struct InverseW {
    std::array<Doubles, 3> corner;
    PlaneOver plane;
    Doubles highestW;
    Doubles beyondCorners;       ///< multi-sampling: what is interpolated is so many times that of the corners at most
    hn::Mask<DoubleTag> precise; ///< doubles keep more than float32 holds of whatever is divided by w
};

HWY_INLINE InverseW MakeInverseW(const Rules& rules, const PlaneMaker& make, const CornerColors& corners)
{
    constexpr DoubleTag tag;
    constexpr double kEnough = 1 << 20;
    const Doubles one = hn::Set(tag, 1.0);
    InverseW q;
    q.corner = {one, one, one};
    if (rules.perspectiveCorrect) {
        std::array<Doubles, 3> w;
        for (std::size_t k = 0; k < 3; ++k) {
            HalfFloats red, green, blue, narrow;
            hn::LoadInterleaved4(HalfFloatTag(), &corners.lanes[k][0].x, red, green, blue, narrow);
            w[k] = hn::PromoteTo(tag, narrow);
        }
        q.corner[1] = hn::Div(w[0], w[1]);
        q.corner[2] = hn::Div(w[0], w[2]);
    }
    q.plane = make(q.corner);
    const Doubles highest = Max3(q.corner[0], q.corner[1], q.corner[2]);
    const Doubles smallest =
        SmallestInverseW(make.geometry, make.weights, Min3(q.corner[0], q.corner[1], q.corner[2]), highest);
    q.highestW = hn::Div(one, smallest);
    const Doubles ratio = hn::Mul(highest, q.highestW);
    q.beyondCorners = hn::Mul(ratio, hn::Add(one, hn::Mul(make.weights.beyond, hn::Set(tag, 4.0))));
    q.precise =
        hn::And(hn::Gt(smallest, hn::Zero(tag)), hn::Lt(hn::Mul(make.weights.steepness, ratio), hn::Set(tag, kEnough)));
    return q;
}

/// Coordinates along one axis of the textures.
struct TexelAxis {
    PlaneOver plane;
    Doubles first;
    Doubles error;
};

/// in     coordinates of the corners, texels along the axis
/// exact  With e = 2^-24, M the sum of a plane's terms, U the largest coordinate: a plane in float32 is off by up to
///        4 e M (coefficients, products, two sums), so the quotient by 4 e w (M_u + M_q U) and, its own roundings,
///        2 e U. 1/w of cut triangles is rounded before: another 4 e U. The scalar stages round the coordinate T they
///        count from the first texel to float32: e T. `error` has a quarter more for terms of second order, and is
///        meant for values below 1/2, where the computed 1/w is then positive too (1 + U instead of U). The rule of
///        borders is taken at one corner: AxisErrors tells what that adds.
HWY_INLINE TexelAxis MakeTexelAxis(const PlaneMaker& make, const InverseW& q, const std::array<HalfFloats, 3>& corner,
                                   Doubles texels, const AxisErrors& errors)
{
    constexpr DoubleTag tag;
    const auto set = [](double value) HWY_ATTR { return hn::Set(DoubleTag(), value); };
    std::array<Doubles, 3> at;
    for (std::size_t k = 0; k < 3; ++k)
        at[k] = hn::Mul(hn::PromoteTo(tag, corner[k]), texels);
    const auto reached = [&](Doubles ofCorners) HWY_ATTR {
        return make.geometry.reach > 0 ? hn::Mul(ofCorners, q.beyondCorners) : ofCorners;
    };
    const Doubles fromFirst = reached(Max3(hn::Abs(at[0]), hn::Abs(at[1]), hn::Abs(at[2])));
    const Doubles whole = hn::Floor(at[0]);
    const Doubles border = hn::MulAdd(hn::Abs(at[0]), set(errors.borderShare), set(errors.borderReach - 0.5));
    const Doubles origin = hn::Sub(whole, border);
    for (Doubles& a : at)
        a = hn::Sub(a, origin);
    const Doubles largest = reached(Max3(hn::Abs(at[0]), hn::Abs(at[1]), hn::Abs(at[2])));
    for (std::size_t k = 0; k < 3; ++k)
        at[k] = hn::Mul(at[k], q.corner[k]);
    TexelAxis axis;
    axis.plane = make(at);
    axis.first = hn::Sub(whole, hn::Mul(hn::Floor(hn::Div(whole, texels)), texels));
    const Doubles terms = hn::Add(axis.plane.largest, hn::Mul(q.plane.largest, hn::Add(largest, hn::Set(tag, 1.0))));
    const Doubles roundings = hn::Add(hn::Mul(set(errors.perLargest), largest),
                                      hn::Add(hn::Mul(set(errors.perCoordinate), fromFirst), set(errors.always)));
    axis.error = hn::Mul(set(0x1p-24), hn::Add(hn::Mul(hn::Mul(set(5), q.highestW), terms), roundings));
    return axis;
}

/// Planes of one vector of triangles.
///
/// out  what goes with the colours
HWY_INLINE TextureLanes MakeTexelPlanes(const Rules& rules, const AxisErrors& errors, const PlaneGeometry& g,
                                        const CornerColors& corners, const TexelStage& stage, TexelPlaneLanes& out)
{
    constexpr DoubleTag tag;
    constexpr HalfFloatTag narrow;
    constexpr HalfIntTag ints;
    const PlaneMaker make(g);
    const InverseW q = MakeInverseW(rules, make, corners);
    std::array<HalfFloats, 3> us, vs;
    for (std::size_t k = 0; k < 3; ++k)
        hn::LoadInterleaved2(narrow, &stage.uv[k][0].x, us[k], vs[k]);
    const HalfInts width = hn::Load(ints, stage.width.data());
    const HalfInts height = hn::Load(ints, stage.height.data());
    const TexelAxis u = MakeTexelAxis(make, q, us, hn::PromoteTo(tag, width), errors);
    const TexelAxis v = MakeTexelAxis(make, q, vs, hn::PromoteTo(tag, height), errors);

    const Doubles half = hn::Set(tag, 0.5);
    const Doubles error = hn::IfThenElse(hn::Lt(u.error, v.error), v.error, u.error); // what is no number stays so
    const auto known = hn::And(hn::And(hn::Lt(u.error, half), hn::Lt(v.error, half)), q.precise);
    const Doubles certain = hn::IfThenElse(known, hn::Sub(half, error), hn::Set(tag, -1.0));
    const auto firstOf = [&](const TexelAxis& axis)
                             HWY_ATTR { return hn::DemoteTo(ints, hn::IfThenElseZero(known, axis.first)); };
    const HalfInts first = hn::Or(firstOf(u), hn::ShiftLeft<16>(firstOf(v)));
    const auto to = [](Doubles d) HWY_ATTR { return hn::DemoteTo(HalfFloatTag(), d); };
    hn::StoreInterleaved4(to(u.plane.origin), to(v.plane.origin), to(certain), hn::BitCast(narrow, first), narrow,
                          out.origin.data());
    hn::StoreInterleaved4(to(u.plane.perX), to(v.plane.perX), to(u.plane.perY), to(v.plane.perY), narrow,
                          out.slopes.data());
    return {to(q.plane.origin), to(q.plane.perX), to(q.plane.perY), hn::Load(ints, stage.texture.data())};
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
