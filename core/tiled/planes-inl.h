// Colours of triangles as planes over the target. Included once for each target: see README.md.
#if defined(RASTERLENS_TILED_PLANES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_PLANES_INL_H
#undef RASTERLENS_TILED_PLANES_INL_H
#else
#define RASTERLENS_TILED_PLANES_INL_H
#endif

#include "core/tiled/frame_job.h"
#include "core/tiled/lanes-inl.h"

#include <bit>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

/// Colour and w of clip space of the corners of triangles, one lane after the other.
struct alignas(64) CornerColors {
    std::array<std::array<glm::vec4, kDoubles>, 3> lanes;
};

HWY_INLINE void StagePieceColors(const ScreenTriangle& triangle, std::size_t lane, CornerColors& colors)
{
    for (std::size_t k = 0; k < 3; ++k) {
        const ScreenVertex& v = triangle.vertices[k];
        colors.lanes[k][lane] = {v.varyings[0], v.varyings[1], v.varyings[2], 1 / v.invW};
    }
}

HWY_INLINE void StageFaceColors(const FrameJob& job, std::uint32_t face, std::size_t lane, CornerColors& colors)
{
    const Mesh& mesh = job.scene->mesh;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t i = mesh.indices[3 * std::size_t(face) + k];
        const MeshVertex& vertex = mesh.vertices[i];
        colors.lanes[k][lane] = job.colors != nullptr ? job.colors[i] : glm::vec4(vertex.color, vertex.position.w);
    }
}

/// Triangles as setting up colours sees them, in units.
struct PlaneGeometry {
    HalfInts abX, abY, acX, acY;
    HalfInts toAnchorX, toAnchorY; ///< from the first corner
    Doubles inverseArea;           ///< one over twice the signed area, in samples
    HalfInts columns, rows;        ///< no sample is farther from the anchor, in samples
    float reach; ///< multi-sampling: centres of pixels may lie so far beside the triangle along both axes, in pixels
};

/// Planes of triangles as their records hold them, lane after lane: four numbers each.
struct alignas(64) ColorPlaneLanes {
    std::array<float, 4 * kDoubles> origin;
    std::array<float, 4 * kDoubles> perX;
    std::array<float, 4 * kDoubles> perY;
    std::array<std::int32_t, 4 * kDoubles> rest; ///< anchor and ColorWay

    HWY_INLINE void copyTo(std::size_t lane, ColorPlanes& to) const
    {
        std::memcpy(&to.origin, origin.data() + 4 * lane, sizeof to.origin);
        std::memcpy(&to.perX, perX.data() + 4 * lane, sizeof to.perX);
        std::memcpy(&to.perY, perY.data() + 4 * lane, sizeof to.perY);
        std::memcpy(&to.x0, rest.data() + 4 * lane, 4 * sizeof(std::int32_t));
    }
};

/// Screen weights of B and C over triangles, and the bound all precision hangs on.
template <class Lanes>
struct WeightLanes {
    Lanes bPerX, bPerY, cPerX, cPerY;
    Lanes bAtAnchor, cAtAnchor;
    Lanes steepness; ///< how much weights change over the extent of the triangle
    Lanes beyond;    ///< multi-sampling: no weight at the centre of a pixel is less than minus this; else 0
};

