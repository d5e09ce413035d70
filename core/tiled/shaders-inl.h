// What shadeFragment() does for the shadings that interpolate, a vector of samples at a time. Included once for each
// target: see README.md.
#if defined(RASTERLENS_TILED_SHADERS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef RASTERLENS_TILED_SHADERS_INL_H
#undef RASTERLENS_TILED_SHADERS_INL_H
#else
#define RASTERLENS_TILED_SHADERS_INL_H
#endif

#include "core/pipeline/shading.h"
#include "core/tiled/frame_job.h"
#include "core/tiled/gouraud-inl.h"
#include "core/tiled/texture-inl.h"
#include "core/tiled/varyings-inl.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace rasterlens::tiled::HWY_NAMESPACE
{

HWY_INLINE Uints PackHeld(const RgbLanes& color) { return PackHeld(color.red, color.green, color.blue); }

/// A vector of samples of one triangle: what a shader reads.
template <std::size_t kCount>
struct ShaderLanes {
    const VisibleTriangle& triangle;
    const VaryingPlanes<kCount>& planes;
    VaryingLanes<kCount> varyings;
    hn::Mask<FloatTag> wanted; ///< the others may hold anything

    HWY_INLINE Floats at(int i) const { return varyings.value[static_cast<std::size_t>(i)]; }
    HWY_INLINE VectorLanes vectorAt(int i) const { return {at(i), at(i + 1), at(i + 2)}; }
    HWY_INLINE RgbLanes colorAt(int i) const { return {at(i), at(i + 1), at(i + 2)}; }
    HWY_INLINE bool all(hn::Mask<FloatTag> holds) const { return hn::AllFalse(FloatTag(), hn::AndNot(holds, wanted)); }
};

/// Whether texels have numbers that lanes can count.
template <std::size_t kCount>
HWY_INLINE bool HasTexels(const ShaderLanes<kCount>& lanes)
{
    const Texture& texture = *lanes.triangle.uniforms.texture;
    if (texture.clamp)
        return false;
    return lanes.all(
        hn::And(InReach(lanes.at(kVaryingUv), texture.width), InReach(lanes.at(kVaryingUv + 1), texture.height)));
}

/// Texels of 0 to 255.
template <std::size_t kCount>
HWY_INLINE RgbLanes SampleTexture(const FrameJob& job, const ShaderLanes<kCount>& lanes)
{
    const Texture& texture = *lanes.triangle.uniforms.texture;
    const Floats u = lanes.at(kVaryingUv);
    const Floats v = lanes.at(kVaryingUv + 1);
    switch (job.rules.textureFilter) {
    case TextureFilter::Nearest: return SampleNearest(texture, u, v, lanes.wanted);
    case TextureFilter::Bilinear: return SampleBilinear(texture, u, v, lanes.wanted);
    case TextureFilter::Trilinear: break;
    }
    return SampleTrilinear(
        texture, u, v, MipLevel(texture, GradientOf(lanes.planes, kVaryingUv, u, v, lanes.varyings.w)), lanes.wanted);
}

// A shader computes colours of 0 to 255. Where it cannot, shadeFragment() does it.

struct UvShader {
    static constexpr std::size_t kVaryings = kUvVaryings;
    explicit UvShader(const FrameJob&) {}

    /// Where coordinates pass a whole number their last bit decides between white and black; and large ones have few
    /// bits of fraction.
    HWY_INLINE bool Can(const ShaderLanes<kVaryings>& lanes) const
    {
        const auto certain = [](Floats c) HWY_ATTR {
            const auto fine = hn::Le(hn::Abs(c), hn::Set(FloatTag(), 0x1p10F));
            return hn::And(fine, hn::Gt(hn::Abs(hn::Sub(c, hn::Round(c))), hn::Set(FloatTag(), 0x1p-10F)));
        };
        return lanes.all(hn::And(certain(lanes.at(0)), certain(lanes.at(1))));
    }
    HWY_INLINE RgbLanes operator()(const ShaderLanes<kVaryings>& lanes) const
    {
        const auto fraction = [](Floats c)
                                  HWY_ATTR { return hn::Mul(hn::Sub(c, hn::Floor(c)), hn::Set(FloatTag(), 255.0F)); };
        return {fraction(lanes.at(0)), fraction(lanes.at(1)), hn::Zero(FloatTag())};
    }
};

/// Vectors long enough that their squares are normal numbers.
HWY_INLINE hn::Mask<FloatTag> HaveDirection(const VectorLanes& v)
{
    return hn::Gt(Dot(v, v), hn::Set(FloatTag(), 1e-30F));
}

struct NormalShader {
    static constexpr std::size_t kVaryings = kNormalVaryings;
    explicit NormalShader(const FrameJob&) {}

    HWY_INLINE bool Can(const ShaderLanes<kVaryings>& lanes) const
    {
        return lanes.all(HaveDirection(lanes.vectorAt(0)));
    }
    HWY_INLINE RgbLanes operator()(const ShaderLanes<kVaryings>& lanes) const
    {
        const VectorLanes n = Normalize(lanes.vectorAt(0));
        const Floats half = hn::Set(FloatTag(), 127.5F);
        return {hn::Add(hn::Mul(n.x, half), half), hn::Add(hn::Mul(n.y, half), half),
                hn::Add(hn::Mul(n.z, half), half)};
    }
};

struct PhongShader {
    static constexpr std::size_t kVaryings = kPhongVaryings;
    explicit PhongShader(const FrameJob& j)
        : job(j), toLight(Spread(j.rules.light)), eye(Spread(glm::vec3(j.matrices.eyeObject))),
          toViewer(Spread(j.rules.toViewer))
    {
    }
    const FrameJob& job;
    VectorLanes toLight;
    VectorLanes eye;
    VectorLanes toViewer; ///< orthographic: in place of the eye

    static HWY_INLINE VectorLanes Spread(const glm::vec3& v)
    {
        constexpr FloatTag tag;
        return {hn::Set(tag, v.x), hn::Set(tag, v.y), hn::Set(tag, v.z)};
    }

    HWY_INLINE bool Can(const ShaderLanes<kVaryings>& lanes) const
    {
        if (lanes.triangle.uniforms.texture != nullptr && !HasTexels(lanes))
            return false;
        if (!job.rules.lit)
            return true;
        const VectorLanes toEye = ToEye(lanes);
        const auto directed = hn::And(hn::And(HaveDirection(lanes.vectorAt(kVaryingNormal)), HaveDirection(toEye)),
                                      HaveDirection(Add(toLight, UnitToEye(toEye))));
        const Material& material = *lanes.triangle.uniforms.material;
        const float specular = material.specular.x + material.specular.y + material.specular.z;
        return material.shininess >= 1 && std::isfinite(material.shininess) && std::isfinite(specular) &&
               lanes.all(directed);
    }

    HWY_INLINE RgbLanes operator()(const ShaderLanes<kVaryings>& lanes) const
    {
        const RgbLanes color = lanes.colorAt(kVaryingColor);
        const RgbLanes surface = lanes.triangle.uniforms.texture != nullptr ? Scale(SampleTexture(job, lanes), color)
                                                                            : Scale(color, hn::Set(FloatTag(), 255.0F));
        return job.rules.lit ? Lit(surface, lanes) : surface;
    }

    HWY_INLINE VectorLanes ToEye(const ShaderLanes<kVaryings>& lanes) const
    {
        if (job.rules.orthographic)
            return toViewer;
        const VectorLanes position = lanes.vectorAt(kVaryingPosition);
        return {hn::Sub(eye.x, position.x), hn::Sub(eye.y, position.y), hn::Sub(eye.z, position.z)};
    }

    HWY_INLINE VectorLanes UnitToEye(const VectorLanes& toEye) const
    {
        return job.rules.orthographic ? toEye : Normalize(toEye);
    }

    /// Ambient, diffuse and specular light on a surface.
    HWY_INLINE RgbLanes Lit(const RgbLanes& surface, const ShaderLanes<kVaryings>& lanes) const
    {
        constexpr FloatTag tag;
        const Material& material = *lanes.triangle.uniforms.material;
        const Floats zero = hn::Zero(tag);
        const VectorLanes normal = Normalize(lanes.vectorAt(kVaryingNormal));
        const VectorLanes halfway = Normalize(Add(toLight, UnitToEye(ToEye(lanes))));
        const Floats diffuse = hn::Mul(hn::Set(tag, kDiffuse), hn::Max(Dot(normal, toLight), zero));
        const Floats shine = Power(hn::Max(Dot(normal, halfway), zero), hn::Set(tag, material.shininess));
        const RgbLanes color = Scale(surface, hn::Add(hn::Set(tag, kAmbient), diffuse));
        const auto add = [&](Floats channel, float specular)
                             HWY_ATTR { return hn::Add(channel, hn::Mul(hn::Set(tag, 255 * specular), shine)); };
        return {add(color.red, material.specular.x), add(color.green, material.specular.y),
                add(color.blue, material.specular.z)};
    }
};

} // namespace rasterlens::tiled::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
