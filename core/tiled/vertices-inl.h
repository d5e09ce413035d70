// The vertex stage: clip space, outcodes, snapped screen positions. Included once for each target: see README.md.
#if defined(RASTERLENS_TILED_VERTICES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_VERTICES_INL_H
#undef RASTERLENS_TILED_VERTICES_INL_H
#else
#define RASTERLENS_TILED_VERTICES_INL_H
#endif

#include "core/pipeline/shading.h"
#include "core/tiled/exact_path.h"
#include "core/tiled/frame_job.h"
#include "core/tiled/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

struct ClipLanes {
    HalfFloats x, y, z, w;
};

/// float32, products summed in pairs, as the vertex stage has it.
HWY_INLINE HalfFloats TransformRow(const glm::mat4& m, int row, const ClipLanes& p)
{
    constexpr HalfFloatTag tag;
    return hn::Add(hn::Add(hn::Mul(hn::Set(tag, m[0][row]), p.x), hn::Mul(hn::Set(tag, m[1][row]), p.y)),
                   hn::Add(hn::Mul(hn::Set(tag, m[2][row]), p.z), hn::Mul(hn::Set(tag, m[3][row]), p.w)));
}

HWY_INLINE ClipLanes ToClipSpace(const FrameJob& job, const ClipLanes& p)
{
    if (job.scene->space == SceneSpace::Object) {
        const glm::mat4& m = job.matrices.clipFromObject;
        return {TransformRow(m, 0, p), TransformRow(m, 1, p), TransformRow(m, 2, p), TransformRow(m, 3, p)};
    }
    ClipLanes clip = p;
    if (job.rules.mirrorClipZ)
        clip.z = job.rules.clipZ == ClipZ::Gl ? hn::Neg(p.z) : hn::Sub(p.w, p.z);
    return clip;
}

/// Lanes inside the view volume with a w to divide by.
HWY_INLINE hn::Mask<HalfFloatTag> InsideView(const FrameJob& job, const ClipLanes& p)
{
    constexpr HalfFloatTag tag;
    const HalfFloats zero = hn::Zero(tag);
    const HalfFloats minusW = hn::Neg(p.w);
    const HalfFloats largest = hn::Set(tag, std::numeric_limits<float>::max());
    const bool clampsDepth = job.rules.clipping == Clipping::DepthClamp; // whatever z is, if it is a number
    const HalfFloats near = clampsDepth ? hn::Neg(largest) : job.rules.clipZ == ClipZ::Gl ? minusW : zero;
    const HalfFloats far = clampsDepth ? largest : p.w;
    const bool knowsW = clampsDepth || job.rules.clipping == Clipping::FrustumW;
    const HalfFloats smallestW = hn::Set(tag, knowsW ? 1.1e-5F : 0.0F);
    const auto x = hn::And(hn::Ge(p.x, minusW), hn::Le(p.x, p.w));
    const auto y = hn::And(hn::Ge(p.y, minusW), hn::Le(p.y, p.w));
    const auto z = hn::And(hn::Ge(p.z, near), hn::Le(p.z, far));
    const auto w = hn::And(hn::Gt(p.w, smallestW), hn::Le(p.w, largest));
    return hn::And(hn::And(x, y), hn::And(z, w));
}

/// One axis of the viewport.
struct Axis {
    int pixels;
    int subpixelBits;
    int unitsPerStep; ///< units of the sample grid to a step of the snapping grid
};

/// Snaps like snapToGrid(); its own rounding decides where the quotient lies close to a tie.
HWY_INLINE HalfInts Snap(Doubles p, Doubles w, Doubles inverseW, const Axis& axis, hn::Mask<DoubleTag> inside)
{
    constexpr DoubleTag tag;
    constexpr double kNearTie = 0.5 - 1e-6;
    const Doubles halfSize = hn::Set(tag, axis.pixels * double(1 << axis.subpixelBits) / 2);
    const Doubles estimate = hn::IfThenElseZero(inside, hn::Mul(hn::Mul(hn::Add(p, w), inverseW), halfSize));
    const Doubles nearest = hn::Round(estimate);
    const auto nearTie = hn::Gt(hn::Abs(hn::Sub(estimate, nearest)), hn::Set(tag, kNearTie));
    Doubles snapped = nearest;
    if (HWY_UNLIKELY(!hn::AllFalse(tag, nearTie))) {
        alignas(64) std::array<double, kDoubles> ps, ws, result;
        hn::Store(p, tag, ps.data());
        hn::Store(w, tag, ws.data());
        hn::Store(nearest, tag, result.data());
        for (std::uint32_t bits = BitsOf(tag, nearTie); bits != 0; bits &= bits - 1) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
            result[lane] = snapToGrid(ps[lane], ws[lane], axis.pixels, axis.subpixelBits);
        }
        snapped = hn::Load(tag, result.data());
    }
    return hn::DemoteTo(HalfIntTag(), hn::Mul(snapped, hn::Set(tag, double(axis.unitsPerStep))));
}