template <class Tag, class Lanes = hn::Vec<Tag>>
HWY_INLINE WeightLanes<Lanes> MakeWeights(Tag tag, Lanes abX, Lanes abY, Lanes acX, Lanes acY, Lanes toX, Lanes toY,
                                          Lanes inverseArea, float reach)
{
    WeightLanes<Lanes> w;
    w.bPerX = hn::Neg(hn::Mul(acY, inverseArea));
    w.bPerY = hn::Mul(acX, inverseArea);
    w.cPerX = hn::Mul(abY, inverseArea);
    w.cPerY = hn::Neg(hn::Mul(abX, inverseArea));
    w.bAtAnchor = hn::Add(hn::Mul(w.bPerX, toX), hn::Mul(w.bPerY, toY));
    w.cAtAnchor = hn::Add(hn::Mul(w.cPerX, toX), hn::Mul(w.cPerY, toY));
    const Lanes extent = hn::Add(hn::Add(hn::Abs(abX), hn::Abs(abY)), hn::Add(hn::Abs(acX), hn::Abs(acY)));
    const Lanes margin = hn::Set(tag, 2 * kBlockSide);
    w.steepness = hn::Mul(hn::Abs(inverseArea), hn::Mul(extent, hn::Add(extent, margin)));
    w.beyond = hn::Zero(tag);
    if (reach > 0) { // the weight of A changes by no more than those of B and C together
        const Lanes slopes =
            hn::Add(hn::Add(hn::Abs(w.bPerX), hn::Abs(w.bPerY)), hn::Add(hn::Abs(w.cPerX), hn::Abs(w.cPerY)));
        w.beyond = hn::Mul(slopes, hn::Set(tag, reach));
    }
    return w;
}

/// In double.
HWY_INLINE WeightLanes<Doubles> MakeWeights(const PlaneGeometry& g)
{
    const auto toSamples = [](HalfInts units) HWY_ATTR {
        return hn::Mul(hn::PromoteTo(DoubleTag(), units), hn::Set(DoubleTag(), 1.0 / kUnit));
    };
    return MakeWeights(DoubleTag(), toSamples(g.abX), toSamples(g.abY), toSamples(g.acX), toSamples(g.acY),
                       toSamples(g.toAnchorX), toSamples(g.toAnchorY), g.inverseArea, g.reach);
}

/// The smallest 1/w at the centres of pixels, from those of the corners: where centres lie beside the triangle, by how
/// much weights may be less than 0 there, and others more than 1.
HWY_INLINE Doubles SmallestInverseW(const PlaneGeometry& g, const WeightLanes<Doubles>& weights, Doubles smallest,
                                    Doubles largest)
{
    if (g.reach == 0)
        return smallest;
    return hn::Sub(smallest, hn::Mul(hn::Mul(weights.beyond, hn::Set(DoubleTag(), 2.0)), hn::Sub(largest, smallest)));
}

/// Ratios of w that are numbers: 0 / 0 is none, and minima of it differ between instruction sets.
HWY_INLINE hn::Mask<DoubleTag> AreNumbers(const std::array<Doubles, 3>& ratios)
{
    const Doubles sum = hn::Add(ratios[1], ratios[2]);
    return hn::Eq(sum, sum);
}

struct ColorLanes3 {
    std::array<std::array<HalfFloats, 3>, 3> channel; ///< of corner k: red, green, blue
    std::array<HalfFloats, 3> w;
    /// The largest bits of the channels: those of 1 at most if all lie between 0 and 1. What is negative or no number
    /// has larger ones, and no instruction set loses it on the way, as minima and maxima of floats may.
    hn::Vec<hn::RebindToUnsigned<HalfIntTag>> bits;
    HalfFloats range; ///< most that a channel differs between two corners
};

HWY_INLINE ColorLanes3 LoadColors(const CornerColors& colors)
{
    constexpr HalfFloatTag tag;
    ColorLanes3 out;
    for (std::size_t k = 0; k < 3; ++k)
        hn::LoadInterleaved4(tag, &colors.lanes[k][0].x, out.channel[k][0], out.channel[k][1], out.channel[k][2],
                             out.w[k]);
    const auto rangeOf = [&](std::size_t i) HWY_ATTR {
        const HalfFloats high = hn::Max(hn::Max(out.channel[0][i], out.channel[1][i]), out.channel[2][i]);
        const HalfFloats low = hn::Min(hn::Min(out.channel[0][i], out.channel[1][i]), out.channel[2][i]);
        return hn::Sub(high, low);
    };
    const auto bitsOf = [&](std::size_t i) HWY_ATTR {
        const auto bits = [&](std::size_t k)
                              HWY_ATTR { return hn::BitCast(hn::RebindToUnsigned<HalfIntTag>(), out.channel[k][i]); };
        return hn::Max(hn::Max(bits(0), bits(1)), bits(2));
    };
    out.range = hn::Max(hn::Max(rangeOf(0), rangeOf(1)), rangeOf(2));
    out.bits = hn::Max(hn::Max(bitsOf(0), bitsOf(1)), bitsOf(2));
    return out;
}

