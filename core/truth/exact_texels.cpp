#include "core/truth/exact_texels.h"

#include "core/pipeline/shading.h"
#include "core/scene/texel_border.h"
#include "core/truth/exact_geometry.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <optional>

namespace rasterlens
{
namespace
{

using namespace exact;

constexpr int kUvBits = 149; ///< every float32 is a whole number of 2^-149

Integer wholeNumber(float value)
{
    const Fraction fraction = fractionOf(static_cast<double>(value));
    return (fraction.numerator << static_cast<unsigned>(kUvBits)) / fraction.denominator;
}

bool isInside(const glm::vec4& p, ClipZ clipZ)
{
    const float nearest = clipZ == ClipZ::Gl ? -p.w : 0;
    return p.w > 0 && std::abs(p.x) <= p.w && std::abs(p.y) <= p.w && nearest <= p.z && p.z <= p.w;
}

/// floor(t + 5 |t| 2^-24 + 2^-20) for t = numerator / denominator.
///
/// in   denominator > 0
Integer texelOf(const Integer& numerator, const Integer& denominator)
{
    const Integer held = (numerator << 24U) + 5 * boost::multiprecision::abs(numerator) + (denominator << 4U);
    return floorDivide(held, denominator << 24U);
}

std::int32_t repeated(const Integer& texel, int size, bool clamp)
{
    if (clamp)
        return clampedTo({0, size - 1}, texel);
    const Integer whole = floorDivide(texel, size);
    return static_cast<std::int32_t>(texel - whole * size);
}

/// Texture coordinates over an uncut face: u = uv[0] / weight / 2^149 and v = uv[1] / weight / 2^149.
class FaceTexels
{
public:
    /// in  a face that no plane cuts
    FaceTexels(const Scene& scene, const ClipTriangle& triangle, const std::array<glm::vec2, 3>& uv,
               const Lattice& lattice)
        : m_texture(*textureOf(scene, triangle.face))
    {
        IntegerTriangle integers = integerTriangle(triangle, 0, glm::dmat4(1));
        std::array<Snapped, 3> p{};
        std::array<Integer, 3> w;
        for (std::size_t i = 0; i < 3; ++i) {
            ScreenCorner corner = toScreen(integers.corners[i], triangle, lattice);
            w[i] = integers.corners[i].position[3];
            p[i] = snap(corner, lattice);
        }
        const std::int64_t area = doubledArea(p);
        const int sign = area < 0 ? -1 : 1;
        for (std::size_t i = 0; i < 3; ++i) {
            const Snapped& a = p[(i + 1) % 3];
            const Snapped& b = p[(i + 2) % 3];
            // The area of the edge opposite corner i and the sample, times the w of the other two.
            const Integer ax = Integer(b.x - a.x);
            const Integer ay = Integer(b.y - a.y);
            const Integer step = 2 * lattice.unit;
            const Integer offset = lattice.unit;
            Linear edge;
            edge.perColumn = -ay * step;
            edge.perRow = ax * step;
            edge.origin = ax * (offset - a.y) - ay * (offset - a.x);
            edge = edge * Integer(Integer(sign) * w[(i + 1) % 3] * w[(i + 2) % 3]);
            m_weight = m_weight + edge;
            m_uv[0] = m_uv[0] + edge * wholeNumber(uv[i].x);
            m_uv[1] = m_uv[1] + edge * wholeNumber(uv[i].y);
        }
    }

    [[nodiscard]] static const Texture* textureOf(const Scene& scene, std::uint32_t face)
    {
        const std::size_t material = scene.mesh.faceMaterial.empty() ? 0 : scene.mesh.faceMaterial[face];
        const int texture = scene.materials[material].texture;
        return texture < 0 ? nullptr : &scene.textures[static_cast<std::size_t>(texture)];
    }

    [[nodiscard]] ExactTexel at(int column, int row) const
    {
        const Integer weight = m_weight.at(column, row);
        if (weight.sign() <= 0)
            return {};
        const std::array<int, 2> sizes{m_texture.width, m_texture.height};
        std::array<Integer, 2> texel;
        for (std::size_t axis = 0; axis < 2; ++axis)
            texel[axis] = texelOf(m_uv[axis].at(column, row) * sizes[axis], weight << kUvBits);
        return {repeated(texel[0], sizes[0], m_texture.clamp), repeated(texel[1], sizes[1], m_texture.clamp),
                levelAt(column, row, weight)};
    }

private:
    /// The greatest n for which the longer of the two steps is at least 2^n texels; 0 where it is less than one.
    [[nodiscard]] int levelAt(int column, int row, const Integer& weight) const
    {
        const Integer squaredWeight = weight * weight;
        const Integer unit = (squaredWeight * squaredWeight) << (2U * kUvBits); // one texel, squared
        Integer longest = 0;
        for (const bool down : {false, true}) {
            Integer squared = 0;
            for (std::size_t axis = 0; axis < 2; ++axis) {
                const Linear& n = m_uv[axis];
                const Integer slope = down ? n.perRow : n.perColumn;
                const Integer weightSlope = down ? m_weight.perRow : m_weight.perColumn;
                const Integer step = (slope * weight - n.at(column, row) * weightSlope) *
                                     (axis == 0 ? m_texture.width : m_texture.height);
                squared += step * step;
            }
            longest = std::max(longest, squared);
        }
        int level = 0;
        for (Integer least = unit << 2U; longest >= least; least <<= 2U)
            ++level;
        return level;
    }

