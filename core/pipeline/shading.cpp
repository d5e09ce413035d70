#include "core/pipeline/shading.h"

#include "core/pipeline/texel_reads.h"
#include "core/scene/texel_border.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rasterlens
{
namespace
{

float lambert(const glm::vec3& normal, const glm::vec3& l)
{
    const float dot = normal.x * l.x + normal.y * l.y + normal.z * l.z;
    return kAmbient + kDiffuse * (dot > 0 ? dot : 0.0F); // what is no number gets no light
}

void put(Varyings& out, int at, const glm::vec3& v)
{
    for (int i = 0; i < 3; ++i)
        out[static_cast<std::size_t>(at + i)] = v[i];
}

void put(Varyings& out, int at, const glm::vec2& v)
{
    out[static_cast<std::size_t>(at)] = v.x;
    out[static_cast<std::size_t>(at + 1)] = v.y;
}

glm::vec3 get(const Varyings& v, std::size_t at) { return {v[at], v[at + 1], v[at + 2]}; }

/// Texel index along one axis; any whole number, also infinite or NaN, lands inside.
int wrapTexel(double texel, int size)
{
    if (texel >= 0 && texel < size)
        return static_cast<int>(texel);
    const double wrapped = texel - std::floor(texel / size) * size;
    return wrapped >= 0 && wrapped < size ? static_cast<int>(wrapped) : 0;
}

/// What is left of a coordinate when all whole ones are taken off. One that lies just below a whole number counts as
/// it.
float fraction(float coordinate) { return std::max(coordinate - texelFloor(coordinate), 0.0F); }

/// A texture or one of its mip levels.
struct TexelView {
    const std::uint32_t* texels;
    int width;
    int height;
    bool clamp;
    const TexelRules* rules;

    /// A column or row of the texture for any whole number; what is no number is 0.
    [[nodiscard]] int index(double texel, int size) const
    {
        if (!clamp)
            return wrapTexel(texel, size);
        return texel > 0 ? static_cast<int>(std::min(texel, size - 1.0)) : 0;
    }
    [[nodiscard]] glm::vec3 at(int x, int y) const { return unpackColor(texels[std::ptrdiff_t(y) * width + x]); }
};

/// The number of the nearest texel along an axis, before it is wrapped or clamped.
double nearestIndex(float coordinate, int size, const TexelRules& rules)
{
    const float texels = coordinate * static_cast<float>(size);
    return double(rules.floored ? texelFloor(texels) : std::trunc(texels));
}

glm::vec3 nearestTexel(const TexelView& view, const glm::vec2& uv)
{
    const auto index = [&](float coordinate, int size) {
        return view.index(nearestIndex(coordinate, size, *view.rules), size);
    };
    return view.at(index(uv.x, view.width), index(uv.y, view.height));
}

/// Where a point lies among the centres of four texels.
struct Blend {
    double left; ///< the number of the left column, before it is wrapped or clamped
    double below;
    float s; ///< how far the point is on the way to the right column, 0..1
    float t;
};

Blend blendAt(const TexelView& view, const glm::vec2& uv)
{
    const double u = double(uv.x) * view.width - view.rules->centre;
    const double v = double(uv.y) * view.height - view.rules->centre;
    const double left = std::floor(u);
    const double below = std::floor(v);
    return {left, below, static_cast<float>(u - left), static_cast<float>(v - below)};
}

/// A blend of the four texel centres around the point.
glm::vec3 bilinear(const TexelView& view, const glm::vec2& uv)
{
    const auto [left, below, s, t] = blendAt(view, uv);
    const int x0 = view.index(left, view.width);
    const int x1 = view.index(left + 1, view.width);
    const int y0 = view.index(below, view.height);
    const int y1 = view.index(below + 1, view.height);
    return glm::mix(glm::mix(view.at(x0, y0), view.at(x1, y0), s), glm::mix(view.at(x0, y1), view.at(x1, y1), s), t);
}

TexelView levelView(const Texture& texture, int level, const TexelRules& rules)
{
    const MipLevels& mips = texture.mipLevels();
    const MipLevels::Level& m = mips.levels[static_cast<std::size_t>(level)];
    return {mips.texels.data() + m.first, m.width, m.height, texture.clamp, &rules};
}

/// The two mip levels between which the samples lie as close as texels.
struct BlendedLevels {
    int finer;
    int coarser;
    float share; ///< of the coarser one
};

BlendedLevels levelsAt(const Texture& texture, const UvGradient& gradient, const TexelRules& rules)
{
    const auto last = static_cast<int>(texture.mipLevels().levels.size()) - 1;
    const float level = std::min(mipLevel(texture, gradient, rules), static_cast<float>(last));
    const auto finer = static_cast<int>(level);
    return {finer, std::min(finer + 1, last), level - static_cast<float>(finer)};
}

glm::vec3 trilinear(const Texture& texture, const glm::vec2& uv, const UvGradient& gradient, const TexelRules& rules)
{
    const BlendedLevels levels = levelsAt(texture, gradient, rules);
    return glm::mix(bilinear(levelView(texture, levels.finer, rules), uv),
                    bilinear(levelView(texture, levels.coarser, rules), uv), levels.share);
}

TexelRead readOf(const TexelView& view, int level, double column, double row, double weight)
{
    TexelRead read{level, column, row, view.index(column, view.width), view.index(row, view.height), weight, 0};
    read.color = view.texels[std::ptrdiff_t(read.y) * view.width + read.x];
    return read;
}

void addBlend(const TexelView& view, int level, const glm::vec2& uv, double weight, std::vector<TexelRead>& reads)
{
    const Blend blend = blendAt(view, uv);
    for (const int up : {0, 1})
        for (const int right : {0, 1}) {
            const double share = double(right != 0 ? blend.s : 1 - blend.s) * double(up != 0 ? blend.t : 1 - blend.t);
            reads.push_back(readOf(view, level, blend.left + right, blend.below + up, weight * share));
        }
}

/// What a byte keeps of 255 * c, as a colour of 0..1.
glm::vec3 begunAgain(const glm::vec3& color)
{
    const glm::vec3 bytes = color * 255.0F;
    return (bytes - 256.0F * glm::floor(bytes / 256.0F)) / 255.0F;
}

/// The normal of a corner after what the rules carry directions through.
glm::vec3 cornerNormal(const MeshVertex& vertex, const Rules& rules)
{
    if (rules.normals == NormalRules())
        return vertex.normal;
    glm::vec3 normal = vertex.normal;
    if (rules.normals.squashed)
        normal *= rules.stretch * rules.stretch; // the normals of the shape, and those by the matrix of positions
    if (rules.normals.moved)
        normal -= rules.eye;
    return rules.normals.squashed || rules.normals.moved ? glm::normalize(normal) : normal;
}

glm::vec3 faceNormal(const Mesh& mesh, std::uint32_t face)
{
    const auto position = [&](std::uint32_t corner) {
        return glm::vec3(mesh.vertices[mesh.indices[3 * face + corner]].position);
    };
    const glm::vec3 normal = glm::cross(position(1) - position(0), position(2) - position(0));
    const float length = glm::length(normal);
    return length > 0 ? normal / length : glm::vec3(0, 0, 1);
}

glm::vec3 phong(const Rules& rules, const FaceUniforms& uniforms, const Varyings& v, const glm::vec3& eyeWorld,
                const UvGradient& gradient)
{
    glm::vec3 color = get(v, kVaryingColor);
    if (uniforms.texture != nullptr)
        color *= sampleTexture(*uniforms.texture, {v[kVaryingUv], v[kVaryingUv + 1]}, rules.textureFilter, gradient,
                               rules.texels);
    if (!rules.lit)
        return color;
    const glm::vec3 carried = get(v, kVaryingNormal);
    const glm::vec3 normal = rules.normals.normalized ? glm::normalize(carried) : carried;
    const glm::vec3 toEye = rules.orthographic ? rules.toViewer : glm::normalize(eyeWorld - get(v, kVaryingPosition));
    const glm::vec3 between = rules.light + toEye;
    if (between == glm::vec3(0))
        return color * lambert(normal, rules.light); // the light shines at the eye: nothing is halfway
    const glm::vec3 halfway = glm::normalize(between);
    const float shine = std::pow(std::max(glm::dot(normal, halfway), 0.0F), uniforms.material->shininess);
    return color * lambert(normal, rules.light) + uniforms.material->specular * shine;
}

} // namespace

glm::vec3 lightDirection(const Light& light, const glm::dvec3& toViewer)
{
    if (light.isHead())
        return glm::vec3(toViewer);
    const glm::dvec3 size = glm::abs(*light.towards);
    return glm::vec3(
        glm::normalize(*light.towards / std::max({size.x, size.y, size.z}))); // 1e-300, 0, 0 is a direction
}

int varyingCount(Shading shading)
{
    switch (shading) {
    case Shading::Gouraud:
    case Shading::Normals: return 3;
    case Shading::Texture:
    case Shading::MipLevel: return kVaryingUv + 2;
    case Shading::Phong: return kVaryingPosition + 3;
    case Shading::Uv: return 2;
    case Shading::Flat:
    case Shading::RandomFlat:
    case Shading::Depth:
    case Shading::Overdraw:
    case Shading::TriangleId: break;
    }
    return 0;
}

void shadeVertex(const MeshVertex& vertex, const Rules& rules, Varyings& out)
{
    switch (rules.shading) {
    case Shading::Phong:
        put(out, kVaryingNormal, cornerNormal(vertex, rules));
        put(out, kVaryingPosition, glm::vec3(vertex.position));
        put(out, kVaryingUv, cornerUv(vertex, rules.texels));
        put(out, kVaryingColor, vertex.color);
        break;
    case Shading::Texture:
    case Shading::MipLevel: put(out, kVaryingUv, cornerUv(vertex, rules.texels)); [[fallthrough]];
    case Shading::Gouraud:
        put(out, kVaryingColor,
            rules.lit ? vertex.color * lambert(cornerNormal(vertex, rules), rules.light) : vertex.color);
        break;
    case Shading::Normals: put(out, 0, cornerNormal(vertex, rules)); break;
    case Shading::Uv: put(out, 0, cornerUv(vertex, rules.texels)); break;
    case Shading::Flat:
    case Shading::RandomFlat:
    case Shading::Depth:
    case Shading::Overdraw:
    case Shading::TriangleId: break;
    }
}

FaceUniforms faceUniforms(const Scene& scene, std::uint32_t face, const Rules& rules)
{
    FaceUniforms uniforms;
    const Mesh& mesh = scene.mesh;
    switch (rules.shading) {
    case Shading::Flat: {
        const glm::vec3 color = mesh.vertices[mesh.indices[3 * face]].color;
        uniforms.color = packColor(rules.lit ? color * lambert(faceNormal(mesh, face), rules.light) : color);
        break;
    }
    case Shading::RandomFlat: uniforms.color = colorOfId(face * 2654435761U + 12345U); break;
    case Shading::TriangleId: uniforms.color = colorOfId(face); break;
    case Shading::Texture:
    case Shading::MipLevel:
    case Shading::Phong: {
        const std::size_t material = mesh.faceMaterial.empty() ? 0 : mesh.faceMaterial[face];
        uniforms.material = &scene.materials[material];
        if (uniforms.material->texture >= 0)
            uniforms.texture = &scene.textures[static_cast<std::size_t>(uniforms.material->texture)];
        else if (rules.shading != Shading::Phong)
            uniforms.texture = &plainTexture(scene);
        break;
    }
    case Shading::Gouraud:
    case Shading::Depth:
    case Shading::Normals:
    case Shading::Uv:
    case Shading::Overdraw: break;
    }
    return uniforms;
}

std::uint32_t shadeElaborately(const Rules& rules, const FaceUniforms& uniforms, const Varyings& v,
                               const glm::vec3& eyeWorld, const UvGradient& gradient)
{
    switch (rules.shading) {
    case Shading::Texture:
        return packColor(get(v, kVaryingColor) * sampleTexture(*uniforms.texture, {v[kVaryingUv], v[kVaryingUv + 1]},
                                                               rules.textureFilter, gradient, rules.texels));
    case Shading::Phong: {
        const glm::vec3 color = phong(rules, uniforms, v, eyeWorld, gradient);
        return packColor(rules.colorsClamped ? color : begunAgain(color));
    }
    case Shading::MipLevel:
        return packColor(
            levelColor(uniforms.texture != nullptr ? mipLevel(*uniforms.texture, gradient, rules.texels) : 0));
    case Shading::Normals: return packColor(0.5F * glm::normalize(get(v, 0)) + 0.5F);
    case Shading::Uv: return packColor({fraction(v[0]), fraction(v[1]), 0});
    case Shading::Gouraud:
    case Shading::Depth:
    case Shading::Flat:
    case Shading::RandomFlat:
    case Shading::TriangleId:
    case Shading::Overdraw: break;
    }
    return uniforms.color;
}

glm::vec3 unpackColor(std::uint32_t color)
{
    return glm::vec3(float(color >> 16 & 255U), float(color >> 8 & 255U), float(color & 255U)) * (1.0F / 255.0F);
}

glm::vec3 sampleTexture(const Texture& texture, const glm::vec2& uv, TextureFilter filter, const UvGradient& gradient,
                        const TexelRules& rules)
{
    const TexelView view{texture.texels.data(), texture.width, texture.height, texture.clamp, &rules};
    switch (filter) {
    case TextureFilter::Nearest: return nearestTexel(view, uv);
    case TextureFilter::Bilinear: return bilinear(view, uv);
    case TextureFilter::Trilinear: break;
    }
    return trilinear(texture, uv, gradient, rules);
}

std::vector<TexelRead> texelReads(const Texture& texture, const glm::vec2& uv, TextureFilter filter,
                                  const UvGradient& gradient, const TexelRules& rules)
{
    std::vector<TexelRead> reads;
    const TexelView view{texture.texels.data(), texture.width, texture.height, texture.clamp, &rules};
    switch (filter) {
    case TextureFilter::Nearest:
        reads.push_back(
            readOf(view, 0, nearestIndex(uv.x, view.width, rules), nearestIndex(uv.y, view.height, rules), 1));
        break;
    case TextureFilter::Bilinear: addBlend(view, 0, uv, 1, reads); break;
    case TextureFilter::Trilinear: {
        const BlendedLevels levels = levelsAt(texture, gradient, rules);
        const auto share = double(levels.share);
        addBlend(levelView(texture, levels.finer, rules), levels.finer, uv, 1 - share, reads);
        if (levels.coarser != levels.finer)
            addBlend(levelView(texture, levels.coarser, rules), levels.coarser, uv, share, reads);
        break;
    }
    }
    return reads;
}

UvGradient wrappedGradient(const glm::vec2& uv, const UvGradient& gradient)
{
    const auto difference = [&](const glm::vec2& step) {
        const glm::vec2 next = uv + step;
        return (next - glm::floor(next)) - (uv - glm::floor(uv));
    };
    return {difference(gradient.perX), difference(gradient.perY)};
}

float mipLevel(const Texture& texture, const UvGradient& gradient, const TexelRules& rules)
{
    const auto squaredTexels = [&](const glm::vec2& step) {
        const glm::vec2 texels = step * glm::vec2(texture.width, texture.height);
        return texels.x * texels.x + texels.y * texels.y;
    };
    const float squared = std::max(squaredTexels(gradient.perX), squaredTexels(gradient.perY));
    return squared > 1 ? rules.levelsPerDoubling * 0.5F * std::log2(squared) : 0.0F;
}

std::uint32_t colorOfId(std::uint32_t id)
{
    // Finalizer of MurmurHash3, then channels kept away from black.
    std::uint32_t h = id + 0x9e3779b9U;
    h = (h ^ (h >> 16)) * 0x85ebca6bU;
    h = (h ^ (h >> 13)) * 0xc2b2ae35U;
    h ^= h >> 16;
    return 0xff000000U | ((h & 0x00bfbfbfU) + 0x00404040U);
}

glm::vec3 levelColor(float level)
{
    constexpr std::array<glm::vec3, 9> kColors{{{0.55F, 0.55F, 0.55F},
                                                {0.85F, 0.20F, 0.15F},
                                                {0.95F, 0.60F, 0.15F},
                                                {0.95F, 0.90F, 0.25F},
                                                {0.35F, 0.75F, 0.30F},
                                                {0.20F, 0.75F, 0.75F},
                                                {0.20F, 0.40F, 0.90F},
                                                {0.55F, 0.25F, 0.80F},
                                                {0.90F, 0.75F, 0.95F}}};
    const float held = level > 0 ? std::min(level, static_cast<float>(kColors.size() - 1)) : 0; // NaN gives 0
    const auto lower = std::min(static_cast<std::size_t>(held), kColors.size() - 2);
    return glm::mix(kColors[lower], kColors[lower + 1], held - static_cast<float>(lower));
}

std::uint32_t overdrawColor(std::uint32_t count)
{
    constexpr std::uint32_t kColors[] = {0xff000000, 0xff08306b, 0xff2171b5, 0xff41b6c4, 0xff7fcdbb,
                                         0xffc7e9b4, 0xffffeda0, 0xfffeb24c, 0xfff03b20};
    return kColors[std::min<std::size_t>(count, std::size(kColors) - 1)];
}

} // namespace rasterlens