/// Where colours of a whole vector of triangles may be taken as linear on the screen.
///
/// exact  The weights of perspective differ from those of the screen by (r - 1)/4 in sum, r the ratio of the corners'
///        w: the colour by that times its range. float32 keeps 24 bits of the largest term of a sum. Corners within
///        0 to 1 keep all samples within that, but for errors that rounding to whole steps swallows.
HWY_INLINE hn::Mask<HalfFloatTag> ColorsAreAffine(const Rules& rules, const ColorLanes3& colors,
                                                  const WeightLanes<HalfFloats>& weights)
{
    constexpr HalfFloatTag tag;
    constexpr float kSteps = 0.5F; // of 255
    constexpr float kEnough = 1 << 10;
    constexpr hn::RebindToUnsigned<HalfIntTag> unsignedTag;
    const auto bitsOfOne = hn::Set(unsignedTag, std::bit_cast<std::uint32_t>(1.0F));
    const auto plain = hn::RebindMask(tag, hn::Eq(hn::Max(colors.bits, bitsOfOne), bitsOfOne));
    const auto precise = hn::And(plain, hn::Lt(weights.steepness, hn::Set(tag, kEnough)));
    if (!rules.perspectiveCorrect)
        return precise;
    const auto& [a, b, c] = colors.w;
    const HalfFloats high = hn::Max(hn::Max(a, b), c);
    const HalfFloats low = hn::Min(hn::Min(a, b), c);
    HalfFloats error = hn::Mul(colors.range, hn::Mul(hn::Sub(high, low), hn::Set(tag, 255.0F / 4)));
    auto close = precise;
    if (rules.multiSampled()) {
        // 1/4 is the largest x (1 - x) between 0 and 1; beyond, both factors grow. 1/w is at least half the smallest of
        // the corners': so the sum that is divided by is.
        const HalfFloats wide = hn::Add(hn::Set(tag, 1.0F), hn::Mul(weights.beyond, hn::Set(tag, 2.0F)));
        error = hn::Mul(hn::Mul(error, hn::Set(tag, 2.0F)), hn::Mul(wide, wide));
        const HalfFloats lost = hn::Mul(hn::Mul(weights.beyond, hn::Set(tag, 4.0F)), hn::Sub(high, low));
        close = hn::And(close, hn::Lt(lost, low));
    }
    return hn::And(close, hn::Lt(error, hn::Mul(low, hn::Set(tag, kSteps)))); // never where all w are 0
}

/// Planes in registers: 1/w, then the channels.
struct PlaneSet {
    std::array<HalfFloats, 4> origin, perX, perY;
};

/// Planes of colours times `white`; what they are converted to is up to `toPlane` (what is added to the origin: 0 or 1
/// times).
template <class ToPlane>
HWY_INLINE PlaneSet ScreenPlanes(const WeightLanes<HalfFloats>& weights, const ColorLanes3& colors, float white,
                                 ToPlane&& toPlane)
{
    constexpr HalfFloatTag tag;
    const HalfFloats scale = hn::Set(tag, white);
    PlaneSet planes;
    planes.origin[0] = planes.perX[0] = planes.perY[0] = hn::Zero(tag);
    for (std::size_t i = 0; i < 3; ++i) {
        const HalfFloats a = hn::Mul(colors.channel[0][i], scale);
        const HalfFloats ab = hn::Mul(hn::Sub(colors.channel[1][i], colors.channel[0][i]), scale);
        const HalfFloats ac = hn::Mul(hn::Sub(colors.channel[2][i], colors.channel[0][i]), scale);
        const auto combine = [&](HalfFloats b, HalfFloats c)
                                 HWY_ATTR { return hn::Add(hn::Mul(ab, b), hn::Mul(ac, c)); };
        planes.origin[i + 1] = toPlane(hn::Add(a, combine(weights.bAtAnchor, weights.cAtAnchor)), 1);
        planes.perX[i + 1] = toPlane(combine(weights.bPerX, weights.cPerX), 0);
        planes.perY[i + 1] = toPlane(combine(weights.bPerY, weights.cPerY), 0);
    }
    return planes;
}

