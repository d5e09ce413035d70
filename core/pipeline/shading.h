#pragma once
#include "core/pipeline/types.h"
#include "core/scene/camera.h"
#include "core/scene/scene.h"
#include "core/settings/rules.h"

#include <cstdint>

namespace rasterlens
{

// Which float of Varyings means what. A shading carries a prefix of this list, or three floats of its own.
constexpr int kVaryingColor = 0;    ///< rgb: gouraud, texture, phong
constexpr int kVaryingUv = 3;       ///< texture, phong
constexpr int kVaryingNormal = 5;   ///< phong
constexpr int kVaryingPosition = 8; ///< world space: phong

/// Towards the light, world space, unit length.
///
/// in  towards the eye: where the headlight is
[[nodiscard]] glm::vec3 lightDirection(const Light& light, const glm::dvec3& toViewer);

/// How many floats this shading interpolates.
[[nodiscard]] int varyingCount(Shading shading);

// The light of every scene.
constexpr float kAmbient = 0.2F;
constexpr float kDiffuse = 0.8F;

/// What the vertex stage computes for this shading: colour (gouraud, texture), attributes (the others).
///
/// in      `rules.lit`: the colour of gouraud and texture is the vertex's own times the light on it
/// source  ambient 0.2 and diffuse 0.8 * max(0, n . l), l = rules.light
void shadeVertex(const MeshVertex& vertex, const Rules& rules, Varyings& out);

/// What is the same for all fragments of a face.
struct FaceUniforms {
    std::uint32_t color = 0; ///< flat, random-flat, triangle-id: 0xffRRGGBB
    const Texture* texture = nullptr;
    const Material* material = nullptr;
};

/// in  `rules.lit`: the colour of flat is that of the face's first corner times the light on the face
[[nodiscard]] FaceUniforms faceUniforms(const Scene& scene, std::uint32_t face, const Rules& rules);

/// Whether this face's colours depend on the gradient.
[[nodiscard]] inline bool needsUvGradient(const Rules& rules, const FaceUniforms& uniforms)
{
    return (rules.textureFilter == TextureFilter::Trilinear || rules.shading == Shading::MipLevel) &&
           uniforms.texture != nullptr;
}

/// round(255 * clamp(c, 0, 1)) for each channel; NaN gives 0.
[[nodiscard]] inline std::uint32_t packColor(const glm::vec3& color)
{
    const auto channel = [](float c) {
        const float held = c > 0.0F ? c : 0.0F;
        return static_cast<std::uint32_t>(static_cast<int>((held < 1.0F ? held : 1.0F) * 255.0F + 0.5F));
    };
    return 0xff000000U | channel(color.r) << 16 | channel(color.g) << 8 | channel(color.b);
}

/// The colour of texture, phong, normals and uv; see shadeFragment().
[[nodiscard]] std::uint32_t shadeElaborately(const Rules& rules, const FaceUniforms& uniforms, const Varyings& varyings,
                                             const glm::vec3& eyeWorld, const UvGradient& gradient);

/// A fragment's colour as 0xffRRGGBB.
///
/// in   varyings as the shading lays them out; depth 0..1; eye in world space (phong); the gradient if it is needed
[[nodiscard, gnu::always_inline]] inline std::uint32_t shadeFragment(const Rules& rules, const FaceUniforms& uniforms,
                                                                     const Varyings& varyings, float depth,
                                                                     const glm::vec3& eyeWorld,
                                                                     const UvGradient& gradient = {})
{
    switch (rules.shading) {
    case Shading::Gouraud: return packColor({varyings[0], varyings[1], varyings[2]});
    case Shading::Depth: return packColor(glm::vec3(depth));
    case Shading::Flat:
    case Shading::RandomFlat:
    case Shading::TriangleId:
    case Shading::Overdraw: return uniforms.color;
    case Shading::Texture:
    case Shading::Phong:
    case Shading::Normals:
    case Shading::Uv:
    case Shading::MipLevel: break;
    }
    return shadeElaborately(rules, uniforms, varyings, eyeWorld, gradient);
}

[[nodiscard]] glm::vec3 unpackColor(std::uint32_t color);

/// The texture's colour at uv; coordinates repeat, or with Texture::clamp the border goes on. Borders between nearest
/// texels: texel_border.h.
///
/// in   the gradient for trilinear only
[[nodiscard]] glm::vec3 sampleTexture(const Texture& texture, const glm::vec2& uv, TextureFilter filter,
                                      const UvGradient& gradient = {}, const TexelRules& rules = {});

/// The mip level whose texels are as far apart as the samples: log2 of the texels that the longer of the two steps
/// goes past, at least 0.
[[nodiscard]] float mipLevel(const Texture& texture, const UvGradient& gradient, const TexelRules& rules = {});

/// The texture coordinates of a corner, with v as the rules count it.
[[nodiscard]] inline glm::vec2 cornerUv(const MeshVertex& vertex, const TexelRules& rules)
{
    return {vertex.uv.x, rules.vUp ? vertex.uv.y : 1 - vertex.uv.y};
}

/// The differences of the coordinates of neighbours from which whole numbers have been taken off.
[[nodiscard]] UvGradient wrappedGradient(const glm::vec2& uv, const UvGradient& gradient);

/// A colour that differs for neighbouring numbers: what random-flat and triangle-id show.
[[nodiscard]] std::uint32_t colorOfId(std::uint32_t id);

/// A mip level in false colours: grey where texels are as far apart as samples or farther, then from red over yellow,
/// green and blue to violet, a colour a level.
[[nodiscard]] glm::vec3 levelColor(float level);

/// The colour of a pixel that `count` faces covered: black, then from blue over green and yellow to red at 8 and more.
[[nodiscard]] std::uint32_t overdrawColor(std::uint32_t count);

} // namespace rasterlens