/// Where the floats of a vector of vertices start, in floats.
using VertexStarts = std::array<std::int32_t, kDoubles>;

/// Four floats that follow each other in each of a vector of vertices. Rows of four are loaded and turned into columns:
/// many processors take longer to gather floats one by one.
HWY_INLINE std::array<HalfFloats, 4> LoadColumns(const float* floats, const VertexStarts& starts, std::size_t offset)
{
    constexpr HalfFloatTag tag;
#if HWY_TARGET <= HWY_AVX2
    constexpr hn::RepartitionToWide<hn::RebindToUnsigned<HalfFloatTag>> pairs;
    const auto row = [&](std::size_t i) HWY_ATTR {
        constexpr hn::FixedTag<float, 4> four;
        const float* from = floats + offset;
#if HWY_TARGET <= HWY_AVX3 // two rows
        return hn::Combine(HalfFloatTag(), hn::LoadU(four, from + starts[i + 4]), hn::LoadU(four, from + starts[i]));
#else
        return hn::LoadU(four, from + starts[i]);
#endif
    };
    const HalfFloats a = row(0), b = row(1), c = row(2), d = row(3);
    const auto abLower = hn::BitCast(pairs, hn::InterleaveLower(tag, a, b));
    const auto abUpper = hn::BitCast(pairs, hn::InterleaveUpper(tag, a, b));
    const auto cdLower = hn::BitCast(pairs, hn::InterleaveLower(tag, c, d));
    const auto cdUpper = hn::BitCast(pairs, hn::InterleaveUpper(tag, c, d));
    return {hn::BitCast(tag, hn::InterleaveLower(pairs, abLower, cdLower)),
            hn::BitCast(tag, hn::InterleaveUpper(pairs, abLower, cdLower)),
            hn::BitCast(tag, hn::InterleaveLower(pairs, abUpper, cdUpper)),
            hn::BitCast(tag, hn::InterleaveUpper(pairs, abUpper, cdUpper))};
#else
    const HalfInts at = hn::LoadU(HalfIntTag(), starts.data());
    const auto column = [&](std::size_t i) HWY_ATTR { return hn::GatherIndex(tag, floats + offset + i, at); };
    return {column(0), column(1), column(2), column(3)};
#endif
}

/// Colours and w for the tiles; Lambert's light, as the vertex stage has it.
HWY_INLINE void ColorVertices(const FrameJob& job, const float* floats, const VertexStarts& starts, HalfFloats w,
                              std::size_t first, std::size_t count)
{
    constexpr HalfFloatTag tag;
    constexpr std::size_t kNormal = offsetof(MeshVertex, normal) / sizeof(float);
    constexpr std::size_t kBeforeColor = offsetof(MeshVertex, color) / sizeof(float) - 1;
    static_assert(kBeforeColor + 4 == sizeof(MeshVertex) / sizeof(float)); // no row ends behind the last vertex
    const glm::vec3& light = job.rules.light;
    const auto normal = LoadColumns(floats, starts, kNormal);
    const auto color = LoadColumns(floats, starts, kBeforeColor);
    const HalfFloats dot =
        hn::Add(hn::Add(hn::Mul(normal[0], hn::Set(tag, light.x)), hn::Mul(normal[1], hn::Set(tag, light.y))),
                hn::Mul(normal[2], hn::Set(tag, light.z)));
    const HalfFloats lit = hn::Add(
        hn::Set(tag, kAmbient), hn::Mul(hn::Set(tag, kDiffuse), hn::IfThenElseZero(hn::Gt(dot, hn::Zero(tag)), dot)));
    const HalfFloats strength = job.lightsVertices() ? lit : hn::Set(tag, 1.0F);
    alignas(64) std::array<glm::vec4, kDoubles> last;
    glm::vec4* out = HWY_LIKELY(count == kDoubles) ? job.colors + first : last.data();
    hn::StoreInterleaved4(hn::Mul(color[1], strength), hn::Mul(color[2], strength), hn::Mul(color[3], strength), w, tag,
                          &out[0].x);
    if (HWY_UNLIKELY(count < kDoubles))
        std::copy_n(last.begin(), count, job.colors + first);
}

constexpr int kVertexStride = sizeof(MeshVertex) / sizeof(float);