/// Planes as ColorPlanes has them for ColorWay::Affine, as bits.
HWY_INLINE PlaneSet AffinePlanes(const WeightLanes<HalfFloats>& weights, const ColorLanes3& colors)
{
    // Rounding to the nearest step, and what is lost on the average where 24 bits of fraction become 8, twice.
    constexpr double kRounding = 0x1p23 + 0x1p16;
    const auto fixed = [](HalfFloats steps, int rounded) HWY_ATTR {
        // Above 2^52 a double counts in ones: its lowest 32 bits are the number modulo 2^32.
        const Doubles sum =
            hn::Add(hn::PromoteTo(DoubleTag(), steps), hn::Set(DoubleTag(), 0x1.8p52 + rounded * kRounding));
        const auto bits = hn::BitCast(hn::RebindToUnsigned<DoubleTag>(), sum);
        return hn::BitCast(HalfFloatTag(), hn::TruncateTo(hn::RebindToUnsigned<HalfIntTag>(), bits));
    };
    return ScreenPlanes(weights, colors, 255.0F * 0x1p24F, fixed);
}

/// Replaces the planes of the lanes that are large, steep or deep: made in double, with 1/w.
///
/// out  how those lanes' colours are found
inline HalfInts MakePerspective(const Rules& rules, const PlaneGeometry& g, const ColorLanes3& colors,
                                hn::Mask<HalfFloatTag> affine, float white, PlaneSet& planes)
{
    constexpr DoubleTag tag;
    const WeightLanes<Doubles> weights = MakeWeights(g);
    const Doubles one = hn::Set(tag, 1.0);
    std::array<Doubles, 3> q{one, one, one};
    // 1/w in units of the first corner's: only ratios matter, and w itself may be beyond what float32 can invert.
    if (rules.perspectiveCorrect)
        for (std::size_t k = 1; k < 3; ++k)
            q[k] = hn::Div(hn::PromoteTo(tag, colors.w[0]), hn::PromoteTo(tag, colors.w[k]));
    const auto makePlane = [&](std::size_t i, const std::array<Doubles, 3>& value) HWY_ATTR {
        const Doubles ab = hn::Sub(value[1], value[0]);
        const Doubles ac = hn::Sub(value[2], value[0]);
        const auto combine = [&](Doubles b, Doubles c) HWY_ATTR { return hn::Add(hn::Mul(ab, b), hn::Mul(ac, c)); };
        const auto put = [&](HalfFloats& plane, Doubles v)
                             HWY_ATTR { plane = hn::IfThenElse(affine, plane, hn::DemoteTo(HalfFloatTag(), v)); };
        put(planes.origin[i], hn::Add(value[0], combine(weights.bAtAnchor, weights.cAtAnchor)));
        put(planes.perX[i], combine(weights.bPerX, weights.cPerX));
        put(planes.perY[i], combine(weights.bPerY, weights.cPerY));
    };
    makePlane(0, q);
    for (std::size_t i = 0; i < 3; ++i) {
        std::array<Doubles, 3> value;
        for (std::size_t k = 0; k < 3; ++k)
            value[k] = hn::Mul(hn::Mul(hn::PromoteTo(tag, colors.channel[k][i]), hn::Set(tag, double(white))), q[k]);
        makePlane(i + 1, value);
    }

    // float32 keeps 24 bits of the largest term of a sum; what is left of them after the terms cancel and after the
    // division by w must be enough for a colour.
    constexpr double kEnough = 1 << 12;
    HalfFloats largest = hn::Set(HalfFloatTag(), 1.0F);
    HalfFloats sum = hn::Zero(HalfFloatTag()); // of what is no number it is none
    for (const auto& corner : colors.channel)
        for (const HalfFloats channel : corner) {
            largest = hn::Max(largest, hn::Abs(channel));
            sum = hn::Add(sum, hn::Abs(channel));
        }
    const auto finite = hn::Lt(sum, hn::Set(HalfFloatTag(), std::numeric_limits<float>::max()));
    const Doubles highest = hn::Max(hn::Max(q[0], q[1]), q[2]);
    // Not positive: unclipped, 1/w may cancel altogether.
    const Doubles smallest = SmallestInverseW(g, weights, hn::Min(hn::Min(q[0], q[1]), q[2]), highest);
    const Doubles ratio = hn::Div(highest, smallest);
    const Doubles cancelled = hn::Mul(weights.steepness, hn::Mul(ratio, hn::PromoteTo(tag, largest)));
    const auto numbers = AreNumbers(q);
    const std::uint32_t precise =
        BitsOf(HalfFloatTag(), finite) &
        BitsOf(tag,
               hn::And(numbers, hn::And(hn::Gt(smallest, hn::Zero(tag)), hn::Lt(cancelled, hn::Set(tag, kEnough)))));
    const auto way = [](ColorWay w) HWY_ATTR { return hn::Set(HalfIntTag(), static_cast<std::int32_t>(w)); };
    const HalfInts other =
        hn::IfThenElse(MaskOf(HalfIntTag(), precise), way(ColorWay::Perspective), way(ColorWay::Exact));
    return hn::IfThenElse(hn::RebindMask(HalfIntTag(), affine), way(ColorWay::Affine), other);
}