    const Texture& m_texture;
    Linear m_weight{};
    std::array<Linear, 2> m_uv{};
};

/// The texels of one face after another, made when its first sample asks.
class Texels
{
public:
    Texels(const Scene& scene, const Settings& settings)
        : m_scene(scene), m_clipZ(settings.clipZ), m_triangles(exactTriangles(scene, settings)),
          m_lattice(latticeOf(exactOptions(scene, settings))), m_faces(m_triangles.size())
    {
    }

    /// Null: not known.
    [[nodiscard]] const FaceTexels* of(std::int32_t face)
    {
        const auto at = static_cast<std::size_t>(face);
        if (!m_faces[at] && isKnown(at)) {
            std::array<glm::vec2, 3> uv{};
            for (std::size_t i = 0; i < 3; ++i)
                uv[i] = m_scene.mesh.vertices[m_scene.mesh.indices[3 * at + i]].uv;
            m_faces[at].emplace(m_scene, m_triangles[at], uv, m_lattice);
        }
        return m_faces[at] ? &*m_faces[at] : nullptr;
    }

private:
    [[nodiscard]] bool isKnown(std::size_t face) const
    {
        for (const ClipVertex& vertex : m_triangles[face].vertices)
            if (!isInside(glm::vec4(vertex.positionClip), m_clipZ))
                return false;
        return FaceTexels::textureOf(m_scene, static_cast<std::uint32_t>(face)) != nullptr;
    }

    const Scene& m_scene;
    ClipZ m_clipZ;
    std::vector<ClipTriangle> m_triangles;
    Lattice m_lattice;
    std::vector<std::optional<FaceTexels>> m_faces;
};

/// A texture or one of its mip levels, looked up in double.
class TexelGrid
{
public:
    explicit TexelGrid(const Texture& texture)
        : m_texels(texture.texels.data()), m_width(texture.width), m_height(texture.height), m_clamp(texture.clamp)
    {
    }
    TexelGrid(const Texture& texture, int level)
        : m_texels(texture.mipLevels().texels.data() + texture.mipLevels().levels[std::size_t(level)].first),
          m_width(texture.mipLevels().levels[std::size_t(level)].width),
          m_height(texture.mipLevels().levels[std::size_t(level)].height), m_clamp(texture.clamp)
    {
    }

    /// The texel of a column and a row that have not been wrapped or clamped.
    [[nodiscard]] glm::dvec3 at(double column, double row) const
    {
        const std::ptrdiff_t index = std::ptrdiff_t(held(row, m_height)) * m_width + held(column, m_width);
        return glm::dvec3(unpackColor(m_texels[index]));
    }

    /// The blend of the four texels whose centres are nearest.
    [[nodiscard]] glm::dvec3 blendAt(const glm::dvec2& place) const
    {
        const glm::dvec2 among = place * glm::dvec2(m_width, m_height) - 0.5;
        const glm::dvec2 low = glm::floor(among);
        const glm::dvec2 way = among - low;
        const auto along = [&](double row) { return glm::mix(at(low.x, row), at(low.x + 1, row), way.x); };
        return glm::mix(along(low.y), along(low.y + 1), way.y);
    }

private:
    [[nodiscard]] int held(double texel, int size) const
    {
        if (m_clamp)
            return static_cast<int>(std::clamp(texel, 0.0, size - 1.0));
        return static_cast<int>(texel - std::floor(texel / size) * size);
    }

    const std::uint32_t* m_texels;
    int m_width;
    int m_height;
    bool m_clamp;
};

/// What the textures of a scene are at the samples of a truth.
class TextureLookup
{
public:
    TextureLookup(const Scene& scene, const Settings& settings, ReferenceSpace space)
        : m_scene(scene), m_filter(settings.textureFilter),
          m_decidesExactly(settings.numberType == NumberType::Fixed && !scene.exact && space == ReferenceSpace::Clip),
          m_exact(scene, settings)
    {
        float largest = 0;
        for (const MeshVertex& vertex : scene.mesh.vertices)
            largest = std::max({largest, std::abs(vertex.uv.x), std::abs(vertex.uv.y)});
        m_doubt = 0x1p-46 * (1 + static_cast<double>(largest));
    }