HWY_INLINE void StorePoints(HalfInts x, HalfInts y, Doubles depth, std::size_t count, ScreenPoint* out)
{
    constexpr hn::RebindToUnsigned<DoubleTag> wide;
    constexpr hn::RebindToUnsigned<HalfIntTag> half;
    const auto xs = hn::PromoteTo(wide, hn::BitCast(half, x));
    const auto ys = hn::PromoteTo(wide, hn::BitCast(half, y));
    const auto positions = hn::Or(xs, hn::ShiftLeft<32>(ys)); // little endian: x comes first
    alignas(64) std::array<ScreenPoint, kDoubles> last;
    ScreenPoint* to = HWY_LIKELY(count == kDoubles) ? out : last.data();
    hn::StoreInterleaved2(positions, hn::BitCast(wide, depth), wide, reinterpret_cast<std::uint64_t*>(to));
    if (HWY_UNLIKELY(count < kDoubles))
        std::copy_n(last.begin(), count, out);
}

/// As many vertices as a vector has lanes; `count` of them are wanted.
///
/// in   vertexOf(lane): the index of a vertex in the mesh
/// out  w of clip space
template <class VertexOf>
HWY_INLINE HalfFloats ProcessVertexLanes(const FrameJob& job, const float* floats, const VertexStarts& starts,
                                         std::size_t count, VertexOf&& vertexOf, ScreenPoint* out)
{
    constexpr HalfFloatTag tag;
    constexpr DoubleTag wide;
    const auto position = LoadColumns(floats, starts, 0);
    const ClipLanes clip = ToClipSpace(job, {position[0], position[1], position[2], position[3]});
    const auto inside = InsideView(job, clip);
    const Doubles w = hn::PromoteTo(wide, clip.w);
    const Doubles inverseW = hn::Div(hn::Set(wide, 1.0), w);
    const auto insideWide = hn::Gt(hn::PromoteTo(wide, hn::IfThenElseZero(inside, hn::Set(tag, 1.0F))), hn::Zero(wide));

    const Rules& rules = job.rules;
    const int unitsPerStep = rules.sampleGrid << (8 - rules.subpixelBits);
    const auto snap = [&](HalfFloats p, int pixels) HWY_ATTR {
        return Snap(hn::PromoteTo(DoubleTag(), p), w, inverseW, {pixels, rules.subpixelBits, unitsPerStep}, insideWide);
    };
    const HalfInts x = snap(clip.x, rules.width);
    const HalfInts y = snap(hn::Neg(clip.y), rules.height);
    const Doubles z = hn::PromoteTo(wide, clip.z);
    const Doubles ofClipZ =
        rules.clipZ == ClipZ::Gl ? hn::Div(hn::Add(w, z), hn::Mul(hn::Set(wide, 2.0), w)) : hn::Div(z, w);
    const DepthRange& range = rules.depthRange;
    const Doubles depth = hn::Add(hn::Set(wide, range.near), hn::Mul(hn::Set(wide, range.far - range.near), ofClipZ));
    StorePoints(x, y, depth, count, out);
    std::uint32_t outside = ~BitsOf(tag, inside) & ((1U << count) - 1);
    for (; outside != 0; outside &= outside - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(outside));
        out[lane] = {{kOutside, planesOutside(job, vertexOf(lane))}, 0};
    }
    return clip.w;
}

/// A run of the mesh's vertices into job.points and job.colors.
inline void ProcessVertices(const FrameJob& job, std::size_t begin, std::size_t end)
{
    for (std::size_t first = begin; first < end; first += kDoubles) {
        const std::size_t count = std::min(kDoubles, end - first);
        const auto* floats = reinterpret_cast<const float*>(job.scene->mesh.vertices.data() + first);
        VertexStarts starts;
        for (std::size_t lane = 0; lane < kDoubles; ++lane)
            starts[lane] = static_cast<std::int32_t>(std::min(lane, count - 1)) * kVertexStride;
        const HalfFloats w = ProcessVertexLanes(
            job, floats, starts, count, [&](std::size_t lane) { return first + lane; }, job.points + first);
        if (job.colors != nullptr)
            ColorVertices(job, floats, starts, w, first, count);
    }
}

/// The vertices that indices name, in their order.
inline void ProcessCorners(const FrameJob& job, const std::uint32_t* indices, std::size_t count, ScreenPoint* out)
{
    const auto* floats = reinterpret_cast<const float*>(job.scene->mesh.vertices.data());
    for (std::size_t first = 0; first < count; first += kDoubles) {
        const std::size_t n = std::min(kDoubles, count - first);
        VertexStarts starts{};
        for (std::size_t i = 0; i < n; ++i)
            starts[i] = static_cast<std::int32_t>(indices[first + i]) * kVertexStride;
        ProcessVertexLanes(
            job, floats, starts, n, [&](std::size_t lane) { return indices[first + lane]; }, out + first);
    }
}

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