/// What a texel is multiplied with, at most: a fraction of 16 bits.
constexpr float kWhiteFactor = 0xffff;

/// What shading texture puts into the colour planes.
struct TextureLanes {
    HalfFloats origin, perX, perY; ///< 1/w, which others have only where colours need it
    HalfInts texture;
};

/// Colour planes of one vector of triangles.
///
/// in   which lanes are wanted; their anchors, samples of the target; null: there is no texture
/// out  colours times 255, or times kWhiteFactor if they are to be multiplied with texels
HWY_INLINE void MakeColorPlanes(const Rules& rules, const PlaneGeometry& g, const CornerColors& corners,
                                std::uint32_t lanes, HalfInts anchorX, HalfInts anchorY, const TextureLanes* textured,
                                ColorPlaneLanes& out)
{
    constexpr HalfFloatTag tag;
    const ColorLanes3 colors = LoadColors(corners);
    const auto toSamples = [](HalfInts units) HWY_ATTR {
        return hn::Mul(hn::ConvertTo(HalfFloatTag(), units), hn::Set(HalfFloatTag(), 1.0F / kUnit));
    };
    const WeightLanes<HalfFloats> weights =
        MakeWeights(tag, toSamples(g.abX), toSamples(g.abY), toSamples(g.acX), toSamples(g.acY), toSamples(g.toAnchorX),
                    toSamples(g.toAnchorY), hn::DemoteTo(tag, g.inverseArea), g.reach);
    const float white = textured != nullptr ? kWhiteFactor : 255.0F;
    PlaneSet planes = textured != nullptr || rules.multiSampled()
                          ? ScreenPlanes(weights, colors, white, [](HalfFloats v, int) HWY_ATTR { return v; })
                          : AffinePlanes(weights, colors);
    HalfInts way = hn::Set(HalfIntTag(), static_cast<std::int32_t>(ColorWay::Affine));
    const auto affine = ColorsAreAffine(rules, colors, weights);
    if (HWY_UNLIKELY((lanes & ~BitsOf(tag, affine)) != 0))
        way = MakePerspective(rules, g, colors, affine, white, planes);
    if (textured != nullptr) {
        planes.origin[0] = textured->origin;
        planes.perX[0] = textured->perX;
        planes.perY[0] = textured->perY;
    }
    const auto store = [](const std::array<HalfFloats, 4>& v, auto& to)
                           HWY_ATTR { hn::StoreInterleaved4(v[0], v[1], v[2], v[3], HalfFloatTag(), to.data()); };
    store(planes.origin, out.origin);
    store(planes.perX, out.perX);
    store(planes.perY, out.perY);
    hn::StoreInterleaved4(anchorX, anchorY, way, textured != nullptr ? textured->texture : hn::Zero(HalfIntTag()),
                          HalfIntTag(), out.rest.data());
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