    /// in  a sample's place in all arrays, and in those of its part of a pattern
    [[nodiscard]] glm::dvec3 at(const ExactFrame& truth, std::size_t sample, std::size_t inPart)
    {
        const std::int32_t face = truth.id[sample];
        const Texture* own = FaceTexels::textureOf(m_scene, static_cast<std::uint32_t>(face));
        const Texture& texture = own != nullptr ? *own : plainTexture(m_scene);
        const ExactUv& uv = truth.uv[sample];
        switch (m_filter) {
        case TextureFilter::Nearest: break;
        case TextureFilter::Bilinear: return TexelGrid(texture).blendAt(uv.place);
        case TextureFilter::Trilinear: return betweenLevels(texture, uv);
        }
        const glm::dvec2 sizes(texture.width, texture.height);
        const glm::dvec2 texels = uv.place * sizes;
        const glm::dvec2 held =
            texels + glm::abs(texels) * static_cast<double>(kBorderShare) + static_cast<double>(kBorderReach);
        const bool isDoubtful = glm::any(glm::lessThan(glm::abs(held - glm::round(held)), m_doubt * sizes));
        if (isDoubtful && m_decidesExactly && truth.patternSamples == 1)
            if (const FaceTexels* faceTexels = m_scene.mesh.isLine(std::uint32_t(face)) ? nullptr : m_exact.of(face)) {
                const int column = static_cast<int>(inPart % std::size_t(truth.width));
                const int row = static_cast<int>(inPart / std::size_t(truth.width));
                const ExactTexel texel =
                    faceTexels->at(truth.window.x * truth.sampleGrid + column, truth.window.y * truth.sampleGrid + row);
                if (texel.column >= 0)
                    return TexelGrid(texture).at(texel.column, texel.row);
            }
        return TexelGrid(texture).at(std::floor(held.x), std::floor(held.y));
    }

private:
    /// The blend of the two mip levels between which the samples lie as close as texels.
    [[nodiscard]] static glm::dvec3 betweenLevels(const Texture& texture, const ExactUv& uv)
    {
        const glm::dvec2 sizes(texture.width, texture.height);
        const glm::dvec2 right = uv.perColumn * sizes;
        const glm::dvec2 down = uv.perRow * sizes;
        const double squared = std::max(glm::dot(right, right), glm::dot(down, down));
        const int last = static_cast<int>(texture.mipLevels().levels.size()) - 1;
        const double level = std::min(squared > 1 ? 0.5 * std::log2(squared) : 0.0, static_cast<double>(last));
        const int finer = static_cast<int>(level);
        return glm::mix(TexelGrid(texture, finer).blendAt(uv.place),
                        TexelGrid(texture, std::min(finer + 1, last)).blendAt(uv.place), level - finer);
    }

    const Scene& m_scene;
    TextureFilter m_filter;
    bool m_decidesExactly;
    Texels m_exact;
    double m_doubt; ///< so far from a border rounding decides, in texture coordinates
};

} // namespace

std::vector<ExactTexel> exactTexels(const Scene& scene, const Settings& settings, const ExactFrame& truth)
{
    std::vector<ExactTexel> all(truth.id.size());
    if (settings.numberType != NumberType::Fixed || scene.exact || truth.patternSamples > 1)
        return all;
    Texels texels(scene, settings);
    for (int y = 0; y < truth.height; ++y)
        for (int x = 0; x < truth.width; ++x) {
            const auto sample =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(truth.width) + static_cast<std::size_t>(x);
            const std::int32_t face = truth.id[sample];
            if (face < 0 || scene.mesh.isLine(static_cast<std::uint32_t>(face)))
                continue;
            if (const FaceTexels* known = texels.of(face))
                all[sample] = known->at(truth.window.x * truth.sampleGrid + x, truth.window.y * truth.sampleGrid + y);
        }
    return all;
}

void textureExactly(const Scene& scene, const Settings& settings, ExactFrame& truth, ReferenceSpace space)
{
    assert(truth.uv.size() == truth.id.size());
    TextureLookup lookup(scene, settings, space);
    const auto samples = static_cast<std::size_t>(truth.width) * static_cast<std::size_t>(truth.height);
    for (std::size_t i = 0; i < truth.id.size(); ++i)
        if (truth.id[i] >= 0)
            truth.color[i] *= lookup.at(truth, i, i % samples);
}

} // namespace rasterlens
